//! Constants that replace products of parameters and numbers in reduced equations.
//!
//! The start of a motion determines these constants. So they are computed once, not at every
//! evaluation of the equations. For example, if u₃ is constant, 2 u₃ sin q₂ becomes c sin q₂ with c =
//! 2 u₃.

use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashMap;

/// Constants that replace products of parameters and numbers, to save multiplications.
#[derive(Default)]
pub struct Hoist {
    /// Constants, each as a pair of its symbol and the product that it replaces.
    pub constants: Vec<(Expr, Expr)>,
}

impl Hoist {
    /// Replaces every factor of parameters and numbers in a term by a constant, if that saves a
    /// multiplication. Returns the new term, which is proved equal to `e`. If the proof fails, `e`
    /// is returned and no constant is added.
    pub fn apply(&mut self, arena: &mut Arena, parameters: &[Expr], e: Expr) -> Expr {
        let before = self.constants.len();
        let mut map: FxHashMap<Expr, Expr> = FxHashMap::default();
        for part in arena.reachable(&[e]) {
            let new = match arena.node(part).clone() {
                Node::Sum(constant, terms) => {
                    let mut list = vec![(arena.number(constant), Rational::ONE)];
                    for (term, k) in terms {
                        list.push(self.term(arena, parameters, &map, term, &k));
                    }
                    arena.linear_combination(&list)
                }
                Node::Product(factors) => {
                    let factors: Vec<(Expr, i32)> = factors.iter().map(|(base, n)| (map[base], *n)).collect();
                    arena.try_product(&factors).unwrap_or(part)
                }
                Node::Apply(f, argument) => arena.apply(f, map[&argument]),
                Node::Named(_, term) => arena.name_like(part, map[&term]),
                Node::Number(_) | Node::Symbol(_) | Node::Pi => part,
            };
            map.insert(part, new);
        }
        // If each constant is replaced by its product, the term must equal the given term.
        // Otherwise no constant is used.
        let written = Substitution::new(&self.constants).apply(arena, map[&e]);
        let difference = arena.sub(written, e);
        if zero_test(arena, difference) == ZeroTest::Zero {
            return map[&e];
        }
        self.constants.truncate(before);
        e
    }

    /// Writes k · term as a pair (new term, factor). The new term contains a constant if that saves
    /// a multiplication. `map` has the rewritten subterms.
    fn term(
        &mut self,
        arena: &mut Arena,
        parameters: &[Expr],
        map: &FxHashMap<Expr, Expr>,
        term: Expr,
        k: &Rational,
    ) -> (Expr, Rational) {
        let factors = match arena.node(term).clone() {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(term, 1)],
        };
        let (fixed, rest): (Vec<_>, Vec<_>) = factors.into_iter().partition(|(base, _)| parameters.contains(base));
        let sign = if k.is_negative() { Rational::MINUS_ONE } else { Rational::ONE };
        let magnitude = k.mul(&sign);
        let plain = fixed.len() == 1 && fixed[0].1 == 1 && magnitude.is_one();
        if fixed.is_empty() || plain || rest.is_empty() && fixed.len() == 1 && magnitude.is_one() {
            return (map[&term], k.clone());
        }
        let Ok(product) = arena.try_product(&fixed) else { return (map[&term], k.clone()) };
        let value = arena.scale(product, &magnitude);
        let symbol = match self.constants.iter().find(|(_, known)| *known == value) {
            Some((symbol, _)) => *symbol,
            None => {
                let symbol = fresh_symbol(arena, &hoisted_constant_name(arena, &fixed, &magnitude));
                self.constants.push((symbol, value));
                symbol
            }
        };
        let rest: Vec<(Expr, i32)> = rest.iter().map(|(base, n)| (map[base], *n)).chain([(symbol, 1)]).collect();
        match arena.try_product(&rest) {
            Ok(product) => (product, sign),
            Err(_) => (map[&term], k.clone()),
        }
    }
}

/// Name of a constant, made from its product: `u3_times_2` for 2 u₃, `k_per_m` for k/m,
/// `l_squared_m_times_4_by_3` for 4/3 l² m.
fn hoisted_constant_name(arena: &Arena, factors: &[(Expr, i32)], k: &Rational) -> String {
    let word = |(base, n): &(Expr, i32)| {
        let name = arena.symbol_name(*base).unwrap_or_default();
        let inverse = if *n < 0 { "per_" } else { "" };
        match n.unsigned_abs() {
            1 => format!("{inverse}{name}"),
            2 => format!("{inverse}{name}_squared"),
            3 => format!("{inverse}{name}_cubed"),
            n => format!("{inverse}{name}_to_{n}"),
        }
    };
    let (above, below): (Vec<_>, Vec<_>) = factors.iter().partition(|(_, n)| *n > 0);
    let mut name = above.into_iter().chain(below).map(word).collect::<Vec<_>>().join("_");
    let k = k.to_big();
    for (joint, number) in [("times", k.numer()), ("by", k.denom())] {
        if *number != 1.into() {
            name = format!("{name}_{joint}_{number}");
        }
    }
    name
}
