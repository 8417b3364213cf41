//! Complex numbers whose parts have 32 digits.

use std::ops::{Add, Div, Mul, Neg, Sub};
use tripos_traits::{DoubleDouble, Scalar};

/// Complex number whose real and imaginary part have 32 digits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WideComplex {
    /// Real part of the number, to 32 digits.
    pub re: DoubleDouble,
    /// Imaginary part of the number, to 32 digits.
    pub im: DoubleDouble,
}

impl WideComplex {
    /// Makes a complex number from its real part; the imaginary part is 0.
    #[must_use]
    pub fn real(re: DoubleDouble) -> Self {
        Self { re, ..Self::default() }
    }

    /// Makes a complex number from its real part, given as a double; the imaginary part is 0.
    #[must_use]
    pub fn from_f64(re: f64) -> Self {
        Self::real(DoubleDouble::from_f64(re))
    }

    /// Makes a complex number from its absolute value and its angle, rad, in double precision.
    #[must_use]
    pub fn polar(size: f64, angle: f64) -> Self {
        let [re, im] = [size * angle.cos(), size * angle.sin()].map(DoubleDouble::from_f64);
        Self { re, im }
    }

    /// Complex conjugate of the number.
    #[must_use]
    pub fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// Squared absolute value |z|², to 32 digits.
    #[must_use]
    pub fn squared_norm(self) -> DoubleDouble {
        self.re * self.re + self.im * self.im
    }

    /// Absolute value |z|, to 32 digits.
    #[must_use]
    pub fn modulus(self) -> DoubleDouble {
        self.squared_norm().sqrt()
    }

    /// Absolute value |z|, rounded to a double.
    #[must_use]
    pub fn norm(self) -> f64 {
        self.re.hi().hypot(self.im.hi())
    }

    /// Product z r with a real number r.
    #[must_use]
    pub fn scaled(self, r: DoubleDouble) -> Self {
        Self { re: self.re * r, im: self.im * r }
    }

    /// Principal square root of the number, whose real part is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let half = DoubleDouble::from_f64(0.5);
        let size = self.modulus();
        if size.hi() <= 0.0 {
            return Self::default();
        }
        // The larger part is computed first, so that nothing cancels.
        let large = ((size + self.re.abs()) * half).sqrt();
        let small = self.im * half / large;
        let is_left = self.re.hi() < 0.0;
        let sign = DoubleDouble::from_f64(if self.im.hi() < 0.0 { -1.0 } else { 1.0 });
        if is_left { Self { re: small * sign, im: large * sign } } else { Self { re: large, im: small } }
    }

    /// True if real and imaginary part are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }
}

impl Add for WideComplex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for WideComplex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for WideComplex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Div for WideComplex {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let product = self * other.conj();
        let square = other.squared_norm();
        Self { re: product.re / square, im: product.im / square }
    }
}

impl Neg for WideComplex {
    type Output = Self;

    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}
