//! Singular values of small dense matrices by one-sided Jacobi rotations.
//!
//! The rotations make the columns of A V perpendicular (M. R. Hestenes 1958; J. Demmel & K. Veselić, Jacobi's method is
//! more accurate than QR, SIAM J. Matrix Anal. Appl. 13, 1992). Then A V = U Σ. The method has no difficulty with equal
//! singular values, as matrices of rotations have them. The decomposition of nalgebra 0.34 misses U Σ Vᵀ = A by up to
//! 0.5 for such matrices (dimforge/nalgebra#1172). The cost is some n² m operations a sweep, and some six sweeps.

#![cfg_attr(doctest, doc = include_str!("../README.md"))]

use nalgebra::{DMatrix, DVector, Dyn, Matrix, Storage, U1};

/// Largest number of sweeps over all pairs of columns. Matrices of some 100 columns need fewer than 15.
const SWEEPS: usize = 60;
/// Cosine of the angle of two columns below which they count as perpendicular.
const PERPENDICULAR: f64 = 4.0 * f64::EPSILON;

/// Singular value decomposition A = U Σ Vᵀ of an m × n matrix, with k = min(m, n) singular values.
#[derive(Clone, Debug)]
pub struct SingularValues {
    /// Left singular vectors, m × k, as columns. A column of the singular value 0 may be zero if m ≥ n.
    pub left: DMatrix<f64>,
    /// Singular values, k of them, the largest first. NaN if an entry of the matrix is not finite.
    pub values: DVector<f64>,
    /// Right singular vectors, k × n, as rows. They are perpendicular and of length 1 if m ≥ n. If m < n, a row of the
    /// singular value 0 may be zero.
    pub right: DMatrix<f64>,
}

impl SingularValues {
    /// Decomposes a matrix.
    #[must_use]
    pub fn new<R: nalgebra::Dim, C: nalgebra::Dim, S: Storage<f64, R, C>>(matrix: &Matrix<f64, R, C, S>) -> Self {
        let (rows, columns) = matrix.shape();
        let own = DMatrix::from_iterator(rows, columns, matrix.iter().copied());
        if rows >= columns {
            return Self::of_tall(own);
        }
        let Self { left, values, right } = Self::of_tall(own.transpose());
        Self { left: right.transpose(), values, right: left.transpose() }
    }

    /// Decomposes a matrix with at least as many rows as columns.
    fn of_tall(mut a: DMatrix<f64>) -> Self {
        let columns = a.ncols();
        let mut v = DMatrix::identity(columns, columns);
        let scale = a.amax();
        if !a.iter().all(|entry| entry.is_finite()) {
            let values = DVector::repeat(columns, f64::NAN);
            return Self { left: a, values, right: v };
        }
        if scale > 0.0 {
            // Squares of entries neither overflow nor vanish.
            a /= scale;
        }
        for _ in 0..SWEEPS {
            let mut is_done = true;
            for p in 0..columns {
                for q in p + 1..columns {
                    is_done &= !rotate_columns(&mut a, &mut v, p, q);
                }
            }
            if is_done {
                break;
            }
        }
        let sizes: Vec<f64> = a.column_iter().map(|column| column.norm()).collect();
        let mut order: Vec<usize> = (0..columns).collect();
        order.sort_by(|one, other| sizes[*other].total_cmp(&sizes[*one]));
        let mut left = a.select_columns(&order);
        for (mut column, at) in left.column_iter_mut().zip(&order) {
            if sizes[*at] > 0.0 {
                column /= sizes[*at];
            }
        }
        let values = DVector::from_iterator(columns, order.iter().map(|at| sizes[*at] * scale));
        Self { left, values, right: v.select_columns(&order).transpose() }
    }

    /// Shortest x that minimizes |A x − b|, without the directions whose singular values are at most `least`. `sides`
    /// has the right-hand sides b as columns, m × r; the result has the x as columns, n × r.
    #[must_use]
    pub fn solve_all(&self, sides: &DMatrix<f64>, least: f64) -> DMatrix<f64> {
        let mut shares = self.left.tr_mul(sides);
        for (mut row, value) in shares.row_iter_mut().zip(self.values.iter()) {
            if *value > least {
                row /= *value;
            } else {
                row.fill(0.0);
            }
        }
        self.right.tr_mul(&shares)
    }

    /// Shortest x that minimizes |A x − b| for one right-hand side b, as [`Self::solve_all`] does.
    #[must_use]
    pub fn solve<S: Storage<f64, Dyn, U1>>(&self, side: &Matrix<f64, Dyn, U1, S>, least: f64) -> DVector<f64> {
        let sides = DMatrix::from_iterator(side.nrows(), 1, side.iter().copied());
        self.solve_all(&sides, least).column(0).into_owned()
    }

    /// Pseudo-inverse, n × m, without the directions whose singular values are at most `least`.
    #[must_use]
    pub fn pseudo_inverse(&self, least: f64) -> DMatrix<f64> {
        self.solve_all(&DMatrix::identity(self.left.nrows(), self.left.nrows()), least)
    }

    /// Number of singular values above `least`.
    #[must_use]
    pub fn rank(&self, least: f64) -> usize {
        self.values.iter().filter(|value| **value > least).count()
    }
}

