//! Forces as arrows along a motion: weights, reactions, and forces of the model file such as springs and
//! dampers.
//!
//! Three kinds of loads are not shown: torques, potentials that are not forces at points, and the forces of
//! closed contacts in a scene with impacts.

use super::pose::Pose;
use super::space::{Triple, length, rotate_vector};
use crate::code::{Code, CodePreparation, compile_tape_with_steps, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::shortened_for_message;
use tripos_derive::mechanics::Kinematics;
use tripos_derive::model::{ForcePlace, Reaction, ReactionKind};
use tripos_derive::scene::Scene;
use tripos_sim::Dynamics;

/// Source of a force: gravity, the model file or constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceSource {
    /// Weight of a body. It acts at the mass centre.
    Weight,
    /// Force that the model file states, or its opposite on the second body.
    Applied,
    /// Constraint force on the first of the two bodies that the constraint joins. The second body has the
    /// opposite force.
    Reaction,
}

/// Force that acts on a body during a motion, without its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForceArrow {
    /// Source of the force: gravity, the model file or a constraint.
    pub kind: ForceSource,
    /// Name of the force. A force of the model file has its own name, and a weight has the name of its body.
    /// A reaction has the names of its components if the model file gives names. Otherwise it has the names of
    /// its body and point.
    pub name: String,
    /// Index of the body on which the force acts.
    pub body: usize,
    /// Index of the point at which the force acts.
    pub point: usize,
    /// True if this is the opposite of the model file's force with the same name.
    pub is_opposite: bool,
    /// Index of the frame in which the components of the force are computed.
    frame: usize,
}

/// Forces of a mechanism along a motion, with their values.
#[derive(Clone, Debug, Default)]
pub struct ForceArrows {
    /// Forces that are not zero at every instant: weights, forces of the model file and their opposites, then
    /// reactions.
    pub list: Vec<ForceArrow>,
    /// Force vectors, N, in the inertial frame. There is one list for each instant, in the order of `list`.
    pub values: Vec<Vec<Triple>>,
    /// Names of the forces that are left out because they have no finite value at an instant.
    pub unknown: Vec<String>,
    /// Usual magnitude of the forces, N, which gives the scale of the arrows. The largest force exceeds it at
    /// one tenth of the instants. So a short peak does not make other forces invisible. If this magnitude
    /// is 0, it is the largest force of all instants.
    pub usual: f64,
    /// Reason why the reactions are missing; `None` if they are known or if there are none.
    pub without: Option<String>,
}

impl ForceArrows {
    /// Length of the longest drawn arrow divided by the length for the usual force. Longer arrows are cut.
    pub const CUT: f64 = 2.5;

    /// Force vector as it is drawn, N: unchanged, or shortened to [`Self::CUT`] times the usual force.
    #[must_use]
    pub fn drawn(&self, force: Triple) -> Triple {
        let cut = Self::CUT * self.usual / length(force);
        if cut < 1.0 { force.map(|x| cut * x) } else { force }
    }

    /// Magnitude of the largest force at any instant, N.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.values.iter().flatten().map(|force| length(*force)).fold(0.0, f64::max)
    }

    /// Copies the forces, but keeps only the instants with the indices `kept`.
    #[must_use]
    pub fn at(&self, kept: &[usize]) -> Self {
        Self { values: kept.iter().map(|at| self.values[*at].clone()).collect(), ..self.clone() }
    }
}

/// Forces of a mechanism as compiled functions of its state.
pub(super) struct ForceFunctions {
    /// Forces whose values are computed, in the order of the outputs of `tape`.
    list: Vec<ForceArrow>,
    /// Program that computes the components of all forces, N, from parameters, q, u and reactions.
    tape: Tape,
    /// Newton–Euler equations, which give the reactions. `None` if there are no reactions, or if the reactions
    /// cannot be computed.
    balance: Option<Code>,
    /// Reason why the reactions cannot be computed. `None` if they can, or if there are none.
    without: Option<String>,
}

