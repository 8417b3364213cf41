//! Probability that a zero test wrongly reports zero. It is bounded by degrees and sizes of
//! polynomials.
//!
//! Every term is N / (d ΠB). N is a polynomial with integer coefficients, in the symbols and in the
//! parameter t of each base angle. d is an integer, and B are the divisors.
//!
//! A polynomial N that is not zero vanishes at a random point modulo p with a probability of at
//! most degree(N)/p (Schwartz 1980, Zippel 1979). All its coefficients vanish only modulo a prime
//! that divides them all. A coefficient has at most log₂|N|/60 prime factors of 60 bits.

use super::residues::POINTS;
use crate::algebra::term::elementary::{angle_atoms, is_exponential};
use crate::algebra::term::fold::{Fold, FoldOrder, Values};
use crate::algebra::{Arena, Expr, Function, Rational};
use num_integer::Integer;
use rustc_hash::FxHashMap;

/// Bounds on the parts of a term N / (d ΠB): N is a polynomial, d an integer, and B are the
/// divisors.
#[derive(Clone, Default)]
struct PolynomialBound {
    /// Upper bound of the degree of the polynomial N.
    degree: f64,
    /// Upper bound of the base-2 logarithm of the sum of the absolute coefficients of N.
    bits: f64,
    /// Upper bound of the base-2 logarithm of the integer d.
    denominator_bits: f64,
    /// Integer d, for finding common denominators; `None` if it does not fit a 64-bit integer.
    denominator: Option<u64>,
    /// Divisors B, as pairs (term, exponent).
    divisors: Vec<(Expr, f64)>,
}

/// Lower bound of log₂ of the number of primes between 2^60 and 2^61 that are 23 modulo 24. There
/// are π(2^61) − π(2^60) > 2^60/43 primes in this interval (Rosser and Schoenfeld 1962). One in
/// φ(24) = 8 of these primes qualifies, and a factor of 4 is a margin.
const LOG_PRIMES: f64 = 60.0 - 5.43 - 3.0 - 2.0;

/// Exponent k of a bound on errors: the term `e` is wrongly found zero with a probability below
/// 2^−k. It is 0 if there is no bound.
///
/// The bound is that of a zero test with two primes and two points for each. `finest` has the least
/// common denominator of the coefficients of each atom inside angles.
pub fn false_zero_exponent(arena: &Arena, needed: &FoldOrder, finest: &FxHashMap<Expr, i64>, e: Expr) -> f64 {
    let Some(sizes) = needed.fold(arena, &mut PolynomialBoundRules { arena, finest }) else { return 0.0 };
    let size = &sizes[e];
    // Sines and cosines have degree 2 in t, and their coefficients are twice as large.
    let degree = (2.0 * size.degree).max(1.0);
    let bits = (size.bits + 2.0 * size.degree).max(1.0);
    let points = f64::from(u32::try_from(POINTS / 2).unwrap_or(1));
    let at_points = (degree.log2() - 60.0) * points;
    let whole = (bits / 60.0).log2() - LOG_PRIMES;
    let one_prime = log_sum(at_points, whole).min(0.0);
    -2.0 * one_prime
}

/// Base-2 logarithm of 2^a + 2^b, computed without overflow.
fn log_sum(a: f64, b: f64) -> f64 {
    let (small, large) = if a < b { (a, b) } else { (b, a) };
    if large == f64::NEG_INFINITY { large } else { large + (small - large).exp2().ln_1p() / std::f64::consts::LN_2 }
}

/// Base-2 logarithms of the absolute numerator and of the denominator of a number.
fn bits_for_bound(value: &Rational) -> (f64, f64) {
    match value.small() {
        Some((n, d)) => ((n.unsigned_abs() as f64).log2(), (d as f64).log2()),
        None => {
            let big = value.to_big();
            (big.numer().bits() as f64, big.denom().bits() as f64)
        }
    }
}

/// Bounds of a term that is a rational number.
fn bound_of_number(value: &Rational) -> PolynomialBound {
    let (bits, denominator_bits) = bits_for_bound(value);
    let denominator = value.small().and_then(|(_, d)| u64::try_from(d).ok());
    PolynomialBound { bits, denominator_bits, denominator, ..PolynomialBound::default() }
}

/// Rules that bound the polynomials of each term.
struct PolynomialBoundRules<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Least common denominator of the coefficients of each atom inside angles. An angle is a sum Σ
    /// k · atom.
    finest: &'a FxHashMap<Expr, i64>,
}