/// Singular values of a matrix, the largest first. NaN if an entry of the matrix is not finite.
#[must_use]
pub fn singular_values<R: nalgebra::Dim, C: nalgebra::Dim, S: Storage<f64, R, C>>(
    matrix: &Matrix<f64, R, C, S>,
) -> DVector<f64> {
    SingularValues::new(matrix).values
}

/// Turns the columns p and q of A, and those of V, until those of A are perpendicular. Returns false if they were.
fn rotate_columns(a: &mut DMatrix<f64>, v: &mut DMatrix<f64>, p: usize, q: usize) -> bool {
    let (square_p, square_q) = (a.column(p).norm_squared(), a.column(q).norm_squared());
    let product = a.column(p).dot(&a.column(q));
    if product.abs() <= PERPENDICULAR * (square_p * square_q).sqrt() {
        return false;
    }
    let cotangent = (square_q - square_p) / (2.0 * product);
    let tangent = cotangent.signum() / (cotangent.abs() + cotangent.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = cosine * tangent;
    for matrix in [a, v] {
        for row in 0..matrix.nrows() {
            let (x, y) = (matrix[(row, p)], matrix[(row, q)]);
            matrix[(row, p)] = cosine * x - sine * y;
            matrix[(row, q)] = sine * x + cosine * y;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudorandom numbers between −1 and 1 (G. Marsaglia 2003, xorshift).
    struct Chance(u64);

    impl Chance {
        fn draw(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    fn check(matrix: &DMatrix<f64>) {
        let found = SingularValues::new(matrix);
        let size = matrix.norm().max(f64::MIN_POSITIVE);
        let again = &found.left * DMatrix::from_diagonal(&found.values) * &found.right;
        assert!((again - matrix).norm() < 1e-13 * size, "{matrix}");
        let values: Vec<f64> = found.values.iter().copied().collect();
        assert!(values.windows(2).all(|pair| pair[0] >= pair[1] && pair[1] >= 0.0), "{values:?}");
        let rank = found.rank(1e-12 * size);
        let perpendicular = |vectors: DMatrix<f64>| {
            let products = &vectors * vectors.transpose();
            assert!((products - DMatrix::identity(rank, rank)).norm() < 1e-13 * matrix.len() as f64, "{matrix}");
        };
        perpendicular(found.right.rows(0, rank).into_owned());
        perpendicular(found.left.columns(0, rank).transpose());
    }

    /// Goal: U Σ Vᵀ = A with perpendicular vectors. Method: random matrices of many shapes and ranks.
    #[test]
    fn random_matrices_are_composed_again() {
        let mut chance = Chance(77);
        for rows in 1..9 {
            for columns in 1..9 {
                for rank in 1..=rows.min(columns) {
                    let mut random = |n: usize, m: usize| DMatrix::from_fn(n, m, |_, _| chance.draw());
                    let (one, other) = (random(rows, rank), random(rank, columns));
                    check(&(one * other));
                }
            }
        }
        for matrix in [DMatrix::zeros(4, 3), DMatrix::from_element(3, 3, 1e-140), DMatrix::from_element(2, 5, 1e140)] {
            check(&matrix);
        }
        let infinite = DMatrix::from_element(2, 2, f64::INFINITY);
        assert!(singular_values(&infinite).iter().all(|value| value.is_nan()));
    }

    /// Goal: equal singular values are found. Method: the rates of Euler parameters at random orientations beside those
    /// of other coordinates have the values 2 and 1, four and five times.
    #[test]
    fn equal_values_of_rotations_are_found() {
        let mut chance = Chance(5);
        for _ in 0..2000 {
            let parts = DVector::from_fn(4, |_, _| chance.draw()).normalize();
            let (a, b, c, d) = (parts[0], parts[1], parts[2], parts[3]);
            let mut matrix = DMatrix::identity(9, 9);
            let rows = [[a, b, c, d], [-b, a, d, -c], [-c, -d, a, b], [-d, c, -b, a]];
            for (row, entries) in rows.iter().enumerate() {
                for (column, entry) in entries.iter().enumerate() {
                    matrix[(3 + row, 3 + column)] = 2.0 * entry;
                }
            }
            check(&matrix);
            let values = singular_values(&matrix);
            assert!((values[3] - 2.0).abs() < 1e-14 && (values[4] - 1.0).abs() < 1e-14, "{values}");
        }
    }

    /// Goal: least squares and null directions. Method: a matrix of rank 2 with three columns.
    #[test]
    fn shortest_solutions_are_found() {
        let matrix = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 0.0, 1.0]);
        let found = SingularValues::new(&matrix);
        assert_eq!(found.rank(1e-12), 2);
        let x = found.solve(&DVector::from_vec(vec![2.0, 4.0, 4.0]), 1e-12);
        assert!((x - DVector::from_vec(vec![1.5, 2.0, 1.5])).norm() < 1e-14);
        let null = found.right.row(2).transpose();
        assert!((&matrix * null).norm() < 1e-14);
        let unit = &matrix * found.pseudo_inverse(1e-12) * &matrix;
        assert!((unit - matrix).norm() < 1e-14);
    }
}
