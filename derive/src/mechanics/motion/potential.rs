//! Potential energy of a model, and the power of the forces without a potential.
//!
//! Each applied load is taken at its value at rest (q̇ = 0). If its generalized forces at rest are −∂U/∂q, then U is
//! its potential energy. The remaining part of a load works only in motion, like a damper, or never, like a magnetic
//! field.
//!
//! H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition (2002), §§ 1.4, 1.5, 2.7; T. R. Kane & D. A.
//! Levinson, *Dynamics: Theory and Applications* (1985), § 5.1.

use super::kinematics::{Kinematics, LoadPotential, MotionVariables, rates_to_speeds};
use super::loads::{Load, generalized_forces_of_loads};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::antiderivative::antiderivative;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};
use crate::geometry::name_transported_components;
use crate::geometry::{Dots, Vector};
use crate::mechanics::derive_error::DeriveError;
use crate::model::Model;

impl Kinematics {
    /// Potential energy V = V_gravity + U as a term in q, J. U is the potential of all applied loads for which the
    /// rules of [`antiderivative`] find one. U is zero at the model's `zero_at` if it has a value there. Otherwise
    /// its constant follows from the rules.
    ///
    /// # Errors
    /// Returns [`DeriveError::NoZeroOfPotential`] if V_gravity has no value at `zero_at`.
    pub fn potential_energy(&mut self, model: &Model) -> Result<Expr, DeriveError> {
        let gravity = self.gravity_potential(model)?;
        let of_loads = self.load_potential(model).energy;
        let sum = self.arena.add(gravity, of_loads);
        Ok(self.simplifier.simplify(&mut self.arena, sum))
    }

    /// Potential energy V = −Σ m g·p of gravity alone, J. It is zero at the configuration `zero_at` of the model.
    ///
    /// # Errors
    /// Returns [`DeriveError::NoZeroOfPotential`] if V has no value at `zero_at`.
    pub fn gravity_potential(&mut self, model: &Model) -> Result<Expr, DeriveError> {
        let Some(gravity) = &model.gravity else { return Ok(Expr::ZERO) };
        let g = Vector::in_frame(gravity.frame, gravity.acceleration);
        if self.frames.carries {
            return self.gravity_potential_by_first_moments(model, &g);
        }
        let mut work = Dots::default();
        for body in &model.bodies {
            work.add(body.mass, &g, &self.positions[body.centre]);
        }
        let work = work.sum(&mut self.arena, &mut self.frames);
        let energy = self.arena.neg(work);
        self.energy_with_stated_zero(model, energy)
    }

    /// Potential energy −g · Σ m p of gravity, J. The first moments m p are added before they are expressed in the
    /// frame of g.
    ///
    /// # Errors
    /// Returns `DeriveError::NoZeroOfPotential` if the energy has no value at the model's `zero_at`.
    fn gravity_potential_by_first_moments(&mut self, model: &Model, g: &Vector) -> Result<Expr, DeriveError> {
        let mut moment = Vector::default();
        for body in &model.bodies {
            let own = self.positions[body.centre].scale(&mut self.arena, body.mass);
            moment = moment.add(&mut self.arena, &own);
        }
        let mut named = moment.clone();
        for (frame, components) in &mut named.parts {
            let what = format!("mp_{}", self.frames.name(*frame).to_owned());
            *components = name_transported_components(&mut self.arena, *components, &what);
        }
        let work = self.frames.dot(&mut self.arena, g, &named);
        let energy = self.arena.neg(work);
        self.energy_with_stated_zero(model, energy)
    }

    /// Shifts a potential energy by a constant so that it is zero at the model's configuration `zero_at`.
    ///
    /// # Errors
    /// Returns `DeriveError::NoZeroOfPotential` if the energy has no value at `zero_at`.
    fn energy_with_stated_zero(&mut self, model: &Model, energy: Expr) -> Result<Expr, DeriveError> {
        let Some(gravity) = &model.gravity else { return Ok(energy) };
        if gravity.zero_at.is_empty() {
            return Ok(self.simplifier.simplify(&mut self.arena, energy));
        }
        let mut to_zero = zero_energy_configuration(model);
        let at_zero = to_zero.apply(&mut self.arena, energy);
        if let Some(term) = to_zero.undefined {
            return Err(DeriveError::NoZeroOfPotential {
                term: crate::algebra::text::print::print_text(&self.arena, term),
            });
        }
        let difference = self.arena.sub(energy, at_zero);
        Ok(self.simplifier.simplify(&mut self.arena, difference))
    }

