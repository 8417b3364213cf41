//! Information about base parameters in the regressor of a motion.
//!
//! The information matrix is Wᵀ Σ⁻¹ W, with the regressor W of all instants and the covariance Σ of the forces.

use crate::fit::uncertainty::{Uncertainty, uncertainty_of_jacobian};
use nalgebra::{DMatrix, DVector};
use tripos_linear::singular_values;

/// Fraction of the largest effect below which a combination of base parameters counts as undetermined.
const TINY: f64 = 1e-8;
/// Pivot of the scaled information matrix below which its determinant counts as zero.
const SINGULAR: f64 = 1e-14;

/// Information that a motion gives about base parameters.
#[derive(Clone, Debug)]
pub struct Information {
    /// Number of equations: instants times generalized speeds.
    pub equations: usize,
    /// Number of independent combinations of base parameters that the motion determines.
    pub rank: usize,
    /// Natural logarithm of the determinant of Wᵀ Σ⁻¹ W in SI units, with the columns that [`Self::is_counted`] names.
    pub log_determinant: f64,
    /// Condition number of the counted columns of the regressor, each scaled to length 1.
    pub condition: f64,
    /// True for each base parameter that is counted. A base parameter is not counted if its column depends on the
    /// columns before it in all motions within the limits.
    pub is_counted: Vec<bool>,
    /// Standard error of each base parameter, in SI units. `None` if the motion does not determine it.
    pub errors: Vec<Option<f64>>,
    /// Directions in which base parameters can change without a change of any force, as pairs (index of the base
    /// parameter, change).
    pub untold: Vec<Vec<(usize, f64)>>,
}

impl Information {
    /// Information in a regressor whose rows are divided by the standard deviations of their forces. `counted` has the
    /// indices of the counted columns.
    #[must_use]
    pub(super) fn new(weighted: &DMatrix<f64>, counted: &[usize]) -> Self {
        let columns = weighted.ncols();
        let lengths: Vec<f64> = weighted.column_iter().map(|column| column.norm()).collect();
        let of = |length: f64| if length > 0.0 { length } else { 1.0 };
        let sizes: Vec<f64> = lengths.iter().map(|length| 1.0 / of(*length)).collect();
        let Uncertainty { errors, untold, .. } = uncertainty_of_jacobian(weighted, &sizes, TINY);
        let scaled = DMatrix::from_fn(weighted.nrows(), counted.len(), |row, column| {
            weighted[(row, counted[column])] / of(lengths[counted[column]])
        });
        let values = singular_values(&scaled);
        let logarithms = values.iter().map(|value| value.ln()).sum::<f64>()
            + counted.iter().map(|column| of(lengths[*column]).ln()).sum::<f64>();
        Self {
            equations: weighted.nrows(),
            rank: columns - untold.len(),
            log_determinant: 2.0 * logarithms,
            condition: values.max() / values.min(),
            is_counted: (0..columns).map(|column| counted.contains(&column)).collect(),
            errors,
            untold: untold
                .into_iter()
                .map(|direction| direction.into_iter().enumerate().filter(|(_, rate)| *rate != 0.0).collect())
                .collect(),
        }
    }
}

/// Natural logarithm of the determinant of the information matrix, from its entries. −∞ if the matrix is singular. The
/// matrix is overwritten.
#[must_use]
pub fn log_determinant(gram: &mut DMatrix<f64>) -> f64 {
    let n = gram.nrows();
    let lengths: Vec<f64> = (0..n).map(|at| gram[(at, at)].sqrt()).collect();
    if !lengths.iter().all(|length| length.is_finite() && *length > 0.0) {
        return f64::NEG_INFINITY;
    }
    let mut sum = 2.0 * lengths.iter().map(|length| length.ln()).sum::<f64>();
    // Cholesky's decomposition of the matrix with ones on its diagonal, in the lower triangle.
    for column in 0..n {
        for row in column..n {
            gram[(row, column)] /= lengths[row] * lengths[column];
        }
    }
    for column in 0..n {
        let pivot = gram[(column, column)] - (0..column).map(|k| gram[(column, k)].powi(2)).sum::<f64>();
        if pivot.is_nan() || pivot <= SINGULAR {
            return f64::NEG_INFINITY;
        }
        sum += pivot.ln();
        let root = pivot.sqrt();
        gram[(column, column)] = root;
        for row in column + 1..n {
            let rest = (0..column).map(|k| gram[(row, k)] * gram[(column, k)]).sum::<f64>();
            gram[(row, column)] = (gram[(row, column)] - rest) / root;
        }
    }
    sum
}

/// Indices of the columns of a matrix that do not depend on the columns before them.
#[must_use]
pub fn independent_columns(matrix: &DMatrix<f64>) -> Vec<usize> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut counted = Vec::new();
    for (at, column) in matrix.column_iter().enumerate() {
        let length = column.norm();
        let mut rest = column.into_owned();
        // The second pass removes the rounding errors of the first.
        for _ in 0..2 {
            for known in &basis {
                let share = known.dot(&rest);
                rest.axpy(-share, known, 1.0);
            }
        }
        let left = rest.norm();
        if left > TINY * length {
            basis.push(rest / left);
            counted.push(at);
        }
    }
    counted
}

#[cfg(test)]
mod tests {
    use super::{independent_columns, log_determinant};
    use nalgebra::DMatrix;

    /// Goal: determinants of small matrices are right. Method: a matrix with the determinant 4 · 5 − 2² = 16, and a
    /// singular one.
    #[test]
    fn determinants_are_those_of_the_formula() {
        let mut good = DMatrix::from_row_slice(2, 2, &[4.0, 2.0, 2.0, 5.0]);
        assert!((log_determinant(&mut good) - 16.0_f64.ln()).abs() < 1e-14);
        let mut singular = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 4.0]);
        assert!(log_determinant(&mut singular) < f64::MIN);
    }

    /// Goal: a column that depends on those before it, and one of zeros, are left out. Method: three such columns.
    #[test]
    fn columns_that_depend_on_others_are_left_out() {
        let matrix = DMatrix::from_row_slice(3, 4, &[1.0, 0.0, 2.0, 1.0, 2.0, 0.0, 4.0, 0.0, 3.0, 0.0, 6.0, 0.0]);
        assert_eq!(independent_columns(&matrix), [0, 3]);
    }
}