impl Fold for PolynomialBoundRules<'_> {
    type Value = PolynomialBound;
    fn number(&mut self, value: &Rational) -> Option<PolynomialBound> {
        Some(bound_of_number(value))
    }
    fn pi(&mut self) -> Option<PolynomialBound> {
        Some(PolynomialBound { degree: 1.0, denominator: Some(1), ..PolynomialBound::default() })
    }
    fn symbol(&mut self, _: Expr) -> Option<PolynomialBound> {
        self.pi()
    }
    fn sum(
        &mut self,
        constant: &Rational,
        terms: &[(Expr, Rational)],
        of: &Values<'_, PolynomialBound>,
    ) -> Option<PolynomialBound> {
        Some(bound_of_sum(constant, terms, of))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, PolynomialBound>) -> Option<PolynomialBound> {
        Some(bound_of_product(factors, of))
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, PolynomialBound>) -> Option<PolynomialBound> {
        let inner = &of[argument];
        if !matches!(f, Function::Sin | Function::Cos) && !is_exponential(f) {
            // The square of a square root has twice its degree. Other functions are independent
            // atoms.
            return Some(PolynomialBound {
                degree: 2.0 * inner.degree + 1.0,
                bits: 2.0 * inner.bits + 1.0,
                ..inner.clone()
            });
        }
        // k · atom is k · d base angles, where d is the common denominator of all coefficients of
        // this atom. The denominator 0 stands for one that is too large.
        let multiples = angle_atoms(self.arena, argument).into_iter().map(|(atom, k)| match self.finest.get(&atom) {
            Some(0) | None => f64::INFINITY,
            Some(d) => k.to_f64().abs() * *d as f64,
        });
        let degree = multiples.sum::<f64>() + inner.degree;
        Some(PolynomialBound { degree, bits: 2.0 * degree, denominator: Some(1), ..PolynomialBound::default() })
    }
}

/// Bounds of the sum constant + Σ k · term, from the bounds of the terms.
fn bound_of_sum(
    constant: &Rational,
    terms: &[(Expr, Rational)],
    sizes: &Values<'_, PolynomialBound>,
) -> PolynomialBound {
    let mut result = PolynomialBound { bits: f64::NEG_INFINITY, ..PolynomialBound::default() };
    let constant = bound_of_number(constant);
    let one = Rational::ONE;
    let mut common = Some(1_u64);
    let parts = || std::iter::once((&constant, &one)).chain(terms.iter().map(|(term, k)| (&sizes[*term], k)));
    for (part, k) in parts() {
        result.denominator_bits += part.denominator_bits + bits_for_bound(k).1;
        let own = k.small().and_then(|(_, d)| u64::try_from(d).ok());
        let own = own.zip(part.denominator).and_then(|(a, b)| a.checked_mul(b));
        common = common.zip(own).and_then(|(a, b)| (a / a.gcd(&b)).checked_mul(b));
        for (divisor, n) in &part.divisors {
            match result.divisors.iter_mut().find(|(known, _)| known == divisor) {
                Some((_, most)) => *most = most.max(*n),
                None => result.divisors.push((*divisor, *n)),
            }
        }
    }
    result.denominator = common;
    if let Some(common) = common {
        result.denominator_bits = (common as f64).log2();
    }
    for (part, k) in parts() {
        let (mut degree, mut bits) = (part.degree, part.bits + bits_for_bound(k).0 + result.denominator_bits);
        for (divisor, most) in &result.divisors {
            let have = part.divisors.iter().find(|(known, _)| known == divisor).map_or(0.0, |(_, n)| *n);
            degree += (most - have) * sizes[*divisor].degree;
            bits += (most - have) * sizes[*divisor].bits.max(0.0);
        }
        result.degree = result.degree.max(degree);
        result.bits = log_sum(result.bits, bits);
    }
    result
}

/// Bounds of the product Π base^exponent, from the bounds of the bases.
fn bound_of_product(factors: &[(Expr, i32)], sizes: &Values<'_, PolynomialBound>) -> PolynomialBound {
    let mut result = PolynomialBound { denominator: Some(1), ..PolynomialBound::default() };
    for (base, exponent) in factors {
        let (size, n) = (&sizes[*base], f64::from(*exponent));
        let mut below = |divisor: Expr, n: f64| match result.divisors.iter_mut().find(|(known, _)| *known == divisor) {
            Some((_, sum)) => *sum += n,
            None => result.divisors.push((divisor, n)),
        };
        if n > 0.0 {
            size.divisors.iter().for_each(|(divisor, k)| below(*divisor, k * n));
            result.degree += n * size.degree;
            result.bits += n * size.bits.max(0.0);
            result.denominator_bits += n * size.denominator_bits;
            let power = size.denominator.and_then(|d| d.checked_pow(exponent.unsigned_abs()));
            result.denominator = result.denominator.zip(power).and_then(|(a, b)| a.checked_mul(b));
        } else {
            // 1/(N/(d ΠB)) = d ΠB/N.
            below(*base, -n);
            for (divisor, k) in &size.divisors {
                result.degree -= n * k * sizes[*divisor].degree;
                result.bits -= n * k * sizes[*divisor].bits.max(0.0);
            }
            result.bits -= n * size.denominator_bits;
        }
    }
    result
}
