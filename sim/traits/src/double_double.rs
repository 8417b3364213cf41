//! About 32 decimal digits from two f64.
//!
//! Invariant: hi is the f64 nearest to hi + lo, so |lo| ≤ ulp(hi)/2 and a value has one representation; lo is 0 where
//! hi is infinite or not a number.
//!
//! Bounds below are in units of [`DoubleDouble::EPSILON`] = 2⁻¹⁰⁴, relative to the result, for results between 1e-270
//! and 1e299. Nearer to the ends of the range of f64 digits are lost gradually, down to those of f64.
//!
//! Methods: Dekker (1971) and Knuth (see `error_free`); Hida, Li & Bailey, "Algorithms for quad-double precision
//! floating point arithmetic", ARITH-15 (2001) 155–162; bounds of the operations by Joldes, Muller & Popescu, "Tight
//! and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44 (2017) 15res.

mod elementary;
mod error_free;
mod tables;
mod text;

use crate::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};
use error_free::{quick_two_sum, two_product, two_sum};

/// The unevaluated sum hi + lo of two f64: a real number to about 32 digits.
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
    /// Not a number.
    pub const NAN: Self = Self { hi: f64::NAN, lo: 0.0 };
    /// Positive infinity.
    pub const INFINITY: Self = Self { hi: f64::INFINITY, lo: 0.0 };
    const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    const ONE: Self = Self { hi: 1.0, lo: 0.0 };

    /// The exact sum a + b, where it has no more than two parts: always, unless it overflows.
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Self {
        let (s, e) = two_sum(a, b);
        Self::finite_or(s, e, s)
    }

    /// The leading part: the nearest f64.
    #[inline]
    #[must_use]
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// The trailing part: the value minus its leading part.
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

    /// hi + lo, or `otherwise` alone where these are lost to infinities: the result as plain f64 has it. In sums and
    /// products with their errors lo is not finite if hi is not, so one question is enough.
    #[inline]
    fn finite_or(hi: f64, lo: f64, otherwise: f64) -> Self {
        if lo.is_finite() { Self { hi, lo } } else { Self { hi: otherwise, lo: 0.0 } }
    }

    /// a + b where |a| ≥ |b|.
    #[inline]
    fn normalized(a: f64, b: f64) -> Self {
        let (hi, lo) = quick_two_sum(a, b);
        Self::finite_or(hi, lo, a)
    }

    /// The exact product a b.
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        let (p, e) = two_product(a, b);
        Self::finite_or(p, e, p)
    }

    #[inline]
    const fn from_parts([hi, lo]: [f64; 2]) -> Self {
        Self { hi, lo }
    }

    /// x + b, to 2 units of 2⁻¹⁰⁵.
    #[inline]
    fn plus(self, b: f64) -> Self {
        let (s, e) = two_sum(self.hi, b);
        let (hi, lo) = quick_two_sum(s, e + self.lo);
        Self::finite_or(hi, lo, s)
    }

    /// x b, to 2⁻¹⁰⁵.
    #[inline]
    fn times(self, b: f64) -> Self {
        let (p, e) = two_product(self.hi, b);
        Self::normalized(p, e + self.lo * b)
    }

    /// x b for a power of two b: exact.
    #[inline]
    fn scaled(self, b: f64) -> Self {
        Self::normalized(self.hi * b, self.lo * b)
    }

    /// Computes x 2ⁿ.
    #[inline]
    fn shifted(self, n: i32) -> Self {
        Self::normalized(libm::scalbn(self.hi, n), libm::scalbn(self.lo, n))
    }

    #[inline]
    fn squared(self) -> Self {
        let (p, e) = two_product(self.hi, self.hi);
        Self::normalized(p, e + 2.0 * self.hi * self.lo)
    }

    /// A whole number, exactly.
    #[inline]
    fn whole_64(n: i64) -> Self {
        if n.unsigned_abs() <= 1 << 53 { Self::from(n as f64) } else { Self::whole(n.into()) }
    }

    /// A whole number below 2¹²⁷ in size; exact up to 2¹⁰⁶.
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
    /// To 1 unit, also where the operands nearly cancel: the low parts are added exactly too.
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
    /// To 2 units. The product of the low parts is below them and left out.
    // Never inlined: generated code calls it by the thousand, and compiling that takes longer than running it.
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        Self::normalized(p, e + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    /// To 2 units: long division in digits of 53 bits.
    // Never inlined: generated code calls it by the thousand, and compiling that takes longer than running it.
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        // What is infinite, zero or not a number has no further digits, and asking for them would make it NaN.
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
    /// 2⁻¹⁰⁴. Next to 1 there are closer values, 1 + 1e-300 among them, but operations do not keep such a distance.
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
    /// To 2 units where the last digit stands within 45 places of the point, to 16 elsewhere; digits after
    /// the 38th are not looked at.
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
    /// To 2 units.
    #[inline]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::whole_64(numerator) / Self::whole_64(denominator)
    }
    /// To 2 units for |x| ≤ 1e5, also next to the zeros; absolute up to 2⁴⁰ = 1.1e12; beyond to 16 digits.
    fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        elementary::sqrt(self)
    }
    /// To 3 units, as are the next two.
    fn asin(self) -> Self {
        elementary::asin(self)
    }
    fn acos(self) -> Self {
        elementary::acos(self)
    }
    fn atan(self) -> Self {
        elementary::atan(self)
    }
    /// To 2 units for |x| ≤ 600; results below 1e-270 lose digits.
    fn exp(self) -> Self {
        elementary::exp(self)
    }
    /// To 2 units, also next to 1.
    fn ln(self) -> Self {
        elementary::ln(self)
    }
    /// To 3 units, also next to 0, as are the next two.
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
