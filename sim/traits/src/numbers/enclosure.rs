//! Enclosure of a function over a range of its argument: the range of its values, and the range of
//! its derivative.
//!
//! Values and derivatives go through every operation by the rules of differentiation, in intervals
//! that are rounded outwards. If x may have either sign, the slope of |x| lies between those of its
//! branches, so that the mean value theorem holds. The sign of x jumps at 0, so its slope there may
//! be any number.

use super::interval::Interval;
use crate::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Range of the values of a function over a range of its argument, and range of its derivative
/// there.
///
/// ```
/// use tripos_traits::{Enclosure, Interval, Scalar};
///
/// // x from 1 to 2, by itself: x² − x is 0 to 3 there, and rises with 1 to 3.
/// let x = Enclosure { value: Interval::new(1.0, 2.0), slope: Interval::point(1.0) };
/// let g = x * x - x;
/// assert!(g.value.lo() <= 0.0 && g.value.hi() >= 2.0);
/// assert!(g.slope.excludes_zero());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Interval that contains all values of the function.
    pub value: Interval,
    /// Interval that contains all derivatives of the function.
    pub slope: Interval,
}

impl Enclosure {
    /// Enclosure of a constant, whose derivative is 0.
    #[must_use]
    pub fn constant(value: Interval) -> Self {
        Self { value, slope: Interval::ZERO }
    }

    /// Enclosure of f(x) for this enclosure x, by the chain rule: `value` contains f(x), `derivative`
    /// contains df/dx.
    fn chain(self, value: Interval, derivative: Interval) -> Self {
        if value.is_undefined() {
            return Self { value, slope: Interval::UNDEFINED };
        }
        // A constant has the slope 0, even where the function is infinitely steep.
        let slope = if self.slope == Interval::ZERO { Interval::ZERO } else { derivative * self.slope };
        Self { value, slope }
    }
}

impl Add for Enclosure {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Enclosure {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Neg for Enclosure {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Mul for Enclosure {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let slope = if self.slope == Interval::ZERO {
            self.value * other.slope
        } else if other.slope == Interval::ZERO {
            self.slope * other.value
        } else {
            self.slope * other.value + self.value * other.slope
        };
        Self { value, slope }
    }
}

impl Div for Enclosure {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self * other.powi(-1)
    }
}

impl Scalar for Enclosure {
    fn from_f64(x: f64) -> Self {
        Self::constant(Interval::point(x))
    }
    fn decimal(text: &str) -> Self {
        Self::constant(text.parse().map_or(Interval::UNDEFINED, Interval::rounded))
    }
    fn pi() -> Self {
        Self::constant(Interval::rounded(core::f64::consts::PI))
    }
    fn int(n: i64) -> Self {
        Self::ratio(n, 1)
    }
    fn ratio(numerator: i64, denominator: i64) -> Self {
        // A whole number up to 2⁵³ is exact.
        let part = |n: i64| {
            let x = n as f64;
            if n.unsigned_abs() <= 1 << 53 { Interval::point(x) } else { Interval::rounded(x) }
        };
        Self::constant(if denominator == 1 { part(numerator) } else { part(numerator) / part(denominator) })
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, (root + root).powi(-1))
    }
    fn asin(self) -> Self {
        self.chain(self.value.asin(), slope_of_asin(self.value))
    }
    fn acos(self) -> Self {
        self.chain(self.value.acos(), -slope_of_asin(self.value))
    }
    fn atan(self) -> Self {
        self.chain(self.value.atan(), (Interval::point(1.0) + self.value.powi(2)).powi(-1))
    }
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    fn ln(self) -> Self {
        self.chain(self.value.ln(), self.value.powi(-1))
    }
    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }
    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.chain(value, Interval::point(1.0) - value.powi(2))
    }
    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.sign())
    }
    fn sign(self) -> Self {
        let jumps = !self.value.excludes_zero();
        self.chain(self.value.sign(), if jumps { Interval::WHOLE } else { Interval::ZERO })
    }
    fn powi(self, n: i32) -> Self {
        let by = Interval::point(f64::from(n));
        match n {
            0 => Self::constant(self.value.powi(0)),
            1 => self,
            _ => self.chain(self.value.powi(n), by * self.value.powi(n.saturating_sub(1))),
        }
    }
}

