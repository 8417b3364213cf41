//! Small dense matrices: in 32 digits for results, and in double precision for decisions and
//! corrections.

use nalgebra::{DMatrix, DVector};
use tripos_linear::SingularValues;
use tripos_traits::{DoubleDouble, Scalar};

/// Dense matrix of numbers with 32 digits.
#[derive(Clone, Debug, Default)]
pub struct WideMatrix {
    /// Entries of the matrix, row by row; all rows have the same length.
    pub rows: Vec<Vec<DoubleDouble>>,
}

impl WideMatrix {
    /// Makes a matrix of zeros with the given numbers of rows and columns.
    #[must_use]
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows: vec![vec![DoubleDouble::int(0); columns]; rows] }
    }

    /// Makes a matrix from its columns, each with `rows` entries.
    #[must_use]
    pub fn from_columns(rows: usize, columns: &[Vec<DoubleDouble>]) -> Self {
        Self { rows: (0..rows).map(|row| columns.iter().map(|column| column[row]).collect()).collect() }
    }

    /// Number of columns of the matrix; 0 if it has no rows.
    pub fn columns(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// Submatrix of the rows and columns with the given indices, in the given order.
    #[must_use]
    pub fn submatrix(&self, rows: &[usize], columns: &[usize]) -> Self {
        Self { rows: rows.iter().map(|row| columns.iter().map(|column| self.rows[*row][*column]).collect()).collect() }
    }

    /// Computes self + sign · a b. The matrices must have fitting shapes.
    #[must_use]
    pub fn plus_product(&self, sign: f64, a: &Self, b: &Self) -> Self {
        let sign = DoubleDouble::from_f64(sign);
        let mut sum = self.clone();
        for (row, left) in sum.rows.iter_mut().zip(&a.rows) {
            for (factor, right) in left.iter().zip(&b.rows) {
                for (entry, x) in row.iter_mut().zip(right) {
                    *entry = *entry + sign * *factor * *x;
                }
            }
        }
        sum
    }

    /// Rounds the matrix to double precision.
    #[must_use]
    pub fn rounded(&self) -> DMatrix<f64> {
        DMatrix::from_fn(self.rows.len(), self.columns(), |row, column| self.rows[row][column].hi())
    }

    /// Rows of the matrix, rounded to double precision.
    #[must_use]
    pub fn doubles(&self) -> Vec<Vec<f64>> {
        self.rows.iter().map(|row| row.iter().map(|x| x.hi()).collect()).collect()
    }

    /// Solves self · X = right for the matrix X, by Gaussian elimination with row pivots. `None` if self is
    /// singular.
    #[must_use]
    pub fn solve(&self, right: &Self) -> Option<Self> {
        let n = self.rows.len();
        let mut all: Vec<Vec<DoubleDouble>> =
            self.rows.iter().zip(&right.rows).map(|(a, b)| [a.as_slice(), b].concat()).collect();
        for column in 0..n {
            let size = |row: &usize| all[*row][column].hi().abs();
            let pivot = (column..n).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            if !(size(&pivot) > 0.0 && size(&pivot).is_finite()) {
                return None;
            }
            all.swap(column, pivot);
            let chosen = all[column].clone();
            for (at, row) in all.iter_mut().enumerate().filter(|(at, _)| *at != column) {
                let factor = row[column] / chosen[column];
                let start = if at < column { column } else { 0 };
                for (x, p) in row[start..].iter_mut().zip(&chosen[start..]) {
                    *x = *x - factor * *p;
                }
            }
        }
        let rows = all.iter().enumerate().map(|(at, row)| row[n..].iter().map(|x| *x / row[at]).collect());
        Some(Self { rows: rows.collect() })
    }
}

/// Finds the shortest vector x that minimizes |a x + r|, after the columns of a are scaled to equal size.
/// Singular values up to the fraction `relative` of the largest count as zero. `None` if an entry is
/// not finite.
pub fn least_squares(a: &DMatrix<f64>, r: &DVector<f64>, relative: f64) -> Option<DVector<f64>> {
    if a.ncols() == 0 || a.nrows() == 0 {
        return Some(DVector::zeros(a.ncols()));
    }
    let size = |x: f64| if x > 0.0 && x.is_finite() { x } else { 1.0 };
    let columns: Vec<f64> = a.column_iter().map(|column| size(column.amax())).collect();
    let scaled = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)] / columns[j]);
    if scaled.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let values = SingularValues::new(&scaled);
    let found = values.solve(&-r, relative * values.values.max());
    Some(DVector::from_fn(found.len(), |j, _| found[j] / columns[j]))
}

/// Computes an orthonormal basis, as columns, of all vectors x with a x = 0. Singular values up to the
/// fraction `relative` of the largest count as zero.
pub fn null_space(a: &DMatrix<f64>, relative: f64) -> DMatrix<f64> {
    let n = a.ncols();
    if a.nrows() == 0 || n == 0 {
        return DMatrix::identity(n, n);
    }
    // Rows of zeros make the matrix square, so that all right singular vectors are computed.
    let square = a.clone().resize_vertically(a.nrows().max(n), 0.0);
    let SingularValues { values, right, .. } = SingularValues::new(&square);
    let most = values.max().max(f64::MIN_POSITIVE);
    let columns: Vec<_> =
        (0..n).filter(|at| values[*at] <= relative * most).map(|at| right.row(at).transpose()).collect();
    if columns.is_empty() { DMatrix::zeros(n, 0) } else { DMatrix::from_columns(&columns) }
}

/// Computes an orthonormal basis, as columns, of the `count` directions that a square matrix maps to the
/// shortest vectors.
pub fn smallest_singular_directions(a: &DMatrix<f64>, count: usize) -> DMatrix<f64> {
    let SingularValues { right, .. } = SingularValues::new(a);
    let last = a.ncols().saturating_sub(1);
    DMatrix::from_fn(a.ncols(), count.min(a.ncols()), |row, column| right[(last - column, row)])
}
