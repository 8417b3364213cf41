//! Judgement of printed linear systems, row by row.

use super::motion_system::{MotionSystem, motion_of_rows};
use super::row_findings::RowPlace;
use super::whole_rows::SolvedUnknowns;
use crate::diff::equations::claim::Claim;
use crate::diff::equations::derived_system::{DerivedSystem, derived_system, is_derived_unknown_of_time};
use crate::diff::equations::matched_system::MatchedSystem;
use crate::diff::equations::row_judgement::{Row, RowMatchResult, TermTools};
use crate::diff::formulas::entry_judge::{EntryJudge, PrintedFormulaValue};
use crate::diff::formulas::finding::{Finding, Judgement, TracedFinding, unjudged_finding};
use crate::diff::formulas::formula_reading::FormulaReading;

use crate::algebra::Expr;
use crate::algebra::meaning::permitted_states::StatesOfValidity;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::value::rank::rank;
use crate::mechanics::{Formulation, Kinematics, Quantities};
use crate::model::Model;
use crate::publication::{Entry, QuantityNames, System, has_decimals, system_row_text};
use std::cell::OnceCell;

/// Printed system as equations of motion, with the derived matrix that it was compared with.
#[derive(Clone, Debug)]
pub struct MatchedMotion {
    /// Printed equations of motion, in the order of the derived unknowns.
    pub motion: MotionSystem,
    /// Coefficient matrix of the derived system, without right-hand sides; empty if the publication states
    /// accelerations directly.
    pub matrix: Vec<Vec<Expr>>,
    /// Match of each printed row with the derived rows.
    pub rows: Vec<RowMatchResult>,
}

/// Judgement of one printed system or program (listing): findings, matched rows and motion.
pub struct JudgedSystem {
    /// Findings on the rows and entries of the system, each with its claim (its statement as data).
    pub findings: Vec<TracedFinding>,
    /// Printed rows with the matched derived rows. `None` if a program states accelerations directly, or if the entry
    /// holds only near a point.
    pub table: Option<MatchedSystem>,
    /// Printed system as equations of motion; `None` if it is incomplete, or if the entry holds
    /// only near a point.
    pub motion: Option<MatchedMotion>,
}

/// Rows of a printed system, with unchanged entries, in the order of the derived unknowns. An unknown that is not
/// printed in the system gets the coefficient 0.
fn rows_as_printed(system: &System, order: &[Expr]) -> Vec<Row> {
    let columns: Vec<Option<usize>> = order.iter().map(|x| system.unknowns.iter().position(|u| u == x)).collect();
    let row = |(entries, right): (&Vec<Expr>, &Expr)| {
        let entries = columns.iter().map(|at| at.map_or(Expr::ZERO, |at| entries[at]));
        entries.chain([*right]).collect()
    };
    system.matrix.iter().zip(&system.right).map(row).collect()
}

/// Printed rows in the order of the derived unknowns, in which the names of derived quantities are replaced with their
/// values. The error is the reason why a printed term has no value.
pub(super) fn printed_rows_of_judged_system(
    quantities: &mut Quantities<'_>,
    names: &QuantityNames,
    system: &System,
    order: &[Expr],
) -> Result<Vec<Row>, String> {
    let reading = FormulaReading::of(system.formulation);
    let mut form = LinearForm::new(order);
    let mut rows = Vec::new();
    for row in rows_as_printed(system, order) {
        let mut row = row.into_iter().map(|e| reading.value(quantities, names, e)).collect::<Result<Row, String>>()?;
        // Names of derived quantities may represent accelerations.
        let arena = &mut quantities.derivations.kinematics.arena;
        let right = row.pop().unwrap_or(Expr::ZERO);
        // A row that is not linear in the unknowns is kept as printed.
        let (entries, rest) =
            form.coefficients(arena, right).unwrap_or_else(|_| (vec![Expr::ZERO; order.len()], right));
        for (entry, more) in row.iter_mut().zip(entries) {
            *entry = arena.sub(*entry, more);
        }
        row.push(rest);
        rows.push(row);
    }
    Ok(rows)
}

/// Converts a printed system to equations of motion. `None` unless it has all unknowns and all rows of the derived
/// system.
pub fn motion_of_system(
    quantities: &mut Quantities<'_>,
    names: &QuantityNames,
    entry: &Entry,
    system: &System,
) -> Option<MotionSystem> {
    let order = derived_system(quantities, system.formulation, system.frame).ok()?;
    let rows = printed_rows_of_judged_system(quantities, names, system, &order.unknowns).ok()?;
    let is_motion = is_complete_motion(quantities, system, &order, &rows);
    is_motion.then(|| motion_of_rows(quantities, &entry.id, system.formulation, &rows))
}

