//! Judgement of printed values of named quantities.

use super::constant::is_constant;
use super::finding::{Finding, Judgement};
use super::near::Near;
use super::ratio::constant_ratio;
use super::terms::wrong_terms;
use crate::diff::equations::claim::Claim;

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted::Holds;
use crate::algebra::text::print::text;
use crate::mechanics::{Kinematics, Quantities, Quantity, QuantityKind};
use crate::publication::Names;

/// Most rounds in which sums of a derived value are shortened.
const MOST_ROUNDS: usize = 4;

/// Judge of the entries of a publication, one by one.
pub struct Judge<'a, 'b> {
    /// Derived quantities with which entries are compared.
    pub quantities: &'a mut Quantities<'b>,
    /// Comparer, which decides the equality of terms and remembers normal forms.
    pub comparer: &'a mut Comparer,
    /// Values of the names that the publication gives to derived quantities.
    pub names: &'a Names,
    /// Number of printed systems before this entry.
    pub tables: usize,
    /// Point near which the formula claims to hold; `None` if the formula claims to hold everywhere.
    pub near: Option<Near>,
}

impl Judge<'_, '_> {
    /// Judges `quantity = printed`, and returns the claim of the entry.
    pub fn equation(&mut self, finding: Finding, quantity: &Quantity, printed: Expr) -> (Finding, Claim) {
        let in_rates = self.quantities.mentions_rates(printed);
        let both = self.names.resolve(self.quantities, printed).and_then(|printed| {
            let derived = self.quantities.value(quantity)?;
            // An acceleration in the formula for an acceleration stands for its derived value.
            let is_solved = matches!(quantity.kind(), QuantityKind::SpeedRate(_) | QuantityKind::SecondRate(_));
            let printed = if is_solved { self.quantities.solved(printed)? } else { printed };
            Ok((printed, derived))
        });
        let (printed, derived) = match both {
            Ok(both) => both,
            Err(why) => return (Finding { judgement: Judgement::Undecided(why), ..finding }, Claim::Other),
        };
        // The definition of a speed contains rates, in whatever variables the entry is printed.
        let in_rates = in_rates || self.quantities.mentions_rates(derived);
        let derived = if in_rates { self.quantities.before_constraints(quantity.kind(), derived) } else { derived };
        let mut rewrite = |e: Expr| if in_rates { self.quantities.in_rates(e) } else { self.quantities.in_speeds(e) };
        let (printed, derived) = (rewrite(printed), rewrite(derived));
        let derived = self.simplify(derived);
        let (finding, claim) = self.value(finding, quantity.kind(), printed, derived);
        match quantity.kind() {
            QuantityKind::Energy(energy) if energy.has_a_zero() => (self.up_to_its_zero(finding), claim),
            _ => (finding, claim),
        }
    }

    /// Judges a printed value of a quantity against the derived value; both are in the same variables.
    pub fn value(&mut self, finding: Finding, kind: &QuantityKind, printed: Expr, derived: Expr) -> (Finding, Claim) {
        if let Some(near) = &mut self.near {
            // A difference beyond the order of an approximation is not traced to other entries.
            let both =
                near.formula(self.quantities, printed).and_then(|p| Ok((p, near.formula(self.quantities, derived)?)));
            let finding = match both {
                Ok((printed, derived)) => self.compare(finding, printed, derived),
                Err(why) => Finding { judgement: Judgement::Undecided(why), ..finding },
            };
            return (finding, Claim::Other);
        }
        let finding = self.compare(finding, printed, derived);
        (finding, Claim::Value { kind: kind.clone(), printed, derived })
    }

    /// Accepts a potential energy that differs by a constant: it is the same potential with another zero.
    fn up_to_its_zero(&mut self, finding: Finding) -> Finding {
        let Some(difference) = finding.difference.filter(|_| finding.judgement == Judgement::Different) else {
            return finding;
        };
        if !is_constant(self.quantities, difference) {
            return finding;
        }
        let arena = &self.quantities.derivations.kinematics.arena;
        let remark = format!("its zero is elsewhere: printed − derived = {}, a constant", text(arena, difference));
        let remarks = finding.remarks.into_iter().chain([remark]).collect();
        Finding {
            judgement: Judgement::Equal,
            remarks,
            difference: None,
            wrong: None,
            witness: None,
            factor: None,
            ..finding
        }
    }

    /// Judges a printed against a derived value. Adds the difference and, if the values have a constant ratio, the
    /// factor.
    pub fn compare(&mut self, finding: Finding, printed: Expr, derived: Expr) -> Finding {
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let verdict = self.comparer.compare_where(arena, printed, derived);
        let is_everywhere = verdict.0.is_equal() && verdict.1 == Holds::EVERYWHERE;
        let derived = if is_everywhere { derived } else { self.shortened(derived) };
        let mut finding = finding.judged(verdict, derived);
        if finding.judgement == Judgement::Different {
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let difference = arena.sub(printed, derived);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            finding.factor = constant_ratio(self.quantities, self.comparer, printed, derived);
            if finding.factor.is_none() {
                let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
                finding.name_terms(wrong_terms(arena, simplifier, printed, difference));
            }
        }
        finding
    }

    /// Shortest form of a term that is equal in permitted states.
    fn shortened(&mut self, e: Expr) -> Expr {
        let mut short = e;
        // The shortened term may contain more sums that can be shortened.
        for _ in 0..MOST_ROUNDS {
            let arena = &mut self.quantities.derivations.kinematics.arena;
            let next = self.comparer.permitted().shortened(arena, short);
            if next == short {
                break;
            }
            short = self.simplify(next);
        }
        short
    }

    /// Simplified form of a term.
    pub fn simplify(&mut self, e: Expr) -> Expr {
        let kinematics = &mut self.quantities.derivations.kinematics;
        kinematics.simplifier.simplify(&mut kinematics.arena, e)
    }
}
