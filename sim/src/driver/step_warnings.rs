//! Signs that the steps of a run follow rounding errors, or kinks of the right-hand side f, and the warnings about
//! them.
//!
//! The examination is cheap. A relative tolerance is never below rounding, so that the errors of single steps are
//! examined only in runs without a relative tolerance. Kinks of f are detected from rejected steps alone.

use tripos_traits::Real;

use crate::error_test::ErrorTest;
use crate::stepper::Stepper;
use crate::warning::Warning;

/// Number of attempted steps with a sign of trouble from which on there is a warning; fewer do no harm.
const ENOUGH: u64 = 20;
/// Number of attempted steps among which one fruitless retry (a shorter step whose error did not fall) is normal. More
/// retries mean that f is not smooth.
///
/// Noise of the size of the tolerance causes a fruitless retry in 20 to 40 attempts, jumps of f in 5 to 20. Smooth
/// equations cause one in 100 at tolerances of 1e-3, and fewer at smaller tolerances.
const ONE_IN: u64 = 50;

/// Signs that the steps of a run are doubtful, counted so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct StepWarnings {
    /// Number of attempted steps of the run so far, accepted or not.
    attempts: u64,
    /// Data about the attempts in which a tolerance was below rounding; `None` if there were none.
    below: Option<ToleranceBelowRounding>,
    /// Size, s, and error norm of the attempt before the current one, if its error was too large; else `None`.
    rejected: Option<(f64, f64)>,
    /// Time of the first retry whose error did not fall, s, and the number of such retries; `None` if there
    /// were none.
    fruitless: Option<(f64, u64)>,
    /// Start time of the first step with a point inside at which f has no value, s; `None` if there was none.
    coarse: Option<f64>,
}

/// Record of attempted steps whose error norm was decided by a component with an allowed error below its rounding. The
/// data are those of the worst attempt.
#[derive(Clone, Debug)]
struct ToleranceBelowRounding {
    /// Index in the state, from 0, of the component whose allowed error is below its rounding.
    component: usize,
    /// Start time of the attempt in which the tolerance was farthest below rounding, s.
    t: f64,
    /// Absolute value of the component in the attempt that was farthest below rounding, in its unit.
    size: f64,
    /// Error of the component that the absolute tolerance allows, in its unit.
    allowed: f64,
    /// Number of attempts whose error norm was decided by a component with an allowed error below its rounding.
    attempts: u64,
}

impl StepWarnings {
    /// Counts an attempted step of size `step`, s, with the norm `error` of its error, and examines it for
    /// signs of trouble.
    pub(crate) fn note_step_error<M: Stepper>(&mut self, stepper: &M, test: &ErrorTest, step: f64, error: f64) {
        let t = stepper.span().0;
        self.attempts += 1;
        if let Some((longer, before)) = self.rejected {
            // A true error falls with a high power of the step. Noise, or the effect of a jump, falls at most in
            // proportion to the step.
            let ratio = step / longer;
            if ratio <= 0.9 && error >= before * ratio * ratio {
                self.fruitless.get_or_insert((t, 0)).1 += 1;
            }
        }
        self.rejected = (error > test.tolerance).then_some((step, error));
        if test.is_absolute() {
            self.note_rounding(stepper, test);
        }
    }

    /// Counts an attempted step that has no error estimate, and therefore shows no sign of trouble.
    pub(crate) fn note_trouble(&mut self) {
        self.attempts += 1;
        self.rejected = None;
    }

    /// Records an accepted step whose dense output is of a lower order, because f has no value at a point
    /// inside it.
    pub(crate) fn note_coarse<M: Stepper>(&mut self, stepper: &M) {
        self.coarse.get_or_insert(stepper.span().0);
    }

    /// Counts the attempt if a tolerance is below rounding: the component with the largest weighted error has an
    /// allowed error below four times its rounding error.
    fn note_rounding<M: Stepper>(&mut self, stepper: &M, test: &ErrorTest) {
        let (y, y_new) = stepper.ends();
        let size = |i: usize| y[i].to_f64().abs().max(y_new[i].to_f64().abs());
        let below = |i: usize| test.absolutely_allowed_error(i) < 4.0 * <M::Real as Real>::EPSILON * size(i);
        if !(0..y.len()).any(below) {
            return;
        }
        if let Some(component) = stepper.component_of_largest_error(test).filter(|i| below(*i)) {
            let (t, size, allowed) = (stepper.span().0, size(component), test.absolutely_allowed_error(component));
            let attempts = self.below.as_ref().map_or(0, |below| below.attempts) + 1;
            let now = ToleranceBelowRounding { component, t, size, allowed, attempts };
            match &mut self.below {
                Some(worst) if worst.size * allowed >= size * worst.allowed => worst.attempts = attempts,
                below => *below = Some(now),
            }
        }
    }

    /// Returns the warnings that the counted signs justify: a tolerance below rounding, f not smooth, and a coarse
    /// solution inside a step.
    pub(crate) fn warnings<S: Real>(self) -> impl Iterator<Item = Warning> {
        let below = self.below.filter(|below| below.attempts >= ENOUGH);
        let below = below.map(|ToleranceBelowRounding { component, t, size, allowed, attempts }| {
            let spacing = S::EPSILON * size;
            Warning::ToleranceBelowRounding { component, t, size, spacing, allowed, attempts }
        });
        let attempts = self.attempts;
        let often = |retries: u64| retries >= ENOUGH && retries * ONE_IN >= attempts;
        let kinks = self.fruitless.filter(|(_, retries)| often(*retries));
        let kinks = kinks.map(|(t, retries)| Warning::NotSmooth { t, retries, attempts });
        let coarse = self.coarse.map(|t| Warning::CoarseInside { t });
        below.into_iter().chain(kinks).chain(coarse)
    }
}
