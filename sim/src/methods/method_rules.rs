//! Step size rules and error norm of each integration method.

use super::step_size_rules::{EffectOfPreviousError, StepSizeRules};
use crate::error_test::Norm;
use tripos_traits::Method;

/// Rules by which a method chooses its step sizes; `None` if it estimates no error and needs equal
/// steps.
pub(crate) fn method_rules(method: Method) -> Option<StepSizeRules> {
    match method {
        Method::Rk4 => None,
        Method::Ode45 => Some(StepSizeRules::Ode45 { order: 5 }),
        Method::Dopri5 => {
            let beta = 0.04;
            Some(StepSizeRules::Hairer {
                order: 5,
                exponent: 0.2 - 0.75 * beta,
                earlier: EffectOfPreviousError::Damps(beta),
                shrink: 0.2,
                grow: 10.0,
            })
        }
        Method::Dop853 => Some(StepSizeRules::Hairer {
            order: 8,
            exponent: 0.125,
            earlier: EffectOfPreviousError::Forgotten,
            shrink: 0.333,
            grow: 6.0,
        }),
        Method::Taylor => Some(StepSizeRules::Proposed),
        Method::Gauss6 => {
            let (earlier, exponent) = (EffectOfPreviousError::Forgotten, 1.0 / 6.0);
            Some(StepSizeRules::Hairer { order: 6, exponent, earlier, shrink: 0.2, grow: 4.0 })
        }
        Method::Radau5 => Some(StepSizeRules::Hairer {
            order: 5,
            exponent: 0.25,
            earlier: EffectOfPreviousError::Predicts,
            shrink: 0.2,
            grow: 8.0,
        }),
    }
}

/// Norm by which the error test of a method joins the errors of all components into a single number.
pub(crate) fn method_norm(method: Method) -> Norm {
    match method {
        Method::Ode45 | Method::Taylor => Norm::Largest,
        Method::Rk4 | Method::Dopri5 | Method::Dop853 | Method::Gauss6 | Method::Radau5 => Norm::MeanSquare,
    }
}
