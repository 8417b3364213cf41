//! Definitions of named terms in documents: a symbol for each named term, and the formula that
//! defines it.
//!
//! A name has one meaning in all documents about a model. The terms common to all documents are
//! written first, on their own: the equations by Kane's method. Names of all other terms end in the
//! name of the document part in which they first occur. So `ratio_x_v` is a term of Kane's
//! equations, and `ratio_x_v_lagrange` a term of Lagrange's equations only.
//!
//! Numbers distinguish terms that have the same label in a part. A number depends on the structure
//! of the terms, not on when they were built. So a term has the same number in every document that
//! contains the part.
//!
//! Invariant: a named term has the same symbol in all texts, and each step comes after the steps
//! that it needs.

use crate::algebra::term::arena::NameSymbol;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::{Definition, unused_symbol};
use crate::algebra::term::structure_hashes::structure_hashes;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};

/// Replaces named terms in the given steps and values by symbols, and adds a step that defines each
/// symbol. Returns the steps and the values.
///
/// An added step comes before the first step that needs it. A given step may define a named term by
/// an equal formula; its formula is then kept.
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
///
/// Terms that are named later get names of this part too, until another part begins. All values of
/// a part must be given at once, since the numbers in their names depend on one another.
pub fn define_names_in_part(arena: &mut Arena, part: &str, values: &[Expr]) {
    arena.names.part = Some(part.to_owned());
    let mut named: Vec<Expr> = arena.reachable(values);
    let structure = structure_hashes(arena, &named);
    named.retain(|e| arena.named_term_value(*e).is_some() && !arena.names.symbols.get(e).is_some_and(|s| s.everywhere));
    named.sort_by_key(|e| structure[e]);
    for e in named {
        // A term that already has a name from another part is counted too. So the numbers in this
        // part do not depend on which other parts are written.
        next_definition_symbol(arena, e);
    }
}

/// Definitions of all named terms that occur in the terms `shown`, directly or within other
/// definitions. Each definition comes after the definitions that it uses. Named terms without a
/// symbol are left out.
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
    /// Symbol for the left side of a given step. For a named term it is the symbol of that term; a
    /// plain symbol is returned unchanged.
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

/// Symbol with which documents show a named term; a new symbol is created if the term has none.
fn definition_symbol(arena: &mut Arena, named: Expr) -> Expr {
    match arena.names.symbols.get(&named) {
        Some(known) => known.symbol,
        None => next_definition_symbol(arena, named),
    }
}

/// Gives a named term a symbol. Its name is the label, the part's name, and the next number among
/// the terms with this label in this part. A term that already has a symbol keeps it, and the
/// number is counted nevertheless.
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

/// Copies to `arena` the symbols of named terms that were written in `from`, another arena of the
/// same model. A term without a name in `arena` gets no symbol. This happens if the two arenas
/// write the term with opposite signs, which depend on the order in which terms were built.
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
