//! Formulas for readers: named terms are written out where the whole stays short.

use super::simplify::Simplifier;
use crate::algebra::term::calculus::without_names;
use crate::algebra::text::print::length;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};

/// Most nodes of a formula that is written out, some ten lines of text.
const MOST_READ: usize = 250;

/// Most nodes of a formula that is simplified in the hope of a short one.
const MOST_SIMPLIFIED: usize = 5_000;

/// The formula with its named terms written out and simplified, if it then has at most some ten lines; else `e` itself.
/// The result is proved equal to `e` modulo primes.
pub fn readable(arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
    let whole = without_names(arena, e);
    if whole == e || length(arena, whole) > MOST_SIMPLIFIED {
        return e;
    }
    let short = simplifier.simplify(arena, whole);
    if length(arena, short) > MOST_READ {
        return e;
    }
    let difference = arena.sub(short, e);
    if zero_test(arena, difference) == ZeroTest::Zero { short } else { e }
}
