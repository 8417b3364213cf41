//! Sums over bodies, computed with printed values: generalized forces, the mass matrix, energies.

use super::Chain;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::{Expr, Rational};
use crate::diff::roots::derived_values::{arena_of, components, derived, dot};
use crate::geometry::Components;
use crate::mechanics::{Energy, Quantities, QuantityKind, Row, VectorName};

/// Load on a body, with the velocity of the point or frame at which the load has power.
struct Power {
    /// Kind of the velocity: of the mass centre, or angular.
    velocity: VectorName,
    /// Index of the point or frame that has the velocity.
    of: usize,
    /// Kind of the load: a force or a torque.
    load: VectorName,
    /// Index of the body on which the load acts.
    body: usize,
}

impl Chain {
    /// Index of the frame in which sums over bodies are formed: that of the first printed
    /// component, else the inertial frame.
    fn frame(&self) -> usize {
        let frame = self.put.iter().find_map(|value| match value.kind {
            QuantityKind::Component { frame, .. }
            | QuantityKind::Partial { frame, .. }
            | QuantityKind::Inertia { frame, .. } => Some(frame),
            _ => None,
        });
        frame.unwrap_or(0)
    }

    /// Generalized inertia force F*_r = Σ ∂v_C/∂u_r·R* + ∂ω/∂u_r·T*, with printed values; r is the
    /// index `speed`.
    /// Derived terms are used for bodies that depend on no printed value. Returns `None` if no body
    /// depends on one.
    pub(super) fn inertia_force(&mut self, quantities: &mut Quantities<'_>, speed: usize) -> Option<Expr> {
        let mut changes = Vec::new();
        for (at, body) in quantities.model.bodies.iter().enumerate() {
            let (velocity, load) = (VectorName::Velocity, VectorName::InertiaForce);
            let power = Power { velocity, of: body.centre, load, body: at };
            changes.extend(self.power_change(quantities, &power, speed));
            if let Some((frame, _)) = &body.rigid {
                let (velocity, load) = (VectorName::AngularVelocity, VectorName::InertiaTorque);
                let power = Power { velocity, of: *frame, load, body: at };
                changes.extend(self.power_change(quantities, &power, speed));
            }
        }
        changed(quantities, &QuantityKind::Row(Row::InertiaForce, speed), &changes)
    }

    /// Change of the term ∂v/∂u_r · load if printed values replace derived ones; `None` if both
    /// factors depend on no printed value.
    fn power_change(&mut self, quantities: &mut Quantities<'_>, power: &Power, speed: usize) -> Option<Expr> {
        let &Power { velocity, of, load, body } = power;
        let frame = self.frame();
        let partial = self.partial(quantities, velocity, of, frame, speed);
        let force = self.vector(quantities, load, body, frame);
        if partial.is_none() && force.is_none() {
            return None;
        }
        let kind = |axis| QuantityKind::Partial { vector: velocity, of, frame, axis, speed };
        let right_partial =
            [derived(quantities, &kind(0))?, derived(quantities, &kind(1))?, derived(quantities, &kind(2))?];
        let right_force = components(quantities, load, body, frame)?;
        let arena = arena_of(quantities);
        let value = dot(arena, &partial.unwrap_or(right_partial), &force.unwrap_or(right_force));
        let right = dot(arena, &right_partial, &right_force);
        Some(arena.sub(value, right))
    }

    /// Generalized active force F_r = Σ ∂v_C/∂u_r·F + ∂ω/∂u_r·M, with printed values; `None` if it
    /// depends on none.
    /// If partial velocities but no resultant force are printed, only the term of the weight
    /// changes.
    pub(super) fn active_force(&mut self, quantities: &mut Quantities<'_>, speed: usize) -> Option<Expr> {
        let mut changes = Vec::new();
        for (at, body) in quantities.model.bodies.iter().enumerate() {
            let resultant = self.vector(quantities, VectorName::Force, at, self.frame()).is_some();
            let load = if resultant { VectorName::Force } else { VectorName::Weight };
            let power = Power { velocity: VectorName::Velocity, of: body.centre, load, body: at };
            changes.extend(self.power_change(quantities, &power, speed));
            if let (Some((frame, _)), true) = (&body.rigid, self.stated_frame(VectorName::Moment, at, 0).is_some()) {
                let (velocity, load) = (VectorName::AngularVelocity, VectorName::Moment);
                let power = Power { velocity, of: *frame, load, body: at };
                changes.extend(self.power_change(quantities, &power, speed));
            }
        }
        changed(quantities, &QuantityKind::Row(Row::ActiveForce, speed), &changes)
    }

    /// Entry M_rs = −∂F*_r/∂u̇_s of the mass matrix, with printed values; `None` if F*_r depends on
    /// none.
    pub(super) fn mass(&mut self, quantities: &mut Quantities<'_>, row: usize, column: usize) -> Option<Expr> {
        let force = self.value(quantities, &QuantityKind::Row(Row::InertiaForce, row))?;
        let rate = quantities.model.speeds[column].rate;
        let arena = arena_of(quantities);
        let slope = Differential::partial(rate).apply(arena, force);
        Some(arena.neg(slope))
    }

