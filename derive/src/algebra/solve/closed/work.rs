//! Tools of the closed-form search: numerators, factors, coefficients and signs of terms in normal form.

use super::BUDGET;
use crate::algebra::form::normal::Normalizer;
use crate::algebra::form::ring::{Poly, Powers};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::signs::Sign;
use crate::algebra::{Arena, Expr, Function, Node};
use std::collections::BTreeMap;

/// Dependence of a generator on an unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The generator is the unknown itself.
    Plain,
    /// The generator is the sine of this angle: the unknown times a term without unknowns.
    Sine(Expr),
    /// The generator is the cosine of this angle: the unknown times a term without unknowns.
    Cosine(Expr),
    /// The generator depends on the unknown in another way.
    Mixed,
}

/// Arena, engines and unknowns with which one system is solved.
pub struct Work<'a> {
    pub arena: &'a mut Arena,
    pub normalizer: Normalizer,
    pub simplifier: Simplifier,
    pub comparer: Comparer,
    pub unknowns: Vec<Expr>,
    pub asked: usize,
    /// True if a tangent may be given in terms of unknown angles while other rows mention its unknown.
    pub keeps_tangents: bool,
}

impl<'a> Work<'a> {
    pub fn new(arena: &'a mut Arena, unknowns: &[Expr], asked: usize) -> Self {
        let normalizer = Normalizer::new(BUDGET);
        let (simplifier, comparer) = (Simplifier::default(), Comparer::default());
        Self { arena, normalizer, simplifier, comparer, unknowns: unknowns.to_vec(), asked, keeps_tangents: true }
    }

    /// Unknowns of the system that a term mentions.
    pub fn unknowns_in(&self, e: Expr) -> Vec<Expr> {
        let parts = self.arena.reachable(&[e]);
        self.unknowns.iter().copied().filter(|x| parts.binary_search(x).is_ok()).collect()
    }

    /// Numerator and factors of the denominator of a term in normal form; `None` beyond the budget.
    pub fn fraction(&mut self, e: Expr) -> Option<(Poly, Vec<(Poly, u32)>)> {
        let form = self.normalizer.fraction(self.arena, e)?;
        Some((form.numerator.clone(), form.denominator.clone()))
    }

    /// A polynomial as a term, multiplied out.
    pub fn term(&mut self, p: &Poly) -> Expr {
        self.normalizer.polynomial(p).expand(self.arena)
    }

    /// Simplifies a term to its short form.
    pub fn short(&mut self, e: Expr) -> Expr {
        self.simplifier.simplify(self.arena, e)
    }

    /// Quotient a / b, simplified; `None` if the divisor is the literal 0.
    pub fn quotient(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        let quotient = self.arena.div(a, b)?;
        Some(self.short(quotient))
    }

    /// True if a term is 0 by its normal form.
    pub fn is_zero(&mut self, e: Expr) -> bool {
        self.fraction(e).is_some_and(|(above, _)| above.is_zero())
    }

    /// Dependence of a generator on an unknown that it mentions.
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

    /// Numbers of the generators in a polynomial that mention the unknown `x`.
    pub fn generators_of(&mut self, p: &Poly, x: Expr) -> Vec<usize> {
        let size = self.normalizer.ring().size();
        let used = (0..size).filter(|at| p.terms.iter().any(|(powers, _)| powers.of(*at) > 0));
        used.filter(|at| self.arena.mentions(self.normalizer.expression_of(*at), x)).collect()
    }

    /// Coefficients of a polynomial by the powers of some generators.
    pub fn coefficients(p: &Poly, generators: &[usize]) -> BTreeMap<Powers, Poly> {
        let mut list: BTreeMap<Powers, Poly> = BTreeMap::new();
        for (powers, k) in &p.terms {
            let (inside, outside) = powers.split(generators);
            list.entry(inside).or_default().terms.push((outside, k.clone()));
        }
        // The order of terms stays falling: the terms of one coefficient lack the same powers.
        list
    }

    /// Sign of a term, as far as it follows from positive symbols, even powers and roots.
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

    fn sign_of(&mut self, p: &Poly) -> Sign {
        let Some((_, first)) = p.terms.first() else { return Sign::NotNegative };
        let negative = first.is_negative();
        let mut strict = false;
        for (powers, k) in &p.terms {
            if k.is_negative() != negative {
                return Sign::Unknown;
            }
            let mut is_strict = true;
            for at in 0..self.normalizer.ring().size() {
                let n = powers.of(at);
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
