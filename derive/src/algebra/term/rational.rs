//! Exact rational numbers of any size.
//!
//! Invariant: the denominator is positive and the fraction is reduced. `Big` is used only for
//! numbers that do not fit into `Small`. So equal numbers are equal values, and no operation
//! overflows.

mod text;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

/// Exact rational number of any size: two machine words if they suffice, big integers otherwise.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Repr);

/// Storage of a rational number: machine words if they suffice, else big integers.
#[derive(Clone)]
enum Repr {
    /// Reduced fraction (numerator, denominator) of machine words, with a positive denominator.
    Small(i64, i64),
    /// Reduced fraction of big integers, for numbers that do not fit two machine words.
    Big(Box<BigRational>),
}

/// Two rational numbers are equal if their numerators and denominators are equal, since fractions
/// are reduced. `BigRational` itself compares and hashes by a recursion as deep as Euclid's
/// algorithm is long. That overflows the stack for numbers of some thousand digits.
impl PartialEq for Repr {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Small(a, b), Self::Small(c, d)) => (a, b) == (c, d),
            (Self::Big(a), Self::Big(b)) => a.numer() == b.numer() && a.denom() == b.denom(),
            _ => false,
        }
    }
}

impl Eq for Repr {}

impl Hash for Repr {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match self {
            Self::Small(n, d) => (n, d).hash(state),
            Self::Big(value) => (value.numer(), value.denom()).hash(state),
        }
    }
}

impl Rational {
    /// The number 0.
    pub const ZERO: Self = Self(Repr::Small(0, 1));
    /// The number 1.
    pub const ONE: Self = Self(Repr::Small(1, 1));
    /// The number −1.
    pub const MINUS_ONE: Self = Self(Repr::Small(-1, 1));

    /// Creates the rational number with the integer value `n`.
    #[must_use]
    pub const fn integer(n: i64) -> Self {
        Self(Repr::Small(n, 1))
    }

    /// Creates the rational number `numerator / denominator`, reduced; `None` if the denominator is
    /// zero.
    #[must_use]
    pub fn fraction(numerator: i64, denominator: i64) -> Option<Self> {
        (denominator != 0).then(|| Self::from_wide(i128::from(numerator), i128::from(denominator)))
    }

