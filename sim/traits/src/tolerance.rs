//! What errors are acceptable.

use std::vec::Vec;

/// Absolute tolerance: the error that is acceptable in a component however small it is.
#[derive(Clone, Debug, PartialEq)]
pub enum AbsoluteTolerance {
    /// The same for every component.
    Uniform(f64),
    /// One for each component of the state, each in its own unit.
    Each(Vec<f64>),
}

impl AbsoluteTolerance {
    /// The smallest of all components.
    #[must_use]
    pub fn smallest(&self) -> f64 {
        match self {
            Self::Uniform(atol) => *atol,
            Self::Each(each) => each.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }
}
