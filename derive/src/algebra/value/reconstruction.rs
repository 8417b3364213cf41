//! Reconstruction of rational numbers, and of sums with square roots, from residues modulo a prime.
//!
//! Each result is a guess, since other numbers have the same residue. The caller must prove it.

use super::field::Field;
use crate::algebra::Rational;

/// Largest numerator and denominator of a reconstructed fraction. Two different fractions within
/// this limit have different residues modulo a prime of 61 bits, since the prime is far above 2 ·
/// 2^48.
const LARGEST: u64 = 1 << 24;

/// Reconstructs a rational number from its residue in the field `f`. Its numerator and denominator
/// are at most 2^24; `None` if no such number has this residue.
///
/// The method uses the remainders of Euclid's algorithm: P. S. Wang, "A p-adic algorithm for
/// univariate partial fractions", SYMSAC (1981) 212–217.
#[must_use]
pub fn reconstruct_rational(f: Field, residue: u64) -> Option<Rational> {
    let (mut last, mut rest) = (i128::from(f.prime), i128::from(residue));
    let (mut before, mut factor) = (0_i128, 1_i128);
    while rest > i128::from(LARGEST) {
        let quotient = last / rest;
        (last, rest) = (rest, last - quotient * rest);
        (before, factor) = (factor, before - quotient * factor);
    }
    let (n, d) = if factor < 0 { (-rest, -factor) } else { (rest, factor) };
    if d == 0 || d > i128::from(LARGEST) {
        return None;
    }
    Rational::fraction(i64::try_from(n).ok()?, i64::try_from(d).ok()?)
}

/// Largest common denominator of a and b that is tried in the search for a number a + b √n.
const DENOMINATORS: u64 = 144;
/// Largest numerator of a and b that is tried in the search for a number a + b √n.
const MOST_NUMERATOR: i64 = 288;
/// Radicands n that are tried in the search for a number a + b √n.
const ROOTS: [i64; 3] = [2, 3, 6];

/// Reconstructs a number a + b √n from its residue in the field `f`, and returns (a, n, b). The
/// numbers a and b ≠ 0 are small and rational; n is 2, 3 or 6. All small denominators, and all
/// small numerators of b, are tried. `None` if no number fits.
#[must_use]
pub fn reconstruct_surd(f: Field, residue: u64) -> Option<(Rational, i64, Rational)> {
    for n in ROOTS {
        let root = f.root(u64::try_from(n).ok()?)?;
        for d in 1..=DENOMINATORS {
            let scaled = f.mul(d, residue);
            for k in -MOST_NUMERATOR..=MOST_NUMERATOR {
                let part = f.mul(root, k.unsigned_abs());
                let left = if k < 0 { f.add(scaled, part) } else { f.sub(scaled, part) };
                let small = i64::try_from(left.min(f.prime - left)).ok().filter(|x| *x <= MOST_NUMERATOR);
                if let Some(size) = small.filter(|_| k != 0) {
                    let whole = if left <= f.prime / 2 { size } else { -size };
                    let d = i64::try_from(d).ok()?;
                    return Some((Rational::fraction(whole, d)?, n, Rational::fraction(k, d)?));
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::value::field::Generator;

    /// Fractions are reconstructed from their residues. The residue of no small fraction gives
    /// `None`.
    #[test]
    fn fractions_come_back_from_residues() {
        let f = Field::random(&mut Generator(5));
        for (n, d) in [(0, 1), (1, 1), (-1, 1), (22, 7), (-1, 12), (355, 113), (-9_999_999, 10_000_019)] {
            let value = Rational::fraction(n, d).unwrap();
            assert_eq!(reconstruct_rational(f, f.residue_of_rational(&value).unwrap()), Some(value));
        }
        assert_eq!(reconstruct_rational(f, f.pow(3, 1_000_003)), None);
    }

    /// Numbers with square roots are reconstructed. The numbers are entries of a rotation about (1,
    /// 1, 1) and of a rotation by 45°.
    #[test]
    fn numbers_with_roots_come_back_from_residues() {
        let f = Field::random(&mut Generator(7));
        for (a, n, b) in [((1, 2), 3, (1, 6)), ((0, 1), 2, (1, 2)), ((-1, 4), 6, (5, 12))] {
            let [a, b] = [a, b].map(|(n, d)| Rational::fraction(n, d).unwrap());
            let root = f.root(u64::try_from(n).unwrap()).unwrap();
            let residue = f.add(f.residue_of_rational(&a).unwrap(), f.mul(root, f.residue_of_rational(&b).unwrap()));
            assert_eq!(reconstruct_surd(f, residue), Some((a, n, b)));
        }
        assert_eq!(reconstruct_surd(f, f.pow(3, 1_000_003)), None);
    }
}
