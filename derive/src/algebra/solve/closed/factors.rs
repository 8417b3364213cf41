//! Factors of the numerators of terms, as far as trial division finds them.

use super::workspace::Workspace;
use crate::algebra::form::ring::Ring;
use crate::algebra::form::ring_polynomial::{GENERATORS, Powers, RingPolynomial};
use crate::algebra::meaning::signs::Sign;
use crate::algebra::{Expr, Function, Node, Rational};

/// Largest number of terms of a numerator that is shown in factors; a longer one is only
/// simplified.
const NEAT: usize = 60;

/// Largest number of terms of a polynomial in which factors are searched. In a longer polynomial,
/// only single generators (symbols, sines and the like) are split off.
const MOST_FACTORED: usize = 80;

/// Numerator of a term, split into factors.
#[derive(Clone, Debug, Default)]
pub struct Factors {
    /// Factors without unknowns, with the numerical factor among them, as pairs (factor, exponent).
    pub known: Vec<(Expr, i32)>,
    /// Factors that contain an unknown, as pairs (factor, exponent).
    pub unknown: Vec<(Expr, i32)>,
}

/// Result of splitting a polynomial into two factors.
enum Split {
    /// The polynomial is the product of the two polynomials, up to a number.
    Product([RingPolynomial; 2]),
    /// No factor of the polynomial was found: it is kept as a whole.
    Whole,
    /// The budget of multiplications ended before a factor was found.
    Stopped,
}

