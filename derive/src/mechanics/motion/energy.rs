//! Kinetic energy, and the momenta from which it is computed.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), § 5.4.

use super::kinematics::{Kinematics, Velocities};
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Expr, Rational};
use crate::geometry::{Dots, SymmetricDots, Vector, cross_components};
use crate::model::{AddedMass, Model};

/// Velocity paired with the momentum along it: v and m v of a mass centre, or ω and H of a rigid body. The kinetic
/// energy is T = Σ ½ scale velocity · momentum.
pub struct VelocityMomentum {
    /// Factor of the momentum: the mass of the body for a mass centre, 1 otherwise. It is kept separate so that equal
    /// products of vectors are recognized.
    pub scale: Expr,
    /// Velocity v_C of the mass centre (m/s), or angular velocity ω (rad/s).
    pub velocity: Vector,
    /// Velocity v_C of the mass centre, which times `scale` is the momentum, or angular momentum H = I · ω.
    pub momentum: Vector,
    /// Rate of the momentum in addition to its time derivative, N m. It is v × p for the angular impulse of an added
    /// mass with impulse p. `None` for other momenta.
    pub carried: Option<Vector>,
}

/// Impulse of the fluid that moves with a body (its added mass): the linear impulse p, the angular impulse h about
/// the mass centre, and v × p.
pub struct Impulse {
    /// Velocity v of the body's mass centre, with components in the body's frame, m/s.
    pub velocity: Vector,
    /// Angular velocity ω of the body, with components in the body's frame, rad/s.
    pub omega: Vector,
    /// Linear impulse p of the fluid, N s.
    pub linear: Vector,
    /// Angular impulse h of the fluid about the mass centre, N m s.
    pub angular: Vector,
    /// Moment v × p, N m, to be added to dh/dt because the mass centre moves.
    pub carried: Vector,
}

impl Kinematics {
    /// Velocities and momenta of all bodies, then of all added masses, in pairs.
    pub fn kinetic_energy_momenta(&mut self, model: &Model, velocities: &Velocities) -> Vec<VelocityMomentum> {
        let mut momenta = Vec::new();
        for body in &model.bodies {
            let v = &velocities.linear[body.centre];
            momenta.push(VelocityMomentum {
                scale: body.mass,
                velocity: v.clone(),
                momentum: v.clone(),
                carried: None,
            });
            if let (Some((_, inertia)), Some(omega)) = (&body.rigid, self.angular_velocity_in(body, velocities)) {
                let velocity = Vector::in_frame(inertia.frame, omega);
                let momentum = self.angular_momentum(body, velocities);
                momenta.push(VelocityMomentum { scale: Expr::ONE, velocity, momentum, carried: None });
            }
        }
        for added in &model.added_masses {
            let Impulse { velocity, omega, linear, angular, carried } =
                self.added_mass_impulse(model, velocities, added);
            momenta.push(VelocityMomentum { scale: Expr::ONE, velocity, momentum: linear, carried: None });
            momenta.push(VelocityMomentum {
                scale: Expr::ONE,
                velocity: omega,
                momentum: angular,
                carried: Some(carried),
            });
        }
        momenta
    }

    /// Impulse (p, h) = M_A ν of an added mass with the 6 × 6 tensor M_A, for a body with the twist ν =
    /// (v, ω).
    pub fn added_mass_impulse(&mut self, model: &Model, velocities: &Velocities, added: &AddedMass) -> Impulse {
        let body = &model.bodies[added.body];
        let frame = body.rigid.as_ref().map_or(0, |(frame, _)| *frame);
        let mut own = |vector: &Vector| {
            let components = self.frames.express(&mut self.arena, vector, frame);
            components.map(|e| self.simplifier.simplify(&mut self.arena, e))
        };
        let (v, omega) = (own(&velocities.linear[body.centre]), own(&velocities.angular[frame]));
        let twist: Vec<Expr> = v.iter().chain(&omega).copied().collect();
        let arena = &mut self.arena;
        let momentum = added.tensor.map(|row| {
            let terms: Vec<Expr> = row.iter().zip(&twist).map(|(entry, x)| arena.mul(*entry, *x)).collect();
            arena.sum(&terms)
        });
        let [p1, p2, p3, h1, h2, h3] = momentum;
        let carried = cross_components(arena, &v, &[p1, p2, p3]);
        let [velocity, omega, linear, angular, carried] =
            [v, omega, [p1, p2, p3], [h1, h2, h3], carried].map(|components| Vector::in_frame(frame, components));
        Impulse { velocity, omega, linear, angular, carried }
    }

