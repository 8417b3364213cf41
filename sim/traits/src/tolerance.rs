//! Tolerances for the error of a step, for scene files and for programs.

use alloc::vec::Vec;

/// Relative tolerance of a run that does not state any.
pub const RTOL: f64 = 1e-6;
/// Absolute tolerance of a run that does not state any, in the units of the state.
pub const ATOL: f64 = 1e-9;

/// Absolute tolerance of a step: the acceptable error of a component of the state, even if its
/// value is small.
///
/// It is made from a number for all components, or from a list: `1e-9.into()`, `vec![1e-9,
/// 1e-6].into()`.
#[derive(Clone, Debug, PartialEq)]
pub enum AbsoluteTolerance {
    /// Same tolerance for every component, each in its own unit.
    Uniform(f64),
    /// Tolerance of each component of the state, in its own unit: coordinates, then motion variables.
    Each(Vec<f64>),
}

impl AbsoluteTolerance {
    /// Smallest absolute tolerance of all components of the state.
    #[must_use]
    pub fn smallest(&self) -> f64 {
        match self {
            Self::Uniform(atol) => *atol,
            Self::Each(each) => each.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }

    /// Tolerance of the component with this index; `None` if a list has no such component.
    #[must_use]
    pub fn of(&self, component: usize) -> Option<f64> {
        match self {
            Self::Uniform(atol) => Some(*atol),
            Self::Each(each) => each.get(component).copied(),
        }
    }
}

/// Default tolerance: [`ATOL`] for every component.
impl Default for AbsoluteTolerance {
    fn default() -> Self {
        Self::Uniform(ATOL)
    }
}

impl From<f64> for AbsoluteTolerance {
    fn from(atol: f64) -> Self {
        Self::Uniform(atol)
    }
}

impl From<Vec<f64>> for AbsoluteTolerance {
    fn from(each: Vec<f64>) -> Self {
        Self::Each(each)
    }
}
