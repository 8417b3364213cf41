//! Written names: a symbol for each named term, and its definition.
//!
//! A name has one meaning in all documents about a model. The terms common to all documents are written first, on their
//! own: the equations by Kane's method. Names of all other terms end in the name of the document part in which they
//! first occur: `ratio_x_v` is a term of Kane's equations, and `ratio_x_v_lagrange` a term of Lagrange's equations
//! only. Numbers tell terms apart that have the same label in a part. A number depends on the structure of the terms
//! and not on when they were built, so it is the same wherever the part is written.
//!
//! Invariant: a name has the same symbol whenever it is written, and each step stands after the steps that it needs.

use crate::algebra::term::arena::NameSymbol;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::{Definition, unused_symbol};
use crate::algebra::term::structure::structures;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};

/// Replaces named terms in steps and values by symbols, and adds a step that defines each symbol. An added step stands
/// before the first step that needs it. A given step may define a named term itself, by an equal term, which is then
/// its value.
pub fn written(arena: &mut Arena, steps: &[Definition], values: &[Expr]) -> (Vec<Definition>, Vec<Expr>) {
    let mut writing = Writing::default();
    for step in steps {
        let value = writing.term(arena, step.value);
        let symbol = writing.stated(arena, step.symbol);
        writing.steps.push(Definition { symbol, value });
    }
    let values = values.iter().map(|e| writing.term(arena, *e)).collect();
    (writing.steps, values)
}

/// Gives every named term in these values its symbol, as part of a document. The values are not changed: they are shown
/// with the names. Names written later without a part of their own belong to this part. All values of a part must be
/// written at once, since their numbers depend on one another.
pub fn write_down(arena: &mut Arena, part: &str, values: &[Expr]) {
    arena.names.part = Some(part.to_owned());
    let mut named: Vec<Expr> = arena.reachable(values);
    let structure = structures(arena, &named);
    named.retain(|e| arena.behind(*e).is_some() && !arena.names.symbols.get(e).is_some_and(|s| s.everywhere));
    named.sort_by_key(|e| structure[e]);
    for e in named {
        // A term with a name of another part counts too: whether that part was written does not change the numbers of
        // this part.
        number(arena, e);
    }
}

/// Definitions of the written names that these terms show, and of the names in these definitions. Each stands after the
/// names that it mentions.
#[must_use]
pub fn glossary(arena: &Arena, shown: &[Expr]) -> Vec<Definition> {
    let named = arena.reachable(shown).into_iter();
    named
        .filter_map(|e| Some(Definition { symbol: arena.names.symbols.get(&e)?.symbol, value: arena.behind(e)? }))
        .collect()
}

/// Steps and symbols of terms that are written down one after another.
#[derive(Default)]
struct Writing {
    steps: Vec<Definition>,
    symbols: Substitution,
}

impl Writing {
    /// Symbol that a given step defines: the written symbol of a named term, or the term itself.
    fn stated(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if arena.behind(e).is_none() {
            return e;
        }
        let symbol = symbol_of(arena, e);
        self.symbols.set(e, symbol);
        symbol
    }

    fn term(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        for part in arena.reachable_until(&[e], |part| self.symbols.knows(part)) {
            if let Some(value) = arena.behind(part) {
                let value = self.symbols.apply(arena, value);
                let symbol = symbol_of(arena, part);
                self.steps.push(Definition { symbol, value });
                self.symbols.set(part, symbol);
            }
        }
        self.symbols.apply(arena, e)
    }
}

/// Symbol that a named term is written with, created if needed.
fn symbol_of(arena: &mut Arena, named: Expr) -> Expr {
    match arena.names.symbols.get(&named) {
        Some(known) => known.symbol,
        None => number(arena, named),
    }
}

/// Gives a named term its symbol, with the next number among the terms of the same label in this part.
fn number(arena: &mut Arena, named: Expr) -> Expr {
    let wanted = arena.names.in_part(arena.label_of(named).unwrap_or_default());
    let count = arena.names.written.entry(wanted.clone()).or_insert(0);
    *count += 1;
    let wanted = if *count == 1 { wanted } else { format!("{wanted}_{count}") };
    if let Some(known) = arena.names.symbols.get(&named) {
        return known.symbol;
    }
    let symbol = unused_symbol(arena, &wanted);
    let everywhere = arena.names.part.is_none();
    arena.names.symbols.insert(named, NameSymbol { symbol, everywhere });
    symbol
}

/// Takes over the names that were written in another arena of the same model. A term may stand there with the other
/// sign, which depends on the terms built before. It is then another term, and no term here gets its name.
pub fn adopt(arena: &mut Arena, from: &Arena) {
    let mut known: Vec<_> = from.names.symbols.iter().collect();
    known.sort_unstable_by_key(|(e, _)| **e);
    let mut transfer = Transfer::new(from);
    for (e, stated) in known {
        let symbol = arena.symbol(from.symbol_name(stated.symbol).unwrap_or_default());
        let here = transfer.term(arena, *e);
        if arena.behind(here).is_some() {
            arena.names.symbols.entry(here).or_insert(NameSymbol { symbol, everywhere: stated.everywhere });
        }
    }
}
