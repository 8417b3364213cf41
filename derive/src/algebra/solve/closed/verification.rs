//! Verification of solutions in closed form: the solutions are inserted into the given equations
//! and checked.

use super::branch_search::{BranchSearch, Case, Row};
use super::relation::{Branch, Relation, RelationCondition, RelationKind};
use super::workspace::Workspace;
use crate::algebra::Expr;

impl BranchSearch<'_, '_> {
    /// Checks a case (a partly solved system) that cannot be solved further. Its solutions are
    /// inserted into the given equations, and its branch is added to the solutions. `rows` are
    /// equations that stay unsolved.
    pub(super) fn verify_case(&mut self, case: &Case, rows: &[Row]) {
        if self.work.normalizer.ring().budget == 0 {
            self.found.is_cut = true;
            return;
        }
        let mut left: Vec<Expr> = rows.iter().map(|row| row.whole).collect();
        let mut case = case.clone();
        for row in self.rows.clone() {
            let Some(value) = self.work.substitute_relations(&case.relations, row) else {
                self.found.is_cut = true;
                return;
            };
            if self.work.comparer.is_zero(self.work.arena, value).is_equal() || self.is_verified_multiple(value, &left)
            {
                continue;
            }
            if self.work.sign(value).is_strict() {
                return;
            }
            match self.verified_sign_condition(value) {
                Some(need) => case.needs.push(need),
                None => left.push(value),
            }
        }
        if let Some(branch) = self.verified_branch(&case, &left)
            && !self.found.branches.contains(&branch)
        {
            self.found.branches.push(branch);
        }
    }

    /// Condition under which a term with a root √p² is 0. The root is |p|: if the term is 0 with
    /// the root replaced by p, the condition is p ≥ 0. If it is 0 with −p, the condition is −p ≥ 0.
    /// `None` if the term is 0 with neither.
    fn verified_sign_condition(&mut self, value: Expr) -> Option<RelationCondition> {
        let (p, [plus, minus]) = self.work.split_root(value)?;
        let mut vanishes = |e: Expr| self.work.comparer.is_zero(self.work.arena, e).is_equal();
        let (plus, minus) = (vanishes(plus), vanishes(minus));
        if plus {
            Some(RelationCondition::NotNegative(p))
        } else {
            minus.then(|| RelationCondition::NotNegative(self.work.arena.neg(p)))
        }
    }

    /// True if the numerator of the term `value` is a multiple of the numerator of a term in
    /// `left`. The terms in `left` are 0, so `value` is then 0 too.
    fn is_verified_multiple(&mut self, value: Expr, left: &[Expr]) -> bool {
        let Some((value, _)) = self.work.fraction(value) else { return false };
        left.iter().any(|e| {
            let Some((divisor, _)) = self.work.fraction(*e) else { return false };
            self.work.normalizer.ring().divide(&value, &divisor).is_some()
        })
    }

    /// Converts a case (a partly solved system) to a branch of solutions for the reader. Each value
    /// is free of the unknowns that were solved for later, and conditions that always hold are left
    /// out.
    ///
    /// `None` if a condition cannot hold, a divisor is 0, or the budget of multiplications is used
    /// up.
    fn verified_branch(&mut self, case: &Case, left: &[Expr]) -> Option<Branch> {
        let mut branch = Branch::default();
        for (at, relation) in case.relations.iter().enumerate() {
            let value = self.work.substitute_relations(&case.relations[at + 1..], relation.value)?;
            let value = self.work.short_form_in_factors(value);
            // The tangent is 0 where the sine is 0.
            let kind = if (relation.kind, value) == (RelationKind::Tangent, Expr::ZERO) {
                RelationKind::Sine
            } else {
                relation.kind
            };
            branch.solved.push(Relation { kind, value, ..*relation });
        }
        let mut needs = Vec::new();
        for need in &case.needs {
            let term = self.work.substitute_relations(&case.relations, need.term())?;
            let term = if let RelationCondition::NotNegative(_) = need {
                self.work.without_positive_factors(term)
            } else {
                term
            };
            needs.push(need.of(self.work.short_form_in_factors(term)));
        }
        branch.needs = self.work.open_conditions(&needs)?;
        for divisor in &case.divided {
            let divisor = self.work.substitute_relations(&case.relations, *divisor)?;
            let factors = self.work.factors(divisor)?;
            if factors.known.is_empty() {
                return None;
            }
            for (e, _) in factors.known.into_iter().chain(factors.unknown) {
                let e = self.work.short(e);
                if !self.work.sign(e).is_strict() && !branch.divided_by.contains(&e) {
                    branch.divided_by.push(e);
                }
            }
        }
        branch.left = left.iter().map(|e| self.factored_row(*e)).collect();
        Some(branch)
    }

    /// Removes branches of solutions that are special cases of other branches.
    pub(super) fn without_verified_special_cases(&mut self) {
        let all = std::mem::take(&mut self.found.branches);
        let mut kept = vec![true; all.len()];
        for at in 0..all.len() {
            kept[at] = !(0..all.len())
                .any(|other| other != at && kept[other] && self.is_verified_special_case(&all[at], &all[other]));
        }
        let kept = all.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(branch, _)| branch);
        self.found.branches = kept.collect();
    }

    /// True if the branch of solutions `branch` is proved to be a special case of the branch
    /// `wider`. For the proof, the solutions of `branch` are inserted into `wider`. All relations
    /// must then hold, all conditions must be met, and no divisor may become 0.
    fn is_verified_special_case(&mut self, branch: &Branch, wider: &Branch) -> bool {
        if wider.solved.len() >= branch.solved.len() {
            return false;
        }
        let residual = |work: &mut Workspace, relation: &Relation| {
            let arena = &mut *work.arena;
            let told = match relation.kind {
                RelationKind::Value => relation.unknown,
                RelationKind::Square => arena.square(relation.unknown),
                RelationKind::Sine => arena.sin(relation.angle),
                RelationKind::Cosine => arena.cos(relation.angle),
                RelationKind::Tangent => return None,
            };
            Some(arena.sub(told, relation.value))
        };
        let vanishes = |work: &mut Workspace, e: Expr| {
            work.substitute_relations(&branch.solved, e)
                .is_some_and(|e| work.comparer.is_zero(work.arena, e).is_equal())
        };
        let told: Vec<Option<Expr>> = wider.solved.iter().map(|relation| residual(self.work, relation)).collect();
        told.into_iter().all(|e| e.is_some_and(|e| vanishes(self.work, e)))
            && wider.left.iter().all(|e| branch.left.contains(e) || vanishes(self.work, *e))
            && wider.needs.iter().all(|need| {
                let Some(term) = self.work.substitute_relations(&branch.solved, need.term()) else { return false };
                self.work
                    .open_conditions(&[need.of(term)])
                    .is_some_and(|open| open.iter().all(|n| branch.needs.contains(n)))
            })
            && wider.divided_by.iter().all(|e| {
                let divisor = self.work.substitute_relations(&branch.solved, *e);
                divisor.is_some_and(|e| self.work.sign(e).is_strict())
            })
    }
}
