//! Reasons why there is no answer by quadrature.

use std::fmt;

use crate::error::SimError;

/// Reason why a stretch is not integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Obstacle {
    /// There is no kinetic energy at this coordinate.
    Barrier(f64),
    /// The panels near this coordinate are too many.
    Unresolved(f64),
}

/// A motion that quadrature does not give. The equations can still be integrated step by step.
#[derive(Clone, Debug, PartialEq)]
pub enum NoQuadrature {
    /// The question makes no sense.
    Question(SimError),
    /// There is not exactly one speed.
    NotOneDegree {
        /// Number of speeds.
        speeds: usize,
    },
    /// The equations do not bring the divided difference of their potential energy.
    NoPotentialSlope,
    /// A rate depends on a coordinate other than the degree of freedom, so it cannot be integrated along its motion.
    NotQuadrature {
        /// The coordinate it depends on, from 0.
        coordinate: usize,
    },
    /// At the start, the coefficient of the kinetic energy is not positive, or that of the rate is 0, or one of them is
    /// not finite.
    Irregular,
    /// The energy is, to rounding, that of an equilibrium which the motion approaches for ever.
    Asymptotic {
        /// The coordinate there.
        at: f64,
    },
    /// The integrands vary too fast for the limit on panels, or have no value.
    Unresolved {
        /// The coordinate there.
        at: f64,
        /// The limit.
        panels: u32,
    },
    /// An instant of an unbounded motion to which it was not followed.
    Uncovered {
        /// The time from the start, in s.
        t: f64,
    },
}

impl From<SimError> for NoQuadrature {
    fn from(error: SimError) -> Self {
        Self::Question(error)
    }
}

impl fmt::Display for NoQuadrature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Question(error) => error.fmt(f),
            Self::NotOneDegree { speeds } => {
                write!(f, "quadrature needs one speed, and there are {speeds}; integrate step by step")
            }
            Self::NoPotentialSlope => {
                f.write_str("these equations do not bring the slope of their potential energy; integrate step by step")
            }
            Self::NotQuadrature { coordinate } => {
                write!(
                    f,
                    "a rate depends on coordinate {coordinate}, which is to be a quadrature; integrate step by step"
                )
            }
            Self::Irregular => {
                f.write_str("at the start the kinetic energy is not positive, or the coordinate has no rate")
            }
            Self::Asymptotic { at } => write!(
                f,
                "to rounding the energy is that of the equilibrium at {at}, which the motion approaches for ever; change the \
                 start, or integrate step by step"
            ),
            Self::Unresolved { at, panels } => {
                write!(f, "the integrands near {at} are not resolved by {panels} panels; integrate step by step")
            }
            Self::Uncovered { t } => write!(f, "the motion was not followed to t = {t} s: call `cover` first"),
        }
    }
}

impl std::error::Error for NoQuadrature {}
