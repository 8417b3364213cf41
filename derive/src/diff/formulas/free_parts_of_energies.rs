//! Free parts of energies, on which the equations of motion do not depend.
//!
//! Free parts are a constant, and the potential of loads that the model declares as forces. In L, the time derivative
//! of a function of q and t is free, too.

use super::constant_terms::{is_constant, is_constant_in_motion};
use super::entry_judge::{EntryJudge, LONGEST, PrintedFormulaValue};
use super::finding::{Finding, Judgement};
use super::wrong_terms::terms_multiplied_out;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::diff::repairs::MistakeKind;
use crate::mechanics::{EnergyQuantity, LoadPotential};
use crate::model::Model;
use crate::publication::has_decimals;

/// Largest number of loads whose potentials are tried, in each combination, as part of a printed energy.
const MOST_LOADS: usize = 4;

/// Loads whose potential an energy may contain: their names in words, and their generalized forces at zero speeds.
type Loads = (String, Vec<Expr>);

impl EntryJudge<'_, '_> {
    /// Finding of a wrong energy that has another zero (an added constant) and one mistake. `found` is the finding that
    /// does not separate the constant. Returns `None` if the energy has no additional constant, or if separating it
    /// does not make the mistake clearer.
    pub(super) fn energy_with_free_constant(
        &mut self,
        finding: Finding,
        found: &Finding,
        printed: PrintedFormulaValue,
        derived: Expr,
    ) -> Option<Finding> {
        if found.judgement != Judgement::Different || self.near.is_some() {
            return None;
        }
        let is_told = found.change.is_some_and(|(own, _)| own != printed.value) || found.factor.is_some();
        let difference = self.quantities.derivations.kinematics.arena.sub(printed.value, derived);
        let difference = self.simplify(difference);
        let terms = terms_multiplied_out(&mut self.quantities.derivations.kinematics.arena, difference);
        let constants: Vec<Expr> = terms.into_iter().filter(|term| is_constant(self.quantities, *term)).collect();
        if constants.is_empty() {
            return None;
        }
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let zero = arena.sum(&constants);
        let shifted = arena.add(derived, zero);
        let shifted = self.simplify(shifted);
        let mut found = self.judge_against_derived(finding, printed, shifted);
        if is_told && found.slip.is_none_or(|slip| slip > MistakeKind::Function) {
            return None;
        }
        let zero = print_text(&self.quantities.derivations.kinematics.arena, zero);
        found.remarks.push(format!("the derived value is shown plus {zero}, so that its zero is the printed one"));
        found.change.is_some_and(|(own, _)| own != printed.value).then_some(found)
    }

    /// Accepts a printed energy that differs from the derived energy only in parts without effect on the equations of
    /// motion. Such parts are a constant, the potential of loads that the model declares as forces, and, in L, the time
    /// derivative of a function of q and t. Otherwise returns the finding unchanged. `printed` is the value of the
    /// printed energy.
    pub(super) fn up_to_free_parts(&mut self, finding: Finding, energy: EnergyQuantity, printed: Expr) -> Finding {
        let finding = self.accept_free_energy_constant(finding, printed);
        let Some(difference) = finding.difference.filter(|_| finding.judgement == Judgement::Different) else {
            return finding;
        };
        if energy == EnergyQuantity::Lagrangian && self.is_time_derivative_in_lagrangian(difference, &[]) {
            let words = print_text(&self.quantities.derivations.kinematics.arena, difference);
            let shown = if words.len() <= LONGEST { format!(" = {words}") } else { String::new() };
            let remark = format!("printed − derived{shown} is the time derivative of a function of q and t");
            return finding.accept_with_remark("up to a time derivative", remark);
        }
        // The energy of gravity contains the potential of no other load.
        let loads = if energy == EnergyQuantity::Gravity { Vec::new() } else { self.loads_left_out_of_energy() };
        let found = loads.into_iter().find(|(_, forces)| match energy {
            EnergyQuantity::Lagrangian => {
                self.is_time_derivative_in_lagrangian(difference, forces)
                    || self.is_free_potential_of_forces(difference, forces, Expr::ONE)
            }
            _ => self.is_free_potential_of_forces(difference, forces, Expr::MINUS_ONE),
        });
        let Some((load, _)) = found else { return finding };
        let remark = format!("it contains the potential of {load}, which the model states as a load");
        finding.accept_with_remark("with the potential of a load", remark)
    }

    /// Accepts a printed energy that differs from the derived energy only by a constant, that is, by its zero.
    fn accept_free_energy_constant(&mut self, finding: Finding, printed: Expr) -> Finding {
        let Some(difference) = finding.difference.filter(|_| finding.judgement == Judgement::Different) else {
            return finding;
        };
        // The difference is tested in three forms: as it is, in permitted states, and with printed numbers for
        // parameters.
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let permitted = self.comparer.permitted().write_in_free_symbols(arena, difference);
        let parameters = &self.quantities.model.parameters;
        let has_none = parameters.iter().all(|p| p.is_input || !arena.mentions(printed, p.symbol));
        let is_in_numbers = has_none && has_decimals(&finding.printed);
        let in_numbers = is_in_numbers.then(|| Substitution::new(self.numbers).apply(arena, permitted));
        let forms = [Some(difference), Some(permitted), in_numbers].into_iter().flatten();
        let Some(difference) = forms.into_iter().find(|e| is_constant(self.quantities, *e)) else {
            if !is_constant_in_motion(self.quantities, self.comparer, difference) {
                return finding;
            }
            let remark = "the zero of the quantity is elsewhere: printed − derived keeps its value in every motion";
            return finding.accept_with_remark("up to a constant", remark.to_owned());
        };
        let difference = self.simplify(difference);
        let arena = &self.quantities.derivations.kinematics.arena;
        let remark = format!(
            "the zero of the quantity is elsewhere: printed − derived = {}, a constant",
            print_text(arena, difference)
        );
        finding.accept_with_remark("up to a constant", remark)
    }

