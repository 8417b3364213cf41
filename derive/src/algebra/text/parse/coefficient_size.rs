//! Size of the numerical coefficients of terms. It determines the cost of exact arithmetic with the
//! terms.

use crate::algebra::{Arena, Expr, Node, Rational};

/// Sizes of the numerator and of the denominator of a term's leading coefficient, in bits. Each is
/// at least 1.
pub(super) fn coefficient_bits(arena: &Arena, e: Expr) -> (u64, u64) {
    let bits = |value: &Rational| match value.small() {
        Some((n, d)) => (u64::from(64 - n.unsigned_abs().leading_zeros()), u64::from(64 - d.leading_zeros())),
        None => {
            let big = value.to_big();
            (big.numer().bits(), big.denom().bits())
        }
    };
    let (above, below) = bits(leading_coefficient(arena, e));
    (above.max(1), below.max(1))
}

/// Leading coefficient of a term: the number itself, the first coefficient of a sum, or 1.
fn leading_coefficient(arena: &Arena, e: Expr) -> &Rational {
    match arena.node(e) {
        Node::Number(value) => value,
        Node::Sum(_, terms) => &terms[0].1,
        _ => &Rational::ONE,
    }
}

/// Denominator of the leading coefficient of a term.
pub(super) fn coefficient_denominator(arena: &Arena, e: Expr) -> num_bigint::BigInt {
    leading_coefficient(arena, e).to_big().denom().clone()
}
