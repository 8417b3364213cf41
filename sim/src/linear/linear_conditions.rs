//! Linear conditions in a metric: the smallest vector that satisfies them, the part of another vector that they leave
//! free, and the conditions that depend on other conditions.
//!
//! A metric M = L Lᵀ turns x into z = Lᵀ x, whose Euclidean length is the length of x in the metric. The rows G of
//! conditions G x = d become the columns of L⁻¹ Gᵀ. The method of Gram and Schmidt finds orthonormal axes for them. It
//! takes the rows in the order of their relative remainders, the largest first (P. Businger & G. H. Golub, Numer. Math.
//! 7 (1965) 269–276). The units of rows therefore do not matter. The remainder of a row measures its distance from
//! depending on the rows taken before it.
//!
//! Conditions are created once and set again for each state, without an allocation. Vectors lie in a single list, one
//! after another.

use super::metric::Metric;
use super::vector_arithmetic::{axpy, dot, normalize_vector};

/// Relative remainder of a row, after projection on the rows taken before it, up to which the row counts as dependent.
pub(crate) const DEPENDENT: f64 = 1e-8;

/// Linear conditions G x = d in a metric, with orthonormal axes for their rows.
#[derive(Clone)]
pub(crate) struct LinearConditions {
    /// Number of components of each condition's row.
    length: usize,
    /// Rows G of the conditions in the metric M = L Lᵀ: each is multiplied by L⁻¹.
    forms: Vec<f64>,
    /// Remainder of each row of `forms`: the row without its components along the axes found so far.
    rest: Vec<f64>,
    /// Orthonormal axes, one vector for each condition that is kept as independent.
    axes: Vec<f64>,
    /// Indices of the independent rows, in the order in which they were taken.
    kept: Vec<usize>,
    /// Indices of the rows that are not kept as independent.
    open: Vec<usize>,
    /// Components of each kept row along the axes up to its own axis: lists of 1, 2, 3 … numbers in the order of
    /// `kept`.
    along: Vec<f64>,
    /// Working space for the components of a vector along the axes of the conditions.
    shares: Vec<f64>,
    /// Length of each condition's row in the metric.
    pub(crate) sizes: Vec<f64>,
    /// Length of each row's remainder, without its components along the rows that were taken before it.
    pub(crate) left: Vec<f64>,
}

impl LinearConditions {
    /// Creates an empty set of conditions.
    pub(crate) const fn new() -> Self {
        Self {
            length: 0,
            forms: Vec::new(),
            rest: Vec::new(),
            axes: Vec::new(),
            kept: Vec::new(),
            open: Vec::new(),
            along: Vec::new(),
            shares: Vec::new(),
            sizes: Vec::new(),
            left: Vec::new(),
        }
    }

    /// Sets the conditions to these rows, which lie one after another, in a metric. A row counts as dependent and is
    /// left out if the length of its remainder, after projection on the rows before it, is at most `dependent` times
    /// its length.
    pub(crate) fn set(&mut self, metric: &Metric, rows: &[f64], dependent: f64) {
        self.length = metric.length.max(1);
        self.forms.clear();
        self.forms.extend_from_slice(rows);
        self.sizes.clear();
        for form in self.forms.chunks_exact_mut(self.length) {
            metric.form_in_metric(form);
            self.sizes.push(dot(form, form).sqrt());
        }
        self.rest.clone_from(&self.forms);
        self.left.clone_from(&self.sizes);
        self.open.clear();
        self.open.extend(0..self.sizes.len());
        for list in [&mut self.axes, &mut self.along] {
            list.clear();
        }
        self.kept.clear();
        while let Some(place) = self.most_independent_row(dependent) {
            self.keep_row(place);
        }
    }

