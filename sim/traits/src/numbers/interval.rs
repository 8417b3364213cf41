//! Intervals: ranges of numbers that are not known exactly. Every operation is rounded outwards.
//!
//! Invariant: the range of a result contains the results for all numbers from the ranges of the
//! operands. If a result may not exist, such as √x with x of either sign, both ends are "not a
//! number", and so are all later results. A division by a range that contains 0 has an infinite
//! end.
//!
//! R. E. Moore, R. B. Kearfott & M. J. Cloud, *Introduction to Interval Analysis* (2009), §2 and
//! §5.

use core::f64::consts::PI;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Bound on the relative error of an elementary function of `libm`; several times the true error.
const LIBRARY: f64 = 4.0 * f64::EPSILON;
/// Largest angle, rad, whose sine and cosine are bounded. For larger angles the range is −1 to 1.
const FAR: f64 = 1e9;

/// Range of all numbers from `lo` to `hi`, which may be infinite. Both ends are "not a number" if
/// there may be no value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// Number slightly below x, as a lower bound for a rounded result x. 0 stays 0, because sums that
/// are 0 are exact.
#[inline]
fn down(x: f64) -> f64 {
    let below = x - x.abs() * f64::EPSILON;
    if below < x { below } else { just_below(x) }
}

/// Largest f64 below x; 0 stays 0, because products with 0 are exact.
fn just_below(x: f64) -> f64 {
    if x == 0.0 { x } else { x.next_down() }
}

/// Number slightly above x, as an upper bound for a rounded result x; 0 stays 0.
#[inline]
fn up(x: f64) -> f64 {
    -down(-x)
}

/// Product of two ends of ranges. 0 times any number, even infinity, is 0. A product that
/// underflows keeps its sign and is not 0.
#[inline]
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let p = a * b;
    if p == 0.0 { f64::from_bits(1).copysign(p) } else { p }
}

