//! Condition numbers of a matrix, with and without scaling, which measure its nearness to a singular
//! matrix.

use nalgebra::DMatrix;
use tripos_traits::largest;

/// Reciprocal condition number 1 / (‖A‖₁ ‖A⁻¹‖₁) of a matrix after scaling: every row, then every column, is divided by
/// its largest entry. `a` holds n² entries, row by row. 0 for a singular matrix, or a matrix with an entry that is not
/// finite.
///
/// The scaling removes the choice of units, so that the number measures nearness to a singular matrix. It computes an
/// explicit inverse, and is meant for messages and charts, not for every step.
#[must_use]
pub fn reciprocal_condition(a: &[f64], n: usize) -> f64 {
    if a.len() != n * n || n == 0 || !a.iter().all(|x| x.is_finite()) {
        return 0.0;
    }
    let mut matrix = DMatrix::from_row_slice(n, n, a);
    for mut row in matrix.row_iter_mut() {
        let largest = row.amax();
        row /= largest;
    }
    for mut column in matrix.column_iter_mut() {
        let largest = column.amax();
        column /= largest;
    }
    let norm = one_norm(&matrix);
    let Some(inverse) = matrix.try_inverse() else {
        return 0.0;
    };
    let reciprocal = 1.0 / (norm * one_norm(&inverse));
    if reciprocal.is_finite() { reciprocal } else { 0.0 }
}

/// Reciprocal condition number 1 / (‖A‖₁ ‖A⁻¹‖₁) of a matrix without scaling; it depends on the choice of units. `a`
/// holds n² entries, row by row. 0 for a singular matrix, or a matrix with an entry that is not finite.
#[must_use]
pub fn plain_reciprocal_condition(a: &[f64], n: usize) -> f64 {
    if a.len() != n * n || n == 0 || !a.iter().all(|x| x.is_finite()) {
        return 0.0;
    }
    let matrix = DMatrix::from_row_slice(n, n, a);
    let norm = one_norm(&matrix);
    let reciprocal = matrix.try_inverse().map_or(0.0, |inverse| 1.0 / (norm * one_norm(&inverse)));
    if reciprocal.is_finite() { reciprocal } else { 0.0 }
}

/// Matrix norm ‖A‖₁: the largest sum of the absolute values in a column.
fn one_norm(matrix: &DMatrix<f64>) -> f64 {
    largest(matrix.column_iter().map(|column| column.iter().map(|x| x.abs()).sum()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn condition_does_not_depend_on_units() {
        // diag(1, 1e-12) is only badly scaled; [[1, 1], [1, 1 + 1e-8]] is nearly singular.
        assert!((reciprocal_condition(&[1.0, 0.0, 0.0, 1e-12], 2) - 1.0).abs() < 1e-15);
        let near = reciprocal_condition(&[1.0, 1.0, 1.0, 1.0 + 1e-8], 2);
        assert!((near / 2.5e-9 - 1.0).abs() < 1e-6, "{near}");
        assert_eq!(reciprocal_condition(&[1.0, 1.0, 1.0, 1.0], 2), 0.0);
        assert_eq!(reciprocal_condition(&[0.0], 1), 0.0);
    }
}
