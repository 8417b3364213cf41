//! Corrections of (q, q̇) that make constraints zero, in the metric of a mass matrix. The coordinates are corrected
//! first, by M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ drift, with the constraints between coordinates. The rates follow, with the
//! constraints of rates, whose drift the first correction has changed.
//!
//! A correction that is prepared at a state serves for any drift there and next to it. It is created once and prepared
//! again for each state, without an allocation. The factors for coordinates are used again for rates if the slopes and
//! the metric are the same.

use crate::linear::metric::{Conditions, DEPENDENT, Metric, dot};

/// Solver for the smallest vector that satisfies linear conditions, in the metric of a mass matrix.
#[derive(Clone)]
pub(crate) struct LeastVectorSolver {
    pub(crate) metric: Metric,
    pub(crate) conditions: Conditions,
}

impl LeastVectorSolver {
    /// Creates a solver without a metric and conditions.
    pub(crate) const fn new() -> Self {
        Self { metric: Metric::new(), conditions: Conditions::new() }
    }

    /// Sets the metric of a mass matrix, row by row, for vectors of this length, and the rows of the conditions. False
    /// if the matrix is not definite on the vectors that the rows leave free.
    pub(crate) fn set(&mut self, inertia: &[f64], length: usize, rows: &[f64]) -> bool {
        let is_definite = self.metric.set_inertia(inertia, length, rows);
        if is_definite {
            self.conditions.set(&self.metric, rows, DEPENDENT);
        }
        is_definite
    }

    /// Sets the metric of a mass matrix to which inertia is added along the rows, as [`Metric::set_heavier`] does. The
    /// measure of dependence among rows then means the same at all states.
    pub(crate) fn set_heavier(&mut self, inertia: &[f64], length: usize, rows: &[f64]) -> bool {
        let is_definite = self.metric.set_heavier(inertia, length, rows);
        if is_definite {
            self.conditions.set(&self.metric, rows, DEPENDENT);
        }
        is_definite
    }

    /// Writes the smallest vector that satisfies the conditions with these right-hand sides.
    pub(crate) fn write(&mut self, sides: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.conditions.add_least(sides, out);
        self.metric.lower(out);
    }
}

/// Corrections of a state (q, q̇) onto its constraints, with the working space.
#[derive(Clone)]
pub(crate) struct Correction {
    /// Indices of the coordinates that may be moved: all except the time.
    moved: Vec<usize>,
    /// Indices of the constraints between coordinates; `of_rates` has those of rates.
    of_places: Vec<usize>,
    of_rates: Vec<usize>,
    /// Slopes of the constraints between coordinates along coordinates. `rates` and `coupling` are the slopes of the
    /// constraints of rates, along rates and along coordinates.
    places: Vec<f64>,
    rates: Vec<f64>,
    coupling: Vec<f64>,
    inertia: Vec<f64>,
    by_places: LeastVectorSolver,
    by_rates: LeastVectorSolver,
    /// True if the slopes along rates equal those along coordinates, in one metric: `by_rates` is then not set.
    are_same: bool,
    sides: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    whole: Vec<f64>,
}

impl Correction {
    /// Creates a correction that is not prepared at a state yet.
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

    /// Prepares corrections at a state with this mass matrix and these gradients of constraints, 2n entries each, row
    /// by row. The coordinate with index `clock` stays. False if the mass matrix is not definite on the motions that
    /// the constraints allow.
    pub(crate) fn set(&mut self, inertia: &[f64], gradients: &[f64], n: usize, clock: Option<usize>) -> bool {
        self.moved.clear();
        self.moved.extend((0..n).filter(|i| Some(*i) != clock));
        self.sort(gradients, n);
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

    /// Separates the constraints between coordinates from those of rates, and copies their slopes.
    fn sort(&mut self, gradients: &[f64], n: usize) {
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

    /// Correction to subtract from the state, 2n entries, if the constraints have the values `drift`.
    pub(crate) fn of(&mut self, drift: &[f64], n: usize) -> &[f64] {
        let length = self.moved.len();
        self.q.resize(length, 0.0);
        self.v.resize(length, 0.0);
        self.sides.clear();
        self.sides.extend(self.of_places.iter().map(|k| drift[*k]));
        self.by_places.write(&self.sides, &mut self.q);
        self.sides.clear();
        let coupling = self.coupling.chunks_exact(length.max(1));
        self.sides.extend(self.of_rates.iter().zip(coupling).map(|(k, row)| drift[*k] - dot(row, &self.q)));
        let by_rates = if self.are_same { &mut self.by_places } else { &mut self.by_rates };
        by_rates.write(&self.sides, &mut self.v);
        self.whole.clear();
        self.whole.resize(2 * n, 0.0);
        for ((i, q), v) in self.moved.iter().zip(&self.q).zip(&self.v) {
            (self.whole[*i], self.whole[n + i]) = (*q, *v);
        }
        &self.whole
    }
}
