//! Arithmetic that a generated function body needs.

pub mod series;

use crate::circular::{self, MulAdd};
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};
use series::{Factors, Pair};

/// A number in which generated equations can be evaluated, or several numbers in lanes.
///
/// Angles are in radians. Functions outside their domain return the type's "not a number", never
/// panic: the simulator looks for it and stops the run with a reason.
pub trait Scalar:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Value of this type nearest to `x`.
    #[must_use]
    fn from_f64(x: f64) -> Self;
    /// Value nearest to a number in decimal notation, such as `"-5.26e-2"`: coefficients of methods are written with
    /// more digits than an `f64` holds. Not a number if `text` has another form.
    #[must_use]
    fn decimal(text: &str) -> Self;
    /// The number π.
    #[must_use]
    fn pi() -> Self;
    /// The whole number `n`.
    #[must_use]
    fn int(n: i64) -> Self {
        Self::ratio(n, 1)
    }
    /// Quotient `numerator / denominator`, correctly rounded where both are exact in this type, as whole numbers up to
    /// 2⁵³ are in `f64`.
    #[must_use]
    fn ratio(numerator: i64, denominator: i64) -> Self;
    /// Computes (sin x, cos x), which cost less together than apart. The error in `f64` and in lanes is 0.9 ulp for |x|
    /// ≤ 2¹⁸, also next to the zeros, and 1 ulp beyond.
    fn sin_cos(self) -> (Self, Self);
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Inverse sine, in [−π/2, π/2].
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine, in [0, π].
    #[must_use]
    fn acos(self) -> Self;
    /// Inverse tangent, in (−π/2, π/2).
    #[must_use]
    fn atan(self) -> Self;
    /// Exponential eˣ.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// Hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Absolute value |x|.
    #[must_use]
    fn abs(self) -> Self;
    /// Sign of x: −1, 0 or 1; 0 at 0, as the derivative of |x| is taken there.
    #[must_use]
    fn sign(self) -> Self;
    /// Computes sin x/x, and 1 at x = 0.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]
    fn sinc(self) -> Self {
        let sign = self.sign();
        let at_zero = Self::int(1) - sign * sign;
        (self.sin_cos().0 + at_zero) / (self + at_zero)
    }
    /// Computes x·a + b. It is rounded once if the processor for which the program is compiled has a fused
    /// multiply-add, as with `-C target-cpu=native`, else twice. So two builds may differ in last bits.
    #[must_use]
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    /// Runs `work`, compiled for the vector instructions that this processor has where the type gains by them. The
    /// numbers are the same as those of `work()`.
    #[inline]
    fn dispatch<R>(work: impl FnOnce() -> R) -> R {
        work()
    }
    /// Sums of products of Taylor coefficients, as [`series::pair_sums`]. The numbers do not depend on the processor.
    #[must_use]
    #[inline]
    fn pair_sums<const W: usize>(history: &[Factors<Self, W>]) -> Pair<Self, W> {
        series::sums::<Self, W, { series::LANES }>(history)
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

/// A real number that can be compared: the scalar of a run.
pub trait Real: Scalar + PartialEq + PartialOrd {
    /// Distance from 1 to the next larger value; for [`crate::DoubleDouble`] the unit of its error bounds.
    const EPSILON: f64;
    /// Nearest `f64` to the value.
    fn to_f64(self) -> f64;
    /// Number of slopes that a value carries: 0 except in [`crate::Tangent`].
    const SLOPES: usize = 0;
    /// Slope of the value along direction number `at`, counted from 0; 0 if the type carries no slopes.
    #[must_use]
    fn slope(self, _at: usize) -> f64 {
        0.0
    }
    /// Copy of the value whose slope along direction number `at` is increased by `by`.
    #[must_use]
    fn turned(self, _at: usize, _by: f64) -> Self {
        self
    }
    /// Computes `self` + k x with a number k that has no slopes, such as a coefficient of a method or the length of a
    /// step. It is rounded as [`Scalar::mul_add`] is.
    #[must_use]
    #[inline]
    fn plus_multiple(self, k: Self, x: Self) -> Self {
        k.mul_add(x, self)
    }
}

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

/// Products and sums as [`Scalar::mul_add`] of `f64` makes them: fused if the target of compilation fuses them.
struct AsCompiled;

impl MulAdd for AsCompiled {
    #[inline]
    fn mul_add(x: f64, a: f64, b: f64) -> f64 {
        Scalar::mul_add(x, a, b)
    }
}

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
