//! Vectors computed with printed values: velocities, accelerations, momenta and their derivatives, loads, partial
//! velocities.

use super::ValueConsequences;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::diff::roots::derived_values::{
    derived_components_in_frame, derived_value, derived_value_components, derived_values_arena, difference, sum,
};
use crate::geometry::{Components, apply_tensor, cross_components};
use crate::mechanics::{Quantities, QuantityKind, VectorName};

impl ValueConsequences {
    /// Computes a vector that is not printed from printed vectors; `None` if it depends on no printed value.
    pub(super) fn compute_vector(
        &mut self,
        quantities: &mut Quantities<'_>,
        name: VectorName,
        of: usize,
        frame: usize,
    ) -> Option<Components> {
        match name {
            VectorName::Velocity => self.point_velocity(quantities, of, frame),
            VectorName::Acceleration => self.vector_rate(quantities, VectorName::Velocity, of, frame),
            VectorName::AngularAcceleration => self.vector_rate(quantities, VectorName::AngularVelocity, of, frame),
            VectorName::AngularMomentum => {
                let reached = self.inertia_product(quantities, of, frame, VectorName::AngularVelocity);
                reached.filter(|(_, is_reached)| *is_reached).map(|(value, _)| value)
            }
            VectorName::MomentumRate => self.momentum_rate(quantities, of, frame),
            VectorName::LinearMomentumRate => {
                if self.frame_of_printed_components(VectorName::InertiaForce, of, frame).is_some() {
                    return self.negative_vector(quantities, VectorName::InertiaForce, of, frame);
                }
                let body = &quantities.model.bodies[of];
                let (centre, mass) = (body.centre, body.mass);
                let a = self.vector(quantities, VectorName::Acceleration, centre, frame)?;
                Some(a.map(|e| derived_values_arena(quantities).mul(mass, e)))
            }
            VectorName::InertiaForce => self.negative_vector(quantities, VectorName::LinearMomentumRate, of, frame),
            VectorName::InertiaTorque => self.negative_vector(quantities, VectorName::MomentumRate, of, frame),
            VectorName::Force => {
                let weight = self.vector_change(quantities, VectorName::Weight, of, frame)?;
                let force = derived_value_components(quantities, VectorName::Force, of, frame)?;
                Some(sum(derived_values_arena(quantities), &force, &weight))
            }
            VectorName::Position | VectorName::AngularVelocity | VectorName::Weight | VectorName::Moment => None,
        }
    }

    /// Negative of a vector, computed with printed values; `None` if the vector depends on no
    /// printed value.
    fn negative_vector(
        &mut self,
        quantities: &mut Quantities<'_>,
        name: VectorName,
        of: usize,
        frame: usize,
    ) -> Option<Components> {
        let v = self.vector(quantities, name, of, frame)?;
        Some(v.map(|e| derived_values_arena(quantities).neg(e)))
    }

    /// Velocity of a point P, computed with printed values; `None` if it depends on no printed value. For a printed
    /// position p, it is dp/dt. Otherwise it is v_O + ω × p_OP plus the derivative of p_OP in the frame, where O is the
    /// point relative to which P is placed.
    fn point_velocity(&mut self, quantities: &mut Quantities<'_>, of: usize, frame: usize) -> Option<Components> {
        if self.frame_of_printed_components(VectorName::Position, of, frame).is_some() {
            return self.vector_rate(quantities, VectorName::Position, of, frame);
        }
        let placement = quantities.model.points[of].position?;
        let (parent, carrier, arm) = (placement.parent, placement.frame, placement.components);
        let mut change = None;
        if self.frame_of_printed_components(VectorName::Velocity, parent, frame).is_some() {
            change = self.vector_change(quantities, VectorName::Velocity, parent, frame);
        }
        if self.frame_of_printed_components(VectorName::AngularVelocity, carrier, carrier).is_some() {
            let turning = self.vector_change(quantities, VectorName::AngularVelocity, carrier, carrier)?;
            let moved = cross_components(derived_values_arena(quantities), &turning, &arm);
            let moved = derived_components_in_frame(quantities, moved, carrier, frame)?;
            change = Some(change.map_or(moved, |other| sum(derived_values_arena(quantities), &moved, &other)));
        }
        let right = derived_value_components(quantities, VectorName::Velocity, of, frame)?;
        Some(sum(derived_values_arena(quantities), &right, &change?))
    }

