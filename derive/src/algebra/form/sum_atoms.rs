//! Atoms of simplification: sums of symbols that are treated like single symbols, such as a sum of
//! masses.
//!
//! Expanding (m₁ + … + m₂₀) l₁ l₂ cos q to twenty terms and factoring them again gains nothing. It
//! could gain only if two sums have the same cofactor, as in (a + b) x − a x.
//! So sums of symbols are treated as atoms first. If the polynomial in these atoms shows such a
//! cofactor, they are expanded after all.

use super::polynomial::{LaurentPolynomial, Monomial};
use crate::algebra::term::elementary::is_sine_or_cosine;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxHashMap, FxHashSet};

/// Sums of symbols that simplification treats as atoms.
#[derive(Default)]
pub struct SumAtoms {
    /// Sums of symbols that simplification treats as single atoms.
    sums: FxHashSet<Expr>,
    /// Symbols that occur in the sums treated as atoms.
    symbols: FxHashSet<Expr>,
}

impl SumAtoms {
    /// Finds the sums of symbols that are factors with positive exponents in the products among the
    /// terms `parts`.
    pub fn new(arena: &Arena, parts: &[Expr]) -> Self {
        let mut found = Self::default();
        for part in parts {
            let Node::Product(factors) = arena.node(*part) else { continue };
            for (base, n) in factors {
                if let Node::Sum(_, terms) = arena.node(*base)
                    && *n > 0
                    && terms.iter().all(|(term, _)| arena.symbol_name(*term).is_some())
                {
                    found.sums.insert(*base);
                    found.symbols.extend(terms.iter().map(|(term, _)| *term));
                }
            }
        }
        found
    }

    /// True if no sum of symbols was found.
    pub fn is_empty(&self) -> bool {
        self.sums.is_empty()
    }

    /// True if the term `e` is a sum of symbols that is treated as an atom.
    pub fn contains(&self, e: Expr) -> bool {
        self.sums.contains(&e)
    }

    /// True if expanding the sums cannot shorten the polynomial. This holds if any two of its terms
    /// that differ in the sums or their symbols differ in other atoms too. Sines and cosines do not
    /// count as other atoms, since they are related.
    pub fn expansion_cannot_shorten(&self, arena: &Arena, polynomial: &LaurentPolynomial) -> bool {
        let mut seen: FxHashMap<Monomial, Monomial> = FxHashMap::default();
        polynomial.terms.keys().all(|monomial| {
            let (mut inside, mut rest) = (Monomial::new(), Monomial::new());
            for factor in monomial {
                if self.sums.contains(&factor.0) || self.symbols.contains(&factor.0) {
                    inside.push(*factor);
                } else if !is_sine_or_cosine(arena, factor.0) {
                    rest.push(*factor);
                }
            }
            *seen.entry(rest).or_insert_with(|| inside.clone()) == inside
        })
    }
}

/// True if any two terms of the polynomial differ in more than sines and cosines, and no term
/// divides by a sine or cosine. Then no trigonometric identity can combine two terms.
pub fn differ_beyond_angles(arena: &Arena, polynomial: &LaurentPolynomial) -> bool {
    let mut seen: FxHashSet<Monomial> = FxHashSet::default();
    polynomial.terms.keys().all(|monomial| {
        let divides = monomial.iter().any(|(e, n)| *n < 0 && is_sine_or_cosine(arena, *e));
        let rest = monomial.iter().copied().filter(|(e, _)| !is_sine_or_cosine(arena, *e)).collect();
        !divides && seen.insert(rest)
    })
}

/// True if `e` is a number times a product without divisors. The factors are symbols, at most one
/// sum of symbols, and sines and cosines of symbols or of sums of symbols. Such a product cannot be
/// shortened.
pub fn is_plain_product(arena: &Arena, e: Expr) -> bool {
    let symbol = |e: Expr| arena.symbol_name(e).is_some();
    let sum_of_symbols = |e: Expr| match arena.node(e) {
        Node::Sum(_, terms) => terms.iter().all(|(term, _)| symbol(*term)),
        _ => symbol(e),
    };
    let is_plain = |e: Expr| match arena.node(e) {
        Node::Apply(Function::Sin | Function::Cos, argument) => match arena.node(*argument) {
            // sin 2q may be shorter as a product, 2 sin q cos q.
            Node::Sum(_, terms) => terms.len() > 1 && sum_of_symbols(*argument),
            _ => symbol(*argument),
        },
        _ => sum_of_symbols(e),
    };
    let inner = match arena.node(e) {
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0].0,
        _ => e,
    };
    match arena.node(inner) {
        Node::Product(factors) => {
            let sums = factors.iter().filter(|(base, _)| matches!(arena.node(*base), Node::Sum(..))).count();
            sums <= 1 && factors.iter().all(|(base, n)| *n > 0 && is_plain(*base))
        }
        Node::Symbol(_) | Node::Apply(..) | Node::Named(..) => is_plain(inner),
        Node::Number(_) | Node::Pi => true,
        Node::Sum(..) => false,
    }
}

/// Creates the polynomial that consists of the single atom `e`.
pub fn atom_polynomial(e: Expr) -> LaurentPolynomial {
    LaurentPolynomial::monomial(vec![(e, 1)], &Rational::ONE)
}
