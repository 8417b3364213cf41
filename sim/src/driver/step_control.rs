//! Step control of a run: equal steps, or steps as large as their error estimates allow.

use tripos_traits::Real;

use crate::error::SimError;
use crate::error_test::ErrorTest;
use crate::events::corners::{Corners, IntervalsBetweenCorners, SLOPE_DIRECTIONS};
use crate::methods::run_options::Options;
use crate::methods::step_size_rules::{self, StepSizeControl, StepSizeRules};
use crate::right_hand_side::RightHandSide;
use crate::rounding::exactly_equal;
use crate::stepper::{TrialStep, evaluate};
use crate::warning::Warning;

/// Decision on an attempted step: accept it, repeat it with a smaller size, or end the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// The step is part of the solution.
    Accepted {
        /// True if the step reached the end of the span of the run.
        last: bool,
    },
    /// The step is rejected, and a smaller step from the same time must be tried.
    Again,
    /// The step is rejected, and is already as small as is allowed: the run ends.
    GiveUp,
}

/// Step control of a run: the step that is being tried, and the data that decide the next sizes.
#[derive(Clone)]
pub(crate) struct StepControl {
    /// Start of the run, s.
    pub(crate) t0: f64,
    /// End of the run, s.
    t1: f64,
    /// Times at which the right-hand side has a corner or jump; adaptive steps end there.
    corners: Corners,
    /// Error test that a step must pass; `None` if all steps are equal.
    pub(crate) test: Option<ErrorTest>,
    /// Kind of step control: equal or adaptive steps.
    kind: Kind,
    /// Signed size and end time of the step that is being tried.
    pub(crate) trial: TrialStep,
    /// True if the trial step ends at the end of the run.
    last: bool,
    /// Number of calls of the right-hand side that the choice of the first step took.
    pub(crate) evaluations: u64,
}

/// Kind of step control: equal steps, or steps by error estimates.
#[derive(Clone)]
enum Kind {
    /// Equal steps. The number says how many there are in the span.
    Equal(f64),
    /// Steps whose size follows from their error estimates.
    Adaptive(Adaptive),
}

/// Step control by error estimates: its rules, its limits and the next size.
#[derive(Clone)]
struct Adaptive {
    /// Rules of the method for the choice of step sizes.
    rules: StepSizeRules,
    /// Controller that finds the next size from the error of a step.
    control: StepSizeControl,
    /// Largest allowed size of a step of the run, s.
    longest: f64,
    /// Smallest size of a step that is tried from the current time, s.
    smallest: f64,
    /// Proposed size of the next step, s, before the limits of the run are applied.
    size: f64,
    /// Size that the trial step would have without a corner, s; `None` if the trial step does not end at a corner.
    cut: Option<f64>,
}

impl StepControl {
    /// Creates the step control for a run of `n` equations over `span`, s, with a warning if the relative
    /// tolerance was raised.
    ///
    /// # Errors
    /// [`SimError`] for invalid tolerances, and for a method that has no error estimate if the options give
    /// no fixed step.
    pub(crate) fn new<S: Real>(
        span: (f64, f64),
        n: usize,
        options: &Options,
    ) -> Result<(Self, Option<Warning>), SimError> {
        let (t0, t1) = span;
        let trial = TrialStep { h: 0.0, t_new: t0 };
        // Equal steps ignore corners.
        let corners = if options.step.is_some() { &[][..] } else { &options.corners };
        let corners = Corners::new(corners, span);
        let pace =
            |kind, test| Self { t0, t1, corners: corners.clone(), test, kind, trial, last: false, evaluations: 0 };
        if let Some(step) = options.step {
            return Ok((pace(Kind::Equal(equal_steps((t1 - t0).abs() / step)), None), None));
        }
        let Some(rules) = crate::methods::method_rules::method_rules(options.method) else {
            return Err(SimError::NoStep { method: options.method.name() });
        };
        let (test, warning) = ErrorTest::new::<S>(
            crate::methods::method_rules::method_norm(options.method),
            options.rtol,
            &options.atol,
            n,
        )?;
        let length = (t1 - t0).abs();
        let longest = options.max_step.unwrap_or(rules.longest_part() * length).min(length);
        let control = StepSizeControl::new(rules, &test);
        let adaptive = Adaptive { rules, control, longest, smallest: 0.0, size: 0.0, cut: None };
        Ok((pace(Kind::Adaptive(adaptive), Some(test)), warning))
    }

