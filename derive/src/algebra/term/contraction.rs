//! Contraction of products of sines and cosines by the addition theorems: sin a cos b − cos a sin b =
//! sin (a − b).
//!
//! Such sums of products occur in the divisors of linear systems if angles are measured from one
//! frame. As a single sine, a divisor shows where it is zero, and no digits are lost near there.

use super::calculus::Substitution;
use crate::algebra::{Arena, Expr, Function, Node, Rational};

/// Contracts products of sines and cosines in `e` and returns the new term. Two terms of a sum that
/// form an addition theorem become a single sine or cosine.
pub fn contract_products(arena: &mut Arena, e: Expr) -> Expr {
    let mut put = Substitution::default();
    for part in arena.reachable(&[e]) {
        if matches!(arena.node(part), Node::Sum(..)) {
            let rebuilt = put.apply(arena, part);
            let contracted = contract_sum(arena, rebuilt);
            put.set(part, contracted);
        }
    }
    put.apply(arena, e)
}

/// A term of a sum, read as k · f(a) g(b) · other factors, where f and g are sines or cosines.
struct Pair {
    /// Position of the term among the terms of its sum.
    at: usize,
    /// Rational coefficient of the term in its sum.
    k: Rational,
    /// True for sin a cos b; false for cos a cos b or sin a sin b.
    is_mixed: bool,
    /// True if both functions are sines. It has a meaning only if `is_mixed` is false.
    are_sines: bool,
    /// Angles a and b, rad. If one function is a sine and the other a cosine, the sine's angle
    /// comes first. Otherwise the angle with the lower handle comes first.
    angles: (Expr, Expr),
    /// Remaining factors of the term, as pairs (base, exponent).
    others: Vec<(Expr, i32)>,
}

/// Contracts the terms of one sum; a sum without an addition theorem is returned unchanged.
fn contract_sum(arena: &mut Arena, sum: Expr) -> Expr {
    let Node::Sum(constant, terms) = arena.node(sum).clone() else { return sum };
    let mut pairs: Vec<Pair> =
        terms.iter().enumerate().flat_map(|(at, (term, k))| contractible_pairs(arena, at, *term, k)).collect();
    let mut is_used = vec![false; terms.len()];
    let mut result = vec![(Expr::ONE, constant)];
    while let Some(first) = pairs.pop() {
        let is_free = |pair: &Pair| !is_used[pair.at];
        if !is_free(&first) {
            continue;
        }
        let Some(second) =
            pairs.iter().find(|other| is_free(other) && other.at != first.at && first.contracts_with(other))
        else {
            continue;
        };
        let (a, b) = first.angles;
        let is_same = first.k == second.k;
        let (f, angle) = if first.is_mixed {
            (Function::Sin, if is_same { arena.add(a, b) } else { arena.sub(a, b) })
        } else {
            (Function::Cos, if is_same { arena.sub(a, b) } else { arena.add(a, b) })
        };
        // cos (a + b) = cos a cos b − sin a sin b: the sign is that of the cosines.
        let k = if first.is_mixed || is_same || !first.are_sines { first.k.clone() } else { second.k.clone() };
        let (first_at, second_at) = (first.at, second.at);
        let mut factors = first.others;
        factors.push((arena.apply(f, angle), 1));
        let Ok(product) = arena.try_product(&factors) else { continue };
        result.push((product, k));
        (is_used[first_at], is_used[second_at]) = (true, true);
    }
    if !is_used.contains(&true) {
        return sum;
    }
    let left = terms.iter().zip(&is_used).filter(|(_, used)| !**used).map(|((term, k), _)| (*term, k.clone()));
    result.extend(left);
    arena.linear_combination(&result)
}

impl Pair {
    /// True if two terms of a sum form an addition theorem and can become a single sine or cosine.
    fn contracts_with(&self, other: &Self) -> bool {
        let is_opposite = self.k.neg() == other.k;
        let kinds = if self.is_mixed {
            other.is_mixed && self.angles == (other.angles.1, other.angles.0)
        } else {
            !other.is_mixed && self.are_sines != other.are_sines && self.angles == other.angles
        };
        kinds && self.others == other.others && (self.k == other.k || is_opposite)
    }
}

/// All ways to read a product as [`Pair`]: one for each two factors that are sines or cosines. `at`
/// and `k` are the position and the coefficient of the product in its sum.
fn contractible_pairs(arena: &Arena, at: usize, term: Expr, k: &Rational) -> Vec<Pair> {
    let Node::Product(factors) = arena.node(term) else { return Vec::new() };
    let wave = |(base, n): &(Expr, i32)| match arena.node(*base) {
        Node::Apply(f @ (Function::Sin | Function::Cos), angle) if *n == 1 => Some((*f == Function::Sin, *angle)),
        _ => None,
    };
    let waves: Vec<(usize, (bool, Expr))> =
        factors.iter().enumerate().filter_map(|(i, f)| Some((i, wave(f)?))).collect();
    let mut list = Vec::new();
    for (place, &(i, (first_is_sine, a))) in waves.iter().enumerate() {
        for &(j, (second_is_sine, b)) in &waves[place + 1..] {
            let others = factors.iter().enumerate().filter(|(at, _)| *at != i && *at != j).map(|(_, f)| *f).collect();
            let is_mixed = first_is_sine != second_is_sine;
            let in_order = if is_mixed { first_is_sine } else { a <= b };
            let angles = if in_order { (a, b) } else { (b, a) };
            list.push(Pair { at, k: k.clone(), is_mixed, are_sines: first_is_sine && second_is_sine, angles, others });
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::meaning::compare::Comparer;
    use crate::algebra::text::parse::parse;
    use crate::algebra::text::print::print_text;

    fn contracted(formula: &str) -> String {
        let mut arena = Arena::new();
        let e = parse(&mut arena, formula, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
        let short = contract_products(&mut arena, e);
        let verdict = Comparer::default().compare(&mut arena, e, short);
        assert!(verdict.is_equal(), "{formula} is not {}", print_text(&arena, short));
        print_text(&arena, short)
    }

    #[test]
    fn addition_theorems_are_read_backwards() {
        for (formula, short) in [
            ("sin(a)*cos(b) - cos(a)*sin(b)", "sin(a - b)"),
            ("k*sin(a)*cos(b) + k*cos(a)*sin(b)", "k*sin(a + b)"),
            ("3*cos(a)*cos(b) + 3*sin(a)*sin(b) + c", "3*cos(a - b) + c"),
            ("sin(a)*sin(b) - cos(a)*cos(b)", "-cos(a + b)"),
            ("cos(a)*cos(b) - sin(a)*sin(b)", "cos(a + b)"),
            ("1/(cos(a)*sin(b)*l - sin(a)*cos(b)*l)", "-1/(l*sin(a - b))"),
            ("2*sin(a)*cos(b) - cos(a)*sin(b)", "2*sin(a)*cos(b) - cos(a)*sin(b)"),
            ("k*sin(a)*cos(b) - l*cos(a)*sin(b)", "k*sin(a)*cos(b) - l*cos(a)*sin(b)"),
            ("sin(a)*sin(b) + cos(a)*sin(b)", "sin(a)*sin(b) + cos(a)*sin(b)"),
        ] {
            assert_eq!(contracted(formula), short, "{formula}");
        }
    }
}
