//! Printed formula with its abbreviations, each with its own formula: the places where a mistake
//! may be.

use super::change::replaced;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};
use crate::publication::{Abbreviation, Shorthand};
use rustc_hash::FxHashSet;

/// Printed formula with its abbreviations, in an arena of its own.
pub struct Formula {
    /// Store of the terms of the formula and of its changes.
    pub arena: Arena,
    /// Formula as printed, in which abbreviations are symbols.
    pub root: Expr,
    /// Abbreviations that the formula uses, directly or through others, in the order of their
    /// declaration.
    pub parts: Vec<Abbreviation>,
    /// For each abbreviation, true if it counts as right, so that no mistake is searched for in it.
    trusted: Vec<bool>,
}

/// Place in a printed formula that may be wrong: the formula itself, or the formula of an
/// abbreviation.
#[derive(Clone, Copy)]
pub struct Place {
    /// Index of the abbreviation in the formula's list; `None` for the formula itself.
    pub at: Option<usize>,
    /// Formula at this place: of the printed formula or of an abbreviation.
    pub formula: Expr,
    /// Whole formula, in which those abbreviations are written out that depend on this
    /// abbreviation.
    around: Expr,
}

impl Formula {
    /// Formula without abbreviations, copied from the arena `from` to an arena of its own.
    pub fn plain(from: &Arena, e: Expr) -> Self {
        let mut arena = Arena::new();
        let root = Transfer::new(from).term(&mut arena, e);
        Self { arena, root, parts: Vec::new(), trusted: Vec::new() }
    }

    /// Formula `e` with its abbreviations, copied from the arena of `shorthand` to an arena of its
    /// own.
    /// No mistake is searched for in the abbreviations with the names in `trusted`.
    pub fn with_abbreviations(shorthand: &Shorthand, e: Expr, trusted: &FxHashSet<String>) -> Self {
        let mut arena = Arena::new();
        for name in shorthand.leading() {
            arena.symbol(name);
        }
        let mut transfer = Transfer::new(shorthand.arena());
        let root = transfer.term(&mut arena, e);
        let mut parts = Vec::new();
        for one in shorthand.used(e) {
            let (symbol, formula) = (transfer.term(&mut arena, one.symbol), transfer.term(&mut arena, one.formula));
            parts.push(Abbreviation { name: one.name.clone(), symbol, formula });
        }
        let trusted = parts.iter().map(|part| trusted.contains(&part.name)).collect();
        Self { arena, root, parts, trusted }
    }

    /// Places that may be wrong: the formula itself, then each abbreviation that is used and not
    /// trusted.
    pub fn places(&mut self) -> Vec<Place> {
        let mut list = vec![Place { at: None, formula: self.root, around: self.root }];
        for at in (0..self.parts.len()).filter(|at| !self.trusted[*at]).collect::<Vec<_>>() {
            let symbol = self.parts[at].symbol;
            let mut depending = vec![symbol];
            for part in &self.parts[at + 1..] {
                if depending.iter().any(|s| self.arena.mentions(part.formula, *s)) {
                    depending.push(part.symbol);
                }
            }
            let mut around = self.root;
            for part in self.parts[at + 1..].iter().rev().filter(|part| depending.contains(&part.symbol)) {
                around = Substitution::new(&[(part.symbol, part.formula)]).apply(&mut self.arena, around);
            }
            if self.arena.mentions(around, symbol) {
                list.push(Place { at: Some(at), formula: self.parts[at].formula, around });
            }
        }
        list
    }

    /// Whole formula with the formula at `place` replaced by `changed`; `None` if a divisor becomes
    /// 0.
    pub fn whole(&self, arena: &mut Arena, place: Place, changed: Expr) -> Option<Expr> {
        match place.at {
            None => Some(changed),
            Some(at) => replaced(arena, place.around, self.parts[at].symbol, changed),
        }
    }

    /// Term with all abbreviations written out; `None` if a divisor becomes 0.
    pub fn written_out(&mut self, e: Expr) -> Option<Expr> {
        let mut whole = e;
        for part in self.parts.iter().rev() {
            whole = replaced(&mut self.arena, whole, part.symbol, part.formula)?;
        }
        Some(whole)
    }

    /// Copy in which the formula at `place` is replaced by `changed`.
    pub fn with(&self, place: Place, changed: Expr) -> Self {
        let (mut root, mut parts) = (self.root, self.parts.clone());
        match place.at {
            None => root = changed,
            Some(at) => parts[at].formula = changed,
        }
        Self { arena: self.arena.clone(), root, parts, trusted: self.trusted.clone() }
    }

    /// Description of a mistake, preceded by the name of the abbreviation if the place is in an
    /// abbreviation.
    pub fn within(&self, place: Place, words: &str) -> String {
        self.name(place).map_or_else(|| words.to_owned(), |name| format!("in {name}, {words}"))
    }

    /// Name of the abbreviation at a place; `None` for the formula itself.
    pub fn name(&self, place: Place) -> Option<&str> {
        place.at.map(|at| self.parts[at].name.as_str())
    }
}
