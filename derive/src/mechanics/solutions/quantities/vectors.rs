//! Vectors among the quantities: positions, velocities, accelerations, momenta and loads. Each vector is computed
//! once.

use super::Quantities;
use crate::geometry::{Components, Vector};
use crate::mechanics::formulations::newton_euler;
use crate::mechanics::motion::kinematics::Kinematics;
use crate::mechanics::quantity::VectorName;
use crate::model::Body;

impl Quantities<'_> {
    /// Simplified components along `frame` of a vector, which belongs to the point, frame or body with the index
    /// `of`. They are computed at the first call.
    pub(super) fn component(&mut self, name: VectorName, of: usize, frame: usize) -> Components {
        if let Some(done) = self.components.get(&(name, of, frame)) {
            return *done;
        }
        let vector = self.vector(name, of);
        let Kinematics { arena, frames, simplifier, .. } = &mut self.derivations.kinematics;
        let components = frames.express(arena, &vector, frame).map(|e| simplifier.simplify(arena, e));
        self.components.insert((name, of, frame), components);
        components
    }

    /// Vector that belongs to the point, frame or body with the index `of`. It is computed at the first call, perhaps
    /// from vectors of earlier variants of [`VectorName`].
    pub(super) fn vector(&mut self, name: VectorName, of: usize) -> Vector {
        if let Some(done) = self.vectors.get(&(name, of)) {
            return done.clone();
        }
        let bodies = &self.model.bodies;
        let vector = match name {
            VectorName::Position => self.derivations.kinematics.positions[of].clone(),
            VectorName::Velocity => self.velocities.linear[of].clone(),
            VectorName::Acceleration => self.time_derivative(VectorName::Velocity, of),
            VectorName::AngularVelocity => self.velocities.angular[of].clone(),
            VectorName::AngularAcceleration => self.time_derivative(VectorName::AngularVelocity, of),
            VectorName::AngularMomentum => self.derivations.kinematics.angular_momentum(&bodies[of], &self.velocities),
            VectorName::MomentumRate => self.time_derivative(VectorName::AngularMomentum, of),
            VectorName::LinearMomentumRate => {
                let a = self.vector(VectorName::Acceleration, bodies[of].centre);
                a.scale(&mut self.derivations.kinematics.arena, bodies[of].mass)
            }
            VectorName::InertiaForce => {
                self.vector(VectorName::LinearMomentumRate, of).neg(&mut self.derivations.kinematics.arena)
            }
            VectorName::InertiaTorque => {
                self.vector(VectorName::MomentumRate, of).neg(&mut self.derivations.kinematics.arena)
            }
            VectorName::Weight => self.weight(&bodies[of]),
            VectorName::Force => self.force(of),
            VectorName::Moment => self.moment(of),
        };
        self.vectors.insert((name, of), vector.clone());
        vector
    }

    /// Time derivative, in the inertial frame, of a vector that belongs to the point, frame or body with the index
    /// `of`.
    fn time_derivative(&mut self, name: VectorName, of: usize) -> Vector {
        let vector = self.vector(name, of);
        let Kinematics { arena, frames, .. } = &mut self.derivations.kinematics;
        frames.time_derivative(arena, &vector, &self.velocities.angular, &mut self.d_dt)
    }

    /// Weight m g of a body, N; zero without gravity.
    fn weight(&mut self, body: &Body) -> Vector {
        let Some(gravity) = &self.model.gravity else { return Vector::default() };
        let arena = &mut self.derivations.kinematics.arena;
        Vector::in_frame(gravity.frame, gravity.acceleration).scale(arena, body.mass)
    }

    /// Sum of all forces on a body, N: its weight, the applied forces and the reactions that the model file states.
    fn force(&mut self, body: usize) -> Vector {
        let mut total = self.vector(VectorName::Weight, body);
        let kinematics = &mut self.derivations.kinematics;
        for (_, force) in newton_euler::newton_euler_forces(self.model, kinematics, self.model.stated_reactions(), body)
        {
            total = total.add(&mut kinematics.arena, &force);
        }
        total
    }

    /// Moment Σ p_CP × F + Σ T on a body about its mass centre C, N m. It is that of the applied loads and of the
    /// reactions that the model file states. The weight has no moment about C.
    fn moment(&mut self, body: usize) -> Vector {
        let kinematics = &mut self.derivations.kinematics;
        let mut total = Vector::default();
        for (point, force) in
            newton_euler::newton_euler_forces(self.model, kinematics, self.model.stated_reactions(), body)
        {
            let arm = kinematics.load_arm(&self.model.bodies[body], point);
            let turning = kinematics.frames.cross(&mut kinematics.arena, &arm, &force);
            total = total.add(&mut kinematics.arena, &turning);
        }
        for torque in newton_euler::newton_euler_torques(self.model, kinematics, self.model.stated_reactions(), body) {
            total = total.add(&mut kinematics.arena, &torque);
        }
        total
    }
}
