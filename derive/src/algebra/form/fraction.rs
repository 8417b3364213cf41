//! Fractions of polynomials of a [`Ring`], with factored denominators.
//!
//! Invariants: the denominator is a product of primitive polynomials (integer coefficients without
//! a common factor). They are not constant and do not divide the numerator. Some of them are single
//! generators.
//! A fraction is identically zero exactly if its numerator is zero. Two equal fractions may still
//! have different denominators, since factors are found by trial division and not by factorization.

use super::ring::Ring;
use super::ring_polynomial::RingPolynomial;
use crate::algebra::Rational;
use std::rc::Rc;

/// Fraction of polynomials: numerator / Π factor^exponent.
#[derive(Clone, PartialEq, Eq, Default)]
pub struct Fraction {
    /// Polynomial in the numerator of the fraction.
    pub numerator: RingPolynomial,
    /// Factors of the denominator, as pairs (polynomial, exponent) with exponents of at least 1.
    pub denominator: Vec<(RingPolynomial, u32)>,
}

impl Fraction {
    /// Creates the fraction with the given numerator and the denominator 1.
    pub fn from_polynomial(numerator: RingPolynomial) -> Self {
        Self { numerator, denominator: Vec::new() }
    }

    /// True if the fraction is 0, so that its numerator has no terms.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Product of two fractions; `None` if the ring's budget of multiplications is used up.
    pub fn mul(&self, ring: &mut Ring, other: &Self) -> Option<Self> {
        let numerator = ring.mul(&self.numerator, &other.numerator)?;
        let mut denominator = self.denominator.clone();
        for (factor, n) in &other.denominator {
            add_factor(&mut denominator, factor, *n);
        }
        let whole = self.denominator.is_empty() && other.denominator.is_empty();
        let product = Self { numerator, denominator };
        if whole { Some(product) } else { product.cancel_common_factors(ring) }
    }

    /// Linear combination Σ k · fraction over the pairs (fraction, k), with a common denominator.
    /// `None` if the ring's budget of multiplications is used up.
    pub fn sum(ring: &mut Ring, parts: &[(&Self, Rational)]) -> Option<Self> {
        let common = common_denominator(parts.iter().map(|(part, _)| *part));
        if common.is_empty() {
            return Some(Self::from_polynomial(ring.sum(parts.iter().map(|(part, k)| (&part.numerator, k.clone())))?));
        }
        // Fractions with equal denominators are added first, so that few products are formed.
        let mut groups: Vec<Group<'_>> = Vec::new();
        for (part, k) in parts {
            match groups.iter_mut().find(|(denominator, _)| *denominator == part.denominator.as_slice()) {
                Some((_, group)) => group.push((&part.numerator, k.clone())),
                None => groups.push((&part.denominator, vec![(&part.numerator, k.clone())])),
            }
        }
        let mut numerators = Vec::new();
        for (denominator, group) in groups {
            let numerator = ring.sum(group.into_iter())?;
            numerators.push(numerator_over(ring, &numerator, denominator, &common)?);
        }
        let numerator = ring.sum(numerators.iter().map(|n| (n, Rational::ONE)))?;
        Self { numerator, denominator: common }.cancel_common_factors(ring)
    }

    /// Power of the fraction with an exponent of either sign. `None` for a negative power of 0, or
    /// if the ring's budget of multiplications is used up.
    pub fn pow(&self, ring: &mut Ring, n: i32) -> Option<Self> {
        let base = if n < 0 { self.inverse(ring)? } else { self.clone() };
        let n = n.unsigned_abs();
        let numerator = ring.pow(&base.numerator, n)?;
        let denominator = base.denominator.into_iter().map(|(factor, k)| (factor, k * n)).collect();
        Self { numerator, denominator }.cancel_common_factors(ring)
    }

