//! Size of the numbers in front of terms, which determines the cost of exact arithmetic with them.

use crate::algebra::{Arena, Expr, Node, Rational};

/// Bits of the numerator and of the denominator of the number in front of a term, at least 1 each.
pub(super) fn largest_number(arena: &Arena, e: Expr) -> (u64, u64) {
    let bits = |value: &Rational| match value.small() {
        Some((n, d)) => (u64::from(64 - n.unsigned_abs().leading_zeros()), u64::from(64 - d.leading_zeros())),
        None => {
            let big = value.to_big();
            (big.numer().bits(), big.denom().bits())
        }
    };
    let (above, below) = bits(leading(arena, e));
    (above.max(1), below.max(1))
}

/// The number in front of a term.
fn leading(arena: &Arena, e: Expr) -> &Rational {
    match arena.node(e) {
        Node::Number(value) => value,
        Node::Sum(_, terms) => &terms[0].1,
        _ => &Rational::ONE,
    }
}

/// The denominator of the number in front of a term.
pub(super) fn below_of(arena: &Arena, e: Expr) -> num_bigint::BigInt {
    leading(arena, e).to_big().denom().clone()
}
