//! Balls: real numbers that are known up to a radius. Every result is an enclosure, with proved bounds of
//! all rounding errors.
//!
//! Invariant: the ball of a result contains the results for all numbers of the operands' balls. If a result may
//! not exist, such as √x with x of either sign or a quotient whose divisor may be 0, the ball is undefined,
//! and so are all later results.
//!
//! No function of a mathematical library is trusted: sine, cosine and exponential are series with bounds of
//! their rests, and inverse functions are checked by these. What is trusted is IEEE 754 arithmetic with
//! rounding to nearest, and the bounds of double-word arithmetic by Joldes, Muller & Popescu, ACM TOMS 44
//! (2017) 15res.
//!
//! Method: F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval arithmetic", IEEE
//! Transactions on Computers 66 (2017) 1281–1292.

mod elementary;

use super::double_double::DoubleDouble;
use super::scalar::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Factor that bounds the rounding of a radius: at most eight operations on positive doubles, each with a
/// relative error of at most 2⁻⁵³.
const UP: f64 = 1.0 + 8.0 * f64::EPSILON;
/// Bound on the loss by underflow in a product, quotient or root of centres or radii.
const TINY: f64 = 1e-285;

/// Number type of a ball's centre, with the errors of its arithmetic.
pub trait Centre: Real {
    /// Bound on the relative error of a sum, product, quotient or square root that does not underflow.
    const ROUNDING: f64;
    /// Upper bound of the absolute value.
    #[must_use]
    fn bound(self) -> f64;
    /// The same number with 32 digits.
    #[must_use]
    fn widen(self) -> DoubleDouble;
    /// The number of this type nearest to `wide`, and a bound on the distance between the two.
    #[must_use]
    fn narrow(wide: DoubleDouble) -> (Self, f64);
}

impl Centre for f64 {
    const ROUNDING: f64 = Self::EPSILON / 2.0;
    #[inline]
    fn bound(self) -> f64 {
        self.abs()
    }
    fn widen(self) -> DoubleDouble {
        DoubleDouble::from(self)
    }
    fn narrow(wide: DoubleDouble) -> (Self, f64) {
        (wide.hi(), wide.lo().abs())
    }
}

impl Centre for DoubleDouble {
    // The proved bounds are 3 · 2⁻¹⁰⁶ (sum), 5 · 2⁻¹⁰⁶ (product) and 10 · 2⁻¹⁰⁶ (quotient); the root is
    // checked by its square.
    const ROUNDING: f64 = 4.0 * Self::EPSILON;
    #[inline]
    fn bound(self) -> f64 {
        self.hi().abs() * UP
    }
    fn widen(self) -> DoubleDouble {
        self
    }
    fn narrow(wide: DoubleDouble) -> (Self, f64) {
        (wide, 0.0)
    }
}

/// All real numbers whose distance from `centre` is at most `radius`. The radius is infinite or "not a number"
/// if the number may not exist.
///
/// ```
/// use tripos_traits::{Ball, Scalar};
///
/// let third = Ball::<f64>::ratio(1, 3);
/// let one = third * Ball::int(3);
/// assert!(one.low() <= 1.0 && one.high() >= 1.0 && one.high() - one.low() < 1e-15);
/// assert!(!(one / (one - one)).is_defined());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<C = DoubleDouble> {
    /// Middle of the ball.
    pub centre: C,
    /// Largest distance of a number of the ball from its centre, never negative.
    pub radius: f64,
}

impl<C: Centre> Ball<C> {
    /// Ball of one number, with radius 0.
    #[must_use]
    #[inline]
    pub fn point(centre: C) -> Self {
        Self { centre, radius: 0.0 }
    }

    /// Ball around a centre. A radius that is negative or "not a number" makes the ball undefined.
    #[must_use]
    #[inline]
    pub fn around(centre: C, radius: f64) -> Self {
        Self { centre, radius: if radius >= 0.0 { radius } else { f64::NAN } }
    }

    /// Ball of an expression that may have no value.
    #[must_use]
    pub fn undefined() -> Self {
        Self { centre: C::from_f64(0.0), radius: f64::INFINITY }
    }

    /// Smallest ball that this type can state for all numbers from `low` to `high`.
    #[must_use]
    pub fn between(low: f64, high: f64) -> Self {
        let middle = 0.5 * low + 0.5 * high;
        let radius = (high - middle).max(middle - low);
        Self::around(C::from_f64(middle), radius * UP)
    }

