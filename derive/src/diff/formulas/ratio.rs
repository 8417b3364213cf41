//! Ratio of two terms that differ only by a factor: a number, or a term in parameters.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::{Kinematics, Quantities};

/// Ratio a / b, simplified; `None` unless a and b are non-zero and the ratio depends on parameters
/// only.
pub fn constant_ratio(quantities: &mut Quantities<'_>, comparer: &mut Comparer, a: Expr, b: Expr) -> Option<Expr> {
    let parameters = quantities.model.p();
    let Kinematics { arena, simplifier, .. } = &mut quantities.derivations.kinematics;
    if zero_test(arena, a) != ZeroTest::NonZero || zero_test(arena, b) != ZeroTest::NonZero {
        return None;
    }
    let ratio = arena.div(a, b)?;
    let symbols: Vec<Expr> = arena
        .reachable(&[ratio])
        .into_iter()
        .filter(|e| arena.symbol_name(*e).is_some() && !parameters.contains(e))
        .collect();
    for symbol in &symbols {
        let slope = Differential::partial(*symbol).apply(arena, ratio);
        if zero_test(arena, slope) != ZeroTest::Zero {
            return None;
        }
    }
    // The ratio does not depend on these symbols, so that any value may replace them.
    let mut at_one = Substitution::new(&symbols.iter().map(|s| (*s, Expr::ONE)).collect::<Vec<_>>());
    let value = at_one.apply(arena, ratio);
    let value = simplifier.simplify(arena, value);
    // A ratio of 1 or −1 may be hidden by roots.
    let plain = [Expr::ONE, Expr::MINUS_ONE].into_iter().find(|n| comparer.compare(arena, value, *n).is_equal());
    let value = plain.unwrap_or(value);
    let back = arena.mul(value, b);
    comparer.compare(arena, a, back).is_equal().then_some(value)
}

/// Ratio term / own if it is a number; else `None`.
pub(super) fn numerical_ratio(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    term: Expr,
    own: Expr,
) -> Option<Rational> {
    let ratio = arena.div(term, own)?;
    let ratio = simplifier.simplify(arena, ratio);
    arena.as_number(ratio).cloned()
}