    /// Chooses the size of the first step from the state `y` and its derivative `slope` at the start. A
    /// given size `initial`, s, has precedence.
    pub(crate) fn start<S, R>(&mut self, rhs: &mut R, y: &[S], slope: &[S], initial: Option<f64>)
    where
        S: Real,
        R: RightHandSide<S>,
    {
        if let Some(h) = self.first_size(y, slope, initial) {
            let step = S::from_f64(h);
            let probe: Vec<S> = y.iter().zip(slope).map(|(y, f)| *y + step * *f).collect();
            let mut beyond = vec![S::from_f64(0.0); y.len()];
            let known = evaluate(rhs, self.t0 + h, &probe, &mut beyond).is_ok();
            self.correct_first_size(y, slope, h, known.then_some(&beyond));
        }
    }

    /// Chooses the size of the first step from the state `y` and its derivative `slope` at the start. A given size
    /// `initial`, s, has precedence.
    ///
    /// Hairer's rules also need y' after a step of Euler's method. For these rules the signed size of that step, s, is
    /// returned, and [`StepControl::correct_first_size`] must be called next. `None` for other rules.
    pub(crate) fn first_size<S: Real>(&mut self, y: &[S], slope: &[S], initial: Option<f64>) -> Option<f64> {
        let (Kind::Adaptive(adaptive), Some(test)) = (&mut self.kind, &self.test) else { return None };
        let longest = adaptive.longest;
        match (initial, adaptive.rules) {
            (Some(size), _) => adaptive.size = size,
            (None, StepSizeRules::Proposed) => adaptive.size = longest,
            (None, StepSizeRules::Ode45 { order }) => {
                adaptive.size =
                    step_size_rules::initial_step_size(test, order, longest, self.t0, test.slope_norm(slope, y));
            }
            (None, StepSizeRules::Hairer { .. }) => {
                adaptive.size = step_size_rules::first_guess_of_step_size(
                    test.weighted_root_sum(y, y),
                    test.weighted_root_sum(slope, y),
                    longest,
                );
                return Some(adaptive.size * (self.t1 - self.t0).signum());
            }
        }
        None
    }

    /// Corrects the size of the first step. `beyond` is y' after a step of Euler's method of size `h`, s; `None` if y'
    /// has no value there.
    pub(crate) fn correct_first_size<S: Real>(&mut self, y: &[S], slope: &[S], h: f64, beyond: Option<&Vec<S>>) {
        self.evaluations += 1;
        let (Kind::Adaptive(adaptive), Some(test)) = (&mut self.kind, &self.test) else { return };
        let StepSizeRules::Hairer { order, .. } = adaptive.rules else { return };
        if let Some(c) = beyond.and_then(|beyond| norm_of_second_derivative(beyond, h, y, slope, test)) {
            let norm = test.weighted_root_sum(slope, y);
            adaptive.size = step_size_rules::second_guess_of_step_size(adaptive.size, norm, c, order, adaptive.longest);
        }
    }

    /// Passes all corners of the right-hand side up to time `t`, s. `None` if there are none. Else returns dt/dp of a
    /// passed jump, where p are the variables along which derivatives are taken; zeros if no passed jump depends on
    /// them.
    pub(crate) fn pass_corners(&mut self, t: f64) -> Option<[f64; SLOPE_DIRECTIONS]> {
        self.corners.pass_corners(t)
    }

    /// Intervals of time around the current time in which the right-hand side is smooth.
    pub(crate) fn smooth_intervals(&self) -> IntervalsBetweenCorners {
        self.corners.intervals_between_corners()
    }

    /// Sets the size of the next step, s, to the size that the method proposes.
    pub(crate) fn propose_step_size(&mut self, size: f64) {
        if let Kind::Adaptive(adaptive) = &mut self.kind {
            adaptive.size = size;
        }
    }

