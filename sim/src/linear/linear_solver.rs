//! Solver for a linear system of small order, by Cholesky's factorization or by LU, and the determinant
//! of a matrix.

use nalgebra::{Const, DMatrix, DVector, DimMin, SMatrix, SVector};

/// Kind of a matrix, which selects its factorization.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixKind {
    /// Symmetric matrix, positive definite unless nearly singular. Cholesky's factorization is tried first, then LU.
    /// Apart from nearly singular matrices, only an indefinite matrix needs LU.
    Symmetric,
    /// Square matrix of any kind, which is solved by LU with partial pivoting.
    General,
}

/// Reason why a linear system A x = b has no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnsolvableSystem {
    /// The matrix or the right-hand side contains an infinity or a "not a number".
    NotFinite,
    /// A pivot of the matrix is exactly zero, the solution overflows, or the matrix has the wrong number of
    /// entries.
    Singular,
}

/// Solves the linear system A x = b. `a` holds A row by row, with b.len()² entries; the solution replaces `b`.
///
/// The residual is small whenever the solution exists. The error can be as large as ε / rcond(A), see
/// [`super::reciprocal_condition`].
///
/// # Errors
/// [`UnsolvableSystem`] if there is no finite solution, or if `a` has the wrong length; `b` then has no meaning.
pub fn solve_linear_system(a: &[f64], b: &mut [f64], shape: MatrixKind) -> Result<(), UnsolvableSystem> {
    if a.len() != b.len() * b.len() {
        return Err(UnsolvableSystem::Singular);
    }
    if !a.iter().chain(b.iter()).all(|x| x.is_finite()) {
        return Err(UnsolvableSystem::NotFinite);
    }
    let solved = match b.len() {
        0 => true,
        1 => solve_on_stack::<1>(a, b, shape),
        2 => solve_on_stack::<2>(a, b, shape),
        3 => solve_on_stack::<3>(a, b, shape),
        4 => solve_on_stack::<4>(a, b, shape),
        5 => solve_on_stack::<5>(a, b, shape),
        6 => solve_on_stack::<6>(a, b, shape),
        7 => solve_on_stack::<7>(a, b, shape),
        8 => solve_on_stack::<8>(a, b, shape),
        9 => solve_on_stack::<9>(a, b, shape),
        10 => solve_on_stack::<10>(a, b, shape),
        11 => solve_on_stack::<11>(a, b, shape),
        12 => solve_on_stack::<12>(a, b, shape),
        _ => solve_dynamic(a, b, shape),
    };
    if solved && b.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(UnsolvableSystem::Singular) }
}

/// Solves a linear system of order N, known at compile time, on the stack; the solution replaces `b`. Returns false if
/// a pivot is zero.
fn solve_on_stack<const N: usize>(a: &[f64], b: &mut [f64], shape: MatrixKind) -> bool
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let matrix = SMatrix::<f64, N, N>::from_row_slice(a);
    let mut x = SVector::<f64, N>::from_column_slice(b);
    let cholesky = match shape {
        MatrixKind::Symmetric => matrix.cholesky(),
        MatrixKind::General => None,
    };
    let solved = match cholesky {
        Some(factors) => {
            factors.solve_mut(&mut x);
            true
        }
        None => matrix.lu().solve_mut(&mut x),
    };
    b.copy_from_slice(x.as_slice());
    solved
}

/// Solves a linear system of any order; the solution replaces `b`. Returns false if a pivot is zero.
fn solve_dynamic(a: &[f64], b: &mut [f64], shape: MatrixKind) -> bool {
    let matrix = DMatrix::from_row_slice(b.len(), b.len(), a);
    let mut x = DVector::from_column_slice(b);
    let cholesky = match shape {
        MatrixKind::Symmetric => matrix.clone().cholesky(),
        MatrixKind::General => None,
    };
    let solved = match cholesky {
        Some(factors) => {
            factors.solve_mut(&mut x);
            true
        }
        None => matrix.lu().solve_mut(&mut x),
    };
    b.copy_from_slice(x.as_slice());
    solved
}

/// Determinant of a matrix of order `n`, by LU. `a` holds n² entries, row by row. NaN if the length is wrong or an
/// entry is not finite.
#[must_use]
pub fn matrix_determinant(a: &[f64], n: usize) -> f64 {
    if a.len() != n * n || !a.iter().all(|x| x.is_finite()) {
        return f64::NAN;
    }
    DMatrix::from_row_slice(n, n, a).determinant()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entries of a positive definite matrix, row by row: 1 / (i + j + 1), plus 1 on the diagonal.
    fn shifted_hilbert(n: usize) -> Vec<f64> {
        (0..n * n)
            .map(|k| {
                let (i, j) = (k / n, k % n);
                1.0 / (i + j + 1) as f64 + if i == j { 1.0 } else { 0.0 }
            })
            .collect()
    }

    /// Systems of every order that is solved on the stack, and of larger orders. The tolerance is 1e-13, since the
    /// condition number is below 4.
    #[test]
    fn systems_of_every_order_are_solved() {
        for n in 1..=15 {
            for shape in [MatrixKind::Symmetric, MatrixKind::General] {
                let a = shifted_hilbert(n);
                let x: Vec<f64> = (0..n).map(|i| 1.0 - i as f64).collect();
                let mut b: Vec<f64> = a.chunks(n).map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
                solve_linear_system(&a, &mut b, shape).unwrap();
                for (found, expected) in b.iter().zip(&x) {
                    assert!((found - expected).abs() < 1e-13, "order {n}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn a_symmetric_indefinite_matrix_is_solved_by_pivoting() {
        let mut b = [2.0, 3.0];
        solve_linear_system(&[0.0, 1.0, 1.0, 0.0], &mut b, MatrixKind::Symmetric).unwrap();
        assert_eq!(b, [3.0, 2.0]);
    }

    #[test]
    fn an_unsymmetric_matrix_is_not_transposed() {
        let mut b = [5.0, 6.0];
        solve_linear_system(&[1.0, 2.0, 0.0, 3.0], &mut b, MatrixKind::General).unwrap();
        assert_eq!(b, [1.0, 2.0]);
    }

    #[test]
    fn singular_and_meaningless_systems_are_refused() {
        let singular = solve_linear_system(&[1.0, 1.0, 1.0, 1.0], &mut [1.0, 2.0], MatrixKind::Symmetric);
        assert_eq!(singular, Err(UnsolvableSystem::Singular));
        let infinite = solve_linear_system(&[f64::INFINITY], &mut [1.0], MatrixKind::General);
        assert_eq!(infinite, Err(UnsolvableSystem::NotFinite));
        let overflow = solve_linear_system(&[1e-300], &mut [1e300], MatrixKind::Symmetric);
        assert_eq!(overflow, Err(UnsolvableSystem::Singular));
    }

    #[test]
    fn determinants_have_signs_and_no_value_where_an_entry_has_none() {
        assert!((matrix_determinant(&[0.0, 2.0, 3.0, 4.0], 2) + 6.0).abs() < 1e-15);
        assert_eq!(matrix_determinant(&[1.0, 1.0, 1.0, 1.0], 2), 0.0);
        assert_eq!(matrix_determinant(&[], 0), 1.0);
        assert!(matrix_determinant(&[f64::INFINITY], 1).is_nan() && matrix_determinant(&[1.0], 2).is_nan());
    }
}
