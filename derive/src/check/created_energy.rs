//! Check of loads that can create energy. Such a load adds energy to a mechanism, beyond the energy
//! stored in a potential.
//!
//! A load consists of a part at rest (q̇ = 0), which has a potential or not, and a rest with the
//! power P(q, u). If P ≤ 0 is proved, the load dissipates. If P > 0 in a state, computed in
//! intervals rounded outwards, the load can create energy. It also can if the work of its part at
//! rest depends on the path. Otherwise its effect is undecided.
//!
//! P ≤ 0 is proved by the ranges of the terms of P. For a quadratic form −uᵀ D u it is proved by
//! the pivots of D: A. J. van der Schaft, *L2-Gain and Passivity Techniques in Nonlinear Control*,
//! 3rd edition (2017), § 2.2.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::value::interval::enclose_in_interval;
use crate::algebra::value::range::range_excludes_positive;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::{DeriveError, Kinematics, potential_at_rest, rates_to_speeds};
use crate::model::{Model, MotionConstraintKind};
use rustc_hash::FxHashMap;
use std::fmt::Write;

/// Effect of a load on the energy of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnergyEffect {
    /// The load conserves energy: it has a potential, or its power is zero.
    Keeps,
    /// The load is proved never to add energy: its power is never positive.
    Dissipates,
    /// The load can add energy to the mechanism.
    Creates,
    /// It is neither proved that the load adds energy in a state, nor that it never adds energy.
    Undecided,
}

/// A load and its effect on the energy, at the default values of the parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadEffect {
    /// Name of the load in the model file.
    pub load: String,
    /// Effect of the load on the energy.
    pub effect: EnergyEffect,
    /// Reason for the effect, in words; empty if the effect needs no reason.
    pub why: String,
}

/// Number of random states (q, u) that are tried to find a positive power.
const STATES: usize = 60;

/// Finds the effect of each applied load on the energy, in the order of the model file, forces
/// before torques. Error if the kinematics cannot be derived.
pub fn energy_effects_of_loads(model: &Model) -> Result<Vec<LoadEffect>, DeriveError> {
    let names: Vec<String> =
        model.forces.iter().map(|f| &f.name).chain(model.torques.iter().map(|t| &t.name)).cloned().collect();
    if names.is_empty() {
        return Ok(Vec::new());
    }
    let mut kinematics = Kinematics::new(model)?;
    let forces = kinematics.generalized_forces_of_each_load(model);
    let mut judge = CreatedEnergyJudge::new(model, kinematics.arena);
    let forces: Vec<Vec<Expr>> = forces.into_iter().map(|list| judge.at_defaults(&list)).collect();
    let all: Vec<Expr> = (0..model.coordinates.len())
        .map(|at| {
            let parts: Vec<Expr> = forces.iter().map(|list| list[at]).collect();
            judge.arena.sum(&parts)
        })
        .collect();
    // Even if single loads have no potential or do not dissipate, all loads together may.
    let have_potential = judge.has_potential(&all);
    let dissipate = judge.power(&all).is_some_and(|power| judge.is_power_never_positive(power));
    let motion = if dissipate { PowerOfAllLoads::Dissipate } else { PowerOfAllLoads::Unproved };
    let mut list = Vec::new();
    for (at, (load, forces)) in names.into_iter().zip(&forces).enumerate() {
        let force = model.forces.get(at);
        let is_spring = force.is_some_and(|f| f.energy.is_some());
        let (effect, why) = match input_that_creates_energy(model, at) {
            Some(input) => (EnergyEffect::Creates, format!("the input `{input}` drives it")),
            None if force.and_then(|f| f.damper).is_some_and(|damper| judge.is_damper(forces, damper)) => {
                (EnergyEffect::Dissipates, String::new())
            }
            None => {
                let rest = if have_potential || is_spring { PartAtRest::Conservative } else { PartAtRest::Unproved };
                judge.effect(forces, rest, motion)
            }
        };
        list.push(LoadEffect { load, effect, why });
    }
    Ok(list)
}

/// Name of an input that the load with this index contains; `None` if it contains no input. The
/// index counts all forces, then all torques.
fn input_that_creates_energy(model: &Model, at: usize) -> Option<String> {
    let vector = match model.forces.get(at) {
        Some(force) => force.vector,
        None => model.torques[at - model.forces.len()].vector,
    };
    let reached = model.arena.reachable(&vector);
    model.parameters.iter().find(|p| p.is_input && reached.contains(&p.symbol)).map(|p| p.name.clone())
}

