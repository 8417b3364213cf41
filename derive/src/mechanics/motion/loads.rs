//! Loads on the bodies, and the velocities of the points and bodies on which they act.
//!
//! The power of a force uses the velocity v_C + ω × p_CP of the body's material at the point P of the force. The
//! velocity of P itself differs if P moves in the body, as a contact point does.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §§ 2.7, 2.8 (points fixed on a body, and
//! moving on it), 4.4 (generalized active forces).

use super::kinematics::{Kinematics, Velocities, rates_to_speeds, speeds_to_rates};
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::text::print::print_text;
use crate::algebra::value::zero_test::{ZeroTest, zero_divisor, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Dots, Vector};
use crate::mechanics::derive_error::DeriveError;
use crate::model::{Body, ForcePlace, Model, NamedVelocity, Potential, ReactionKind};

/// Force or torque with the velocity on which it does work. Its generalized force is F_r =
/// ∂velocity/∂u_r · scale load.
pub struct Load {
    /// Velocity of the body's material at the point of a force (m/s), or angular velocity of the body on which a
    /// torque acts (rad/s).
    pub velocity: Vector,
    /// Factor of `load`: the mass of the body for a weight, otherwise 1. It is kept separate so that equal products
    /// of vectors are recognized.
    pub scale: Expr,
    /// Force (N) or torque (N m). For a weight, the acceleration of free fall (m/s²).
    pub load: Vector,
}

/// Force or reaction whose point of action moves relative to the body on which it acts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MovingLoadPlace {
    /// Kind and name of the force or reaction, such as `force drag`.
    pub load: String,
    /// Body and point at which the force or reaction acts.
    pub place: ForcePlace,
}

impl MovingLoadPlace {
    /// Sentence for the user about the moving point. It names the load, the point, the body, and the velocity that
    /// gives the power.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        let (load, body) = (&self.load, &model.bodies[self.place.body].name);
        let point = &model.points[self.place.point].name;
        format!(
            "The {load} acts on the material of {body} that is at {point}: {point} moves in {body}, so that power is taken \
             with v({body}, {point}), not with v({point})."
        )
    }
}

/// Forces and reactions of a model whose points move in their bodies, in the order of the model file.
///
/// # Errors
/// Returns a [`DeriveError`], for the same reasons as [`Kinematics::new`].
pub fn moving_load_places(model: &Model) -> Result<Vec<MovingLoadPlace>, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let mut list = Vec::new();
    for (load, place) in places_of_loads(model) {
        if kinematics.moves_in_body(model, place) {
            list.push(MovingLoadPlace { load, place });
        }
    }
    Ok(list)
}

/// All forces, reaction forces and their opposites, each as (kind and name, body and point on which it acts).
fn places_of_loads(model: &Model) -> Vec<(String, ForcePlace)> {
    let mut list = Vec::new();
    for force in &model.forces {
        list.push((format!("force {}", force.name), force.on));
        list.extend(force.against.map(|place| (format!("opposite of force {}", force.name), place)));
    }
    for reaction in &model.reactions {
        if let ReactionKind::Force { on, against } = reaction.kind {
            list.push((format!("reaction {}", reaction.name), on));
            list.extend(against.map(|place| (format!("opposite of reaction {}", reaction.name), place)));
        }
    }
    list
}

impl Kinematics {
    /// Velocity v_P = v_C + ω × p_CP of the body's material at a point P, relative to the inertial frame, m/s. For a
    /// particle it is v_C.
    pub fn load_place_velocity(&mut self, model: &Model, velocities: &Velocities, place: ForcePlace) -> Vector {
        let body = &model.bodies[place.body];
        let centre = velocities.linear[body.centre].clone();
        let Some((frame, _)) = &body.rigid else { return centre };
        let arm = self.load_arm(body, place.point);
        let turning = self.frames.cross(&mut self.arena, &velocities.angular[*frame], &arm);
        centre.add(&mut self.arena, &turning)
    }

    /// Vector p_CP from the mass centre C of a body to a point P, m.
    pub fn load_arm(&mut self, body: &Body, point: usize) -> Vector {
        let back = self.positions[body.centre].neg(&mut self.arena);
        self.positions[point].add(&mut self.arena, &back)
    }