    /// Chooses the first trial of the step that begins at time `t`, s. `done` is the number of accepted
    /// steps.
    pub(crate) fn begin_step(&mut self, t: f64, done: u64) {
        match &mut self.kind {
            Kind::Equal(count) => {
                let next = done as f64 + 1.0;
                self.last = next >= *count;
                let t_new = if self.last { self.t1 } else { self.t0 + (self.t1 - self.t0) * (next / *count) };
                self.trial = TrialStep { h: t_new - t, t_new };
            }
            Kind::Adaptive(adaptive) => {
                adaptive.smallest = crate::rounding::smallest_step_beyond_rounding(t);
                let size = adaptive.size.min(adaptive.longest).max(adaptive.smallest);
                let corner = self.corners.next_corner();
                let end = corner.unwrap_or(self.t1);
                // The step is stretched or shortened to end exactly at `end`, if the stretch allowed by the rules
                // reaches it.
                let ends = adaptive.rules.largest_stretch_of_step() * size >= (end - t).abs();
                adaptive.cut = (ends && corner.is_some()).then_some(size);
                self.last = ends && corner.is_none();
                self.trial = if ends { TrialStep { h: end - t, t_new: end } } else { self.trial_of_size(t, size) };
            }
        }
    }

    /// Trial step of this size, s, from time `t`, s, in the direction of the run.
    fn trial_of_size(&self, t: f64, size: f64) -> TrialStep {
        let h = (self.t1 - self.t0).signum() * size;
        TrialStep { h, t_new: t + h }
    }

    /// Limits the size of the next step to the fraction `margin` of the size that the error estimates allow.
    pub(crate) fn limit_next_step(&mut self, margin: f64) {
        if let Kind::Adaptive(adaptive) = &mut self.kind {
            adaptive.control.margin = margin;
        }
    }

    /// Decides on the trial step that began at time `t`, s. `error` is the norm of its error; `None` if the step has no
    /// result. After [`Verdict::Again`] a smaller trial step is set.
    pub(crate) fn judge_step(&mut self, t: f64, error: Option<f64>) -> Verdict {
        let Kind::Adaptive(adaptive) = &mut self.kind else {
            return if error.is_some() { Verdict::Accepted { last: self.last } } else { Verdict::GiveUp };
        };
        let size = self.trial.h.abs();
        let tolerance = self.test.as_ref().map_or(f64::INFINITY, |test| test.tolerance);
        if let Some(error) = error
            && error <= tolerance
        {
            adaptive.size =
                adaptive.control.size_after_accepted_step(size, error).max(adaptive.cut.take().unwrap_or(0.0));
            return Verdict::Accepted { last: self.last };
        }
        if size <= adaptive.smallest {
            return Verdict::GiveUp;
        }
        let smaller = adaptive.control.size_after_failed_step(size, error).max(adaptive.smallest);
        (self.last, adaptive.cut) = (false, None);
        self.trial = self.trial_of_size(t, smaller);
        Verdict::Again
    }
}

/// Smallest number of equal steps that are no longer than the wanted step. `quotient` is the span divided by the wanted
/// step; a quotient that is whole up to rounding is the result.
fn equal_steps(quotient: f64) -> f64 {
    let nearest = quotient.round();
    let whole = (quotient - nearest).abs() <= 4.0 * f64::EPSILON * quotient;
    if whole { nearest.max(1.0) } else { quotient.ceil() }
}

/// Estimated norm of y'', from y' at the start (`slope`) and y' after a step `h` of Euler's method (`beyond`). `None`
/// if it is not finite.
fn norm_of_second_derivative<S: Real>(beyond: &[S], h: f64, y: &[S], slope: &[S], test: &ErrorTest) -> Option<f64> {
    let change: Vec<S> = beyond.iter().zip(slope).map(|(after, before)| *after - *before).collect();
    let curvature = test.weighted_root_sum(&change, y) / h.abs();
    (!exactly_equal(h, 0.0) && curvature.is_finite()).then_some(curvature)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_that_fits_but_for_rounding_is_not_divided() {
        assert_eq!(equal_steps(1.0 / 0.1), 10.0);
        assert_eq!(equal_steps(0.3 / 0.1), 3.0); // 2.9999999999999996
        assert_eq!(equal_steps(0.7 / 0.1), 7.0); // 6.999999999999999
        assert_eq!((equal_steps(2.5), equal_steps(0.1), equal_steps(1e-300)), (3.0, 1.0, 1.0));
    }
}