/// Finding on the part of a load at rest: its generalized forces at q̇ = 0.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PartAtRest {
    /// The part at rest has a potential, alone or together with all other loads.
    Conservative,
    /// No potential of the part at rest was found yet.
    Unproved,
}

/// Finding on the power of all loads together, without their parts at rest.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PowerOfAllLoads {
    /// All loads together dissipate: their power is never positive.
    Dissipate,
    /// All loads together are not proved to dissipate.
    Unproved,
}

/// Judge of the effect of loads on the energy. It uses generalized forces at the default values of
/// the parameters.
struct CreatedEnergyJudge<'m> {
    /// Model whose loads are judged.
    model: &'m Model,
    /// Arena of the terms.
    arena: Arena,
    /// Simplifier of the computed terms.
    simplifier: Simplifier,
    /// Substitution of the default values for the parameters.
    defaults: Substitution,
}

impl<'m> CreatedEnergyJudge<'m> {
    fn new(model: &'m Model, mut arena: Arena) -> Self {
        let values = model.parameters.iter().filter_map(|p| Some((p.symbol, p.value.clone()?)));
        let values: Vec<(Expr, Expr)> = values.map(|(symbol, value)| (symbol, arena.number(value))).collect();
        Self { model, arena, simplifier: Simplifier::default(), defaults: Substitution::new(&values) }
    }

    /// Replaces parameters in terms by their default values, and simplifies the terms.
    fn at_defaults(&mut self, list: &[Expr]) -> Vec<Expr> {
        let put = |e: &Expr| {
            let value = self.defaults.apply(&mut self.arena, *e);
            self.simplifier.simplify(&mut self.arena, value)
        };
        list.iter().map(put).collect()
    }

    /// Generalized forces at rest, q̇ = 0; `None` if they have no value there.
    fn at_rest(&mut self, forces: &[Expr]) -> Option<Vec<Expr>> {
        let still: Vec<_> = self.model.q_dot().into_iter().map(|rate| (rate, Expr::ZERO)).collect();
        let mut put = Substitution::new(&still);
        let resting = forces.iter().map(|force| put.apply(&mut self.arena, *force)).collect();
        put.undefined.is_none().then_some(resting)
    }

    /// True if a potential of the generalized forces at rest was found.
    fn has_potential(&mut self, forces: &[Expr]) -> bool {
        potential_at_rest(&mut self.arena, &mut self.simplifier, self.model, forces).is_some()
    }

    /// Power of generalized forces without their part at rest, as a term in q and u, W. `None` if
    /// the forces have no value at rest.
    fn power(&mut self, forces: &[Expr]) -> Option<Expr> {
        let resting = self.at_rest(forces)?;
        let arena = &mut self.arena;
        let mut terms = Vec::new();
        for ((force, resting), rate) in forces.iter().zip(resting).zip(self.model.q_dot()) {
            let moving = arena.sub(*force, resting);
            terms.push(arena.mul(moving, rate));
        }
        let power = arena.sum(&terms);
        let power = rates_to_speeds(self.model).apply(arena, power);
        // Rates of a model with constraints contain parameters, which are replaced by their default
        // values.
        let power = self.defaults.apply(arena, power);
        Some(self.simplifier.simplify(arena, power))
    }

    /// True if the generalized forces of a spring are proved to be a potential force and a damping
    /// force. The power of the damping force is −c ḋ² with c > 0. The arguments are the forces, the
    /// coefficient c, and the rate ḋ of lengthening.
    fn is_damper(&mut self, forces: &[Expr], [coefficient, lengthening]: [Expr; 2]) -> bool {
        let coefficient = self.defaults.apply(&mut self.arena, coefficient);
        let taken = self.arena.neg(coefficient);
        if coefficient == Expr::ZERO || !range_excludes_positive(&self.arena, taken) {
            return false;
        }
        let Some(power) = self.power(forces) else { return false };
        let rate = rates_to_speeds(self.model).apply(&mut self.arena, lengthening);
        let rate = self.defaults.apply(&mut self.arena, rate);
        let product = self.arena.product(&[coefficient, rate, rate]);
        let rest = self.arena.add(power, product);
        zero_test(&self.arena, rest) == ZeroTest::Zero
    }