impl Workspace<'_> {
    /// Splits the numerator of a term into factors. The lists are empty if the term is 0. `None` if
    /// the budget of multiplications is used up.
    pub fn factors(&mut self, e: Expr) -> Option<Factors> {
        let (above, _) = self.fraction(e)?;
        if above.is_zero() {
            return Some(Factors::default());
        }
        let (content, rest) = above.split_content();
        let mut list: Vec<(RingPolynomial, i32)> = Vec::new();
        let mut open = vec![rest];
        while let Some(p) = open.pop() {
            match self.split(&p) {
                Split::Stopped => return None,
                Split::Product(parts) => open.extend(parts),
                Split::Whole if p.as_constant().is_some() => {}
                Split::Whole => match list.iter_mut().find(|(known, _)| *known == p) {
                    Some((_, n)) => *n += 1,
                    None => list.push((p, 1)),
                },
            }
        }
        let number = self.arena.number(content);
        let mut factors = Factors { known: vec![(number, 1)], unknown: Vec::new() };
        for (p, n) in list {
            let term = self.term(&p);
            let side = if self.unknowns_in(term).is_empty() { &mut factors.known } else { &mut factors.unknown };
            side.push((term, n));
        }
        Some(factors)
    }

    /// Splits a primitive polynomial (with coprime integer coefficients) into a product of two
    /// polynomials, if trial division finds a factor.
    fn split(&mut self, p: &RingPolynomial) -> Split {
        let ring = self.normalizer.ring();
        let common = p.common_powers();
        let degree = |powers: &Powers| (0..GENERATORS).map(|at| usize::from(powers.exponent_of(at))).sum::<usize>();
        if p.terms.len() == 1 && degree(&common) == 1 {
            return Split::Whole;
        }
        for at in 0..ring.size() {
            if common.exponent_of(at) > 0 {
                let generator = Ring::variable(at);
                let Some(rest) = ring.divide(p, &generator) else { return Split::Stopped };
                return Split::Product([generator, rest.split_content().1]);
            }
        }
        if p.terms.len() > MOST_FACTORED {
            return Split::Whole;
        }
        let candidates = self.candidates(p);
        for candidate in candidates {
            if candidate.as_constant().is_none()
                && candidate != *p
                && let Some(rest) = self.normalizer.ring().divide(p, &candidate)
            {
                if rest.as_constant().is_some() {
                    continue;
                }
                return Split::Product([candidate, rest.split_content().1]);
            }
        }
        if self.normalizer.ring().budget > 0 { Split::Whole } else { Split::Stopped }
    }

    /// Candidates for divisors of the polynomial `p`: sines, 1 ± cosine, and common factors of its
    /// coefficients.
    ///
    /// The coefficients are those of the powers of one generator. A common factor divides each of
    /// them, so the candidate is taken from the shortest.
    fn candidates(&mut self, p: &RingPolynomial) -> Vec<RingPolynomial> {
        let used: Vec<usize> = (0..self.normalizer.ring().size())
            .filter(|at| p.terms.iter().any(|(powers, _)| powers.exponent_of(*at) > 0))
            .collect();
        let mut list = Vec::new();
        let one = RingPolynomial::constant(&Rational::ONE);
        for at in &used {
            let e = self.normalizer.expression_of(*at);
            match *self.arena.node(e) {
                Node::Apply(Function::Sin, _) => list.push(Ring::variable(*at)),
                Node::Apply(Function::Cos, _) => {
                    let cosine = Ring::variable(*at);
                    for k in [Rational::ONE, Rational::MINUS_ONE] {
                        let sum = self.normalizer.ring().sum([(&one, Rational::ONE), (&cosine, k)].into_iter());
                        list.extend(sum.map(|sum| sum.split_content().1));
                    }
                }
                _ => {}
            }
        }
        for at in &used {
            let coefficients = Self::coefficients(p, &[*at]);
            let shortest = coefficients.values().min_by_key(|c| c.terms.len()).filter(|_| coefficients.len() > 1);
            let Some(shortest) = shortest else { continue };
            let mut part = shortest.split_content().1;
            // Generators that divide this coefficient need not divide the others, so they are
            // removed.
            let common = part.common_powers();
            for other in 0..self.normalizer.ring().size() {
                for _ in 0..common.exponent_of(other) {
                    match self.normalizer.ring().divide(&part, &Ring::variable(other)) {
                        Some(rest) => part = rest,
                        None => break,
                    }
                }
            }
            if part.terms.len() > 1 && !list.contains(&part) {
                list.push(part);
            }
        }
        list
    }

    /// Writes a term as a fraction with numerator and denominator in factors, each in short form. A
    /// term that is too large is only simplified.
    pub fn short_form_in_factors(&mut self, e: Expr) -> Expr {
        let short = self.short(e);
        let Some((above, below)) = self.fraction(e).filter(|(above, _)| above.terms.len() <= NEAT) else {
            return short;
        };
        let above = self.term(&above);
        let Some(factors) = self.factors(above) else { return short };
        let mut list: Vec<(Expr, i32)> = factors.known.into_iter().chain(factors.unknown).collect();
        for (factor, n) in below {
            let factor = self.term(&factor);
            list.push((factor, -i32::try_from(n).unwrap_or(i32::MAX)));
        }
        let list: Vec<(Expr, i32)> = list.into_iter().map(|(e, n)| (self.short(e), n)).collect();
        if list.is_empty() { Expr::ZERO } else { self.arena.try_product(&list).unwrap_or(short) }
    }

    /// Term with the same sign as the term `e`, but without its positive factors and even powers.
    /// Returns `e` if it is too large.
    pub fn without_positive_factors(&mut self, e: Expr) -> Expr {
        let Some((above, below)) = self.fraction(e) else { return e };
        let above = self.term(&above);
        let Some(factors) = self.factors(above) else { return e };
        let mut list: Vec<(Expr, i32)> = factors.known.into_iter().chain(factors.unknown).collect();
        for (factor, n) in below {
            list.push((self.term(&factor), i32::try_from(n).unwrap_or(1)));
        }
        let mut left = Vec::new();
        for (e, _) in list.into_iter().filter(|(_, n)| n % 2 == 1) {
            match self.sign(e) {
                Sign::Positive => {}
                Sign::Negative => left.push(Expr::MINUS_ONE),
                _ => left.push(e),
            }
        }
        self.arena.product(&left)
    }
}
