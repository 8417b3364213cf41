//! Adaptive Gauss–Legendre quadrature to rounding accuracy, for integrals of smooth functions and of even periodic
//! functions.

use super::trigonometry::nearest_whole;
use tripos_traits::Real;

/// Number of points of the Gauss–Legendre rule. If a panel resolves the function to 1 %, 20 points give 30 digits.
const POINTS: i64 = 20;
/// Largest number of halvings of panels in an integral. An integral over a path at distance d from a pole takes a few
/// times log₂(1/d) halvings.
const HALVINGS_LIMIT: usize = 300;

/// Adaptive Gauss–Legendre quadrature on panels (subintervals). The worst panel is halved until its
/// halves agree with the whole.
///
/// Davis & Rabinowitz, *Methods of Numerical Integration* §2.7; DLMF 3.5(v).
#[derive(Clone, Debug)]
pub(super) struct Quadrature<S> {
    /// Positive points of the rule from −1 to 1, each with its weight; the rule is symmetric about 0.
    points: Vec<(S, S)>,
}

/// Panel of an integral: a subinterval with the integrals over its two halves and an error estimate.
struct Panel<S> {
    /// Lower end of the panel, a subinterval of an integral.
    a: S,
    /// Upper end of the panel, a subinterval of an integral.
    b: S,
    /// Integrals over the two halves of the panel.
    halves: [S; 2],
    /// Absolute difference between the sum of both halves and the rule on the whole panel.
    error: f64,
}

impl<S: Real> Panel<S> {
    /// Integral over the panel: the sum of its halves.
    fn total(&self) -> S {
        self.halves[0] + self.halves[1]
    }
}

impl<S: Real> Quadrature<S> {
    /// Computes the points and weights of the Gauss–Legendre rule in the scalar `S`.
    pub(super) fn new() -> Self {
        Self { points: (1..=POINTS / 2).map(adaptive_gauss_point_and_weight).collect() }
    }

    /// Integral of f from `a` to `b`, with an error of about 16 EPSILON of ∫ |f|.
    pub(super) fn integrate(&self, f: impl Fn(S) -> S, a: S, b: S) -> S {
        let mut panels = vec![self.panel_with_error(&f, a, b, self.apply_rule(&f, a, b))];
        for _ in 0..HALVINGS_LIMIT {
            let size: f64 = panels.iter().map(|panel| panel.total().to_f64().abs()).sum();
            let worst = (0..panels.len()).max_by(|&i, &j| panels[i].error.total_cmp(&panels[j].error)).unwrap_or(0);
            // NaN is not improved by halving, so that it ends the loop, too.
            if panels[worst].error.is_nan() || panels[worst].error <= 16.0 * S::EPSILON * size {
                break;
            }
            let Panel { a, b, halves: [left, right], .. } = panels.swap_remove(worst);
            let middle = (a + b) / S::int(2);
            panels.push(self.panel_with_error(&f, a, middle, left));
            panels.push(self.panel_with_error(&f, middle, b, right));
        }
        panels.iter().fold(S::int(0), |total, panel| total + panel.total())
    }

    /// Creates the panel from `a` to `b`. `whole` is its integral by a single application of the rule.
    fn panel_with_error(&self, f: &impl Fn(S) -> S, a: S, b: S, whole: S) -> Panel<S> {
        let middle = (a + b) / S::int(2);
        let halves = [self.apply_rule(f, a, middle), self.apply_rule(f, middle, b)];
        Panel { a, b, halves, error: (halves[0] + halves[1] - whole).to_f64().abs() }
    }

    /// Integral of f from `a` to `b` by a single application of the Gauss–Legendre rule.
    fn apply_rule(&self, f: &impl Fn(S) -> S, a: S, b: S) -> S {
        let (middle, half) = ((a + b) / S::int(2), (b - a) / S::int(2));
        let sum = self.points.iter().fold(S::int(0), |sum, &(point, weight)| {
            sum + weight * (f(middle - half * point) + f(middle + half * point))
        });
        half * sum
    }
}

/// Computes the i-th largest zero x of the Legendre polynomial P_n by Newton's method, with its weight 2/((1 − x²)
/// P_n′(x)²) in the Gauss–Legendre rule.
fn adaptive_gauss_point_and_weight<S: Real>(i: i64) -> (S, S) {
    let one = S::int(1);
    let guess = (core::f64::consts::PI * (i as f64 - 0.25) / (POINTS as f64 + 0.5)).cos();
    let mut x = S::from_f64(guess);
    // The guess has 3 digits, and each Newton step doubles their number.
    for _ in 0..6 {
        let (value, slope) = legendre_value_and_slope(x);
        x = x - value / slope;
    }
    let (_, slope) = legendre_value_and_slope(x);
    (x, S::int(2) / ((one - x * x) * slope * slope))
}

/// Values P_n(x) and P_n′(x) of the Legendre polynomial of degree `POINTS`, by the recurrence k P_k = (2 k − 1) x
/// P_{k−1} − (k − 1) P_{k−2}.
fn legendre_value_and_slope<S: Real>(x: S) -> (S, S) {
    let one = S::int(1);
    let (mut before, mut value) = (one, x);
    for k in 2..=POINTS {
        let next = (S::int(2 * k - 1) * x * value - S::int(k - 1) * before) / S::int(k);
        (before, value) = (value, next);
    }
    let slope = S::int(POINTS) * (x * value - before) / (x * x - one);
    (value, slope)
}

/// Integral of an even function that repeats with `period`, from 0 to any x. The integral over a whole period is
/// computed once.
#[derive(Clone, Debug)]
pub(super) struct PeriodicIntegral<S> {
    /// Adaptive quadrature for the part beyond whole periods.
    quadrature: Quadrature<S>,
    /// Period of the function; infinite if it does not repeat.
    period: S,
    /// Integral of the function over a whole period.
    over_period: S,
}

impl<S: Real> PeriodicIntegral<S> {
    /// Creates the integral of the function that is 0 everywhere.
    pub(super) fn zero_integral() -> Self {
        let zero = S::int(0);
        Self { quadrature: Quadrature { points: Vec::new() }, period: zero, over_period: zero }
    }

    /// Creates the integral of the even function `f` with this period.
    pub(super) fn new(f: impl Fn(S) -> S, period: S) -> Self {
        let quadrature = Quadrature::new();
        let two = S::int(2);
        let over_period = two * quadrature.integrate(f, S::int(0), period / two);
        Self { quadrature, period, over_period }
    }

    /// Integral of f from 0 to x. `f` must be the function that was given to [`PeriodicIntegral::new`].
    pub(super) fn integral_to(&self, f: impl Fn(S) -> S, x: S) -> S {
        let zero = S::int(0);
        // An infinite period has no whole periods to count.
        let n = if self.period.to_f64().is_finite() { nearest_whole(x / self.period) } else { zero };
        let rest = self.quadrature.integrate(f, zero, if n == zero { x } else { x - n * self.period });
        if n == zero { rest } else { n * self.over_period + rest }
    }
}
