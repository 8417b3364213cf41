//! Scalars: the arithmetic that a generated function body needs.

pub mod series;

use super::circular;
use super::circular::MulAdd;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};
use series::{Factors, Pair};

/// Number type, or several numbers in lanes, in which generated equations can be evaluated.
///
/// Angles are in radians. Functions outside their domain return the type's "not a number" and never
/// panic. The simulator checks for it and stops the run with a reason.
pub trait Scalar:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Value of this type nearest to `x`.
    #[must_use]
    fn from_f64(x: f64) -> Self;
    /// Value nearest to a number in decimal notation, such as `"-5.26e-2"`. Coefficients of methods are
    /// written with more digits than an `f64` holds. "Not a number" if `text` has another form.
    #[must_use]
    fn decimal(text: &str) -> Self;
    /// Number π in this type.
    #[must_use]
    fn pi() -> Self;
    /// Whole number `n` in this type.
    #[must_use]
    fn int(n: i64) -> Self {
        Self::ratio(n, 1)
    }
    /// Quotient `numerator / denominator`. It is correctly rounded if both are exact in this type, as
    /// whole numbers up to 2⁵³ are in `f64`.
    #[must_use]
    fn ratio(numerator: i64, denominator: i64) -> Self;
    /// Computes (sin x, cos x) together, which costs less than each alone. The error in `f64` and in
    /// lanes is at most 0.9 ulp for |x| ≤ 2¹⁸, also near the zeros, and 1 ulp for larger x.
    fn sin_cos(self) -> (Self, Self);
    /// Square root √x; "not a number" for x < 0.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Inverse sine, rad, in [−π/2, π/2]; "not a number" for |x| > 1.
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine, rad, in [0, π]; "not a number" for |x| > 1.
    #[must_use]
    fn acos(self) -> Self;
    /// Inverse tangent, rad, in (−π/2, π/2).
    #[must_use]
    fn atan(self) -> Self;
    /// Exponential eˣ of this number x.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm; "not a number" for x < 0.
    #[must_use]
    fn ln(self) -> Self;
    /// Hyperbolic sine of this number.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine of this number.
    #[must_use]
    fn cosh(self) -> Self;
    /// Hyperbolic tangent of this number.
    #[must_use]
    fn tanh(self) -> Self;
    /// Absolute value |x| of this number x.
    #[must_use]
    fn abs(self) -> Self;
    /// Sign of x: −1, 0 or 1. It is 0 at 0, where it serves as the derivative of |x|.
    #[must_use]
    fn sign(self) -> Self;
    /// Computes sin x/x of this number x (rad), and 1 at x = 0.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]
    fn sinc(self) -> Self {
        let sign = self.sign();
        let at_zero = Self::int(1) - sign * sign;
        (self.sin_cos().0 + at_zero) / (self + at_zero)
    }
    /// Computes x·a + b. It is rounded once if the program is compiled for a processor with fused
    /// multiply–add, as with `-C target-cpu=native`; else twice. So two builds may differ in the last
    /// bits.
    #[must_use]
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    /// Runs `work`, compiled for this processor's vector instructions if the type gains by them. The
    /// results equal those of `work()`.
    #[inline]
    fn dispatch<R>(work: impl FnOnce() -> R) -> R {
        work()
    }
    /// Sums of products of Taylor coefficients, as [`series::pair_sums`] defines them. The results do
    /// not depend on the processor.
    #[must_use]
    #[inline]
    fn pair_sums<const W: usize>(history: &[Factors<Self, W>]) -> Pair<Self, W> {
        series::sums::<Self, W, { series::LANES }>(history)
    }
    /// Computes Σ a b over pairs of factors, in their order; 0 if there are none.
    #[must_use]
    #[inline]
    fn sum_of_products(pairs: impl Iterator<Item = (Self, Self)> + Clone) -> Self {
        pairs.map(|(a, b)| a * b).reduce(|sum, product| sum + product).unwrap_or(Self::int(0))
    }
    /// Computes xⁿ by repeated multiplication; n may be negative.
    #[must_use]
    fn powi(self, n: i32) -> Self {
        let mut base = if n < 0 { Self::ratio(1, 1) / self } else { self };
        let mut left = n.unsigned_abs();
        let mut product = Self::ratio(1, 1);
        while left > 0 {
            if left & 1 == 1 {
                product = product * base;
            }
            base = base * base;
            left >>= 1;
        }
        product
    }
}

