//! Readable formulas: named terms are written out where the whole formula stays short.

use super::simplify::Simplifier;
use crate::algebra::term::calculus::expand_names;
use crate::algebra::text::print::printed_length;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};

/// Largest number of nodes of a written-out formula, which prints as some ten lines of text.
const MOST_READ: usize = 250;

/// Largest number of nodes of a written-out formula for which simplification is tried.
const MOST_SIMPLIFIED: usize = 5_000;

/// Writes out the named terms of the formula `e` and simplifies it. The result is proved equal to
/// `e` modulo random primes. Returns `e` itself if the result would exceed some ten lines.
pub fn written_out_formula(arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
    let whole = expand_names(arena, e);
    if whole == e || printed_length(arena, whole) > MOST_SIMPLIFIED {
        return e;
    }
    let short = simplifier.simplify(arena, whole);
    if printed_length(arena, short) > MOST_READ {
        return e;
    }
    let difference = arena.sub(short, e);
    if zero_test(arena, difference) == ZeroTest::Zero { short } else { e }
}
