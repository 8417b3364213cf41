//! Findings on rows and entries of printed systems: the verdict, the wrong entries, and the mistake in each wrong
//! entry.

use super::whole_rows::WholeRow;
use crate::diff::equations::derived_system::DerivedSystem;
use crate::diff::equations::row_judgement::{Row, RowJudgement, RowMatchResult, TermTools, judge_row};
use crate::diff::formulas::entry_judge::{EntryJudge, PrintedFormulaValue};
use crate::diff::formulas::finding::{Finding, Judgement, Mistake, ROUNDED};
use crate::diff::formulas::rounded_numbers::agrees_to_printed_digits;

use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Engine, Verdict, Witness};
use crate::algebra::meaning::permitted_states::StatesOfValidity;
use crate::algebra::solve::linear::linear_row_term;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::print::print_text;
use crate::mechanics::Kinematics;
use crate::publication::System;

/// Place of a printed row: its system, and its index in the system.
#[derive(Clone, Copy)]
pub(super) struct RowPlace<'a> {
    /// Index of the row in its system, from 0.
    pub index: usize,
    /// Printed system that contains the row.
    pub system: &'a System,
}

impl EntryJudge<'_, '_> {
    /// Judges a printed row. Decimal numbers in the row may be rounded values of parameters.
    pub(super) fn judge_row_with_decimals(&mut self, row: &Row, order: &DerivedSystem, index: usize) -> RowJudgement {
        let found =
            self.judge_rounded_row(row, order, index).or_else(|| self.judge_rounded_multiple(row, order, index));
        found.unwrap_or_else(|| self.judge_row(row, order, index))
    }

    /// Judgement of a row of numbers that equals a derived row times a number, to the digits printed. Returns `None` if
    /// the row mentions parameters, or if no derived row fits.
    fn judge_rounded_multiple(&mut self, row: &Row, order: &DerivedSystem, index: usize) -> Option<RowJudgement> {
        let model = self.quantities.model;
        let mut put = Substitution::new(self.numbers);
        let arena = &self.quantities.derivations.kinematics.arena;
        let is_printed = |e: &Expr| model.parameters.iter().any(|p| !p.is_input && arena.mentions(*e, p.symbol));
        if row.iter().any(is_printed) {
            return None;
        }
        let own = index.min(order.rows.len() - 1);
        for at in std::iter::once(own).chain((0..order.rows.len()).filter(|at| *at != own)) {
            for column in (0..row.len()).filter(|column| row[*column] != Expr::ZERO) {
                let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
                let numbers: Row = order.rows[at].iter().map(|e| put.apply(arena, *e)).collect();
                let Some(ratio) = arena.div(row[column], numbers[column]) else { continue };
                let factor = simplifier.simplify(arena, ratio);
                if arena.as_number(factor).is_none() || factor == Expr::ONE {
                    continue;
                }
                let expected: Row = order.rows[at].iter().map(|e| arena.mul(factor, *e)).collect();
                let is_right = row.iter().zip(&expected).zip(&numbers).all(|((printed, derived), number)| {
                    let arena = &mut self.quantities.derivations.kinematics.arena;
                    let exact = arena.mul(factor, *number);
                    self.comparer.compare(arena, *printed, exact).is_equal()
                        || agrees_to_printed_digits(self.quantities, self.comparer, self.numbers, *printed, *derived)
                });
                if is_right {
                    let entries = vec![Verdict::Equal(Engine::NormalForm); row.len()];
                    let holds = vec![StatesOfValidity::EVERYWHERE; row.len()];
                    return Some(RowJudgement {
                        by: RowMatchResult::Row { at, factor },
                        entries,
                        expected,
                        holds,
                        is_rounded: true,
                    });
                }
            }
        }
        None
    }

    /// Judges a printed row exactly, without allowing for rounded numbers.
    pub(super) fn judge_row(&mut self, row: &Row, order: &DerivedSystem, index: usize) -> RowJudgement {
        let parameters = self.quantities.model.p();
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let mut terms = TermTools { arena, simplifier, comparer: self.comparer };
        judge_row(&mut terms, &parameters, row, &order.rows, index)
    }

