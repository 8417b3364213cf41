//! Elliptic integrals and Jacobi's elliptic functions by the arithmetic–geometric mean, in any scalar.
//!
//! NIST *Digital Library of Mathematical Functions* §19.8(i) (the mean), §22.20(ii) (Jacobi's
//! functions), and Abramowitz & Stegun 17.6 (the incomplete integral).

use super::trigonometry::nearest_whole;
use tripos_traits::Real;

/// Largest number of steps of the arithmetic–geometric mean. No scalar type needs so many, since each step doubles the
/// digits.
const STEPS_LIMIT: usize = 40;

/// Elliptic functions of one parameter m = k² in [0, 1].
///
/// ```
/// use tripos_sim::exact::Elliptic;
///
/// let elliptic = Elliptic::new(0.5_f64);
/// assert!((elliptic.quarter_period() - 1.854_074_677_301_371_9).abs() < 1e-15); // Γ(1/4)²/(4√π)
/// assert!((elliptic.jacobi_functions(elliptic.quarter_period()).sn - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Debug)]
pub struct Elliptic<S> {
    /// Parameter m = k² of the elliptic functions.
    parameter: S,
    /// Complementary parameter 1 − m of the elliptic functions.
    complement: S,
    /// Steps of the arithmetic–geometric mean from a₀ = 1 and b₀ = √(1 − m); none for m = 1 or an invalid
    /// m.
    steps: Vec<Step<S>>,
}

/// Step n of the arithmetic–geometric mean, from aₙ and bₙ to aₙ₊₁ and bₙ₊₁.
#[derive(Clone, Copy, Debug)]
struct Step<S> {
    /// Arithmetic mean aₙ₊₁ = (aₙ + bₙ)/2 after step n of the arithmetic–geometric mean.
    mean: S,
    /// Geometric mean bₙ before step n of the arithmetic–geometric mean.
    geometric: S,
    /// Ratio cₙ₊₁/aₙ₊₁ of step n of the arithmetic–geometric mean, where cₙ₊₁ = (aₙ − bₙ)/2.
    ratio: S,
}

/// Values of Jacobi's elliptic functions at an argument u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiValues<S> {
    /// Elliptic sine sn u = sin am u.
    pub sn: S,
    /// Elliptic cosine cn u = cos am u.
    pub cn: S,
    /// Delta amplitude dn u = √(1 − m sn² u) of the argument u, positive.
    pub dn: S,
    /// Amplitude am u, rad, which grows by π whenever u grows by 2 K, with the quarter period K.
    pub am: S,
}

impl<S: Real> Elliptic<S> {
    /// Creates the elliptic functions of a parameter m from 0 to 1. For other m all results are NaN.
    #[must_use]
    pub fn new(m: S) -> Self {
        Self::with_complement(m, S::int(1) - m)
    }

    /// Creates the elliptic functions from the parameter m and its complement 1 − m, whose digits matter near m = 1.
    /// For m outside 0 to 1 all results are NaN.
    #[must_use]
    pub fn with_complement(m: S, complement: S) -> Self {
        let zero = S::int(0);
        // For m outside [0, 1], or NaN, all results are NaN.
        let complement = if m >= zero && complement >= zero { complement } else { S::from_f64(f64::NAN) };
        let steps = if complement > zero { mean_steps(complement) } else { Vec::new() };
        Self { parameter: m, complement, steps }
    }

    /// Complete integral K = ∫₀^{π/2} dφ/√(1 − m sin² φ), a quarter of the period of sn; infinite for m = 1.
    #[must_use]
    pub fn quarter_period(&self) -> S {
        S::pi() / (S::int(2) * self.mean())
    }

    /// Complementary parameter 1 − m of the elliptic functions.
    #[must_use]
    pub fn complement(&self) -> S {
        self.complement
    }

    /// Arithmetic–geometric mean of 1 and √(1 − m); 0 for m = 1.
    fn mean(&self) -> S {
        // Without steps the mean is 0 for m = 1, or NaN.
        self.steps.last().map_or(self.complement, |step| step.mean)
    }

