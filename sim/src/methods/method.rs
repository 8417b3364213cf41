//! Step size rules and error norm of each integration method.

use super::control::{Earlier, Rules};
use crate::tolerance::Norm;
use tripos_traits::Method;

/// Rules by which a method chooses its step sizes; `None` if it estimates no error and needs equal
/// steps.
pub(crate) fn rules(method: Method) -> Option<Rules> {
    match method {
        Method::Rk4 => None,
        Method::Ode45 => Some(Rules::Ode45 { order: 5 }),
        Method::Dopri5 => {
            let beta = 0.04;
            Some(Rules::Hairer {
                order: 5,
                exponent: 0.2 - 0.75 * beta,
                earlier: Earlier::Damps(beta),
                shrink: 0.2,
                grow: 10.0,
            })
        }
        Method::Dop853 => {
            Some(Rules::Hairer { order: 8, exponent: 0.125, earlier: Earlier::Forgotten, shrink: 0.333, grow: 6.0 })
        }
        Method::Taylor => Some(Rules::Proposed),
        Method::Gauss6 => {
            let (earlier, exponent) = (Earlier::Forgotten, 1.0 / 6.0);
            Some(Rules::Hairer { order: 6, exponent, earlier, shrink: 0.2, grow: 4.0 })
        }
        Method::Radau5 => {
            Some(Rules::Hairer { order: 5, exponent: 0.25, earlier: Earlier::Predicts, shrink: 0.2, grow: 8.0 })
        }
    }
}

/// Norm by which the error test of a method joins the errors of all components into a single number.
pub(crate) fn norm(method: Method) -> Norm {
    match method {
        Method::Ode45 | Method::Taylor => Norm::Largest,
        Method::Rk4 | Method::Dopri5 | Method::Dop853 | Method::Gauss6 | Method::Radau5 => Norm::MeanSquare,
    }
}
