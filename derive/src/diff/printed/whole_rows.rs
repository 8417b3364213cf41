//! Reading of a wrong row as one formula, if its entries alone do not show the mistake.
//!
//! Rows are compared entry by entry. But one mistake can make several entries of a row wrong: a lost dot moves a term
//! from one entry to another. Another case is an equation that is solved for one unknown. It is no multiple of a
//! derived row. It is therefore compared with the value of the unknown that follows from all derived rows together.

use crate::diff::equations::derived_system::DerivedSystem;
use crate::diff::equations::row_judgement::{Row, RowJudgement, RowMatchResult};
use crate::diff::formulas::entry_judge::{EntryJudge, PrintedFormulaValue};
use crate::diff::formulas::finding::{Finding, Judgement, Mistake};

use crate::algebra::meaning::compare::{Verdict, Witness};
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::print::print_text;
use crate::algebra::value::rank::pivot_rows_and_columns;
use crate::algebra::{Expr, Node};
use crate::mechanics::Kinematics;
use crate::publication::has_right_side;
use std::cell::OnceCell;

/// Largest number of unknowns of a derived system that is solved for the value of an unknown.
const MOST_UNKNOWNS: usize = 8;

/// Largest number of derived rows, each divided by one of its coefficients, with which a wrong row is compared.
const MOST_MEANT: usize = 8;

/// Largest number of multipliers that are eliminated from derived rows.
const MOST_ELIMINATED: usize = 3;

/// Result of reading a wrong row as one formula.
pub(super) enum WholeRow {
    /// The row is not linear in the unknowns, and holds with the values of the unknowns from the
    /// derived rows.
    Holds,
    /// One mistake explains the wrong row; the second value is the derived row that the author meant.
    Changed(Mistake, Row),
    /// The row states the value of an unknown, or of a sum of unknowns; this is its finding.
    Solved(Box<Finding>),
}

/// Derived rows with the values of their unknowns, which are computed when first needed.
pub(super) struct SolvedUnknowns<'a> {
    /// Derived rows of the system, exact even if the entry holds only near a point.
    pub order: &'a DerivedSystem,
    /// Values of the unknowns, empty until they are computed. The inner `None` means that the rows do not determine
    /// them or have too many unknowns.
    pub values: OnceCell<Option<Vec<Expr>>>,
}

impl WholeRow {
    /// Match of the row for later steps: the match `entries` if one mistake explains the row, else no single derived
    /// row.
    pub fn row_match(&self, entries: RowMatchResult) -> RowMatchResult {
        match self {
            Self::Changed(..) => entries,
            Self::Holds | Self::Solved(_) => RowMatchResult::Combination { multipliers: Vec::new() },
        }
    }
}

impl EntryJudge<'_, '_> {
    /// Reads a wrong row as one formula.
    /// Returns `None` if the entries alone show the mistake, or if no entry is proved wrong.
    pub(super) fn whole_row(
        &mut self,
        finding: &Finding,
        row: &[PrintedFormulaValue],
        order: &DerivedSystem,
        solving: &SolvedUnknowns<'_>,
        judged: &RowJudgement,
    ) -> Option<WholeRow> {
        let wrong = judged.entries.iter().filter(|verdict| !verdict.is_equal()).count();
        if wrong == 0 {
            return None;
        }
        let solved = self.whole_row_finding_of_unknown(finding, row, order, solving);
        if solved.as_ref().is_some_and(|found| found.judgement == Judgement::Equal) {
            return solved.map(|found| WholeRow::Solved(Box::new(found)));
        }
        // A stated reaction or multiplier is meant as a value. A stated acceleration may also be an equation of motion.
        let is_force = only_unknown_of_whole_row(row)
            .is_some_and(|at| !self.quantities.mentions_accelerations(order.unknowns[at]));
        if is_force && solved.is_some() {
            return solved.map(|found| WholeRow::Solved(Box::new(found)));
        }
        if self.whole_row_holds_with_solutions(row, solving) {
            return Some(WholeRow::Holds);
        }
        let has_unknowns = self.quantities.mentions_accelerations(row.last()?.raw);
        let is_different = judged.entries.iter().any(|verdict| matches!(verdict, Verdict::Different(_)));
        if !is_different || (wrong == 1 && !has_unknowns) {
            return None;
        }
        let of = |part: fn(&PrintedFormulaValue) -> Expr| row.iter().map(part).collect::<Row>();
        let (raw, value) = (of(|printed| printed.raw), of(|printed| printed.value));
        let [raw, value] = [&raw, &value].map(|row| self.row_as_term(row, &order.unknowns));
        let whole = PrintedFormulaValue { raw, value, reading: row[0].reading };
        let mut meant = self.whole_rows_possibly_meant(order, judged);
        meant.extend(self.rows_without_multipliers(&of(|printed| printed.value), order));
        for expected in meant {
            let term = self.row_as_term(&expected, &order.unknowns);
            if let Some(mistake) = self.find_slip(whole, term) {
                return Some(WholeRow::Changed(mistake, expected));
            }
        }
        solved.map(|found| WholeRow::Solved(Box::new(found)))
    }