/// Real number that can be compared: the scalar in which a run is made.
pub trait Real: Scalar + PartialEq + PartialOrd {
    /// Distance from 1 to the next larger value; for [`crate::DoubleDouble`], the unit of its error
    /// bounds.
    const EPSILON: f64;
    /// Value rounded to the nearest `f64`.
    fn to_f64(self) -> f64;
    /// Number of derivatives (slopes) that a value contains: 0 except in [`crate::Tangent`].
    const SLOPES: usize = 0;
    /// Derivative of the value along direction number `at`, counted from 0; 0 if the type contains no
    /// derivatives.
    #[must_use]
    fn slope(self, _at: usize) -> f64 {
        0.0
    }
    /// Copy of the value whose derivative along direction number `at` is increased by `by`; unchanged
    /// if the type has none.
    #[must_use]
    fn turned(self, _at: usize, _by: f64) -> Self {
        self
    }
    /// Computes `self` + k x with a number k that has no derivatives, such as a coefficient of a method
    /// or a step length. It is rounded like [`Scalar::mul_add`].
    #[must_use]
    #[inline]
    fn plus_multiple(self, k: Self, x: Self) -> Self {
        k.mul_add(x, self)
    }
}

/// Implements `Scalar` and `Real` for a floating-point type, with the given functions of `libm`.
macro_rules! float_scalar {
    ($type:ty, $sincos:path, $sqrt:path, $asin:path, $acos:path, $atan:path, $exp:path, $ln:path,
     $sinh:path, $cosh:path, $tanh:path) => {
        #[allow(clippy::cast_possible_truncation, clippy::cast_lossless)]
        impl Real for $type {
            const EPSILON: f64 = <$type>::EPSILON as f64;
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
        }

        #[allow(clippy::cast_possible_truncation, clippy::cast_lossless, clippy::cast_precision_loss)]
        impl Scalar for $type {
            #[inline]
            fn from_f64(x: f64) -> Self {
                x as Self
            }
            fn decimal(text: &str) -> Self {
                text.parse().unwrap_or(<$type>::NAN)
            }
            #[inline]
            fn pi() -> Self {
                core::f64::consts::PI as Self
            }
            #[inline]
            fn ratio(numerator: i64, denominator: i64) -> Self {
                numerator as Self / denominator as Self
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sincos(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline]
            fn asin(self) -> Self {
                $asin(self)
            }
            #[inline]
            fn acos(self) -> Self {
                $acos(self)
            }
            #[inline]
            fn atan(self) -> Self {
                $atan(self)
            }
            #[inline]
            fn exp(self) -> Self {
                $exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                $ln(self)
            }
            #[inline]
            fn sinh(self) -> Self {
                $sinh(self)
            }
            #[inline]
            fn cosh(self) -> Self {
                $cosh(self)
            }
            #[inline]
            fn tanh(self) -> Self {
                $tanh(self)
            }
            #[cfg(all(feature = "std", target_feature = "fma"))]
            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                <$type>::mul_add(self, a, b)
            }
            #[inline]
            fn pair_sums<const W: usize>(history: &[Factors<Self, W>]) -> Pair<Self, W> {
                series::widest(history)
            }
            #[inline]
            fn abs(self) -> Self {
                <$type>::abs(self)
            }
            #[inline]
            fn sign(self) -> Self {
                if self == 0.0 { 0.0 } else { self.signum() }
            }
        }
    };
}

/// Multiply–add that rounds like [`Scalar::mul_add`] of `f64`: once if the compilation target has
/// the fused instruction, else twice.
struct AsCompiled;

impl MulAdd for AsCompiled {
    #[inline]
    fn mul_add(x: f64, a: f64, b: f64) -> f64 {
        Scalar::mul_add(x, a, b)
    }
}

/// Computes (sin x, cos x) of an f64, x in rad.
#[inline]
fn sin_cos(x: f64) -> (f64, f64) {
    circular::one::<AsCompiled>(x)
}

float_scalar!(
    f64,
    sin_cos,
    libm::sqrt,
    libm::asin,
    libm::acos,
    libm::atan,
    libm::exp,
    libm::log,
    libm::sinh,
    libm::cosh,
    libm::tanh
);
float_scalar!(
    f32,
    libm::sincosf,
    libm::sqrtf,
    libm::asinf,
    libm::acosf,
    libm::atanf,
    libm::expf,
    libm::logf,
    libm::sinhf,
    libm::coshf,
    libm::tanhf
);