    /// True if the number exists and the ball bounds it.
    #[must_use]
    #[inline]
    pub fn is_defined(self) -> bool {
        self.radius.is_finite() && self.centre.to_f64().is_finite()
    }

    /// Double below all numbers of the ball; −∞ if the ball is undefined.
    #[must_use]
    pub fn low(self) -> f64 {
        -(-self).high()
    }

    /// Double above all numbers of the ball; ∞ if the ball is undefined.
    #[must_use]
    pub fn high(self) -> f64 {
        if !self.is_defined() {
            return f64::INFINITY;
        }
        let (nearest, rest) = f64::narrow(self.centre.widen());
        let above = nearest + (self.radius + rest) * UP;
        if self.radius == 0.0 && rest == 0.0 { nearest } else { above.next_up() }
    }

    /// Upper bound of the absolute values of the numbers in the ball.
    #[must_use]
    #[inline]
    pub fn size(self) -> f64 {
        (self.centre.bound() + self.radius) * UP
    }

    /// Lower bound of the absolute values of the numbers in the ball; 0 if it contains 0.
    #[must_use]
    #[inline]
    pub fn least_size(self) -> f64 {
        // `bound` is at most this factor above the absolute value.
        let least = self.centre.bound() * (1.0 - 16.0 * f64::EPSILON) - self.radius * UP;
        if least > 0.0 { least } else { 0.0 }
    }

    /// True if all numbers of `other` are in this ball.
    #[must_use]
    pub fn contains(self, other: Self) -> bool {
        let gap = other - Self::point(self.centre);
        gap.is_defined() && self.is_defined() && gap.size() <= self.radius
    }

    /// Smallest ball that this type can state for the numbers of both balls.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        if !self.is_defined() || !other.is_defined() {
            return Self::undefined();
        }
        let gap = (other - Self::point(self.centre)).size();
        Self::around(self.centre, self.radius.max(gap))
    }

    /// The ball with a larger radius, by `more` ≥ 0.
    #[must_use]
    #[inline]
    pub fn widened(self, more: f64) -> Self {
        Self { radius: (self.radius + more) * UP, ..self }
    }

    /// The ball whose centre has 32 digits.
    #[must_use]
    pub fn wide(self) -> Ball<DoubleDouble> {
        Ball { centre: self.centre.widen(), radius: self.radius }
    }

    /// Ball of this type that contains a ball whose centre has 32 digits.
    #[must_use]
    pub fn narrowed(wide: Ball<DoubleDouble>) -> Self {
        let (centre, rest) = C::narrow(wide.centre);
        Self { centre, radius: if rest == 0.0 { wide.radius } else { (wide.radius + rest) * UP } }
    }

    /// Value of a function that is computed with 32 digits.
    fn by_wide(self, f: impl FnOnce(Ball<DoubleDouble>) -> Ball<DoubleDouble>) -> Self {
        Self::narrowed(f(self.wide()))
    }
}

impl<C: Centre> Add for Ball<C> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let centre = self.centre + other.centre;
        Self { centre, radius: (self.radius + other.radius + centre.bound() * C::ROUNDING) * UP }
    }
}

impl<C: Centre> Sub for Ball<C> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<C: Centre> Neg for Ball<C> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { centre: -self.centre, radius: self.radius }
    }
}

impl<C: Centre> Mul for Ball<C> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.centre.bound(), other.centre.bound());
        let centre = self.centre * other.centre;
        if (a == 0.0 && self.radius == 0.0) || (b == 0.0 && other.radius == 0.0) {
            // 0 times an undefined number is undefined.
            return if self.is_defined() && other.is_defined() {
                Self::point(C::from_f64(0.0))
            } else {
                Self::undefined()
            };
        }
        let radius = a * other.radius + self.radius * (b + other.radius) + centre.bound() * C::ROUNDING;
        Self { centre, radius: radius * UP + TINY }
    }
}

impl<C: Centre> Div for Ball<C> {
    type Output = Self;
    /// Quotient; undefined if the divisor may be 0.
    fn div(self, other: Self) -> Self {
        let least = other.least_size();
        if least <= 0.0 || !other.is_defined() {
            return Self::undefined();
        }
        if self.centre.bound() == 0.0 && self.radius == 0.0 {
            return self;
        }
        let centre = self.centre / other.centre;
        // |x/y − a/b| = |(x − a) − (a/b)(y − b)|/|y|, and `centre` is a/b up to its rounding.
        let quotient = centre.bound() * (1.0 + C::ROUNDING) + TINY;
        let radius = (self.radius + quotient * other.radius) / least + centre.bound() * C::ROUNDING;
        Self { centre, radius: radius * UP + TINY }
    }
}

