//! Steps of an explicit embedded Runge–Kutta pair, such as Dormand–Prince 5(4).
//!
//! Invariant: `k[0]` is the derivative at (t, y); after a trial step `k[S-1]` is the derivative at its
//! end. Buffers are made once; a step allocates nothing. Absent on purpose: the choice of the step
//! size.

use tripos_traits::Real;

use super::tableau::{Coefficients, Tableau};
use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite, evaluate};

/// Kind of the step length h by which a Runge–Kutta method multiplies the derivatives of its stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepLength {
    /// Step length as it was chosen, before t + h was rounded, as in `ode45`. A scalar wider than `f64` uses
    /// [`StepLength::Exact`] instead, since the rounding of t + h would be its largest error.
    Chosen,
    /// Difference of the times at the end and at the start of the step.
    Exact,
}

/// Explicit Runge–Kutta method with S stages in a run: the current step with its stages and error.
pub(crate) struct ExplicitRungeKutta<T, const S: usize> {
    /// Coefficients of the Runge–Kutta method in the scalar of the run.
    coefficients: Coefficients<T, S>,
    /// Kind of the step length by which derivatives are multiplied.
    length: StepLength,
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// State at the start of the step.
    y: Vec<T>,
    /// State at which a stage is evaluated; after the last stage, the state at the end of the step.
    y_new: Vec<T>,
    /// Derivatives kᵢ of the S stages of the step.
    k: [Vec<T>; S],
    /// Working space for weighted sums of the stages; after an attempt, the error estimate divided by h.
    sum: Vec<T>,
    /// Number of calls of the right-hand side so far.
    evaluations: u64,
}

impl<T: Real, const S: usize> ExplicitRungeKutta<T, S> {
    /// Creates the method for a state of `n` components; [`Stepper::start`] must be called first.
    pub(crate) fn new(tableau: &Tableau<S>, length: StepLength, n: usize) -> Self {
        let zeros = || vec![T::from_f64(0.0); n];
        Self {
            coefficients: Coefficients::new(tableau),
            length,
            t: 0.0,
            t_new: 0.0,
            y: zeros(),
            y_new: zeros(),
            k: std::array::from_fn(|_| zeros()),
            sum: zeros(),
            evaluations: 0,
        }
    }

    /// Evaluates f at time `t`, s, and state `y_new`, and stores the result as the stage with index `stage`. Error if a
    /// number is not finite or f has no value.
    fn evaluate<R: RightHandSide<T>>(&mut self, rhs: &mut R, stage: usize, t: f64) -> Result<(), StepFailure> {
        check_finite(&self.y_new)?;
        self.evaluations += 1;
        evaluate(rhs, t, &self.y_new, &mut self.k[stage])
    }

    /// Signed length of a trial step, s, by which derivatives are multiplied.
    fn step_length(&self, trial: TrialStep) -> T {
        match self.length {
            StepLength::Chosen if T::EPSILON >= f64::EPSILON => T::from_f64(trial.h),
            StepLength::Chosen | StepLength::Exact => trial.exact_step_length(self.t),
        }
    }
}

/// Writes the weighted sum Σⱼ weight(j) kⱼ of the stages to `sum`.
fn combine_stages<T: Real>(sum: &mut [T], k: &[Vec<T>], weight: impl Fn(usize) -> T) {
    let zero = T::from_f64(0.0);
    sum.fill(zero);
    for (j, k_j) in k.iter().enumerate() {
        let w = weight(j);
        if w != zero {
            for (s, k_ji) in sum.iter_mut().zip(k_j) {
                *s = *s + w * *k_ji;
            }
        }
    }
}

impl<T: Real, const S: usize> Interpolant for ExplicitRungeKutta<T, S> {
    type Real = T;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[T], &[T]) {
        (&self.y, &self.y_new)
    }

    fn dense_output(&self, theta: T, mut put: impl FnMut(usize, T)) {
        let h = T::from_f64(self.t_new) - T::from_f64(self.t);
        let zero = T::from_f64(0.0);
        // h (d_0 θ + d_1 θ² + d_2 θ³ + d_3 θ⁴)
        let weight = |d: &[T; 4]| h * theta * (d[0] + theta * (d[1] + theta * (d[2] + theta * d[3])));
        let weights = self.coefficients.dense.each_ref().map(weight);
        for (i, y) in self.y.iter().enumerate() {
            let mut sum = zero;
            for (w, k) in weights.iter().zip(&self.k) {
                if *w != zero {
                    sum = sum + *w * k[i];
                }
            }
            put(i, sum + *y);
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(4)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, T)) {
        let h = T::from_f64(self.t_new) - T::from_f64(self.t);
        let dense = &self.coefficients.dense;
        for (i, y) in self.y.iter().enumerate() {
            put(i, 0, *y);
            for power in 0..4 {
                let sum = dense.iter().zip(&self.k).fold(T::from_f64(0.0), |sum, (d, k)| sum + d[power] * k[i]);
                put(i, power + 1, h * sum);
            }
        }
    }
}

impl<T: Real, const S: usize> Stepper for ExplicitRungeKutta<T, S> {
    fn start<R: RightHandSide<T>>(&mut self, rhs: &mut R, t: f64, y: &[T]) -> Result<(), StepFailure> {
        (self.t, self.t_new) = (t, t);
        self.y.copy_from_slice(y);
        self.y_new.copy_from_slice(y);
        self.evaluate(rhs, 0, t)
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<T>,
    {
        let h = self.step_length(trial);
        for i in 1..S {
            // Y_i = y + Σ_j (h a_ij) k_j,  k_i = f(t + c_i h, Y_i); the last Y_i is the new point.
            let row = &self.coefficients.a[i];
            combine_stages(&mut self.sum, &self.k[..i], |j| h * row[j]);
            for ((y_new, y), sum) in self.y_new.iter_mut().zip(&self.y).zip(&self.sum) {
                *y_new = *y + *sum;
            }
            let t = if i + 1 == S { trial.t_new } else { self.t + trial.h * self.coefficients.c[i] };
            self.evaluate(rhs, i, t)?;
        }
        self.t_new = trial.t_new;
        let Some(test) = test else { return Ok(0.0) };
        // error = |h| max_i |Σ_j e_j k_ji| / weight_i
        combine_stages(&mut self.sum, &self.k, |j| self.coefficients.error[j]);
        let error = trial.h.abs() * test.norm(&self.sum, &self.y, &self.y_new);
        if error.is_nan() {
            check_finite(&self.sum)?;
        }
        Ok(error)
    }

    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize> {
        // `sum` still holds the error estimate of the last attempt.
        test.component_of_largest_weighted_error(self.sum.iter().copied(), &self.y, &self.y_new)
    }

    fn accept(&mut self) {
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        self.k.swap(0, S - 1);
    }

    fn slope(&self) -> &[T] {
        &self.k[0]
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
