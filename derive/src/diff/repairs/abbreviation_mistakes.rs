//! Record of the mistakes found so far in a publication's abbreviations.
//!
//! A mistake in an abbreviation makes every formula wrong that uses the abbreviation. The mistake is reported once, in
//! the abbreviation's own formula. Later formulas are first read with the corrected abbreviation: they may be right
//! then, or have a mistake of their own.

use super::printed_formula::PrintedFormula;
use super::{
    MistakeKind, Repair, RepairSearch, RepairTools, find_abbreviation_repairs, find_change_pair, find_repair,
    is_repaired_formula_right,
};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr};
use crate::publication::PrintedAbbreviations;
use rustc_hash::FxHashSet;

/// Abbreviation known to be wrong, with its right formula and the description of its mistake.
struct Correction {
    /// Name of the wrong abbreviation.
    name: String,
    /// Right formula of the abbreviation, in the arena of the corrected formulas.
    right: Expr,
    /// Description of the mistake, such as "2*l should be l".
    words: String,
    /// Wrong part and right part of the formula; `None` for a missing term.
    parts: Option<(Expr, Expr)>,
    slip: MistakeKind,
}

/// Record of a publication's abbreviations: those known to be wrong, and those used by right entries.
pub struct AbbreviationMistakes {
    shorthand: PrintedAbbreviations,
    /// Store of the terms of the corrected formulas.
    arena: Arena,
    corrections: Vec<Correction>,
    /// Names of abbreviations that right entries use. They count as right, and no mistake is sought in them.
    trusted: FxHashSet<String>,
    /// Mistakes in abbreviations, each of which alone would explain wrong entries, with the formulas of these entries.
    suspected: Vec<(Correction, Vec<Expr>)>,
}

/// Mistakes found in a printed formula that uses abbreviations.
pub struct FormulaMistake {
    /// Descriptions of the mistakes, one text for each mistake.
    pub words: Vec<String>,
    /// Wrong part and right part; `None` unless there is exactly one mistake with both parts.
    pub parts: Option<(Expr, Expr)>,
    /// Kind of the mistake; `None` unless there is exactly one mistake.
    pub slip: Option<MistakeKind>,
    /// Names of the wrong abbreviations if every mistake of the formula lies in an abbreviation;
    /// else empty.
    pub abbreviations: Vec<String>,
}

impl AbbreviationMistakes {
    /// Creates the record for the abbreviations `shorthand` of a publication, none of which is known to be wrong.
    pub fn new(shorthand: &PrintedAbbreviations) -> Self {
        let (shorthand, arena) = (shorthand.clone(), Arena::new());
        let (corrections, suspected) = (Vec::new(), Vec::new());
        Self { shorthand, arena, corrections, trusted: FxHashSet::default(), suspected }
    }

    /// Records that an entry is right, so that its abbreviations count as right. `raw` is its
    /// formula with abbreviations written out.
    pub fn record_right_formula(&mut self, raw: Expr) {
        let Some(as_printed) = self.shorthand.printed_form(raw) else { return };
        let used = self.shorthand.used_abbreviations(as_printed);
        self.trusted.extend(used.into_iter().map(|one| one.name.clone()));
    }

    /// Records that the entries of a row are right up to a factor of the whole row. An abbreviation that is in all
    /// entries may be this factor, and is therefore not known to be right.
    pub fn trust_parts(&mut self, entries: impl Iterator<Item = Expr>) {
        let used = |raw: Expr| -> FxHashSet<String> {
            let as_printed = self.shorthand.printed_form(raw);
            let used = as_printed.map(|e| self.shorthand.used_abbreviations(e)).unwrap_or_default();
            used.into_iter().map(|one| one.name.clone()).collect()
        };
        let entries: Vec<FxHashSet<String>> = entries.map(used).collect();
        let is_common = |name: &String| entries.iter().all(|entry| entry.contains(name));
        let apart = entries.iter().flatten().filter(|name| !is_common(name)).cloned();
        self.trusted.extend(apart.collect::<Vec<_>>());
    }

    /// Discards corrections of abbreviations that right entries use. Accepts suspected mistakes that each explain
    /// several entries alone. Returns true if the record has corrections, so that entries may now be judged
    /// differently.
    pub fn accept_suspected_corrections(&mut self) -> bool {
        let mut suspected = std::mem::take(&mut self.suspected);
        let declared = |one: &Correction| self.shorthand.abbreviations().iter().position(|own| own.name == one.name);
        // If two mistakes explain the same entries, the abbreviation that is declared last is preferred: it is nearest
        // to the entries.
        suspected.sort_by_key(|(one, entries)| std::cmp::Reverse((entries.len(), declared(one))));
        let mut explained: FxHashSet<Expr> = FxHashSet::default();
        for (suspect, entries) in suspected.into_iter().filter(|(_, entries)| entries.len() > 1) {
            if entries.iter().all(|entry| !explained.contains(entry))
                && self.corrections.iter().all(|one| one.name != suspect.name)
            {
                explained.extend(entries);
                self.corrections.push(suspect);
            }
        }
        let had_corrections = !self.corrections.is_empty();
        self.corrections.retain(|one| !self.trusted.contains(&one.name));
        had_corrections
    }

    /// Records the quotient of two formulas as printed, if either of them uses an abbreviation.
    pub fn keep_quotient(&mut self, model: &Arena, quotient: Expr, dividend: Expr, divisor: Expr) {
        self.shorthand.record_quotient(model, quotient, dividend, divisor);
    }

