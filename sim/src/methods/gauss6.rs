//! Gauss–Legendre collocation with three stages, the method `gauss6`: order 6, implicit, symplectic.
//!
//! The polynomial u of degree 3 with u(t) = y satisfies the equations at three points inside the step, the zeros of
//! Legendre's polynomial. The new state is u(t + h), and u is also the dense output, of order 3 only. Quadratic
//! invariants are conserved to rounding. With equal steps, the energy of a mechanical system stays within a band. E.
//! Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), §II.1, §IV.2, §VIII.6.
//!
//! The unknowns are the derivatives k₁, k₂, k₃ at the three points. They are found by Newton's method with the Jacobian
//! at the start of the step. It does not stop at a tolerance, but when rounding lets the changes shrink no further: a
//! remaining error would act like a force and let the invariants drift. For the same reason the rounding error of a sum
//! y + h Σ b k is added in the next step (compensated summation).

use tripos_traits::{Real, largest};

use crate::dense_output::Interpolant;
use crate::error::Failure;
use crate::error_test::ErrorTest;
use crate::linear::lu::Lu;
use crate::right_hand_side::RightHandSide;
use crate::stepper::{StepFailure, Stepper, TrialStep, check_finite, evaluate};

/// Number of iterations of Newton's method after which a step is given up. Each iteration gains several digits unless
/// the step is too long.
const ITERATIONS: u32 = 30;

/// Coefficients of Gauss's method with three stages: the nodes ½ − s, ½, ½ + s with s = √15 / 10, and
/// the matrix A.
struct Nodes<S> {
    /// Distance s = √15 / 10 of the outer nodes from the middle of the step, as a fraction of the step.
    s: S,
    /// Nodes of Gauss's method: times of the three stages, as fractions of the step.
    c: [S; 3],
    /// Matrix A of the method: aᵢⱼ is the weight of stage j at node i.
    a: [[S; 3]; 3],
}

impl<S: Real> Nodes<S> {
    /// Computes the coefficients of Gauss's method in the scalar `S`.
    fn new() -> Self {
        let root = S::int(15).sqrt();
        let (half, s) = (S::ratio(1, 2), root / S::int(10));
        let (side, middle) = (S::ratio(5, 36), S::ratio(2, 9));
        let over = |n: i64| root / S::int(n);
        Self {
            s,
            c: [half - s, half, half + s],
            a: [
                [side, middle - over(15), side - over(30)],
                [side + over(24), middle, side - over(24)],
                [side + over(30), middle + over(15), side],
            ],
        }
    }
}

/// Derivative u' of a component inside a step, as a polynomial: `middle` + 2 `first` τ + 3 `second` τ².
/// τ is the fraction of the step, counted from its middle.
struct GaussSlope<S> {
    /// Value of the derivative u' in the middle of the step.
    middle: S,
    /// Half of the coefficient of τ in the derivative polynomial u'. τ is the fraction of the step, counted from its
    /// middle.
    first: S,
    /// Third of the coefficient of τ² in the derivative polynomial u'. τ is the fraction of the step, counted from its
    /// middle.
    second: S,
}

impl<S: Real> GaussSlope<S> {
    /// Creates the derivative polynomial through the values k₁, k₂, k₃ at the nodes. `s` is the distance of the outer
    /// nodes from the middle, as a fraction of the step.
    fn slope_through_nodes(s: S, [k1, k2, k3]: [S; 3]) -> Self {
        let first = (k3 - k1) / (S::int(4) * s);
        let second = ((k1 - k2) + (k3 - k2)) / (S::int(6) * s * s);
        Self { middle: k2, first, second }
    }

    /// Value of the derivative u' at the fraction `theta` of the step.
    fn at(&self, theta: S) -> S {
        let tau = theta - S::ratio(1, 2);
        self.middle + tau * (S::int(2) * self.first + S::int(3) * self.second * tau)
    }

