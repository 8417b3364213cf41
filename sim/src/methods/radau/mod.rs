//! Radau IIA with three stages, the method `radau5`: order 5, implicit, A- and L-stable, for stiff equations.
//!
//! The polynomial u of degree 3 with u(t) = y satisfies the equations at the three zeros of Radau's polynomial, of
//! which the last is the end of the step. u is also the dense output, of order 3. Fast decaying parts of the solution
//! vanish in a step of any length, so that the motion alone limits the steps.
//!
//! The method, its error estimate and its step control are those of the code RADAU5: E. Hairer & G. Wanner, *Solving
//! Ordinary Differential Equations II. Stiff and Differential-Algebraic Problems*, 2nd edition (1996), §IV.8.
//!
//! Invariant: `z` has the differences between the stages of the last tried step and its start, all components of the
//! first stage first; `inside` has their polynomial. Newton's method, with the data that it keeps from step to step, is
//! in [`radau_newton`].

mod complex;
mod radau_coefficients;
mod radau_newton;

use tripos_traits::{Real, larger};

use super::run_options::Options;
use crate::dense_output::Interpolant;
use crate::error_test::ErrorTest;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite, evaluate};
use radau_coefficients::{Scheme, dot};
use radau_newton::{Newton, NewtonAccuracy, StageVectors};

/// Number of iterations of Newton's method after which an adaptive step is given up, as in RADAU5.
const ITERATIONS: u32 = 7;
/// Largest number of iterations of Newton's method for a step of fixed length. Such a step cannot be
/// shortened and is solved to rounding.
const FIXED_ITERATIONS: u32 = 30;

/// Radau's method in a run: the current step with its stages, error and dense output.
pub(crate) struct Radau5<S> {
    /// Coefficients of Radau IIA with three stages.
    scheme: Scheme<S>,
    /// Newton's method, which solves the equations of the three stages.
    newton: Newton<S>,
    /// Factor by which an accepted error estimate may exceed the tolerance, from the function
    /// [`radau_error_allowance`].
    leeway: f64,
    /// Tolerance that decides most steps: the relative tolerance, or the smallest absolute tolerance if the relative
    /// one is zero.
    tolerance: f64,
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// State at the start of the step.
    y: Vec<S>,
    /// State at the end of the step.
    y_new: Vec<S>,
    /// Differences Z between the three stages and `y`, 3n entries: all components of the first stage first.
    z: Vec<S>,
    /// Transformed stage differences W = (T⁻¹ ⊗ I) Z, 3n entries. In these variables the equations of a step separate.
    w: Vec<S>,
    /// Derivatives f at the three stages, 3n entries.
    f: Vec<S>,
    /// Coefficients of θ, θ² and θ³ in the dense output u − y of the step, 3n entries, with the fraction θ
    /// of the step.
    inside: Vec<S>,
    /// Coefficients of the dense output of the previous step, 3n entries.
    before: Vec<S>,
    /// Signed length of the previous step, s; `None` if the current step is the first.
    h_before: Option<S>,
    /// Derivative f at the start of the step.
    slope: Vec<S>,
    /// Derivative f at the end of the step, known only after a step that passed its error test.
    slope_new: Vec<S>,
    /// Error estimate of the last tried step, for each component of the state.
    error: Vec<S>,
    /// State at which a stage is evaluated.
    point: Vec<S>,
    /// Largest absolute value of each component of the state so far.
    magnitudes: Vec<f64>,
    /// True if the last step was accepted; false at the start and after a failed step.
    goes_well: bool,
    /// Number of calls of the right-hand side so far.
    evaluations: u64,
}

impl<S: Real> Radau5<S> {
    /// Creates the method for a state of `n` components, with the tolerances of these options.
    pub(crate) fn new(n: usize, options: &Options) -> Self {
        let zeros = |n: usize| vec![S::int(0); n];
        let tolerance = if options.rtol > 0.0 { options.rtol } else { options.atol.smallest() };
        let tolerance = tolerance.clamp(S::EPSILON, 1.0);
        Self {
            scheme: Scheme::new(),
            newton: Newton::new(n),
            leeway: radau_error_allowance(tolerance),
            tolerance,
            t: 0.0,
            t_new: 0.0,
            y: zeros(n),
            y_new: zeros(n),
            z: zeros(3 * n),
            w: zeros(3 * n),
            f: zeros(3 * n),
            inside: zeros(3 * n),
            before: zeros(3 * n),
            h_before: None,
            slope: zeros(n),
            slope_new: zeros(n),
            error: zeros(n),
            point: zeros(n),
            magnitudes: vec![0.0; n],
            goes_well: false,
            evaluations: 0,
        }
    }

