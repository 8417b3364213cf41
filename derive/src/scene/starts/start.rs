//! Start of a scene, as the scene file states it.

use crate::algebra::Rational;
use tripos_traits::DoubleDouble;

/// Parameters and start of a scene as its file states them, beyond the precision of a double.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exact {
    /// Values of the parameters, in the order of the model, to 32 digits where they are known.
    pub parameters: Vec<DoubleDouble>,
    /// Values of the parameters as rational numbers; `None` for a value that is not rational.
    pub rational: Vec<Option<Rational>>,
    /// Values of the coordinates at the start, to 32 digits where they are known.
    pub q: Vec<DoubleDouble>,
    /// Speeds or rates at the start, as the file states them.
    pub motion: InitialMotion,
}

/// Motion at an instant, as a scene or state file states it.
#[derive(Clone, Debug, PartialEq)]
pub enum InitialMotion {
    /// Values of every generalized speed u, in the order of the model.
    Speeds(Vec<DoubleDouble>),
    /// Values of the rate q′ of every coordinate, in the order of the model.
    Rates(Vec<DoubleDouble>),
}

impl Default for InitialMotion {
    fn default() -> Self {
        Self::Speeds(Vec::new())
    }
}

/// A coordinate, or the rate of one, whose value at the start was solved for.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedVariable {
    /// Name of the coordinate, or of its rate.
    pub name: String,
    /// Value of the coordinate or rate at the start.
    pub value: f64,
    /// True for a rate, which follows from the motion constraints and the stated motion; false for a coordinate.
    pub is_rate: bool,
}
