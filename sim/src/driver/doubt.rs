//! Signs that the steps of a run follow rounding errors, or kinks of f.
//!
//! The watch is cheap: a relative tolerance is never below rounding, so that only runs without one are examined step by
//! step. Whether f is smooth shows in rejected steps alone.

use tripos_traits::Real;

use crate::stepper::Stepper;
use crate::tolerance::ErrorTest;
use crate::warning::Warning;

/// Number of attempted steps that must show a sign of trouble before there is a warning: fewer do no harm.
const ENOUGH: u64 = 20;
/// Number of attempts per fruitless retry below which such retries are a sign of a function that is not smooth. Noise
/// of the size of the tolerance makes a retry of 20 to 40 attempts fruitless, jumps of f one of 5 to 20. Smooth
/// equations have one in 100 at tolerances of 1e-3, and fewer below.
const ONE_IN: u64 = 50;

/// Signs of doubtful steps that a run has shown so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Doubts {
    attempts: u64,
    below: Option<Below>,
    /// Size and error of the attempt before, if the step is being tried again.
    rejected: Option<(f64, f64)>,
    /// Time of the first fruitless retry, s, and the number of such retries.
    fruitless: Option<(f64, u64)>,
    /// Start of the first step inside which f has no value, s.
    coarse: Option<f64>,
}

/// Count of attempts decided by a component whose allowed error is below its rounding, with the worst of them.
#[derive(Clone, Debug)]
struct Below {
    component: usize,
    t: f64,
    size: f64,
    allowed: f64,
    attempts: u64,
}

impl Doubts {
    /// Takes note of an attempted step that has an error.
    pub(crate) fn note<M: Stepper>(&mut self, stepper: &M, test: &ErrorTest, step: f64, error: f64) {
        let t = stepper.span().0;
        self.attempts += 1;
        if let Some((longer, before)) = self.rejected {
            // A true error falls with a high power of the step; noise, or the effect of a jump, falls only with the
            // step.
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

    /// Takes note of an attempted step without a result.
    pub(crate) fn note_trouble(&mut self) {
        self.attempts += 1;
        self.rejected = None;
    }

    /// Takes note of an accepted step inside of which the solution is not known to its full order.
    pub(crate) fn note_coarse<M: Stepper>(&mut self, stepper: &M) {
        self.coarse.get_or_insert(stepper.span().0);
    }

    fn note_rounding<M: Stepper>(&mut self, stepper: &M, test: &ErrorTest) {
        let (y, y_new) = stepper.ends();
        let size = |i: usize| y[i].to_f64().abs().max(y_new[i].to_f64().abs());
        let below = |i: usize| test.allowed(i) < 4.0 * <M::Real as Real>::EPSILON * size(i);
        if !(0..y.len()).any(below) {
            return;
        }
        if let Some(component) = stepper.worst(test).filter(|i| below(*i)) {
            let (t, size, allowed) = (stepper.span().0, size(component), test.allowed(component));
            let attempts = self.below.as_ref().map_or(0, |below| below.attempts) + 1;
            let now = Below { component, t, size, allowed, attempts };
            match &mut self.below {
                Some(worst) if worst.size * allowed >= size * worst.allowed => worst.attempts = attempts,
                below => *below = Some(now),
            }
        }
    }

    /// Warnings that the signs justify: tolerance below rounding, f not smooth, and a coarse solution inside a step.
    pub(crate) fn warnings<S: Real>(self) -> impl Iterator<Item = Warning> {
        let below = self.below.filter(|below| below.attempts >= ENOUGH);
        let below = below.map(|Below { component, t, size, allowed, attempts }| {
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
