//! Working tools of the search for closed forms: numerators, factors, coefficients and signs of
//! terms in normal form.

use super::BUDGET;
use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::form::ring_polynomial::{Powers, RingPolynomial};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::signs::Sign;
use crate::algebra::{Arena, Expr, Function, Node};
use std::collections::BTreeMap;

/// Role of a generator (a variable of the normal form, such as a sine) with respect to one unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The generator of the normal form is the unknown itself.
    Plain,
    /// The generator of the normal form is the sine of an angle, which is the unknown times a term
    /// without unknowns.
    Sine(Expr),
    /// The generator of the normal form is the cosine of an angle, which is the unknown times a
    /// term without unknowns.
    Cosine(Expr),
    /// The generator of the normal form depends on the unknown, but in none of the other ways.
    Mixed,
}

/// Workspace in which a system is solved in closed form: arena, algebraic tools and unknowns.
pub struct Workspace<'a> {
    /// Arena of the terms.
    pub arena: &'a mut Arena,
    /// Converter to normal forms, with the budget of multiplications.
    pub normalizer: Normalizer,
    /// Simplifier that brings results to short form.
    pub simplifier: Simplifier,
    /// Comparer that decides if terms are zero.
    pub comparer: Comparer,
    /// Unknowns of the system; preferred unknowns come first.
    pub unknowns: Vec<Expr>,
    /// Number of unknowns, from the first, that are preferred at any cost.
    pub asked: usize,
    /// True if a tangent may be given in terms of other unknown angles, even if other equations
    /// contain its unknown.
    pub keeps_tangents: bool,
}

impl<'a> Workspace<'a> {
    /// Creates the workspace for a system with the given unknowns. The first `asked` unknowns are
    /// preferred.
    pub fn new(arena: &'a mut Arena, unknowns: &[Expr], asked: usize) -> Self {
        let normalizer = Normalizer::new(BUDGET);
        let (simplifier, comparer) = (Simplifier::default(), Comparer::default());
        Self { arena, normalizer, simplifier, comparer, unknowns: unknowns.to_vec(), asked, keeps_tangents: true }
    }

    /// Unknowns of the system that occur in the term `e`.
    pub fn unknowns_in(&self, e: Expr) -> Vec<Expr> {
        let parts = self.arena.reachable(&[e]);
        self.unknowns.iter().copied().filter(|x| parts.binary_search(x).is_ok()).collect()
    }

    /// Numerator of a term in normal form, and factors of its denominator as pairs (polynomial,
    /// exponent). `None` if the budget of multiplications is used up.
    pub fn fraction(&mut self, e: Expr) -> Option<(RingPolynomial, Vec<(RingPolynomial, u32)>)> {
        let form = self.normalizer.normal_form(self.arena, e)?;
        Some((form.numerator.clone(), form.denominator.clone()))
    }

    /// Converts a polynomial to a term, multiplied out.
    pub fn term(&mut self, p: &RingPolynomial) -> Expr {
        self.normalizer.polynomial(p).expand(self.arena)
    }

    /// Brings a term to short form.
    pub fn short(&mut self, e: Expr) -> Expr {
        self.simplifier.simplify(self.arena, e)
    }

    /// Quotient a / b in short form; `None` if b is the literal 0.
    pub fn quotient(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        let quotient = self.arena.div(a, b)?;
        Some(self.short(quotient))
    }

    /// True if the normal form of the term is 0. False also if the budget of multiplications is
    /// used up first.
    pub fn is_zero(&mut self, e: Expr) -> bool {
        self.fraction(e).is_some_and(|(above, _)| above.is_zero())
    }

    /// Role of a generator of the normal form with respect to the unknown `x`. The generator must
    /// contain `x`.
    pub fn role(&mut self, generator: Expr, x: Expr) -> Role {
        if generator == x {
            return Role::Plain;
        }
        let Node::Apply(f @ (Function::Sin | Function::Cos), angle) = *self.arena.node(generator) else {
            return Role::Mixed;
        };
        let Some(factor) = self.arena.div(angle, x) else { return Role::Mixed };
        match f {
            _ if !self.unknowns_in(factor).is_empty() => Role::Mixed,
            Function::Sin => Role::Sine(angle),
            _ => Role::Cosine(angle),
        }
    }

    /// Numbers of the generators (variables of the normal form) that occur in a polynomial and
    /// contain the unknown `x`.
    pub fn generators_of(&mut self, p: &RingPolynomial, x: Expr) -> Vec<usize> {
        let size = self.normalizer.ring().size();
        let used = (0..size).filter(|at| p.terms.iter().any(|(powers, _)| powers.exponent_of(*at) > 0));
        used.filter(|at| self.arena.mentions(self.normalizer.expression_of(*at), x)).collect()
    }

    /// Coefficients of a polynomial in the given generators: for each product of their powers, a
    /// polynomial in all other generators.
    pub fn coefficients(p: &RingPolynomial, generators: &[usize]) -> BTreeMap<Powers, RingPolynomial> {
        let mut list: BTreeMap<Powers, RingPolynomial> = BTreeMap::new();
        for (powers, k) in &p.terms {
            let (inside, outside) = powers.split(generators);
            list.entry(inside).or_default().terms.push((outside, k.clone()));
        }
        // The terms of a coefficient remain in descending order, because the same powers were
        // removed from each of them.
        list
    }

    /// Sign of a term, as far as it follows from positive symbols, even powers and roots in its
    /// normal form. `Unknown` if the budget of multiplications is used up.
    pub fn sign(&mut self, e: Expr) -> Sign {
        let Some((above, below)) = self.fraction(e) else { return Sign::Unknown };
        let mut sign = self.sign_of(&above);
        for (factor, n) in &below {
            sign = match (self.sign_of(factor), n % 2) {
                (Sign::Positive | Sign::NotNegative, _) | (_, 0) => sign,
                (Sign::Negative | Sign::NotPositive, _) => sign.negated(),
                (Sign::Unknown, _) => Sign::Unknown,
            };
        }
        sign
    }

    /// Sign of a polynomial whose terms all have the same sign; `Unknown` for other polynomials.
    fn sign_of(&mut self, p: &RingPolynomial) -> Sign {
        let Some((_, first)) = p.terms.first() else { return Sign::NotNegative };
        let negative = first.is_negative();
        let mut strict = false;
        for (powers, k) in &p.terms {
            if k.is_negative() != negative {
                return Sign::Unknown;
            }
            let mut is_strict = true;
            for at in 0..self.normalizer.ring().size() {
                let n = powers.exponent_of(at);
                let e = self.normalizer.expression_of(at);
                let is_root = matches!(self.arena.node(e), Node::Apply(Function::Sqrt | Function::Abs, _));
                match n {
                    0 => {}
                    _ if self.arena.is_positive(e) || *self.arena.node(e) == Node::Pi => {}
                    _ if n % 2 == 0 || is_root => is_strict = false,
                    _ => return Sign::Unknown,
                }
            }
            strict |= is_strict;
        }
        let sign = if strict { Sign::Positive } else { Sign::NotNegative };
        if negative { sign.negated() } else { sign }
    }
}
