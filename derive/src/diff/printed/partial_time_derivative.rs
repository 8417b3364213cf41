//! Detection of rows in which a partial derivative ∂/∂t, with q and q̇ held constant, is printed instead of d/dt.

use super::judged_system::printed_rows_of_judged_system;
use crate::algebra::Expr;
use crate::algebra::meaning::compare::Verdict;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::diff::equations::derived_system::DerivedSystem;
use crate::diff::equations::row_judgement::{Row, RowJudgement};
use crate::diff::formulas::entry_judge::EntryJudge;
use crate::diff::formulas::finding::{Finding, Judgement};
use crate::diff::repairs::MistakeKind;
use crate::publication::System;

/// Text that describes the mistake in a finding.
const WORDS: &str = "∂/∂t is printed instead of d/dt";

impl EntryJudge<'_, '_> {
    /// Printed rows in which every ∂/∂t is replaced with d/dt. `None` if no row has a ∂/∂t, or if the entry holds near
    /// a point.
    pub(super) fn rows_with_total_derivatives(
        &mut self,
        system: &System,
        raw: &[Row],
        order: &DerivedSystem,
    ) -> Option<Vec<Row>> {
        if self.near.is_some() {
            return None;
        }
        let names = self.names.with_total_rates(&self.quantities.derivations.kinematics.arena, &raw.concat())?;
        printed_rows_of_judged_system(self.quantities, &names, system, &order.unknowns).ok()
    }

    /// Judgement of the row `total`, in which ∂/∂t is replaced with d/dt. It is returned if `total` is right and the
    /// printed `row` is wrong or zero. Returns `None` if the replacement changes nothing, or if the printed row is
    /// right.
    pub(super) fn judge_with_total_derivative(
        &mut self,
        total: &Row,
        row: &Row,
        order: &DerivedSystem,
        index: usize,
    ) -> Option<RowJudgement> {
        if total == row {
            return None;
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        let is_empty = row.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero);
        if !is_empty && self.judge_row(row, order, index).is_right() {
            return None;
        }
        Some(self.judge_row(total, order, index)).filter(RowJudgement::is_right)
    }

    /// Completes the finding on a row with a wrong ∂/∂t. `right` is the judgement of the row with d/dt.
    pub(super) fn partial_derivative_finding(
        &mut self,
        mut finding: Finding,
        row: &Row,
        right: &RowJudgement,
        order: &DerivedSystem,
    ) -> Finding {
        let printed: Expr = self.row_as_term(row, &order.unknowns);
        let expected: Expr = self.row_as_term(&right.expected, &order.unknowns);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        if let Verdict::Different(witness) = self.comparer.compare(arena, printed, expected) {
            finding.witness = Some(witness);
        }
        let difference = arena.sub(printed, expected);
        finding.difference = Some(self.simplify(difference));
        finding.judgement = Judgement::Different;
        finding.derived = Some(expected);
        finding.slip = Some(MistakeKind::Symbol);
        finding.wrong = Some(WORDS.to_owned());
        finding.remarks.push(WORDS.to_owned());
        finding
    }
}