    /// Increment (u − y) / h of a component up to the fraction `theta` of the step: the integral of u' from the start
    /// of the step.
    fn integral(&self, theta: S) -> S {
        let tau = theta - S::ratio(1, 2);
        let square = tau * tau;
        theta * self.middle + (square - S::ratio(1, 4)) * self.first + (square * tau + S::ratio(1, 8)) * self.second
    }

    /// Coefficients of θ, θ² and θ³ in the increment (u − y) / h of a component. θ is the fraction of the step.
    fn powers(&self) -> [S; 3] {
        let half = S::ratio(3, 2) * self.second;
        [self.middle - self.first + S::ratio(3, 4) * self.second, self.first - half, self.second]
    }
}

/// Gauss's method in a run: the current step with its stages, error and dense output.
pub(crate) struct Gauss6<S> {
    /// Coefficients of Gauss's method with three stages.
    nodes: Nodes<S>,
    /// Time at the start of the step, s.
    t: f64,
    /// Time at the end of the step, s.
    t_new: f64,
    /// State at the start of the step.
    y: Vec<S>,
    /// State at the end of the step.
    y_new: Vec<S>,
    /// Rounding errors of the sums that gave `y`, which are added in the next sum (compensated summation).
    carry: Vec<S>,
    /// Rounding errors of the sums that gave `y_new`, for the sums of the next step (compensated
    /// summation).
    carry_new: Vec<S>,
    /// Derivatives at the three nodes, 3n entries: all components of the first node, then of the second and
    /// third.
    k: Vec<S>,
    /// Derivatives at the three nodes of the previous step, 3n entries.
    k_before: Vec<S>,
    /// Signed length of the previous step, s; `None` if the current step is the first.
    h_before: Option<S>,
    /// Derivative f at the start of the step.
    slope: Vec<S>,
    /// Derivative f at the end of the step, which is computed only if there is an error test.
    slope_new: Vec<S>,
    /// Jacobian ∂f/∂y at (t, y), n² entries row by row; valid if `has_jacobian` is true.
    jacobian: Vec<S>,
    /// True if `jacobian` was evaluated at the start of the current step.
    has_jacobian: bool,
    /// Factors of Newton's matrix I − h A ⊗ ∂f/∂y, of order 3n.
    newton: Lu<S>,
    /// Residuals f − k of the three stages, 3n entries; after the solution, the changes of k.
    residual: Vec<S>,
    /// State at which a stage is evaluated; after an attempt, the error estimate of order 5.
    point: Vec<S>,
    /// Largest absolute value of each component so far, by which rounding is measured.
    magnitudes: Vec<f64>,
    /// Scale of each component, by which Newton's changes are divided before they are compared.
    scales: Vec<f64>,
    /// Number of calls of the right-hand side so far.
    evaluations: u64,
    /// Number of evaluations of the Jacobian so far.
    jacobians: u64,
}

impl<S: Real> Gauss6<S> {
    /// Creates the method for a state of `n` components.
    pub(crate) fn new(n: usize) -> Self {
        let zeros = |n: usize| vec![S::from_f64(0.0); n];
        Self {
            nodes: Nodes::new(),
            t: 0.0,
            t_new: 0.0,
            y: zeros(n),
            y_new: zeros(n),
            carry: zeros(n),
            carry_new: zeros(n),
            k: zeros(3 * n),
            k_before: zeros(3 * n),
            h_before: None,
            slope: zeros(n),
            slope_new: zeros(n),
            jacobian: zeros(n * n),
            has_jacobian: false,
            newton: Lu::new(3 * n),
            residual: zeros(3 * n),
            point: zeros(n),
            magnitudes: vec![0.0; n],
            scales: vec![0.0; n],
            evaluations: 0,
            jacobians: 0,
        }
    }