    /// Effect of a load on the energy, with the reason in words. `forces` are its generalized
    /// forces. `rest` is the finding on its part at rest, `together` the finding on all loads.
    fn effect(&mut self, forces: &[Expr], rest: PartAtRest, together: PowerOfAllLoads) -> (EnergyEffect, String) {
        let Some(power) = self.power(forces) else {
            return (EnergyEffect::Undecided, "it has no value at rest".to_owned());
        };
        let moving = self.effect_in_motion(power, together);
        if moving.0 == EnergyEffect::Creates || rest == PartAtRest::Conservative || self.has_potential(forces) {
            return moving;
        }
        if self.does_work_depend_on_path(forces) {
            (EnergyEffect::Creates, "its work depends on the way".to_owned())
        } else {
            (EnergyEffect::Undecided, "it has no potential that was found, or one that jumps in time".to_owned())
        }
    }

    /// Effect of a load on the energy, with the reason in words. `power` is its power without the
    /// part at rest; `together` is the finding on all loads.
    fn effect_in_motion(&mut self, power: Expr, together: PowerOfAllLoads) -> (EnergyEffect, String) {
        if zero_test(&self.arena, power) == ZeroTest::Zero {
            return (EnergyEffect::Keeps, String::new());
        }
        if self.is_power_never_positive(power) {
            return (EnergyEffect::Dissipates, String::new());
        }
        if together == PowerOfAllLoads::Dissipate {
            return (EnergyEffect::Dissipates, "together with the other loads".to_owned());
        }
        match self.state_with_positive_power(power) {
            Ok(Some(state)) => (EnergyEffect::Creates, state),
            Ok(None) => (
                EnergyEffect::Undecided,
                "no state was found in which it adds energy, and no proof that there is none".to_owned(),
            ),
            Err(reason) => (EnergyEffect::Undecided, reason),
        }
    }

    /// True if the work of the generalized forces at rest is proved to depend on the path, since
    /// ∂F_i/∂q_j ≠ ∂F_j/∂q_i. False if this is not proved, or if constraints or loops restrict the
    /// paths.
    fn does_work_depend_on_path(&mut self, forces: &[Expr]) -> bool {
        let is_free = self.model.motion_constraints.iter().all(|c| c.kind == MotionConstraintKind::Clock)
            && self.model.loops.is_empty();
        let Some(resting) = self.at_rest(forces).filter(|_| is_free) else { return false };
        let n = resting.len();
        let mut gradient = Gradient::new(&self.model.q());
        let mut slopes = vec![vec![Expr::ZERO; n]; n];
        for (row, force) in slopes.iter_mut().zip(&resting) {
            for &(at, slope) in gradient.apply(&mut self.arena, *force).iter() {
                row[at] = slope;
            }
        }
        (0..n).any(|i| {
            (0..i).any(|j| {
                let curl = self.arena.sub(slopes[i][j], slopes[j][i]);
                zero_test(&self.arena, curl) == ZeroTest::NonZero
            })
        })
    }

    /// True if a power is proved never to be positive in any state.
    fn is_power_never_positive(&mut self, power: Expr) -> bool {
        if range_excludes_positive(&self.arena, power) {
            return true;
        }
        let u = self.model.u();
        let mut gradient = Gradient::new(&u);
        let mut form = vec![vec![Expr::ZERO; u.len()]; u.len()];
        let first = gradient.apply(&mut self.arena, power);
        for &(i, slope) in first.iter() {
            for &(j, second) in gradient.apply(&mut self.arena, slope).iter() {
                form[i][j] = self.simplifier.simplify(&mut self.arena, second);
            }
        }
        self.is_form(power, &form, &u) && self.is_negative(form)
    }

    /// True if a power is proved to be ½ uᵀ H u for the p × p matrix H = `form`, whose entries contain
    /// no generalized speed.
    fn is_form(&mut self, power: Expr, form: &[Vec<Expr>], u: &[Expr]) -> bool {
        if self.arena.reachable(&form.concat()).iter().any(|part| u.contains(part)) {
            return false;
        }
        let half = Rational::fraction(-1, 2).expect("not zero");
        let mut terms = vec![(power, Rational::ONE)];
        for (row, a) in form.iter().zip(u) {
            for (entry, b) in row.iter().zip(u) {
                terms.push((self.arena.product(&[*entry, *a, *b]), half.clone()));
            }
        }
        let rest = self.arena.linear_combination(&terms);
        zero_test(&self.arena, rest) == ZeroTest::Zero
    }

