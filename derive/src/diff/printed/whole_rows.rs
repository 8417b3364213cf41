//! Wrong rows that are read as one formula.
//!
//! A row is compared entry by entry. A wrong row may differ in several entries by one mistake: a lost dot moves a term
//! from one entry to another. And an equation that is solved for one unknown is no multiple of a derived row: it is
//! compared with the value of the unknown that all derived rows give.

use crate::diff::equations::derived_system::Ordered;
use crate::diff::equations::rows::{Match, Row, RowJudgement};
use crate::diff::formulas::entries::{Judge, Printed};
use crate::diff::formulas::finding::{Finding, Judgement, Mistake};

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Witness;
use crate::algebra::solve::linear::solve;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::print::text;
use crate::algebra::value::rank::echelon;
use crate::mechanics::Kinematics;

/// Most unknowns of a derived system that is solved for one of them.
const MOST_UNKNOWNS: usize = 8;

/// A wrong row, read as one formula.
pub(super) enum WholeRow {
    /// The row is not linear in the unknowns, and right with the values that the derived rows give them.
    Holds,
    /// One mistake makes the whole row wrong, compared with the expected row.
    Changed(Mistake),
    /// The row states the value of one unknown, and this is its finding.
    Solved(Box<Finding>),
}

impl WholeRow {
    /// Match of the row: that of its entries, or none with a single derived row.
    pub fn matched(&self, entries: Match) -> Match {
        match self {
            Self::Changed(_) => entries,
            Self::Holds | Self::Solved(_) => Match::Combination { multipliers: Vec::new() },
        }
    }
}

impl Judge<'_, '_> {
    /// Reading of a wrong row as one formula; `None` if its entries, one by one, tell the mistake.
    pub(super) fn whole_row(
        &mut self,
        finding: &Finding,
        row: &[Printed],
        order: &Ordered,
        judged: &RowJudgement,
    ) -> Option<WholeRow> {
        let wrong = judged.entries.iter().filter(|verdict| !verdict.is_equal()).count();
        let right = row.last()?.raw;
        let has_unknowns = self.quantities.mentions_accelerations(right);
        if wrong == 0 || (wrong == 1 && !has_unknowns) {
            return None;
        }
        if self.holds_with_solutions(row, order) {
            return Some(WholeRow::Holds);
        }
        let of = |part: fn(&Printed) -> Expr| row.iter().map(part).collect::<Row>();
        let (raw, value) = (of(|printed| printed.raw), of(|printed| printed.value));
        let [raw, value, expected] = [&raw, &value, &judged.expected].map(|row| self.as_term(row, &order.unknowns));
        let whole = Printed { raw, value, reading: row[0].reading };
        if let Some(mistake) = self.slip(whole, expected) {
            return Some(WholeRow::Changed(mistake));
        }
        self.solved(finding, row, order)
    }

    /// True if a row that is not linear in the unknowns holds with their values.
    fn holds_with_solutions(&mut self, row: &[Printed], order: &Ordered) -> bool {
        let values: Row = row.iter().map(|printed| printed.value).collect();
        let arena = &self.quantities.derivations.kinematics.arena;
        let mentions = |unknown: &Expr| arena.mentions(values[values.len() - 1], *unknown);
        if self.near.is_some() || !order.unknowns.iter().any(mentions) {
            return false;
        }
        let Some(solutions) = self.solutions(order) else { return false };
        let whole = self.as_term(&values, &order.unknowns);
        let pairs: Vec<(Expr, Expr)> = order.unknowns.iter().copied().zip(solutions).collect();
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let mut put = Substitution::new(&pairs);
        let residual = put.apply(arena, whole);
        put.undefined.is_none() && self.comparer.is_zero(arena, residual).is_equal()
    }

    /// Reading of a row with one unknown as its value, if the value is right or its mistake is named.
    fn solved(&mut self, finding: &Finding, row: &[Printed], order: &Ordered) -> Option<WholeRow> {
        let (right, entries) = row.split_last()?;
        let mut present = (0..entries.len()).filter(|at| entries[*at].value != Expr::ZERO);
        let (at, None) = (present.next()?, present.next()) else { return None };
        let derived = self.solutions(order)?[at];
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let value = arena.div(right.value, entries[at].value)?;
        let raw = arena.div(right.raw, entries[at].raw)?;
        let (value, derived) = match &mut self.near {
            Some(near) => (near.formula(self.quantities, value).ok()?, near.formula(self.quantities, derived).ok()?),
            None => (value, derived),
        };
        let derived = self.simplify(derived);
        let value = Printed { raw, value, reading: right.reading };
        let mut found = self.compare(finding.clone(), value, derived);
        let is_named = found.factor.is_some() || found.change.is_some_and(|(own, _)| own != value.value);
        if found.judgement == Judgement::Different && !is_named {
            return None;
        }
        let name = text(&self.quantities.derivations.kinematics.arena, order.unknowns[at]);
        found.remarks.insert(0, format!("compared with the value of {name} that all equations give"));
        let mut solved: Row = vec![Expr::ZERO; order.unknowns.len() + 1];
        solved[at] = Expr::ONE;
        *solved.last_mut().expect("a row has a right-hand side") = derived;
        found.derived = Some(self.as_term(&solved, &order.unknowns));
        Some(WholeRow::Solved(Box::new(found)))
    }

    /// Values of the unknowns by the derived rows; `None` if these do not determine them, or are many.
    fn solutions(&mut self, order: &Ordered) -> Option<Vec<Expr>> {
        let n = order.unknowns.len();
        if n > MOST_UNKNOWNS {
            return None;
        }
        let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
        let (independent, _) = echelon(arena, &order.rows)?;
        if independent.len() != n {
            return None;
        }
        let rows: Vec<&Row> = independent.iter().map(|row| &order.rows[*row]).collect();
        let a: Vec<Row> = rows.iter().map(|row| row[..n].to_vec()).collect();
        let b: Vec<Row> = rows.iter().map(|row| vec![row[n]]).collect();
        let (values, _) = solve(arena, simplifier, &a, &b).ok()?;
        Some(values.into_iter().map(|value| value[0]).collect())
    }

    /// Finding of a wrong row that is read as one formula.
    pub(super) fn told_as_whole(
        &mut self,
        mut finding: Finding,
        whole: WholeRow,
        row: &[Printed],
        expected: &Row,
        order: &Ordered,
        witness: Option<Witness>,
    ) -> Finding {
        match whole {
            WholeRow::Holds => {
                let remark = "with the accelerations and reactions that all equations give".to_owned();
                finding.accepted("with the derived unknowns", remark)
            }
            WholeRow::Changed(mistake) => {
                let values: Row = row.iter().map(|printed| printed.value).collect();
                let wrong = mistake.words.join(", ");
                finding.remarks.push(format!("wrong: {wrong}"));
                finding.name_mistake(Mistake { words: Vec::new(), ..mistake });
                finding.wrong = Some(wrong);
                self.contrasted(finding, order, &values, expected, witness)
            }
            WholeRow::Solved(found) => *found,
        }
    }
}