impl Interval {
    /// Range of all real numbers, from −∞ to ∞.
    pub const WHOLE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// Range of an expression that may have no value: both ends are "not a number".
    pub const UNDEFINED: Self = Self { lo: f64::NAN, hi: f64::NAN };
    /// Range that contains only 0.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// Range between two numbers in any order; undefined if either is "not a number".
    #[must_use]
    pub fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::UNDEFINED } else { Self { lo: a.min(b), hi: a.max(b) } }
    }

    /// Range that contains only x.
    #[must_use]
    pub fn point(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// Range of all numbers that may have been rounded to x: x and its neighbouring f64.
    #[must_use]
    pub fn rounded(x: f64) -> Self {
        Self { lo: x.next_down(), hi: x.next_up() }
    }

    /// Range of all numbers within `radius` of `middle`, rounded outwards.
    #[must_use]
    pub fn around(middle: f64, radius: f64) -> Self {
        Self::outwards(middle - radius, middle + radius)
    }

    /// Lower end of the range.
    #[must_use]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// Upper end of the range.
    #[must_use]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Difference between the upper and the lower end of the range.
    #[must_use]
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }

    /// Largest absolute value of the numbers in the range.
    #[must_use]
    pub fn size(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// True if the range does not contain 0; false if it does, or if the expression may have no value.
    #[must_use]
    pub fn excludes_zero(self) -> bool {
        self.lo > 0.0 || self.hi < 0.0
    }

    /// True if both ends are finite, so that the expression has a value and all its values are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// True if the expression may have no value; both ends are then "not a number".
    #[must_use]
    pub fn is_undefined(self) -> bool {
        self.lo.is_nan()
    }

    /// Intersection of two ranges that contain the same number. Returns this range if they do not
    /// overlap or if either is undefined.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        let both = Self { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) };
        // Two ranges of the same number that do not overlap are both wrong by rounding.
        if both.lo <= both.hi && !self.is_undefined() && !other.is_undefined() { both } else { self }
    }

    /// Range from lo to hi, with both ends rounded outwards.
    fn outwards(lo: f64, hi: f64) -> Self {
        Self { lo: down(lo), hi: up(hi) }
    }

    /// Range of the product k x for a number k and this range of x.
    fn times(self, k: f64) -> Self {
        if k - 1.0 == 0.0 {
            return self;
        }
        let (a, b) = (product(k, self.lo), product(k, self.hi));
        Self::outwards(a.min(b), a.max(b))
    }

    /// True if the range contains 0; false if the expression may have no value.
    fn has_zero(self) -> bool {
        self.lo <= 0.0 && self.hi >= 0.0
    }

    /// Range of f(x) for an increasing function f: from its value at the lower end of x to that at the
    /// upper end. Undefined if f has no value at an end.
    fn rising(self, f: impl Fn(f64) -> f64) -> Self {
        let (lo, hi) = (f(self.lo), f(self.hi));
        if lo.is_nan() || hi.is_nan() {
            return Self::UNDEFINED;
        }
        let wide = |x: f64| if x.is_finite() { LIBRARY * x.abs() } else { 0.0 };
        Self::outwards(lo - wide(lo), hi + wide(hi))
    }

    /// Limits both ends to the interval from `low` to `high`; an undefined range stays undefined.
    fn restricted(self, low: f64, high: f64) -> Self {
        if self.is_undefined() { self } else { Self { lo: self.lo.max(low), hi: self.hi.min(high) } }
    }

    /// Range of the reciprocal 1/x; undefined if x is exactly 0, all numbers if x may have either sign.
    fn reciprocal(self) -> Self {
        if self.is_undefined() || (self.lo == 0.0 && self.hi == 0.0) {
            Self::UNDEFINED
        } else if self.lo == 0.0 {
            Self { lo: down(1.0 / self.hi), hi: f64::INFINITY }
        } else if self.hi == 0.0 {
            Self { lo: f64::NEG_INFINITY, hi: up(1.0 / self.lo) }
        } else if self.has_zero() {
            Self::WHOLE
        } else {
            Self::outwards(1.0 / self.hi, 1.0 / self.lo)
        }
    }

    /// Range of cos x. It reaches 1 or −1 if x contains an even or odd multiple of π; else it spans the
    /// values at the ends of x.
    fn cos(self) -> Self {
        self.wave(0.0, libm::cos)
    }

    /// Range of sin x, x in rad.
    fn sin(self) -> Self {
        self.wave(0.5, libm::sin)
    }

    /// Range of `f`, which must be cos(x − `shift` π): 1 at even, −1 at odd multiples of π, all
    /// moved by `shift` · π.
    fn wave(self, shift: f64, f: impl Fn(f64) -> f64) -> Self {
        const ALL: Interval = Interval { lo: -1.0, hi: 1.0 };
        if self.is_undefined() {
            return self;
        }
        if self.size() > FAR || self.width() >= 2.0 * PI {
            return ALL;
        }
        // A multiple of π next to an end counts as inside.
        let slack = 4.0 * f64::EPSILON * (1.0 + self.size());
        let first = libm::ceil(self.lo / PI - shift - slack);
        let last = libm::floor(self.hi / PI - shift + slack);
        let (a, b) = (f(self.lo), f(self.hi));
        let ends = Self::outwards(a.min(b) - LIBRARY, a.max(b) + LIBRARY);
        let even = |n: f64| n % 2.0 == 0.0;
        let both = last - first >= 1.0;
        let top = both || (first <= last && even(first));
        let bottom = both || (first <= last && !even(first));
        let (lo, hi) = (if bottom { -1.0 } else { ends.lo }, if top { 1.0 } else { ends.hi });
        Self { lo, hi }.restricted(-1.0, 1.0)
    }

    /// Ranges of (sin x, cos x), x in rad.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Range of √x; undefined if x may be negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.lo >= 0.0 { self.rising(libm::sqrt).restricted(0.0, f64::INFINITY) } else { Self::UNDEFINED }
    }

    /// Range of the inverse sine of x, rad, in [−π/2, π/2]; undefined if |x| may exceed 1.
    #[must_use]
    pub fn asin(self) -> Self {
        self.rising(libm::asin)
    }

    /// Range of the inverse cosine of x, rad, in [0, π]; undefined if |x| may exceed 1.
    #[must_use]
    pub fn acos(self) -> Self {
        // acos decreases, so −acos increases.
        -self.rising(|x| -libm::acos(x))
    }

    /// Range of the inverse tangent of x, rad.
    #[must_use]
    pub fn atan(self) -> Self {
        self.rising(libm::atan)
    }

    /// Range of the exponential eˣ; the lower end is at least 0.
    #[must_use]
    pub fn exp(self) -> Self {
        self.rising(libm::exp).restricted(0.0, f64::INFINITY)
    }

    /// Range of the natural logarithm of x; undefined if x may be negative.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.lo >= 0.0 { self.rising(libm::log) } else { Self::UNDEFINED }
    }

    /// Range of the hyperbolic sine of x.
    #[must_use]
    pub fn sinh(self) -> Self {
        self.rising(libm::sinh)
    }

    /// Range of the hyperbolic cosine of x.
    #[must_use]
    pub fn cosh(self) -> Self {
        // cosh x = cosh |x|, which rises.
        self.abs().rising(libm::cosh).restricted(1.0, f64::INFINITY)
    }

    /// Range of the hyperbolic tangent of x.
    #[must_use]
    pub fn tanh(self) -> Self {
        self.rising(libm::tanh).restricted(-1.0, 1.0)
    }

    /// Range of the absolute value |x|.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.lo >= 0.0 || self.is_undefined() {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Self { lo: 0.0, hi: self.size() }
        }
    }

    /// Range of the sign of x, which is −1, 0 or 1.
    #[must_use]
    pub fn sign(self) -> Self {
        let of = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
        Self { lo: of(self.lo), hi: of(self.hi) }
    }

    /// Range of xⁿ; n may be negative, and then x must not be exactly 0.
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        match n {
            i32::MIN..=-1 => self.raised(n.unsigned_abs()).reciprocal(),
            0 if self.is_undefined() => self,
            _ => self.raised(n.unsigned_abs()),
        }
    }

    /// Range of xⁿ for n ≥ 0, narrow also if x may have either sign.
    fn raised(self, n: u32) -> Self {
        if n.is_multiple_of(2) {
            let size = self.abs();
            Self { lo: size.power(n).lo, hi: size.power(n).hi }.restricted(0.0, f64::INFINITY)
        } else {
            // An odd power rises.
            let (low, high) = (Self::point(self.lo).power(n), Self::point(self.hi).power(n));
            Self { lo: low.lo, hi: high.hi }
        }
    }

    /// Range of xⁿ by multiplications, each rounded outwards, for a range whose ends have equal signs.
    fn power(self, mut n: u32) -> Self {
        let (mut base, mut result) = (self, Self::point(1.0));
        while n > 0 {
            if n & 1 == 1 {
                result = result * base;
            }
            n >>= 1;
            if n > 0 {
                base = base * base;
            }
        }
        result
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::outwards(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_undefined() || other.is_undefined() {
            return Self::UNDEFINED;
        }
        // Factors of terms are mostly 1, or exact numbers.
        if self.width() == 0.0 {
            return other.times(self.lo);
        }
        if other.width() == 0.0 {
            return self.times(other.lo);
        }
        let (a, b) = (product(self.lo, other.lo), product(self.lo, other.hi));
        let (c, d) = (product(self.hi, other.lo), product(self.hi, other.hi));
        Self::outwards(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl Div for Interval {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "what may be 0 is dealt with in the reciprocal")]
    fn div(self, other: Self) -> Self {
        self * other.reciprocal()
    }
}