    /// Forcing f_r = F_r + F*_r at u̇ = 0, with printed values; `None` if it depends on none.
    pub(super) fn forcing(&mut self, quantities: &mut Quantities<'_>, row: usize) -> Option<Expr> {
        let active = self.change(quantities, &QuantityKind::Row(Row::ActiveForce, row));
        let inertia = self.change(quantities, &QuantityKind::Row(Row::InertiaForce, row));
        let changes: Vec<Expr> = active.into_iter().chain(inertia).collect();
        let zeros: Vec<_> = quantities.model.speeds.iter().map(|s| (s.rate, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&zeros);
        let changes: Vec<Expr> = changes.into_iter().map(|e| at_rest.apply(arena_of(quantities), e)).collect();
        changed(quantities, &QuantityKind::Row(Row::Forcing, row), &changes)
    }

    /// Energy, computed from printed parts such as T, V or the translational energy; `None` if it
    /// depends on no printed value.
    pub(super) fn energy(&mut self, quantities: &mut Quantities<'_>, energy: Energy) -> Option<Expr> {
        let mut of = |chain: &mut Self, parts: &[(Energy, i64)]| {
            let mut changes = Vec::new();
            for (part, sign) in parts {
                let change = chain.change(quantities, &QuantityKind::Energy(*part));
                changes.extend(change.map(|e| arena_of(quantities).scale(e, &Rational::integer(*sign))));
            }
            changed(quantities, &QuantityKind::Energy(energy), &changes)
        };
        match energy {
            Energy::Kinetic => of(self, &[(Energy::Translation, 1), (Energy::Rotation, 1)]),
            Energy::Potential => of(self, &[(Energy::Gravity, 1)]),
            Energy::Lagrangian => of(self, &[(Energy::Kinetic, 1), (Energy::Potential, -1)]),
            Energy::Total => of(self, &[(Energy::Kinetic, 1), (Energy::Potential, 1)]),
            Energy::Translation | Energy::Rotation => self.part_of_kinetic(quantities, energy),
            Energy::Gravity => None,
        }
    }

    /// Kinetic energy of translation, Σ ½ m v·v, or of rotation, Σ ½ ω·H, with printed values.
    /// Derived terms are used for bodies that depend on no printed value. Returns `None` if no body
    /// depends on one.
    fn part_of_kinetic(&mut self, quantities: &mut Quantities<'_>, energy: Energy) -> Option<Expr> {
        let half = Rational::fraction(1, 2).expect("not zero");
        let mut changes = Vec::new();
        for body in 0..quantities.model.bodies.len() {
            let pairs = match energy {
                Energy::Translation => self.moving_pairs(quantities, body),
                _ => self.turning_pairs(quantities, body),
            };
            let Some([(v, p), (right_v, right_p)]) = pairs else { continue };
            let arena = arena_of(quantities);
            let (value, right) = (dot(arena, &v, &p), dot(arena, &right_v, &right_p));
            let twice = arena.sub(value, right);
            changes.push(arena.scale(twice, &half));
        }
        changed(quantities, &QuantityKind::Energy(energy), &changes)
    }

    /// Pairs (v, m v) of a body, first from printed values, then as derived; `None` if v depends on
    /// no printed value.
    fn moving_pairs(&mut self, quantities: &mut Quantities<'_>, body: usize) -> Option<[(Components, Components); 2]> {
        let (centre, mass) = (quantities.model.bodies[body].centre, quantities.model.bodies[body].mass);
        let frame = self.frame();
        let v = self.vector(quantities, VectorName::Velocity, centre, frame)?;
        let right = components(quantities, VectorName::Velocity, centre, frame)?;
        let arena = arena_of(quantities);
        Some([v, right].map(|v| (v, v.map(|e| arena.mul(mass, e)))))
    }

    /// Pairs (ω, H) of a body, first from printed values, then as derived; `None` if both depend on
    /// no printed value.
    fn turning_pairs(&mut self, quantities: &mut Quantities<'_>, body: usize) -> Option<[(Components, Components); 2]> {
        let carrier = quantities.model.bodies[body].rigid.as_ref()?.0;
        let frame = self.frame();
        let turning = self.vector(quantities, VectorName::AngularVelocity, carrier, frame);
        let h = self.vector(quantities, VectorName::AngularMomentum, body, frame);
        if turning.is_none() && h.is_none() {
            return None;
        }
        let right = components(quantities, VectorName::AngularVelocity, carrier, frame)?;
        let right_h = components(quantities, VectorName::AngularMomentum, body, frame)?;
        Some([(turning.unwrap_or(right), h.unwrap_or(right_h)), (right, right_h)])
    }
}

/// Derived value of a quantity plus the given changes; `None` if there are no changes.
fn changed(quantities: &mut Quantities<'_>, kind: &QuantityKind, changes: &[Expr]) -> Option<Expr> {
    if changes.is_empty() {
        return None;
    }
    let right = derived(quantities, kind)?;
    Some(arena_of(quantities).sum(&[&[right], changes].concat()))
}