    /// True if a formula is printed as the bare name of an abbreviation. `raw` is the formula with abbreviations
    /// written out.
    pub fn is_name(&self, raw: Expr) -> bool {
        self.shorthand.is_name(raw)
    }

    /// Finds the mistake of a printed formula that uses abbreviations. `raw` is its value with abbreviations written
    /// out. Returns `None` if the formula uses no abbreviation, or if no mistake is found.
    pub fn find_abbreviation_mistake(
        &mut self,
        tools: &mut RepairTools<'_, '_>,
        raw: Expr,
        derived: Expr,
        search: RepairSearch,
    ) -> Option<FormulaMistake> {
        let as_printed = self.shorthand.printed_form(raw)?;
        let mut formula = PrintedFormula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        let known = self.insert_known_corrections(&mut formula);
        if !known.is_empty() {
            let words: Vec<String> = known.iter().map(|at| self.corrections[*at].words.clone()).collect();
            if is_repaired_formula_right(tools, &mut formula, derived) {
                let first = &self.corrections[known[0]];
                let is_one = known.len() == 1;
                return Some(FormulaMistake {
                    words,
                    parts: first.parts.filter(|_| is_one),
                    slip: Some(first.slip).filter(|_| is_one),
                    abbreviations: known.iter().map(|at| self.corrections[*at].name.clone()).collect(),
                });
            }
            if let Some(found) = find_repair(tools, &mut formula, derived, search) {
                self.record_abbreviation_mistake(&formula, &found);
                let words = words.into_iter().chain([found.words]).collect();
                return Some(FormulaMistake { words, parts: None, slip: None, abbreviations: Vec::new() });
            }
            formula = PrintedFormula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        }
        let found = find_repair(tools, &mut formula, derived, search)?;
        let abbreviations = Vec::from_iter(self.record_abbreviation_mistake(&formula, &found));
        if abbreviations.is_empty() {
            for other in find_abbreviation_repairs(tools, &mut formula, derived) {
                self.record_suspected_mistake(&formula, &other, raw);
            }
        }
        Some(FormulaMistake { words: vec![found.words], parts: found.parts, slip: Some(found.slip), abbreviations })
    }

    /// Finds two mistakes of a printed formula, besides known mistakes of its abbreviations. Returns `None` if the
    /// formula uses no abbreviation, or if no two mistakes are found.
    pub fn find_two_mistakes(
        &mut self,
        tools: &mut RepairTools<'_, '_>,
        raw: Expr,
        derived: Expr,
    ) -> Option<FormulaMistake> {
        let as_printed = self.shorthand.printed_form(raw)?;
        let mut formula = PrintedFormula::with_abbreviations(&self.shorthand, as_printed, &self.trusted);
        let known = self.insert_known_corrections(&mut formula);
        let mut words: Vec<String> = known.iter().map(|at| self.corrections[*at].words.clone()).collect();
        for found in find_change_pair(tools, &mut formula, derived)? {
            self.record_abbreviation_mistake(&formula, &found);
            words.push(found.words);
        }
        Some(FormulaMistake { words, parts: None, slip: None, abbreviations: Vec::new() })
    }

    /// Replaces known wrong abbreviations of a formula with their right formulas. Returns the indices of the
    /// corrections used.
    fn insert_known_corrections(&self, formula: &mut PrintedFormula) -> Vec<usize> {
        let mut used = Vec::new();
        let mut transfer = Transfer::new(&self.arena);
        for part in &mut formula.parts {
            if let Some(at) = self.corrections.iter().position(|one| one.name == part.name) {
                part.formula = transfer.transfer_term(&mut formula.arena, self.corrections[at].right);
                used.push(at);
            }
        }
        used
    }

    /// Records a mistake found in an abbreviation and returns the abbreviation's name; `None` if
    /// the mistake is elsewhere.
    fn record_abbreviation_mistake(&mut self, formula: &PrintedFormula, found: &Repair) -> Option<String> {
        let correction = self.correction(formula, found)?;
        let name = correction.name.clone();
        self.corrections.retain(|one| one.name != name);
        self.corrections.push(correction);
        Some(name)
    }

    /// Records a possible mistake of an abbreviation, which would explain the entry `raw` without a mistake in the
    /// entry itself.
    fn record_suspected_mistake(&mut self, formula: &PrintedFormula, found: &Repair, raw: Expr) {
        let Some(correction) = self.correction(formula, found) else { return };
        let is_same = |one: &Correction| (&one.name, one.right) == (&correction.name, correction.right);
        match self.suspected.iter_mut().find(|(one, _)| is_same(one)) {
            Some((_, entries)) if entries.contains(&raw) => {}
            Some((_, entries)) => entries.push(raw),
            None => self.suspected.push((correction, vec![raw])),
        }
    }

    /// Converts a repair into a correction of its abbreviation; `None` if the repair is not in an
    /// abbreviation.
    fn correction(&mut self, formula: &PrintedFormula, found: &Repair) -> Option<Correction> {
        let name = formula.parts[found.place?].name.clone();
        let right = Transfer::new(&formula.arena).transfer_term(&mut self.arena, found.changed);
        Some(Correction { name, right, words: found.words.clone(), parts: found.parts, slip: found.slip })
    }
}
