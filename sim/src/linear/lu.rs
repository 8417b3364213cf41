//! LU factors of a dense matrix in any scalar, real or complex, with partial pivoting.
//!
//! They solve the linear systems of implicit steps, whose order is up to three times the length of the state. Nothing
//! is allocated after `new`.

use std::ops::{Add, Div, Mul, Sub};

use tripos_traits::{DoubleDouble, Real};

/// Real or complex number that can be an entry of a factored matrix.
pub(crate) trait Entry:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Returns the number 0.
    fn zero() -> Self;
    /// Absolute value of the number, rounded to `f64`, for the choice of pivots.
    fn absolute_value(self) -> f64;
}

impl<S: Real> Entry for S {
    fn zero() -> Self {
        S::from_f64(0.0)
    }
    fn absolute_value(self) -> f64 {
        self.to_f64().abs()
    }
}

/// Square matrix of order n. After a call of `factor` it holds the LU factors.
pub(crate) struct Lu<S> {
    /// Order n of the square matrix.
    n: usize,
    /// Entries of the matrix, row by row. After the factorization: U, and the multipliers L below the diagonal.
    pub(crate) entries: Vec<S>,
    /// Index of the row that was exchanged with row i when column i was eliminated, for each i.
    pivots: Vec<usize>,
}

impl<S: Entry> Lu<S> {
    /// Creates a matrix of order `n` whose entries are all zero.
    pub(crate) fn new(n: usize) -> Self {
        Self { n, entries: vec![S::zero(); n * n], pivots: vec![0; n] }
    }

    /// Replaces the entries of the matrix with its LU factors. Returns false if a pivot is 0 or not finite.
    pub(crate) fn factor(&mut self) -> bool {
        let n = self.n;
        for column in 0..n {
            let size = |row: &usize| self.entries[row * n + column].absolute_value();
            let pivot = (column..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(column);
            self.pivots[column] = pivot;
            if pivot != column {
                for j in 0..n {
                    self.entries.swap(column * n + j, pivot * n + j);
                }
            }
            let (above, below) = self.entries.split_at_mut((column + 1) * n);
            let pivot_row = &above[column * n..];
            let pivot = pivot_row[column];
            if !(pivot.absolute_value() > 0.0 && pivot.absolute_value().is_finite()) {
                return false;
            }
            for row in below.chunks_exact_mut(n) {
                let factor = row[column] / pivot;
                row[column] = factor;
                for (x, p) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                    *x = *x - factor * *p;
                }
            }
        }
        true
    }

    /// Solves A x = b with the LU factors of A; the solution x replaces `b`, n entries.
    pub(crate) fn solve(&self, b: &mut [S]) {
        let n = self.n;
        for (i, pivot) in self.pivots.iter().enumerate() {
            b.swap(i, *pivot);
        }
        for i in 1..n {
            let (known, rest) = b.split_at_mut(i);
            for (l, x) in self.entries[i * n..i * n + i].iter().zip(known) {
                rest[0] = rest[0] - *l * *x;
            }
        }
        for i in (0..n).rev() {
            let (rest, known) = b.split_at_mut(i + 1);
            for (u, x) in self.entries[i * n + i + 1..(i + 1) * n].iter().zip(known) {
                rest[i] = rest[i] - *u * *x;
            }
            rest[i] = rest[i] / self.entries[i * n + i];
        }
    }
}

/// Solves A x = b in 32 digits. `a` has the rows of A one after the other; the solution x replaces `b`. Returns false
/// if A is exactly singular or not finite; `b` then has no meaning.
///
/// # Panics
/// If `a` does not have as many rows and columns as `b` has entries.
#[must_use]
pub fn solve_extended(a: &[DoubleDouble], b: &mut [DoubleDouble]) -> bool {
    let mut lu = Lu::new(b.len());
    lu.entries.copy_from_slice(a);
    let is_regular = lu.factor();
    if is_regular {
        lu.solve(b);
    }
    is_regular
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrix whose pivots lie off the diagonal. The tolerance is 1e-14, since its condition number is below 30.
    #[test]
    fn a_system_that_needs_pivots_is_solved() {
        let a = [0.0, 2.0, 1.0, 1.0, -2.0, -3.0, -1.0, 1.0, 2.0_f64];
        let x = [1.0, -2.0, 3.0];
        let mut lu = Lu::new(3);
        lu.entries.copy_from_slice(&a);
        let mut b: Vec<f64> = a.chunks(3).map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        assert!(lu.factor());
        lu.solve(&mut b);
        for (found, expected) in b.iter().zip(x) {
            assert!((found - expected).abs() < 1e-14, "{b:?}");
        }
    }

    #[test]
    fn singular_and_meaningless_matrices_are_refused() {
        for entries in [[1.0, 2.0, 2.0, 4.0], [f64::NAN, 0.0, 0.0, 1.0], [f64::INFINITY, 1.0, 1.0, 1.0]] {
            let mut lu = Lu::new(2);
            lu.entries.copy_from_slice(&entries);
            assert!(!lu.factor(), "{entries:?}");
        }
        assert!(Lu::<f64>::new(0).factor());
    }
}