    /// Converts a big fraction, which must be reduced and have a positive denominator.
    #[must_use]
    pub fn from_big(value: BigRational) -> Self {
        match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(n), Some(d)) => Self(Repr::Small(n, d)),
            _ => Self(Repr::Big(Box::new(value))),
        }
    }

    /// Converts the number to a fraction of big integers.
    #[must_use]
    pub fn to_big(&self) -> BigRational {
        match &self.0 {
            Repr::Small(n, d) => BigRational::new_raw((*n).into(), (*d).into()),
            Repr::Big(value) => (**value).clone(),
        }
    }

    /// Pair (numerator, denominator); `None` unless both fit into an `i64`.
    #[must_use]
    pub fn small(&self) -> Option<(i64, i64)> {
        match self.0 {
            Repr::Small(n, d) => Some((n, d)),
            Repr::Big(_) => None,
        }
    }

    /// Value as a machine integer; `None` if the number is not an integer or does not fit into an
    /// `i64`.
    #[must_use]
    pub fn to_i64(&self) -> Option<i64> {
        match self.0 {
            Repr::Small(n, 1) => Some(n),
            _ => None,
        }
    }

    /// Exact rational value of a double; `None` if the double is infinite or not a number.
    #[must_use]
    pub fn from_f64_exact(x: f64) -> Option<Self> {
        BigRational::from_float(x).map(Self::from_big)
    }

    /// Double nearest to the number; infinite if the number is too large, 0 if it is too small.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        match &self.0 {
            // Both below 2^53: one correctly rounded division.
            Repr::Small(n, d) if n.unsigned_abs() < 1 << 53 && *d < 1 << 53 => *n as f64 / *d as f64,
            _ => {
                let big = self.to_big();
                match big.to_f64() {
                    Some(value) if !value.is_nan() => value,
                    // The value is too large or too small for a double.
                    _ if big.numer().bits() < big.denom().bits() => 0.0,
                    _ if big.is_negative() => f64::NEG_INFINITY,
                    _ => f64::INFINITY,
                }
            }
        }
    }

    /// Creates the rational number n/d of 128-bit integers, reduced; d must not be 0.
    fn from_wide(n: i128, d: i128) -> Self {
        if let (Ok(n), Ok(d)) = (i64::try_from(n), i64::try_from(d))
            && let Some(reduced) = Self::reduced(n, d)
        {
            return reduced;
        }
        let g = n.gcd(&d);
        let sign = if d < 0 { -1 } else { 1 };
        let (n, d) = (sign * (n / g), sign * (d / g));
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) => Self(Repr::Small(n, d)),
            _ => Self(Repr::Big(Box::new(BigRational::new_raw(n.into(), d.into())))),
        }
    }

    /// Creates the reduced fraction n/d of machine words. `None` for 0/0, or if the sign change of
    /// a negative d overflows.
    fn reduced(n: i64, d: i64) -> Option<Self> {
        if d == 1 {
            return Some(Self(Repr::Small(n, 1)));
        }
        let g = i64::try_from(n.unsigned_abs().gcd(&d.unsigned_abs())).ok().filter(|g| *g > 0)?;
        let (n, d) = (n / g, d / g);
        Some(if d < 0 { Self(Repr::Small(n.checked_neg()?, d.checked_neg()?)) } else { Self(Repr::Small(n, d)) })
    }

    /// True if the number is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Repr::Small(0, _))
    }

    /// True if the number is 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        matches!(self.0, Repr::Small(1, 1))
    }

    /// True if the number is an integer: its denominator is 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Small(_, d) => *d == 1,
            Repr::Big(value) => value.is_integer(),
        }
    }

    /// True if the number is below 0.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Small(n, _) => *n < 0,
            Repr::Big(value) => value.is_negative(),
        }
    }

    /// Sum of two rational numbers.
    #[must_use]
    pub fn add(&self, other: &Self) -> Self {
        if let (Repr::Small(a, 1), Repr::Small(c, 1)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(*c)
        {
            return Self(Repr::Small(sum, 1));
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            let (a, b, c, d) = (i128::from(*a), i128::from(*b), i128::from(*c), i128::from(*d));
            if let Some(n) = (a * d).checked_add(c * b) {
                return Self::from_wide(n, b * d);
            }
        }
        Self::from_big(self.to_big() + other.to_big())
    }

    /// Product of two rational numbers.
    #[must_use]
    pub fn mul(&self, other: &Self) -> Self {
        if let (Repr::Small(a, 1), Repr::Small(c, 1)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(*c)
        {
            return Self(Repr::Small(product, 1));
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            return Self::from_wide(i128::from(*a) * i128::from(*c), i128::from(*b) * i128::from(*d));
        }
        Self::from_big(self.to_big() * other.to_big())
    }

    /// Negative of the number.
    #[must_use]
    pub fn neg(&self) -> Self {
        self.mul(&Self::MINUS_ONE)
    }

    /// Reciprocal of the number; `None` for 0.
    #[must_use]
    pub fn reciprocal(&self) -> Option<Self> {
        match &self.0 {
            Repr::Small(0, _) => None,
            Repr::Small(n, d) => Some(Self::from_wide(i128::from(*d), i128::from(*n))),
            Repr::Big(value) => Some(Self::from_big(value.recip())),
        }
    }

    /// Power of the number with the integer exponent `n`. `None` for a negative power of 0, or if
    /// the result would have more than about [`Self::MAX_BITS`] bits. 0⁰ is 1.
    #[must_use]
    pub fn pow(&self, n: i32) -> Option<Self> {
        match n {
            1 => return Some(self.clone()),
            -1 => return self.reciprocal(),
            _ if n > 0 && self.is_one() => return Some(Self::ONE),
            _ => {}
        }
        let bits = self.to_big().numer().bits().max(self.to_big().denom().bits());
        if n.unsigned_abs() > 1 && bits > 1 && bits.saturating_mul(u64::from(n.unsigned_abs())) > Self::MAX_BITS {
            return None;
        }
        if self.is_zero() {
            return (n >= 0).then_some(if n == 0 { Self::ONE } else { Self::ZERO });
        }
        Some(Self::from_big(num_traits::Pow::pow(self.to_big(), n)))
    }

    /// Square root of the number; `None` if the root is not rational, or if the number does not
    /// fit 64 bits.
    pub(in crate::algebra) fn small_square_root(&self) -> Option<Self> {
        let root = |n: i64| {
            let near = u64::try_from(n).ok()?.isqrt();
            let near = i64::try_from(near).ok()?;
            (near.checked_mul(near)? == n).then_some(near)
        };
        let (n, d) = self.small()?;
        Self::fraction(root(n)?, root(d)?)
    }

    /// Number of bits above which a power of a rational number is refused rather than computed.
    pub const MAX_BITS: u64 = 100_000;

    /// Greatest common divisor of two rational numbers: the largest positive rational number of
    /// which both are integer multiples. It is the gcd of the numerators over the lcm of the
    /// denominators. If one number is 0, it is the absolute value of the other.
    #[must_use]
    pub fn greatest_common_divisor(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            let value = self.add(other);
            return if value.is_negative() { value.neg() } else { value };
        }
        if let (Repr::Small(a, b), Repr::Small(c, d)) = (&self.0, &other.0) {
            // The result is reduced, since both fractions are: a prime in its numerator and
            // denominator would divide both parts of one fraction.
            let numerator = i64::try_from(a.unsigned_abs().gcd(&c.unsigned_abs()));
            if let (Ok(numerator), Some(denominator)) = (numerator, (b / b.gcd(d)).checked_mul(*d)) {
                return Self(Repr::Small(numerator, denominator));
            }
        }
        let (a, b) = (self.to_big(), other.to_big());
        Self::from_big(BigRational::new(a.numer().gcd(b.numer()), a.denom().lcm(b.denom())))
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Repr::Small(a, b), Repr::Small(c, d)) => {
                (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)))
            }
            _ => {
                let (a, b) = (self.to_big(), other.to_big());
                (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
            }
        }
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        Self::from_big(BigRational::new_raw(value, BigInt::one()))
    }
}

