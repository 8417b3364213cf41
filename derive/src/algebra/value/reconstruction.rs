//! Reconstruction of numbers from residues: rational numbers, surds, and rational coefficients of
//! linear combinations.
//!
//! Each result is a guess, since other numbers have the same residue. The caller must prove it.

use super::field::Field;
use crate::algebra::Rational;

/// Largest numerator and denominator of a reconstructed fraction. Two different fractions within
/// this limit have different residues modulo a prime of 61 bits, since 2 · 2^48 is far below the
/// prime.
const LARGEST: u64 = 1 << 24;

/// Reconstructs the rational number with a small numerator and denominator from its residue in the
/// field `f`. `None` if there is no such number.
///
/// P. S. Wang, "A p-adic algorithm for univariate partial fractions", SYMSAC (1981) 212–217. It
/// uses the remainders of Euclid's algorithm.
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
/// numbers a and b ≠ 0 are small and rational; n is 2, 3 or 6.
/// The search tries all denominators, and all numerators of b. `None` if no number fits.
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

/// Brings a matrix over the field `f` to reduced echelon form and removes its zero rows. Returns
/// the pivot columns: the first columns that are independent.
pub fn reduced_echelon_form(f: Field, rows: &mut Vec<Vec<u64>>) -> Vec<usize> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let at = pivots.len();
        let Some(found) = (at..rows.len()).find(|row| rows[*row][column] != 0) else { continue };
        rows.swap(at, found);
        let inverse = f.inverse(rows[at][column]).unwrap_or(1);
        rows[at].iter_mut().for_each(|x| *x = f.mul(*x, inverse));
        let pivot = std::mem::take(&mut rows[at]);
        for row in rows.iter_mut().filter(|row| !row.is_empty()) {
            let factor = row[column];
            if factor != 0 {
                row.iter_mut().zip(&pivot).skip(column).for_each(|(x, p)| *x = f.sub(*x, f.mul(factor, *p)));
            }
        }
        rows[at] = pivot;
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    pivots
}

/// Unique solution x of the linear system Σ xₖ columnₖ = last column over the field `f`. Each row
/// of the matrix is an equation. `None` if there is no solution, or more than one.
#[must_use]
pub fn unique_solution(f: Field, mut rows: Vec<Vec<u64>>) -> Option<Vec<u64>> {
    let unknowns = rows.first()?.len() - 1;
    let pivots = reduced_echelon_form(f, &mut rows);
    pivots.iter().copied().eq(0..unknowns).then(|| rows.iter().map(|row| row[unknowns]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::value::field::Generator;

    /// Goal: numbers come back from their residues, and a residue of no small fraction is refused. Method: fractions,
    /// and a residue that belongs to none.
    #[test]
    fn fractions_come_back_from_residues() {
        let f = Field::random(&mut Generator(5));
        for (n, d) in [(0, 1), (1, 1), (-1, 1), (22, 7), (-1, 12), (355, 113), (-9_999_999, 10_000_019)] {
            let value = Rational::fraction(n, d).unwrap();
            assert_eq!(reconstruct_rational(f, f.residue_of_rational(&value).unwrap()), Some(value));
        }
        assert_eq!(reconstruct_rational(f, f.pow(3, 1_000_003)), None);
    }

    /// Goal: numbers beside roots come back. Method: entries of a turn about (1, 1, 1), and of one by an eighth.
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

    #[test]
    fn systems_are_solved_where_they_have_one_solution() {
        let f = Field::random(&mut Generator(6));
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![1, 2, 8], vec![2, 3, 13]]), Some(vec![2, 3]));
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![1, 2, 8], vec![2, 3, 14]]), None);
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![2, 2, 10], vec![3, 3, 15]]), None);
    }
}
