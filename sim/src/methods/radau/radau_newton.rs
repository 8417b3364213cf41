//! Newton's method for the stages of a Radau step, with the same Jacobian for all three stages and for several steps.
//!
//! Invariant: `factored` is the step size for which the matrices are factored; a new Jacobian invalidates the factors.
//! The unknowns of the iteration are the transformed differences W = (T⁻¹ ⊗ I) Z. For them the 3n equations separate,
//! with the matrices γ/h − J for ΔW₁ and (α + iβ)/h − J for ΔW₂ + i ΔW₃. Hairer & Wanner II, §IV.8.

use tripos_traits::Real;

use super::complex::Complex;
use super::radau_coefficients::{Scheme, dot};
use crate::error::Failure;
use crate::linear::lu::Lu;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, check_finite};

/// Largest relative difference of two step sizes that use the same factors. The sizes of equal steps differ by the
/// rounding of t.
const SAME_SIZE: f64 = 1e-9;
/// Ratio of successive Newton changes below which the Jacobian is kept for the next step.
const FAST: f64 = 1e-3;
/// Ratio of successive Newton changes above which the iteration is given up.
const SLOW: f64 = 0.99;

/// Age of the Jacobian: unknown, evaluated at an earlier point, or at the current point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Age {
    /// No Jacobian is known.
    None,
    /// The Jacobian was evaluated at an earlier point.
    Old,
    /// The Jacobian was evaluated at the start of the current step.
    Here,
}

/// Accuracy to which Newton's method solves the equations of a step.
pub(super) struct NewtonAccuracy {
    /// Largest remaining error with which the equations count as solved, divided by the weights.
    pub(super) enough: f64,
    /// Size below which a change that no longer shrinks counts as rounding, divided by the weights.
    pub(super) rounding: f64,
    /// Number of Newton iterations after which a step is given up.
    pub(super) iterations: u32,
}

/// Newton's method for a Radau step: the matrices, and the speed of convergence.
pub(super) struct Newton<S> {
    /// Number of components of the state.
    n: usize,
    /// Jacobian ∂f/∂y, n² entries row by row.
    jacobian: Vec<S>,
    /// Age of the Jacobian: unknown, of an earlier point, or of the current point.
    age: Age,
    /// Signed step size, s, for which the matrices are factored; `None` if they are not.
    factored: Option<S>,
    /// LU factors of the real matrix γ/h − J of Newton's method, of order n, with the Jacobian J.
    pub(super) real: Lu<S>,
    /// LU factors of the complex matrix (α + iβ)/h − J of Newton's method, of order n, with the Jacobian J.
    complex: Lu<Complex<S>>,
    /// Right-hand side of the real linear system; after its solution, the change of W₁.
    first: Vec<S>,
    /// Right-hand side of the complex linear system; after its solution, the change of W₂ + i W₃.
    pair: Vec<Complex<S>>,
    /// Weight of each component, by which its errors and changes are divided.
    pub(super) weights: Vec<f64>,
    /// Ratio θ/(1 − θ) of the remaining error to the last change. θ is the factor by which changes shrink.
    left: f64,
    /// Factor θ by which changes shrank in the last iteration; 0 if a single iteration was enough.
    rate: f64,
    /// Number of Newton iterations that the last step took.
    pub(super) taken: u32,
    /// Number of evaluations of the Jacobian so far.
    pub(super) jacobians: u64,
}

/// Vectors of the three stages of a step. Each vector has 3n entries, one stage after the other.
pub(super) struct StageVectors<'a, S> {
    /// Differences Z between the stages and the state at the start of the step.
    pub(super) z: &'a mut [S],
    /// Transformed stage differences W = (T⁻¹ ⊗ I) Z, in which the equations of a Radau step separate.
    pub(super) w: &'a mut [S],
    /// Derivatives f at the three stages of the step.
    pub(super) f: &'a mut [S],
}

/// Function `(Z, f)` that writes the derivatives f at the three stages y + Z, 3n entries. Error if f
/// has no finite value.
type Stages<'a, S> = &'a mut dyn FnMut(&[S], &mut [S]) -> Result<(), StepFailure>;

