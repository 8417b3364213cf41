//! Equations of large models, derived by recursion along the tree of frames; their closed form would be too long.
//! Velocity components are paired with the forces or momenta along them.
//!
//! Velocities and accelerations are passed from frame to frame, and long subterms get names. Sums over bodies are
//! differentiated backwards through these names.
//!
//! The formulations remain distinct, and share only the kinematics. Kane's method adds weights, loads and inertia
//! forces along partial velocities that are never written out (backward sums of forces). Lagrange's method
//! differentiates the energies backwards through the named subterms, then by time. The Newton–Euler equations are
//! stated body by body, as for every other model.
//!
//! Luh, Walker & Paul, ASME J. Dyn. Sys. Meas. Control 102 (1980) 69–76; R. Featherstone, *Rigid Body Dynamics
//! Algorithms* (2008), §§ 5.3, 6.2.

use crate::algebra::term::adjoint::adjoint_product;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::Vector;
use crate::mechanics::motion::kinematics::{Kinematics, Velocities, rates_to_speeds};
use crate::mechanics::motion::loads::Load;
use crate::mechanics::motion::tree_accelerations::{Accelerations, AlphaTerms};
use crate::model::Model;

/// Prefix for the name of a force along a named velocity component (backward sums of Kane's method).
pub(super) const FORCE: &str = "F";
/// Prefix for the name of a momentum along a named velocity component.
pub(super) const MOMENTUM: &str = "p";

/// Velocity component, paired with the force or momentum component along it.
pub(in crate::mechanics) type VelocityForcePair = (Expr, Expr);

impl Kinematics {
    /// Velocity components of all bodies, each paired with the momentum along it. The kinetic energy is T = ½ Σ
    /// velocity · momentum.
    pub(in crate::mechanics) fn momentum_pairs(
        &mut self,
        model: &Model,
        velocities: &Velocities,
    ) -> Vec<VelocityForcePair> {
        let mut pairs = Vec::new();
        for body in &model.bodies {
            let v = &velocities.linear[body.centre];
            let home = self.frames.common_transport_frame([v]);
            let v = self.frames.express_frame_by_frame(&mut self.arena, v, home, "v", &model.points[body.centre].name);
            pairs.extend(v.map(|e| (e, self.arena.mul(body.mass, e))));
            if let Some((omega, momentum)) = self.angular_velocity_and_momentum(body, velocities) {
                pairs.extend(omega.into_iter().zip(momentum));
            }
        }
        pairs
    }

    /// Velocity components of all bodies, each paired with the inertia force and weight along it. The given
    /// accelerations must be relative to free fall, so that inertia forces include the weights.
    fn inertia_pairs(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        accelerations: &Accelerations,
    ) -> Vec<VelocityForcePair> {
        let mut pairs = Vec::new();
        for body in &model.bodies {
            let (v, a) = (&velocities.linear[body.centre], &accelerations.linear[body.centre]);
            let home = self.frames.common_transport_frame([v, a]);
            let point = &model.points[body.centre].name;
            let v = self.frames.express_frame_by_frame(&mut self.arena, v, home, "v", point);
            let a = self.frames.express_frame_by_frame(&mut self.arena, a, home, "a", point);
            for (v, a) in v.into_iter().zip(a) {
                let force = self.arena.product(&[body.mass, a, Expr::MINUS_ONE]);
                pairs.push((v, force));
            }
            if let (Some((omega, _)), Some(rate)) = (
                self.angular_velocity_and_momentum(body, velocities),
                self.angular_momentum_rate_along_tree(body, velocities, accelerations),
            ) {
                pairs.extend(omega.into_iter().zip(rate.map(|e| self.arena.neg(e))));
            }
        }
        pairs
    }

    /// Velocity components on which loads do work, each paired with the load along it. `put` replaces the velocities
    /// that occur in a load.
    pub(in crate::mechanics) fn load_pairs<'a>(
        &mut self,
        loads: impl IntoIterator<Item = &'a Load>,
        put: &mut Substitution,
    ) -> Vec<VelocityForcePair> {
        let mut pairs = Vec::new();
        for Load { velocity, scale, load } in loads {
            let load = load.substitute(&mut self.arena, put);
            let home = self.frames.common_transport_frame([velocity, &load]);
            let velocity = self.frames.express_frame_by_frame(&mut self.arena, velocity, home, "v", "load");
            let load = self.frames.express_frame_by_frame(&mut self.arena, &load, home, "load", "on");
            pairs.extend(velocity.into_iter().zip(load.map(|e| self.arena.mul(*scale, e))));
        }
        pairs
    }

    /// Generalized forces of the given loads, one entry for each of the motion variables `variables`.
    pub(in crate::mechanics) fn forces_of_load_pairs<'a>(
        &mut self,
        loads: impl IntoIterator<Item = &'a Load>,
        put: &mut Substitution,
        variables: &[Expr],
    ) -> Vec<Expr> {
        let pairs = self.load_pairs(loads, put);
        adjoint_product(&mut self.arena, &pairs, variables, FORCE)
    }

    /// Symmetric matrix ∂²T/∂x_i∂x_j of the kinetic energy for the motion variables x. It is differentiated from the
    /// momenta of the bodies.
    pub(in crate::mechanics) fn kinetic_matrix_of_momentum_pairs(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        variables: &[Expr],
    ) -> Vec<Vec<Expr>> {
        let pairs = self.momentum_pairs(model, velocities);
        let momenta = adjoint_product(&mut self.arena, &pairs, variables, MOMENTUM);
        symmetric_derivative_matrix(&mut self.arena, &momenta, variables)
    }

    /// Kinetic energy ½ Σ velocity · momentum, J, from pairs of velocity and momentum components.
    pub(in crate::mechanics) fn kinetic_energy_of_momentum_pairs(&mut self, pairs: &[VelocityForcePair]) -> Expr {
        let arena = &mut self.arena;
        let half = Rational::fraction(1, 2).expect("not zero");
        let terms: Vec<(Expr, Rational)> = pairs.iter().map(|(v, p)| (arena.mul(*v, *p), half.clone())).collect();
        arena.linear_combination(&terms)
    }

    /// Sums F_r + F*_r of the active and inertia forces, one for each speed. They hold in a motion in which the state
    /// has the given `rates`.
    pub(in crate::mechanics) fn forces_of_velocity_pairs(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        loads: &[Load],
        fall: &Vector,
        rates: &mut Differential,
    ) -> Vec<Expr> {
        let accelerations = self.accelerations(model, velocities, rates, fall, AlphaTerms::InMatrix);
        let mut pairs = self.inertia_pairs(model, velocities, &accelerations);
        pairs.extend(self.load_pairs(loads, &mut rates_to_speeds(model)));
        adjoint_product(&mut self.arena, &pairs, &model.u(), FORCE)
    }
}

/// Matrix ∂p_i/∂x_j of momenta p with respect to motion variables x. It is symmetric, so only its upper triangle is
/// differentiated.
pub(in crate::mechanics) fn symmetric_derivative_matrix(
    arena: &mut Arena,
    momenta: &[Expr],
    variables: &[Expr],
) -> Vec<Vec<Expr>> {
    let n = variables.len();
    let mut gradient = Gradient::new(variables);
    let mut matrix = vec![vec![Expr::ZERO; n]; n];
    for (i, momentum) in momenta.iter().enumerate() {
        for &(j, slope) in gradient.apply(arena, *momentum).iter().filter(|(j, _)| *j >= i) {
            matrix[i][j] = slope;
            matrix[j][i] = slope;
        }
    }
    matrix
}
