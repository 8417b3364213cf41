//! Mistakes in abbreviations that entries of a publication have shown so far.
//!
//! A mistake in an abbreviation makes every formula wrong that uses it. It is named once, in the abbreviation's own
//! formula. Later formulas are first read with the right formula in its place: they may be right then, or have a
//! mistake of their own.

use super::formula::Formula;
use super::{Repair, Search, Slip, Tools, is_right, pair, repair};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};
use crate::publication::Shorthand;
use rustc_hash::FxHashSet;

/// Abbreviation that is known to be wrong.
struct Correction {
    name: String,
    /// Right formula, in the arena of the corrections.
    right: Expr,
    words: String,
    parts: Option<(Expr, Expr)>,
    slip: Slip,
}

/// Abbreviations of a publication, those that are known to be wrong, and those that right entries use.
pub struct Book {
    shorthand: Shorthand,
    arena: Arena,
    corrections: Vec<Correction>,
    /// Names of abbreviations that right entries use: no mistake is sought in them.
    trusted: FxHashSet<String>,
}

/// Mistake of a formula that uses abbreviations.
pub struct Found {
    /// Descriptions of the mistakes, one for each.
    pub words: Vec<String>,
    /// Wrong part and right part, if there is one mistake.
    pub parts: Option<(Expr, Expr)>,
    /// Kind of the mistake, if there is one.
    pub slip: Option<Slip>,
    /// Name of the abbreviation whose mistake is the only one.
    pub abbreviation: Option<String>,
}

impl Book {
    /// Book in which no abbreviation is wrong.
    pub fn new(shorthand: &Shorthand) -> Self {
        let (shorthand, arena) = (shorthand.clone(), Arena::new());
        Self { shorthand, arena, corrections: Vec::new(), trusted: FxHashSet::default() }
    }

    /// Notes that an entry with this formula, abbreviations written out, is right.
    pub fn trust(&mut self, raw: Expr) {
        let Some(as_printed) = self.shorthand.as_printed(raw) else { return };
        let used = self.shorthand.used(as_printed);
        self.trusted.extend(used.into_iter().map(|one| one.name.clone()));
    }

    /// Drops the mistakes in abbreviations that right entries use. True if entries may be judged otherwise with what
    /// the book knows now.
    pub fn learn(&mut self) -> bool {
        let had_corrections = !self.corrections.is_empty();
        self.corrections.retain(|one| !self.trusted.contains(&one.name));
        had_corrections
    }

    /// True if a formula, with abbreviations written out, is printed as the name of an abbreviation alone.
    pub fn is_name(&self, raw: Expr) -> bool {
        self.shorthand.is_name(raw)
    }

    /// Mistake of a printed formula that uses abbreviations, whose value with abbreviations written out is `raw`.
    /// `None` if it uses none, or if no mistake is found.
    pub fn mistake(&mut self, tools: &mut Tools<'_, '_>, raw: Expr, derived: Expr, search: Search) -> Option<Found> {
        let as_printed = self.shorthand.as_printed(raw)?;
        let mut formula = Formula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        let known = self.corrected(&mut formula);
        if !known.is_empty() {
            let words: Vec<String> = known.iter().map(|at| self.corrections[*at].words.clone()).collect();
            if is_right(tools, &mut formula, derived) {
                let first = &self.corrections[known[0]];
                let is_one = known.len() == 1;
                return Some(Found {
                    words,
                    parts: first.parts.filter(|_| is_one),
                    slip: Some(first.slip).filter(|_| is_one),
                    abbreviation: Some(first.name.clone()).filter(|_| is_one),
                });
            }
            if let Some(found) = repair(tools, &mut formula, derived, search) {
                self.note(&formula, &found);
                let words = words.into_iter().chain([found.words]).collect();
                return Some(Found { words, parts: None, slip: None, abbreviation: None });
            }
            formula = Formula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        }
        let found = repair(tools, &mut formula, derived, search)?;
        let abbreviation = self.note(&formula, &found);
        Some(Found { words: vec![found.words], parts: found.parts, slip: Some(found.slip), abbreviation })
    }

    /// Two mistakes of a printed formula, also beside those of abbreviations that are known to be wrong. `None` if it
    /// uses no abbreviation, or if no two mistakes are found.
    pub fn two_mistakes(&mut self, tools: &mut Tools<'_, '_>, raw: Expr, derived: Expr) -> Option<Found> {
        let as_printed = self.shorthand.as_printed(raw)?;
        let mut formula = Formula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        let known = self.corrected(&mut formula);
        let mut words: Vec<String> = known.iter().map(|at| self.corrections[*at].words.clone()).collect();
        for found in pair(tools, &mut formula, derived)? {
            self.note(&formula, &found);
            words.push(found.words);
        }
        Some(Found { words, parts: None, slip: None, abbreviation: None })
    }

    /// Puts the right formulas of known wrong abbreviations into a formula; returns the indices of those that it uses.
    fn corrected(&self, formula: &mut Formula) -> Vec<usize> {
        let mut used = Vec::new();
        let mut transfer = Transfer::new(&self.arena);
        for part in &mut formula.parts {
            if let Some(at) = self.corrections.iter().position(|one| one.name == part.name) {
                part.formula = transfer.term(&mut formula.arena, self.corrections[at].right);
                used.push(at);
            }
        }
        used
    }

    /// Notes the mistake of an abbreviation; returns its name.
    fn note(&mut self, formula: &Formula, found: &Repair) -> Option<String> {
        let name = formula.parts[found.place?].name.clone();
        let right = Transfer::new(&formula.arena).term(&mut self.arena, found.changed);
        let (words, parts, slip) = (found.words.clone(), found.parts, found.slip);
        self.corrections.retain(|one| one.name != name);
        self.corrections.push(Correction { name: name.clone(), right, words, parts, slip });
        Some(name)
    }
}
