//! Steps of a computation: values that are computed in sequence. Each value has a symbol, by which
//! later steps refer to it.

use super::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashSet;

/// Step of a computation: it defines a symbol by a value, a term in the symbols of earlier steps
/// and inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Symbol that the step of the computation defines.
    pub symbol: Expr,
    /// Value of the step: a term in the symbols of earlier steps and inputs.
    pub value: Expr,
}

/// Steps that the given expressions need, directly or through other steps, in the order of `steps`.
#[must_use]
pub fn needed_steps(arena: &Arena, steps: &[Definition], expressions: &[Expr]) -> Vec<Definition> {
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

/// Adds steps to the substitution `put`, which then replaces the symbol of each step by its value.
/// Values are inserted as named terms, so that terms stay short.
pub fn substitute_steps(arena: &mut Arena, put: &mut Substitution, steps: &[Definition]) {
    for step in steps {
        let value = put.apply(arena, step.value);
        let value = arena.name(value, "step");
        put.set(step.symbol, value);
    }
}

/// Creates a new symbol with the name `wanted`, or with underscores appended if that name is taken.
/// While a document part is being written ([`crate::algebra::text::definitions`]), the name of the
/// part is appended before the underscores.
pub fn fresh_symbol(arena: &mut Arena, wanted: &str) -> Expr {
    let wanted = arena.names.name_in_part(wanted);
    unused_symbol(arena, &wanted)
}

/// Creates a new symbol with the name `wanted`, followed by as many underscores as are needed to
/// make it unique.
pub(in crate::algebra) fn unused_symbol(arena: &mut Arena, wanted: &str) -> Expr {
    let mut name = wanted.to_owned();
    while arena.find_symbol(&name).is_some() {
        name.push('_');
    }
    arena.symbol(&name)
}