    /// Potential of the applied loads. It is that of all loads together or, if they have none together, of each load
    /// that has its own.
    pub fn load_potential(&mut self, model: &Model) -> LoadPotential {
        if let Some(known) = &self.potential {
            return known.clone();
        }
        let velocities = self.in_rates.clone();
        let groups = self.loads(model, &velocities);
        let found = self.search_load_potential(model, &groups);
        self.potential = Some(found.clone());
        found
    }

    /// Generalized forces of each applied load, as terms in q and q̇. There is an inner list for each load (forces,
    /// then torques, then potentials), with an entry for each coordinate.
    pub fn generalized_forces_of_each_load(&mut self, model: &Model) -> Vec<Vec<Expr>> {
        let velocities = self.in_rates.clone();
        let groups = self.loads(model, &velocities);
        groups.iter().map(|group| generalized_forces_of_loads(model, self, group)).collect()
    }

    /// Power d(T + V)/dt of the forces without a potential in V, W, as a term in q and the given motion variables. It
    /// is the literal 0 if it is identically zero.
    pub(in crate::mechanics) fn power_without_potential(&mut self, model: &Model, variables: MotionVariables) -> Expr {
        let rest = self.load_potential(model).rest;
        let arena = &mut self.arena;
        let terms: Vec<Expr> = rest.iter().zip(model.q_dot()).map(|(force, rate)| arena.mul(*force, rate)).collect();
        let power = arena.sum(&terms);
        if zero_test(arena, power) == ZeroTest::Zero {
            return Expr::ZERO;
        }
        let power = match variables {
            MotionVariables::Rates => power,
            MotionVariables::Speeds => rates_to_speeds(model).apply(arena, power),
        };
        self.simplifier.simplify(arena, power)
    }

    /// Searches for the potential of the given applied loads. Known potentials, as of springs, come first; then
    /// forces are integrated.
    fn search_load_potential(&mut self, model: &Model, groups: &[Vec<Load>]) -> LoadPotential {
        let all = generalized_forces_of_loads(model, self, groups.iter().flatten());
        let all: Vec<Expr> = all.into_iter().map(|e| self.simplifier.simplify(&mut self.arena, e)).collect();
        // The model holds the potentials of springs and the stated potentials.
        let of_forces = model.forces.iter().map(|f| f.energy);
        let of_torques = model.torques.iter().map(|_| None);
        let stated = of_forces.chain(of_torques).chain(model.potentials.iter().map(|p| Some(p.energy)));
        let known: Vec<Option<Expr>> = stated
            .map(|energy| energy.filter(|energy| !potential_jumps_in_time(&self.arena, model, *energy)))
            .collect();
        let driven = loads_with_inputs(model);
        let is_sought = |at: &usize| known[*at].is_none() && !driven[*at];
        let mut outside: Vec<usize> = (0..known.len()).filter(|at| known[*at].is_none() && driven[*at]).collect();
        let indices: Vec<usize> = (0..groups.len()).filter(is_sought).collect();
        let groups: Vec<&Vec<Load>> = indices.iter().map(|at| &groups[*at]).collect();
        let sought = if groups.len() == known.len() {
            all.clone()
        } else {
            let sought = generalized_forces_of_loads(model, self, groups.iter().copied().flatten());
            sought.into_iter().map(|e| self.simplifier.simplify(&mut self.arena, e)).collect()
        };
        let mut found: Vec<Expr> = known.into_iter().flatten().collect();
        found.extend(match potential_at_rest(&mut self.arena, &mut self.simplifier, model, &sought) {
            Some(energy) => vec![energy],
            None if groups.len() > 1 => {
                let mut one = |(group, at): (&&Vec<Load>, usize)| {
                    let forces = generalized_forces_of_loads(model, self, group.iter());
                    let energy = potential_at_rest(&mut self.arena, &mut self.simplifier, model, &forces);
                    if energy.is_none() {
                        outside.push(at);
                    }
                    energy
                };
                groups.iter().zip(indices).filter_map(&mut one).collect()
            }
            None => {
                outside.extend(indices);
                Vec::new()
            }
        });
        let energy = self.arena.sum(&found);
        let energy = self.potential_with_zero_if_possible(model, energy);
        let mut rest = all;
        for (i, slope) in Gradient::new(&model.q()).apply(&mut self.arena, energy).iter() {
            let sum = self.arena.add(rest[*i], *slope);
            rest[*i] = self.simplifier.simplify(&mut self.arena, sum);
        }
        for force in &mut rest {
            if zero_test(&self.arena, *force) == ZeroTest::Zero {
                *force = Expr::ZERO;
            }
        }
        LoadPotential { energy, rest, outside }
    }

