//! Corrections of a state (q, q̇) that make its constraints zero and are the smallest in the metric of a mass matrix M.
//!
//! The coordinates are corrected first, by M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ drift, with the slopes G of the constraints between
//! coordinates. The rates are corrected next, by the constraints that contain rates; the first correction has changed
//! the drift of these.
//!
//! A correction that is prepared at a state serves for any drift at that state and near it. It is created once and
//! prepared again for each state, without an allocation. If slopes and metric are the same for rates and coordinates,
//! the factors for the coordinates also serve for the rates.

use crate::linear::least_vector_solver::LeastVectorSolver;
use crate::linear::vector_arithmetic::dot;

/// Solver for corrections of a state (q, q̇) onto its constraints, with its working space.
#[derive(Clone)]
pub(crate) struct Correction {
    /// Indices of the coordinates that may be moved: all except the time.
    moved: Vec<usize>,
    /// Indices, among all constraints, of the constraints between coordinates only, without rates q̇.
    of_places: Vec<usize>,
    /// Indices, among all constraints, of the constraints that contain rates q̇.
    of_rates: Vec<usize>,
    /// Slopes of the constraints between coordinates by the movable coordinates, row by row.
    places: Vec<f64>,
    /// Slopes of the constraints that contain rates, by the rates of movable coordinates, row by row.
    rates: Vec<f64>,
    /// Slopes of the constraints that contain rates, by the movable coordinates, row by row.
    coupling: Vec<f64>,
    /// Mass matrix of the movable coordinates, row by row.
    inertia: Vec<f64>,
    /// Solver for the smallest correction of the coordinates q.
    by_places: LeastVectorSolver,
    /// Solver for the smallest correction of the rates q̇.
    by_rates: LeastVectorSolver,
    /// True if the constraints on rates have the same slopes and metric as those on coordinates. Then `by_places` also
    /// corrects the rates, and `by_rates` is not set.
    are_same: bool,
    /// Right-hand sides of the linear conditions of a correction: the drift that it must remove.
    sides: Vec<f64>,
    /// Correction of the movable coordinates.
    q: Vec<f64>,
    /// Correction of the rates of the movable coordinates.
    v: Vec<f64>,
    /// Correction of the whole state (q, q̇), 2n entries for n coordinates.
    whole: Vec<f64>,
}

impl Correction {
    /// Creates a solver for corrections that is not prepared at a state yet.
    pub(crate) const fn new() -> Self {
        Self {
            moved: Vec::new(),
            of_places: Vec::new(),
            of_rates: Vec::new(),
            places: Vec::new(),
            rates: Vec::new(),
            coupling: Vec::new(),
            inertia: Vec::new(),
            by_places: LeastVectorSolver::new(),
            by_rates: LeastVectorSolver::new(),
            are_same: false,
            sides: Vec::new(),
            q: Vec::new(),
            v: Vec::new(),
            whole: Vec::new(),
        }
    }

    /// Prepares corrections at a state with n coordinates. `inertia` is the n × n mass matrix. `gradients` has 2n
    /// entries for each constraint, row by row. The coordinate with index `clock` is the time and is never moved.
    ///
    /// Returns false if the mass matrix is not positive definite on the motions that the constraints allow.
    pub(crate) fn set(&mut self, inertia: &[f64], gradients: &[f64], n: usize, clock: Option<usize>) -> bool {
        self.moved.clear();
        self.moved.extend((0..n).filter(|i| Some(*i) != clock));
        self.sort_constraints(gradients, n);
        self.inertia.clear();
        for i in &self.moved {
            self.inertia.extend(self.moved.iter().map(|j| inertia[i * n + j]));
        }
        let length = self.moved.len();
        if !self.by_places.set(&self.inertia, length, &self.places) {
            return false;
        }
        self.are_same = self.by_places.metric.is_plain() && self.places == self.rates;
        self.are_same || self.by_rates.set(&self.inertia, length, &self.rates)
    }

    /// Separates the constraints between coordinates from those that contain rates, and copies their
    /// slopes. `gradients` has 2n entries for each constraint.
    fn sort_constraints(&mut self, gradients: &[f64], n: usize) {
        let Self { moved, of_places, of_rates, places, rates, coupling, .. } = self;
        for list in [&mut *of_places, &mut *of_rates] {
            list.clear();
        }
        for list in [&mut *places, &mut *rates, &mut *coupling] {
            list.clear();
        }
        for (k, row) in gradients.chunks_exact((2 * n).max(1)).enumerate() {
            let along_q = moved.iter().map(|i| row[*i]);
            if moved.iter().all(|i| row[n + i] == 0.0) {
                of_places.push(k);
                places.extend(along_q);
            } else {
                of_rates.push(k);
                coupling.extend(along_q);
                rates.extend(moved.iter().map(|i| row[n + i]));
            }
        }
    }

    /// Returns the correction to subtract from the state (q, q̇), with 2n entries. `drift` has the value of each
    /// constraint at that state.
    pub(crate) fn correction_of_drift(&mut self, drift: &[f64], n: usize) -> &[f64] {
        let length = self.moved.len();
        self.q.resize(length, 0.0);
        self.v.resize(length, 0.0);
        self.sides.clear();
        self.sides.extend(self.of_places.iter().map(|k| drift[*k]));
        self.by_places.least_vector(&self.sides, &mut self.q);
        self.sides.clear();
        let coupling = self.coupling.chunks_exact(length.max(1));
        self.sides.extend(self.of_rates.iter().zip(coupling).map(|(k, row)| drift[*k] - dot(row, &self.q)));
        let by_rates = if self.are_same { &mut self.by_places } else { &mut self.by_rates };
        by_rates.least_vector(&self.sides, &mut self.v);
        self.whole.clear();
        self.whole.resize(2 * n, 0.0);
        for ((i, q), v) in self.moved.iter().zip(&self.q).zip(&self.v) {
            (self.whole[*i], self.whole[n + i]) = (*q, *v);
        }
        &self.whole
    }
}
