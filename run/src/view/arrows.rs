//! Forces as arrows: weights, the forces of the model file, springs and dampers among them, and what constraints exert, along a motion.
//!
//! Absent on purpose: torques, potentials that are no forces at points, and what holds a closed contact of a scene with impacts.

use super::pose::Pose;
use super::space::{Triple, length, rotated};
use crate::code::{Code, Ready, code, stepwise};
use crate::error::{Error, refused};
use crate::mechanism::Mechanism;
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::algebra::steps::{Definition, needed};
use tripos_derive::mechanics::Kinematics;
use tripos_derive::model::{Place, Reaction, ReactionKind};
use tripos_derive::scene::Scene;
use tripos_sim::Dynamics;

/// What a force comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowKind {
    /// Gravity, at the mass centre of a body.
    Weight,
    /// A force of the model file, or its opposite.
    Applied,
    /// What constraints exert on the first of the bodies that they hold; on the other it is the opposite.
    Reaction,
}

/// A force on a body, without its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arrow {
    /// What it comes from.
    pub kind: ArrowKind,
    /// The name of the force in the file; of the body for a weight; of those of its components that the file names for a reaction, else where it acts.
    pub name: String,
    /// The body that it acts on.
    pub body: usize,
    /// The point that it acts at.
    pub point: usize,
    /// Whether it is the opposite of the named force.
    pub is_opposite: bool,
    /// The frame of its components.
    frame: usize,
}

/// The forces along a motion.
#[derive(Clone, Debug, Default)]
pub struct Forces {
    /// What they are, in order: weights by bodies, each force of the file and its opposite, reactions; those that are zero all the time left out.
    pub list: Vec<Arrow>,
    /// Their values at each instant, N, in the inertial frame, in the order of the list.
    pub values: Vec<Vec<Triple>>,
    /// The names of those that are left out since they have no value at some instant.
    pub unknown: Vec<String>,
    /// What the largest of an instant exceeds at a tenth of the instants, N: a spike makes no others invisible. The largest of all where that is 0.
    pub usual: f64,
    /// Why the motion has reactions of which none is told, if so.
    pub without: Option<String>,
}

impl Forces {
    /// How many times the usual force the longest arrow is of: longer ones are cut.
    pub const CUT: f64 = 2.5;

    /// A force as it is drawn, N: of its own length, or cut.
    #[must_use]
    pub fn drawn(&self, force: Triple) -> Triple {
        let cut = Self::CUT * self.usual / length(force);
        if cut < 1.0 { force.map(|x| cut * x) } else { force }
    }

    /// The largest, N.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.values.iter().flatten().map(|force| length(*force)).fold(0.0, f64::max)
    }

    /// Forces at some of the instants alone.
    #[must_use]
    pub fn at(&self, kept: &[usize]) -> Self {
        Self { values: kept.iter().map(|at| self.values[*at].clone()).collect(), ..self.clone() }
    }
}

/// What gives the forces of a mechanism at the states of a scene.
pub(super) struct Arrows {
    list: Vec<Arrow>,
    /// From parameters, q, u and reactions.
    tape: Tape,
    /// The force balance, if there are reactions.
    balance: Option<Code>,
    without: Option<String>,
}

