//! Numbers with about 32 decimal digits, each the sum of two f64, hi + lo.
//!
//! Invariant: hi is the f64 nearest to hi + lo, so |lo| ≤ ulp(hi)/2 and each value has a unique
//! representation. lo is 0 where hi is infinite or not a number.
//!
//! Error bounds below are in units of [`DoubleDouble::EPSILON`] = 2⁻¹⁰⁴, relative to the result,
//! for results between 1e-270 and 1e299. Nearer to the ends of the range of f64, digits are lost
//! gradually, down to those of f64.
//!
//! Methods: Dekker (1971) and Knuth (see `error_free`); Hida, Li & Bailey, "Algorithms for
//! quad-double precision floating point arithmetic", ARITH-15 (2001) 155–162; bounds of the
//! operations by Joldes, Muller & Popescu, "Tight and rigorous error bounds for basic building
//! blocks of double-word arithmetic", ACM TOMS 44 (2017) 15res.

mod elementary;
mod error_free;
mod tables;
mod text;

use crate::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};
use error_free::{quick_two_sum, two_product, two_sum};

/// Real number with about 32 decimal digits, stored as the unevaluated sum hi + lo of two f64.
///
/// ```
/// use tripos_traits::{DoubleDouble, Real, Scalar};
///
/// let third = DoubleDouble::ratio(1, 3);
/// assert_eq!(third.to_string(), "3.3333333333333333333333333333333e-1");
/// assert!((third * DoubleDouble::int(3) - DoubleDouble::int(1)).abs().to_f64() <= DoubleDouble::EPSILON);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    // Compared in this order: of two values with equal hi, the larger has the larger lo.
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    /// Value "not a number" of this type.
    pub const NAN: Self = Self { hi: f64::NAN, lo: 0.0 };
    /// Positive infinity of this type.
    pub const INFINITY: Self = Self { hi: f64::INFINITY, lo: 0.0 };
    /// Number zero of this type.
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    /// Number one of this type.
    const ONE: Self = Self { hi: 1.0, lo: 0.0 };

    /// Exact sum a + b of two f64; infinite or "not a number" if the sum overflows.
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let (s, e) = two_sum(a, b);
        Self::finite_or(s, e, s)
    }

    /// Leading part of the value: the f64 nearest to it.
    #[inline]
    #[must_use]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Trailing part of the value: the value minus its leading part.
    #[inline]
    #[must_use]
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// True if the value is neither infinite nor "not a number".
    #[inline]
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.hi.is_finite()
    }

    /// Creates the number hi + lo; if lo is not finite, creates `otherwise`, which is the result in
    /// plain f64. In sums and products with their errors, lo is not finite if hi is not, so a single
    /// test is enough.
    #[inline]
    fn finite_or(hi: f64, lo: f64, otherwise: f64) -> Self {
        if lo.is_finite() { Self { hi, lo } } else { Self { hi: otherwise, lo: 0.0 } }
    }

    /// Sum a + b of two f64 with |a| ≥ |b|, as a number in normal form (hi is the f64 nearest to the
    /// sum).
    #[inline]
    fn normalized(a: f64, b: f64) -> Self {
        let (hi, lo) = quick_two_sum(a, b);
        Self::finite_or(hi, lo, a)
    }

    /// Exact product a b of two f64; infinite or "not a number" if it overflows.
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        let (p, e) = two_product(a, b);
        Self::finite_or(p, e, p)
    }

    /// Creates the number hi + lo from its parts, which must be in normal form.
    #[inline]
    const fn from_parts([hi, lo]: [f64; 2]) -> Self {
        Self { hi, lo }
    }

    /// Sum of this number and an f64, with a relative error of at most 2 · 2⁻¹⁰⁵.
    #[inline]
    fn plus(self, b: f64) -> Self {
        let (s, e) = two_sum(self.hi, b);
        let (hi, lo) = quick_two_sum(s, e + self.lo);
        Self::finite_or(hi, lo, s)
    }

    /// Product of this number and an f64, with a relative error of at most 2⁻¹⁰⁵.
    #[inline]
    fn times(self, b: f64) -> Self {
        let (p, e) = two_product(self.hi, b);
        Self::normalized(p, e + self.lo * b)
    }

    /// Exact product of this number and b, which must be a power of two.
    #[inline]
    fn scaled(self, b: f64) -> Self {
        Self::normalized(self.hi * b, self.lo * b)
    }

    /// Computes x 2ⁿ of this number x, exactly unless it underflows.
    #[inline]
    fn shifted(self, n: i32) -> Self {
        Self::normalized(libm::scalbn(self.hi, n), libm::scalbn(self.lo, n))
    }

    /// Square x² of this number x, cheaper than a product.
    #[inline]
    fn squared(self) -> Self {
        let (p, e) = two_product(self.hi, self.hi);
        Self::normalized(p, e + 2.0 * self.hi * self.lo)
    }

    /// Converts a whole number of 64 bits exactly.
    #[inline]
    fn whole_64(n: i64) -> Self {
        if n.unsigned_abs() <= 1 << 53 { Self::from(n as f64) } else { Self::whole(n.into()) }
    }

    /// Converts a whole number of absolute value below 2¹²⁷; exact up to 2¹⁰⁶.
    #[allow(clippy::cast_possible_truncation, reason = "the difference is below 2⁷⁴ and is rounded once")]
    fn whole(n: i128) -> Self {
        let hi = n as f64;
        Self::normalized(hi, (n - hi as i128) as f64)
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    /// Sum with an error of at most 2⁻¹⁰⁴, relative to the result. This holds even if the operands
    /// nearly cancel, because the low parts are added exactly.
    // Never inlined: generated code calls it by the thousand, and compiling that takes longer than running it.
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s_1, e_1) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s_1, e_1 + f);
        Self::finite_or(hi, lo, s)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    /// Product with a relative error of at most 2 · 2⁻¹⁰⁴. The product of the low parts is too small to
    /// matter and is left out.
    // Never inlined: generated code calls it by the thousand, and compiling that takes longer than running it.
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        Self::normalized(p, e + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    /// Quotient with a relative error of at most 2 · 2⁻¹⁰⁴, by long division in digits of 53 bits.
    // Never inlined: generated code calls it by the thousand, and compiling that takes longer than running it.
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        // A quotient that is infinite, zero or not a number has no further digits; asking for them would make it NaN.
        if first == 0.0 || !first.is_finite() || !other.hi.is_finite() {
            return Self::from(first);
        }
        let rest = self - other.times(first);
        let second = rest.hi / other.hi;
        let rest = rest - other.times(second);
        let (hi, lo) = quick_two_sum(first, second);
        Self { hi, lo }.plus(rest.hi / other.hi)
    }
}