    /// Rows that the author of a wrong row may have meant: first the matched row, then derived rows divided by one of
    /// their coefficients. A coefficient is used as a divisor if it depends only on parameters.
    fn whole_rows_possibly_meant(&mut self, order: &DerivedSystem, judged: &RowJudgement) -> Vec<Row> {
        let mut list = vec![judged.expected.clone()];
        let parameters = self.quantities.model.p();
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let mut divisors: Vec<(usize, Expr)> = Vec::new();
        for (at, row) in order.rows.iter().enumerate() {
            for entry in row[..order.unknowns.len()].iter().chain([&Expr::ONE]) {
                let parts = arena.reachable(&[*entry]);
                let is_constant = parts.iter().all(|e| arena.symbol_name(*e).is_none() || parameters.contains(e));
                if *entry != Expr::ZERO && is_constant && !divisors.contains(&(at, *entry)) {
                    divisors.push((at, *entry));
                }
            }
        }
        divisors.truncate(MOST_MEANT);
        for (at, divisor) in divisors {
            let quotients = order.rows[at].iter().map(|e| arena.div(*e, divisor)).collect::<Option<Row>>();
            let row: Row = quotients.into_iter().flatten().map(|e| simplifier.simplify(arena, e)).collect();
            if row.len() == order.rows[at].len() && !list.contains(&row) {
                list.push(row);
            }
        }
        list
    }

    /// Derived rows from which the multipliers are eliminated by means of the other rows. Empty if the printed row has
    /// multipliers, or if the system has none or more than three.
    ///
    /// With rows P q̈ + L λ = r, the other rows give λ = (LᵀL)⁻¹ Lᵀ (r − P q̈). An author reads this value off along
    /// the axes of the constraints.
    fn rows_without_multipliers(&mut self, printed: &Row, order: &DerivedSystem) -> Vec<Row> {
        let multipliers = self.quantities.model.motion_constraints.iter().map(|constraint| constraint.multiplier);
        let columns: Vec<usize> = multipliers.filter_map(|m| order.unknowns.iter().position(|u| *u == m)).collect();
        let has_multiplier = |row: &Row| columns.iter().any(|c| row[*c] != Expr::ZERO);
        if !(1..=MOST_ELIMINATED).contains(&columns.len()) || has_multiplier(printed) {
            return Vec::new();
        }
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let mut list = Vec::new();
        for (at, row) in order.rows.iter().enumerate().filter(|(_, row)| has_multiplier(row)) {
            let others: Vec<&Row> = order
                .rows
                .iter()
                .enumerate()
                .filter(|(i, row)| *i != at && has_multiplier(row))
                .map(|(_, row)| row)
                .collect();
            let mut product = |left: usize, right: usize| {
                let terms: Vec<Expr> = others.iter().map(|row| arena.mul(row[left], row[right])).collect();
                let sum = arena.sum(&terms);
                simplifier.simplify(arena, sum)
            };
            let square: Vec<Row> = columns.iter().map(|i| columns.iter().map(|k| product(*i, *k)).collect()).collect();
            let kept: Vec<usize> = (0..row.len()).filter(|c| !columns.contains(c)).collect();
            let right: Vec<Row> = columns.iter().map(|i| kept.iter().map(|c| product(*i, *c)).collect()).collect();
            let Ok((values, _)) = solve_linear(arena, simplifier, &square, &right) else { continue };
            let mut without = vec![Expr::ZERO; row.len()];
            for (place, column) in kept.iter().enumerate() {
                let terms: Vec<Expr> =
                    columns.iter().zip(&values).map(|(c, value)| arena.mul(row[*c], value[place])).collect();
                let sum = arena.sum(&terms);
                let entry = arena.sub(row[*column], sum);
                without[*column] = simplifier.simplify(arena, entry);
            }
            list.push(without);
        }
        list
    }

