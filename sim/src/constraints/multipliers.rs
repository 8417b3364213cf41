//! Equations of motion in all rates with the multipliers λ of their constraints: E q̈ − Aᵀλ = f and A q̈ = γ. They are
//! solved at each state for any rank of A.
//!
//! With the mass matrix E = L Lᵀ and z = Lᵀ q̈, the forces alone would give z = L⁻¹ f. In the motion, the part of z
//! along the columns of L⁻¹ Aᵀ is replaced by the one that the constraints require (F. E. Udwadia & R. E. Kalaba,
//! *Analytical Dynamics* (1996), §3.3).
//!
//! No independent speeds are chosen, so that no choice can fail. Rows of A that depend on other rows, everywhere or in
//! a singular pose, are left out. In a singular pose the motion continues by its inertia; no number that vanishes there
//! is a divisor.
//!
//! Accelerations are those at the nearest state on the constraints, in the metric of E. Stages of a step are off the
//! constraints by errors of low order, and near a singular pose these would be divided by a vanishing number. On the
//! constraints the accelerations of a regular motion are bounded up to the singular pose itself, so that steps can lead
//! across it.

use tripos_traits::{Lengths, System};

use super::nearest_state::NearestState;
use crate::error::Failure;
use crate::linear::least_vector_solver::LeastVectorSolver;
use crate::linear::singular_value::least_singular_value;
use crate::linear::vector_arithmetic::dot;
use crate::right_hand_side::RightHandSide;

/// Distance from dependent constraints below which no step may end, as a fraction of the largest distance in the run.
/// The distance is [`DistancesFromSingularity::constraints`].
const AVOIDED: f64 = 0.003;
/// Absolute value of a coordinate below which neighbouring poses treat it as zero, in its unit.
const SMALL: f64 = 1e-3;

/// Right-hand side y' = (q̇, q̈) of equations of motion in all rates, with multipliers for their
/// constraints. The state is y = (q, q̇).
#[derive(Clone)]
pub struct Multipliers<'a> {
    /// System that provides the mass matrix, the forcing and the constraints.
    system: &'a dyn System<f64>,
    /// Parameters of the system, in the order of the model file.
    parameters: Vec<f64>,
    /// Matrix of the linear system for accelerations and multipliers, row by row.
    matrix: Vec<f64>,
    /// Right-hand side of the linear system for accelerations and multipliers: f, then γ of A q̈ = γ.
    forcing: Vec<f64>,
    /// Smallest [`DistancesFromSingularity::constraints`] at which accelerations were computed.
    nearest: f64,
    /// Largest [`DistancesFromSingularity::constraints`] at which accelerations were computed.
    farthest: f64,
    /// Largest length so far of each row of the constraint matrix A, in the metric of the mass matrix E.
    sizes: Vec<f64>,
    /// Solver for the state on the constraints that is nearest to a given state.
    placement: NearestState,
    /// Mass matrix E of the rates q̇, row by row.
    inertia: Vec<f64>,
    /// Matrix A of the constraints A q̈ = γ on the accelerations, row by row.
    rows: Vec<f64>,
    /// Solver for the constraints A q̈ = γ in the metric of the mass matrix E.
    least: LeastVectorSolver,
    /// Matrix J of the generalized speeds u = J q̇ + d, row by row, multiplied by L⁻ᵀ, where E = L Lᵀ.
    forms: Vec<f64>,
    /// Largest length of each row of J so far, in the metric of E; empty before the first use.
    longest: Vec<f64>,
    /// Generalized speeds u at a pose if all rates q̇ are 0.
    rest: Vec<f64>,
    /// Generalized speeds u at a pose if a single rate q̇ᵢ is 1 and the other rates are 0.
    along: Vec<f64>,
    /// Rates q̇ that are all 0, an entry for each coordinate; an argument for computing J.
    still: Vec<f64>,
}

/// Distances of a state from two kinds of singularity: failing generalized speeds, and dependent constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistancesFromSingularity {
    /// Smallest singular value of the matrix J of the generalized speeds, on the motions that the constraints allow. It
    /// is between 0, where the speeds fail, and 1. Each row of J is first divided by its largest length so far.
    pub speeds: f64,
    /// Smallest relative length of the independent part of a constraint's row. The independent part does not depend on
    /// the other rows; its length is divided by the largest length of that row so far. 0 in a singular pose, where rows
    /// vanish or depend on one another.
    pub constraints: f64,
}

