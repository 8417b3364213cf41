//! Gauss–Legendre rule with 24 points on a panel, and series of Legendre polynomials.

use std::sync::OnceLock;

use tripos_traits::{DoubleDouble, Lanes, Real, Scalar};

/// Number of points of the Gauss–Legendre rule, and number of terms of a Legendre series.
pub(super) const POINTS: usize = 24;

/// Half of the number of points of the Gauss–Legendre rule.
const HALF: usize = POINTS / 2;

/// Function on a panel, stored as its values at the points of the rule or as its Legendre coefficients.
pub(super) type Series = [f64; POINTS];

/// Values P₀(x) … P_n(x) of Legendre polynomials at a point x, with n = [`POINTS`].
pub(super) type LegendreValues = [f64; POINTS + 1];

/// Gauss–Legendre rule on the interval from −1 to 1, prepared to compute the coefficients of Legendre
/// series.
pub(super) struct LegendreRule {
    /// Points of the rule, the zeros of P_n, in increasing order.
    pub(super) points: Series,
    /// Factors (k + ½) wᵢ P_k(xᵢ) of point i in the coefficients of a series, in row i: first for even k, then for odd
    /// k. They multiply the sum (even k) or difference (odd k) of the values at point i and at the opposite point.
    shares: [[[f64; HALF]; 2]; HALF],
    /// Factors (2 k + 1)/(k + 1) and k/(k + 1) of the recurrence of Legendre polynomials, for each k.
    recurrence: [[f64; 2]; POINTS],
}

impl LegendreRule {
    /// Returns the rule that the whole program shares. Its points and weights are computed in 32 digits at the first
    /// call.
    pub(super) fn shared_rule() -> &'static Self {
        static RULE: OnceLock<LegendreRule> = OnceLock::new();
        RULE.get_or_init(Self::new)
    }

    /// Computes the points, shares and recurrence factors of the rule.
    fn new() -> Self {
        let mut rule = Self { points: [0.0; POINTS], shares: [[[0.0; HALF]; 2]; HALF], recurrence: [[0.0; 2]; POINTS] };
        for (k, factors) in rule.recurrence.iter_mut().enumerate() {
            *factors = [(2 * k + 1) as f64 / (k + 1) as f64, k as f64 / (k + 1) as f64];
        }
        let one = DoubleDouble::int(1);
        for i in 0..HALF {
            let guess = (std::f64::consts::PI * (i as f64 + 0.75) / (POINTS as f64 + 0.5)).cos();
            let mut x = DoubleDouble::from_f64(-guess);
            // Newton's method: the guess has 3 digits, and each step doubles their number.
            for _ in 0..5 {
                let p = legendre_values(x);
                x = x - p[POINTS] / legendre_slope(x, &p);
            }
            let p = legendre_values(x);
            let slope = legendre_slope(x, &p);
            let weight = DoubleDouble::int(2) / ((one - x * x) * slope * slope);
            (rule.points[i], rule.points[POINTS - 1 - i]) = (x.to_f64(), -x.to_f64());
            for (k, p) in p[..POINTS].iter().enumerate() {
                rule.shares[i][k % 2][k / 2] = (*p * weight).to_f64() * (k as f64 + 0.5);
            }
        }
        rule
    }

    /// Coefficients c_k of the Legendre series Σ c_k P_k that takes these values at the points of the rule.
    pub(super) fn coefficients(&self, values: &Series) -> Series {
        let (even, odd) = Lanes::<4>::dispatch(
            #[inline(always)]
            || self.even_and_odd_coefficients(values),
        );
        std::array::from_fn(|k| if k % 2 == 0 { even[k / 2] } else { odd[k / 2] })
    }

    /// Coefficients of the even and of the odd Legendre polynomials in the series that takes these values at the points
    /// of the rule.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]
    fn even_and_odd_coefficients(&self, values: &Series) -> ([f64; HALF], [f64; HALF]) {
        let (mut even, mut odd) = ([0.0; HALF], [0.0; HALF]);
        for (i, [of_even, of_odd]) in self.shares.iter().enumerate() {
            let (left, right) = (values[i], values[POINTS - 1 - i]);
            let (sum, difference) = (left + right, left - right);
            for l in 0..HALF {
                even[l] += sum * of_even[l];
                odd[l] += difference * of_odd[l];
            }
        }
        (even, odd)
    }

    /// Values of the Legendre polynomials P₀ … P_n at `x`, by (k + 1) P_{k+1} = (2 k + 1) x P_k − k
    /// P_{k−1}.
    pub(super) fn values(&self, x: f64) -> LegendreValues {
        let mut p = [1.0; POINTS + 1];
        p[1] = x;
        for k in 1..POINTS {
            let [a, b] = self.recurrence[k];
            p[k + 1] = a * x * p[k] - b * p[k - 1];
        }
        p
    }
}