    /// True if a row that is not linear in the unknowns holds when the unknowns have their values from the derived
    /// rows.
    fn whole_row_holds_with_solutions(&mut self, row: &[PrintedFormulaValue], solving: &SolvedUnknowns<'_>) -> bool {
        let order = solving.order;
        let values: Row = row.iter().map(|printed| printed.value).collect();
        let arena = &self.quantities.derivations.kinematics.arena;
        let mentions = |unknown: &Expr| arena.mentions(values[values.len() - 1], *unknown);
        if self.near.is_some() || !order.unknowns.iter().any(mentions) {
            return false;
        }
        let Some(solutions) = self.unknown_values_for_whole_row(solving) else { return false };
        let whole = self.row_as_term(&values, &order.unknowns);
        let pairs: Vec<(Expr, Expr)> = order.unknowns.iter().copied().zip(solutions).collect();
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let mut put = Substitution::new(&pairs);
        let residual = put.apply(arena, whole);
        put.undefined.is_none() && self.comparer.is_zero(arena, residual).is_equal()
    }

    /// Finding on a row that states the value of one unknown, or of a sum of unknowns with numerical factors. Returns
    /// `None` unless the value is right or its mistake is found.
    fn whole_row_finding_of_unknown(
        &mut self,
        finding: &Finding,
        row: &[PrintedFormulaValue],
        order: &DerivedSystem,
        solving: &SolvedUnknowns<'_>,
    ) -> Option<Finding> {
        let (right, entries) = row.split_last()?;
        let arena = &self.quantities.derivations.kinematics.arena;
        let numbers = || entries.iter().all(|entry| arena.as_number(entry.value).is_some());
        let first = only_unknown_of_whole_row(row)
            .or_else(|| entries.iter().position(|e| e.value != Expr::ZERO).filter(|_| numbers()))?;
        let solutions = self.unknown_values_for_whole_row(solving)?;
        let divisor = entries[first];
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let value = arena.div(right.value, divisor.value)?;
        let raw = arena.div(right.raw, divisor.raw)?;
        self.book.keep_quotient(arena, raw, right.raw, divisor.raw);
        let mut solved: Row = Vec::new();
        let mut terms = Vec::new();
        for (entry, unknown) in entries.iter().zip(&order.unknowns) {
            let factor = arena.div(entry.value, divisor.value)?;
            solved.push(factor);
            if factor != Expr::ZERO {
                let column = solving.order.unknowns.iter().position(|own| own == unknown)?;
                terms.push(arena.mul(factor, solutions[column]));
            }
        }
        let derived = arena.sum(&terms);
        let (value, derived) = match &mut self.near {
            Some(near) => {
                (near.expand_formula(self.quantities, value).ok()?, near.expand_formula(self.quantities, derived).ok()?)
            }
            None => (value, derived),
        };
        let derived = self.simplify(derived);
        let value = PrintedFormulaValue { raw, value, reading: right.reading };
        let mut found = self.judge_against_derived(finding.clone(), value, derived);
        // A mistake that exchanges two whole sums explains nothing.
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let is_sum = matches!(arena.node(value.value), Node::Sum(_, terms) if terms.len() > 1);
        let is_named = found.factor.is_some()
            || !found.abbreviations.is_empty()
            || found.change.is_some_and(|(own, _)| own != value.value || !is_sum);
        if found.judgement != Judgement::Equal && !(found.judgement == Judgement::Different && is_named) {
            return None;
        }
        let products: Vec<Expr> = solved.iter().zip(&order.unknowns).map(|(k, x)| arena.mul(*k, *x)).collect();
        let sum = arena.sum(&products);
        let name = print_text(arena, sum);
        found.remarks.insert(0, format!("compared with the value of {name} that all equations give"));
        solved.push(derived);
        found.derived = Some(self.row_as_term(&solved, &order.unknowns));
        Some(found)
    }

