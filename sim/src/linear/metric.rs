//! Metric by which the length of a vector is measured: weights, or a mass matrix with its Cholesky factor.
//!
//! A metric M = L Lᵀ turns x into z = Lᵀ x, whose Euclidean length is the length of x in the metric. It is created once
//! and set again for each state, without an allocation.

use super::vector_arithmetic::{axpy, dot, scale_vector_components};

/// Smallest pivot of a positive definite mass matrix in its Cholesky factorization, as a fraction of the diagonal
/// entry. A smaller pivot counts as rounding.
const CLEAR: f64 = 1e-13;

/// Kind of a metric: by weights, or by a mass matrix.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Each component of a vector is divided by its weight.
    Weights,
    /// The mass matrix defines lengths. `is_plain` is false if inertia was added to the matrix.
    Inertia { is_plain: bool },
}

/// Metric that defines the length of vectors: weights, or a mass matrix M = L Lᵀ.
#[derive(Clone)]
pub(crate) struct Metric {
    /// Kind of the metric: by weights, or by a mass matrix.
    kind: Kind,
    /// Number of components of the vectors that are measured.
    pub(super) length: usize,
    /// Weights of the components; or the Cholesky factor L, row by row, with the reciprocals of its diagonal.
    entries: Vec<f64>,
    /// Copy of the mass matrix with added inertia, row by row.
    heavier: Vec<f64>,
}

impl Metric {
    /// Creates a metric that is not set yet.
    pub(crate) const fn new() -> Self {
        Self { kind: Kind::Weights, length: 0, entries: Vec::new(), heavier: Vec::new() }
    }

    /// Sets a metric by weights: each component of a vector is divided by its weight.
    pub(crate) fn set_weights(&mut self, weights: impl Iterator<Item = f64>) {
        self.kind = Kind::Weights;
        self.entries.clear();
        self.entries.extend(weights);
        self.length = self.entries.len();
    }

    /// Sets the metric of a mass matrix, `length` × `length` entries row by row. `rows` are the rows of conditions.
    /// Returns false if a motion that the rows allow has no inertia.
    ///
    /// The matrix may be singular along motions that the rows prevent. Inertia is then added there, which changes no
    /// motion that the rows allow.
    pub(crate) fn set_inertia(&mut self, matrix: &[f64], length: usize, rows: &[f64]) -> bool {
        self.length = length;
        self.kind = Kind::Inertia { is_plain: true };
        if cholesky_factor(matrix, length, &mut self.entries) {
            return true;
        }
        self.set_inertia_with_added_mass(matrix, length, rows)
    }

    /// Sets the metric of a mass matrix, `length` × `length` entries row by row, and always adds inertia along the rows
    /// of conditions. Returns false if a motion that the rows allow has no inertia.
    ///
    /// Motions that the rows allow keep their inertia. The lengths of the rows stay bounded even if the motions that
    /// they prevent have no inertia.
    pub(crate) fn set_inertia_with_added_mass(&mut self, matrix: &[f64], length: usize, rows: &[f64]) -> bool {
        self.length = length;
        self.kind = Kind::Inertia { is_plain: false };
        self.heavier.clear();
        self.heavier.extend_from_slice(matrix);
        let scale = (0..length).fold(0.0, |most: f64, i| most.max(matrix[i * (length + 1)].abs()));
        for row in rows.chunks_exact(length.max(1)) {
            let size = dot(row, row);
            if size > 0.0 {
                for (entries, along) in self.heavier.chunks_exact_mut(length).zip(row) {
                    axpy(along * scale / size, row, entries);
                }
            }
        }
        cholesky_factor(&self.heavier, length, &mut self.entries)
    }

    /// True if no inertia was added along rows of conditions, so that the metric does not depend on them.
    pub(crate) fn is_plain(&self) -> bool {
        self.kind != Kind::Inertia { is_plain: false }
    }

    /// Multiplies a linear form, such as a force or a row of conditions, by L⁻¹ in place. The dot product of the result
    /// with z = Lᵀ x is that of the form with x.
    pub(crate) fn form_in_metric(&self, form: &mut [f64]) {
        if self.kind == Kind::Weights {
            return scale_vector_components(form, &self.entries);
        }
        for (i, row) in self.entries.chunks_exact(self.length.max(1)).enumerate() {
            form[i] = (form[i] - dot(&row[..i], &form[..i])) * row[i];
        }
    }

    /// Replaces z with x = L⁻ᵀ z in place, with the factor L of the metric M = L Lᵀ. In a metric of weights each
    /// component is multiplied by its weight.
    pub(crate) fn vector_from_metric(&self, z: &mut [f64]) {
        if self.kind == Kind::Weights {
            return scale_vector_components(z, &self.entries);
        }
        for (i, row) in self.entries.chunks_exact(self.length.max(1)).enumerate().rev() {
            z[i] *= row[i];
            let x = z[i];
            axpy(-x, &row[..i], &mut z[..i]);
        }
    }
}

/// Computes the Cholesky factor L of a matrix, row by row, with the reciprocals of its diagonal. Returns false if the
/// matrix is not positive definite by more than rounding.
fn cholesky_factor(matrix: &[f64], length: usize, lower: &mut Vec<f64>) -> bool {
    lower.clear();
    lower.extend_from_slice(matrix);
    for i in 0..length {
        let (above, row) = lower.split_at_mut(i * length);
        for j in 0..i {
            let other = &above[j * length..];
            row[j] = (row[j] - dot(&row[..j], &other[..j])) * other[j];
        }
        let entry = row[i];
        let left = entry - dot(&row[..i], &row[..i]);
        // NaN counts as indefinite.
        if !(left > 0.0 && left > CLEAR * entry) {
            return false;
        }
        row[i] = left.sqrt().recip();
    }
    true
}