impl Default for Rational {
    fn default() -> Self {
        Self::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_beyond_a_machine_word_do_not_wrap() {
        let big = Rational::integer(i64::MAX);
        let twice = big.add(&big);
        assert_eq!(twice.to_string(), "18446744073709551614");
        assert_eq!(twice.add(&big.neg()), big, "and come back to the small form");
    }

    #[test]
    fn i64_min_has_an_opposite() {
        assert_eq!(Rational::integer(i64::MIN).neg().to_string(), "9223372036854775808");
        assert_eq!(
            Rational::integer(i64::MIN).reciprocal().unwrap().reciprocal().unwrap(),
            Rational::integer(i64::MIN)
        );
    }

    #[test]
    fn a_thousand_unit_fractions_sum_exactly() {
        let forward = (1..=1000).fold(Rational::ZERO, |s, k| s.add(&Rational::fraction(1, k).unwrap()));
        let backward = (1..=1000).rev().fold(Rational::ZERO, |s, k| s.add(&Rational::fraction(1, k).unwrap()));
        assert_eq!(forward, backward);
        assert!((forward.to_f64() - 7.485_470_860_550_345).abs() < 1e-14);
    }

    #[test]
    fn what_no_double_can_hold_is_zero_or_infinite() {
        let tiny = Rational::integer(10).pow(-400).unwrap();
        assert_eq!(tiny.to_f64().to_bits(), 0.0_f64.to_bits());
        assert!(tiny.reciprocal().unwrap().to_f64().is_infinite());
        assert!((Rational::integer(10).pow(300).unwrap().to_f64() / 1e300 - 1.0).abs() < 1e-15);
    }

    /// Long fractions need no deep stack. For consecutive Fibonacci numbers Euclid's algorithm
    /// takes the most steps: 140 000 nested calls for 30 000 digits.
    #[test]
    fn long_numbers_are_compared_and_hashed_without_a_deep_stack() {
        let (mut a, mut b) = (BigInt::one(), BigInt::one());
        for _ in 0..60_000 {
            (a, b) = (b.clone(), a + b);
        }
        let ratio = |a: &BigInt, b: &BigInt| Rational::from_big(BigRational::new_raw(a.clone(), b.clone()));
        let (one, same, other) = (ratio(&a, &b), ratio(&a, &b), ratio(&b, &(a.clone() + &b)));
        assert_eq!(one, same);
        assert_ne!(one.cmp(&other), Ordering::Equal);
        let mut known = std::collections::HashSet::new();
        assert!(known.insert(one) && !known.insert(same));
    }

    #[test]
    fn powers_that_would_fill_memory_are_refused() {
        assert_eq!(Rational::integer(2).pow(1 << 20), None);
        assert_eq!(Rational::ONE.pow(i32::MAX), Some(Rational::ONE));
        assert_eq!(Rational::ZERO.pow(-1), None);
        assert_eq!(Rational::ZERO.pow(0), Some(Rational::ONE));
    }
}