    /// Position in `open` of the row with the largest relative remainder; `None` if no relative remainder is above
    /// `dependent`.
    fn most_independent_row(&self, dependent: f64) -> Option<usize> {
        // A row of zeros is no condition.
        let part = |row: usize| if self.sizes[row] > 0.0 { self.left[row] / self.sizes[row] } else { 0.0 };
        let parts = self.open.iter().enumerate().map(|(place, row)| (place, part(*row)));
        parts.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, most)| *most > dependent).map(|(place, _)| place)
    }

    /// Keeps the row at this position in `open`: makes an axis from its remainder, and removes this axis from the
    /// remainders of the other open rows.
    fn keep_row(&mut self, place: usize) {
        let (n, row) = (self.length, self.open.remove(place));
        let known = self.axes.len();
        self.axes.extend_from_slice(&self.rest[row * n..(row + 1) * n]);
        let (before, axis) = self.axes.split_at_mut(known);
        // The projection is repeated to remove rounding errors.
        for other in before.chunks_exact(n) {
            axpy(-dot(other, axis), other, axis);
        }
        normalize_vector(axis);
        for other in &self.open {
            let rest = &mut self.rest[other * n..(other + 1) * n];
            axpy(-dot(axis, rest), axis, rest);
            self.left[*other] = dot(rest, rest).sqrt();
        }
        let form = &self.forms[row * n..(row + 1) * n];
        self.along.extend(self.axes.chunks_exact(n).map(|axis| dot(axis, form)));
        self.kept.push(row);
    }

    /// True if no row of the conditions depends on the other rows.
    pub(crate) fn is_independent(&self) -> bool {
        self.kept.len() == self.sizes.len()
    }

    /// Adds to `z` the shortest vector that satisfies the kept conditions. `sides` has the right-hand side
    /// of each condition, kept or not. Vectors are in the coordinates z = Lᵀ x.
    pub(crate) fn add_least_vector(&mut self, sides: &[f64], z: &mut [f64]) {
        self.shares.clear();
        let mut along = self.along.as_slice();
        for row in &self.kept {
            let count = self.shares.len();
            let (own, next) = along.split_at(count + 1);
            self.shares.push((sides[*row] - dot(&own[..count], &self.shares)) / own[count]);
            along = next;
        }
        for (axis, share) in self.axes.chunks_exact(self.length).zip(&self.shares) {
            axpy(*share, axis, z);
        }
    }

    /// Removes from `z` its part along the axes of all kept conditions. The conditions do not restrict the
    /// remaining `z`.
    pub(crate) fn remove_conditioned_part(&self, z: &mut [f64]) {
        for axis in self.axes.chunks_exact(self.length) {
            axpy(-dot(axis, z), axis, z);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_inertia(matrix: &[f64], rows: &[f64]) -> Option<Metric> {
        let mut metric = Metric::new();
        metric.set_inertia(matrix, 3, rows).then_some(metric)
    }

    fn conditions(metric: &Metric, rows: &[f64]) -> LinearConditions {
        let mut conditions = LinearConditions::new();
        conditions.set(metric, rows, DEPENDENT);
        conditions
    }

    /// Smallest vector x that satisfies the conditions with the right-hand sides `sides`.
    fn least(metric: &Metric, conditions: &mut LinearConditions, sides: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; 3];
        conditions.add_least_vector(sides, &mut x);
        metric.vector_from_metric(&mut x);
        x
    }

    /// True if two vectors have the same length and differ by less than `most` in every entry.
    fn near(a: &[f64], b: &[f64], most: f64) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < most)
    }

    /// Truth: of all corrections x with G x = d, the one with the smallest xᵀ M x is M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ d.
    #[test]
    fn the_least_correction_is_that_of_the_multipliers() {
        let m = [4.0, 1.0, 0.0, 1.0, 3.0, -1.0, 0.0, -1.0, 2.0];
        let g = [1.0, 2.0, 0.5, 0.0, 1.0, -1.0];
        let metric = of_inertia(&m, &g).unwrap();
        let mut conditions = conditions(&metric, &g);
        let d = [0.3, -0.7];
        let found = least(&metric, &mut conditions, &d);
        let truth = by_multipliers(&m, &g, d);
        assert!(conditions.is_independent() && near(&found, &truth, 1e-15), "{found:?} {truth:?}");
    }

    /// Computes M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ d with explicit inverses.
    fn by_multipliers(m: &[f64], g: &[f64], d: [f64; 2]) -> Vec<f64> {
        use nalgebra::{DMatrix, DVector};
        let (m, g) = (DMatrix::from_row_slice(3, 3, m), DMatrix::from_row_slice(2, 3, g));
        let inverse = m.try_inverse().unwrap();
        let compliance = (&g * &inverse * g.transpose()).try_inverse().unwrap();
        let x = &inverse * g.transpose() * compliance * DVector::from_row_slice(&d);
        x.iter().copied().collect()
    }

    /// A third row that is a combination of the two others, in another unit, changes nothing. Conditions that are set
    /// again keep nothing from the earlier setting.
    #[test]
    fn a_row_that_follows_from_others_is_left_out() {
        let g = [1.0, 2.0, 0.5, 0.0, 1.0, -1.0, 1e6, 1e6, 1.5e6];
        let mut metric = Metric::new();
        metric.set_weights([1.0, 2.0, 0.5].into_iter());
        let (mut all, mut two) = (conditions(&metric, &g), conditions(&metric, &g));
        two.set(&metric, &g[..6], DEPENDENT);
        assert!(!all.is_independent() && all.left.iter().any(|left| *left < 1e-8) && two.is_independent());
        let of_all = least(&metric, &mut all, &[0.3, -0.7, 1e6]);
        assert!(near(&of_all, &least(&metric, &mut two, &[0.3, -0.7]), 1e-14));
        let (mut z, mut other) = ([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        all.remove_conditioned_part(&mut z);
        two.remove_conditioned_part(&mut other);
        assert!(near(&z, &other, 1e-14) && dot(&z, &z) > 0.1, "{z:?} {other:?}");
    }

    /// A zero mass is allowed along a motion that a row prevents, and refused along a free motion.
    #[test]
    fn a_massless_link_is_held_by_its_row() {
        let m = [2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        let held = [1.0, 0.0, -1.0];
        let metric = of_inertia(&m, &held).unwrap();
        let x = least(&metric, &mut conditions(&metric, &held), &[1.0]);
        // The massless link makes the whole correction, since no inertia resists it.
        assert!((x[0] - x[2] - 1.0).abs() < 1e-14 && x[0].abs() < 1e-14 && !metric.is_plain(), "{x:?}");
        assert!(of_inertia(&m, &[1.0, 0.0, 0.0]).is_none());
    }
}