impl<S: Real> Newton<S> {
    /// Creates Newton's method for a state of `n` components, without a Jacobian.
    pub(super) fn new(n: usize) -> Self {
        let zero = S::int(0);
        Self {
            n,
            jacobian: vec![zero; n * n],
            age: Age::None,
            factored: None,
            real: Lu::new(n),
            complex: Lu::new(n),
            first: vec![zero; n],
            pair: vec![Complex { re: zero, im: zero }; n],
            weights: vec![1.0; n],
            left: 1.0,
            rate: 0.0,
            taken: 0,
            jacobians: 0,
        }
    }

    /// True if the Jacobian was evaluated at an earlier point, so that a new Jacobian might help Newton's method.
    pub(super) fn is_old(&self) -> bool {
        self.age == Age::Old
    }

    /// Marks the Jacobian as unknown, so that the next step evaluates it.
    pub(super) fn forget_jacobian(&mut self) {
        self.age = Age::None;
        self.left = 1.0;
    }

    /// Marks the end of an accepted step. The Jacobian is kept for the next step if Newton's method
    /// converged fast with it.
    pub(super) fn age_jacobian(&mut self) {
        self.age = if self.rate <= FAST { Age::Old } else { Age::None };
    }

    /// Evaluates the Jacobian, if needed, and factors the matrices for a step of `h` s from (t, y). Error
    /// if the Jacobian has no finite value or a matrix is singular.
    pub(super) fn prepare_newton_matrices<R>(
        &mut self,
        rhs: &mut R,
        t: f64,
        y: &[S],
        scheme: &Scheme<S>,
        h: S,
    ) -> Result<(), StepFailure>
    where
        R: RightHandSide<S>,
    {
        if self.age == Age::None {
            self.evaluate_jacobian(rhs, t, y)?;
        }
        if self.factored.is_some_and(|size| (h / size - S::int(1)).to_f64().abs() <= SAME_SIZE) {
            return Ok(());
        }
        self.factored = None;
        let (real, pair) = (scheme.real / h, Complex { re: scheme.pair.re / h, im: scheme.pair.im / h });
        let zero = S::int(0);
        let entries = self.real.entries.iter_mut().zip(&mut self.complex.entries).zip(&self.jacobian);
        for (at, ((one, both), slope)) in entries.enumerate() {
            let diagonal = at % (self.n + 1) == 0;
            *one = if diagonal { real - *slope } else { -*slope };
            *both = Complex { re: -*slope, im: zero };
            if diagonal {
                *both = *both + pair;
            }
        }
        if !(self.real.factor() && self.complex.factor()) {
            return Err(StepFailure::NotConverged { iterations: 0 });
        }
        self.factored = Some(h);
        Ok(())
    }

