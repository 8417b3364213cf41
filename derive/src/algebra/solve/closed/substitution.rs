//! Substitution of solved relations into terms. A relation gives an unknown, its square, or its
//! sine, cosine or tangent.

use super::relation::{Relation, RelationKind};
use super::workspace::Workspace;
use crate::algebra::form::polynomial::LaurentPolynomial;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Expr, Function, Node, Rational};

impl Workspace<'_> {
    /// Inserts a relation into the term `e`, as far as the relation determines it. The sign of a
    /// square root, or of the cosine for a given sine, may be undetermined. The unknown, sine or
    /// cosine then remains with the exponent 1.
    ///
    /// `None` if a divisor becomes 0 or the budget of multiplications is used up.
    pub fn substitute_relation(&mut self, relation: &Relation, e: Expr) -> Option<Expr> {
        if !self.arena.mentions(e, relation.unknown) {
            return Some(e);
        }
        if relation.kind == RelationKind::Value {
            let mut put = Substitution::new(&[(relation.unknown, relation.value)]);
            let value = put.apply(self.arena, e);
            return put.undefined.is_none().then_some(value);
        }
        let (above, below) = self.fraction(e)?;
        let above = self.normalizer.polynomial(&above);
        let mut factors = vec![(self.substitute_in_polynomial(relation, &above)?, 1)];
        for (factor, n) in below {
            let factor = self.normalizer.polynomial(&factor);
            let factor = self.substitute_in_polynomial(relation, &factor)?;
            factors.push((factor, -i32::try_from(n).ok()?));
        }
        self.arena.try_product(&factors).ok()
    }

    /// Inserts a relation into each term of a polynomial; `None` if a divisor becomes 0 or the
    /// budget of multiplications is used up.
    fn substitute_in_polynomial(&mut self, relation: &Relation, p: &LaurentPolynomial) -> Option<Expr> {
        let Relation { kind, angle, value, .. } = *relation;
        let square = self.arena.square(value);
        let (sine, cosine) = (self.arena.apply(Function::Sin, angle), self.arena.apply(Function::Cos, angle));
        // sin² + cos² = 1.
        let complement = self.arena.sub(Expr::ONE, square);
        let secant = self.arena.add(Expr::ONE, square);
        let mut terms: Vec<(Expr, Rational)> = Vec::new();
        for (monomial, k) in &p.terms {
            let mut factors: Vec<(Expr, i32)> = Vec::new();
            let mut cosines = 0;
            for (atom, n) in monomial {
                match kind {
                    RelationKind::Square if *atom == angle => factors.extend([(value, n / 2), (angle, n % 2)]),
                    RelationKind::Cosine if *atom == cosine => factors.push((value, *n)),
                    RelationKind::Sine if *atom == sine => factors.push((value, *n)),
                    RelationKind::Sine if *atom == cosine => factors.extend([(complement, n / 2), (cosine, n % 2)]),
                    RelationKind::Tangent if *atom == sine => {
                        factors.push((value, *n));
                        cosines += n;
                    }
                    RelationKind::Tangent if *atom == cosine => cosines += n,
                    _ => factors.push((self.substitute_in_argument(relation, *atom)?, *n)),
                }
            }
            // 1 + tan² = 1/cos².
            factors.extend([(secant, -(cosines / 2)), (cosine, cosines % 2)]);
            terms.push((self.arena.try_product(&factors).ok()?, k.clone()));
        }
        Some(self.arena.linear_combination(&terms))
    }

    /// Inserts a relation into the argument of a function, for example into √x² if the relation
    /// gives x². Sines, cosines and other atoms are returned unchanged. `None` if a divisor becomes
    /// 0 or the budget of multiplications is used up.
    fn substitute_in_argument(&mut self, relation: &Relation, atom: Expr) -> Option<Expr> {
        let Node::Apply(f, argument) = *self.arena.node(atom) else { return Some(atom) };
        if !self.arena.mentions(argument, relation.unknown) || matches!(f, Function::Sin | Function::Cos) {
            return Some(atom);
        }
        let argument = self.substitute_relation(relation, argument)?;
        Some(self.arena.apply(f, argument))
    }

    /// Inserts several relations into a term in sequence; `None` if a divisor becomes 0 or the
    /// budget of multiplications is used up.
    pub fn substitute_relations(&mut self, relations: &[Relation], e: Expr) -> Option<Expr> {
        relations.iter().try_fold(e, |e, relation| self.substitute_relation(relation, e))
    }
}