    /// Sets the initial values of Z for Newton's method, for a step of `h` s. They continue the polynomial of the
    /// previous step, and are 0 if there is no previous step.
    fn predict_radau_stages(&mut self, h: S) {
        let n = self.y.len();
        let Some(before) = self.h_before else { return self.z.fill(S::int(0)) };
        for (stage, c) in self.scheme.c.into_iter().enumerate() {
            let theta = S::int(1) + c * (h / before);
            for i in 0..n {
                let [a, b, c] = [self.before[i], self.before[n + i], self.before[2 * n + i]];
                self.z[stage * n + i] = theta * (a + theta * (b + theta * c)) - (a + b + c);
            }
        }
    }

    /// Solves the equations of the step to the accuracy `aim`, from the predicted values of Z. Error if Newton's method
    /// does not converge or f has no value.
    fn solve_radau_stages<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        trial: TrialStep,
        h: S,
        aim: &NewtonAccuracy,
    ) -> Result<(), StepFailure> {
        let n = self.y.len();
        self.newton.prepare_newton_matrices(rhs, self.t, &self.y, &self.scheme, h)?;
        self.predict_radau_stages(h);
        let Self { newton, scheme, y, z, w, f, point, evaluations, t, .. } = self;
        let t = *t;
        let c = scheme.c;
        newton.solve(scheme, h, StageVectors { z, w, f }, aim, |z, f| {
            for (stage, c) in c.iter().enumerate() {
                for ((point, y), z) in point.iter_mut().zip(&*y).zip(&z[stage * n..]) {
                    *point = *y + *z;
                }
                check_finite(point)?;
                let at = if stage == 2 { trial.t_new } else { t + c.to_f64() * trial.h };
                *evaluations += 1;
                evaluate(rhs, at, point, &mut f[stage * n..(stage + 1) * n])?;
            }
            Ok(())
        })
    }

    /// Sets the weights of the components in Newton's method, and returns the accuracy to which the equations of the
    /// step are solved.
    ///
    /// With an error test, the weights are the allowed errors, and the remaining error must be a small fraction of
    /// them. Without a test, the weights are the sizes of the components, and the remaining error must be as small as
    /// rounding.
    fn radau_accuracy(&mut self, h: S, test: Option<&ErrorTest>) -> NewtonAccuracy {
        let n = self.y.len();
        for i in 0..n {
            let size = self.y[i].to_f64().abs();
            let moved = (h * self.slope[i]).to_f64().abs();
            self.newton.weights[i] = match test {
                Some(test) => {
                    let weight = self.leeway * test.weight(i, size);
                    // The weight of a component at 0 without an absolute tolerance follows from its change in the step.
                    if weight > self.leeway * f64::MIN_POSITIVE { weight } else { self.leeway * test.weight(i, moved) }
                }
                None => self.magnitudes[i].max(moved),
            };
        }
        if test.is_none() {
            let most = self.newton.weights.iter().copied().fold(0.0, larger);
            let rest = if most > 0.0 { most } else { 1.0 };
            for weight in self.newton.weights.iter_mut().filter(|weight| **weight <= 0.0) {
                *weight = rest;
            }
            return NewtonAccuracy { enough: S::EPSILON, rounding: S::EPSILON.sqrt(), iterations: FIXED_ITERATIONS };
        }
        let parts = self.y.iter().zip(&self.newton.weights).map(|(y, weight)| y.to_f64() / weight);
        let size = (parts.map(|part| part * part).sum::<f64>() / n.max(1) as f64).sqrt();
        let rounding = 10.0 * S::EPSILON * size;
        let part = (self.leeway * self.tolerance).sqrt().min(0.03);
        NewtonAccuracy { enough: part.max(rounding), rounding: rounding.min(1.0), iterations: ITERATIONS }
    }

    /// Estimates the error of the step of `h` s, in the norm of the error test: (γ/h − J)⁻¹ (f₀ + Σ eᵢ Zᵢ / h), with
    /// the derivative f₀ at the start. The estimate is of order h⁴ and bounded for equations of any stiffness.
    ///
    /// If it is too large in the first step or after a failure, f₀ is taken at the state moved by the estimate.
    /// Components that decay at once then have no effect on the estimate.
    fn error<R: RightHandSide<S>>(&mut self, rhs: &mut R, h: S, test: &ErrorTest) -> f64 {
        let n = self.y.len();
        let defects = |z: &[S], i: usize, weights: &[S; 3]| dot(weights, &[z[i], z[n + i], z[2 * n + i]]) / h;
        for i in 0..n {
            self.error[i] = self.slope[i] + defects(&self.z, i, &self.scheme.error);
        }
        self.newton.real.solve(&mut self.error);
        let mut norm = test.norm(&self.error, &self.y, &self.y_new) / self.leeway;
        if norm > test.tolerance && !self.goes_well {
            for ((point, y), error) in self.point.iter_mut().zip(&self.y).zip(&self.error) {
                *point = *y + *error;
            }
            self.evaluations += 1;
            let moved = &mut self.f[..n];
            if check_finite(&self.point).is_ok() && evaluate(rhs, self.t, &self.point, moved).is_ok() {
                for i in 0..n {
                    self.error[i] = self.f[i] + defects(&self.z, i, &self.scheme.error);
                }
                self.newton.real.solve(&mut self.error);
                norm = test.norm(&self.error, &self.y, &self.y_new) / self.leeway;
            }
        }
        if norm.is_nan() { f64::INFINITY } else { norm }
    }
}

