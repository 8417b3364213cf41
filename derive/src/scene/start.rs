//! Where a scene begins, as its file states it.

use crate::algebra::Rational;
use tripos_traits::DoubleDouble;

/// The start of a scene as its file states it, beyond the precision of a double.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exact {
    /// The parameters, in the order of the model.
    pub parameters: Vec<DoubleDouble>,
    /// The parameters as rational numbers, where they are such.
    pub rational: Vec<Option<Rational>>,
    /// The coordinates.
    pub q: Vec<DoubleDouble>,
    /// What moves.
    pub motion: Stated,
}

/// How a file states the motion at an instant.
#[derive(Clone, Debug, PartialEq)]
pub enum Stated {
    /// By every generalized speed u.
    Speeds(Vec<DoubleDouble>),
    /// By every q′.
    Rates(Vec<DoubleDouble>),
}

impl Default for Stated {
    fn default() -> Self {
        Self::Speeds(Vec::new())
    }
}

/// A coordinate, or the rate of one, that was solved for.
#[derive(Clone, Debug, PartialEq)]
pub struct Closed {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Whether it is a rate, which follows from the motion constraints and from what the start states of the motion.
    pub is_rate: bool,
}
