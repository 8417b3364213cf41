//! Steps: values that are computed one after another. Each has a symbol, by which later steps mention it.

use super::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashSet;

/// A symbol and its value in symbols that are defined before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Symbol that is defined.
    pub symbol: Expr,
    /// Value of the symbol.
    pub value: Expr,
}

/// Steps that these expressions need, directly or by way of other steps, in the given order.
#[must_use]
pub fn needed(arena: &Arena, steps: &[Definition], expressions: &[Expr]) -> Vec<Definition> {
    let mut wanted: FxHashSet<Expr> = arena.reachable(expressions).into_iter().collect();
    let mut list: Vec<Definition> = Vec::new();
    for step in steps.iter().rev() {
        if wanted.contains(&step.symbol) {
            wanted.extend(arena.reachable(&[step.value]));
            list.push(*step);
        }
    }
    list.reverse();
    list
}

/// Puts the values of steps into a substitution, for the steps' symbols. Earlier steps are put into later ones as named
/// terms, so that nothing is written out.
pub fn put_in(arena: &mut Arena, put: &mut Substitution, steps: &[Definition]) {
    for step in steps {
        let value = put.apply(arena, step.value);
        let value = arena.name(value, "step");
        put.set(step.symbol, value);
    }
}

/// Creates a symbol called `wanted`, or a similar name if that is taken. In a part of a document
/// ([`crate::algebra::text::definitions`]) the part's name is appended.
pub fn fresh_symbol(arena: &mut Arena, wanted: &str) -> Expr {
    let wanted = arena.names.in_part(wanted);
    unused_symbol(arena, &wanted)
}

/// Creates a symbol of this name, with underscores behind it if the name is taken.
pub(in crate::algebra) fn unused_symbol(arena: &mut Arena, wanted: &str) -> Expr {
    let mut name = wanted.to_owned();
    while arena.find_symbol(&name).is_some() {
        name.push('_');
    }
    arena.symbol(&name)
}
