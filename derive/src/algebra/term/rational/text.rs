//! Text of rational numbers: decimals are read exactly, and numbers are printed as fractions.

use super::{Rational, Repr};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::fmt;

impl Rational {
    /// Reads an unsigned decimal number such as `12`, `0.5` or `1.5e-3` as an exact fraction: `0.1`
    /// is 1/10.
    ///
    /// `None` if the text is not a decimal number or its exponent is beyond ±4 000.
    #[must_use]
    pub fn parse_decimal(text: &str) -> Option<Self> {
        let (mantissa, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{decimals}");
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) || exponent.abs() > 4000 {
            return None;
        }
        let scale = exponent - i32::try_from(decimals.len()).ok()?;
        let value = BigRational::from_integer(digits.parse::<BigInt>().ok()?);
        let ten = BigRational::from_integer(10.into());
        Some(Self::from_big(value * num_traits::Pow::pow(ten, scale)))
    }

    /// Decimal number with the fewest digits that rounds to the double `x`, as an exact fraction:
    /// 1/10 for 0.1. `None` if `x` is infinite or not a number.
    #[must_use]
    pub fn shortest_decimal(x: f64) -> Option<Self> {
        // Rust's standard library prints the fewest digits that read back as the same double.
        let size = Self::parse_decimal(&format!("{:e}", x.abs()))?;
        Some(if x.is_sign_negative() { size.neg() } else { size })
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Small(n, 1) => write!(f, "{n}"),
            Repr::Small(n, d) => write!(f, "{n}/{d}"),
            Repr::Big(value) => write!(f, "{value}"),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact() {
        let sum = Rational::parse_decimal("0.1").unwrap().add(&Rational::parse_decimal("0.2").unwrap());
        assert_eq!(sum, Rational::fraction(3, 10).unwrap());
        assert_eq!(Rational::parse_decimal("1.5e-3").unwrap(), Rational::fraction(3, 2000).unwrap());
        for bad in ["", ".", "1e", "1.2.3", "1e99999", "-1", "0x1"] {
            assert_eq!(Rational::parse_decimal(bad), None, "{bad}");
        }
    }

    #[test]
    fn doubles_are_the_shortest_decimals_that_round_to_them() {
        assert_eq!(Rational::shortest_decimal(0.1), Rational::fraction(1, 10));
        assert_eq!(Rational::shortest_decimal(-1.62), Rational::fraction(-81, 50));
        assert_eq!(Rational::shortest_decimal(0.0), Rational::fraction(0, 1));
        for x in [f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1), -1.0 / 3.0] {
            assert_eq!(Rational::shortest_decimal(x).unwrap().to_f64().to_bits(), x.to_bits());
        }
        assert_eq!(Rational::shortest_decimal(f64::NAN), None);
        assert_eq!(Rational::shortest_decimal(f64::INFINITY), None);
    }
}
