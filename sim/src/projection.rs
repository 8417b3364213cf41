//! Projection of the states of a run onto its invariants or its constraints, with a report of the corrections.
//!
//! After each accepted step the state is moved onto I_k(y) = I_k(y₀), or onto the constraints φ_k(y) = 0 of the
//! equations, by the smallest correction in the norm of the tolerances. The method continues from the corrected state.
//! The removed drift is added up with its sign, so that a projected run shows the drift of the method. E. Hairer, C.
//! Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd edition (2006), §IV.4.
//!
//! If the state is (q, q̇) and its mass matrix M is known, corrections onto constraints are the smallest in the metric
//! of M. First q is moved by M⁻¹ Gᵀ times multipliers, with G = ∂φ/∂q. Then q̇ is moved in the same way. The correction
//! of q̇ does no work on the motions that the constraints allow. Constraints that depend on others, everywhere or in a
//! singular pose, are left out.
//!
//! Events, and output at and inside a step, belong to the step before the correction at its end. Samples of a run with
//! constraints are moved onto the constraints one by one. The last state, and all later steps, follow from the
//! corrected state.

use tripos_traits::Real;

use crate::constraints::correction::Correction;
use crate::error_test::ErrorTest;
use crate::linear::least_vector_solver::LeastVectorSolver;
use crate::linear::linear_conditions::DEPENDENT;
use crate::linear::vector_arithmetic::dot;
use crate::methods::run_options::Options;
use crate::right_hand_side::RightHandSide;

/// Largest number of Newton iterations for a correction that has not become as small as rounding.
const ITERATIONS: u32 = 3;
/// Largest number of Newton iterations once corrections are as small as the rounding of the largest component of the
/// state. If that component is an angle of many turns, other components must then take over its part of the correction.
const SETTLING: u32 = 8;
/// Size below which a correction of the state counts as rounding, in units in the last place of the largest component.
const ROUNDING: f64 = 16.0;
/// Fraction of the drift that may remain after the last Newton iteration. Each iteration squares the relative drift.
const LEFT: f64 = 1e-3;

/// Function `(t, y, values, gradients)` that writes m invariants I_k(y) and their m × n gradients
/// ∂I_k/∂y, row by row. The time t is in s.
pub type InvariantFunction<'a, S> = Box<dyn FnMut(f64, &[S], &mut [S], &mut [S]) + 'a>;

/// Invariants of a motion, such as its energy, that a projected run keeps at their values at the start.
pub struct Invariants<'a, S = f64> {
    /// Number m of invariants that the function computes.
    pub count: usize,
    /// Function that writes the `count` values of the invariants, each in its unit, and their `count` × n
    /// gradients by the state.
    pub function: InvariantFunction<'a, S>,
}

impl<S> std::fmt::Debug for Invariants<'_, S> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Invariants").field("count", &self.count).finish_non_exhaustive()
    }
}

/// Report on the projection in a run: its corrections, and the drift that they removed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectionReport {
    /// Number of steps after which the state was moved onto the invariants or constraints.
    pub corrections: u64,
    /// Number of steps without a correction because the gradients are dependent, zero or not finite.
    pub singular: u64,
    /// Number of steps without a correction because Newton's method did not reach the invariants or
    /// constraints. The gradients are wrong, or the step was far too long.
    pub not_converged: u64,
    /// Sum Σ |correction| over all steps, for each component of the state, in its unit.
    pub moved: Vec<f64>,
    /// Signed sum of the drift that corrections removed, Σ (value before − value after), for each invariant or
    /// constraint.
    pub removed: Vec<f64>,
    /// Largest drift that a single correction removed, with its sign, for each invariant or constraint.
    pub largest: Vec<f64>,
}

impl ProjectionReport {
    /// Adds the report `next` of the run that continues the run of this report.
    pub fn add(&mut self, next: &Self) {
        self.corrections += next.corrections;
        self.singular += next.singular;
        self.not_converged += next.not_converged;
        for (sum, more) in self.moved.iter_mut().zip(&next.moved).chain(self.removed.iter_mut().zip(&next.removed)) {
            *sum += more;
        }
        for (largest, drift) in self.largest.iter_mut().zip(&next.largest).filter(|(a, b)| b.abs() > a.abs()) {
            *largest = *drift;
        }
    }
}

/// Set onto which the states of a run are moved: level sets of invariants, or constraints.
pub(crate) enum ProjectionTarget<'p, 'a, S> {
    /// Invariants, which are kept at their values at the start of the run.
    Invariants(&'p mut Invariants<'a, S>),
    /// Constraints of the equations, which are kept at zero. The field is their number.
    Constraints(usize),
}

