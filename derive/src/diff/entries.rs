//! Printed values of named quantities.

use super::finding::{Finding, Judgement};
use super::terms::wrong_terms;

use crate::algebra::Expr;
use crate::algebra::calculus::{Differential, Substitution};
use crate::algebra::compare::Comparer;
use crate::algebra::modular::{ZeroTest, zero_test};
use crate::algebra::print::text;
use crate::mechanics::{Kinematics, Quantities, Quantity, QuantityKind};
use crate::report::Names;

/// Judges entries one by one.
pub struct Judge<'a, 'b> {
    /// What is derived.
    pub quantities: &'a mut Quantities<'b>,
    /// Remembers normal forms.
    pub comparer: &'a mut Comparer,
    /// What symbols of the text stand for.
    pub names: &'a Names,
}

impl Judge<'_, '_> {
    /// Judges `quantity = printed`.
    pub fn equation(&mut self, finding: Finding, quantity: &Quantity, printed: Expr) -> Finding {
        let in_rates = self.quantities.mentions_rates(printed);
        let both = self.names.resolve(self.quantities, printed).and_then(|printed| {
            let derived = self.quantities.value(quantity)?;
            // An acceleration that an acceleration is stated by means what is derived.
            let is_solved = matches!(quantity.kind(), QuantityKind::SpeedRate(_) | QuantityKind::SecondRate(_));
            let printed = if is_solved { self.quantities.solved(printed)? } else { printed };
            Ok((printed, derived))
        });
        let (printed, derived) = match both {
            Ok(both) => both,
            Err(why) => return Finding { judgement: Judgement::Undecided(why), ..finding },
        };
        // A speed is defined by rates, whatever the entry writes.
        let in_rates = in_rates || self.quantities.mentions_rates(derived);
        let mut rewrite = |e: Expr| if in_rates { self.quantities.in_rates(e) } else { self.quantities.in_speeds(e) };
        let (printed, derived) = (rewrite(printed), rewrite(derived));
        let derived = self.simplify(derived);
        let finding = self.compare(finding, printed, derived);
        match quantity.kind() {
            QuantityKind::Energy(energy) if energy.has_a_zero() => self.up_to_its_zero(finding),
            _ => finding,
        }
    }

    /// A potential energy that differs by a constant is the same potential with another zero.
    fn up_to_its_zero(&mut self, finding: Finding) -> Finding {
        let Some(difference) = finding.difference.filter(|_| finding.judgement == Judgement::Different) else {
            return finding;
        };
        let model = self.quantities.model;
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let variables = [model.q(), model.u(), model.q_dot()].concat();
        let constant = variables.into_iter().all(|symbol| {
            let slope = Differential::partial(symbol).apply(arena, difference);
            zero_test(arena, slope) == ZeroTest::Zero
        });
        if !constant {
            return finding;
        }
        let remark = format!("its zero is elsewhere: printed − derived = {}, a constant", text(arena, difference));
        let remarks = finding.remarks.into_iter().chain([remark]).collect();
        Finding { judgement: Judgement::Equal, remarks, difference: None, witness: None, factor: None, ..finding }
    }

    /// Judges one value against another, with the difference and, where it holds, the factor.
    pub fn compare(&mut self, finding: Finding, printed: Expr, derived: Expr) -> Finding {
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let verdict = self.comparer.compare(arena, printed, derived);
        let mut finding = finding.judged(verdict, derived);
        if finding.judgement == Judgement::Different {
            let difference = arena.sub(printed, derived);
            let difference = self.simplify(difference);
            finding.difference = Some(difference);
            finding.factor = self.constant_ratio(printed, derived);
            if finding.factor.is_none() {
                let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
                finding.remarks.extend(wrong_terms(arena, simplifier, printed, difference));
            }
        }
        finding
    }

    /// printed / derived, if it depends on parameters only.
    fn constant_ratio(&mut self, printed: Expr, derived: Expr) -> Option<Expr> {
        let model = self.quantities.model;
        let arena = &mut self.quantities.derivations.kinematics.arena;
        if zero_test(arena, printed) != ZeroTest::NonZero || zero_test(arena, derived) != ZeroTest::NonZero {
            return None;
        }
        let ratio = arena.div(printed, derived)?;
        let parameters = model.p();
        let symbols: Vec<Expr> = arena
            .reachable(&[ratio])
            .into_iter()
            .filter(|e| arena.symbol_name(*e).is_some() && !parameters.contains(e))
            .collect();
        for symbol in &symbols {
            let slope = Differential::partial(*symbol).apply(arena, ratio);
            if zero_test(arena, slope) != ZeroTest::Zero {
                return None;
            }
        }
        // It does not depend on them, so any value may stand for them.
        let mut at_one = Substitution::new(&symbols.iter().map(|s| (*s, Expr::ONE)).collect::<Vec<_>>());
        let value = at_one.apply(arena, ratio);
        let value = self.simplify(value);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let back = arena.mul(value, derived);
        self.comparer.compare(arena, printed, back).is_equal().then_some(value)
    }

    /// The shortest form of a term.
    pub fn simplify(&mut self, e: Expr) -> Expr {
        let kinematics = &mut self.quantities.derivations.kinematics;
        kinematics.simplifier.simplify(&mut kinematics.arena, e)
    }
}
