//! Zeros of an event function that a search found in a step.

use super::Kind;
use super::root_and_minimum::NotANumber;
use super::samples::Sign;

/// Zero of an event function that a search found in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Finding {
    /// Fraction of the step at which the event function is zero.
    pub(crate) theta: f64,
    /// Kind of the zero, such as a rising crossing or a touch.
    pub(crate) kind: Kind,
    /// Sign of the event function after the zero.
    pub(crate) side: Sign,
}

/// Crossing at the fraction `theta` of the step, after which the function has the sign `side`.
pub(super) fn crossing_to(side: Sign, theta: f64) -> Finding {
    Finding { theta, kind: if side > 0 { Kind::Rising } else { Kind::Falling }, side }
}

/// Zeros of an event function that a search found in a step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Findings {
    /// Zeros that were found in the step, in no particular order.
    pub(crate) found: Vec<Finding>,
    /// First fraction of the step at which the function is not a number; `None` if there is none.
    pub(crate) not_a_number: Option<f64>,
}

impl Findings {
    /// Records the fraction of the step at which the function is not a number, if `outcome` is an error and
    /// no earlier fraction is recorded.
    pub(crate) fn note_not_a_number(&mut self, outcome: Result<(), NotANumber>) {
        if let Err(NotANumber { at }) = outcome {
            self.not_a_number = Some(self.not_a_number.map_or(at, |theta| theta.min(at)));
        }
    }
}
