//! Reasons why quadrature does not give a motion of one degree of freedom.

use std::fmt;

use crate::error::SimError;

/// Obstacle because of which a stretch of the motion is not integrated to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StretchObstacle {
    /// The motion meets this coordinate, at which there is no kinetic energy.
    Barrier(f64),
    /// The quadrature needs too many panels (subintervals) near this coordinate.
    Unresolved(f64),
}

/// Reason why quadrature does not give a motion. The equations can still be integrated step by step.
#[derive(Clone, Debug, PartialEq)]
pub enum NoQuadrature {
    /// The arguments of the run are invalid; the error inside says why.
    Question(SimError),
    /// The equations have no single generalized speed, so that they do not describe one degree of freedom.
    NotOneDegree {
        /// Number of generalized speeds of the equations.
        speeds: usize,
    },
    /// The equations do not provide the divided difference of their potential energy.
    NoPotentialSlope,
    /// A rate depends on a coordinate other than coordinate 0. It can therefore not be integrated along the motion of
    /// coordinate 0.
    NotQuadrature {
        /// Index of the coordinate on which a rate depends, from 0.
        coordinate: usize,
    },
    /// The start is not regular: the inertia in the kinetic energy is not positive, the rate of coordinate 0 is 0 for
    /// any speed, or a value is not finite.
    Irregular,
    /// The energy is, up to rounding, that of an equilibrium, which the motion approaches for ever.
    Asymptotic {
        /// Value of coordinate 0 at the equilibrium that the motion approaches.
        at: f64,
    },
    /// The integrands vary too fast for the allowed number of panels (subintervals), or have no value.
    Unresolved {
        /// Value of coordinate 0 near which the integrands are not resolved.
        at: f64,
        /// Largest number of panels (subintervals of the quadrature) that was allowed.
        panels: u32,
    },
    /// The motion is unbounded, and was not integrated up to the wanted time.
    Uncovered {
        /// Wanted time from the start, s.
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