impl<'a> Multipliers<'a> {
    /// Creates the right-hand side from a system, with parameters in the order of the model file. `clock`
    /// is the index of the coordinate that is the time; `None` if no coordinate is.
    ///
    /// `None` if the unknowns of the system are not all rates with multipliers, or if the number of
    /// parameters is wrong.
    #[must_use]
    pub fn new(system: &'a dyn System<f64>, parameters: &[f64], clock: Option<usize>) -> Option<Self> {
        let Lengths { coordinates, variables, reactions, speeds, .. } = system.lengths();
        let fits = parameters.len() == system.lengths().parameters && variables == coordinates && reactions > 0;
        let order = coordinates + reactions;
        fits.then(|| Self {
            system,
            parameters: parameters.to_vec(),
            matrix: vec![0.0; order * order],
            forcing: vec![0.0; order],
            nearest: 1.0,
            farthest: 0.0,
            sizes: vec![0.0; reactions],
            placement: NearestState::new(system, clock),
            inertia: Vec::new(),
            rows: Vec::new(),
            least: LeastVectorSolver::new(),
            forms: Vec::new(),
            longest: Vec::new(),
            rest: vec![0.0; speeds],
            along: vec![0.0; speeds],
            still: vec![0.0; coordinates],
        })
    }

    /// Copies these equations for another run. The copy keeps the largest lengths of rows and the largest
    /// distance from singular poses so far. Its smallest distance starts anew.
    #[must_use]
    pub fn copy_for_another_run(&self) -> Self {
        Self { nearest: 1.0, ..self.clone() }
    }

    /// Computes [`DistancesFromSingularity::constraints`] from the conditions in `least`, and updates its
    /// smallest and largest value so far.
    fn distance_from_dependence(&mut self) -> f64 {
        let conditions = &self.least.conditions;
        for (most, size) in self.sizes.iter_mut().zip(&conditions.sizes) {
            *most = most.max(*size);
        }
        let least = conditions.left.iter().zip(&self.sizes).map(|(left, size)| left / size).fold(1.0, f64::min);
        (self.nearest, self.farthest) = (self.nearest.min(least), self.farthest.max(least));
        least
    }

    /// Smallest [`DistancesFromSingularity::constraints`] of all states so far, from 0 (a singular pose) to 1.
    #[must_use]
    pub fn least_distance_from_dependence(&self) -> f64 {
        self.nearest
    }

    /// Sets the solver `least` to the conditions A in the metric of E, both taken from `matrix`. Returns false if a
    /// motion that the conditions allow has no inertia.
    fn set_least(&mut self) -> bool {
        let (n, order) = (self.still.len(), self.forcing.len());
        for list in [&mut self.inertia, &mut self.rows] {
            list.clear();
        }
        for (i, row) in self.matrix.chunks_exact(order).enumerate() {
            if i < n { &mut self.inertia } else { &mut self.rows }.extend_from_slice(&row[..n]);
        }
        self.least.set_heavier(&self.inertia, n, &self.rows)
    }

    /// Solves the linear system in `matrix` and `forcing`, and writes the accelerations q̈ to `out`. Error
    /// if an entry is not finite, or if a motion that the constraints allow has no inertia.
    fn accelerations(&mut self, out: &mut [f64]) -> Result<(), Failure> {
        if !self.matrix.iter().chain(&self.forcing).all(|x| x.is_finite()) {
            let message = "an entry of the equations with multipliers is not finite".to_owned();
            return Err(Failure { code: "not-finite", message });
        }
        if !self.set_least() {
            let message = "something that the constraints let move has no inertia".to_owned();
            return Err(Failure { code: "singular", message });
        }
        self.distance_from_dependence();
        let (forces, sides) = self.forcing.split_at(out.len());
        out.copy_from_slice(forces);
        let LeastVectorSolver { metric, conditions } = &mut self.least;
        metric.form_in_metric(out);
        conditions.remove_conditioned_part(out);
        conditions.add_least_vector(sides, out);
        metric.vector_from_metric(out);
        Ok(())
    }

