//! Sums over bodies, computed with printed values: generalized forces, the mass matrix, and energies.

use super::ValueConsequences;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::{Expr, Rational};
use crate::diff::roots::derived_values::{
    derived_value, derived_value_components, derived_value_with_changes, derived_values_arena, dot,
};
use crate::geometry::Components;
use crate::mechanics::{EnergyQuantity, Quantities, QuantityKind, RowQuantity, VectorName};

/// Load on a body, with the velocity that is multiplied by the load in the power.
struct LoadPower {
    /// Kind of the velocity: that of the mass centre, or the angular velocity.
    velocity: VectorName,
    /// Index of the point or frame whose velocity is meant.
    of: usize,
    /// Kind of the load: a force or a torque.
    load: VectorName,
    /// Index of the body on which the load acts.
    body: usize,
}

impl ValueConsequences {
    /// Index of the frame in which sums over bodies are computed. It is the frame of the first printed component, else
    /// the inertial frame.
    fn frame_of_sums(&self) -> usize {
        let frame = self.put.iter().find_map(|value| match value.kind {
            QuantityKind::Component { frame, .. }
            | QuantityKind::Partial { frame, .. }
            | QuantityKind::Inertia { frame, .. } => Some(frame),
            _ => None,
        });
        frame.unwrap_or(0)
    }

    /// Generalized inertia force F*_r = Σ ∂v_C/∂u_r·R* + ∂ω/∂u_r·T*, with printed values; r is the index `speed`.
    /// Derived terms are used for bodies that depend on no printed value. Returns `None` if no body depends on a
    /// printed value.
    pub(super) fn inertia_force(&mut self, quantities: &mut Quantities<'_>, speed: usize) -> Option<Expr> {
        let mut changes = Vec::new();
        for (at, body) in quantities.model.bodies.iter().enumerate() {
            let (velocity, load) = (VectorName::Velocity, VectorName::InertiaForce);
            let power = LoadPower { velocity, of: body.centre, load, body: at };
            changes.extend(self.power_change(quantities, &power, speed));
            if let Some((frame, _)) = &body.rigid {
                let (velocity, load) = (VectorName::AngularVelocity, VectorName::InertiaTorque);
                let power = LoadPower { velocity, of: *frame, load, body: at };
                changes.extend(self.power_change(quantities, &power, speed));
            }
        }
        derived_value_with_changes(quantities, &QuantityKind::Row(RowQuantity::InertiaForce, speed), &changes)
    }

    /// Change of the term ∂v/∂u_r · load when printed values replace derived values. `None` if both factors depend on
    /// no printed value.
    fn power_change(&mut self, quantities: &mut Quantities<'_>, power: &LoadPower, speed: usize) -> Option<Expr> {
        let &LoadPower { velocity, of, load, body } = power;
        let frame = self.frame_of_sums();
        let partial = self.partial_velocity(quantities, velocity, of, frame, speed);
        let force = self.vector(quantities, load, body, frame);
        if partial.is_none() && force.is_none() {
            return None;
        }
        let kind = |axis| QuantityKind::Partial { vector: velocity, of, frame, axis, speed };
        let right_partial = [
            derived_value(quantities, &kind(0))?,
            derived_value(quantities, &kind(1))?,
            derived_value(quantities, &kind(2))?,
        ];
        let right_force = derived_value_components(quantities, load, body, frame)?;
        let arena = derived_values_arena(quantities);
        let value = dot(arena, &partial.unwrap_or(right_partial), &force.unwrap_or(right_force));
        let right = dot(arena, &right_partial, &right_force);
        Some(arena.sub(value, right))
    }

    /// Generalized active force F_r = Σ ∂v_C/∂u_r·F + ∂ω/∂u_r·M, with printed values. `None` if it depends on no
    /// printed value. If partial velocities but no resultant force are printed, only the term of the weight changes.
    pub(super) fn active_force(&mut self, quantities: &mut Quantities<'_>, speed: usize) -> Option<Expr> {
        let mut changes = Vec::new();
        for (at, body) in quantities.model.bodies.iter().enumerate() {
            let resultant = self.vector(quantities, VectorName::Force, at, self.frame_of_sums()).is_some();
            let load = if resultant { VectorName::Force } else { VectorName::Weight };
            let power = LoadPower { velocity: VectorName::Velocity, of: body.centre, load, body: at };
            changes.extend(self.power_change(quantities, &power, speed));
            if let (Some((frame, _)), true) =
                (&body.rigid, self.frame_of_printed_components(VectorName::Moment, at, 0).is_some())
            {
                let (velocity, load) = (VectorName::AngularVelocity, VectorName::Moment);
                let power = LoadPower { velocity, of: *frame, load, body: at };
                changes.extend(self.power_change(quantities, &power, speed));
            }
        }
        derived_value_with_changes(quantities, &QuantityKind::Row(RowQuantity::ActiveForce, speed), &changes)
    }

    /// Entry M_rs = −∂F*_r/∂u̇_s of the mass matrix, with printed values. `None` if F*_r depends on no printed value.
    pub(super) fn mass_matrix_entry(
        &mut self,
        quantities: &mut Quantities<'_>,
        row: usize,
        column: usize,
    ) -> Option<Expr> {
        let force = self.value(quantities, &QuantityKind::Row(RowQuantity::InertiaForce, row))?;
        let rate = quantities.model.speeds[column].rate;
        let arena = derived_values_arena(quantities);
        let slope = Differential::partial(rate).apply(arena, force);
        Some(arena.neg(slope))
    }