    /// Derivative polynomial u' of component `i` inside a step, from the derivatives `k` at the nodes.
    fn slope_of_component(&self, k: &[S], i: usize) -> GaussSlope<S> {
        let n = self.y.len();
        GaussSlope::slope_through_nodes(self.nodes.s, [k[i], k[n + i], k[2 * n + i]])
    }

    /// Sets the initial values of the derivatives k for Newton's method, for a step of `h` s. They continue the
    /// polynomial of the previous step.
    ///
    /// The initial values are f at the start of the step if there is no previous step, or if the step is more than
    /// twice as long.
    fn predict_gauss_stages(&mut self, h: S) {
        let n = self.y.len();
        let ratio = self.h_before.map(|before| h / before).filter(|r| r.to_f64() <= 2.0);
        for i in 0..n {
            let before = self.slope_of_component(&self.k_before, i);
            for (node, c) in self.nodes.c.into_iter().enumerate() {
                self.k[node * n + i] = ratio.map_or(self.slope[i], |r| before.at(S::int(1) + c * r));
            }
        }
    }

    /// Evaluates the Jacobian if it is not known, and factors Newton's matrix I − h A ⊗ ∂f/∂y for a step of `h` s.
    /// Error if the Jacobian has no finite value or the matrix is singular.
    fn prepare_newton<R: RightHandSide<S>>(&mut self, rhs: &mut R, h: S) -> Result<(), StepFailure> {
        let n = self.y.len();
        if !self.has_jacobian {
            self.jacobians += 1;
            match rhs.jacobian(self.t, &self.y, &mut self.jacobian) {
                Some(outcome) => outcome.map_err(StepFailure::Failed)?,
                None => return Err(no_jacobian()),
            }
            let odd = self.jacobian.iter().position(|x| !x.to_f64().is_finite());
            if let Some(entry) = odd {
                return Err(StepFailure::NotFinite { component: entry / n });
            }
            self.has_jacobian = true;
        }
        let (zero, one) = (S::int(0), S::int(1));
        for (row, entries) in self.newton.entries.chunks_exact_mut((3 * n).max(1)).enumerate() {
            let (stage, i) = (row / n, row % n);
            for (column, entry) in entries.iter_mut().enumerate() {
                let unit = if row == column { one } else { zero };
                *entry = unit - h * self.nodes.a[stage][column / n] * self.jacobian[i * n + column % n];
            }
        }
        if self.newton.factor() { Ok(()) } else { Err(StepFailure::NotConverged { iterations: 0 }) }
    }