/// True if a printed system has a non-zero entry for the acceleration of time or for the clock's
/// multiplier.
fn judged_system_mentions_time(model: &Model, system: &System) -> bool {
    let mut columns = (0..system.unknowns.len()).filter(|at| is_derived_unknown_of_time(model, system.unknowns[*at]));
    columns.any(|column| system.matrix.iter().any(|row| row[column] != Expr::ZERO))
}

/// True if printed rows are complete equations of motion: there are as many rows as unknowns, all unknowns are present,
/// and the rows are linear.
fn is_complete_motion(quantities: &Quantities<'_>, system: &System, order: &DerivedSystem, rows: &[Row]) -> bool {
    let arena = &quantities.derivations.kinematics.arena;
    let is_linear =
        |row: &Row| row.last().is_some_and(|right| !order.unknowns.iter().any(|u| arena.mentions(*right, *u)));
    let all_there = system.formulation.unknowns(quantities.model).iter().all(|(_, u)| order.unknowns.contains(u))
        && order.unknowns.iter().all(|u| system.unknowns.contains(u));
    all_there && rows.len() == order.unknowns.len() && rows.iter().all(is_linear)
}

impl EntryJudge<'_, '_> {
    /// Judges a printed system: first each row, then each entry that has its own id.
    pub fn judge_system(&mut self, entry: &Entry, system: &System) -> JudgedSystem {
        let model = self.quantities.model;
        let both = derived_system(self.quantities, system.formulation, system.frame).and_then(|order| {
            let order = if judged_system_mentions_time(model, system) { order } else { order.without_time(model) };
            let rows = printed_rows_of_judged_system(self.quantities, self.names, system, &order.unknowns)?;
            let exact = order.clone();
            let (order, rows) = self.expand_judged_system(order, rows)?;
            Ok((exact, order, rows))
        });
        let (exact, mut order, rows) = match both {
            Ok(both) => both,
            Err(why) => {
                let finding = Finding::new(&entry.id, &entry.section, Judgement::Undecided(why), "");
                return JudgedSystem { findings: vec![finding.with_claim(Claim::Other)], table: None, motion: None };
            }
        };
        let raw = rows_as_printed(system, &order.unknowns);
        let reading = FormulaReading::of(system.formulation);

        let multipliers = self.adapt_judged_system_to_multipliers(&mut order, &rows);
        let shown_rows = order.shown_rows(multipliers.is_none() && system.frame.is_none());
        let exact = if self.near.is_some() { exact } else { order.clone() };
        let solving = SolvedUnknowns { order: &exact, values: OnceCell::new() };
        let total = self.rows_with_total_derivatives(system, &raw, &order);
        let mut findings: Vec<TracedFinding> = Vec::new();
        let (mut matches, mut kept) = (Vec::new(), Vec::new());
        for (i, row) in rows.iter().enumerate() {
            let texts = system.matrix_texts[i].iter().chain([&system.right_texts[i]]);
            let has_decimals =
                texts.chain(system.row_texts.iter().map(|texts| &texts[i])).any(|text| has_decimals(text));
            let judged = if has_decimals {
                self.judge_row_with_decimals(row, &order, i)
            } else {
                self.judge_row(row, &order, i)
            };
            let id = system.row_id(&entry.id, i);
            let (entries, right) = (&system.matrix_texts[i], &system.right_texts[i]);
            let shown = match &system.row_texts {
                Some(texts) => texts[i].clone(),
                None => system_row_text(entries, &system.unknown_names, right, entry.notation),
            };
            let finding = unjudged_finding(&id, entry, &shown);
            if let Some(finding) = self.constraint_finding_in_system(&finding, row) {
                findings.push(finding.with_claim(Claim::Other));
                continue;
            }
            kept.push(i);
            if let Some(right) =
                total.as_ref().and_then(|total| self.judge_with_total_derivative(&total[i], row, &order, i))
            {
                findings
                    .push(self.partial_derivative_finding(finding, row, &right, &order).with_claim(Claim::HeldTime));
                matches.push(judged.by);
                continue;
            }
            let claim = match self.earlier_system_row_with_expansion(system.formulation, &order.unknowns, row) {
                Some((table, row)) => Claim::Expansion { table, row },
                None => Claim::Row { table: self.earlier.len(), row: i },
            };
            let row_printed: Vec<PrintedFormulaValue> = raw[i]
                .iter()
                .zip(row)
                .map(|(raw, value)| PrintedFormulaValue { raw: *raw, value: *value, reading })
                .collect();
            // If entries have ids of their own, each is compared with an entry of a single derived row.
            let is_apart = system.matrix_ids.is_some() || system.right_ids.is_some();
            let whole = if is_apart { None } else { self.whole_row(&finding, &row_printed, &order, &solving, &judged) };
            let by = whole.as_ref().map_or_else(|| judged.by.clone(), |whole| whole.row_match(judged.by.clone()));
            let place = RowPlace { index: i, system };
            let finding = self.row_finding(finding, &row_printed, &order, &judged, whole, place);
            findings.push(finding.with_derived_row(&judged, shown_rows).with_claim(claim));
            for (j, unknown) in system.unknowns.iter().enumerate() {
                let Some(id) = system.matrix_id(i, j) else { break };
                let Some(at) = order.unknowns.iter().position(|u| u == unknown) else { continue };
                let text = &system.matrix_texts[i][j];
                let claim = Claim::Entry { table: self.earlier.len(), row: i, column: at };
                let finding = self.entry_finding(unjudged_finding(&id, entry, text), row_printed[at], &judged, at);
                findings.push(finding.with_derived_row(&judged, shown_rows).with_claim(claim));
            }
            if let Some(id) = system.right_id(i) {
                let at = row.len() - 1;
                let claim = Claim::Entry { table: self.earlier.len(), row: i, column: at };
                let text = &system.right_texts[i];
                let finding = self.entry_finding(unjudged_finding(&id, entry, text), row_printed[at], &judged, at);
                findings.push(finding.with_derived_row(&judged, shown_rows).with_claim(claim));
            }
            matches.push(by);
        }
        if let Some(first) = findings.first_mut() {
            first.finding.remarks.extend(multipliers);
        }
        let ids: Vec<String> = kept.iter().map(|i| system.row_id(&entry.id, *i)).collect();
        let rows: Vec<Row> = kept.into_iter().map(|i| rows[i].clone()).collect();
        self.mark_missing_equations_of_system(&mut findings, &ids, system, &rows, &order.unknowns);
        let motion = is_complete_motion(self.quantities, system, &order, &rows).then(|| {
            let matrix = order.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect();
            let motion = motion_of_rows(self.quantities, &entry.id, system.formulation, &rows);
            MatchedMotion { motion, matrix, rows: matches.clone() }
        });
        let table = order.into_matched_system(system.formulation, rows, matches);
        self.restrict_judged_system(JudgedSystem { findings, table: Some(table), motion })
    }

