//! Solver for the smallest vector that satisfies linear conditions in a metric.

use super::linear_conditions::{DEPENDENT, LinearConditions};
use super::metric::Metric;

/// Solver for the smallest vector that satisfies linear conditions, in the metric of a mass matrix or
/// of weights.
#[derive(Clone)]
pub(crate) struct LeastVectorSolver {
    /// Metric that defines the length of the wanted vector.
    pub(crate) metric: Metric,
    /// Linear conditions that the wanted vector satisfies.
    pub(crate) conditions: LinearConditions,
}

impl LeastVectorSolver {
    /// Creates a solver for the smallest vector; its metric and conditions are not set yet.
    pub(crate) const fn new() -> Self {
        Self { metric: Metric::new(), conditions: LinearConditions::new() }
    }

    /// Sets the conditions, and the metric of the mass matrix `inertia`, which has `length` × `length` entries, row by
    /// row. Each condition is a row of `rows` with `length` entries. Returns false if the matrix is not positive
    /// definite on the vectors that the rows leave free.
    pub(crate) fn set(&mut self, inertia: &[f64], length: usize, rows: &[f64]) -> bool {
        let is_definite = self.metric.set_inertia(inertia, length, rows);
        if is_definite {
            self.conditions.set(&self.metric, rows, DEPENDENT);
        }
        is_definite
    }

    /// Sets the conditions, and the metric of a mass matrix to which inertia is added along their rows. The measure of
    /// dependence among rows then means the same at all states.
    ///
    /// `inertia` has `length` × `length` entries, and `rows` has `length` entries for each condition. Returns false if
    /// the matrix is not positive definite on the vectors that the rows leave free.
    pub(crate) fn set_heavier(&mut self, inertia: &[f64], length: usize, rows: &[f64]) -> bool {
        let is_definite = self.metric.set_inertia_with_added_mass(inertia, length, rows);
        if is_definite {
            self.conditions.set(&self.metric, rows, DEPENDENT);
        }
        is_definite
    }

    /// Writes the smallest vector that satisfies the conditions to `out`. `sides` has the right-hand side
    /// of each condition.
    pub(crate) fn least_vector(&mut self, sides: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.conditions.add_least_vector(sides, out);
        self.metric.vector_from_metric(out);
    }
}