    /// True if a symmetric matrix is proved to be negative semidefinite by its pivots. Each pivot
    /// must never be above zero, and a pivot that is identically zero must have a row of zeros.
    /// Where a pivot is zero in single states only, the property holds by continuity.
    fn is_negative(&mut self, mut form: Vec<Vec<Expr>>) -> bool {
        let is_zero = |arena: &Arena, e: Expr| zero_test(arena, e) == ZeroTest::Zero;
        while let Some(row) = form.pop() {
            let Some((pivot, row)) = row.split_last().map(|(pivot, row)| (*pivot, row.to_vec())) else { return true };
            for other in &mut form {
                other.pop();
            }
            if is_zero(&self.arena, pivot) {
                if !row.iter().all(|e| is_zero(&self.arena, *e)) {
                    return false;
                }
                continue;
            }
            if !range_excludes_positive(&self.arena, pivot) {
                return false;
            }
            for i in 0..row.len() {
                for j in 0..row.len() {
                    let product = self.arena.mul(row[i], row[j]);
                    let Some(share) = self.arena.div(product, pivot) else { return false };
                    let left = self.arena.sub(form[i][j], share);
                    form[i][j] = self.simplifier.simplify(&mut self.arena, left);
                }
            }
        }
        true
    }

    /// Searches for a state with positive power and describes the state in words. `None` if no such
    /// state is found. The error is the reason in words why no state can be tested.
    fn state_with_positive_power(&mut self, power: Expr) -> Result<Option<String>, String> {
        let model = self.model;
        let without = model.parameters.iter().find(|p| p.value.is_none() && self.arena.mentions(power, p.symbol));
        if let Some(parameter) = without {
            return Err(format!("`{}` has no default value", parameter.name));
        }
        let is_tied = !model.loops.is_empty();
        let closed = model.branch.as_ref().map(|branch| branch.pose.clone());
        let pose = match (is_tied, closed) {
            (true, None) => return Err("no closed pose was found to ask in".to_owned()),
            (true, Some(pose)) => pose,
            (false, _) => vec![0.0; model.coordinates.len()],
        };
        // Simple states are tried first, since they are easy to read.
        let mut states: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
        for at in 0..model.speeds.len() {
            for sign in [1.0, -1.0] {
                let mut u = vec![0.0; model.speeds.len()];
                u[at] = sign;
                states.push((pose.clone(), u));
            }
        }
        let mut chance = 1_u32;
        for _ in 0..STATES {
            // Random multiples of 1/8 from −2 to 2, which print exactly (Lehmer's generator).
            let mut draw = || {
                chance = u32::try_from(u64::from(chance) * 48_271 % 2_147_483_647).unwrap_or(1);
                (f64::from(chance % 33) - 16.0) / 8.0
            };
            let q = if is_tied { pose.clone() } else { pose.iter().map(|_| draw()).collect() };
            let u = model.speeds.iter().map(|_| draw()).collect();
            states.push((q, u));
        }
        let gives = |(q, u): &&(Vec<f64>, Vec<f64>)| {
            let values =
                model.q().into_iter().zip(q.iter().copied()).chain(model.u().into_iter().zip(u.iter().copied()));
            let at: FxHashMap<Expr, f64> = values.collect();
            enclose_in_interval(&self.arena, power, &at)
                .is_some_and(crate::algebra::value::interval::PointInterval::is_positive)
        };
        Ok(states.iter().find(gives).map(|(q, u)| created_energy_sentence(model, q, u)))
    }
}

/// Sentence which says that a load adds energy in the state (q, u). It names the coordinates and
/// speeds that are not zero.
fn created_energy_sentence(model: &Model, q: &[f64], u: &[f64]) -> String {
    let coordinates = model.coordinates.iter().map(|c| &c.name).zip(q);
    let named = coordinates.chain(model.speeds.iter().map(|s| &s.name).zip(u)).filter(|(_, value)| **value != 0.0);
    let mut text = String::from("it adds energy at");
    for (at, (name, value)) in named.enumerate() {
        let _ = write!(text, "{} {name} = {value}", if at == 0 { "" } else { "," });
    }
    text
}