    /// Computes the distances of the state y = (q, q̇) from a failure of the model's generalized speeds and
    /// from dependent constraints. `None` if the equations have no value there.
    pub fn distances_from_singularity(&mut self, y: &[f64]) -> Option<DistancesFromSingularity> {
        let n = self.still.len();
        let (q, v) = y.split_at(n);
        self.system.mass_matrix(&self.parameters, q, v, &mut self.matrix);
        if !self.matrix.iter().all(|x| x.is_finite()) || !self.set_least() {
            return None;
        }
        if self.longest.is_empty() {
            self.record_speed_rows_at_neighbours(q);
        }
        self.speed_rows_in_metric(q);
        for (form, size) in self.forms.chunks_exact_mut(n).zip(&self.longest) {
            for x in form.iter_mut() {
                *x /= size;
            }
            self.least.conditions.remove_conditioned_part(form);
        }
        let speeds = if self.forms.is_empty() { 1.0 } else { least_singular_value(&mut self.forms, n) };
        speeds.is_finite().then(|| DistancesFromSingularity { speeds, constraints: self.distance_from_dependence() })
    }

    /// Records the lengths of the rows of J at poses near `q`. At `q` itself a row may vanish, as in a dead point.
    ///
    /// In each of these poses a single coordinate is increased by half of its value. A coordinate near zero is
    /// increased by one half of its unit.
    fn record_speed_rows_at_neighbours(&mut self, q: &[f64]) {
        self.longest = vec![0.0; self.rest.len()];
        let mut beside = q.to_vec();
        for (at, place) in q.iter().enumerate() {
            beside[at] = place + 0.5 * if place.abs() > SMALL { place.abs() } else { 1.0 };
            self.speed_rows_in_metric(&beside);
            beside[at] = *place;
        }
    }

    /// Computes the matrix J of the generalized speeds at pose `q` in the metric of E, and updates the
    /// largest lengths of its rows.
    fn speed_rows_in_metric(&mut self, q: &[f64]) {
        self.speed_rows(q);
        for (form, longest) in self.forms.chunks_exact_mut(q.len().max(1)).zip(&mut self.longest) {
            self.least.metric.form_in_metric(form);
            let length = dot(form, form).sqrt();
            // A length that is not finite is ignored.
            *longest = if length.is_finite() { longest.max(length) } else { *longest };
        }
    }

    /// Computes the matrix J of the generalized speeds u = J q̇ + d at pose `q`, row by row. Differences
    /// along each rate are exact, since u is linear in q̇.
    fn speed_rows(&mut self, q: &[f64]) {
        let (n, p) = (q.len(), self.rest.len());
        let (system, parameters) = (self.system, self.parameters.as_slice());
        self.forms.resize(p * n, 0.0);
        system.generalized_speeds(parameters, q, &self.still, &mut self.rest);
        for i in 0..n {
            self.still[i] = 1.0;
            system.generalized_speeds(parameters, q, &self.still, &mut self.along);
            self.still[i] = 0.0;
            for (row, (u, rest)) in self.along.iter().zip(&self.rest).enumerate() {
                self.forms[row * n + i] = u - rest;
            }
        }
    }
}

impl RightHandSide<f64> for Multipliers<'_> {
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        let (n, p) = (self.still.len(), self.parameters.as_slice());
        let (q_dot, v_dot) = dydt.split_at_mut(n);
        let (q, v) = self.placement.nearest_state(self.system, p, y).split_at(n);
        self.system.coordinate_rates(p, q, v, q_dot);
        self.system.linear_system(p, q, v, &mut self.matrix, &mut self.forcing);
        self.accelerations(v_dot)
    }

    fn constraint_count(&self) -> usize {
        self.system.constraint_count()
    }

    fn constraints(&mut self, _t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        crate::right_hand_side::system_constraints(self.system, &self.parameters, y, values, slopes);
    }

    /// True if the state is near a singular pose, where rounding errors are divided by the square of a
    /// vanishing number.
    fn avoids_end_of_step(&mut self, _t: f64, y: &[f64]) -> bool {
        self.distances_from_singularity(y).is_some_and(|standing| standing.constraints < AVOIDED * self.farthest)
    }

    fn inertia(&mut self, _t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        crate::right_hand_side::system_inertia(self.system, &self.parameters, y, &mut self.matrix, out)
    }
}
