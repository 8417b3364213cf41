//! Arithmetic modulo random primes.

use super::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// A small deterministic generator (`SplitMix64`, Steele, Lea and Flood 2014).
pub struct Generator(pub u64);

impl Generator {
    /// The next 64 bits.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

/// Arithmetic modulo a prime between 2^60 and 2^61 that is 23 modulo 24: then −1 is no square, so that of
/// two roots exactly one is a square, and 2 and 3 are squares, so that multiples of π/12 have values.
#[derive(Clone, Copy)]
pub struct Field(pub u64);

impl Field {
    /// A random prime field.
    pub fn random(generator: &mut Generator) -> Self {
        loop {
            let candidate = (1 << 60) | (generator.next() >> 4);
            let candidate = candidate - candidate % 24 + 23;
            if candidate < 1 << 61 && is_prime(candidate) {
                return Self(candidate);
            }
        }
    }

    /// a + b.
    pub fn add(self, a: u64, b: u64) -> u64 {
        (a + b) % self.0
    }

    /// a − b.
    pub fn sub(self, a: u64, b: u64) -> u64 {
        (a + self.0 - b) % self.0
    }

    /// a b.
    pub fn mul(self, a: u64, b: u64) -> u64 {
        mul_mod(a, b, self.0)
    }

    /// a to the power n.
    pub fn pow(self, a: u64, n: u64) -> u64 {
        pow_mod(a, n, self.0)
    }

    /// 1/a; `None` for 0.
    pub fn inverse(self, a: u64) -> Option<u64> {
        (a != 0).then(|| self.pow(a, self.0 - 2))
    }

    /// a to any power; `None` for a negative power of 0.
    pub fn power(self, a: u64, n: i32) -> Option<u64> {
        let base = if n < 0 { self.inverse(a)? } else { a };
        Some(self.pow(base, u64::from(n.unsigned_abs())))
    }

    /// The square root that is itself a square; `None` for a non-residue.
    pub fn root(self, a: u64) -> Option<u64> {
        let root = self.pow(a, self.0.div_ceil(4));
        (self.mul(root, root) == a).then_some(root)
    }

    /// The residue of a number; `None` if the prime divides its denominator.
    pub fn rational(self, value: &Rational) -> Option<u64> {
        let residue = |n: &BigInt| n.mod_floor(&BigInt::from(self.0)).to_u64();
        let big = value.to_big();
        Some(self.mul(residue(big.numer())?, self.inverse(residue(big.denom())?)?))
    }
}

fn mul_mod(a: u64, b: u64, p: u64) -> u64 {
    u64::try_from(u128::from(a) * u128::from(b) % u128::from(p)).expect("below p")
}

fn pow_mod(mut a: u64, mut n: u64, p: u64) -> u64 {
    let mut result = 1;
    a %= p;
    while n > 0 {
        if n & 1 == 1 {
            result = mul_mod(result, a, p);
        }
        a = mul_mod(a, a, p);
        n >>= 1;
    }
    result
}

/// Miller–Rabin with the twelve bases that decide every 64-bit number (Sorenson and Webster 2015).
fn is_prime(n: u64) -> bool {
    let bases = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if bases.iter().any(|b| n.is_multiple_of(*b)) {
        return bases.contains(&n);
    }
    let twos = (n - 1).trailing_zeros();
    bases.iter().all(|&base| {
        let mut x = pow_mod(base, (n - 1) >> twos, n);
        (x == 1 || x == n - 1)
            || (1..twos).any(|_| {
                x = mul_mod(x, x, n);
                x == n - 1
            })
    })
}
