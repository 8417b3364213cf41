//! Control of step sizes by error estimates: the rules of `ode45` and of Hairer's codes, as data.
//!
//! Sizes are positive in both directions of time. No rule tries a failed step again with a size below 16 ulp of t.

use crate::error_test::ErrorTest;
use crate::rounding::smallest_step_beyond_rounding;

/// Rules that determine the size of the next step from the error of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StepSizeRules {
    /// Rules of `ode45`: L. F. Shampine & M. W. Reichelt, "The MATLAB ODE Suite", SIAM J. Sci. Comput. 18 (1997) 1–22.
    Ode45 {
        /// Degree n of the root error^(1/n) by which a step size is divided.
        order: u32,
    },
    /// The method proposes each size itself. A step that fails is tried again with half its size.
    Proposed,
    /// Rules of `dopri5` and `dop853`, with the stabilization of Lund and Gustafsson: E. Hairer, S. P. Nørsett & G.
    /// Wanner, *Solving Ordinary Differential Equations I* (1993), §II.4 and §IV.2 of volume II.
    Hairer {
        /// Degree of the root in the formula for the size of the first step.
        order: u32,
        /// Power of the error by which the size is divided.
        exponent: f64,
        /// Effect of the error of the previous step on the size of the next step.
        earlier: EffectOfPreviousError,
        /// Smallest factor by which the size changes from one step to the next.
        shrink: f64,
        /// Largest factor by which the size changes from one step to the next.
        grow: f64,
    },
}

/// Effect of the previous step's error on the size of the next step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EffectOfPreviousError {
    /// The error of the previous step has no effect.
    Forgotten,
    /// The size is multiplied by this power of the error of the previous step. This damps alternating errors.
    Damps(f64),
    /// The error is predicted to grow by the same factor as in the last step; the prediction is used if it gives a
    /// smaller size. K. Gustafsson, "Control-theoretic techniques for stepsize selection in implicit Runge–Kutta
    /// methods", ACM Trans. Math. Software 20 (1994) 496–517; Hairer & Wanner, *Solving Ordinary Differential Equations
    /// II*, §IV.8.
    ///
    /// A size that would grow by a fifth or less is kept, since another size needs a new factorization of the matrices.
    Predicts,
}

/// Largest growth factor for which a step size is kept, to save a new factorization of the matrices.
const WORTH_A_CHANGE: f64 = 1.2;

/// Safety divisor of Hairer's rules: a step is 0.9 of the size that its error allows. It is stored as the factor 1 /
/// 0.9 on a divisor, because a multiplication is faster than a division.
const MARGIN: f64 = 1.0 / 0.9;

impl EffectOfPreviousError {
    /// Lower bound on the previous error that the step control remembers, as a fraction of the tolerance.
    fn least_remembered_error(self) -> f64 {
        if self == Self::Predicts { 1e-2 } else { 1e-4 }
    }
}

impl StepSizeRules {
    /// Largest size of a step as a fraction of the span, if the options give no largest size.
    pub(crate) fn longest_part(self) -> f64 {
        match self {
            // A motion that is a polynomial in time has no error that limits the step. Events need a limit, since they
            // are sampled at a fixed number of places of each step.
            Self::Ode45 { .. } | Self::Proposed => 0.1,
            Self::Hairer { .. } => 1.0,
        }
    }

    /// Largest factor by which a step is stretched to end exactly at the end of the run or at a corner.
    pub(crate) fn largest_stretch_of_step(self) -> f64 {
        match self {
            Self::Ode45 { .. } => 1.1,
            Self::Hairer { .. } | Self::Proposed => 1.01,
        }
    }
}

/// Control of step sizes by rules, which remembers the errors of earlier steps.
#[derive(Clone, Debug)]
pub(crate) struct StepSizeControl {
    /// Rules by which the method chooses its step sizes.
    rules: StepSizeRules,
    /// Largest norm of an error that passes the error test.
    tolerance: f64,
    /// True if an attempt at the current step has failed.
    failed: bool,
    /// Error of the previous accepted step in Hairer's rules. It is stored as at least 1e-4, or 1e-2 for
    /// [`EffectOfPreviousError::Predicts`].
    previous: f64,
    /// Size of the previous accepted step, s; `None` before the first accepted step.
    previous_size: Option<f64>,
    /// Factor, at most 1, on the size that the error allows in Hairer's rules. An implicit method sets it below 1 if
    /// its equations were hard to solve.
    pub(crate) margin: f64,
}