    /// Evaluates the Jacobian at (t, y). Error if it has no finite value.
    fn evaluate_jacobian<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        self.jacobians += 1;
        self.factored = None;
        match rhs.jacobian(t, y, &mut self.jacobian) {
            Some(outcome) => outcome.map_err(StepFailure::Failed)?,
            None => {
                let message = "the right-hand side has no Jacobian here".to_owned();
                return Err(StepFailure::Failed(Failure { code: "no-jacobian", message }));
            }
        }
        check_finite(&self.jacobian).map_err(|trouble| match trouble {
            StepFailure::NotFinite { component: entry } => StepFailure::NotFinite { component: entry / self.n },
            other => other,
        })?;
        self.age = Age::Here;
        Ok(())
    }

    /// Solves Z = h (A ⊗ I) f(y + Z) for Z by Newton's method, from the given initial values, to the accuracy `aim`.
    /// `stages` writes f at the stages. Error if the method does not converge or f has no value.
    pub(super) fn solve(
        &mut self,
        scheme: &Scheme<S>,
        h: S,
        vectors: StageVectors<'_, S>,
        aim: &NewtonAccuracy,
        mut stages: impl FnMut(&[S], &mut [S]) -> Result<(), StepFailure>,
    ) -> Result<(), StepFailure> {
        let StageVectors { z, w, f } = vectors;
        self.iterate_newton(scheme, h, StageVectors { z, w, f }, aim, &mut stages)?;
        if S::SLOPES == 0 {
            return Ok(());
        }
        // The derivatives that the numbers carry have converged only as far as the values had before the last
        // iteration. They need another iteration.
        let known = w.to_vec();
        stages(z, f)?;
        self.newton_correction(scheme, h, w, f);
        for (now, known) in w.iter_mut().zip(known) {
            *now = (0..S::SLOPES).fold(known, |w, along| w.turned(along, now.slope(along) - known.slope(along)));
        }
        transform_stages(&scheme.t, self.n, w, z);
        Ok(())
    }

    /// Iterates Newton's method for Z until the accuracy `aim` is reached. Error if it does not converge or
    /// f has no value.
    fn iterate_newton(
        &mut self,
        scheme: &Scheme<S>,
        h: S,
        vectors: StageVectors<'_, S>,
        aim: &NewtonAccuracy,
        stages: Stages<'_, S>,
    ) -> Result<(), StepFailure> {
        let StageVectors { z, w, f } = vectors;
        transform_stages(&scheme.t_inverse, self.n, z, w);
        // At the rate of convergence of earlier steps, the first change may already be small enough.
        self.left = self.left.max(f64::EPSILON).powf(0.8);
        self.rate = 0.0;
        let (mut last, mut ratio) = (f64::INFINITY, 0.0_f64);
        for iteration in 1..=aim.iterations {
            self.taken = iteration;
            let failed = Err(StepFailure::NotConverged { iterations: iteration });
            stages(z, f)?;
            let change = self.newton_correction(scheme, h, w, f);
            if change.is_nan() {
                return failed;
            }
            transform_stages(&scheme.t, self.n, w, z);
            if iteration > 1 && change > 0.0 {
                let now = change / last;
                self.rate = if iteration == 2 { now } else { (now * ratio).sqrt() };
                ratio = now;
                let is_rounding = now > 0.5 && last <= aim.rounding;
                if is_rounding {
                    return Ok(());
                }
                if self.rate >= SLOW {
                    return failed;
                }
                self.left = self.rate / (1.0 - self.rate);
                let more = i32::try_from(aim.iterations - iteration).unwrap_or(i32::MAX);
                if self.left * change * self.rate.powi(more) > aim.enough.max(aim.rounding) {
                    return failed;
                }
            }
            if self.left * change <= aim.enough {
                return Ok(());
            }
            last = change;
        }
        if last <= aim.rounding { Ok(()) } else { Err(StepFailure::NotConverged { iterations: aim.iterations }) }
    }

    /// Changes W by a Newton iteration, and returns the size of the change: the root of the mean square of the changes
    /// divided by the weights.
    ///
    /// The change ΔW solves (h⁻¹ Λ ⊗ I − I ⊗ J) ΔW = (T⁻¹ ⊗ I) F − (h⁻¹ Λ ⊗ I) W. F are the derivatives f at the three
    /// stages, and Λ = T⁻¹ A⁻¹ T.
    fn newton_correction(&mut self, scheme: &Scheme<S>, h: S, w: &mut [S], f: &[S]) -> f64 {
        let n = self.n;
        let real = scheme.real / h;
        let pair = Complex { re: scheme.pair.re / h, im: scheme.pair.im / h };
        for i in 0..n {
            let at = [f[i], f[n + i], f[2 * n + i]];
            let [one, re, im] = scheme.t_inverse.each_ref().map(|row| dot(row, &at));
            self.first[i] = one - real * w[i];
            self.pair[i] = Complex { re, im } - pair * Complex { re: w[n + i], im: w[2 * n + i] };
        }
        self.real.solve(&mut self.first);
        self.complex.solve(&mut self.pair);
        let mut sum = 0.0;
        for (i, weight) in self.weights.iter().enumerate() {
            for (stage, change) in [self.first[i], self.pair[i].re, self.pair[i].im].into_iter().enumerate() {
                w[stage * n + i] = w[stage * n + i] + change;
                // A component that does not change needs no weight.
                let size = change.to_f64();
                let part = if crate::rounding::exactly_equal(size, 0.0) { 0.0 } else { size / weight };
                sum += part * part;
            }
        }
        (sum / (3 * n).max(1) as f64).sqrt()
    }
}

/// Writes (M ⊗ I) `from` to `to`, for a 3 × 3 matrix M and vectors of 3n entries.
fn transform_stages<S: Real>(matrix: &super::radau_coefficients::Matrix<S>, n: usize, from: &[S], to: &mut [S]) {
    for i in 0..n {
        let at = [from[i], from[n + i], from[2 * n + i]];
        for (row, weights) in matrix.iter().enumerate() {
            to[row * n + i] = dot(weights, &at);
        }
    }
}
