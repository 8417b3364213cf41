//! Range of a symbol in which a term is positive: the limits that a condition states.

use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Function, Node};

/// Relative difference up to which two values of a term are equal.
const EQUAL: f64 = 1e-12;
/// Values of the symbol at which the sign of an absolute value in a term is tested.
const TESTED: [f64; 2] = [0.731, -1.287];

/// Computes the range of a symbol, as (lower, upper), in which a term is positive: the limits that the condition
/// `positive > 0` states. The term is linear in the symbol, such as `q - low` and `high - 2*q`, or it decreases
/// linearly in the absolute value of a linear term, such as `bound - abs(q - middle)`. The lower or the upper end is
/// infinite if only one is stated. `known` has the other symbols with their values. If no value of the symbol makes the
/// term positive, the lower end is not below the upper one.
///
/// `None` for other terms, such as `abs(q) - least`, for terms without the symbol, for terms with another symbol that
/// is not in `known`, and if an end of the range has no finite value, for example because a known value is NaN.
#[must_use]
pub fn positive_range(arena: &mut Arena, known: &[(Expr, f64)], positive: Expr, symbol: Expr) -> Option<(f64, f64)> {
    let branches = linear_branches(arena, positive, symbol)?;
    let mut terms = vec![positive];
    for branch in &branches {
        let slope = Differential::partial(symbol).apply(arena, *branch);
        if arena.mentions(slope, symbol) {
            return None;
        }
        terms.extend([*branch, slope]);
    }
    let symbols: Vec<Expr> = known.iter().map(|(known, _)| *known).chain([symbol]).collect();
    let tape = Tape::new(arena, &symbols, &terms).ok()?;
    let at = |x: f64| tape.evaluate(&known.iter().map(|(_, value)| *value).chain([x]).collect::<Vec<f64>>());
    // A term in −|x| is the least of its branches, a term in |x| the largest.
    for x in TESTED {
        let values = at(x);
        let least = (0..branches.len()).fold(f64::INFINITY, |least, branch| least.min(values[1 + 2 * branch]));
        // A difference that is NaN is none that is small.
        let is_least = (values[0] - least).abs() <= EQUAL * values[0].abs().max(1.0);
        if !is_least {
            return None;
        }
    }
    let origin = at(0.0);
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for branch in 0..branches.len() {
        let (constant, slope) = (origin[1 + 2 * branch], origin[2 + 2 * branch]);
        // A root of −0 becomes 0.
        let root = 0.0 - constant / slope;
        if !root.is_finite() {
            return None;
        }
        if slope > 0.0 {
            low = low.max(root);
        } else {
            high = high.min(root);
        }
    }
    Some((low, high))
}

/// Terms without the absolute value of the symbol, one for each sign of its content. `None` if the symbol is in several
/// absolute values.
fn linear_branches(arena: &mut Arena, positive: Expr, symbol: Expr) -> Option<Vec<Expr>> {
    let absolute: Vec<(Expr, Expr)> = arena
        .reachable(&[positive])
        .into_iter()
        .filter_map(|part| match arena.node(part) {
            Node::Apply(Function::Abs, inner) if arena.mentions(part, symbol) => Some((part, *inner)),
            _ => None,
        })
        .collect();
    match absolute.as_slice() {
        [] => Some(vec![positive]),
        [(whole, inner)] => {
            let negative = arena.neg(*inner);
            Some([*inner, negative].map(|sign| Substitution::new(&[(*whole, sign)]).apply(arena, positive)).to_vec())
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::positive_range;
    use crate::algebra::{Arena, Expr};

    /// Terms of the tests: a coordinate, a bound and the absolute value of the coordinate.
    struct Terms {
        arena: Arena,
        q: Expr,
        bound: Expr,
    }

    impl Terms {
        fn new() -> Self {
            let mut arena = Arena::new();
            let (q, bound) = (arena.symbol("q"), arena.symbol("b"));
            Self { arena, q, bound }
        }

        fn range(&mut self, positive: Expr, bound: f64) -> Option<(f64, f64)> {
            positive_range(&mut self.arena, &[(self.bound, bound)], positive, self.q)
        }
    }

    /// Goal: bounds on one side and on both sides are read, with the sign of a negative slope. Method: ranges by hand.
    #[test]
    fn linear_terms_and_absolute_values_have_a_range() {
        let mut terms = Terms::new();
        let (q, bound) = (terms.q, terms.bound);
        let above = terms.arena.sub(q, bound);
        let below = terms.arena.sub(bound, q);
        let size = terms.arena.apply(crate::algebra::Function::Abs, q);
        let within = terms.arena.sub(bound, size);
        let outside = terms.arena.sub(size, bound);
        assert_eq!(terms.range(above, 0.5), Some((0.5, f64::INFINITY)));
        assert_eq!(terms.range(below, 0.5), Some((f64::NEG_INFINITY, 0.5)));
        assert_eq!(terms.range(within, 0.5), Some((-0.5, 0.5)));
        // No value of the coordinate fits a negative bound.
        assert_eq!(terms.range(within, -0.5), Some((0.5, -0.5)));
        assert_eq!(terms.range(outside, 0.5), None);
    }

    /// Goal: no range is made up. Method: NaN, infinity, a term without the symbol, one that is not linear, and one
    /// with a symbol that has no value.
    #[test]
    fn other_terms_have_no_range() {
        let mut terms = Terms::new();
        let (q, bound) = (terms.q, terms.bound);
        let above = terms.arena.sub(q, bound);
        let square = terms.arena.mul(q, q);
        assert_eq!(terms.range(above, f64::NAN), None);
        assert_eq!(terms.range(above, f64::INFINITY), None);
        assert_eq!(terms.range(bound, 1.0), None);
        assert_eq!(terms.range(square, 1.0), None);
        assert_eq!(positive_range(&mut terms.arena, &[], above, q), None);
    }
}