impl Real for DoubleDouble {
    /// Unit 2⁻¹⁰⁴ of the error bounds. Numbers closer to 1 exist, such as 1 + 1e-300, but operations
    /// lose such digits.
    const EPSILON: f64 = 4.930_380_657_631_324e-32;

    #[inline]
    fn to_f64(self) -> f64 {
        self.hi
    }
}

impl Scalar for DoubleDouble {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::from(x)
    }
    /// Parses decimal notation. The error is at most 2 units of 2⁻¹⁰⁴ if the last digit is within 45
    /// places of the point, and 16 units elsewhere. Digits after the 38th are ignored.
    fn decimal(text: &str) -> Self {
        text::parsed(text)
    }
    #[inline]
    fn pi() -> Self {
        Self { hi: 2.0 * tables::HALF_PI[0], lo: 2.0 * tables::HALF_PI[1] }
    }
    #[inline]
    fn int(n: i64) -> Self {
        Self::whole_64(n)
    }
    /// Quotient of two whole numbers, with a relative error of at most 2 · 2⁻¹⁰⁴.
    #[inline]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::whole_64(numerator) / Self::whole_64(denominator)
    }
    /// Sine and cosine with a relative error of at most 2 · 2⁻¹⁰⁴ for |x| ≤ 1e5, also near their zeros.
    /// From there to 2⁴⁰ = 1.1e12 the bound is absolute. Larger angles give 16 digits.
    fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        elementary::sqrt(self)
    }
    /// Inverse sine, rad, with a relative error of at most 3 · 2⁻¹⁰⁴. The bound also holds for `acos`
    /// and `atan`.
    fn asin(self) -> Self {
        elementary::asin(self)
    }
    fn acos(self) -> Self {
        elementary::acos(self)
    }
    fn atan(self) -> Self {
        elementary::atan(self)
    }
    /// Exponential with a relative error of at most 2 · 2⁻¹⁰⁴ for |x| ≤ 600; results below 1e-270 lose
    /// digits.
    fn exp(self) -> Self {
        elementary::exp(self)
    }
    /// Natural logarithm with a relative error of at most 2 · 2⁻¹⁰⁴, also near 1.
    fn ln(self) -> Self {
        elementary::ln(self)
    }
    /// Hyperbolic sine with a relative error of at most 3 · 2⁻¹⁰⁴, also near 0. The bound also holds
    /// for `cosh` and `tanh`.
    fn sinh(self) -> Self {
        elementary::sinh(self)
    }
    fn cosh(self) -> Self {
        elementary::cosh(self)
    }
    fn tanh(self) -> Self {
        elementary::tanh(self)
    }
    #[inline]
    fn abs(self) -> Self {
        if self.hi.is_sign_negative() { -self } else { self }
    }
    #[inline]
    fn sign(self) -> Self {
        Self::from(Scalar::sign(self.hi))
    }
}
