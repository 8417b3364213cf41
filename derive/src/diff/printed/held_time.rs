//! Detection of rows in which a partial derivative ∂/∂t, with q and q̇ held constant, is printed
//! instead of d/dt.

use super::systems::printed;
use crate::algebra::Expr;
use crate::algebra::meaning::compare::Verdict;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::diff::equations::derived_system::Ordered;
use crate::diff::equations::rows::{Row, RowJudgement};
use crate::diff::formulas::entries::Judge;
use crate::diff::formulas::finding::{Finding, Judgement};
use crate::diff::repairs::Slip;
use crate::publication::System;

/// Text that describes the mistake in a finding.
const WORDS: &str = "∂/∂t is printed instead of d/dt";

impl Judge<'_, '_> {
    /// Printed rows in which d/dt replaces every ∂/∂t; `None` if no row has a ∂/∂t, or if the entry
    /// holds near a point.
    pub(super) fn with_total_rates(&mut self, system: &System, raw: &[Row], order: &Ordered) -> Option<Vec<Row>> {
        if self.near.is_some() {
            return None;
        }
        let names = self.names.with_total_rates(&self.quantities.derivations.kinematics.arena, &raw.concat())?;
        printed(self.quantities, &names, system, &order.unknowns).ok()
    }

    /// Judgement of the row `total`, in which d/dt replaces ∂/∂t, if `total` is right and the
    /// printed `row` is wrong or zero.
    /// Returns `None` if the replacement changes nothing, or if the printed row is right.
    pub(super) fn right_with(&mut self, total: &Row, row: &Row, order: &Ordered, index: usize) -> Option<RowJudgement> {
        if total == row {
            return None;
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        let is_empty = row.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero);
        if !is_empty && self.row(row, order, index).is_right() {
            return None;
        }
        Some(self.row(total, order, index)).filter(RowJudgement::is_right)
    }

    /// Completes the finding of a row with a wrong ∂/∂t; `right` is the judgement of the row with
    /// d/dt.
    pub(super) fn held_time(
        &mut self,
        mut finding: Finding,
        row: &Row,
        right: &RowJudgement,
        order: &Ordered,
    ) -> Finding {
        let printed: Expr = self.as_term(row, &order.unknowns);
        let expected: Expr = self.as_term(&right.expected, &order.unknowns);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        if let Verdict::Different(witness) = self.comparer.compare(arena, printed, expected) {
            finding.witness = Some(witness);
        }
        let difference = arena.sub(printed, expected);
        finding.difference = Some(self.simplify(difference));
        finding.judgement = Judgement::Different;
        finding.derived = Some(expected);
        finding.slip = Some(Slip::Symbol);
        finding.wrong = Some(WORDS.to_owned());
        finding.remarks.push(WORDS.to_owned());
        finding
    }
}