    /// Loads that the derived energy leaves out, with their generalized forces: first all together, then each
    /// combination of loads.
    fn loads_left_out_of_energy(&mut self) -> Vec<Loads> {
        let model = self.quantities.model;
        let kinematics = &mut self.quantities.derivations.kinematics;
        let names: Vec<&String> =
            model.forces.iter().map(|f| &f.name).chain(model.torques.iter().map(|t| &t.name)).collect();
        let LoadPotential { rest, outside, .. } = kinematics.load_potential(model);
        let forces = kinematics.generalized_forces_of_each_load(model);
        let arena = &mut kinematics.arena;
        let mut list: Vec<Loads> = Vec::new();
        list.extend(forces_at_rest(arena, model, &rest).map(|forces| ("all loads".to_owned(), forces)));
        let named =
            outside.into_iter().filter_map(|at| Some((*names.get(at)?, forces_at_rest(arena, model, &forces[at])?)));
        let named: Vec<(&String, Vec<Expr>)> = named.take(MOST_LOADS).collect();
        for chosen in 1..(1_usize << named.len()) {
            let some = named.iter().enumerate().filter(|(at, _)| chosen >> at & 1 == 1).map(|(_, load)| load);
            let words: Vec<String> = some.clone().map(|(name, _)| format!("`{name}`")).collect();
            let sum = |at: usize| some.clone().map(|(_, force)| force[at]).collect::<Vec<Expr>>();
            list.push((words.join(" and "), (0..model.coordinates.len()).map(|at| arena.sum(&sum(at))).collect()));
        }
        // A function of time has no slopes, and is the potential of no force.
        list.retain(|(_, load)| load.iter().any(|force| *force != Expr::ZERO));
        list
    }

    /// True if the given forces do work equal to −`sign` times the change of `term`, in every motion that the
    /// constraints permit.
    fn is_free_potential_of_forces(&mut self, term: Expr, forces: &[Expr], sign: Expr) -> bool {
        let model = self.quantities.model;
        let term = self.quantities.in_speeds(term);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        // Kinetic energies in different rates are equal in permitted states.
        let depends = |speed: Expr| {
            let slope = Differential::partial(speed).apply(arena, term);
            !self.comparer.compare(arena, slope, Expr::ZERO).is_equal()
        };
        if model.u().into_iter().any(depends) {
            return false;
        }
        let mut resting = Substitution::new(&model.u().into_iter().map(|u| (u, Expr::ZERO)).collect::<Vec<_>>());
        let term = resting.apply(arena, term);
        let rests = coordinates_without_time(model).map(|at| {
            let slope = Differential::partial(model.coordinates[at].symbol).apply(arena, term);
            let slope = arena.mul(sign, slope);
            (at, arena.sub(slope, forces[at]))
        });
        let rests: Vec<(usize, Expr)> = rests.collect();
        model.u().into_iter().all(|speed| {
            let terms = rests.iter().map(|(at, rest)| {
                let motion = Differential::partial(speed).apply(arena, model.kinematic_equations.rates[*at]);
                arena.mul(*rest, motion)
            });
            let terms: Vec<Expr> = terms.collect();
            let power = arena.sum(&terms);
            self.comparer.compare(arena, power, Expr::ZERO).is_equal()
        })
    }

    /// True if the part `term` of L adds exactly the given forces to Lagrange's equations. If there are no forces,
    /// `term` must be the time derivative of a function of q and t.
    fn is_time_derivative_in_lagrangian(&mut self, term: Expr, forces: &[Expr]) -> bool {
        let model = self.quantities.model;
        let term = self.quantities.in_rates(term);
        let mut along: Vec<(Expr, Expr)> = Vec::new();
        for (at, c) in model.coordinates.iter().enumerate() {
            if model.time() == Some(at) {
                along.push((c.symbol, Expr::ONE));
            } else {
                along.extend([(c.symbol, c.rate), (c.rate, c.second_rate)]);
            }
        }
        let mut d_dt = Differential::along(&along);
        let arena = &mut self.quantities.derivations.kinematics.arena;
        coordinates_without_time(model).all(|at| {
            let c = &model.coordinates[at];
            let momentum = Differential::partial(c.rate).apply(arena, term);
            let slope = Differential::partial(c.symbol).apply(arena, term);
            let rate = d_dt.apply(arena, momentum);
            let force = forces.get(at).copied().unwrap_or(Expr::ZERO);
            let expected = arena.sub(slope, force);
            self.comparer.compare(arena, rate, expected).is_equal()
        })
    }
}

/// Indices of the generalized coordinates, without time.
fn coordinates_without_time(model: &Model) -> impl Iterator<Item = usize> + '_ {
    (0..model.coordinates.len()).filter(|at| model.time() != Some(*at))
}

/// Forces at zero rates q̇, at which dampers have no force. `None` if a force has no value there.
fn forces_at_rest(arena: &mut Arena, model: &Model, forces: &[Expr]) -> Option<Vec<Expr>> {
    let mut at_rest = Substitution::new(&model.q_dot().into_iter().map(|rate| (rate, Expr::ZERO)).collect::<Vec<_>>());
    let resting = forces.iter().map(|force| at_rest.apply(arena, *force)).collect();
    at_rest.undefined.is_none().then_some(resting)
}
