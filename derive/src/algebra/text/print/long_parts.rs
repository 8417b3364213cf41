//! Splitting of long formulas into parts: each part gets a name in the formulas that contain it.

use crate::algebra::{Arena, Expr, Node};
use rustc_hash::FxHashMap;

/// Number of printed nodes above which a formula is split into parts: about two pages of text.
const LONG_FORMULA: usize = 2_000;
/// Number of nodes above which a sum or product becomes a part with its own name. Parts inside it
/// count as one node each.
const PART: usize = 300;

/// Sums and products that must get names so that formulas of more than two thousand nodes become
/// short. Each comes after the parts that it contains. The list is empty if all formulas are short.
/// Without names, a term that is shared many times would be printed each time.
#[must_use]
pub fn long_parts(arena: &Arena, formulas: &[Expr]) -> Vec<Expr> {
    let whole = sizes(arena, &arena.shown_subterms(formulas), usize::MAX);
    let long: Vec<Expr> = formulas.iter().copied().filter(|e| whole[e].0 > LONG_FORMULA).collect();
    let shown = arena.shown_subterms(&long);
    let sizes = sizes(arena, &shown, PART);
    shown.into_iter().filter(|e| sizes[e].1).collect()
}

/// Number of nodes of a formula that is printed in full. The text has three to four characters for
/// each node.
#[must_use]
pub fn printed_length(arena: &Arena, formula: Expr) -> usize {
    sizes(arena, &arena.shown_subterms(&[formula]), usize::MAX)[&formula].0
}

/// Number of nodes of a formula that is printed with every named term inside it as its name, also names that no
/// document has defined yet.
#[must_use]
pub fn length_up_to_names(arena: &Arena, formula: Expr) -> usize {
    let mut known: FxHashMap<Expr, usize> = FxHashMap::default();
    for e in arena.subterms_up_to_names(&[formula]) {
        let operands = arena.operands(e).map(|o| known.get(&o).copied().unwrap_or(0));
        known.insert(e, operands.fold(1, usize::saturating_add));
    }
    known[&formula]
}

/// Pairs (number of printed nodes, true if the term is a part) for each term. A sum or product of
/// more than `part` nodes is a part, and counts as one node in other terms. Operands must come
/// first in `terms`.
fn sizes(arena: &Arena, terms: &[Expr], part: usize) -> FxHashMap<Expr, (usize, bool)> {
    let mut known: FxHashMap<Expr, (usize, bool)> = FxHashMap::default();
    for e in terms {
        let operands = if arena.written_name(*e).is_some() { 0 } else { usize::MAX };
        let inner = arena.operands(*e).take(operands).map(|o| if known[&o].1 { 1 } else { known[&o].0 });
        let size = inner.fold(1, usize::saturating_add);
        let is_part = size > part && matches!(arena.node(*e), Node::Sum(..) | Node::Product(_));
        known.insert(*e, (size, is_part));
    }
    known
}
