//! What inputs reach and outputs show of a linear system, and its transfer functions.

use nalgebra::{DMatrix, Schur};

/// What is left of a direction, beside its length, when those reached are taken out of it, below which it is none.
const NOTHING: f64 = 1e-9;

/// The number of dimensions that inputs reach: the rank of (B, A B, A² B, …), direction by direction, so that powers of A do not
/// hide any (Kalman's condition). Of (Aᵀ, Cᵀ), what outputs show.
#[must_use]
pub fn reached(a: &DMatrix<f64>, b: &DMatrix<f64>) -> usize {
    let mut basis: Vec<nalgebra::DVector<f64>> = Vec::new();
    let size = a.norm().max(f64::MIN_POSITIVE);
    let mut next: Vec<nalgebra::DVector<f64>> =
        b.column_iter().filter(|c| c.norm() > 0.0).map(|c| c.into_owned().normalize()).collect();
    while let Some(mut direction) = next.pop() {
        // Twice, for what rounding leaves.
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
        // What A makes nothing of, beside its size, reaches nothing.
        if moved.norm() > f64::EPSILON * size {
            next.insert(0, moved.normalize());
        }
        basis.push(direction);
    }
    basis.len()
}

/// y(s)/r(s) of one output and one input, (n₀ sᵐ + n₁ sᵐ⁻¹ + …)/(sᵏ + …).
#[derive(Clone, Debug)]
pub struct Transfer {
    /// The place of the input.
    pub input: usize,
    /// The place of the output.
    pub output: usize,
    /// Coefficients of the numerator, that of the highest power first.
    pub numerator: Vec<f64>,
    /// Coefficients of the denominator, 1 first.
    pub denominator: Vec<f64>,
}

/// The transfer functions of d' = A d + B r, y = C d + D r: det(s − A + b c) − det(s − A) over det(s − A), each.
#[must_use]
pub fn transfers(a: &DMatrix<f64>, b: &DMatrix<f64>, c: &DMatrix<f64>, d: &DMatrix<f64>) -> Vec<Transfer> {
    let mut list = Vec::new();
    let Some(denominator) = characteristic(a) else { return list };
    for input in 0..b.ncols() {
        for output in 0..c.nrows() {
            let closed = a - b.column(input) * c.row(output);
            let Some(of_closed) = characteristic(&closed) else { continue };
            let direct = d[(output, input)];
            let size = of_closed.iter().chain(&denominator).fold(0.0_f64, |most, x| most.max(x.abs()));
            let numerator: Vec<f64> =
                of_closed.iter().zip(&denominator).map(|(closed, open)| closed - open + direct * open).collect();
            let first = numerator.iter().position(|x| x.abs() > 1e-12 * size).unwrap_or(numerator.len() - 1);
            let numerator = numerator[first..].to_vec();
            list.push(Transfer { input, output, numerator, denominator: denominator.clone() });
        }
    }
    list
}

/// det(s − A), the coefficient of the highest power first.
fn characteristic(a: &DMatrix<f64>) -> Option<Vec<f64>> {
    let mut coefficients = vec![nalgebra::Complex::new(1.0, 0.0)];
    if a.nrows() > 0 {
        for root in Schur::try_new(a.clone(), f64::EPSILON, 10_000)?.complex_eigenvalues().iter() {
            coefficients.push(nalgebra::Complex::new(0.0, 0.0));
            for at in (1..coefficients.len()).rev() {
                let above = coefficients[at - 1];
                coefficients[at] -= root * above;
            }
        }
    }
    Some(coefficients.iter().map(|c| c.re).collect())
}
