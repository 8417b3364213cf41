//! What the driver asks of a one-step method: a trial step, its error, and the solution inside it.

use crate::error::Failure;
use crate::tolerance::ErrorTest;

/// Why a trial step has no result.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Trouble {
    /// A component of the state or its derivative became infinite or not a number.
    NotFinite {
        /// The component, from 0.
        component: usize,
    },
    /// The right-hand side has no value.
    Failed(Failure),
}

/// Position of the first entry that is not finite.
pub(crate) fn check_finite(values: &[f64]) -> Result<(), Trouble> {
    match values.iter().position(|x| !x.is_finite()) {
        Some(component) => Err(Trouble::NotFinite { component }),
        None => Ok(()),
    }
}

/// Whether two numbers are the same number.
#[expect(clippy::float_cmp, reason = "asks for identity, not for nearness")]
pub(crate) fn same(a: f64, b: f64) -> bool {
    a == b
}

/// The solution inside one step.
pub(crate) trait DenseStep {
    /// Start and end of the step, in s; the end is smaller when integrating backward.
    fn times(&self) -> (f64, f64);
    /// The state at the fraction `theta` of the step, exactly the step's ends at 0 and 1.
    /// A little beyond 1 is allowed and extrapolates.
    fn interpolate(&self, theta: f64, out: &mut [f64]);
    /// The time at the fraction `theta` of the step.
    fn time_at(&self, theta: f64) -> f64 {
        let (start, end) = self.times();
        if same(theta, 1.0) { end } else { start + theta * (end - start) }
    }
}

/// A one-step method. The driver alone knows about step sizes, events and output.
pub(crate) trait Stepper: DenseStep {
    /// Puts the method at (t, y) and evaluates the derivative there.
    fn start<F>(&mut self, rhs: &mut F, t: f64, y: &[f64]) -> Result<(), Trouble>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>;
    /// Tries the step from the current point over `h` to `t_end` (which is t + h, but exact at the
    /// end of a run), and returns its error in the norm of `test`.
    fn attempt<F>(&mut self, rhs: &mut F, h: f64, t_end: f64, test: &ErrorTest) -> Result<f64, Trouble>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>;
    /// Moves to the end of the step last tried.
    fn accept(&mut self);
    /// Order that the step size is controlled with.
    fn order(&self) -> u32;
    /// Current time.
    fn time(&self) -> f64;
    /// Current state.
    fn state(&self) -> &[f64];
    /// Derivative at the current point.
    fn slope(&self) -> &[f64];
    /// Calls of the right-hand side so far.
    fn evaluations(&self) -> u64;
}
