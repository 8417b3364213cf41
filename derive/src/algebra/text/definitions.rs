//! Definitions of named terms in documents: a symbol for each named term, and the formula that
//! defines it.
//!
//! A name has one meaning in all documents about a model. The terms common to all documents are
//! written first, on their own: the equations by Kane's method. Names of all other terms end in the
//! name of the document part in which they first occur. So `ratio_x_v` is a term of Kane's
//! equations, and `ratio_x_v_lagrange` a term of Lagrange's equations only.
//! Numbers distinguish terms that have the same label in a part. A number depends on the structure
//! of the terms and not on when they were built. So it is the same wherever the part is written.
//!
//! Invariant: a named term has the same symbol whenever it is written, and each step comes after
//! the steps that it needs.

use crate::algebra::term::arena::NameSymbol;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::{Definition, unused_symbol};
use crate::algebra::term::structure_hashes::structure_hashes;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};

/// Replaces named terms in the given steps and values by symbols, and adds a step that defines each
/// symbol. Returns the steps and the values.
/// An added step comes before the first step that needs it. A given step may itself define a named
/// term by an equal formula, which is then kept as its value.
pub fn write_definitions(arena: &mut Arena, steps: &[Definition], values: &[Expr]) -> (Vec<Definition>, Vec<Expr>) {
    let mut writing = DefinitionWriter::default();
    for step in steps {
        let value = writing.term(arena, step.value);
        let symbol = writing.symbol_defined_by_step(arena, step.symbol);
        writing.steps.push(Definition { symbol, value });
    }
    let values = values.iter().map(|e| writing.term(arena, *e)).collect();
    (writing.steps, values)
}

/// Gives every named term in `values` a symbol, for the document part `part`. The values stay
/// unchanged; documents show them with these symbols.
/// Names that are written later without a part of their own belong to `part`. All values of a part
/// must be given at once, since the numbers in their names depend on one another.
pub fn define_names_in_part(arena: &mut Arena, part: &str, values: &[Expr]) {
    arena.names.part = Some(part.to_owned());
    let mut named: Vec<Expr> = arena.reachable(values);
    let structure = structure_hashes(arena, &named);
    named.retain(|e| arena.named_term_value(*e).is_some() && !arena.names.symbols.get(e).is_some_and(|s| s.everywhere));
    named.sort_by_key(|e| structure[e]);
    for e in named {
        // A term that already has a name from another part is counted too. So the numbers of this
        // part do not depend on other parts being written.
        next_definition_symbol(arena, e);
    }
}

/// Definitions of all named terms that the terms `shown` contain, directly or within other
/// definitions. Each comes after the definitions that it uses.
#[must_use]
pub fn definitions_shown(arena: &Arena, shown: &[Expr]) -> Vec<Definition> {
    let named = arena.reachable(shown).into_iter();
    named
        .filter_map(|e| {
            Some(Definition { symbol: arena.names.symbols.get(&e)?.symbol, value: arena.named_term_value(e)? })
        })
        .collect()
}

/// Definitions and symbols collected while terms are written in sequence.
#[derive(Default)]
struct DefinitionWriter {
    /// Steps written so far, including those added to define symbols of named terms.
    steps: Vec<Definition>,
    /// Symbol of each named term written so far.
    symbols: Substitution,
}

impl DefinitionWriter {
    /// Symbol that a given step defines: the symbol of a named term, or the term itself if it is a
    /// plain symbol.
    fn symbol_defined_by_step(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if arena.named_term_value(e).is_none() {
            return e;
        }
        let symbol = definition_symbol(arena, e);
        self.symbols.set(e, symbol);
        symbol
    }

    /// Replaces the named terms in a term by their symbols, and adds the steps that define these
    /// symbols.
    fn term(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        for part in arena.reachable_until(&[e], |part| self.symbols.knows(part)) {
            if let Some(value) = arena.named_term_value(part) {
                let value = self.symbols.apply(arena, value);
                let symbol = definition_symbol(arena, part);
                self.steps.push(Definition { symbol, value });
                self.symbols.set(part, symbol);
            }
        }
        self.symbols.apply(arena, e)
    }
}

/// Symbol with which a named term is written; it is created if the term has none.
fn definition_symbol(arena: &mut Arena, named: Expr) -> Expr {
    match arena.names.symbols.get(&named) {
        Some(known) => known.symbol,
        None => next_definition_symbol(arena, named),
    }
}

/// Gives a named term a symbol: its label and the part's name, then the next number among the terms
/// of that label in this part. A term that already has a symbol keeps it.
fn next_definition_symbol(arena: &mut Arena, named: Expr) -> Expr {
    let wanted = arena.names.name_in_part(arena.label_of(named).unwrap_or_default());
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

/// Copies the names written in another arena of the same model into `arena`. In `from`, a term may
/// have the opposite sign, which depends on the terms built before. It is then a different term,
/// and no term of `arena` gets its name.
pub fn adopt_definitions(arena: &mut Arena, from: &Arena) {
    let mut known: Vec<_> = from.names.symbols.iter().collect();
    known.sort_unstable_by_key(|(e, _)| **e);
    let mut transfer = Transfer::new(from);
    for (e, stated) in known {
        let symbol = arena.symbol(from.symbol_name(stated.symbol).unwrap_or_default());
        let here = transfer.transfer_term(arena, *e);
        if arena.named_term_value(here).is_some() {
            arena.names.symbols.entry(here).or_insert(NameSymbol { symbol, everywhere: stated.everywhere });
        }
    }
}
