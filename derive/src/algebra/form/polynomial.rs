//! Laurent polynomials over ℚ in arbitrary atoms: the form of terms in which [`super::simplify`]
//! works.
//!
//! Invariant: no coefficient is zero; monomials are sorted by atom and have no zero exponents. An
//! atom is any term that is not expanded, such as a symbol or a function value.
//! These polynomials are separate from those of `ring`, whose generators are numbered and have
//! known squares. Here every atom is independent and may have negative exponents.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use std::collections::BTreeMap;

/// Monomial Π atom^exponent as pairs (atom, exponent), sorted by atom. The empty list is 1;
/// exponents may be negative.
pub type Monomial = Vec<(Expr, i32)>;

/// Laurent polynomial Σ coefficient · monomial with rational coefficients, in terms of the arena as
/// atoms.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LaurentPolynomial {
    /// Rational coefficient of each monomial of the polynomial, never zero.
    pub terms: BTreeMap<Monomial, Rational>,
}

impl LaurentPolynomial {
    /// Creates the polynomial coefficient · monomial.
    #[must_use]
    pub fn monomial(monomial: Monomial, coefficient: &Rational) -> Self {
        let mut result = Self::default();
        result.add_term(monomial, coefficient);
        result
    }

    /// Creates a constant polynomial.
    #[must_use]
    pub fn constant(value: &Rational) -> Self {
        Self::monomial(Vec::new(), value)
    }

