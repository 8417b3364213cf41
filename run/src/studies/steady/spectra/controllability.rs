//! Controllability and observability of a linear system, and its transfer functions.

use super::schur_form::SchurForm;
use super::wide_complex::WideComplex;
use super::wide_matrix::WideMatrix;
use crate::Error;
use nalgebra::DMatrix;
use tripos_traits::DoubleDouble;

/// Remaining length of a unit vector up to which it counts as zero, after its components along known
/// directions are removed.
const NOTHING: f64 = 1e-9;

/// Computes the dimension of the subspace of states that the inputs can reach: the rank of
/// (B, A B, A² B, …) (Kalman's condition). For (Aᵀ, Cᵀ) it is the dimension that the outputs can
/// distinguish. It is found direction by direction, so that powers of A lose no digits.
#[must_use]
pub fn controllable_dimension(a: &DMatrix<f64>, b: &DMatrix<f64>) -> usize {
    let mut basis: Vec<nalgebra::DVector<f64>> = Vec::new();
    let size = a.norm().max(f64::MIN_POSITIVE);
    let mut next: Vec<nalgebra::DVector<f64>> =
        b.column_iter().filter(|c| c.norm() > 0.0).map(|c| c.into_owned().normalize()).collect();
    while let Some(mut direction) = next.pop() {
        // The components are removed twice, since rounding leaves a remainder the first time.
        for _ in 0..2 {
            for known in &basis {
                direction -= known * known.dot(&direction);
            }
        }
        if direction.norm() <= NOTHING {
            continue;
        }
        direction.normalize_mut();
        let moved = a * &direction;
        // A direction that A maps to zero, relative to the size of A, leads to no further direction.
        if moved.norm() > f64::EPSILON * size {
            next.insert(0, moved.normalize());
        }
        basis.push(direction);
    }
    basis.len()
}

/// Transfer function y(s)/r(s) from an input to an output, (n₀ sᵐ + n₁ sᵐ⁻¹ + …)/(sᵏ + …).
#[derive(Clone, Debug)]
pub struct TransferFunction {
    /// Index of the input among the inputs of the linear system.
    pub input: usize,
    /// Index of the output among the outputs of the linear system.
    pub output: usize,
    /// Coefficients of the numerator, with the highest power of s first.
    pub numerator: Vec<f64>,
    /// Coefficients of the denominator, with the highest power of s first. The first coefficient is 1.
    pub denominator: Vec<f64>,
}

/// Computes the transfer functions of d' = A d + B r, y = C d + D r, from each input to each output.
/// Each is (det(s − A + b c) − det(s − A))/det(s − A) plus an entry of D. Here b is a column of B, and
/// c a row of C.
///
/// # Errors
/// [`Error::Stopped`] if the eigenvalues cannot be computed.
pub fn transfer_functions(
    a: &WideMatrix,
    b: &WideMatrix,
    c: &WideMatrix,
    d: &WideMatrix,
) -> Result<Vec<TransferFunction>, Error> {
    let mut list = Vec::new();
    let open = characteristic_polynomial(a)?;
    let denominator: Vec<f64> = open.iter().map(|x| x.hi()).collect();
    for input in 0..b.columns() {
        for output in 0..c.rows.len() {
            let mut closed = a.clone();
            for (row, entries) in closed.rows.iter_mut().enumerate() {
                for (entry, shown) in entries.iter_mut().zip(&c.rows[output]) {
                    *entry = *entry - b.rows[row][input] * *shown;
                }
            }
            let closed = characteristic_polynomial(&closed)?;
            let direct = d.rows[output][input];
            let size = closed.iter().chain(&open).fold(0.0_f64, |most, x| most.max(x.hi().abs()));
            let numerator = closed.iter().zip(&open).map(|(closed, open)| (*closed - *open + direct * *open).hi());
            let numerator: Vec<f64> = numerator.collect();
            let first = numerator.iter().position(|x| x.abs() > 1e-12 * size).unwrap_or(numerator.len() - 1);
            let numerator = numerator[first..].to_vec();
            list.push(TransferFunction { input, output, numerator, denominator: denominator.clone() });
        }
    }
    Ok(list)
}

/// Coefficients of the characteristic polynomial det(s − A), with the highest power of s first.
///
/// # Errors
/// `Error::Stopped` if the eigenvalues cannot be computed.
fn characteristic_polynomial(a: &WideMatrix) -> Result<Vec<DoubleDouble>, Error> {
    let mut coefficients = vec![WideComplex::from_f64(1.0)];
    if !a.rows.is_empty() {
        let none = || Error::Stopped("the eigenvalues of this matrix were not found".to_owned());
        for root in SchurForm::new(a).ok_or_else(none)?.eigenvalues() {
            coefficients.push(WideComplex::default());
            for at in (1..coefficients.len()).rev() {
                coefficients[at] = coefficients[at] - root * coefficients[at - 1];
            }
        }
    }
    Ok(coefficients.into_iter().map(|c| c.re).collect())
}
