//! Large primes with a short proof that they are prime, for certificates that other programs check.
//!
//! The primes are p = 2 k Q + 1 with the Mersenne prime Q = 2^127 − 1 and k < 2^126, so that Q > √p. If a^(p−1) = 1
//! modulo p and a^(2k) − 1 has no factor in common with p, then p is prime (H. C. Pocklington 1914, Proc. Cambridge
//! Phil. Soc. 18, 29).

use num_bigint::BigUint;

/// Prime 2 k Q + 1 with Q = 2^127 − 1 and its proof. It is 7 modulo 8, so that a number or its negative is a square.
/// Modulo the prime, all primes up to 31 are squares, so that roots of their products exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProvedPrime {
    /// Number k of the prime 2 k Q + 1, in decimal digits.
    pub cofactor: String,
    /// Base a of Pocklington's criterion.
    pub witness: u32,
}

/// Number of primes below 1000 by which candidates are divided before Pocklington's criterion is tried.
const SMALL: std::ops::Range<u32> = 3..1000;

/// Odd primes that are squares modulo each proved prime, as 2 is.
const ODD_SQUARES: [u32; 10] = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31];

/// Finds the first proved prime whose number k is at least 2^125 plus the first 124 bits of a hash of 64 hexadecimal
/// digits. Digits that are not hexadecimal count as 0.
#[must_use]
pub fn proved_prime_after(digest: &str) -> ProvedPrime {
    let mersenne = (BigUint::from(1_u8) << 127) - 1_u8;
    let digits = digest.bytes().take(31).map(|digit| char::from(digit).to_digit(16).unwrap_or_default());
    let offset = digits.fold(BigUint::ZERO, |sum, digit| (sum << 4) + digit);
    let moduli = ODD_SQUARES.map(|small| (small, prime_residues(small)));
    // With k = 1 modulo 4, the prime is 7 modulo 8.
    let mut cofactor = ((((BigUint::from(1_u8) << 125) + offset) >> 2) << 2) + 1_u8;
    loop {
        let prime: BigUint = &cofactor * 2_u8 * &mersenne + 1_u8;
        let squares =
            moduli.iter().all(|(small, allowed)| allowed.iter().any(|r| &prime % *small == BigUint::from(*r)));
        if squares
            && !SMALL.step_by(2).any(|small| &prime % small == BigUint::ZERO)
            && let Some(witness) = pocklington_witness(&prime, &cofactor)
        {
            return ProvedPrime { cofactor: cofactor.to_string(), witness };
        }
        cofactor += 4_u8;
    }
}

/// Residues modulo an odd prime `small` of those primes p = 3 modulo 4 modulo which `small` is a square. By the law of
/// quadratic reciprocity, p or −p is then a square modulo `small`.
fn prime_residues(small: u32) -> Vec<u32> {
    let squares = (1..small).map(|x| x * x % small);
    let mut residues: Vec<u32> = squares.map(|x| if small % 4 == 1 { x } else { small - x }).collect();
    residues.sort_unstable();
    residues.dedup();
    residues
}

/// Base that proves by Pocklington's criterion that 2 k Q + 1 is prime; `None` if no base below 20 does.
fn pocklington_witness(prime: &BigUint, cofactor: &BigUint) -> Option<u32> {
    let one = BigUint::from(1_u8);
    let (order, exponent) = (prime - 1_u8, cofactor * 2_u8);
    for witness in 2..20_u32 {
        let base = BigUint::from(witness);
        if base.modpow(&order, prime) != one {
            return None;
        }
        let power = base.modpow(&exponent, prime);
        if power != one && greatest_common_divisor(power - 1_u8, prime.clone()) == one {
            return Some(witness);
        }
    }
    None
}

/// Greatest common divisor of two numbers, by Euclid's algorithm.
fn greatest_common_divisor(mut a: BigUint, mut b: BigUint) -> BigUint {
    while b != BigUint::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    a
}
