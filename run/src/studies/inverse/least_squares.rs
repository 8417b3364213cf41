//! Least-squares solutions to 32 digits, for linear systems with a matrix of any shape and rank.

use nalgebra::{DMatrix, DVector};
use tripos_linear::SingularValues;
use tripos_traits::DoubleDouble;

/// Fraction of the largest singular value below which a singular value counts as zero.
const RANK: f64 = 1e-10;

/// Solver of linear systems in the least-squares sense. It uses the pseudo-inverse of the matrix in double
/// precision.
pub struct LeastSquaresSolver {
    /// Pseudo-inverse, with a row for each unknown and a column for each equation.
    inverse: DMatrix<f64>,
    /// Rank of the matrix.
    rank: usize,
}

/// Least-squares solution of a linear system. If there are several, it is the solution of least norm.
pub struct LeastSquaresSolution {
    /// Values of the unknowns.
    pub x: Vec<DoubleDouble>,
    /// Residual: the right-hand side minus the matrix times `x`, an entry for each equation.
    pub left: Vec<DoubleDouble>,
    /// Rank of the matrix.
    pub rank: usize,
}

/// Rounds numbers of 32 digits to double precision.
pub fn round_to_doubles(list: &[DoubleDouble]) -> Vec<f64> {
    list.iter().map(|x| x.hi()).collect()
}

impl LeastSquaresSolver {
    /// Computes the pseudo-inverse of a matrix, given by its rows.
    pub fn new(rows: &[&[DoubleDouble]]) -> Self {
        let columns = rows.first().map_or(0, |row| row.len());
        let matrix = DMatrix::from_fn(rows.len(), columns, |i, j| rows[i][j].hi());
        if rows.is_empty() || columns == 0 {
            return Self { inverse: DMatrix::zeros(columns, rows.len()), rank: 0 };
        }
        let found = SingularValues::new(&matrix);
        let least = RANK * found.values.max();
        Self { inverse: found.pseudo_inverse(least), rank: found.rank(least) }
    }

    /// Solves the linear system for a right-hand side, in three steps that each add up to sixteen digits.
    /// `rows` must be the matrix that was given to `new`.
    pub fn solve(&self, rows: &[&[DoubleDouble]], right: &[DoubleDouble]) -> LeastSquaresSolution {
        let mut x = vec![DoubleDouble::from(0.0); self.inverse.nrows()];
        let left_of = |x: &[DoubleDouble]| -> Vec<DoubleDouble> {
            let one = |(row, right): (&&[DoubleDouble], &DoubleDouble)| {
                row.iter().zip(x).fold(*right, |left, (a, x)| left - *a * *x)
            };
            rows.iter().zip(right).map(one).collect()
        };
        let mut left = left_of(&x);
        for _ in 0..3 {
            let step = &self.inverse * DVector::from_vec(round_to_doubles(&left));
            for (x, step) in x.iter_mut().zip(step.iter()) {
                *x = *x + DoubleDouble::from(*step);
            }
            left = left_of(&x);
        }
        LeastSquaresSolution { x, left, rank: self.rank }
    }
}