/// Derivative 1/√(1 − x²) of the inverse sine, as an interval.
fn slope_of_asin(x: Interval) -> Interval {
    let square = Interval::point(1.0) - x.powi(2);
    Interval::new(square.lo().max(0.0), square.hi()).sqrt().powi(-1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A generator of numbers in [0, 1): the same ones on every machine (Knuth's MMIX constants).
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    type UnaryFunction<S> = fn(S) -> S;

    /// A function's name, the function in numbers and in ranges, and its derivative.
    type Case = (&'static str, UnaryFunction<f64>, UnaryFunction<Enclosure>, UnaryFunction<f64>);

    fn functions() -> [Case; 15] {
        [
            ("sin", |x| x.sin_cos().0, |x| x.sin_cos().0, |x| x.sin_cos().1),
            ("cos", |x| x.sin_cos().1, |x| x.sin_cos().1, |x| -x.sin_cos().0),
            ("sqrt", Scalar::sqrt, Scalar::sqrt, |x| 0.5 / Scalar::sqrt(x)),
            ("exp", Scalar::exp, Scalar::exp, Scalar::exp),
            ("ln", Scalar::ln, Scalar::ln, |x| 1.0 / x),
            ("asin", Scalar::asin, Scalar::asin, |x| 1.0 / Scalar::sqrt(1.0 - x * x)),
            ("acos", Scalar::acos, Scalar::acos, |x| -1.0 / Scalar::sqrt(1.0 - x * x)),
            ("atan", Scalar::atan, Scalar::atan, |x| 1.0 / (1.0 + x * x)),
            ("sinh", Scalar::sinh, Scalar::sinh, Scalar::cosh),
            ("cosh", Scalar::cosh, Scalar::cosh, Scalar::sinh),
            ("tanh", Scalar::tanh, Scalar::tanh, |x| 1.0 - Scalar::tanh(x) * Scalar::tanh(x)),
            ("abs", Scalar::abs, Scalar::abs, Scalar::sign),
            ("x^2", |x| Scalar::powi(x, 2), |x| x.powi(2), |x| 2.0 * x),
            ("x^3", |x| Scalar::powi(x, 3), |x| x.powi(3), |x| 3.0 * x * x),
            ("x^-3", |x| Scalar::powi(x, -3), |x| x.powi(-3), |x| -3.0 / Scalar::powi(x, 4)),
        ]
    }

    fn holds(range: Interval, x: f64) -> bool {
        range.lo() <= x && x <= range.hi()
    }

    /// Goal: no value and no slope outside of its range. Method: ranges of every width about seeded places, at 20
    /// points each; what numbers err by is far below the margin but where they cancel, which is allowed 1e-14.
    #[test]
    fn values_and_slopes_of_functions_lie_in_their_ranges() {
        let mut numbers = Numbers(3);
        let mut checked = [0; 15];
        for trial in 0..4000 {
            let middle = [2.0, 20.0, 0.9][trial % 3] * (2.0 * numbers.next() - 1.0);
            let radius = [1e-9, 1e-3, 0.3, 2.0][trial % 4] * numbers.next();
            let value = Interval::new(middle - radius, middle + radius);
            let x = Enclosure { value, slope: Interval::point(1.0) };
            for (at, (name, f, in_ranges, slope)) in functions().into_iter().enumerate() {
                let range = in_ranges(x);
                for _ in 0..20 {
                    let point = (middle + radius * (2.0 * numbers.next() - 1.0)).clamp(value.lo(), value.hi());
                    let (y, s) = (f(point), slope(point));
                    if range.value.is_undefined() || y.is_nan() {
                        continue;
                    }
                    checked[at] += 1;
                    assert!(holds(range.value, y), "{name}({point}) = {y}: {:?}", range.value);
                    let near = Interval::around(s, 1e-14 * (1.0 + s.abs()));
                    let meets = near.lo() <= range.slope.hi() && range.slope.lo() <= near.hi();
                    assert!(meets || !s.is_finite(), "{name}'({point}) = {s}: {:?}", range.slope);
                }
            }
        }
        assert!(checked.iter().all(|count| *count > 5000), "{checked:?}");
    }

    #[test]
    fn ranges_are_not_much_wider_than_the_values() {
        let of = |lo: f64, hi: f64| Enclosure { value: Interval::new(lo, hi), slope: Interval::point(1.0) };
        assert!(of(0.1, 0.2).sin_cos().0.value.width() < 0.1);
        let over_a_top = of(1.5, 1.7).sin_cos();
        assert!(
            over_a_top.0.value.hi() >= 1.0 && over_a_top.0.value.lo() > 0.99 && !over_a_top.0.slope.excludes_zero()
        );
        assert!(of(-1.0, 2.0).powi(2).value == Interval::new(0.0, of(2.0, 2.0).powi(2).value.hi()));
        assert!(of(-1.0, 2.0).powi(2).sqrt().value.lo() >= 0.0, "a square is nowhere negative");
        assert!(of(3.0, 3.0).exp().value.width() < 1e-13);
    }

    /// Poles, kinks, jumps and places without a value are told from all else.
    #[test]
    fn what_is_not_smooth_is_told() {
        let of = |lo: f64, hi: f64| Enclosure { value: Interval::new(lo, hi), slope: Interval::point(1.0) };
        assert!(of(-1.0, 1.0).powi(-1).value == Interval::WHOLE);
        assert!(of(-1.0, 1.0).powi(-2).value.excludes_zero() && !of(-1.0, 1.0).powi(-2).value.is_finite());
        assert!(of(-0.1, 1.0).sqrt().value.is_undefined() && of(-0.1, 1.0).ln().value.is_undefined());
        assert!((of(-0.1, 1.0).sqrt().exp() + of(1.0, 2.0)).value.is_undefined());
        assert!(of(-2.0, -1.5).asin().value.is_undefined());
        let kink = of(-0.5, 1.0).abs();
        assert_eq!(kink.value, Interval::new(0.0, 1.0));
        assert!(holds(kink.slope, -1.0) && holds(kink.slope, 1.0) && kink.slope.size() < 1.000_001);
        assert!(!of(-0.5, 1.0).sign().slope.is_finite() && of(0.5, 1.0).sign().slope == Interval::ZERO);
        // A jump between two finite values has no bounded slope.
        assert!(!of(-1.0, 1.0).powi(-1).atan().slope.is_finite());
    }

    #[test]
    fn exact_constants_are_exact_and_others_enclosed() {
        assert!(Enclosure::ratio(3, 1).value.width() <= 0.0);
        let tenth = Enclosure::ratio(1, 10).value;
        assert!(tenth.lo() < 0.1 && 0.1 < tenth.hi());
        let pi = Enclosure::pi().value;
        assert!(pi.lo() < core::f64::consts::PI && core::f64::consts::PI < pi.hi());
        let decimal = Enclosure::decimal("0.1").value;
        assert!(holds(decimal, 0.1) && Enclosure::decimal("tenth").value.is_undefined());
    }
}
