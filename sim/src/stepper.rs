//! Interface of a one-step method of integration to the driver of a run: a trial step, its error, and
//! its dense output.

use tripos_traits::{Real, Scalar};

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

/// Checks that all entries of a state or derivative are finite. The error has the index of the first
/// entry that is not.
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

/// True if two numbers are exactly equal; 0 equals −0.
#[expect(clippy::float_cmp, reason = "asks for identity, not for nearness")]
pub(crate) fn exactly_equal(a: f64, b: f64) -> bool {
    a == b
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
    /// Signed distance from time `t` to the end of the step, s, computed in the scalar `S`. A scalar wider
    /// than `f64` holds it without rounding.
    pub(crate) fn exact_step_length<S: Real>(self, t: f64) -> S {
        S::from_f64(self.t_new) - S::from_f64(t)
    }
}

/// Dense output of a step (the solution inside it), rounded to `f64`, for the search of events.
pub(crate) trait DenseStep {
    /// Start and end time of the step, s. The end is before the start in a run backward in time.
    fn times(&self) -> (f64, f64);
    /// Writes the state at the fraction `theta` of the step. At 0 and 1 it is exactly the state at the
    /// step's ends. Values a little above 1 are allowed and extrapolate.
    fn interpolate(&self, theta: f64, out: &mut [f64]);
    /// Degree of the dense output as a polynomial in the fraction of the step; `None` if it is no
    /// polynomial.
    fn degree(&self) -> Option<usize>;
    /// Writes the coefficients of the dense output in powers of the fraction of the step, (degree + 1) × n
    /// numbers. Row k has those of power k, an entry for each of the n components.
    fn dense_output_powers(&self, out: &mut [f64]);
    /// Time at the fraction `theta` of the step, s.
    fn time_at(&self, theta: f64) -> f64 {
        let (start, end) = self.times();
        if exactly_equal(theta, 1.0) { end } else { start + theta * (end - start) }
    }
}

/// Dense output of a step (the solution inside it), in the scalar type of the run.
pub(crate) trait Interpolant {
    /// Scalar type in which the run computes its states.
    type Real: Real;
    /// Start and end time of the step, s.
    fn span(&self) -> (f64, f64);
    /// States at the start and at the end of the step.
    fn ends(&self) -> (&[Self::Real], &[Self::Real]);
    /// Computes the state at the fraction `theta` of the step. Calls `put(i, value)` for each component i.
    fn dense_output(&self, theta: Self::Real, put: impl FnMut(usize, Self::Real));
    /// Degree of the dense output as a polynomial in the fraction of the step; `None` if it is no
    /// polynomial.
    fn degree_of_dense_output(&self) -> Option<usize>;
    /// Computes the coefficients of the dense output in powers of the fraction of the step. Calls `put(i,
    /// k, value)` for each component i and each power k up to the degree. The polynomial equals
    /// [`Interpolant::inside`] up to rounding.
    fn coefficients(&self, put: impl FnMut(usize, usize, Self::Real));

    /// Returns the state at the fraction `theta` of the step. `t` is the time there, s.
    fn sample(&self, theta: f64, t: f64) -> Vec<Self::Real> {
        let (y, y_new) = self.ends();
        let mut out = if exactly_equal(theta, 1.0) { y_new.to_vec() } else { y.to_vec() };
        if !exactly_equal(theta, 0.0) && !exactly_equal(theta, 1.0) {
            self.dense_output(self.fraction(theta, t), |i, value| out[i] = value);
        }
        out
    }

    /// Fraction of the step at time `t`, s, as exactly as the run's scalar can hold it. `theta` is the same
    /// fraction in `f64`.
    fn fraction(&self, theta: f64, t: f64) -> Self::Real {
        let wide = <Self::Real as Scalar>::from_f64;
        if <Self::Real as Real>::EPSILON < f64::EPSILON {
            let (start, end) = self.span();
            (wide(t) - wide(start)) / (wide(end) - wide(start))
        } else {
            wide(theta)
        }
    }
}

impl<I: Interpolant> DenseStep for I {
    fn times(&self) -> (f64, f64) {
        self.span()
    }

    fn interpolate(&self, theta: f64, out: &mut [f64]) {
        let (y, y_new) = self.ends();
        let mut round = |values: &[I::Real]| {
            for (o, value) in out.iter_mut().zip(values) {
                *o = value.to_f64();
            }
        };
        if exactly_equal(theta, 0.0) {
            round(y);
        } else if exactly_equal(theta, 1.0) {
            round(y_new);
        } else {
            self.dense_output(I::Real::from_f64(theta), |i, value| out[i] = value.to_f64());
        }
    }

    fn degree(&self) -> Option<usize> {
        self.degree_of_dense_output()
    }

    fn dense_output_powers(&self, out: &mut [f64]) {
        let components = self.ends().0.len();
        self.coefficients(|i, k, value| out[k * components + i] = value.to_f64());
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
    /// Size of the next step, s, for a method that finds it before the step is tried, as Taylor's does.
    /// `None` for a method that needs step control.
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
    /// Evaluates the stages that only the dense output of the last tried step needs. False if f has no
    /// value there; the dense output is then of lower order.
    fn prepare_inside<R>(&mut self, rhs: &mut R) -> bool
    where
        R: RightHandSide<Self::Real>,
    {
        let _ = rhs;
        true
    }
    /// Announces, before the start, that the driver may move the state after each step. Each accepted step
    /// is then followed by [`Stepper::continue_from_moved_state`] or [`Stepper::stay`].
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
    /// Continues from the state `y` at the current time, in place of the state that the last step reached.
    /// Error if the derivative there has no finite value.
    fn continue_from_moved_state<R>(&mut self, rhs: &mut R, y: &[Self::Real]) -> Result<(), StepFailure>
    where
        R: RightHandSide<Self::Real>,
    {
        let t = self.span().0;
        self.start(rhs, t, y)
    }
    /// Factor, at most 1, by which the next step must be smaller than the error of the last tried step
    /// allows. It is below 1 if the equations of an implicit step were hard to solve.
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