/// Projection of the states of a run onto invariants or constraints, with its working space and its
/// report so far.
pub(crate) struct Projector<'p, 'a, S> {
    /// Invariants or constraints onto which states are moved.
    onto: ProjectionTarget<'p, 'a, S>,
    /// Error test whose weights define the norm of a correction; `None` if the tolerances are invalid, and
    /// all weights are 1.
    weights: Option<ErrorTest>,
    /// Target value of each invariant or constraint: the value at the start, or 0.
    wanted: Vec<S>,
    /// Value of each invariant or constraint at the state `y`.
    values: Vec<S>,
    /// Gradients of the invariants or constraints by the state at `y`, m × n entries, row by row.
    gradients: Vec<S>,
    /// Difference `values` − `wanted` of each invariant or constraint.
    drift: Vec<f64>,
    /// Drift of each invariant or constraint before the last correction.
    before: Vec<f64>,
    /// State that is being moved onto the invariants or constraints.
    y: Vec<S>,
    /// True if the drift is as small as the rounding of the state's components would make it.
    is_near: bool,
    /// Mass matrix at the state, row by row; empty if the equations provide none.
    inertia: Vec<f64>,
    /// Gradients of the invariants or constraints, rounded to `f64`, m × n entries, row by row.
    slopes: Vec<f64>,
    /// Right-hand sides of the linear conditions that a correction satisfies: the deviation of each invariant or
    /// constraint from its target.
    open: Vec<f64>,
    /// Correction that is subtracted from the state, n entries.
    correction: Vec<f64>,
    /// Solver for the correction of (q, q̇) that is the smallest in the metric of the mass matrix.
    in_rates: Correction,
    /// Solver for the correction that is the smallest in the norm of the tolerances.
    in_weights: LeastVectorSolver,
    /// Index of the component of the state that is the time, which no correction moves; `None` if there is
    /// none.
    clock: Option<usize>,
    /// Report on the corrections made so far.
    pub(crate) report: ProjectionReport,
}

/// Class of the size of a correction of the state, from the smallest to the largest.
#[derive(PartialEq, PartialOrd)]
enum CorrectionSize {
    /// The correction is no larger than the rounding errors with which the constraints are computed.
    Constraint,
    /// The correction is no larger than the rounding of the largest component of the state.
    State,
    /// The correction is larger than rounding.
    Further,
}

/// Reason why the state cannot be moved onto the invariants or constraints.
enum ProjectionFailure {
    /// The gradients are dependent, zero or not finite.
    Singular,
    /// Newton's method did not reach the invariants or constraints.
    NotConverged,
}

impl<'p, 'a, S: Real> Projector<'p, 'a, S> {
    /// Creates a projection onto invariants at their values at the start (t0, y0), or onto constraints.
    pub(crate) fn new<R: RightHandSide<S>>(
        onto: ProjectionTarget<'p, 'a, S>,
        rhs: &mut R,
        options: &Options,
        t0: f64,
        y0: &[S],
    ) -> Self {
        let count = match &onto {
            ProjectionTarget::Invariants(invariants) => invariants.count,
            ProjectionTarget::Constraints(count) => *count,
        };
        let (m, n) = (count, y0.len());
        let zeros = |n: usize| vec![S::from_f64(0.0); n];
        // A run with fixed steps may have invalid tolerances: all components then have the weight 1.
        let weights = ErrorTest::new::<S>(
            crate::methods::method_rules::method_norm(options.method),
            options.rtol,
            &options.atol,
            n,
        )
        .ok()
        .map(|(test, _)| test);
        let mut projector = Self {
            onto,
            weights,
            wanted: zeros(m),
            values: zeros(m),
            gradients: zeros(m * n),
            drift: vec![0.0; m],
            before: vec![0.0; m],
            y: y0.to_vec(),
            is_near: true,
            inertia: Vec::new(),
            slopes: Vec::new(),
            open: Vec::new(),
            correction: vec![0.0; n],
            in_rates: Correction::new(),
            in_weights: LeastVectorSolver::new(),
            clock: options.clock,
            report: ProjectionReport {
                moved: vec![0.0; n],
                removed: vec![0.0; m],
                largest: vec![0.0; m],
                ..ProjectionReport::default()
            },
        };
        if matches!(projector.onto, ProjectionTarget::Invariants(_)) {
            projector.measure_drift(rhs, t0);
            projector.wanted.clone_from(&projector.values);
        }
        projector
    }