    /// Judgement of a row that equals a derived row to the digits printed. The derived row with the same index is tried
    /// first. Returns `None` if no derived row fits, or if the row is equal without rounding.
    fn judge_rounded_row(&mut self, row: &Row, order: &DerivedSystem, index: usize) -> Option<RowJudgement> {
        let own = index.min(order.rows.len() - 1);
        for at in std::iter::once(own).chain((0..order.rows.len()).filter(|at| *at != own)) {
            let expected = order.rows[at].clone();
            let (mut entries, mut holds, mut is_rounded) = (Vec::new(), Vec::new(), false);
            for (printed, derived) in row.iter().zip(&expected) {
                let arena = &mut self.quantities.derivations.kinematics.arena;
                let (mut verdict, place) = self.comparer.compare_with_states(arena, *printed, *derived);
                if !verdict.is_equal()
                    && agrees_to_printed_digits(self.quantities, self.comparer, self.numbers, *printed, *derived)
                {
                    (verdict, is_rounded) = (Verdict::Equal(Engine::NormalForm), true);
                }
                if !verdict.is_equal() {
                    break;
                }
                entries.push(verdict);
                holds.push(place);
            }
            if is_rounded && entries.len() == row.len() {
                let by = RowMatchResult::Row { at, factor: Expr::ONE };
                return Some(RowJudgement { by, entries, expected, holds, is_rounded });
            }
        }
        None
    }

    /// Completes the finding on a printed row with its verdict and remarks. A wrong row is described by its wrong
    /// entries, or by `whole` if the row is read as one formula.
    pub(super) fn row_finding(
        &mut self,
        mut finding: Finding,
        row: &[PrintedFormulaValue],
        order: &DerivedSystem,
        judged: &RowJudgement,
        whole: Option<WholeRow>,
        place: RowPlace<'_>,
    ) -> Finding {
        let RowPlace { index, system } = place;
        finding.judgement = Judgement::Equal;
        finding.holds = judged.holds();
        let as_term = |judge: &mut Self, row: &Row| judge.row_as_term(row, &order.unknowns);
        finding.derived = Some(as_term(self, &judged.expected));
        match &judged.by {
            RowMatchResult::Row { at, factor } => {
                // An author may exchange the two sides of an equation.
                let is_turned = system.row_texts.is_some() && *factor == Expr::MINUS_ONE;
                if *factor != Expr::ONE && !is_turned {
                    finding.factor = Some(*factor);
                    finding.judgement = Judgement::Scaled;
                }
                if *at != index {
                    finding.remarks.push(format!("compared with derived row {}", at + 1));
                }
            }
            RowMatchResult::Combination { multipliers } => {
                finding.judgement = Judgement::Scaled;
                let arena = &self.quantities.derivations.kinematics.arena;
                let parts = multipliers.iter().enumerate().filter(|(_, m)| **m != Expr::ZERO);
                let parts: Vec<String> =
                    parts.map(|(i, m)| format!("({}) row {}", print_text(arena, *m), i + 1)).collect();
                let by = if parts.is_empty() { "of derived rows".to_owned() } else { parts.join(" + ") };
                finding.remarks.push(format!("a combination: {by}"));
            }
        }
        if judged.is_rounded {
            finding.up_to = Some("to the digits printed");
            finding.remarks.push(ROUNDED.to_owned());
        }
        // A factor of the whole row that contains parameters or the state may come from a wrong abbreviation.
        let arena = &self.quantities.derivations.kinematics.arena;
        let is_plain = matches!(&judged.by, RowMatchResult::Row { factor, .. } if arena.as_number(*factor).is_some());
        let right = judged.entries.iter().filter(|verdict| verdict.is_equal()).count();
        if is_plain && right + 1 >= row.len() {
            for (printed, _) in row.iter().zip(&judged.entries).filter(|(_, verdict)| verdict.is_equal()) {
                self.book.record_right_formula(printed.raw);
            }
        }
        if judged.is_right() {
            self.book.trust_parts(row.iter().map(|printed| printed.raw).filter(|raw| *raw != Expr::ZERO));
            return finding;
        }
        finding.holds = StatesOfValidity::EVERYWHERE;
        let undecided = judged.entries.iter().find_map(|v| match v {
            Verdict::Undecided(why) => Some(why.clone()),
            _ => None,
        });
        let witness = judged.entries.iter().find_map(|v| match v {
            Verdict::Different(witness) => Some(witness.clone()),
            _ => None,
        });
        finding.judgement = match (&witness, undecided) {
            (None, Some(why)) => Judgement::Undecided(why),
            _ => Judgement::Different,
        };
        let raw: Row = row.iter().map(|printed| printed.raw).collect();
        let raw = as_term(self, &raw);
        let (model, arena) = (self.quantities.model, &self.quantities.derivations.kinematics.arena);
        if let Err(message) = model.checked_unit_of(arena, raw) {
            finding.remarks.push(format!("units alone show it: {message}"));
        }
        if let Some(whole) = whole {
            return self.whole_row_finding(finding, whole, row, order, witness);
        }
        let wrong: Vec<usize> = (0..judged.entries.len()).filter(|at| !judged.entries[*at].is_equal()).collect();
        let mut places = Vec::new();
        let mut mistakes = Vec::new();
        for at in wrong {
            let unknown = order.unknowns.get(at);
            let (words, mistake) = self.describe_wrong_row_entry(unknown, row[at], judged.expected[at]);
            finding.places.push(self.row_entry_name(unknown));
            places.push(words);
            mistakes.push(mistake);
        }
        if let [mistake] = mistakes.as_slice() {
            (finding.change, finding.slip) = (mistake.change, mistake.slip);
            finding.abbreviations.clone_from(&mistake.abbreviations);
        }
        let wrong = places.join("; ");
        finding.remarks.push(format!("wrong: {wrong}"));
        finding.wrong = Some(wrong);
        let values: Row = row.iter().map(|printed| printed.value).collect();
        self.finding_with_difference(finding, order, &values, &judged.expected, witness)
    }

