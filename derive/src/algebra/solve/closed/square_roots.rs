//! Square roots in equations: the root of a square is taken, and other roots are removed by
//! multiplication.

use super::workspace::Workspace;
use crate::algebra::form::ring_polynomial::RingPolynomial;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Expr, Function, Node};

impl Workspace<'_> {
    /// Removes a square root whose argument contains unknowns from a factor of an equation. The
    /// result is the norm (A + B √x) (A − B √x), which is 0 wherever the factor A + B √x is 0.
    /// `None` if the factor has no such root.
    pub fn without_root(&mut self, factor: Expr) -> Option<Expr> {
        let (p, _) = self.fraction(factor)?;
        let root = (0..self.normalizer.ring().size()).rev().find(|at| {
            let e = self.normalizer.expression_of(*at);
            let is_used = p.terms.iter().any(|(powers, _)| powers.exponent_of(*at) > 0);
            is_used && matches!(self.arena.node(e), Node::Apply(Function::Sqrt, _)) && !self.unknowns_in(e).is_empty()
        })?;
        // The norm is (A + B √x) (A − B √x).
        let other = p.terms.iter().map(|(m, k)| (*m, if m.exponent_of(root) % 2 == 1 { k.neg() } else { k.clone() }));
        let other = RingPolynomial { terms: other.collect() };
        let norm = self.normalizer.ring().mul(&p, &other)?;
        Some(self.term(&norm))
    }

    /// Square root of the term `e`. If `e` is the square of a rational term p, the result is p or
    /// −p, and the sign of the result is not checked.
    pub fn root_of(&mut self, e: Expr) -> Expr {
        match self.rational_root(e) {
            Some(root) => root,
            None => self.arena.apply(Function::Sqrt, e),
        }
    }

    /// Rational term p with p² = e; its sign is arbitrary. `None` if no such term is found.
    fn rational_root(&mut self, e: Expr) -> Option<Expr> {
        let (above, below) = self.fraction(e)?;
        let above = self.normalizer.ring().square_root(&above)?;
        let mut factors = vec![(self.term(&above), 1)];
        for (factor, n) in below {
            let n = i32::try_from(n).ok().filter(|n| n % 2 == 0)?;
            factors.push((self.term(&factor), -n / 2));
        }
        self.arena.try_product(&factors).ok()
    }

    /// Finds a square root √p² in a term. Returns p, and two terms with the root replaced by p and
    /// by −p. `None` if the term has no such root.
    pub fn split_root(&mut self, e: Expr) -> Option<(Expr, [Expr; 2])> {
        let parts = self.arena.reachable(&[e]);
        let mut roots = parts.into_iter().filter_map(|part| match *self.arena.node(part) {
            Node::Apply(Function::Sqrt, argument) => Some((part, argument)),
            _ => None,
        });
        let roots: Vec<(Expr, Expr)> = roots.by_ref().collect();
        roots.into_iter().find_map(|(root, argument)| {
            let p = self.rational_root(argument)?;
            let minus = self.arena.neg(p);
            let values = [p, minus].map(|p| Substitution::new(&[(root, p)]).apply(self.arena, e));
            Some((p, values))
        })
    }
}