/// Coefficients of the Legendre series of the integral ∫₋₁ˣ Σ c_k P_k, by (2 k + 1) P_k = P′_{k+1} −
/// P′_{k−1}.
pub(super) fn integrated_series(c: &Series) -> LegendreValues {
    let mut d = [0.0; POINTS + 1];
    d[0] = c[0];
    for (k, c) in c.iter().enumerate() {
        let share = c / (2 * k + 1) as f64;
        d[k + 1] += share;
        if k > 0 {
            d[k - 1] -= share;
        }
    }
    d
}

/// Dot product Σ cᵢ xᵢ, computed as four partial sums for vector instructions.
pub(super) fn dot_of_legendre_series(c: &[f64], x: &[f64]) -> f64 {
    let (c, c_rest) = c.as_chunks::<4>();
    let (x, x_rest) = x.as_chunks::<4>();
    let mut sum = [0.0; 4];
    for (c, x) in c.iter().zip(x) {
        for l in 0..4 {
            sum[l] += c[l] * x[l];
        }
    }
    let rest: f64 = c_rest.iter().zip(x_rest).map(|(c, x)| c * x).sum();
    (sum[0] + sum[2]) + (sum[1] + sum[3]) + rest
}

/// Values of the Legendre polynomials P₀ … P_n at `x` in double-double numbers.
fn legendre_values(x: DoubleDouble) -> [DoubleDouble; POINTS + 1] {
    let mut p = [DoubleDouble::int(1); POINTS + 1];
    p[1] = x;
    for (k, n) in (1..POINTS).zip(1_i64..) {
        p[k + 1] =
            (DoubleDouble::int(2 * n + 1) * x * p[k] - DoubleDouble::int(n) * p[k - 1]) / DoubleDouble::int(n + 1);
    }
    p
}

/// Slope P_n′(x) of the last Legendre polynomial, by (x² − 1) P_n′ = n (x P_n − P_{n−1}). `p` has the values of all
/// polynomials at `x`.
fn legendre_slope(x: DoubleDouble, p: &[DoubleDouble; POINTS + 1]) -> DoubleDouble {
    DoubleDouble::from_f64(POINTS as f64) * (x * p[POINTS] - p[POINTS - 1]) / (x * x - DoubleDouble::int(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: a polynomial of degree 23 equals its series, and its integral equals the series of the integral. The
    /// tested polynomial is x²³, whose series has 24 terms of size 1.
    #[test]
    fn series_of_a_polynomial_and_of_its_integral_are_exact() {
        let rule = LegendreRule::shared_rule();
        let c = rule.coefficients(&rule.points.map(|x| 24.0 * x.powi(23)));
        let d = integrated_series(&c);
        for x in [-1.0, -0.7, 0.0, 0.3, 1.0_f64] {
            let p = rule.values(x);
            assert!((dot_of_legendre_series(&c, &p[..POINTS]) - 24.0 * x.powi(23)).abs() < 24.0 * 8.0 * f64::EPSILON);
            assert!((dot_of_legendre_series(&d, &p) - (x.powi(24) - 1.0)).abs() < 8.0 * f64::EPSILON, "{x}");
        }
    }
}
