//! Tangents: an f64 with its derivatives along several directions, for runs with sensitivities.
//!
//! Invariant: the value has the bits that an f64 has after the same operations, whatever the
//! derivatives are. So a run in tangents takes the steps of the run in f64, and its derivatives are
//! those of that run.
//!
//! Products of derivatives are never fused, so that they have equal bits on every processor.
//! Tangents compare by their values only.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use super::lanes::each_lane;
use super::scalar::{Real, Scalar};
use crate::dispatch;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Number with a value and its derivatives along `K` directions at once; 4 of them fill a register.
///
/// Where a function has no derivative, the slopes are the values of its derivative formula there.
/// For example, |x| has the slope 0 at 0.
///
/// ```
/// use tripos_traits::{Scalar, Tangent};
///
/// let (x, y) = (Tangent { value: 0.5, slopes: [1.0, 0.0] }, Tangent { value: 2.0, slopes: [0.0, 1.0] });
/// let z = x * y * x.sin_cos().0;
/// assert_eq!(z.slopes, [2.0 * 0.5_f64.sin() + 2.0 * 0.5 * 0.5_f64.cos(), 0.5 * 0.5_f64.sin()]);
/// ```
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Tangent<const K: usize> {
    /// Value of the number without its derivatives.
    pub value: f64,
    /// Derivatives of the value, one for each of the `K` directions.
    pub slopes: [f64; K],
}

impl<const K: usize> Tangent<K> {
    /// Number that is constant along all directions, with slopes 0.
    #[must_use]
    #[inline(always)]
    pub const fn constant(value: f64) -> Self {
        Self { value, slopes: [0.0; K] }
    }

    /// Result of a function f of this number x by the chain rule: `value` is f(x), `derivative` is
    /// df/dx.
    #[must_use]
    #[inline(always)]
    pub fn through(self, value: f64, derivative: f64) -> Self {
        let mut out = Self { value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = derivative * self.slopes[k]);
        out
    }
}

impl<const K: usize> Add for Tangent<K> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mut out = Self { value: self.value + other.value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = self.slopes[k] + other.slopes[k]);
        out
    }
}

impl<const K: usize> Sub for Tangent<K> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let mut out = Self { value: self.value - other.value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = self.slopes[k] - other.slopes[k]);
        out
    }
}

impl<const K: usize> Mul for Tangent<K> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mut out = Self { value: self.value * other.value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = self.slopes[k] * other.value + self.value * other.slopes[k]);
        out
    }
}

impl<const K: usize> Div for Tangent<K> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let (value, inverse) = (self.value / other.value, 1.0 / other.value);
        let mut out = Self { value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = (self.slopes[k] - value * other.slopes[k]) * inverse);
        out
    }
}

impl<const K: usize> Neg for Tangent<K> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let mut out = Self { value: -self.value, slopes: self.slopes };
        each_lane!(k, K, out.slopes[k] = -self.slopes[k]);
        out
    }
}

impl<const K: usize> PartialEq for Tangent<K> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<const K: usize> PartialOrd for Tangent<K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

/// Computes √(1 − x²), the second leg of a right triangle with hypotenuse 1 and leg x.
fn leg(x: f64) -> f64 {
    Scalar::sqrt(1.0 - x * x)
}

impl<const K: usize> Scalar for Tangent<K> {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::constant(x)
    }
    fn decimal(text: &str) -> Self {
        Self::constant(f64::decimal(text))
    }
    #[inline(always)]
    fn pi() -> Self {
        Self::constant(f64::pi())
    }
    #[inline(always)]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::constant(f64::ratio(numerator, denominator))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.through(sine, cosine), self.through(cosine, -sine))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = Scalar::sqrt(self.value);
        self.through(root, 0.5 / root)
    }
    fn asin(self) -> Self {
        self.through(Scalar::asin(self.value), 1.0 / leg(self.value))
    }
    fn acos(self) -> Self {
        self.through(Scalar::acos(self.value), -1.0 / leg(self.value))
    }
    fn atan(self) -> Self {
        self.through(Scalar::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }
    fn exp(self) -> Self {
        let value = Scalar::exp(self.value);
        self.through(value, value)
    }
    fn ln(self) -> Self {
        self.through(Scalar::ln(self.value), 1.0 / self.value)
    }
    fn sinh(self) -> Self {
        self.through(Scalar::sinh(self.value), Scalar::cosh(self.value))
    }
    fn cosh(self) -> Self {
        self.through(Scalar::cosh(self.value), Scalar::sinh(self.value))
    }
    fn tanh(self) -> Self {
        let value = Scalar::tanh(self.value);
        self.through(value, 1.0 - value * value)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.through(Scalar::abs(self.value), Scalar::sign(self.value))
    }
    #[inline(always)]
    fn sign(self) -> Self {
        Self::constant(Scalar::sign(self.value))
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let mut out = Self { value: Scalar::mul_add(self.value, a.value, b.value), slopes: b.slopes };
        each_lane!(k, K, out.slopes[k] = b.slopes[k] + (self.slopes[k] * a.value + self.value * a.slopes[k]));
        out
    }
    fn powi(self, n: i32) -> Self {
        let value = Scalar::powi(self.value, n);
        match n {
            0 => Self::constant(value),
            _ => self.through(value, f64::from(n) * Scalar::powi(self.value, n - 1)),
        }
    }
    #[inline(always)]
    fn dispatch<R>(work: impl FnOnce() -> R) -> R {
        if K < 4 { work() } else { dispatch::run::<K, R>(work) }
    }
}

/// Scalar of a run with sensitivities: compared and rounded by its value; the derivatives go along.
impl<const K: usize> Real for Tangent<K> {
    const EPSILON: f64 = f64::EPSILON;
    const SLOPES: usize = K;
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.value
    }
    fn slope(self, at: usize) -> f64 {
        self.slopes[at]
    }
    fn turned(mut self, at: usize, by: f64) -> Self {
        self.slopes[at] += by;
        self
    }
    #[inline(always)]
    fn plus_multiple(self, k: Self, x: Self) -> Self {
        let mut out = Self { value: Scalar::mul_add(k.value, x.value, self.value), slopes: self.slopes };
        each_lane!(j, K, out.slopes[j] = self.slopes[j] + k.value * x.slopes[j]);
        out
    }
}
