//! A printed formula with the abbreviations in it, each with its own formula: the places where a mistake may be.

use super::change::replaced;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};
use crate::publication::{Abbreviation, Shorthand};
use rustc_hash::FxHashSet;

/// Printed formula, in an arena of its own.
pub struct Formula {
    /// Store of the terms of the formula and of its changes.
    pub arena: Arena,
    /// Formula as printed, with abbreviations as symbols.
    pub root: Expr,
    /// Abbreviations that the formula uses, also through others, in the order of their declaration.
    pub parts: Vec<Abbreviation>,
    /// For each abbreviation, true if no mistake is sought in it.
    trusted: Vec<bool>,
}

/// Place of a formula that may be wrong: the formula itself, or that of an abbreviation.
#[derive(Clone, Copy)]
pub struct Place {
    /// Index of the abbreviation; `None` for the formula itself.
    pub at: Option<usize>,
    /// Formula at this place.
    pub formula: Expr,
    /// Whole formula, in which abbreviations that depend on this one are written out.
    around: Expr,
}

impl Formula {
    /// Formula of an arena, without abbreviations.
    pub fn plain(from: &Arena, e: Expr) -> Self {
        let mut arena = Arena::new();
        let root = Transfer::new(from).term(&mut arena, e);
        Self { arena, root, parts: Vec::new(), trusted: Vec::new() }
    }

    /// Formula with abbreviations. `e` is in the arena of the shorthand. No mistake is sought in abbreviations with the
    /// `trusted` names.
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

    /// The formula itself, then that of each abbreviation that may be wrong.
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

    /// Whole formula with another formula at a place; `None` if a divisor becomes 0.
    pub fn whole(&self, arena: &mut Arena, place: Place, changed: Expr) -> Option<Expr> {
        match place.at {
            None => Some(changed),
            Some(at) => replaced(arena, place.around, self.parts[at].symbol, changed),
        }
    }

    /// A term with all abbreviations written out; `None` if a divisor becomes 0.
    pub fn written_out(&mut self, e: Expr) -> Option<Expr> {
        let mut whole = e;
        for part in self.parts.iter().rev() {
            whole = replaced(&mut self.arena, whole, part.symbol, part.formula)?;
        }
        Some(whole)
    }

    /// Formula with another formula at a place.
    pub fn with(&self, place: Place, changed: Expr) -> Self {
        let (mut root, mut parts) = (self.root, self.parts.clone());
        match place.at {
            None => root = changed,
            Some(at) => parts[at].formula = changed,
        }
        Self { arena: self.arena.clone(), root, parts, trusted: self.trusted.clone() }
    }

    /// Description of a mistake at a place, with the name of the abbreviation.
    pub fn within(&self, place: Place, words: &str) -> String {
        self.name(place).map_or_else(|| words.to_owned(), |name| format!("in {name}, {words}"))
    }

    /// Name of the abbreviation at a place.
    pub fn name(&self, place: Place) -> Option<&str> {
        place.at.map(|at| self.parts[at].name.as_str())
    }
}