    /// Simplifies a potential energy and shifts it so that it is zero at the model's `zero_at`, if it has a value
    /// there.
    fn potential_with_zero_if_possible(&mut self, model: &Model, energy: Expr) -> Expr {
        let Self { arena, simplifier, .. } = self;
        let at_zero = model.gravity.as_ref().filter(|gravity| !gravity.zero_at.is_empty()).and_then(|_| {
            let mut to_zero = zero_energy_configuration(model);
            let value = to_zero.apply(arena, energy);
            to_zero.undefined.is_none().then_some(value)
        });
        let energy = at_zero.map_or(energy, |value| arena.sub(energy, value));
        simplifier.simplify(arena, energy)
    }
}

/// Substitution that puts the coordinates at the configuration where the model's potential energy
/// is zero.
fn zero_energy_configuration(model: &Model) -> Substitution {
    let mut values: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, Expr::ZERO)).collect();
    for (symbol, value) in model.gravity.iter().flat_map(|gravity| &gravity.zero_at) {
        values.retain(|(s, _)| s != symbol);
        values.push((*symbol, *value));
    }
    Substitution::new(&values)
}

/// For each applied load, in the order of [`Kinematics::loads`]: true if it contains an input. Work that inputs do is
/// not stored as energy in the mechanism.
fn loads_with_inputs(model: &Model) -> Vec<bool> {
    let inputs: Vec<Expr> = model.parameters.iter().filter(|p| p.is_input).map(|p| p.symbol).collect();
    let vectors = model.forces.iter().map(|f| f.vector).chain(model.torques.iter().map(|t| t.vector));
    let names_one = |vector: [Expr; 3]| model.arena.reachable(&vector).iter().any(|part| inputs.contains(part));
    vectors.map(names_one).chain(model.potentials.iter().map(|_| false)).collect()
}

/// Potential energy U, J, for which −∂U/∂q are the given generalized forces at rest (q̇ = 0). `None` if there is no
/// such U, if no rule finds it, or if it jumps in time.
pub fn potential_at_rest(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    model: &Model,
    forces: &[Expr],
) -> Option<Expr> {
    let mut at_rest = Substitution::new(&model.q_dot().iter().map(|rate| (*rate, Expr::ZERO)).collect::<Vec<_>>());
    let slopes: Vec<Expr> = forces
        .iter()
        .map(|force| {
            let resting = at_rest.apply(arena, *force);
            arena.neg(resting)
        })
        .collect();
    // A load that divides by a speed, as dry friction does, has no value at rest.
    if at_rest.undefined.is_some() {
        return None;
    }
    // A potential that jumps would add energy in an instant, which no power shows. So the work of such a load is
    // counted instead.
    antiderivative(arena, simplifier, &model.q(), &slopes)
        .filter(|energy| !potential_jumps_in_time(arena, model, *energy))
}

/// True if a term jumps in time: it contains the sign of a function of time alone, also in the form
/// `abs(t - 1)/(t - 1)`.
fn potential_jumps_in_time(arena: &Arena, model: &Model, e: Expr) -> bool {
    let Some(time) = model.time() else { return false };
    let (clock, others): (Vec<_>, Vec<_>) = model.q().into_iter().enumerate().partition(|(at, _)| *at == time);
    let names = |e: Expr, of: &[(usize, Expr)]| of.iter().any(|(_, symbol)| arena.mentions(e, *symbol));
    let is_of_time = |e: Expr| names(e, &clock) && !names(e, &others);
    let bends = |e: Expr| matches!(arena.node(e), Node::Apply(Function::Abs, argument) if is_of_time(*argument));
    let mut parts = arena.reachable(&[e]).into_iter();
    parts.any(|part| match arena.node(part) {
        Node::Apply(Function::Sign, argument) => is_of_time(*argument),
        Node::Product(factors) => {
            factors.iter().any(|(base, _)| bends(*base)) && factors.iter().any(|(base, n)| *n < 0 && is_of_time(*base))
        }
        _ => false,
    })
}