impl Arrows {
    /// The weights, declared forces and reactions of a mechanism.
    ///
    /// # Errors
    /// [`Error::Input`] if a force divides by a velocity that is zero; [`Error::Request`] if one depends on what has no value during a
    /// run.
    pub(super) fn new(mechanism: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        let model = &mechanism.model;
        let mut kinematics = Kinematics::new(model).map_err(|error| model.diagnose(&error))?;
        let (mut list, mut values): (Vec<Arrow>, Vec<Expr>) = (Vec::new(), Vec::new());
        let mut put = |kind, name: &str, place: Place, frame, is_opposite, force: [Expr; 3]| {
            let Place { body, point } = place;
            list.push(Arrow { kind, name: name.to_owned(), body, point, is_opposite, frame });
            values.extend(force);
        };
        if let Some(gravity) = &model.gravity {
            for (body, each) in model.bodies.iter().enumerate() {
                let weight = gravity.acceleration.map(|g| kinematics.arena.mul(each.mass, g));
                let place = Place { body, point: each.centre };
                put(ArrowKind::Weight, &each.name, place, gravity.frame, false, weight);
            }
        }
        for (at, force) in model.forces.iter().enumerate() {
            let vector = kinematics.forces[at].clone();
            let own = kinematics.frames.express(&mut kinematics.arena, &vector, force.frame);
            put(ArrowKind::Applied, &force.name, force.on, force.frame, false, own);
            if let Some(against) = force.against {
                let opposite = own.map(|e| kinematics.arena.neg(e));
                put(ArrowKind::Applied, &force.name, against, force.frame, true, opposite);
            }
        }
        let reactions = joined(&model.reactions);
        let (balance, without) = match balance(mechanism, scene, !reactions.is_empty()) {
            Ok(balance) => (balance, None),
            Err(why) => (None, Some(why)),
        };
        if balance.is_some() {
            for (place, frame, parts) in reactions {
                let mut sum = [Expr::ZERO; 3];
                for part in &parts {
                    for (sum, direction) in sum.iter_mut().zip(part.direction) {
                        let along = kinematics.arena.mul(part.symbol, direction);
                        *sum = kinematics.arena.add(*sum, along);
                    }
                }
                let names = parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>();
                let name = if parts.iter().all(|part| part.is_stated) {
                    names.join(", ")
                } else {
                    format!("force on {} at {}", model.bodies[place.body].name, model.points[place.point].name)
                };
                put(ArrowKind::Reaction, &name, place, frame, false, sum);
            }
        }
        let rates = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied());
        let steps: Vec<Definition> = rates.map(|(symbol, value)| Definition { symbol, value }).collect();
        let steps = needed(&kinematics.arena, &steps, &values);
        let symbols = model.reactions.iter().map(|reaction| reaction.symbol).collect();
        let inputs = [model.p(), model.q(), model.u(), symbols].concat();
        Ok(Self { tape: stepwise(&kinematics.arena, &inputs, &steps, &values, "a force")?, list, balance, without })
    }

    /// The forces at states, each coordinates and generalized speeds, of which these are the poses.
    ///
    /// # Errors
    /// [`Error::Request`] if the parameters are not those of the equations.
    pub(super) fn along(self, mechanism: &Mechanism, scene: &Scene, seen: &[(&[f64], &Pose)]) -> Result<Forces, Error> {
        let (p, n) = (scene.parameters.as_slice(), mechanism.coordinates.len());
        let mut balance = match &self.balance {
            Some(code) => Some(Dynamics::new(code.system(), p).map_err(|error| refused(scene, &error))?),
            None => None,
        };
        let count = mechanism.reactions.len();
        let mut at = |state: &[f64], pose: &Pose| {
            let (q, u) = state.split_at(n);
            let unknowns = balance.as_mut().and_then(|balance| balance.unknowns(q, u).ok());
            // Where the balance is singular there are no reactions.
            let reactions = unknowns.map_or_else(|| vec![f64::NAN; count], |x| x[u.len()..].to_vec());
            let values = self.tape.evaluate(&[p, state, &reactions].concat());
            let own = values.chunks_exact(3).map(|each| [each[0], each[1], each[2]]);
            let turned = self.list.iter().zip(own).map(|(arrow, own)| rotated(&pose.rotations[arrow.frame], own));
            turned.collect::<Vec<_>>()
        };
        let all: Vec<Vec<Triple>> = seen.iter().map(|(state, pose)| at(state, pose)).collect();
        let has_values = |at: usize| all.iter().all(|now| now[at].iter().all(|x| x.is_finite()));
        let acts = |at: usize| all.iter().any(|now| now[at].iter().any(|x| *x != 0.0));
        let (known, unknown): (Vec<usize>, Vec<usize>) = (0..self.list.len()).partition(|at| has_values(*at));
        let kept: Vec<usize> = known.into_iter().filter(|at| acts(*at)).collect();
        let values: Vec<Vec<Triple>> = all.iter().map(|now| kept.iter().map(|at| now[*at]).collect()).collect();
        Ok(Forces {
            list: kept.iter().map(|at| self.list[*at].clone()).collect(),
            unknown: unknown.into_iter().map(|at| self.list[at].name.clone()).collect(),
            usual: usual(&values),
            values,
            without: self.without,
        })
    }
}

/// What the largest of an instant exceeds at a tenth of the instants; the largest of all where that is 0.
fn usual(values: &[Vec<Triple>]) -> f64 {
    let largest = |now: &Vec<Triple>| now.iter().map(|force| length(*force)).fold(0.0, f64::max);
    let mut each: Vec<f64> = values.iter().map(largest).collect();
    each.sort_by(f64::total_cmp);
    let tenth = each.get(each.len() * 9 / 10).copied().unwrap_or_default();
    if tenth > 0.0 { tenth } else { each.last().copied().unwrap_or_default() }
}

/// The force balance, if a motion has reactions; in words, why none is to be had.
fn balance(mechanism: &Mechanism, scene: &Scene, has_reactions: bool) -> Result<Option<Code>, String> {
    if !has_reactions {
        return Ok(None);
    }
    if !scene.impacts.is_empty() {
        return Err("what holds a closed contact is not among them".to_owned());
    }
    let balance = code(mechanism, &Formulation::NewtonEuler.into(), None, Ready::AsDerived);
    balance.map(Some).map_err(|error| format!("Newton and Euler's equations do not determine them: {error}"))
}

/// Forces that act at one place and on one other, in one frame, together.
fn joined(reactions: &[Reaction]) -> Vec<(Place, usize, Vec<&Reaction>)> {
    let mut list: Vec<(ReactionKind, usize, Vec<&Reaction>)> = Vec::new();
    for reaction in reactions {
        match list.iter_mut().find(|(kind, frame, _)| (*kind, *frame) == (reaction.kind, reaction.frame)) {
            Some((_, _, parts)) => parts.push(reaction),
            None => list.push((reaction.kind, reaction.frame, vec![reaction])),
        }
    }
    let forces = list.into_iter().filter_map(|(kind, frame, parts)| match kind {
        ReactionKind::Force { on, .. } => Some((on, frame, parts)),
        ReactionKind::Torque { .. } => None,
    });
    forces.collect()
}
