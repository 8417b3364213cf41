//! Complex numbers over a real scalar. Two of the three real stages of a Radau step are solved as a
//! single complex stage.

use std::ops::{Add, Div, Mul, Neg, Sub};

use tripos_traits::Real;

use crate::linear::lu::Entry;

/// Complex number re + i im.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex<S> {
    /// Real part of the complex number.
    pub(super) re: S,
    /// Imaginary part of the complex number.
    pub(super) im: S,
}

impl<S: Real> Add for Complex<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<S: Real> Sub for Complex<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl<S: Real> Neg for Complex<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

impl<S: Real> Mul for Complex<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (re, im) = (self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re);
        Self { re, im }
    }
}

/// Division by R. L. Smith's formula, Comm. ACM 5 (1962) 435. It avoids the square of the divisor, which may overflow
/// although the quotient does not.
impl<S: Real> Div for Complex<S> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.re.absolute_value() >= other.im.absolute_value() {
            let ratio = other.im / other.re;
            let divisor = other.re + other.im * ratio;
            Self { re: (self.re + self.im * ratio) / divisor, im: (self.im - self.re * ratio) / divisor }
        } else {
            let ratio = other.re / other.im;
            let divisor = other.re * ratio + other.im;
            Self { re: (self.re * ratio + self.im) / divisor, im: (self.im * ratio - self.re) / divisor }
        }
    }
}

impl<S: Real> Entry for Complex<S> {
    fn zero() -> Self {
        Self { re: S::zero(), im: S::zero() }
    }
    fn absolute_value(self) -> f64 {
        self.re.absolute_value() + self.im.absolute_value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linear::lu::Lu;

    fn number(re: f64, im: f64) -> Complex<f64> {
        Complex { re, im }
    }

    #[test]
    fn quotients_are_exact_where_they_can_be_and_do_not_overflow() {
        assert_eq!(number(5.0, 5.0) / number(2.0, 1.0), number(3.0, 1.0));
        assert_eq!(number(5.0, 5.0) / number(1.0, 2.0), number(3.0, -1.0));
        let large = number(1e300, 1e300);
        assert_eq!(large / large, number(1.0, 0.0));
    }

    /// System with pivots off the diagonal and complex pivots. The tolerance is 1e-14, since the entries are small
    /// whole numbers.
    #[test]
    fn a_complex_system_is_solved() {
        let a = [number(0.0, 0.0), number(2.0, 1.0), number(1.0, -3.0), number(0.0, 1.0)];
        let x = [number(1.0, 2.0), number(-1.0, 0.5)];
        let mut lu = Lu::new(2);
        lu.entries.copy_from_slice(&a);
        let mut b: Vec<_> = a.chunks(2).map(|row| row[0] * x[0] + row[1] * x[1]).collect();
        assert!(lu.factor());
        lu.solve(&mut b);
        for (found, expected) in b.into_iter().zip(x) {
            assert!((found - expected).absolute_value() < 1e-14, "{found:?} {expected:?}");
        }
        lu.entries.fill(Complex::zero());
        assert!(!lu.factor());
    }
}
