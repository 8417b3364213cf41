//! Interface between a one-step method of integration and the driver of a run: a trial step, its error, and its dense
//! output.

use tripos_traits::Real;

use crate::dense_output::Interpolant;
use crate::error::Failure;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;

/// Reason why an attempted step has no result. The driver then tries a smaller step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum StepFailure {
    /// A component of the state or its derivative became infinite or not a number.
    NotFinite {
        /// Index in the state, from 0, of the component that is infinite or not a number.
        component: usize,
    },
    /// The right-hand side has no value at a point of the step.
    Failed(Failure),
    /// Newton's method did not solve the equations of an implicit step.
    NotConverged {
        /// Number of iterations of Newton's method that were made.
        iterations: u32,
    },
}

/// Checks that all entries of a state or derivative are finite. The error has the index of the first entry that is not
/// finite.
pub(crate) fn check_finite<S: Real>(values: &[S]) -> Result<(), StepFailure> {
    match values.iter().position(|x| !x.to_f64().is_finite()) {
        Some(component) => Err(StepFailure::NotFinite { component }),
        None => Ok(()),
    }
}

/// Writes f(t, y) to `out`. Error if f has no value there, or if an entry is not finite.
#[inline]
pub(crate) fn evaluate<S, R>(rhs: &mut R, t: f64, y: &[S], out: &mut [S]) -> Result<(), StepFailure>
where
    S: Real,
    R: RightHandSide<S>,
{
    rhs.rhs(t, y, out).map_err(StepFailure::Failed)?;
    check_finite(out)
}

/// Size and end time of a step that is being tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrialStep {
    /// Signed size of the step, s, as the step control chose it; negative in a run backward in time.
    pub(crate) h: f64,
    /// Time at the end of the step, s: t + h after rounding, or exactly the end of the run.
    pub(crate) t_new: f64,
}

impl TrialStep {
    /// Signed distance from time `t` to the end of the step, s, computed in the scalar `S`. A scalar wider than `f64`
    /// represents it without rounding.
    pub(crate) fn exact_step_length<S: Real>(self, t: f64) -> S {
        S::from_f64(self.t_new) - S::from_f64(t)
    }
}

/// One-step method of integration. It tries single steps; the driver decides on step sizes, events and
/// output.
pub(crate) trait Stepper: Interpolant {
    /// Sets the method to the state `y` at time `t`, s, and evaluates the derivative there. Error if the
    /// derivative has no finite value.
    fn start<R>(&mut self, rhs: &mut R, t: f64, y: &[Self::Real]) -> Result<(), StepFailure>
    where
        R: RightHandSide<Self::Real>;
    /// Size of the next step, s, for a method that knows it before the step is tried, as Taylor's method does. `None`
    /// for a method that needs step control.
    fn proposal(&mut self, test: &ErrorTest) -> Option<f64> {
        let _ = test;
        None
    }
    /// Tries a step from the current state, and returns its error in the norm of `test`; 0 if there is no
    /// test. The derivative at the step's end is known if the step passes the test. Error if the step has
    /// no result.
    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<Self::Real>;
    /// Evaluates the stages that only the dense output of the last tried step needs. Returns false if f has no value
    /// there; the dense output is then of lower order.
    fn prepare_inside<R>(&mut self, rhs: &mut R) -> bool
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        true
    }
    /// Announces, before the start, that the driver may move the state after each step. Each accepted step
    /// is then followed by [`Stepper::continue_from_moved_state`] or [`Stepper::continue_unmoved`].
    fn expect_moves(&mut self) {}
    /// Continues from the current state after an accepted step. The driver was allowed to move the state,
    /// but did not. Error if the derivative there has no finite value.
    fn continue_unmoved<R>(&mut self, rhs: &mut R) -> Result<(), StepFailure>
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        Ok(())
    }
    /// Continues from the state `y` at the current time instead of the state that the last step reached. Error if the
    /// derivative there has no finite value.
    fn continue_from_moved_state<R>(&mut self, rhs: &mut R, y: &[Self::Real]) -> Result<(), StepFailure>
    where
        R: RightHandSide<Self::Real>,
    {
        let t = self.span().0;
        self.start(rhs, t, y)
    }
    /// Factor, at most 1, on the size that the error of the last tried step allows for the next step. It is below 1 if
    /// the equations of an implicit step were hard to solve.
    fn next_step_margin(&self) -> f64 {
        1.0
    }
    /// Index of the component with the largest weighted error in the last tried step; `None` if all errors
    /// are 0.
    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize>;
    /// Makes the last tried step part of the solution: its end becomes the current state.
    fn accept(&mut self);
    /// Derivative y' at the start of the run, before the first step.
    fn slope(&self) -> &[Self::Real];
    /// Number of calls of the right-hand side by this method so far.
    fn evaluations(&self) -> u64;
    /// Number of evaluations of the Jacobian ∂f/∂y so far; 0 for explicit methods.
    fn jacobians(&self) -> u64 {
        0
    }
}