impl ForceFunctions {
    /// Compiles the weights, the forces of the model file and the reactions of a mechanism.
    ///
    /// # Errors
    /// [`Error::Input`] if a force divides by a velocity that is zero. [`Error::Request`] if a force depends on
    /// a symbol that has no value during a run.
    pub(super) fn new(mechanism: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        let model = &mechanism.model;
        let mut kinematics = Kinematics::new(model).map_err(|error| model.diagnose(&error))?;
        let (mut list, mut values): (Vec<ForceArrow>, Vec<Expr>) = (Vec::new(), Vec::new());
        let mut put = |kind, name: &str, place: ForcePlace, frame, is_opposite, force: [Expr; 3]| {
            let ForcePlace { body, point } = place;
            list.push(ForceArrow { kind, name: name.to_owned(), body, point, is_opposite, frame });
            values.extend(force);
        };
        if let Some(gravity) = &model.gravity {
            for (body, each) in model.bodies.iter().enumerate() {
                let weight = gravity.acceleration.map(|g| kinematics.arena.mul(each.mass, g));
                let place = ForcePlace { body, point: each.centre };
                put(ForceSource::Weight, &each.name, place, gravity.frame, false, weight);
            }
        }
        for (at, force) in model.forces.iter().enumerate() {
            let vector = kinematics.forces[at].clone();
            let own = kinematics.frames.express(&mut kinematics.arena, &vector, force.frame);
            put(ForceSource::Applied, &force.name, force.on, force.frame, false, own);
            if let Some(against) = force.against {
                let opposite = own.map(|e| kinematics.arena.neg(e));
                put(ForceSource::Applied, &force.name, against, force.frame, true, opposite);
            }
        }
        let reactions = joined_reaction_forces(&model.reactions);
        let balance = (!reactions.is_empty()).then(|| force_arrow_equations(mechanism, scene)).transpose();
        let (balance, without) = match balance {
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
                put(ForceSource::Reaction, &name, place, frame, false, sum);
            }
        }
        let rates = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied());
        let steps: Vec<Definition> = rates.map(|(symbol, value)| Definition { symbol, value }).collect();
        let steps = needed_steps(&kinematics.arena, &steps, &values);
        let symbols = model.reactions.iter().map(|reaction| reaction.symbol).collect();
        let inputs = [model.p(), model.q(), model.u(), symbols].concat();
        Ok(Self {
            tape: compile_tape_with_steps(&kinematics.arena, &inputs, &steps, &values, "a force")?,
            list,
            balance,
            without,
        })
    }

    /// Computes the forces at the states of a motion. `seen` has pairs of a state and its pose. A state has the
    /// coordinates q, followed by the generalized speeds u.
    ///
    /// # Errors
    /// [`Error::Request`] if the number of parameters does not fit the equations.
    pub(super) fn forces_along_motion(
        self,
        mechanism: &Mechanism,
        scene: &Scene,
        seen: &[(&[f64], &Pose)],
    ) -> Result<ForceArrows, Error> {
        let (p, n) = (scene.parameters.as_slice(), mechanism.coordinates.len());
        let mut balance = match &self.balance {
            Some(code) => Some(Dynamics::new(code.system(), p).map_err(|error| refused_scene_error(scene, &error))?),
            None => None,
        };
        let count = mechanism.reactions.len();
        let mut at = |state: &[f64], pose: &Pose| {
            let (q, u) = state.split_at(n);
            let unknowns = balance.as_mut().and_then(|balance| balance.unknowns(q, u).ok());
            // If the Newton–Euler equations are singular, the reactions are NaN.
            let reactions = unknowns.map_or_else(|| vec![f64::NAN; count], |x| x[u.len()..].to_vec());
            let values = self.tape.evaluate(&[p, state, &reactions].concat());
            let own = values.chunks_exact(3).map(|each| [each[0], each[1], each[2]]);
            let turned = self.list.iter().zip(own).map(|(arrow, own)| rotate_vector(&pose.rotations[arrow.frame], own));
            turned.collect::<Vec<_>>()
        };
        let all: Vec<Vec<Triple>> = seen.iter().map(|(state, pose)| at(state, pose)).collect();
        let has_values = |at: usize| all.iter().all(|now| now[at].iter().all(|x| x.is_finite()));
        let acts = |at: usize| all.iter().any(|now| now[at].iter().any(|x| *x != 0.0));
        let (known, unknown): (Vec<usize>, Vec<usize>) = (0..self.list.len()).partition(|at| has_values(*at));
        let kept: Vec<usize> = known.into_iter().filter(|at| acts(*at)).collect();
        let values: Vec<Vec<Triple>> = all.iter().map(|now| kept.iter().map(|at| now[*at]).collect()).collect();
        Ok(ForceArrows {
            list: kept.iter().map(|at| self.list[*at].clone()).collect(),
            unknown: unknown.into_iter().map(|at| self.list[at].name.clone()).collect(),
            usual: usual_force(&values),
            values,
            without: self.without,
        })
    }
}

/// Magnitude, N, that the largest force exceeds at one tenth of the instants. If it is 0, the largest
/// magnitude of all instants.
fn usual_force(values: &[Vec<Triple>]) -> f64 {
    let largest = |now: &Vec<Triple>| now.iter().map(|force| length(*force)).fold(0.0, f64::max);
    let mut each: Vec<f64> = values.iter().map(largest).collect();
    each.sort_by(f64::total_cmp);
    let tenth = each.get(each.len() * 9 / 10).copied().unwrap_or_default();
    if tenth > 0.0 { tenth } else { each.last().copied().unwrap_or_default() }
}

/// Newton–Euler equations of a mechanism, which give its reactions. The error is the reason why the
/// reactions cannot be computed.
fn force_arrow_equations(mechanism: &Mechanism, scene: &Scene) -> Result<Code, String> {
    if !scene.impacts.is_empty() {
        return Err("the forces of closed contacts are not part of the equations".to_owned());
    }
    let balance = runnable_code(mechanism, &Formulation::NewtonEuler.into(), None, CodePreparation::AsDerived);
    // The whole reason, with all components that are missing, is an answer of `prove`.
    balance.map_err(|error| {
        let reason = error.to_string();
        let reason = reason.trim_start_matches("error: ");
        let reason = shortened_for_message(reason.lines().next().unwrap_or_default());
        format!(
            "the Newton–Euler equations do not determine these forces: {reason} `tripos prove` gives the whole reason"
        )
    })
}

/// Joins the components of each reaction force, which act at the same place in the same frame. Returns for
/// each force its place, the index of the frame, and its components. Reaction torques are left out.
fn joined_reaction_forces(reactions: &[Reaction]) -> Vec<(ForcePlace, usize, Vec<&Reaction>)> {
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
