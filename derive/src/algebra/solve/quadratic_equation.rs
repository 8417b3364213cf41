//! Equations that are at most quadratic in one symbol, with their solution.

use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Rational};

/// Equation A x² + B x + C = 0 in one symbol x.
pub(crate) struct QuadraticEquation {
    /// Coefficient A of x², a term without x.
    pub(crate) a: Expr,
    /// Coefficient B of x, a term without x.
    pub(crate) b: Expr,
    /// Term C, which is the value of the left side at x = 0.
    pub(crate) c: Expr,
}

impl QuadraticEquation {
    /// Reads the coefficients of an equation in a symbol. `None` unless the equation depends on the
    /// symbol and is at most quadratic in it.
    pub(crate) fn new(arena: &mut Arena, equation: Expr, symbol: Expr) -> Option<Self> {
        let mut along = Differential::partial(symbol);
        let slope = along.apply(arena, equation);
        let bend = along.apply(arena, slope);
        let mut at_zero = Substitution::new(&[(symbol, Expr::ZERO)]);
        let (b, c) = (at_zero.apply(arena, slope), at_zero.apply(arena, equation));
        let a = arena.scale(bend, &Rational::fraction(1, 2)?);
        let is_free = [a, b, c].into_iter().all(|e| !arena.mentions(e, symbol));
        let depends = [a, b].into_iter().any(|e| zero_test(arena, e) == ZeroTest::NonZero);
        (is_free && depends).then_some(Self { a, b, c })
    }

    /// True if A = 0, so that the equation is linear in the symbol.
    pub(crate) fn is_linear(&self) -> bool {
        self.a == Expr::ZERO
    }

    /// Solution x of A x² + B x + C = 0. It is −C/B for a linear equation. Otherwise it is the root
    /// −B/(2 A) + √(B²/(4 A²) − C/A). `None` if a divisor is zero.
    pub(crate) fn value(&self, arena: &mut Arena) -> Option<Expr> {
        if self.is_linear() {
            let quotient = arena.div(self.c, self.b)?;
            return Some(arena.neg(quotient));
        }
        // −B/(2 A) + √(B²/(4 A²) − C/A).
        let twice = arena.add(self.a, self.a);
        let middle = arena.div(self.b, twice)?;
        let (square, product) = (arena.square(middle), arena.div(self.c, self.a)?);
        let radicand = arena.sub(square, product);
        let root = arena.apply(Function::Sqrt, radicand);
        Some(arena.sub(root, middle))
    }
}