impl StepSizeControl {
    /// Creates the control for these rules and the tolerance of an error test, before the first step.
    pub(crate) fn new(rules: StepSizeRules, test: &ErrorTest) -> Self {
        Self { rules, tolerance: test.tolerance, failed: false, previous: 1e-4, previous_size: None, margin: 1.0 }
    }

    /// Size of the next step, s, after an accepted step of `size` s with the norm `error` of its error.
    pub(crate) fn size_after_accepted_step(&mut self, size: f64, error: f64) -> f64 {
        let failed = std::mem::replace(&mut self.failed, false);
        match self.rules {
            StepSizeRules::Proposed => size,
            StepSizeRules::Ode45 { .. } if failed => size,
            StepSizeRules::Ode45 { order } => {
                let shrink = 1.25 * step_size_root(error / self.tolerance, order);
                if shrink > 0.2 { size / shrink } else { 5.0 * size }
            }
            StepSizeRules::Hairer { exponent, earlier, shrink, grow, .. } => {
                let own = power(error, exponent) * MARGIN;
                let divisor = match earlier {
                    EffectOfPreviousError::Forgotten => own,
                    EffectOfPreviousError::Damps(beta) => own / self.previous.powf(beta),
                    EffectOfPreviousError::Predicts => {
                        self.predicted_size_divisor(size, error, exponent).max(own / self.margin)
                    }
                };
                (self.previous, self.previous_size) = (error.max(earlier.least_remembered_error()), Some(size));
                let next = size / divisor.min(1.0 / shrink).max(1.0 / grow);
                let stays =
                    earlier == EffectOfPreviousError::Predicts && (size..=WORTH_A_CHANGE * size).contains(&next);
                if stays || failed { next.min(size) } else { next }
            }
        }
    }

    /// Divisor of the step size for a predicted error, which grows by the same factor as from the previous step to this
    /// step. 0 after the first step.
    fn predicted_size_divisor(&self, size: f64, error: f64, exponent: f64) -> f64 {
        let Some(before) = self.previous_size else { return 0.0 };
        (before / size) * power(error * error / self.previous, exponent) * MARGIN
    }

    /// Size of the next attempt, s, after a failed attempt of `size` s with the norm `error` of its error. `error` is
    /// `None` if f had no value at a point of the step.
    pub(crate) fn size_after_failed_step(&mut self, size: f64, error: Option<f64>) -> f64 {
        let failed = std::mem::replace(&mut self.failed, true);
        match (self.rules, error) {
            (StepSizeRules::Ode45 { order }, Some(error)) if !failed => {
                size * (0.8 * step_size_root(self.tolerance / error, order)).max(0.1)
            }
            (StepSizeRules::Hairer { exponent, shrink, .. }, Some(error)) => {
                size / (power(error, exponent) * MARGIN / self.margin).min(1.0 / shrink)
            }
            _ => 0.5 * size,
        }
    }
}

/// Root x^(1/order) of x.
fn step_size_root(x: f64, order: u32) -> f64 {
    x.powf(1.0 / f64::from(order))
}

/// Power of `x` with this exponent. The eighth root is computed by three square roots, which cost less.
fn power(x: f64, exponent: f64) -> f64 {
    if crate::rounding::exactly_equal(exponent, 0.125) { x.sqrt().sqrt().sqrt() } else { x.powf(exponent) }
}

/// Size of the first step of `ode45`, s: at most `longest`, s, and so small that y' alone would change y by about
/// rtol^(1/order). `slope_norm` is the weighted norm of y' at the start.
pub(crate) fn initial_step_size(test: &ErrorTest, order: u32, longest: f64, t: f64, slope_norm: f64) -> f64 {
    let rate = slope_norm / (0.8 * step_size_root(test.tolerance, order));
    let size = if longest * rate > 1.0 { 1.0 / rate } else { longest };
    size.max(smallest_step_beyond_rounding(t))
}

/// Hairer's first guess of the first step, s: a step of Euler's method that changes y by a hundredth of its size. `y`
/// and `slope` are the weighted norms of the state and the derivative at the start; `longest` is the largest allowed
/// size, s.
pub(crate) fn first_guess_of_step_size(y: f64, slope: f64, longest: f64) -> f64 {
    let tiny = 1e-5; // their squares are compared with 1e-10
    let guess = if y <= tiny || slope <= tiny { 1e-6 } else { 0.01 * (y / slope) };
    guess.min(longest)
}