    /// Kinetic energy T = Σ ½ m v·v + ½ ω·I·ω, J, as a quadratic form in the motion variables `variables`.
    pub fn kinetic_energy(&mut self, model: &Model, velocities: &Velocities, variables: &[Expr]) -> Expr {
        let form = self.kinetic_energy_matrix(model, velocities, variables);
        self.kinetic_energy_of_matrix(model, velocities, variables, &form)
    }

    /// Symmetric matrix ∂²T/∂x_i∂x_j of the kinetic energy, each entry simplified; x are the motion
    /// variables `variables`.
    pub fn kinetic_energy_matrix(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        variables: &[Expr],
    ) -> Vec<Vec<Expr>> {
        if self.frames.carries && !self.frames.are_all_children_of_inertial() {
            return self.kinetic_matrix_of_momentum_pairs(model, velocities, variables);
        }
        let mut gradient = Gradient::new(variables);
        let mut products = SymmetricDots::new(variables.len());
        for VelocityMomentum { scale, velocity, momentum, .. } in self.kinetic_energy_momenta(model, velocities) {
            let velocities = velocity.partial_derivatives(&mut self.arena, &mut gradient);
            products.add(scale, &velocities, &momentum.partial_derivatives(&mut self.arena, &mut gradient));
        }
        let mut form = products.sum(&mut self.arena, &mut self.frames);
        form.iter_mut().flatten().for_each(|e| *e = self.simplifier.simplify(&mut self.arena, *e));
        form
    }

    /// Kinetic energy as the quadratic form ½ Σ form_ij x_i x_j, J, as people write it. The plain sum over the
    /// bodies, if T is not quadratic in x because velocities remain at x = 0.
    pub(in crate::mechanics) fn kinetic_energy_of_matrix(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        variables: &[Expr],
        form: &[Vec<Expr>],
    ) -> Expr {
        if self.frames.carries {
            let pairs = self.momentum_pairs(model, velocities);
            return self.kinetic_energy_of_momentum_pairs(&pairs);
        }
        let half = Rational::fraction(1, 2).expect("not zero");
        let mut terms = Vec::new();
        for (i, row) in form.iter().enumerate() {
            for (j, coefficient) in row.iter().enumerate().skip(i) {
                let term = self.arena.product(&[*coefficient, variables[i], variables[j]]);
                terms.push((term, if i == j { half.clone() } else { Rational::ONE }));
            }
        }
        let quadratic = self.arena.linear_combination(&terms);
        let zeros: Vec<_> = variables.iter().map(|x| (*x, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&zeros);
        let moving = model.bodies.iter().flat_map(|body| {
            let turning = body.rigid.as_ref().map(|(frame, _)| &velocities.angular[*frame]);
            turning.into_iter().chain([&velocities.linear[body.centre]])
        });
        if moving.into_iter().all(|v| v.substitute(&mut self.arena, &mut at_rest).is_zero()) {
            return quadratic;
        }
        let mut dots = Dots::default();
        for VelocityMomentum { scale, velocity, momentum, .. } in self.kinetic_energy_momenta(model, velocities) {
            dots.add(scale, &velocity, &momentum);
        }
        let twice = dots.sum(&mut self.arena, &mut self.frames);
        let energy = self.arena.scale(twice, &half);
        let rest = self.arena.sub(energy, quadratic);
        match zero_test(&self.arena, rest) {
            ZeroTest::Zero => quadratic,
            _ => self.simplifier.simplify(&mut self.arena, energy),
        }
    }
}
