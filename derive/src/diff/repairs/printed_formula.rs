//! Printed formula with its abbreviations, each with its own formula. These are the places where a mistake may be.

use super::formula_change::formula_with_replacement;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};
use crate::publication::{Abbreviation, PrintedAbbreviations};
use rustc_hash::FxHashSet;

/// Printed formula with its abbreviations, in an arena of its own.
pub struct PrintedFormula {
    /// Store of the terms of the printed formula and of the changed formulas that are tried.
    pub arena: Arena,
    /// Formula as printed, in which abbreviations are symbols.
    pub root: Expr,
    /// Abbreviations that the formula uses, directly or through others, in the order of their
    /// declaration.
    pub parts: Vec<Abbreviation>,
    /// True, for each abbreviation, if it counts as right, so that no mistake is sought in it.
    trusted: Vec<bool>,
}

/// Place in a printed formula that may be wrong: the formula itself, or the formula of an
/// abbreviation.
#[derive(Clone, Copy)]
pub struct FormulaPlace {
    /// Index of the abbreviation in the formula's list; `None` for the formula itself.
    pub at: Option<usize>,
    /// Formula at this place: of the printed formula or of an abbreviation.
    pub formula: Expr,
    /// Whole formula, in which all abbreviations that depend on this abbreviation are written out.
    around: Expr,
}

impl PrintedFormula {
    /// Creates the formula without abbreviations, copied from the arena `from` to a new arena.
    pub fn without_abbreviations(from: &Arena, e: Expr) -> Self {
        let mut arena = Arena::new();
        let root = Transfer::new(from).transfer_term(&mut arena, e);
        Self { arena, root, parts: Vec::new(), trusted: Vec::new() }
    }

    /// Creates the formula `e` with its abbreviations, copied from the arena of `shorthand` to a new arena. No mistake
    /// is sought in the abbreviations with the names in `trusted`.
    pub fn with_abbreviations(shorthand: &PrintedAbbreviations, e: Expr, trusted: &FxHashSet<String>) -> Self {
        let mut arena = Arena::new();
        for name in shorthand.leading_names() {
            arena.symbol(name);
        }
        let mut transfer = Transfer::new(shorthand.arena());
        let root = transfer.transfer_term(&mut arena, e);
        let mut parts = Vec::new();
        for one in shorthand.used_abbreviations(e) {
            let (symbol, formula) =
                (transfer.transfer_term(&mut arena, one.symbol), transfer.transfer_term(&mut arena, one.formula));
            parts.push(Abbreviation { name: one.name.clone(), symbol, formula });
        }
        let trusted = parts.iter().map(|part| trusted.contains(&part.name)).collect();
        Self { arena, root, parts, trusted }
    }

    /// Places that may be wrong: the formula itself, then each used abbreviation that does not count as right.
    pub fn places(&mut self) -> Vec<FormulaPlace> {
        let mut list = vec![FormulaPlace { at: None, formula: self.root, around: self.root }];
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
                list.push(FormulaPlace { at: Some(at), formula: self.parts[at].formula, around });
            }
        }
        list
    }

    /// Whole formula in which the formula at `place` is replaced with `changed`; `None` if a divisor becomes 0.
    pub fn whole_formula_with_change(&self, arena: &mut Arena, place: FormulaPlace, changed: Expr) -> Option<Expr> {
        match place.at {
            None => Some(changed),
            Some(at) => formula_with_replacement(arena, place.around, self.parts[at].symbol, changed),
        }
    }

    /// Term with all abbreviations written out; `None` if a divisor becomes 0.
    pub fn write_out_abbreviations(&mut self, e: Expr) -> Option<Expr> {
        let mut whole = e;
        for part in self.parts.iter().rev() {
            whole = formula_with_replacement(&mut self.arena, whole, part.symbol, part.formula)?;
        }
        Some(whole)
    }

    /// Copy in which the formula at `place` is replaced with `changed`.
    pub fn with_changed_place(&self, place: FormulaPlace, changed: Expr) -> Self {
        let (mut root, mut parts) = (self.root, self.parts.clone());
        match place.at {
            None => root = changed,
            Some(at) => parts[at].formula = changed,
        }
        Self { arena: self.arena.clone(), root, parts, trusted: self.trusted.clone() }
    }

    /// Description of a mistake. If the place is in an abbreviation, the name of the abbreviation comes first.
    pub fn mistake_text_with_place(&self, place: FormulaPlace, words: &str) -> String {
        self.name(place).map_or_else(|| words.to_owned(), |name| format!("in {name}, {words}"))
    }

    /// Name of the abbreviation at a place; `None` for the formula itself.
    pub fn name(&self, place: FormulaPlace) -> Option<&str> {
        place.at.map(|at| self.parts[at].name.as_str())
    }
}
