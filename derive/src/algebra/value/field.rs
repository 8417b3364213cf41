//! Prime fields: arithmetic modulo random primes of 61 bits.

use crate::algebra::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// Deterministic generator of random numbers. The field is its state (`SplitMix64`, Steele, Lea and
/// Flood 2014).
pub struct Generator(pub u64);

impl Generator {
    /// Draws the next random number of 64 bits.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

/// Prime field: arithmetic modulo a prime p between 2^60 and 2^61 with p = 23 modulo 24.
///
/// In such a field −1 is not a square, so exactly one of the two roots of a square is itself a
/// square. 2 and 3 are squares, so sines of multiples of π/12 have values.
#[derive(Clone, Copy)]
pub struct Field {
    /// Prime modulus of the field, between 2^60 and 2^61.
    pub prime: u64,
    /// Value ⌊2^122 / prime⌋. Products are reduced by a multiplication with this value, because
    /// divisions of 128-bit numbers are slow.
    reciprocal: u64,
}

impl Field {
    /// Creates the field modulo `prime`, which must lie between 2^60 and 2^61.
    fn modulo(prime: u64) -> Self {
        debug_assert_eq!(prime >> 60, 1, "a prime of 61 bits");
        Self { prime, reciprocal: u64::try_from((1 << 122) / u128::from(prime)).expect("at most 2^62") }
    }
    /// Draws a random prime with the generator and creates its field.
    pub fn random(generator: &mut Generator) -> Self {
        loop {
            let candidate = (1 << 60) | (generator.next() >> 4);
            let candidate = candidate - candidate % 24 + 23;
            if candidate < 1 << 61 && Self::modulo(candidate).is_prime() {
                return Self::modulo(candidate);
            }
        }
    }

    /// Sum a + b modulo the prime.
    pub fn add(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.prime { sum - self.prime } else { sum }
    }

    /// Difference a − b modulo the prime.
    pub fn sub(self, a: u64, b: u64) -> u64 {
        if a >= b { a - b } else { a + self.prime - b }
    }

    /// Product a · b modulo the prime.
    pub fn mul(self, a: u64, b: u64) -> u64 {
        // Barrett's reduction: for a product below 2^122 the quotient is at most two below the
        // exact quotient.
        let product = u128::from(a) * u128::from(b);
        let quotient = ((product >> 60) * u128::from(self.reciprocal)) >> 62;
        let rest = product - quotient * u128::from(self.prime);
        let mut rest = u64::try_from(rest).expect("below three primes of 61 bits");
        while rest >= self.prime {
            rest -= self.prime;
        }
        rest
    }

    /// Power aⁿ modulo the prime, for n ≥ 0. 0⁰ is 1.
    pub fn pow(self, a: u64, mut n: u64) -> u64 {
        let (mut result, mut power) = (1, a);
        while n > 0 {
            if n & 1 == 1 {
                result = self.mul(result, power);
            }
            n >>= 1;
            if n > 0 {
                power = self.mul(power, power);
            }
        }
        result
    }

    /// Inverse 1/a modulo the prime; `None` for a = 0.
    pub fn inverse(self, a: u64) -> Option<u64> {
        match a {
            0 => None,
            1 => Some(1),
            _ => Some(self.pow(a, self.prime - 2)),
        }
    }

    /// Power aⁿ modulo the prime, for n of either sign; `None` for a negative power of 0.
    pub fn signed_power(self, a: u64, n: i32) -> Option<u64> {
        let base = if n < 0 { self.inverse(a)? } else { a };
        Some(self.pow(base, u64::from(n.unsigned_abs())))
    }

    /// Square root of a modulo the prime: of the two roots, the one that is itself a square. `None`
    /// if a has no root.
    pub fn root(self, a: u64) -> Option<u64> {
        let root = self.pow(a, self.prime.div_ceil(4));
        (self.mul(root, root) == a).then_some(root)
    }

    /// Residue of a rational number modulo the prime; `None` if the prime divides its denominator.
    pub fn residue_of_rational(self, value: &Rational) -> Option<u64> {
        if let Some((n, d)) = value.small() {
            let above = n.unsigned_abs() % self.prime;
            let above = if n < 0 { self.sub(0, above) } else { above };
            return Some(self.mul(above, self.inverse(d.unsigned_abs() % self.prime)?));
        }
        let residue = |n: &BigInt| n.mod_floor(&BigInt::from(self.prime)).to_u64();
        let big = value.to_big();
        Some(self.mul(residue(big.numer())?, self.inverse(residue(big.denom())?)?))
    }

    /// True if the modulus is a prime: the test of Miller and Rabin with the seven bases that
    /// decide every 64-bit number (Sinclair 2011).
    fn is_prime(self) -> bool {
        let n = self.prime;
        let small = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53];
        if small.iter().any(|b| n.is_multiple_of(*b)) {
            return false;
        }
        let twos = (n - 1).trailing_zeros();
        [2, 325, 9375, 28178, 450_775, 9_780_504, 1_795_265_022].iter().all(|&base| {
            let mut x = self.pow(base, (n - 1) >> twos);
            (x == 1 || x == n - 1)
                || (1..twos).any(|_| {
                    x = self.mul(x, x);
                    x == n - 1
                })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_those_of_division_by_double_words() {
        let mut generator = Generator(7);
        for _ in 0..200 {
            let f = Field::random(&mut generator);
            let p = u128::from(f.prime);
            let mut pairs: Vec<(u64, u64)> =
                (0..50).map(|_| (generator.next() % f.prime, generator.next() % f.prime)).collect();
            pairs.extend([(f.prime - 1, f.prime - 1), (0, f.prime - 1), (1, f.prime - 1), (2, f.prime - 1)]);
            for (a, b) in pairs {
                assert_eq!(u128::from(f.mul(a, b)), u128::from(a) * u128::from(b) % p, "{a} {b} modulo {p}");
                assert_eq!(u128::from(f.add(a, b)), (u128::from(a) + u128::from(b)) % p);
                assert_eq!(f.add(f.sub(a, b), b), a);
            }
        }
    }

    #[test]
    fn composites_are_no_primes() {
        // 2^61 − 1 is prime; its neighbour and the product of two primes near 2^30.4 are not.
        assert!(Field::modulo((1 << 61) - 1).is_prime());
        assert!(!Field::modulo((1 << 61) - 3).is_prime());
        assert!(!Field::modulo(1_400_000_023 * 1_400_000_101).is_prime());
    }
}
