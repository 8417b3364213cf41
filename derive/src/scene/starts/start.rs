//! Start of a scene, as its file states it.

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
    /// Speeds or rates at the start.
    pub motion: Stated,
}

/// Motion at an instant, as a file states it.
#[derive(Clone, Debug, PartialEq)]
pub enum Stated {
    /// Every generalized speed u.
    Speeds(Vec<DoubleDouble>),
    /// The rate q′ of every coordinate.
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
    /// True if it is a rate, which follows from the motion constraints and from the motion that the start states.
    pub is_rate: bool,
}
