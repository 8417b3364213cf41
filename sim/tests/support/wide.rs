//! A scalar of twice the digits of `f64`, for tests: x = hi + lo, with |lo| at most half an ulp of hi.
//!
//! T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971) 224–242.
//! Only arithmetic and roots are exact to 1e-31; the other functions are those of `f64`.

use std::ops::{Add, Div, Mul, Neg, Sub};

use tripos_traits::{Real, Scalar};

/// Number hi + lo in twice the precision of a double.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Wide(pub f64, pub f64);

fn two_sum(a: f64, b: f64) -> Wide {
    let sum = a + b;
    let other = sum - a;
    Wide(sum, (a - (sum - other)) + (b - other))
}

fn two_product(a: f64, b: f64) -> Wide {
    let product = a * b;
    Wide(product, a.mul_add(b, -product))
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.0, other.0), two_sum(self.1, other.1));
        let first = two_sum(high.0, high.1 + low.0);
        two_sum(first.0, first.1 + low.1)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.0, other.0);
        two_sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = Self(self.0 / other.0, 0.0);
        let rest = self - first * other;
        let second = Self(rest.0 / other.0, 0.0);
        let rest = rest - second * other;
        first + second + Self(rest.0 / other.0, 0.0)
    }
}

impl Real for Wide {
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;

    fn to_f64(self) -> f64 {
        self.0
    }
}

impl Scalar for Wide {
    fn from_f64(x: f64) -> Self {
        Self(x, 0.0)
    }
    fn decimal(text: &str) -> Self {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let mut value = Self::int(0);
        for digit in whole.trim_start_matches('-').chars().chain(part.chars()) {
            value = value * Self::int(10) + Self::from_f64(f64::from(digit.to_digit(10).unwrap()));
        }
        let shift = exponent.parse::<i32>().unwrap() - i32::try_from(part.len()).unwrap();
        let power = Self::int(10).powi(shift.abs());
        let value = if shift < 0 { value / power } else { value * power };
        if text.starts_with('-') { -value } else { value }
    }
    fn pi() -> Self {
        Self(std::f64::consts::PI, 1.224_646_799_147_353_2e-16)
    }
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::from_f64(numerator as f64) / Self::from_f64(denominator as f64)
    }
    fn sqrt(self) -> Self {
        let root = Self::from_f64(self.0.sqrt());
        if root.0 == 0.0 { root } else { (root + self / root) * Self::from_f64(0.5) }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0.sin_cos();
        (Self::from_f64(s), Self::from_f64(c))
    }
    fn asin(self) -> Self {
        Self::from_f64(self.0.asin())
    }
    fn acos(self) -> Self {
        Self::from_f64(self.0.acos())
    }
    fn atan(self) -> Self {
        Self::from_f64(self.0.atan())
    }
    fn exp(self) -> Self {
        Self::from_f64(self.0.exp())
    }
    fn ln(self) -> Self {
        Self::from_f64(self.0.ln())
    }
    fn sinh(self) -> Self {
        Self::from_f64(self.0.sinh())
    }
    fn cosh(self) -> Self {
        Self::from_f64(self.0.cosh())
    }
    fn tanh(self) -> Self {
        Self::from_f64(self.0.tanh())
    }
    fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }
    fn sign(self) -> Self {
        Self::from_f64(if self.0 > 0.0 {
            1.0
        } else if self.0 < 0.0 {
            -1.0
        } else {
            0.0
        })
    }
}