    /// Computes Jacobi's functions sn, cn, dn and the amplitude am of the argument u. Their absolute error is the error
    /// of u, which is at least |u| EPSILON.
    #[must_use]
    pub fn jacobi_functions(&self, u: S) -> JacobiValues<S> {
        if self.steps.is_empty() {
            return self.jacobi_of_parameter_one(u);
        }
        // am(u + 2 n K) = am u + n π.
        let half_period = S::int(2) * self.quarter_period();
        let n = nearest_whole(u / half_period);
        let reduced = self.amplitude_within_half_period(u - n * half_period);
        let (sn, cn) = reduced.sin_cos();
        // (−1)ⁿ: sn and cn change sign with each half period.
        let sign = if (n.to_f64() / 2.0).fract() == 0.0 { S::int(1) } else { S::int(-1) };
        // dn² = 1 − m sn² = (1 − m) + m cn², without cancellation.
        let dn = (self.complement + self.parameter * cn * cn).sqrt();
        JacobiValues { sn: sign * sn, cn: sign * cn, dn, am: reduced + n * S::pi() }
    }

    /// Amplitude am u, rad, by the descending Landen transformation: from φ_N = 2ᴺ a_N u back by sin(2φₙ −
    /// φₙ₊₁) = (cₙ₊₁/aₙ₊₁) sin φₙ₊₁. The argument u lies within half a period of 0.
    fn amplitude_within_half_period(&self, u: S) -> S {
        let doublings = self.steps.iter().fold(u, |u, _| u + u);
        self.steps.iter().rev().fold(doublings * self.mean(), |phi, step| {
            let (sin, _) = phi.sin_cos();
            (phi + (step.ratio * sin).asin()) / S::int(2)
        })
    }

    /// Jacobi's functions for m = 1: sn = tanh u, cn = dn = 1/cosh u, and am is the Gudermannian of u. NaN for an
    /// invalid m.
    fn jacobi_of_parameter_one(&self, u: S) -> JacobiValues<S> {
        // The complement is 0 or NaN, so that an invalid m gives NaN.
        let u = u + self.complement;
        let [one, two] = [1, 2].map(S::int);
        let sech = one / u.cosh();
        JacobiValues { sn: u.tanh(), cn: sech, dn: sech, am: two * (u / two).tanh().atan() }
    }

    /// Incomplete integral F(φ) = ∫₀^φ dφ'/√(1 − m sin² φ') of the amplitude φ, rad; the inverse of am.
    /// For m = 1 it is valid only for |φ| < π/2.
    #[must_use]
    pub fn incomplete_integral(&self, phi: S) -> S {
        if self.steps.is_empty() {
            let (sin, cos) = (phi + self.complement).sin_cos();
            let size = ((S::int(1) + sin.abs()) / cos).ln();
            return size * sin.sign();
        }
        let mut phi = phi;
        let mut arithmetic = S::int(1);
        for step in &self.steps {
            // tan(φₙ₊₁ − φₙ) = (bₙ/aₙ) tan φₙ, with φₙ₊₁ near 2 φₙ at any φ: the small difference is an arctangent.
            let (sin, cos) = phi.sin_cos();
            let rest = (arithmetic - step.geometric) * sin * cos;
            phi = phi + phi - (rest / (arithmetic * cos * cos + step.geometric * sin * sin)).atan();
            arithmetic = step.mean;
        }
        let halvings = self.steps.iter().fold(phi, |phi, _| phi / S::int(2));
        halvings / self.mean()
    }
}

/// Steps of the arithmetic–geometric mean of 1 and √`complement`, until further changes are below rounding. None for an
/// invalid complement.
fn mean_steps<S: Real>(complement: S) -> Vec<Step<S>> {
    let two = S::int(2);
    let (mut a, mut b) = (S::int(1), complement.sqrt());
    let mut steps = Vec::new();
    for _ in 0..STEPS_LIMIT {
        let (mean, difference) = ((a + b) / two, (a - b) / two);
        let ratio = difference / mean;
        steps.push(Step { mean, geometric: b, ratio });
        // The next ratio would be a quarter of the square of this ratio; it bounds the remaining change of mean and
        // amplitude.
        if ratio.to_f64().powi(2) <= S::EPSILON / 16.0 {
            break;
        }
        (a, b) = (mean, (a * b).sqrt());
    }
    steps
}