    /// Time derivative of a vector in the inertial frame: its derivative in `frame` plus the cross product of the
    /// angular velocity of `frame` with the vector. Returns `None` if it depends on no printed value.
    fn vector_rate(
        &mut self,
        quantities: &mut Quantities<'_>,
        name: VectorName,
        of: usize,
        frame: usize,
    ) -> Option<Components> {
        let moving = self.vector(quantities, name, of, frame);
        let turning = self.vector(quantities, VectorName::AngularVelocity, frame, frame);
        if moving.is_none() && turning.is_none() && !self.moves_otherwise {
            return None;
        }
        let v = moving.or_else(|| derived_value_components(quantities, name, of, frame))?;
        let w = turning.or_else(|| derived_value_components(quantities, VectorName::AngularVelocity, frame, frame))?;
        let arena = derived_values_arena(quantities);
        let own = v.map(|e| self.d_dt.apply(arena, e));
        let carried = cross_components(arena, &w, &v);
        Some(sum(arena, &own, &carried))
    }

    /// Product of a body's inertia tensor with ω or α. The second value is true if the product depends on a printed
    /// value.
    fn inertia_product(
        &mut self,
        quantities: &mut Quantities<'_>,
        body: usize,
        frame: usize,
        by: VectorName,
    ) -> Option<(Components, bool)> {
        let carrier = quantities.model.bodies[body].rigid.as_ref()?.0;
        let turning = self.vector(quantities, by, carrier, frame);
        let mut tensor = [[Expr::ZERO; 3]; 3];
        let mut is_reached = turning.is_some();
        for (at, value) in tensor.iter_mut().flatten().enumerate() {
            let kind = QuantityKind::Inertia { body, frame, entry: (at / 3, at % 3) };
            is_reached |= self.printed(&kind).is_some();
            *value = self.printed(&kind).or_else(|| derived_value(quantities, &kind))?;
        }
        let turning = turning.or_else(|| derived_value_components(quantities, by, carrier, frame))?;
        Some((apply_tensor(derived_values_arena(quantities), &tensor, &turning), is_reached))
    }

    /// Time derivative of a body's angular momentum. It is −T* or dH/dt from a printed T* or H, else Euler's I·α + ω ×
    /// I·ω. Returns `None` if it depends on no printed value.
    fn momentum_rate(&mut self, quantities: &mut Quantities<'_>, body: usize, frame: usize) -> Option<Components> {
        if self.frame_of_printed_components(VectorName::InertiaTorque, body, frame).is_some() {
            return self.negative_vector(quantities, VectorName::InertiaTorque, body, frame);
        }
        if self.frame_of_printed_components(VectorName::AngularMomentum, body, frame).is_some() || self.moves_otherwise
        {
            return self.vector_rate(quantities, VectorName::AngularMomentum, body, frame);
        }
        let carrier = quantities.model.bodies[body].rigid.as_ref()?.0;
        let turning = self.vector(quantities, VectorName::AngularVelocity, carrier, frame);
        let (own, own_reached) = self.inertia_product(quantities, body, frame, VectorName::AngularAcceleration)?;
        let (h, h_reached) = self.inertia_product(quantities, body, frame, VectorName::AngularVelocity)?;
        if !(own_reached || h_reached) {
            return None;
        }
        let w =
            turning.or_else(|| derived_value_components(quantities, VectorName::AngularVelocity, carrier, frame))?;
        let arena = derived_values_arena(quantities);
        let carried = cross_components(arena, &w, &h);
        Some(sum(arena, &own, &carried))
    }

    /// Vector computed with printed values, minus the derived vector. `None` if it depends on no printed value.
    fn vector_change(
        &mut self,
        quantities: &mut Quantities<'_>,
        name: VectorName,
        of: usize,
        frame: usize,
    ) -> Option<Components> {
        let value = self.vector(quantities, name, of, frame)?;
        let right = derived_value_components(quantities, name, of, frame)?;
        Some(difference(derived_values_arena(quantities), &value, &right))
    }

    /// Partial velocity ∂v/∂u_r, where r is the index `speed`: as printed, or else from a velocity that depends on
    /// printed values. Returns `None` if neither exists.
    pub(super) fn partial_velocity(
        &mut self,
        quantities: &mut Quantities<'_>,
        vector: VectorName,
        of: usize,
        frame: usize,
        speed: usize,
    ) -> Option<Components> {
        let stated = self.put.iter().find_map(|value| match value.kind {
            QuantityKind::Partial { vector: v, of: o, frame, speed: s, .. } if (v, o, s) == (vector, of, speed) => {
                Some(frame)
            }
            _ => None,
        });
        if let Some(stated) = stated {
            let kind = |axis| QuantityKind::Partial { vector, of, frame: stated, axis, speed };
            let own = self.components_printed_or_derived(quantities, kind)?;
            return derived_components_in_frame(quantities, own, stated, frame);
        }
        let v = self.vector(quantities, vector, of, frame)?;
        let mut slope = Differential::partial(quantities.model.speeds[speed].symbol);
        Some(v.map(|e| slope.apply(derived_values_arena(quantities), e)))
    }
}
