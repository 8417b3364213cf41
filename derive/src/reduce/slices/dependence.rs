//! Dependence of terms on variables, decided by meaning.
//!
//! A term may mention a variable and not depend on it: then the derivative is zero by identity, and any value may stand
//! for the variable. Invariant: a definition mentions only symbols and what is defined before it.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use rustc_hash::{FxHashMap, FxHashSet};

/// Values that are put for a variable on which a term does not depend, in turn: at some the term has no value.
const STANDINS: [(i64, i64); 4] = [(0, 1), (1, 1), (1, 2), (2, 1)];

/// Decides on which variables terms depend by meaning, definitions included.
#[derive(Clone)]
pub struct Dependence {
    /// Each symbol that stands for a term, after those that its term mentions.
    pub definitions: Vec<Definition>,
    inline: Substitution,
    known: FxHashMap<(Expr, Expr), bool>,
}

impl Dependence {
    /// With these definitions.
    pub fn new(arena: &mut Arena, definitions: Vec<Definition>) -> Self {
        let mut inline = Substitution::default();
        for definition in &definitions {
            let value = inline.apply(arena, definition.value);
            inline.set(definition.symbol, value);
        }
        Self { definitions, inline, known: FxHashMap::default() }
    }

    /// The term in variables alone.
    pub fn whole(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        self.inline.apply(arena, e)
    }

    /// True if a term in variables alone depends on a symbol by meaning, or if that cannot be decided.
    fn on(&mut self, arena: &mut Arena, whole: Expr, symbol: Expr) -> bool {
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

    /// The symbols that a term mentions, directly or in the definitions that it uses.
    pub fn mentioned(&self, arena: &Arena, list: &[Expr]) -> FxHashSet<Expr> {
        let mut found: FxHashSet<Expr> = FxHashSet::default();
        found.extend(arena.reachable(list));
        for definition in self.definitions.iter().rev() {
            if found.contains(&definition.symbol) {
                found.extend(arena.reachable(&[definition.value]));
            }
        }
        found
    }

    /// The term without the variables that it mentions and does not depend on; definitions that mention such are
    /// written out.
    pub fn settle(&mut self, arena: &mut Arena, simplifier: &mut Simplifier, e: Expr, variables: &[Expr]) -> Expr {
        let whole = self.whole(arena, e);
        let mut e = e;
        loop {
            let mentioned = self.mentioned(arena, &[e]);
            let idle: Vec<Expr> = variables.iter().copied().filter(|v| mentioned.contains(v)).collect();
            let idle: Vec<Expr> = idle.into_iter().filter(|v| !self.on(arena, whole, *v)).collect();
            if idle.is_empty() {
                return e;
            }
            let parts = arena.reachable(&[e]);
            let through = |d: &&Definition| {
                parts.binary_search(&d.symbol).is_ok() && {
                    let inside = self.mentioned(arena, &[d.value]);
                    idle.iter().any(|v| inside.contains(v))
                }
            };
            let found = self.definitions.iter().rev().find(through).copied();
            let next = match found {
                Some(definition) => {
                    let written = Substitution::new(&[(definition.symbol, definition.value)]).apply(arena, e);
                    simplifier.simplify(arena, written)
                }
                None => idle.iter().fold(e, |e, v| put_any(arena, simplifier, e, *v)),
            };
            if next == e && found.is_none() {
                // What is left hangs together with definitions: they are all written out, and if that was so, it stays.
                let all = simplifier.simplify(arena, whole);
                let all = idle.iter().fold(all, |e, v| put_any(arena, simplifier, e, *v));
                return all;
            }
            e = next;
        }
    }
}

/// The term with a number in the place of a symbol on which it does not depend.
fn put_any(arena: &mut Arena, simplifier: &mut Simplifier, e: Expr, symbol: Expr) -> Expr {
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