    /// Solves k_i = f(t + c_i h, y + h Σ_j a_ij k_j) for the derivatives k at the nodes by Newton's method.
    /// Error if it does not converge or f has no value.
    fn iterate_gauss_stages<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        trial: TrialStep,
        h: S,
    ) -> Result<(), StepFailure> {
        self.set_scales(h);
        let mut last = f64::INFINITY;
        for iteration in 1..=ITERATIONS {
            for stage in 0..3 {
                self.stage(rhs, stage, trial, h)?;
            }
            self.newton.solve(&mut self.residual);
            for (k, change) in self.k.iter_mut().zip(&self.residual) {
                *k = *k + *change;
            }
            let scales = self.scales.iter().cycle();
            let sizes = self.residual.iter().zip(scales).map(|(d, scale)| (h * *d).to_f64().abs() / scale);
            let change = largest(sizes);
            // A change that no longer shrinks is a rounding error if it is small, and divergence otherwise.
            let at_rounding = change == 0.0 || (change >= last && last <= S::EPSILON.sqrt());
            if at_rounding {
                return Ok(());
            }
            if change.is_nan() || change > 2.0 * last {
                return Err(StepFailure::NotConverged { iterations: iteration });
            }
            last = last.min(change);
        }
        if last <= S::EPSILON.sqrt() { Ok(()) } else { Err(StepFailure::NotConverged { iterations: ITERATIONS }) }
    }

    /// Computes the residual f − k of a stage of the step. Error if a number is not finite or f has no
    /// value.
    fn stage<R: RightHandSide<S>>(
        &mut self,
        rhs: &mut R,
        stage: usize,
        trial: TrialStep,
        h: S,
    ) -> Result<(), StepFailure> {
        let n = self.y.len();
        let [a1, a2, a3] = self.nodes.a[stage];
        for i in 0..n {
            let sum = a1 * self.k[i] + a2 * self.k[n + i] + a3 * self.k[2 * n + i];
            self.point[i] = self.y[i] + (self.carry[i] + h * sum);
        }
        check_finite(&self.point)?;
        let t = self.t + self.nodes.c[stage].to_f64() * trial.h;
        let f = &mut self.residual[stage * n..(stage + 1) * n];
        self.evaluations += 1;
        evaluate(rhs, t, &self.point, f)?;
        for (f, k) in f.iter_mut().zip(&self.k[stage * n..]) {
            *f = *f - *k;
        }
        Ok(())
    }

    /// Sets the scale of each component, by which Newton's changes are divided. It is the component's largest absolute
    /// value so far, or its change in the step of `h` s if that is larger.
    ///
    /// A component that has always been zero has the largest scale of all components.
    fn set_scales(&mut self, h: S) {
        let middle = &self.k[self.y.len()..];
        for ((scale, magnitude), k) in self.scales.iter_mut().zip(&self.magnitudes).zip(middle) {
            *scale = magnitude.max((h * *k).to_f64().abs());
        }
        let most = largest(self.scales.iter().copied());
        let rest = if most > 0.0 { most } else { 1.0 };
        for scale in self.scales.iter_mut().filter(|scale| **scale == 0.0) {
            *scale = rest;
        }
    }

    /// Writes the state y + h (5 k₁ + 8 k₂ + 5 k₃) / 18 at the end of the step to `y_new`, and the rounding
    /// errors of this sum to `carry_new`.
    fn gauss_new_state(&mut self, h: S) {
        let n = self.y.len();
        for i in 0..n {
            let sum = S::int(5) * (self.k[i] + self.k[2 * n + i]) + S::int(8) * self.k[n + i];
            let add = self.carry[i] + h * sum / S::int(18);
            let new = self.y[i] + add;
            let added = new - self.y[i];
            self.carry_new[i] = (self.y[i] - (new - added)) + (add - added);
            self.y_new[i] = new;
        }
    }

    /// Estimates the error of the step of `h` s, in the norm of the error test, from the defects f − u' at its ends.
    /// Collocation does not satisfy the equations there.
    ///
    /// A defect d is of order h³, so that e₄ = h d₀ / 20 is of order h⁴ (¹⁄₂₀ is c₁ c₂ c₃, the weight of the third
    /// divided difference in it). Two vectors are of order h⁵: h (d₀ + d₁) / 20, whose leading terms cancel, and h² J
    /// d₀ / 20. The first vanishes for linear equations, since the defect is then a multiple of Legendre's polynomial.
    /// The second misses terms that depend on the time alone. The sum of their absolute values is e₅. It is combined
    /// with e₄ as in DOP853: e₅² / √(e₅² + 0.01 e₄²), of order h⁶, while the method's own error is of order h⁷.
    fn gauss_error(&mut self, h: S, test: &ErrorTest) -> f64 {
        let n = self.y.len();
        let (zero, one, factor) = (S::int(0), S::int(1), h * S::ratio(1, 20));
        let mut defects = std::mem::take(&mut self.residual);
        for i in 0..n {
            let inside = self.slope_of_component(&self.k, i);
            defects[i] = factor * (self.slope[i] - inside.at(zero));
            defects[n + i] = factor * (self.slope_new[i] - inside.at(one));
        }
        let (start, end) = defects.split_at(n);
        let fourth = test.norm(start, &self.y, &self.y_new);
        for (i, row) in self.jacobian.chunks_exact(n.max(1)).enumerate() {
            let linear = row.iter().zip(start).fold(zero, |sum, (j, d)| sum + *j * *d);
            self.point[i] = (start[i] + end[i]).abs() + (h * linear).abs();
        }
        self.residual = defects;
        let fifth = test.norm(&self.point, &self.y, &self.y_new);
        let both = (fifth * fifth + 0.01 * fourth * fourth).sqrt();
        let error = if both > 0.0 { fifth * (fifth / both) } else { 0.0 };
        if error.is_nan() { f64::INFINITY } else { error }
    }
}