    /// Reads a term of the arena as a polynomial, without expanding it. Each summand becomes a
    /// monomial in its factors.
    pub(super) fn read_sum(arena: &Arena, e: Expr) -> Self {
        let monomial = |e: Expr| match arena.node(e) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(e, 1)],
        };
        match arena.node(e) {
            Node::Number(value) => Self::constant(value),
            Node::Sum(constant, terms) => {
                let mut sum = Self::constant(constant);
                for (term, k) in terms {
                    sum.add_term(monomial(*term), k);
                }
                sum
            }
            _ => Self::monomial(monomial(e), &Rational::ONE),
        }
    }

    /// Adds the term coefficient · monomial to the polynomial.
    pub fn add_term(&mut self, monomial: Monomial, coefficient: &Rational) {
        if coefficient.is_zero() {
            return;
        }
        match self.terms.entry(monomial) {
            std::collections::btree_map::Entry::Vacant(place) => {
                place.insert(coefficient.clone());
            }
            std::collections::btree_map::Entry::Occupied(mut place) => {
                let sum = place.get().add(coefficient);
                if sum.is_zero() {
                    place.remove();
                } else {
                    *place.get_mut() = sum;
                }
            }
        }
    }

    /// Adds k · other to the polynomial, for a polynomial `other` and a number k.
    pub fn add_scaled(&mut self, other: &Self, k: &Rational) {
        for (monomial, coefficient) in &other.terms {
            self.add_term(monomial.clone(), &coefficient.mul(k));
        }
    }

    /// Product of two polynomials; `None` if it could have more than `limit` terms.
    #[must_use]
    pub fn mul(&self, other: &Self, limit: usize) -> Option<Self> {
        if self.terms.len().saturating_mul(other.terms.len()) > limit {
            return None;
        }
        let mut result = Self::default();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                result.add_term(multiply_monomials(a, b), &x.mul(y));
            }
        }
        Some(result)
    }

    /// Power of the polynomial with the exponent n. A polynomial of several terms needs n ≥ 0.
    /// `None` for a negative power of a sum, or if the result could have more than `limit` terms.
    #[must_use]
    pub fn pow(&self, n: i32, limit: usize) -> Option<Self> {
        if let (1, Some((monomial, k))) = (self.terms.len(), self.terms.first_key_value()) {
            let monomial = monomial.iter().map(|(e, m)| Some((*e, m.checked_mul(n)?))).collect::<Option<_>>()?;
            return Some(Self::monomial(monomial, &k.pow(n)?));
        }
        let mut result = Self::constant(&Rational::ONE);
        for _ in 0..u32::try_from(n).ok()? {
            result = result.mul(self, limit)?;
        }
        Some(result)
    }

    /// Converts the polynomial to an expression: the sum of its terms.
    pub fn expand(&self, arena: &mut Arena) -> Expr {
        let terms: Vec<_> = self.terms.iter().map(|(m, k)| (monomial_expr(arena, m), k.clone())).collect();
        arena.linear_combination(&terms)
    }

    /// Replaces powers f^k, k ≥ 2, by (1 − g²)^⌊k/2⌋ · f^(k mod 2). `f` and `g` are the sine and
    /// cosine of an angle, in either order. `None` if the result has more than `limit` terms.
    #[must_use]
    pub fn replace_squares(&self, f: Expr, g: Expr, limit: usize) -> Option<Self> {
        // A power becomes as many terms as half its exponent, so many high powers are not expanded.
        let halves = self.terms.keys().flatten().filter(|(e, _)| *e == f).map(|(_, n)| n.unsigned_abs() as usize / 2);
        if halves.sum::<usize>() > 10 * limit {
            return None;
        }
        let mut complement = Self::constant(&Rational::ONE);
        complement.add_term(vec![(g, 2)], &Rational::MINUS_ONE);
        let mut result = Self::default();
        for (monomial, k) in &self.terms {
            match monomial.iter().position(|(e, n)| *e == f && *n >= 2) {
                None => result.add_term(monomial.clone(), k),
                Some(at) => {
                    let mut rest = monomial.clone();
                    let n = rest[at].1;
                    rest[at].1 = n % 2;
                    rest.retain(|(_, n)| *n != 0);
                    let power = complement.pow(n / 2, limit)?;
                    result.add_scaled(&power.mul(&Self::monomial(rest, k), limit)?, &Rational::ONE);
                }
            }
            if result.terms.len() > limit {
                return None;
            }
        }
        Some(result)
    }

    /// True if the atom has an exponent of 2 or more in any term of the polynomial.
    #[must_use]
    pub fn has_square(&self, atom: Expr) -> bool {
        self.terms.keys().flatten().any(|(e, n)| *e == atom && *n >= 2)
    }

    /// True if atom `a` or atom `b` has a negative exponent in any term of the polynomial.
    #[must_use]
    pub fn divides_by(&self, a: Expr, b: Expr) -> bool {
        self.terms.keys().flatten().any(|(e, n)| (*e == a || *e == b) && *n < 0)
    }

    /// Angles whose sine or cosine is an atom of the polynomial, each once.
    #[must_use]
    pub fn angles(&self, arena: &Arena) -> Vec<Expr> {
        let mut angles: Vec<Expr> = self
            .terms
            .keys()
            .flatten()
            .filter_map(|(e, _)| match arena.node(*e) {
                Node::Apply(Function::Sin | Function::Cos, angle) => Some(*angle),
                _ => None,
            })
            .collect();
        angles.sort_unstable();
        angles.dedup();
        angles
    }

    /// Splits the polynomial into monomial · content · rest, where the terms of the rest have no common
    /// factor.
    pub(super) fn split_common_factor(&self) -> (Monomial, Rational, Self) {
        let Some(first) = self.terms.keys().next() else {
            return (Vec::new(), Rational::ONE, Self::default());
        };
        let mut common = first.clone();
        let mut content = Rational::ZERO;
        for (monomial, k) in &self.terms {
            content = content.greatest_common_divisor(k);
            for (atom, n) in &mut common {
                let m = monomial.iter().find(|(e, _)| e == atom).map_or(0, |(_, m)| *m);
                // The part of the exponent that both monomials share, with the sign of the exponent.
                *n = if *n > 0 { (*n).min(m).max(0) } else { (*n).max(m).min(0) };
            }
        }
        common.retain(|(_, n)| *n != 0);
        let negative = self.terms.values().next().is_some_and(Rational::is_negative);
        let content = if negative { content.neg() } else { content };
        let inverse = content.reciprocal().unwrap_or(Rational::ONE);
        let mut rest = Self::default();
        for (monomial, k) in &self.terms {
            let mut left: Monomial = monomial
                .iter()
                .map(|(e, n)| (*e, n - common.iter().find(|(c, _)| c == e).map_or(0, |(_, m)| *m)))
                .collect();
            left.retain(|(_, n)| *n != 0);
            rest.add_term(left, &k.mul(&inverse));
        }
        (common, content, rest)
    }

    /// Atom that occurs in most terms of the polynomial with exponents of one sign, and true if
    /// that sign is positive. If several atoms tie, the first is taken. `None` if no two terms
    /// share an atom.
    pub(super) fn most_shared_atom(&self) -> Option<(Expr, bool)> {
        let mut counts: BTreeMap<(Expr, bool), usize> = BTreeMap::new();
        for (atom, n) in self.terms.keys().flatten() {
            *counts.entry((*atom, *n > 0)).or_default() += 1;
        }
        let most = counts.values().copied().max().filter(|most| *most >= 2)?;
        counts.into_iter().find(|(_, count)| *count == most).map(|(key, _)| key)
    }
}

/// Product of two monomials, each given as pairs (atom, exponent) sorted by atom.
#[must_use]
pub fn multiply_monomials(a: &[(Expr, i32)], b: &[(Expr, i32)]) -> Monomial {
    let mut result = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        match (a.get(i), b.get(j)) {
            (Some(x), Some(y)) if x.0 == y.0 => {
                if x.1 + y.1 != 0 {
                    result.push((x.0, x.1 + y.1));
                }
                i += 1;
                j += 1;
            }
            (Some(x), y) if y.is_none_or(|y| x.0 < y.0) => {
                result.push(*x);
                i += 1;
            }
            (_, Some(y)) => {
                result.push(*y);
                j += 1;
            }
            (_, None) => unreachable!("one of the two has a factor left"),
        }
    }
    result
}

/// Converts a monomial to an expression.
pub fn monomial_expr(arena: &mut Arena, monomial: &Monomial) -> Expr {
    arena.try_product(monomial).expect("atoms are not zero and exponents small")
}