    /// Finding on a printed row without unknowns that states a constraint of the mechanism, such as a loop equation.
    /// Returns `None` for any other row, including an identity that holds in all states.
    fn constraint_finding_in_system(&mut self, finding: &Finding, row: &Row) -> Option<Finding> {
        let (right, entries) = row.split_last()?;
        if *right == Expr::ZERO || entries.iter().any(|entry| *entry != Expr::ZERO) {
            return None;
        }
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let (verdict, holds) = self.comparer.compare_with_states(arena, *right, Expr::ZERO);
        (verdict.is_equal() && holds != StatesOfValidity::EVERYWHERE).then(|| {
            let remark = "a constraint of the model, which stands beside the equations of motion".to_owned();
            Finding { holds, ..finding.clone().accept_with_remark("a constraint of the model", remark) }
        })
    }

    /// Rewrites the derived rows in the multipliers of the printed rows. Returns a description of the printed
    /// multipliers; `None` if they equal the derived multipliers.
    fn adapt_judged_system_to_multipliers(&mut self, order: &mut DerivedSystem, rows: &[Row]) -> Option<String> {
        let model = self.quantities.model;
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let mut terms = TermTools { arena, simplifier, comparer: self.comparer };
        terms.adapt_to_printed_multipliers(order, rows, model, self.multipliers)
    }