impl<C: Centre> Scalar for Ball<C> {
    #[inline]
    fn from_f64(x: f64) -> Self {
        if x.is_finite() { Self::point(C::from_f64(x)) } else { Self::undefined() }
    }
    /// Ball of a number in decimal notation. A number with up to 45 digits after the point has a radius of
    /// some units of its last digit.
    fn decimal(text: &str) -> Self {
        let wide = DoubleDouble::decimal(text);
        Self::narrowed(Ball { centre: wide, radius: 32.0 * DoubleDouble::EPSILON * wide.bound() + TINY })
    }
    fn pi() -> Self {
        let wide = DoubleDouble::pi();
        Self::narrowed(Ball { centre: wide, radius: DoubleDouble::EPSILON * wide.bound() })
    }
    fn int(n: i64) -> Self {
        // An i64 is exact with 32 digits.
        Self::narrowed(Ball::point(DoubleDouble::int(n)))
    }
    fn ratio(numerator: i64, denominator: i64) -> Self {
        if denominator == 1 { Self::int(numerator) } else { Self::int(numerator) / Self::int(denominator) }
    }
    /// Sum of products whose roundings are bounded together: each product and each partial sum is off by at most
    /// the rounding of the sum of all sizes.
    fn sum_of_products(pairs: impl Iterator<Item = (Self, Self)> + Clone) -> Self {
        let (mut centre, mut sizes, mut radius, mut count) = (C::from_f64(0.0), 0.0, 0.0, 0.0);
        let is_zero = |x: &Self| x.radius == 0.0 && x.centre.bound() == 0.0;
        for (x, y) in pairs {
            if (is_zero(&x) && y.is_defined()) || (is_zero(&y) && x.is_defined()) {
                continue;
            }
            let (a, b) = (x.centre.bound(), y.centre.bound());
            centre = centre + x.centre * y.centre;
            sizes += a * b;
            radius += a * y.radius + x.radius * (b + y.radius);
            count += 1.0;
        }
        if count == 0.0 {
            return Self::point(C::from_f64(0.0));
        }
        let rounding = (count + 1.0) * C::ROUNDING * sizes;
        Self { centre, radius: (radius + rounding) * (UP + 2.0 * count * f64::EPSILON) + (count + 1.0) * TINY }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = elementary::sin_cos(self.wide());
        (Self::narrowed(sine), Self::narrowed(cosine))
    }
    fn sqrt(self) -> Self {
        self.by_wide(elementary::sqrt)
    }
    fn asin(self) -> Self {
        self.by_wide(elementary::asin)
    }
    fn acos(self) -> Self {
        self.by_wide(elementary::acos)
    }
    fn atan(self) -> Self {
        self.by_wide(elementary::atan)
    }
    fn exp(self) -> Self {
        self.by_wide(elementary::exp)
    }
    fn ln(self) -> Self {
        self.by_wide(elementary::ln)
    }
    fn sinh(self) -> Self {
        self.by_wide(|x| (elementary::exp(x) - elementary::exp(-x)) / Ball::int(2))
    }
    fn cosh(self) -> Self {
        self.by_wide(|x| (elementary::exp(x) + elementary::exp(-x)) / Ball::int(2))
    }
    fn tanh(self) -> Self {
        self.by_wide(elementary::tanh)
    }
    fn abs(self) -> Self {
        if !self.is_defined() || self.least_size() > 0.0 {
            if self.centre.to_f64() < 0.0 { -self } else { self }
        } else {
            let half = 0.5 * self.size();
            Self { centre: C::from_f64(half), radius: half * UP }
        }
    }
    fn sign(self) -> Self {
        if !self.is_defined() {
            Self::undefined()
        } else if self.least_size() > 0.0 {
            Self::point(C::from_f64(self.centre.to_f64().signum()))
        } else if self.size() == 0.0 {
            Self::point(C::from_f64(0.0))
        } else {
            Self { centre: C::from_f64(0.0), radius: 1.0 }
        }
    }
    fn sinc(self) -> Self {
        if self.least_size() > 0.0 {
            return self.sin_cos().0 / self;
        }
        // 0 ≤ 1 − sin x/x ≤ x²/6.
        let sixth = (self.size() * self.size() / 12.0) * UP;
        Self::point(C::from_f64(1.0)) - Self { centre: C::from_f64(sixth), radius: sixth * UP }
    }
}
