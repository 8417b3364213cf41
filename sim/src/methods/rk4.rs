//! Classical Runge–Kutta method of order 4. Its dense output is the cubic through the states and derivatives at the
//! ends of a step.
//!
//! W. Kutta, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen", Z. Math. Phys. 46 (1901)
//! 435–453. The stages are k₁ = f(t, y), k₂ = f(t + h/2, y + h/2 k₁), k₃ = f(t + h/2, y + h/2 k₂) and k₄ = f(t + h, y +
//! h k₃). The new state is y + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄).

use tripos_traits::Real;

use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite, evaluate};

/// Classical Runge–Kutta method in a run: the current step with its stages.
pub(crate) struct Rk4<S> {
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// State at the start of the step.
    y: Vec<S>,
    /// State at which a stage is evaluated; after the last stage, the state at the end of the step.
    y_new: Vec<S>,
    /// Derivatives of the four stages, then the derivative at the end of the step.
    k: [Vec<S>; 5],
    /// Number of calls of the right-hand side so far.
    evaluations: u64,
}

impl<S: Real> Rk4<S> {
    /// Creates the method for a state of `n` components.
    pub(crate) fn new(n: usize) -> Self {
        let zeros = || vec![S::from_f64(0.0); n];
        Self { t: 0.0, t_new: 0.0, y: zeros(), y_new: zeros(), k: [(); 5].map(|()| zeros()), evaluations: 0 }
    }

    /// Evaluates f at time `t`, s, and state `y_new`, and stores the result as the stage with index `stage`. Error if a
    /// number is not finite or f has no value.
    fn evaluate<R: RightHandSide<S>>(&mut self, rhs: &mut R, stage: usize, t: f64) -> Result<(), StepFailure> {
        check_finite(&self.y_new)?;
        self.evaluations += 1;
        evaluate(rhs, t, &self.y_new, &mut self.k[stage])
    }

    /// Writes the next state to evaluate, y + h k, to `y_new`. k is the derivative of the stage with index `stage`.
    fn next_rk4_point(&mut self, stage: usize, h: S) {
        for ((y_new, y), k) in self.y_new.iter_mut().zip(&self.y).zip(&self.k[stage]) {
            *y_new = *y + h * *k;
        }
    }
}

impl<S: Real> Interpolant for Rk4<S> {
    type Real = S;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[S], &[S]) {
        (&self.y, &self.y_new)
    }

    fn dense_output(&self, theta: S, mut put: impl FnMut(usize, S)) {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        let rest = S::int(1) - theta;
        for (i, (y, y_new)) in self.y.iter().zip(&self.y_new).enumerate() {
            // Hermite's cubic: y + θ Δ + θ (1 − θ) ((1 − θ) (h f − Δ) − θ (h f_new − Δ))
            let rise = *y_new - *y;
            let bend = rest * (h * self.k[0][i] - rise) - theta * (h * self.k[4][i] - rise);
            put(i, *y + theta * (rise + rest * bend));
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(3)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, S)) {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        for (i, (y, y_new)) in self.y.iter().zip(&self.y_new).enumerate() {
            // y + θ (Δ + a) − θ² (2 a + b) + θ³ (a + b), with a = h f − Δ and b = h f_new − Δ
            let rise = *y_new - *y;
            let (a, b) = (h * self.k[0][i] - rise, h * self.k[4][i] - rise);
            for (power, value) in [*y, rise + a, -(a + a + b), a + b].into_iter().enumerate() {
                put(i, power, value);
            }
        }
    }
}

impl<S: Real> Stepper for Rk4<S> {
    fn start<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        (self.t, self.t_new) = (t, t);
        self.y.copy_from_slice(y);
        self.y_new.copy_from_slice(y);
        self.evaluate(rhs, 0, t)
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, _test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<S>,
    {
        let h: S = trial.exact_step_length(self.t);
        let half = h * S::ratio(1, 2);
        for (stage, step, t) in
            [(1, half, self.t + 0.5 * trial.h), (2, half, self.t + 0.5 * trial.h), (3, h, trial.t_new)]
        {
            self.next_rk4_point(stage - 1, step);
            self.evaluate(rhs, stage, t)?;
        }
        let (sixth, two) = (h * S::ratio(1, 6), S::int(2));
        for i in 0..self.y.len() {
            let [k1, k2, k3, k4, _] = &self.k;
            self.y_new[i] = self.y[i] + sixth * (k1[i] + two * (k2[i] + k3[i]) + k4[i]);
        }
        self.t_new = trial.t_new;
        self.evaluate(rhs, 4, trial.t_new)?;
        Ok(0.0)
    }

    fn component_of_largest_error(&self, _test: &ErrorTest) -> Option<usize> {
        None
    }

    fn accept(&mut self) {
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        self.k.swap(0, 4);
    }

    fn slope(&self) -> &[S] {
        &self.k[0]
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
