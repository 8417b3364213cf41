//! Coefficients of explicit Runge–Kutta methods (Butcher tableaux) as data.
//!
//! Invariant: coefficients are stored as the published fractions, and rounded once. The order conditions can therefore
//! be tested exactly, and a more precise scalar type can round them better. Absent on purpose: the arithmetic of a
//! step, which is in [`super::explicit_runge_kutta`].

use tripos_traits::Real;

/// Exact fraction, as numerator and denominator.
pub type Fraction = (i64, i64);

/// Butcher tableau of an explicit embedded Runge–Kutta pair with S stages and a dense output of degree 4. The last
/// stage is evaluated at the new state ("first same as last").
///
/// Stage i is kᵢ = f(t + cᵢ h, y + h Σⱼ aᵢⱼ kⱼ) with cᵢ = Σⱼ aᵢⱼ. The new state is the point of the last stage, and the
/// error estimate is h Σ eᵢ kᵢ. For θ in \[0, 1\] the solution inside the step is y(t + θ h) = y + h Σ kᵢ (dᵢ₀ θ + dᵢ₁
/// θ² + dᵢ₂ θ³ + dᵢ₃ θ⁴).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tableau<const S: usize> {
    /// Order of the solution at the end of the step.
    pub order: u32,
    /// Order of the embedded solution, with which the error is estimated.
    pub embedded_order: u32,
    /// Order of the dense output, the solution inside a step.
    pub dense_order: u32,
    /// Coefficients aᵢⱼ of the stages, strictly lower triangular; the last row has the weights of the new
    /// state.
    pub a: [[Fraction; S]; S],
    /// Weights eᵢ of the stages in the error estimate: weights of the new state minus weights of the embedded solution.
    pub error: [Fraction; S],
    /// Coefficients dᵢ₀ … dᵢ₃ of the dense output, for each stage i.
    pub dense: [[Fraction; 4]; S],
}

/// Coefficients of an explicit Runge–Kutta pair, rounded to the scalar `T` of a run.
#[derive(Clone, Debug)]
pub(crate) struct Coefficients<T, const S: usize> {
    /// Runge–Kutta coefficients aᵢⱼ of the stages.
    pub(crate) a: [[T; S]; S],
    /// Times cᵢ of the Runge–Kutta stages, as fractions of the step.
    pub(crate) c: [f64; S],
    /// Weights eᵢ of the Runge–Kutta stages in the error estimate.
    pub(crate) error: [T; S],
    /// Coefficients dᵢ₀ … dᵢ₃ of the dense output, for each stage i.
    pub(crate) dense: [[T; 4]; S],
}

impl<T: Real, const S: usize> Coefficients<T, S> {
    /// Rounds the fractions of a tableau to the scalar `T`.
    pub(crate) fn new(tableau: &Tableau<S>) -> Self {
        Self {
            a: tableau.a.map(|row| row.map(round)),
            c: tableau.a.map(|row| round(sum_of_tableau_row(&row))),
            error: tableau.error.map(round),
            dense: tableau.dense.map(|row| row.map(round)),
        }
    }
}

/// Rounds a fraction to the scalar `T`.
fn round<T: Real>((numerator, denominator): Fraction) -> T {
    T::ratio(numerator, denominator)
}

/// Exact sum of the fractions of a row. Numerators and denominators are small enough for 128 bits.
fn sum_of_tableau_row(row: &[Fraction]) -> Fraction {
    let (mut n, mut d) = (0_i128, 1_i128);
    for &(numerator, denominator) in row {
        n = n * i128::from(denominator) + i128::from(numerator) * d;
        d *= i128::from(denominator);
        let common = gcd(n, d);
        (n, d) = (n / common, d / common);
    }
    (i64::try_from(n).unwrap_or(0), i64::try_from(d).unwrap_or(1))
}

/// Greatest common divisor of two whole numbers, at least 1.
fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs().max(1)
}