/// Hairer's size of the first step, s: size^order times the larger norm of y' and y'' is 0.01. `guess` is the first
/// guess, s; `slope` and `curvature` are the weighted norms of y' and y''; `longest` is the largest allowed size, s.
pub(crate) fn second_guess_of_step_size(guess: f64, slope: f64, curvature: f64, order: u32, longest: f64) -> f64 {
    let larger = slope.max(curvature);
    let size = if larger <= 1e-15 { (1e-3 * guess).max(1e-6) } else { step_size_root(0.01 / larger, order) };
    size.min(100.0 * guess).min(longest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error_test::Norm;
    use tripos_traits::AbsoluteTolerance;

    fn control(rules: StepSizeRules) -> StepSizeControl {
        let (test, _) = ErrorTest::new::<f64>(Norm::Largest, 0.0, &AbsoluteTolerance::Uniform(1.0), 1).unwrap();
        StepSizeControl::new(rules, &test)
    }

    fn near(a: f64, b: f64) -> bool {
        (a / b - 1.0).abs() < 4.0 * f64::EPSILON
    }

    /// With order 5, errors of 32, 1/32 … times the tolerance give round numbers. The tolerance is 4 ε, for the powers.
    #[test]
    fn sizes_follow_the_fifth_root_of_the_error_within_bounds() {
        let fresh = || control(StepSizeRules::Ode45 { order: 5 });
        for (error, size) in [(1.0, 0.8), (1.0 / 32.0, 1.6), (0.0, 5.0)] {
            assert!(near(fresh().size_after_accepted_step(1.0, error), size));
        }
        for (error, size) in [(Some(32.0), 0.4), (Some(f64::INFINITY), 0.1), (None, 0.5)] {
            assert!(near(fresh().size_after_failed_step(1.0, error), size));
        }
    }

    #[test]
    fn after_a_failure_ode45_halves_and_does_not_grow() {
        let mut control = control(StepSizeRules::Ode45 { order: 5 });
        control.size_after_failed_step(1.0, Some(32.0));
        assert_eq!(
            (control.size_after_failed_step(1.0, Some(32.0)), control.size_after_accepted_step(1.0, 1e-9)),
            (0.5, 1.0)
        );
        assert!(control.size_after_accepted_step(1.0, 1e-9) > 4.0);
    }

    /// Errors of 1, 2⁻⁸ and 2⁸ with the eighth root, and the bounds 1/3 and 6.
    #[test]
    fn hairer_divides_by_the_root_over_the_safety_within_bounds() {
        let rules = StepSizeRules::Hairer {
            order: 8,
            exponent: 0.125,
            earlier: EffectOfPreviousError::Forgotten,
            shrink: 1.0 / 3.0,
            grow: 6.0,
        };
        for (error, size) in [(1.0, 0.9), (1.0 / 256.0, 1.8), (0.0, 6.0)] {
            assert!(near(control(rules).size_after_accepted_step(1.0, error), size));
        }
        for (error, size) in [(256.0, 0.45), (f64::INFINITY, 1.0 / 3.0)] {
            assert!(near(control(rules).size_after_failed_step(1.0, Some(error)), size));
        }
        let mut control = control(rules);
        control.size_after_failed_step(1.0, None);
        assert_eq!(control.size_after_accepted_step(1.0, 1e-9), 1.0);
    }

    /// Truth: an error of 1 at size 1, then again at size 0.9. The size shrinks by 0.9 for safety, and by 0.9 again
    /// because the error did not shrink with the size. A size that would grow by 15 % stays. The margin 0.75 of a step
    /// that was hard to solve multiplies the size.
    #[test]
    fn a_size_that_was_too_large_is_foreseen_to_be_so_again() {
        let rules = StepSizeRules::Hairer {
            order: 5,
            exponent: 0.25,
            earlier: EffectOfPreviousError::Predicts,
            shrink: 0.2,
            grow: 8.0,
        };
        let mut predicts = control(rules);
        assert!(near(predicts.size_after_accepted_step(1.0, 1.0), 0.9));
        assert!(near(predicts.size_after_accepted_step(0.9, 1.0), 0.9 * 0.9 * 0.9));
        assert!(near(control(rules).size_after_accepted_step(1.0, 1.0 / 16.0), 1.8));
        assert_eq!(control(rules).size_after_accepted_step(1.0, (0.9_f64 / 1.15).powi(4)), 1.0);
        let mut hard = control(rules);
        hard.margin = 0.75;
        assert!(near(hard.size_after_accepted_step(1.0, 1.0 / 16.0), 1.35));
    }
}
