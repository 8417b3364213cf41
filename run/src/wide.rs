//! Values of terms in twice the precision of a double.

use crate::problem::wide;
use rustc_hash::FxHashMap;
use tripos_derive::algebra::{Arena, Expr, Function, Node};
use tripos_derive::scene::Extended;
use tripos_traits::{DoubleDouble, Scalar};

/// The values of these terms for these values of symbols; not a number where a symbol has none.
pub fn values(arena: &Arena, terms: &[Expr], known: &[(Expr, DoubleDouble)]) -> Vec<DoubleDouble> {
    let mut values: FxHashMap<Expr, DoubleDouble> = known.iter().copied().collect();
    let number = |value| wide(&Extended::of(value));
    for part in arena.reachable(terms) {
        if values.contains_key(&part) {
            continue;
        }
        let value = match arena.node(part) {
            Node::Number(value) => number(value),
            Node::Pi => DoubleDouble::pi(),
            Node::Symbol(_) => DoubleDouble::from_f64(f64::NAN),
            Node::Sum(constant, terms) => {
                terms.iter().fold(number(constant), |sum, (term, k)| sum + values[term] * number(k))
            }
            Node::Product(factors) => {
                factors.iter().fold(DoubleDouble::int(1), |product, (base, n)| product * values[base].powi(*n))
            }
            Node::Apply(f, argument) => value_of(*f, values[argument]),
        };
        values.insert(part, value);
    }
    terms.iter().map(|e| values[e]).collect()
}

fn value_of(f: Function, x: DoubleDouble) -> DoubleDouble {
    match f {
        Function::Sin => x.sin_cos().0,
        Function::Cos => x.sin_cos().1,
        Function::Sqrt => x.sqrt(),
        Function::Exp => x.exp(),
        Function::Log => x.ln(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Abs => x.abs(),
        Function::Sign => x.sign(),
    }
}