    /// True if the point of `place` moves in its body, so that its velocity differs from that of the body's material
    /// there.
    fn moves_in_body(&mut self, model: &Model, place: ForcePlace) -> bool {
        let velocities = self.in_rates.clone();
        let material = self.load_place_velocity(model, &velocities, place);
        let back = velocities.linear[place.point].neg(&mut self.arena);
        let Self { arena, frames, .. } = self;
        let slip = material.add(arena, &back);
        frames.express(arena, &slip, 0).iter().any(|e| zero_test(arena, *e) == ZeroTest::NonZero)
    }

    /// Weights of all bodies as loads; empty without gravity.
    pub fn weight_loads(&mut self, model: &Model, velocities: &Velocities) -> Vec<Load> {
        let Some(gravity) = &model.gravity else { return Vec::new() };
        let weight = |centre: usize, mass: Expr| Load {
            velocity: velocities.linear[centre].clone(),
            scale: mass,
            load: Vector::in_frame(gravity.frame, gravity.acceleration),
        };
        model.bodies.iter().map(|body| weight(body.centre, body.mass)).collect()
    }

    /// Applied loads other than weights. There is an inner list for each force and torque of the model (with its
    /// opposite), and for each stated potential.
    pub fn loads(&mut self, model: &Model, velocities: &Velocities) -> Vec<Vec<Load>> {
        let mut groups = Vec::new();
        for (at, force) in model.forces.iter().enumerate() {
            let vector = self.forces[at].clone();
            let mut loads = vec![(self.load_place_velocity(model, velocities, force.on), vector.clone())];
            if let Some(place) = force.against {
                let back = vector.neg(&mut self.arena);
                loads.push((self.load_place_velocity(model, velocities, place), back));
            }
            groups.push(loads);
        }
        for (at, torque) in model.torques.iter().enumerate() {
            let vector = self.torques[at].clone();
            let mut loads = vec![(velocities.angular[torque.on.0].clone(), vector.clone())];
            if let Some((frame, _)) = torque.against {
                loads.push((velocities.angular[frame].clone(), vector.neg(&mut self.arena)));
            }
            groups.push(loads);
        }
        for potential in &model.potentials {
            groups.push(self.loads_of_potential(model, velocities, potential));
        }
        let load = |(velocity, load)| Load { velocity, scale: Expr::ONE, load };
        groups.into_iter().map(|loads| loads.into_iter().map(load).collect()).collect()
    }

    /// Loads of a potential energy V: the generalized force −∂V/∂q of each coordinate, paired with the velocity q̇. The
    /// force of time leaves out the explicit part of ∂V/∂t. Both are written along axis 0 of the inertial frame.
    fn loads_of_potential(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        potential: &Potential,
    ) -> Vec<(Vector, Vector)> {
        let time = model.time();
        let slopes = Gradient::new(&model.q()).apply(&mut self.arena, potential.energy);
        let along = |e: Expr| Vector::in_frame(0, [e, Expr::ZERO, Expr::ZERO]);
        let mut loads = Vec::new();
        for (at, slope) in slopes.iter() {
            let explicit = if Some(*at) == time { potential.explicit_rate } else { Expr::ZERO };
            let force = self.arena.sub(explicit, *slope);
            let force = self.simplifier.simplify(&mut self.arena, force);
            if force != Expr::ZERO {
                loads.push((along(velocities.rates[*at]), along(force)));
            }
        }
        loads
    }

    /// Sets `forces` and `torques` to the applied loads of the model. Velocities that a load names are replaced by
    /// terms.
    ///
    /// # Errors
    /// Returns [`DeriveError::LoadDividesByZero`] if a load divides by a velocity that is zero at all times.
    pub(in crate::mechanics) fn apply_loads(&mut self, model: &Model) -> Result<(), DeriveError> {
        let values: Vec<_> =
            model.velocities.iter().map(|v| (v.symbol, self.velocity_named_by_load(model, v))).collect();
        let mut put = Substitution::new(&values);
        let arena = &mut self.arena;
        for force in &model.forces {
            let vector = substitute_load_velocities(arena, &mut put, &force.name, force.vector)?;
            self.forces.push(Vector::in_frame(force.frame, vector));
        }
        for torque in &model.torques {
            let vector = substitute_load_velocities(arena, &mut put, &torque.name, torque.vector)?;
            self.torques.push(Vector::in_frame(torque.frame, vector));
        }
        Ok(())
    }

