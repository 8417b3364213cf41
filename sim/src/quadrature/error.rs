//! Reasons why a motion is not given by quadrature.

use std::fmt;

use crate::error::SimError;

/// Reason why a stretch of the motion is not integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Obstacle {
    /// Coordinate at which there is no kinetic energy.
    Barrier(f64),
    /// Coordinate near which too many panels are needed.
    Unresolved(f64),
}

/// Reason why quadrature does not give a motion. The equations can still be integrated step by step.
#[derive(Clone, Debug, PartialEq)]
pub enum NoQuadrature {
    /// The question makes no sense; the error says why.
    Question(SimError),
    /// The equations do not have exactly one speed.
    NotOneDegree {
        /// Number of speeds of the equations.
        speeds: usize,
    },
    /// The equations have no divided difference of their potential energy.
    NoPotentialSlope,
    /// A rate depends on a coordinate other than the degree of freedom, so the rate cannot be integrated along its
    /// motion.
    NotQuadrature {
        /// Index of the coordinate on which a rate depends, from 0.
        coordinate: usize,
    },
    /// The start is not regular: the coefficient of the kinetic energy is not positive, or the rate of the coordinate
    /// is 0, or one of both is not finite.
    Irregular,
    /// The energy is, to rounding, that of an equilibrium that the motion approaches for ever.
    Asymptotic {
        /// Coordinate of the equilibrium.
        at: f64,
    },
    /// The integrands vary too fast for the limit on panels, or have no value.
    Unresolved {
        /// Coordinate near which the integrands are not resolved.
        at: f64,
        /// Largest number of panels that was allowed.
        panels: u32,
    },
    /// The motion is unbounded, and was not followed to this instant.
    Uncovered {
        /// Time of the instant from the start, s.
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
