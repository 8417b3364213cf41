//! Dependence of terms on variables, decided by meaning and not by form.
//!
//! A term may mention a variable without depending on it. Then the derivative is identically zero,
//! and any value may replace the variable. Invariant: a definition contains only variables and
//! symbols that are defined before it.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use rustc_hash::{FxHashMap, FxHashSet};

/// Fractions (numerator, denominator) that are tried in turn in place of a variable on which a term
/// does not depend. A term may have no value at some of them.
const STANDINS: [(i64, i64); 4] = [(0, 1), (1, 1), (1, 2), (2, 1)];

/// Test on which variables terms depend by meaning. It looks through definitions.
#[derive(Clone)]
pub struct Dependence {
    /// Definitions of symbols, each after those that it uses.
    pub definitions: Vec<Definition>,
    /// Substitution that replaces every defined symbol by its full value.
    inline: Substitution,
    /// Earlier answers: for a term and a symbol, true if the term depends on the symbol.
    known: FxHashMap<(Expr, Expr), bool>,
}

impl Dependence {
    /// Creates the test for terms that use the symbols of these definitions.
    pub fn new(arena: &mut Arena, definitions: Vec<Definition>) -> Self {
        let mut inline = Substitution::default();
        for definition in &definitions {
            let value = inline.apply(arena, definition.value);
            inline.set(definition.symbol, value);
        }
        Self { definitions, inline, known: FxHashMap::default() }
    }

    /// Replaces all defined symbols in a term by their full values.
    pub fn without_definitions(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        self.inline.apply(arena, e)
    }

    /// True if the term `whole`, whose definitions are written out, depends on a symbol by meaning, or
    /// if the test cannot decide.
    fn depends_on(&mut self, arena: &mut Arena, whole: Expr, symbol: Expr) -> bool {
        if !arena.mentions(whole, symbol) {
            return false;
        }
        if let Some(known) = self.known.get(&(whole, symbol)) {
            return *known;
        }
        let slope = Differential::partial(symbol).apply(arena, whole);
        let answer = zero_test(arena, slope) != ZeroTest::Zero;
        self.known.insert((whole, symbol), answer);
        answer
    }

    /// Symbols that terms mention, directly or through the definitions that they use.
    pub fn mentioned_symbols(&self, arena: &Arena, list: &[Expr]) -> FxHashSet<Expr> {
        let mut found: FxHashSet<Expr> = FxHashSet::default();
        found.extend(arena.reachable(list));
        for definition in self.definitions.iter().rev() {
            if found.contains(&definition.symbol) {
                found.extend(arena.reachable(&[definition.value]));
            }
        }
        found
    }

    /// Rewrites a term so that it mentions no variable on which it does not depend. Definitions that
    /// mention such variables are written out.
    pub fn without_independent_variables(
        &mut self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        e: Expr,
        variables: &[Expr],
    ) -> Expr {
        let whole = self.without_definitions(arena, e);
        let mut e = e;
        loop {
            let mentioned = self.mentioned_symbols(arena, &[e]);
            let idle: Vec<Expr> = variables.iter().copied().filter(|v| mentioned.contains(v)).collect();
            let idle: Vec<Expr> = idle.into_iter().filter(|v| !self.depends_on(arena, whole, *v)).collect();
            if idle.is_empty() {
                return e;
            }
            let parts = arena.reachable(&[e]);
            let through = |d: &&Definition| {
                parts.binary_search(&d.symbol).is_ok() && {
                    let inside = self.mentioned_symbols(arena, &[d.value]);
                    idle.iter().any(|v| inside.contains(v))
                }
            };
            let found = self.definitions.iter().rev().find(through).copied();
            let next = match found {
                Some(definition) => {
                    let written = Substitution::new(&[(definition.symbol, definition.value)]).apply(arena, e);
                    simplifier.simplify(arena, written)
                }
                None => idle.iter().fold(e, |e, v| replace_independent_symbol(arena, simplifier, e, *v)),
            };
            if next == e && found.is_none() {
                // The rest cancels only across definitions, so all definitions are written out.
                let all = simplifier.simplify(arena, whole);
                let all = idle.iter().fold(all, |e, v| replace_independent_symbol(arena, simplifier, e, *v));
                return all;
            }
            e = next;
        }
    }
}

/// Puts a number in place of a symbol on which a term does not depend. Returns the term unchanged
/// if no number can be used.
fn replace_independent_symbol(arena: &mut Arena, simplifier: &mut Simplifier, e: Expr, symbol: Expr) -> Expr {
    if !arena.mentions(e, symbol) {
        return e;
    }
    for (n, d) in STANDINS {
        let number = arena.ratio(n, d);
        let mut put = Substitution::new(&[(symbol, number)]);
        let candidate = put.apply(arena, e);
        let difference = arena.sub(candidate, e);
        if put.undefined.is_none() && zero_test(arena, difference) == ZeroTest::Zero {
            return simplifier.simplify(arena, candidate);
        }
    }
    e
}