    /// Values of the unknowns from the derived rows, computed once. `None` if the rows do not determine them, or if
    /// there are too many rows.
    fn unknown_values_for_whole_row(&mut self, solving: &SolvedUnknowns<'_>) -> Option<Vec<Expr>> {
        let order = solving.order;
        solving.values.get_or_init(|| self.solve_unknowns_for_whole_row(order)).clone()
    }

    /// Solves the independent derived rows for all unknowns. `None` unless there are as many independent rows as
    /// unknowns, at most eight.
    fn solve_unknowns_for_whole_row(&mut self, order: &DerivedSystem) -> Option<Vec<Expr>> {
        let n = order.unknowns.len();
        if n > MOST_UNKNOWNS {
            return None;
        }
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let (independent, _) = pivot_rows_and_columns(arena, &order.rows)?;
        if independent.len() != n {
            return None;
        }
        let rows: Vec<&Row> = independent.iter().map(|row| &order.rows[*row]).collect();
        let a: Vec<Row> = rows.iter().map(|row| row[..n].to_vec()).collect();
        let b: Vec<Row> = rows.iter().map(|row| vec![row[n]]).collect();
        let (values, _) = solve_linear(arena, simplifier, &a, &b).ok()?;
        Some(values.into_iter().map(|value| value[0]).collect())
    }

    /// Completes the finding of a wrong row that was read as one formula.
    pub(super) fn whole_row_finding(
        &mut self,
        mut finding: Finding,
        whole: WholeRow,
        row: &[PrintedFormulaValue],
        order: &DerivedSystem,
        witness: Option<Witness>,
    ) -> Finding {
        match whole {
            WholeRow::Holds => {
                let remark = "with the accelerations and reactions that all equations give".to_owned();
                finding.accept_with_remark("with the derived unknowns", remark)
            }
            WholeRow::Changed(mistake, expected) => {
                let values: Row = row.iter().map(|printed| printed.value).collect();
                let words = mistake.words.join(", ");
                // In left − right, a term of the right side has the opposite sign.
                let has_right = has_right_side(&finding.printed);
                let wrong = if has_right { format!("in left − right, {words}") } else { words };
                finding.derived = Some(self.row_as_term(&expected, &order.unknowns));
                finding.remarks.push(format!("wrong: {wrong}"));
                finding.name_mistake(Mistake { words: Vec::new(), ..mistake });
                finding.wrong = Some(wrong);
                self.finding_with_difference(finding, order, &values, &expected, witness)
            }
            WholeRow::Solved(found) => *found,
        }
    }
}

/// Index of the only unknown that a row contains; `None` if it contains none or several.
fn only_unknown_of_whole_row(row: &[PrintedFormulaValue]) -> Option<usize> {
    let mut present = (0..row.len() - 1).filter(|at| row[*at].value != Expr::ZERO);
    let at = present.next()?;
    present.next().is_none().then_some(at)
}