    /// Generalized forces of loads, one for each of the motion variables `variables`, not simplified. `put` replaces
    /// velocities that occur in a load by terms in the motion variables.
    fn generalized_forces<'a>(
        &mut self,
        loads: impl IntoIterator<Item = &'a Load>,
        put: &mut Substitution,
        variables: &[Expr],
    ) -> Vec<Expr> {
        if self.frames.carries {
            return self.forces_of_load_pairs(loads, put, variables);
        }
        let mut gradient = Gradient::new(variables);
        let mut forces: Vec<Dots> = variables.iter().map(|_| Dots::default()).collect();
        for Load { velocity, scale, load } in loads {
            let load = load.substitute(&mut self.arena, put);
            for (i, partial) in velocity.partial_derivatives(&mut self.arena, &mut gradient) {
                forces[i].add(*scale, &partial, &load);
            }
        }
        forces.iter().map(|dots| dots.sum(&mut self.arena, &mut self.frames)).collect()
    }

    /// Component of a velocity or position that a load names, as a term in q and q̇. It is the literal 0 if it is
    /// identically zero.
    fn velocity_named_by_load(&mut self, model: &Model, name: &NamedVelocity) -> Expr {
        let velocities = self.in_rates.clone();
        let velocity = match name.of {
            VelocityOf::Material(body, point) => {
                self.load_place_velocity(model, &velocities, ForcePlace { body, point })
            }
            VelocityOf::Point(point) => velocities.linear[point].clone(),
            VelocityOf::Place(point) => self.positions[point].clone(),
            VelocityOf::Turning(frame) => velocities.angular[frame].clone(),
        };
        let Self { arena, frames, simplifier, .. } = self;
        let component = frames.component(arena, &velocity, name.frame, name.axis);
        let component = simplifier.simplify(arena, component);
        if zero_test(arena, component) == ZeroTest::Zero { Expr::ZERO } else { component }
    }
}

/// Generalized forces Q_i = Σ (∂v_P/∂q̇_i)·R_P + Σ (∂ω_B/∂q̇_i)·T_B of the given loads, one for each coordinate. They
/// are terms in q and q̇, not simplified.
pub(in crate::mechanics) fn generalized_forces_of_loads<'a>(
    model: &Model,
    kinematics: &mut Kinematics,
    loads: impl IntoIterator<Item = &'a Load>,
) -> Vec<Expr> {
    kinematics.generalized_forces(loads, &mut speeds_to_rates(model), &model.q_dot())
}

/// Generalized active forces F_r = Σ (∂v_P/∂u_r)·R_P + Σ (∂ω_B/∂u_r)·T_B of all loads and weights, one for each
/// speed. They are terms in q and u, not simplified. Entry r has the unit of power divided by that of u_r. Reactions
/// do not contribute.
pub(in crate::mechanics) fn active_forces_of_loads(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let mut loads = kinematics.weight_loads(model, velocities);
    loads.extend(kinematics.loads(model, velocities).into_iter().flatten());
    kinematics.generalized_forces(&loads, &mut rates_to_speeds(model), &model.u())
}

/// Replaces named velocities in the components of a load. `put` maps each named velocity to its value.
///
/// # Errors
/// Returns `DeriveError::LoadDividesByZero` if the result divides by a term that is identically zero.
fn substitute_load_velocities(
    arena: &mut Arena,
    put: &mut Substitution,
    load: &str,
    stated: [Expr; 3],
) -> Result<[Expr; 3], DeriveError> {
    let components = stated.map(|e| put.apply(arena, e));
    let mut changed = stated.iter().zip(&components).filter(|(before, after)| before != after);
    let hidden = changed.find_map(|(_, e)| zero_divisor(arena, *e));
    match put.undefined.or(hidden) {
        Some(term) => Err(DeriveError::LoadDividesByZero { load: load.to_owned(), term: print_text(arena, term) }),
        None => Ok(components),
    }
}
