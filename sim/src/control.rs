//! Step sizes, by the rules of `ode45`.
//!
//! Sizes are positive whichever way the run goes. Source: the published behaviour of `ode45`
//! (L. F. Shampine & M. W. Reichelt, "The MATLAB ODE Suite", SIAM J. Sci. Comput. 18 (1997) 1–22).

use crate::tolerance::ErrorTest;

/// The distance from |t| to the next larger number: MATLAB's `eps(t)`.
fn ulp(t: f64) -> f64 {
    t.abs().next_up() - t.abs()
}

/// The smallest step that is tried at `t`: 16 ulp.
pub(crate) fn smallest(t: f64) -> f64 {
    16.0 * ulp(t)
}

/// The first step: small enough that y' alone would change y by about rtol^(1/order).
pub(crate) fn initial(test: &ErrorTest, order: u32, longest: f64, t: f64, slope_norm: f64) -> f64 {
    let rate = slope_norm / (0.8 * root(test.tolerance, order));
    let size = if longest * rate > 1.0 { 1.0 / rate } else { longest };
    size.max(smallest(t))
}

/// The next step after one with this error, if it was accepted at the first attempt.
pub(crate) fn after_success(test: &ErrorTest, order: u32, size: f64, error: f64) -> f64 {
    let shrink = 1.25 * root(error / test.tolerance, order);
    if shrink > 0.2 { size / shrink } else { 5.0 * size }
}

/// The next attempt after the first failure of a step, by its error.
pub(crate) fn after_first_failure(test: &ErrorTest, order: u32, size: f64, error: f64) -> f64 {
    size * (0.8 * root(test.tolerance / error, order)).max(0.1)
}

fn root(x: f64, order: u32) -> f64 {
    x.powf(1.0 / f64::from(order))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::AbsoluteTolerance;

    #[test]
    fn ulp_is_the_spacing_of_numbers() {
        assert_eq!(ulp(1.0), f64::EPSILON);
        assert_eq!(ulp(-3.0), 2.0 * f64::EPSILON);
        assert_eq!(ulp(0.0), f64::from_bits(1));
    }

    /// Order 5 and errors of 32, 1/32 … times the tolerance give round numbers; 4 ε for the powers.
    #[test]
    fn sizes_follow_the_fifth_root_of_the_error_within_bounds() {
        let (test, _) = ErrorTest::new(0.0, &AbsoluteTolerance::Uniform(1.0), 1).unwrap();
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 4.0 * f64::EPSILON;
        assert!(near(after_success(&test, 5, 1.0, 1.0), 0.8));
        assert!(near(after_success(&test, 5, 1.0, 1.0 / 32.0), 1.6));
        assert!(near(after_success(&test, 5, 1.0, 0.0), 5.0));
        assert!(near(after_first_failure(&test, 5, 1.0, 32.0), 0.4));
        assert!(near(after_first_failure(&test, 5, 1.0, f64::INFINITY), 0.1));
    }
}
