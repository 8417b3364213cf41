//! Explicit Runge–Kutta methods as data.
//!
//! Invariant: coefficients are stored as the fractions they are published as, and rounded once. The
//! order conditions can therefore be tested exactly, and another number type can round them better.
//! Absent on purpose: any arithmetic of a step; that is [`super::explicit`].

use tripos_traits::Real;

/// Fraction numerator / denominator.
pub type Fraction = (i64, i64);

/// An explicit embedded Runge–Kutta pair with S stages, whose last stage is evaluated at the new
/// point ("first same as last"), and with a dense output of degree 4.
///
/// Stage i is kᵢ = f(t + cᵢ h, y + h Σⱼ aᵢⱼ kⱼ) with cᵢ = Σⱼ aᵢⱼ; the new point is that of
/// the last stage; the error estimate is h Σ eᵢ kᵢ; and for θ in [0, 1] the solution inside the
/// step is y(t + θ h) = y + h Σ kᵢ (dᵢ₀ θ + dᵢ₁ θ² + dᵢ₂ θ³ + dᵢ₃ θ⁴).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tableau<const S: usize> {
    /// Order of the solution at the new point.
    pub order: u32,
    /// Order of the embedded solution, against which the error is estimated.
    pub embedded_order: u32,
    /// Order of the dense output.
    pub dense_order: u32,
    /// Coefficients aᵢⱼ of the stages, strictly lower triangular; the last row holds the weights of the new point.
    pub a: [[Fraction; S]; S],
    /// Weights eᵢ of the error: those of the new point minus those of the embedded solution.
    pub error: [Fraction; S],
    /// Coefficients dᵢ₀ … dᵢ₃ of the dense output.
    pub dense: [[Fraction; 4]; S],
}

/// Coefficients of a [`Tableau`], rounded to a scalar.
#[derive(Clone, Debug)]
pub(crate) struct Coefficients<T, const S: usize> {
    pub(crate) a: [[T; S]; S],
    pub(crate) c: [f64; S],
    pub(crate) error: [T; S],
    pub(crate) dense: [[T; 4]; S],
}

impl<T: Real, const S: usize> Coefficients<T, S> {
    pub(crate) fn new(tableau: &Tableau<S>) -> Self {
        Self {
            a: tableau.a.map(|row| row.map(round)),
            c: tableau.a.map(|row| round(sum(&row))),
            error: tableau.error.map(round),
            dense: tableau.dense.map(|row| row.map(round)),
        }
    }
}

fn round<T: Real>((numerator, denominator): Fraction) -> T {
    T::ratio(numerator, denominator)
}

/// Exact sum of the fractions of a row; these are small enough for 128 bits.
fn sum(row: &[Fraction]) -> Fraction {
    let (mut n, mut d) = (0_i128, 1_i128);
    for &(numerator, denominator) in row {
        n = n * i128::from(denominator) + i128::from(numerator) * d;
        d *= i128::from(denominator);
        let common = gcd(n, d);
        (n, d) = (n / common, d / common);
    }
    (i64::try_from(n).unwrap_or(0), i64::try_from(d).unwrap_or(1))
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs().max(1)
}