/// Creates the error of a step whose right-hand side provides no Jacobian.
fn no_jacobian() -> StepFailure {
    let message = "the right-hand side has no Jacobian here".to_owned();
    StepFailure::Failed(Failure { code: "no-jacobian", message })
}

impl<S: Real> Interpolant for Gauss6<S> {
    type Real = S;

    fn span(&self) -> (f64, f64) {
        (self.t, self.t_new)
    }

    fn ends(&self) -> (&[S], &[S]) {
        (&self.y, &self.y_new)
    }

    fn dense_output(&self, theta: S, mut put: impl FnMut(usize, S)) {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        for (i, y) in self.y.iter().enumerate() {
            put(i, *y + h * self.slope_of_component(&self.k, i).integral(theta));
        }
    }

    fn degree_of_dense_output(&self) -> Option<usize> {
        Some(3)
    }

    fn coefficients(&self, mut put: impl FnMut(usize, usize, S)) {
        let h = S::from_f64(self.t_new) - S::from_f64(self.t);
        for (i, y) in self.y.iter().enumerate() {
            put(i, 0, *y);
            for (power, value) in self.slope_of_component(&self.k, i).powers().into_iter().enumerate() {
                put(i, power + 1, h * value);
            }
        }
    }
}

impl<S: Real> Stepper for Gauss6<S> {
    fn start<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<(), StepFailure> {
        (self.t, self.t_new) = (t, t);
        self.y.copy_from_slice(y);
        self.y_new.copy_from_slice(y);
        self.carry.fill(S::from_f64(0.0));
        for (magnitude, y) in self.magnitudes.iter_mut().zip(y) {
            *magnitude = y.to_f64().abs();
        }
        self.evaluations += 1;
        evaluate(rhs, t, y, &mut self.slope)
    }

    fn attempt<R>(&mut self, rhs: &mut R, trial: TrialStep, test: Option<&ErrorTest>) -> Result<f64, StepFailure>
    where
        R: RightHandSide<S>,
    {
        let h: S = trial.exact_step_length(self.t);
        self.prepare_newton(rhs, h)?;
        self.predict_gauss_stages(h);
        self.iterate_gauss_stages(rhs, trial, h)?;
        self.gauss_new_state(h);
        self.t_new = trial.t_new;
        check_finite(&self.y_new)?;
        let Some(test) = test else { return Ok(0.0) };
        self.evaluations += 1;
        evaluate(rhs, trial.t_new, &self.y_new, &mut self.slope_new)?;
        Ok(self.gauss_error(h, test))
    }

    fn component_of_largest_error(&self, test: &ErrorTest) -> Option<usize> {
        // `point` still holds the error estimate of the last attempt.
        test.component_of_largest_weighted_error(self.point.iter().copied(), &self.y, &self.y_new)
    }

    fn accept(&mut self) {
        self.h_before = Some(S::from_f64(self.t_new) - S::from_f64(self.t));
        self.t = self.t_new;
        std::mem::swap(&mut self.y, &mut self.y_new);
        std::mem::swap(&mut self.carry, &mut self.carry_new);
        std::mem::swap(&mut self.k, &mut self.k_before);
        std::mem::swap(&mut self.slope, &mut self.slope_new);
        self.has_jacobian = false;
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
        self.jacobians
    }
}