    /// Forcing f_r = F_r + F*_r at u̇ = 0, with printed values; `None` if it depends on no printed value.
    pub(super) fn forcing_entry(&mut self, quantities: &mut Quantities<'_>, row: usize) -> Option<Expr> {
        let active = self.change_of_quantity(quantities, &QuantityKind::Row(RowQuantity::ActiveForce, row));
        let inertia = self.change_of_quantity(quantities, &QuantityKind::Row(RowQuantity::InertiaForce, row));
        let changes: Vec<Expr> = active.into_iter().chain(inertia).collect();
        let zeros: Vec<_> = quantities.model.speeds.iter().map(|s| (s.rate, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&zeros);
        let changes: Vec<Expr> =
            changes.into_iter().map(|e| at_rest.apply(derived_values_arena(quantities), e)).collect();
        derived_value_with_changes(quantities, &QuantityKind::Row(RowQuantity::Forcing, row), &changes)
    }

    /// Energy, computed from printed parts such as T, V or the translational energy; `None` if it
    /// depends on no printed value.
    pub(super) fn energy_of_bodies(&mut self, quantities: &mut Quantities<'_>, energy: EnergyQuantity) -> Option<Expr> {
        let mut of = |chain: &mut Self, parts: &[(EnergyQuantity, i64)]| {
            let mut changes = Vec::new();
            for (part, sign) in parts {
                let change = chain.change_of_quantity(quantities, &QuantityKind::Energy(*part));
                changes.extend(change.map(|e| derived_values_arena(quantities).scale(e, &Rational::integer(*sign))));
            }
            derived_value_with_changes(quantities, &QuantityKind::Energy(energy), &changes)
        };
        match energy {
            EnergyQuantity::Kinetic => of(self, &[(EnergyQuantity::Translation, 1), (EnergyQuantity::Rotation, 1)]),
            EnergyQuantity::Potential => of(self, &[(EnergyQuantity::Gravity, 1)]),
            EnergyQuantity::Lagrangian => of(self, &[(EnergyQuantity::Kinetic, 1), (EnergyQuantity::Potential, -1)]),
            EnergyQuantity::Total => of(self, &[(EnergyQuantity::Kinetic, 1), (EnergyQuantity::Potential, 1)]),
            EnergyQuantity::Translation | EnergyQuantity::Rotation => self.part_of_kinetic(quantities, energy),
            EnergyQuantity::Gravity => None,
        }
    }

    /// Kinetic energy of translation, Σ ½ m v·v, or of rotation, Σ ½ ω·H, with printed values. Derived terms are used
    /// for bodies that depend on no printed value. Returns `None` if no body depends on a printed value.
    fn part_of_kinetic(&mut self, quantities: &mut Quantities<'_>, energy: EnergyQuantity) -> Option<Expr> {
        let half = Rational::fraction(1, 2).expect("not zero");
        let mut changes = Vec::new();
        for body in 0..quantities.model.bodies.len() {
            let pairs = match energy {
                EnergyQuantity::Translation => self.velocity_and_momentum(quantities, body),
                _ => self.angular_velocity_and_momentum(quantities, body),
            };
            let Some([(v, p), (right_v, right_p)]) = pairs else { continue };
            let arena = derived_values_arena(quantities);
            let (value, right) = (dot(arena, &v, &p), dot(arena, &right_v, &right_p));
            let twice = arena.sub(value, right);
            changes.push(arena.scale(twice, &half));
        }
        derived_value_with_changes(quantities, &QuantityKind::Energy(energy), &changes)
    }

    /// Pairs (v, m v) of a body: the first pair from printed values, the second derived. `None` if v depends on no
    /// printed value.
    fn velocity_and_momentum(
        &mut self,
        quantities: &mut Quantities<'_>,
        body: usize,
    ) -> Option<[(Components, Components); 2]> {
        let (centre, mass) = (quantities.model.bodies[body].centre, quantities.model.bodies[body].mass);
        let frame = self.frame_of_sums();
        let v = self.vector(quantities, VectorName::Velocity, centre, frame)?;
        let right = derived_value_components(quantities, VectorName::Velocity, centre, frame)?;
        let arena = derived_values_arena(quantities);
        Some([v, right].map(|v| (v, v.map(|e| arena.mul(mass, e)))))
    }

    /// Pairs (ω, H) of a body: the first pair from printed values, the second derived. `None` if both ω and H depend on
    /// no printed value.
    fn angular_velocity_and_momentum(
        &mut self,
        quantities: &mut Quantities<'_>,
        body: usize,
    ) -> Option<[(Components, Components); 2]> {
        let carrier = quantities.model.bodies[body].rigid.as_ref()?.0;
        let frame = self.frame_of_sums();
        let turning = self.vector(quantities, VectorName::AngularVelocity, carrier, frame);
        let h = self.vector(quantities, VectorName::AngularMomentum, body, frame);
        if turning.is_none() && h.is_none() {
            return None;
        }
        let right = derived_value_components(quantities, VectorName::AngularVelocity, carrier, frame)?;
        let right_h = derived_value_components(quantities, VectorName::AngularMomentum, body, frame)?;
        Some([(turning.unwrap_or(right), h.unwrap_or(right_h)), (right, right_h)])
    }
}
