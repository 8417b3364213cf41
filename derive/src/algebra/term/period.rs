//! Period of a term in one of its variables, derived from the form of the term.

use super::calculus::Differential;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::FxHashMap;

/// Common period r of the given terms in the variable x, in turns: the least r > 0 for which e(x +
/// 2 π r) = e(x) follows from their form.
///
/// The form shows a period if x occurs only in sines and cosines of k x + c, with k rational and c
/// free of x. The period is 1 if no term contains x; `None` if the form shows no period.
///
/// ```
/// use tripos_derive::algebra::term::period::period_in_turns;
/// use tripos_derive::algebra::text::parse::parse_free;
/// use tripos_derive::algebra::{Arena, Rational};
///
/// let arena = &mut Arena::new();
/// let x = arena.symbol("x");
/// let of = |arena: &mut Arena, text| { let e = parse_free(arena, text).unwrap(); period_in_turns(arena, &[e], x) };
/// assert_eq!(of(arena, "sin(3*x/2 + a)/(2 + cos(x))"), Some(Rational::integer(2)));
/// assert_eq!(of(arena, "cos(4*x)^2 + sin(6*x)"), Rational::fraction(1, 2));
/// assert_eq!(of(arena, "x + sin(x)"), None);
/// ```
pub fn period_in_turns(arena: &mut Arena, terms: &[Expr], x: Expr) -> Option<Rational> {
    let mut slope = Differential::partial(x);
    let mut repeats: FxHashMap<Expr, bool> = FxHashMap::default();
    // Each factor k gives the period 1/k, and r is the least common multiple of these periods: lcm
    // of their numerators over gcd of their denominators.
    let (mut multiple, mut divisor) = (1_i64, 0_i64);
    for part in arena.reachable(terms) {
        let mut does = part != x && arena.operands(part).all(|operand| repeats[&operand]);
        if let (false, Node::Apply(Function::Sin | Function::Cos, argument)) = (does, arena.node(part).clone()) {
            let factor = slope.apply(arena, argument);
            if let Some((k, over)) = arena.as_number(factor).and_then(Rational::small).filter(|(k, _)| *k != 0) {
                multiple = multiple.checked_mul(over / over.gcd(&multiple))?;
                divisor = divisor.gcd(&k);
                does = true;
            }
        }
        repeats.insert(part, does);
    }
    terms.iter().all(|term| repeats[term]).then(|| Rational::fraction(multiple, divisor.max(1))).flatten()
}
