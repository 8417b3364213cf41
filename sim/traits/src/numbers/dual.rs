//! Dual number: a value with its derivative along a single direction.

use super::scalar::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Dual number: a value and its derivative along a single direction. Both go through a computation
/// together (forward differentiation), exactly up to rounding.
///
/// Where a function has no derivative, the slope is the value of its derivative formula there. For
/// example, |x| has the slope 0 at 0.
///
/// ```
/// use tripos_traits::{Dual, Scalar};
///
/// let x = Dual { value: 0.5, slope: 1.0 };
/// let y = x * x.sin_cos().0;
/// assert_eq!(y.slope, 0.5_f64.sin() + 0.5 * 0.5_f64.cos());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<S> {
    /// Value of the dual number.
    pub value: S,
    /// Derivative of the value along the single direction.
    pub slope: S,
}

impl<S: Scalar> Dual<S> {
    /// Number that is constant along the direction, with the slope 0.
    #[must_use]
    #[inline]
    pub fn constant(value: S) -> Self {
        Self { value, slope: S::int(0) }
    }

    /// Result of a function f of this number x by the chain rule: `value` is f(x), `derivative` is
    /// df/dx.
    #[inline]
    fn through(self, value: S, derivative: S) -> Self {
        Self { value, slope: derivative * self.slope }
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let slope = self.slope.mul_add(other.value, self.value * other.slope);
        Self { value: self.value * other.value, slope }
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::constant(S::from_f64(x))
    }
    fn decimal(text: &str) -> Self {
        Self::constant(S::decimal(text))
    }
    #[inline]
    fn pi() -> Self {
        Self::constant(S::pi())
    }
    #[inline]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::constant(S::ratio(numerator, denominator))
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.through(sine, cosine), self.through(cosine, -sine))
    }
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self { value: root, slope: self.slope / (S::int(2) * root) }
    }
    fn asin(self) -> Self {
        let leg = (S::int(1) - self.value * self.value).sqrt();
        Self { value: self.value.asin(), slope: self.slope / leg }
    }
    fn acos(self) -> Self {
        let leg = (S::int(1) - self.value * self.value).sqrt();
        Self { value: self.value.acos(), slope: -self.slope / leg }
    }
    fn atan(self) -> Self {
        Self { value: self.value.atan(), slope: self.slope / (S::int(1) + self.value * self.value) }
    }
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.through(value, value)
    }
    fn ln(self) -> Self {
        Self { value: self.value.ln(), slope: self.slope / self.value }
    }
    fn sinh(self) -> Self {
        self.through(self.value.sinh(), self.value.cosh())
    }
    fn cosh(self) -> Self {
        self.through(self.value.cosh(), self.value.sinh())
    }
    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.through(value, S::int(1) - value * value)
    }
    #[inline]
    fn abs(self) -> Self {
        self.through(self.value.abs(), self.value.sign())
    }
    #[inline]
    fn sign(self) -> Self {
        Self::constant(self.value.sign())
    }
    #[inline]
    fn sum_of_products(pairs: impl Iterator<Item = (Self, Self)> + Clone) -> Self {
        let value = S::sum_of_products(pairs.clone().map(|(a, b)| (a.value, b.value)));
        let slope = S::sum_of_products(pairs.flat_map(|(a, b)| [(a.slope, b.value), (a.value, b.slope)]));
        Self { value, slope }
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let slope = self.slope.mul_add(a.value, self.value.mul_add(a.slope, b.slope));
        Self { value: self.value.mul_add(a.value, b.value), slope }
    }
}
