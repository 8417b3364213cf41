//! Dependence of terms on variables, decided by meaning and not by form.
//!
//! A term may contain a variable without depending on it. Then the derivative is identically zero,
//! and any value may replace the variable. Invariant: a definition contains only variables and
//! symbols that are defined before it.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use rustc_hash::{FxHashMap, FxHashSet};

/// Fractions (numerator, denominator) that are tried in turn as the value of a variable on which a
/// term does not depend. At some of these values the term may not be defined.
const STANDINS: [(i64, i64); 4] = [(0, 1), (1, 1), (1, 2), (2, 1)];

/// Test if terms depend on variables by meaning. It takes the definitions of symbols into account.
#[derive(Clone)]
pub struct Dependence {
    /// Definitions of symbols, each after the definitions that it uses.
    pub definitions: Vec<Definition>,
    /// Substitution that replaces every defined symbol by its value, with all definitions written
    /// out.
    inline: Substitution,
    /// Results so far: true if the term depends on the symbol, by (term, symbol).
    known: FxHashMap<(Expr, Expr), bool>,
}

impl Dependence {
    /// Creates the test for terms that contain symbols with the given definitions.
    pub fn new(arena: &mut Arena, definitions: Vec<Definition>) -> Self {
        let mut inline = Substitution::default();
        for definition in &definitions {
            let value = inline.apply(arena, definition.value);
            inline.set(definition.symbol, value);
        }
        Self { definitions, inline, known: FxHashMap::default() }
    }

    /// Replaces all defined symbols in a term by their values, with all definitions written out.
    pub fn without_definitions(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        self.inline.apply(arena, e)
    }

    /// True if the term `whole` depends on a symbol by meaning, or if the test cannot decide. All
    /// definitions in the term must be written out.
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

    /// Symbols that occur in the given terms, directly or in the definitions that these terms use.
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

    /// Rewrites a term so that it contains no variable on which it does not depend. Definitions
    /// that contain such variables are written out.
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
                // Terms cancel only across definitions, so all definitions are written out.
                let all = simplifier.simplify(arena, whole);
                let all = idle.iter().fold(all, |e, v| replace_independent_symbol(arena, simplifier, e, *v));
                return all;
            }
            e = next;
        }
    }
}

/// Replaces a symbol on which a term does not depend by a number. Returns the term unchanged if it
/// has no value at any of the numbers tried, or if equality is not proved.
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
