//! Start of a scene as its file states it, to more digits than doubles have.

use crate::algebra::Rational;
use tripos_traits::{Ball, DoubleDouble};

/// Parameters and start of a scene as its file states them, to 32 digits.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExactStart {
    /// Values of the parameters in SI units, in the order of the model. They have 32 digits if these are known.
    pub parameters: Vec<DoubleDouble>,
    /// Values of the parameters as rational numbers, in the order of the model; `None` for a value that
    /// is not known exactly.
    pub rational: Vec<Option<Rational>>,
    /// Start values of the coordinates in SI units, in the order of the model. They have 32 digits if these are
    /// known.
    pub q: Vec<DoubleDouble>,
    /// Generalized speeds or rates at the start, as the file states them.
    pub motion: InitialMotion,
}

/// Parameters and start of a scene as balls that contain the numbers of its file. The radius of a number is
/// infinite if no bound is known, as for coordinates that close loops.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EnclosedStart {
    /// Values of the parameters in SI units, in the order of the model.
    pub parameters: Vec<Ball>,
    /// Start values of the coordinates in SI units, in the order of the model.
    pub q: Vec<Ball>,
    /// Generalized speeds or rates at the start, as the file states them.
    pub motion: InitialMotion<Ball>,
}

/// Motion at an instant as a file states it: either generalized speeds or rates of the coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum InitialMotion<S = DoubleDouble> {
    /// Values of all generalized speeds u in SI units, in the order of the model.
    Speeds(Vec<S>),
    /// Values of the rates q′ of all coordinates in SI units, in the order of the model.
    Rates(Vec<S>),
}

impl<S> Default for InitialMotion<S> {
    fn default() -> Self {
        Self::Speeds(Vec::new())
    }
}

/// Coordinate or rate of a coordinate that the file does not state, so that its start value was solved for.
#[derive(Clone, Debug, PartialEq)]
pub struct SolvedVariable {
    /// Name of the coordinate, or of the rate, such as `q1'`.
    pub name: String,
    /// Start value of the coordinate or rate, in SI units.
    pub value: f64,
    /// True for a rate, which the motion constraints and the stated motion determine. False for a coordinate, which
    /// the loops determine.
    pub is_rate: bool,
}