    /// Reciprocal of the fraction; `None` for 0, or if the ring's budget of multiplications is used
    /// up.
    fn inverse(&self, ring: &mut Ring) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        let mut numerator = RingPolynomial::constant(&Rational::ONE);
        for (factor, n) in &self.denominator {
            let power = ring.pow(factor, *n)?;
            numerator = ring.mul(&numerator, &power)?;
        }
        let (content, mut rest) = self.numerator.split_content();
        let mut denominator = Vec::new();
        let common = rest.common_powers();
        for at in 0..ring.size() {
            if common.exponent_of(at) > 0 {
                let generator = Ring::variable(at);
                for _ in 0..common.exponent_of(at) {
                    rest = ring.divide(&rest, &generator)?;
                }
                denominator.push((generator, u32::from(common.exponent_of(at))));
            }
        }
        let (more, rest) = rest.split_content();
        if rest.as_constant().is_none() {
            denominator.push((rest, 1));
        }
        let k = content.mul(&more).reciprocal()?;
        Self { numerator: numerator.scaled(&k), denominator }.cancel_common_factors(ring)
    }

    /// Cancels common factors of numerator and denominator, as far as trial division finds them.
    /// `None` if the ring's budget of multiplications is used up.
    fn cancel_common_factors(mut self, ring: &mut Ring) -> Option<Self> {
        if self.numerator.is_zero() {
            return Some(Self::default());
        }
        for (factor, n) in &mut self.denominator {
            while *n > 0
                && let Some(quotient) = ring.divide(&self.numerator, factor)
            {
                self.numerator = quotient;
                *n -= 1;
            }
        }
        self.denominator.retain(|(_, n)| *n > 0);
        (ring.budget > 0).then_some(self)
    }
}

/// Group of summands with the same denominator: that denominator, and pairs (numerator,
/// coefficient).
type Group<'a> = (&'a [(RingPolynomial, u32)], Vec<(&'a RingPolynomial, Rational)>);

/// Numerators of the given fractions over their common denominator, in the same order. `None` if
/// the ring's budget of multiplications is used up.
pub fn over_common_denominator(ring: &mut Ring, list: &[Rc<Fraction>]) -> Option<Vec<RingPolynomial>> {
    let common = common_denominator(list.iter().map(Rc::as_ref));
    list.iter().map(|part| numerator_over(ring, &part.numerator, &part.denominator, &common)).collect()
}

/// Common denominator of fractions: each factor with its largest exponent.
fn common_denominator<'a>(list: impl Iterator<Item = &'a Fraction>) -> Vec<(RingPolynomial, u32)> {
    let mut common: Vec<(RingPolynomial, u32)> = Vec::new();
    for (factor, n) in list.flat_map(|part| &part.denominator) {
        match common.iter_mut().find(|(known, _)| known == factor) {
            Some((_, most)) => *most = (*most).max(*n),
            None => common.push((factor.clone(), *n)),
        }
    }
    common
}

/// Numerator of a fraction over the denominator `common`, given its numerator over `denominator`.
/// `None` if the ring's budget of multiplications is used up.
fn numerator_over(
    ring: &mut Ring,
    numerator: &RingPolynomial,
    denominator: &[(RingPolynomial, u32)],
    common: &[(RingPolynomial, u32)],
) -> Option<RingPolynomial> {
    let mut numerator = numerator.clone();
    for (factor, most) in common {
        let have = denominator.iter().find(|(known, _)| known == factor).map_or(0, |(_, n)| *n);
        let missing = ring.pow(factor, most - have)?;
        numerator = ring.mul(&numerator, &missing)?;
    }
    Some(numerator)
}

/// Multiplies a factored denominator by factor^n.
fn add_factor(denominator: &mut Vec<(RingPolynomial, u32)>, factor: &RingPolynomial, n: u32) {
    match denominator.iter_mut().find(|(known, _)| known == factor) {
        Some((_, most)) => *most += n,
        None => denominator.push((factor.clone(), n)),
    }
}
