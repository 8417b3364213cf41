//! Names written down as steps: a symbol for each, and what it stands for.
//!
//! Invariant: a name has the same symbol whenever it is written, and each step stands after what it needs.

use super::calculus::Substitution;
use super::steps::{Definition, fresh_symbol};
use super::{Arena, Expr};

/// Steps and values with symbols in place of names; the steps behind the names stand before what first needs them. A step may
/// state a name itself, by what it is equal to: from there on that is its value.
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

/// Terms that are written down one after another.
#[derive(Default)]
struct Writing {
    steps: Vec<Definition>,
    symbols: Substitution,
}

impl Writing {
    /// The symbol of what a step states.
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

/// The symbol that a named term is written with.
fn symbol_of(arena: &mut Arena, named: Expr) -> Expr {
    if let Some(known) = arena.names.symbols.get(&named) {
        return *known;
    }
    let wanted = arena.name_of(named).unwrap_or_default().to_owned();
    // Many may be called alike: each further one has a number.
    let count = arena.names.written.entry(wanted.clone()).or_insert(0);
    *count += 1;
    let wanted = if *count == 1 { wanted } else { format!("{wanted}_{count}") };
    let symbol = fresh_symbol(arena, &wanted);
    arena.names.symbols.insert(named, symbol);
    symbol
}