    /// Adds to the finding on a wrong row the difference printed − expected, and a state with values at which the two
    /// differ. The state is for the whole row with its unknowns. If none is found, `of_entry` is used, which is for a
    /// single entry.
    pub(super) fn finding_with_difference(
        &mut self,
        mut finding: Finding,
        order: &DerivedSystem,
        printed: &Row,
        expected: &Row,
        of_entry: Option<Witness>,
    ) -> Finding {
        let [printed, expected] = [printed, expected].map(|row| self.row_as_term(row, &order.unknowns));
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let difference = arena.sub(printed, expected);
        finding.witness = match self.comparer.compare(arena, printed, expected) {
            Verdict::Different(whole) => Some(whole),
            _ => of_entry,
        };
        finding.difference = Some(self.simplify(difference));
        finding
    }

    /// Residual of a row as one term: Σ entry · unknown − right side.
    pub(super) fn row_as_term(&mut self, row: &Row, unknowns: &[Expr]) -> Expr {
        linear_row_term(&mut self.quantities.derivations.kinematics.arena, unknowns, row)
    }

    /// Name of an entry of a row, in words: the coefficient of `unknown`, or the right-hand side for `None`.
    fn row_entry_name(&self, unknown: Option<&Expr>) -> String {
        let arena = &self.quantities.derivations.kinematics.arena;
        match unknown {
            Some(unknown) => format!("the coefficient of {}", print_text(arena, *unknown)),
            None => "the right-hand side".to_owned(),
        }
    }

    /// Describes a wrong entry in words, with its place and its repair or its error. Also returns the mistake.
    fn describe_wrong_row_entry(
        &mut self,
        unknown: Option<&Expr>,
        printed: PrintedFormulaValue,
        expected: Expr,
    ) -> (String, Mistake) {
        let place = self.row_entry_name(unknown);
        let difference = self.quantities.derivations.kinematics.arena.sub(printed.value, expected);
        let difference = self.simplify(difference);
        let mistake = self.find_mistake(printed, expected, difference);
        if !mistake.words.is_empty() {
            return (format!("in {place}, {}", mistake.words.join(", ")), mistake);
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        (format!("{place} is off by {}", print_text(arena, difference)), mistake)
    }

    /// Completes the finding on a single entry of a row, the entry with the index `at`.
    pub(super) fn entry_finding(
        &mut self,
        finding: Finding,
        printed: PrintedFormulaValue,
        judged: &RowJudgement,
        at: usize,
    ) -> Finding {
        let mut finding = finding.with_verdict(judged.entries[at].clone(), judged.holds[at], judged.expected[at]);
        match &judged.by {
            RowMatchResult::Row { factor, .. } if *factor != Expr::ONE => {
                finding.factor = Some(*factor);
                if finding.judgement == Judgement::Equal {
                    finding.judgement = Judgement::Scaled;
                }
            }
            RowMatchResult::Combination { .. } if finding.judgement == Judgement::Equal => {
                finding.judgement = Judgement::Scaled;
            }
            RowMatchResult::Combination { .. } | RowMatchResult::Row { .. } => {}
        }
        if finding.judgement == Judgement::Equal {
            self.book.record_right_formula(printed.raw);
        }
        if finding.judgement == Judgement::Different {
            let difference = self.quantities.derivations.kinematics.arena.sub(printed.value, judged.expected[at]);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            finding.name_mistake(self.find_mistake(printed, judged.expected[at], difference));
        }
        finding
    }
}