/// Factor by which the error estimate of an accepted step may exceed the tolerance.
///
/// The estimate is of order h⁴, but the error at the end of a run is of order h⁵ and shall be about the tolerance.
/// Therefore ½ rtol^(4/5) replaces rtol. RADAU5 uses 0.1 rtol^(2/3), with which the ratio of error to tolerance grows
/// tenfold every six digits.
fn radau_error_allowance(tolerance: f64) -> f64 {
    0.5 * tolerance.powf(-0.2)
}

impl<S: Real> Interpolant for Radau5<S> {
    type Real = S;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[S], &[S]) {
        (&self.y, &self.y_new)
    }

    fn dense_output(&self, theta: S, mut put: impl FnMut(usize, S)) {
        let n = self.y.len();
        for (i, y) in self.y.iter().enumerate() {
            let [a, b, c] = [self.inside[i], self.inside[n + i], self.inside[2 * n + i]];
            put(i, *y + theta * (a + theta * (b + theta * c)));
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(3)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, S)) {
        let n = self.y.len();
        for (i, y) in self.y.iter().enumerate() {
            put(i, 0, *y);
            for power in 0..3 {
                put(i, power + 1, self.inside[power * n + i]);
            }
        }
    }
}

impl<S: Real> Stepper for Radau5<S> {
    fn start<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        self.t_new = t;
        self.h_before = None;
        self.goes_well = false;
        self.newton.forget_jacobian();
        self.magnitudes.fill(0.0);
        self.restart_at(rhs, t, y)
    }

    /// Continues from a state that the driver has moved. The Jacobian is kept, since its age decides when it is
    /// replaced. The polynomial of the last step is kept, too, since it only serves as a prediction.
    fn continue_from_moved_state<R: RightHandSide<S>>(&mut self, rhs: &mut R, y: &[S]) -> Result<(), StepFailure> {
        self.restart_at(rhs, self.t, y)
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<S>,
    {
        let n = self.y.len();
        let h: S = trial.exact_step_length(self.t);
        let aim = self.radau_accuracy(h, test);
        let mut solved = self.solve_radau_stages(rhs, trial, h, &aim);
        if solved.is_err() && self.newton.is_old() {
            self.newton.forget_jacobian();
            solved = self.solve_radau_stages(rhs, trial, h, &aim);
        }
        if solved.is_err() {
            self.goes_well = false;
        }
        solved?;
        self.t_new = trial.t_new;
        for i in 0..n {
            self.y_new[i] = self.y[i] + self.z[2 * n + i];
            let at = [self.z[i], self.z[n + i], self.z[2 * n + i]];
            for (power, row) in self.scheme.powers.iter().enumerate() {
                self.inside[power * n + i] = dot(row, &at);
            }
        }
        check_finite(&self.y_new)?;
        let Some(test) = test else {
            // This derivative only affects the sizes of later changes.
            self.slope_new.copy_from_slice(&self.f[2 * n..]);
            return Ok(0.0);
        };
        let error = self.error(rhs, h, test);
        self.goes_well = error <= test.tolerance;
        if self.goes_well {
            self.evaluations += 1;
            evaluate(rhs, trial.t_new, &self.y_new, &mut self.slope_new)?;
        }
        Ok(error)
    }

    /// Factor of RADAU5 on the size of the next step. It falls with the number of Newton iterations that the step took.
    fn next_step_margin(&self) -> f64 {
        let (most, taken) = (f64::from(2 * ITERATIONS), f64::from(self.newton.taken));
        ((1.0 + most) / (taken + most)).min(1.0)
    }

    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize> {
        test.component_of_largest_weighted_error(self.error.iter().copied(), &self.y, &self.y_new)
    }

    fn accept(&mut self) {
        self.h_before = Some(S::from_f64(self.t_new) - S::from_f64(self.t));
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        std::mem::swap(&mut self.inside, &mut self.before);
        std::mem::swap(&mut self.slope, &mut self.slope_new);
        self.newton.age_jacobian();
        for (magnitude, y) in self.magnitudes.iter_mut().zip(&self.y) {
            *magnitude = magnitude.max(y.to_f64().abs());
        }
    }

    fn slope(&self) -> &[S] {
        &self.slope
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn jacobians(&self) -> u64 {
        self.newton.jacobians
    }
}

impl<S: Real> Radau5<S> {
    /// Sets the method to the state `y` at time `t`, s, and evaluates the derivative there. Error if the derivative has
    /// no finite value.
    fn restart_at<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        self.t = t;
        self.y.copy_from_slice(y);
        self.y_new.copy_from_slice(y);
        for (magnitude, y) in self.magnitudes.iter_mut().zip(y) {
            *magnitude = magnitude.max(y.to_f64().abs());
        }
        self.evaluations += 1;
        evaluate(rhs, t, y, &mut self.slope)
    }
}