    /// Expands derived and printed rows up to the order of the entry if it holds near a point. Rows of any other entry
    /// are returned unchanged. The error is the reason why an expansion does not exist.
    pub(super) fn expand_judged_system(
        &mut self,
        order: DerivedSystem,
        rows: Vec<Row>,
    ) -> Result<(DerivedSystem, Vec<Row>), String> {
        let Some(near) = &mut self.near else { return Ok((order, rows)) };
        near.separate_orders_if_needed(self.quantities, &rows.concat());
        let mut all = |quantities: &mut Quantities<'_>, list: Vec<Row>| -> Result<Vec<Row>, String> {
            let row = |row: Row| -> Result<Row, String> {
                let entry = |(at, e): (usize, Expr)| match order.unknowns.get(at) {
                    Some(unknown) => near.expand_coefficient(quantities, *unknown, e),
                    None => near.expand_formula(quantities, e),
                };
                row.into_iter().enumerate().map(entry).collect()
            };
            list.into_iter().map(row).collect()
        };
        let (derived, rows) = (all(self.quantities, order.rows.clone())?, all(self.quantities, rows)?);
        Ok((DerivedSystem { rows: derived, ..order }, rows))
    }

    /// Indices (table, row) of an earlier printed row whose expansion near the entry's point is
    /// `row`.
    /// Returns `None` if no earlier row has this expansion, or if the entry holds everywhere.
    fn earlier_system_row_with_expansion(
        &mut self,
        formulation: Formulation,
        unknowns: &[Expr],
        row: &Row,
    ) -> Option<(usize, usize)> {
        for (table, earlier) in self.earlier.iter().enumerate() {
            if earlier.formulation != formulation || earlier.unknowns != unknowns {
                continue;
            }
            for (at, printed) in earlier.printed.iter().enumerate() {
                let near = self.near.as_mut()?;
                let mut is_same = true;
                for (column, (whole, own)) in printed.iter().zip(row).enumerate() {
                    let expanded = match unknowns.get(column) {
                        Some(unknown) => near.expand_coefficient(self.quantities, *unknown, *whole),
                        None => near.expand_formula(self.quantities, *whole),
                    };
                    let arena = &mut self.quantities.derivations.kinematics.arena;
                    is_same = expanded.is_ok_and(|e| self.comparer.compare(arena, e, *own).is_equal());
                    if !is_same {
                        break;
                    }
                }
                if is_same {
                    return Some((table, at));
                }
            }
        }
        None
    }

    /// Removes table and motion from the result of an entry that holds only near a point; other results are unchanged.
    /// Such an entry is no equation of the whole motion. It is traced to another row only if it is the expansion of
    /// that row.
    pub(super) fn restrict_judged_system(&self, judged: JudgedSystem) -> JudgedSystem {
        if self.near.is_none() {
            return judged;
        }
        let traced = |claim: Claim| if matches!(claim, Claim::Expansion { .. }) { claim } else { Claim::Other };
        let findings = judged.findings.into_iter().map(|found| found.finding.with_claim(traced(found.claim))).collect();
        JudgedSystem { findings, table: None, motion: None }
    }

    /// Marks a right row as "different" if it depends linearly on the rows before it, because an equation of motion is
    /// then missing. Adds a remark if the system has too few equations to determine the motion.
    fn mark_missing_equations_of_system(
        &self,
        findings: &mut [TracedFinding],
        ids: &[String],
        system: &System,
        rows: &[Row],
        unknowns: &[Expr],
    ) {
        let arena = &self.quantities.derivations.kinematics.arena;
        let Some(first) = findings.first_mut() else { return };
        let constraints = &self.quantities.model.motion_constraints;
        // Rows without multipliers determine the accelerations together with the constraints.
        let is_absent = |unknown: &Expr| !system.unknowns.contains(unknown);
        let absent = constraints.iter().filter(|constraint| is_absent(&constraint.multiplier)).count();
        let unknowns = unknowns.len();
        if rows.len() + constraints.len() + absent < unknowns {
            first.finding.remarks.push(format!(
                "the system has {} of {unknowns} equations: it does not determine the motion",
                rows.len()
            ));
        }
        let Some(row) = rank(arena, rows).and_then(|found| found.dependent) else { return };
        let Some(TracedFinding { finding, .. }) = findings.iter_mut().find(|found| found.finding.id == ids[row]) else {
            return;
        };
        if rows.len() <= unknowns && matches!(finding.judgement, Judgement::Equal | Judgement::Scaled) {
            finding.judgement = Judgement::Different;
            finding.remarks.push("this row follows from the rows above: an equation of motion is missing".to_owned());
        }
    }
}