    /// Moves the state `y` at time `t`, s, onto the invariants or constraints, and returns the moved state. `None` if
    /// the state already lies on them up to rounding, or if it cannot be moved; the report counts failed attempts.
    pub(crate) fn project<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Option<&[S]> {
        match self.project_copy(rhs, t, y) {
            Ok(true) => {
                self.report_correction(y);
                return Some(&self.y);
            }
            Ok(false) => (),
            Err(ProjectionFailure::Singular) => self.report.singular += 1,
            Err(ProjectionFailure::NotConverged) => self.report.not_converged += 1,
        }
        None
    }

    /// Returns the state of a sample for the output. In a run with constraints it is moved onto them if possible. In a
    /// run with invariants it is not moved, so that their drift is visible.
    pub(crate) fn sample<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: Vec<S>) -> Vec<S> {
        let is_placed =
            matches!(self.onto, ProjectionTarget::Constraints(_)) && matches!(self.project_copy(rhs, t, &y), Ok(true));
        if is_placed { self.y.clone() } else { y }
    }

    /// Moves a copy of the state `y` onto the invariants or constraints, and stores it in `self.y`. Returns false if
    /// `y` already lies on them up to rounding.
    fn project_copy<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, y: &[S]) -> Result<bool, ProjectionFailure> {
        self.y.copy_from_slice(y);
        if self.values.is_empty() || self.measure_drift(rhs, t) {
            return Ok(false);
        }
        self.before.clone_from(&self.drift);
        self.iterate(rhs, t)?;
        self.project_slopes(rhs, t)?;
        Ok(true)
    }

    /// Corrects the derivatives that the numbers of the moved state carry, if its scalar has any. The constraints then
    /// have the derivative zero along each direction, and the change is the smallest possible.
    fn project_slopes<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> Result<(), ProjectionFailure> {
        for along in 0..S::SLOPES {
            self.open.clear();
            self.open.extend(self.values.iter().zip(&self.wanted).map(|(x, to)| (*x - *to).slope(along)));
            self.correct(rhs, t)?;
            for (y, correction) in self.y.iter_mut().zip(&self.correction) {
                *y = y.turned(along, -correction);
            }
        }
        Ok(())
    }

    /// Derivatives of the weighted sum `weights` · y of the last moved state by the drift of each constraint. Entry k
    /// is the product of `weights` with the correction for a drift of 1 in constraint k alone. This is the transpose of
    /// [`Self::project_slopes`]. NaN if no correction exists.
    pub(crate) fn project_weights<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64, weights: &[f64]) -> Vec<f64> {
        let count = self.values.len();
        let mut share = |k: usize| {
            self.open.clear();
            self.open.extend((0..count).map(|other| f64::from(u8::from(other == k))));
            match self.correct(rhs, t) {
                Ok(()) => dot(&self.correction, weights),
                Err(_) => f64::NAN,
            }
        };
        (0..count).map(&mut share).collect()
    }

    /// Computes the values, the gradients and the drift of the invariants or constraints at `self.y`. Returns true if
    /// the drift is only rounding.
    ///
    /// The rounding error of a constraint is that of its value, not that of its arguments. The sine of an angle of a
    /// thousand turns is as exact as that of a small angle, and the other coordinates can satisfy the constraint.
    fn measure_drift<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> bool {
        match &mut self.onto {
            ProjectionTarget::Invariants(invariants) => {
                (invariants.function)(t, &self.y, &mut self.values, &mut self.gradients);
            }
            ProjectionTarget::Constraints(_) => rhs.constraints(t, &self.y, &mut self.values, &mut self.gradients),
        }
        let reach = self.largest_size_for_rounding();
        self.is_near = true;
        let mut rounding = true;
        for (k, row) in self.gradients.chunks_exact(self.y.len().max(1)).enumerate() {
            self.drift[k] = (self.values[k] - self.wanted[k]).to_f64();
            let (mut full, mut least) = (self.wanted[k].to_f64().abs(), self.wanted[k].to_f64().abs());
            for (g, y) in row.iter().zip(&self.y) {
                full += (g.to_f64() * y.to_f64()).abs();
                least += g.to_f64().abs() * y.to_f64().abs().min(reach);
            }
            rounding &= self.drift[k].abs() <= 2.0 * S::EPSILON * least;
            self.is_near &= self.drift[k].abs() <= 2.0 * S::EPSILON * full;
        }
        rounding
    }

    /// Largest absolute value with which a component of the state counts in rounding errors: 1 for constraints,
    /// infinite for invariants.
    fn largest_size_for_rounding(&self) -> f64 {
        if matches!(self.onto, ProjectionTarget::Constraints(_)) { 1.0 } else { f64::INFINITY }
    }

    /// Moves `self.y` by Newton's method until the drift is only rounding. Error if there is no correction, or if too
    /// much drift remains.
    fn iterate<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> Result<(), ProjectionFailure> {
        let mut is_settled = false;
        for iteration in 0..SETTLING {
            if iteration >= ITERATIONS && !is_settled {
                break;
            }
            let moved = self.step(rhs, t)?;
            if self.measure_drift(rhs, t) || moved <= CorrectionSize::Constraint {
                return Ok(());
            }
            is_settled |= moved <= CorrectionSize::State;
        }
        let near = self.drift.iter().zip(&self.before).all(|(now, before)| now.abs() <= LEFT * before.abs());
        if near || is_settled || self.is_near { Ok(()) } else { Err(ProjectionFailure::NotConverged) }
    }

    /// Computes the smallest correction that removes the deviations `open` of the invariants or constraints, to first
    /// order. Error if the gradients are singular.
    fn correct<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> Result<(), ProjectionFailure> {
        let n = self.y.len();
        self.slopes.clear();
        self.slopes.extend(self.gradients.iter().map(|g| g.to_f64()));
        if !self.slopes.iter().chain(&self.open).all(|x| x.is_finite()) {
            return Err(ProjectionFailure::Singular);
        }
        if !matches!(self.onto, ProjectionTarget::Constraints(_)) || !rhs.inertia(t, &self.y, &mut self.inertia) {
            return self.correct_in_weights();
        }
        if !self.in_rates.set(&self.inertia, &self.slopes, n / 2, self.clock) {
            return Err(ProjectionFailure::Singular);
        }
        self.correction.copy_from_slice(self.in_rates.correction_of_drift(&self.open, n / 2));
        Ok(())
    }

    /// Takes a step of Newton's method from `self.y`, and returns the size class of its correction.
    fn step<R: RightHandSide<S>>(&mut self, rhs: &mut R, t: f64) -> Result<CorrectionSize, ProjectionFailure> {
        self.open.clone_from(&self.drift);
        self.correct(rhs, t)?;
        let largest = |reach: f64| self.y.iter().fold(0.0, |most: f64, y| most.max(y.to_f64().abs().min(reach)));
        let rounding =
            [self.largest_size_for_rounding(), f64::INFINITY].map(|reach| ROUNDING * S::EPSILON * largest(reach));
        let most = self.correction.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (y, correction) in self.y.iter_mut().zip(&self.correction) {
            *y = *y - S::from_f64(*correction);
        }
        Ok(match rounding {
            [constraint, _] if most <= constraint => CorrectionSize::Constraint,
            [_, state] if most <= state => CorrectionSize::State,
            _ => CorrectionSize::Further,
        })
    }

    /// Computes the correction W² Gᵀ (G W² Gᵀ)⁻¹ `open`, with gradients G and the weights W of the
    /// tolerances. Error if gradients of invariants are dependent.
    fn correct_in_weights(&mut self) -> Result<(), ProjectionFailure> {
        let (reach, y, weights) = (self.largest_size_for_rounding(), &self.y, &self.weights);
        let size = |y: &S| y.to_f64().abs().min(reach);
        let weight = |(i, y)| weights.as_ref().map_or(1.0, |test| test.weight(i, size(y)));
        let LeastVectorSolver { metric, conditions } = &mut self.in_weights;
        metric.set_weights(y.iter().enumerate().map(weight));
        conditions.set(metric, &self.slopes, DEPENDENT);
        let may_depend = matches!(self.onto, ProjectionTarget::Constraints(_));
        if !may_depend && !conditions.is_independent() {
            return Err(ProjectionFailure::Singular);
        }
        self.in_weights.least_vector(&self.open, &mut self.correction);
        Ok(())
    }

    /// Adds the correction that moved the state `y` to `self.y` to the report.
    fn report_correction(&mut self, y: &[S]) {
        self.report.corrections += 1;
        for ((moved, new), old) in self.report.moved.iter_mut().zip(&self.y).zip(y) {
            *moved += (*new - *old).to_f64().abs();
        }
        let removed = self.before.iter().zip(&self.drift).map(|(before, after)| before - after);
        for ((sum, largest), drift) in self.report.removed.iter_mut().zip(&mut self.report.largest).zip(removed) {
            *sum += drift;
            if drift.abs() > largest.abs() {
                *largest = drift;
            }
        }
    }
}
