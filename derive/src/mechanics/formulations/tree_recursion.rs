//! Equations of motion of large models, whose closed form would be too long. Velocities and
//! accelerations are passed from frame to frame along the tree, and long subterms get names. Sums
//! over bodies are differentiated backwards through these names.
//!
//! The three formulations remain distinct. Kane's method adds weights, loads and inertia forces
//! along partial velocities that are never written out (backward sums of forces). Lagrange's method
//! differentiates the energies backwards through the named subterms, then by time. The Newton–Euler
//! equations are stated body by body, as for every other model. The formulations share only the
//! kinematics.
//!
//! Luh, Walker & Paul, ASME J. Dyn. Sys. Meas. Control 102 (1980) 69–76; R. Featherstone, *Rigid Body Dynamics
//! Algorithms* (2008), §§ 5.3, 6.2.

use crate::algebra::solve::quadratic_minimum::{QuadraticBlock, QuadraticForm};
use crate::algebra::term::adjoint::adjoint_product;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::{Components, Placement, Vector, apply_tensor, cross_components};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::kinematics::{
    Kinematics, Velocities, kinematic_rates, kinematic_rates_without_acceleration, rates_to_speeds,
};
use crate::mechanics::motion::loads::Load;
use crate::mechanics::motion::tree_accelerations::{Accelerations, AlphaTerms};
use crate::model::{Body, Model};

/// Prefix for the name of a force along a named velocity component.
const FORCE: &str = "F";
/// Prefix for the name of a momentum along a named velocity component.
const MOMENTUM: &str = "p";

/// Velocity component and the force or momentum component along it.
pub(in crate::mechanics) type VelocityForcePair = (Expr, Expr);

impl Kinematics {
    /// Angular velocity ω (rad/s) and angular momentum H (kg m²/s) of a rigid body, as named components
    /// along the frame of its inertia; `None` for a particle.
    fn angular_velocity_and_momentum(
        &mut self,
        body: &Body,
        velocities: &Velocities,
    ) -> Option<(Components, Components)> {
        let (own, inertia) = body.rigid.as_ref()?;
        let name = self.frames.name(*own);
        let omega =
            self.frames.express_frame_by_frame(&mut self.arena, &velocities.angular[*own], inertia.frame, "w", name);
        let momentum = apply_tensor(&mut self.arena, &inertia.tensor, &omega);
        Some((
            omega,
            crate::mechanics::motion::frame_transport::name_transported_components(
                &mut self.arena,
                momentum,
                &format!("H_{}", body.name),
            ),
        ))
    }

    /// Rate dH/dt of a rigid body's angular momentum, N m, along the frame F of its inertia: I ω' + ω_F
    /// × H. Here ω' differentiates the components along F. `None` for a particle.
    fn angular_momentum_rate_along_tree(
        &mut self,
        body: &Body,
        velocities: &Velocities,
        accelerations: &Accelerations,
    ) -> Option<Components> {
        let (within, gyroscopic) = self.angular_acceleration_along_tree(body, velocities, accelerations)?;
        let (_, inertia) = body.rigid.as_ref()?;
        let rate = apply_tensor(&mut self.arena, &inertia.tensor, &within);
        Some(std::array::from_fn(|i| self.arena.add(rate[i], gyroscopic[i])))
    }

    /// Rate ω' of the components of a rigid body's ω along the frame F of its inertia, and ω_F × H.
    /// `None` for a particle.
    fn angular_acceleration_along_tree(
        &mut self,
        body: &Body,
        velocities: &Velocities,
        accelerations: &Accelerations,
    ) -> Option<(Components, Components)> {
        let (omega, momentum) = self.angular_velocity_and_momentum(body, velocities)?;
        let (own, inertia) = body.rigid.as_ref()?;
        let name = self.frames.name(*own);
        let alpha = self.frames.express_frame_by_frame(
            &mut self.arena,
            &accelerations.angular[*own],
            inertia.frame,
            "alpha",
            name,
        );
        let of_frame = if *own == inertia.frame {
            omega
        } else {
            let name = self.frames.name(inertia.frame);
            self.frames.express_frame_by_frame(
                &mut self.arena,
                &velocities.angular[inertia.frame],
                inertia.frame,
                "w",
                name,
            )
        };
        let arena = &mut self.arena;
        // The rate of the components is α less ω_F × ω.
        let turning = cross_components(arena, &of_frame, &omega);
        let within = std::array::from_fn(|i| arena.sub(alpha[i], turning[i]));
        Some((within, cross_components(arena, &of_frame, &momentum)))
    }

    /// Lists the velocity components of all bodies, each paired with the momentum along it: T = ½ Σ
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

    /// Lists the velocity components of all bodies, each paired with the inertia force and weight along
    /// it. Inertia forces use the given accelerations, which already contain the free fall.
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

    /// Lists the velocity components on which loads do work, each paired with the load along it. `put`
    /// substitutes the velocities that occur in a load.
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

    /// Time derivatives of a point's position components along the frame in which the model places it,
    /// m/s. Zero for the origin.
    pub(in crate::mechanics) fn point_rates_in_frame(
        &mut self,
        model: &Model,
        point: usize,
        velocities: &Velocities,
    ) -> Components {
        let Some(Placement { components, .. }) = model.points[point].position else { return [Expr::ZERO; 3] };
        let mut rates =
            Differential::along(&model.q().into_iter().zip(velocities.rates.iter().copied()).collect::<Vec<_>>());
        components.map(|e| rates.apply(&mut self.arena, e))
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

    /// Matrix ∂²T/∂x_i∂x_j of the kinetic energy for the motion variables x, differentiated from the
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

    /// Potential energy −g · Σ m p of gravity, J. The first moments m p are added before they are
    /// expressed in the frame of g.
    ///
    /// # Errors
    /// `DeriveError::NoZeroOfPotential` if it has no value at the model's `zero_at`.
    pub(in crate::mechanics) fn gravity_potential_by_first_moments(
        &mut self,
        model: &Model,
        g: &Vector,
    ) -> Result<Expr, DeriveError> {
        let mut moment = Vector::default();
        for body in &model.bodies {
            let own = self.positions[body.centre].scale(&mut self.arena, body.mass);
            moment = moment.add(&mut self.arena, &own);
        }
        let mut named = moment.clone();
        for (frame, components) in &mut named.parts {
            let what = format!("mp_{}", self.frames.name(*frame).to_owned());
            *components = crate::mechanics::motion::frame_transport::name_transported_components(
                &mut self.arena,
                *components,
                &what,
            );
        }
        let work = self.frames.dot(&mut self.arena, g, &named);
        let energy = self.arena.neg(work);
        self.energy_with_stated_zero(model, energy)
    }

    /// Kinetic energy ½ Σ velocity · momentum, J, from pairs of velocity and momentum components.
    pub(in crate::mechanics) fn kinetic_energy_of_momentum_pairs(&mut self, pairs: &[VelocityForcePair]) -> Expr {
        let arena = &mut self.arena;
        let half = Rational::fraction(1, 2).expect("not zero");
        let terms: Vec<(Expr, Rational)> = pairs.iter().map(|(v, p)| (arena.mul(*v, *p), half.clone())).collect();
        arena.linear_combination(&terms)
    }

    /// Kane's equations M u̇ = f as (M, f), with the given loads and the acceleration `fall` of free
    /// fall. Partial velocities are never written out.
    pub(in crate::mechanics) fn kane_system_by_recursion(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        loads: &[Load],
        fall: &Vector,
    ) -> (Vec<Vec<Expr>>, Vec<Expr>) {
        let mut resting = kinematic_rates_without_acceleration(model);
        let forcing = self.forces_of_velocity_pairs(model, velocities, loads, fall, &mut resting);
        let matrix = match self.composite_mass_matrix(model, velocities, &model.u()) {
            Some(form) => form,
            None => self.kinetic_energy_matrix(model, velocities, &model.u()),
        };
        (matrix, forcing)
    }

    /// Sums F_r + F*_r of the active and inertia forces, one for each speed, in a motion whose state
    /// has the given rates.
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

    /// Vectors m a − weight (N) and dH/dt (N m) of a body, from accelerations that already contain the
    /// free fall.
    pub(in crate::mechanics) fn momentum_rates_along_tree(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        accelerations: &Accelerations,
        body: &Body,
    ) -> (Vector, Vector) {
        let a = &accelerations.linear[body.centre];
        let home = self.frames.common_transport_frame([&velocities.linear[body.centre], a]);
        let a = self.frames.express_frame_by_frame(&mut self.arena, a, home, "a", &model.points[body.centre].name);
        let force = Vector::in_frame(home, a.map(|e| self.arena.mul(body.mass, e)));
        let moment = self.angular_momentum_rate_along_tree(body, velocities, accelerations);
        let frame = body.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
        (force, moment.map_or_else(Vector::default, |rate| Vector::in_frame(frame, rate)))
    }

    /// Function of u̇ that Gauss's principle minimizes: the acceleration energy less the power of the
    /// loads along u̇. Weights count as inertia forces.
    pub(in crate::mechanics) fn gauss_function_along_tree(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        loads: &[Load],
    ) -> QuadraticForm {
        let blocks =
            self.acceleration_energy_along_tree(model, velocities, &mut kinematic_rates(model), &Self::fall(model));
        let forces = self.forces_of_load_pairs(loads, &mut rates_to_speeds(model), &model.u());
        let linear = forces.into_iter().map(|e| self.arena.neg(e)).collect();
        QuadraticForm { blocks, linear }
    }

    /// Acceleration energy ½ Σ m a² + Σ ½ ω' · I ω' + ω' · (ω × H) in a given motion, as blocks ½ e · K
    /// e + b · e. Here a is the acceleration of a mass centre less that of free fall.
    pub(in crate::mechanics) fn acceleration_energy_along_tree(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        rates: &mut Differential,
        fall: &Vector,
    ) -> Vec<QuadraticBlock> {
        let accelerations = self.accelerations(model, velocities, rates, fall, AlphaTerms::Separate);
        let mut blocks = Vec::new();
        let none = [Expr::ZERO; 3];
        for body in &model.bodies {
            let a = &accelerations.linear[body.centre];
            let home = self.frames.common_transport_frame([&velocities.linear[body.centre], a]);
            let components =
                self.frames.express_frame_by_frame(&mut self.arena, a, home, "a", &model.points[body.centre].name);
            let mut tensor = [none; 3];
            (0..3).for_each(|i| tensor[i][i] = body.mass);
            blocks.push(QuadraticBlock { components, tensor, linear: none });
            if let (Some((_, inertia)), Some((components, linear))) =
                (&body.rigid, self.angular_acceleration_along_tree(body, velocities, &accelerations))
            {
                blocks.push(QuadraticBlock { components, tensor: inertia.tensor, linear });
            }
        }
        blocks
    }

    /// Acceleration of free fall, m/s², in the model's gravity frame; zero without gravity.
    pub(in crate::mechanics) fn fall(model: &Model) -> Vector {
        model.gravity.as_ref().map(|g| Vector::in_frame(g.frame, g.acceleration)).unwrap_or_default()
    }

    /// Lagrange's equations E q̈ = A from the energies, as (E, A, E q̈ − A). Of the loads, only gravity
    /// is included.
    pub(in crate::mechanics) fn lagrange_system(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        potential: Expr,
    ) -> (Vec<Vec<Expr>>, Vec<Expr>, Vec<Expr>) {
        let n = model.coordinates.len();
        let variables = [model.q(), model.q_dot()].concat();
        // T = ½ Σ v · p with p linear in v, so the slopes of T are those of v, weighted by p.
        let pairs = self.momentum_pairs(model, velocities);
        let slopes = adjoint_product(&mut self.arena, &pairs, &variables, MOMENTUM);
        let (along_q, momenta) = slopes.split_at(n);
        let falling = adjoint_product(&mut self.arena, &[(potential, Expr::MINUS_ONE)], &model.q(), FORCE);
        let mut along: Vec<(Expr, Expr)> = model.q().into_iter().zip(model.q_dot()).collect();
        let mut coasting = Differential::along(&along);
        along.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
        let mut moving = Differential::along(&along);
        let arena = &mut self.arena;
        let (mut forcing, mut required) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for i in 0..n {
            let acting = arena.add(along_q[i], falling[i]);
            let (coasting, moving) = (coasting.apply(arena, momenta[i]), moving.apply(arena, momenta[i]));
            forcing.push(arena.sub(acting, coasting));
            required.push(arena.sub(moving, acting));
        }
        let matrix = if self.frames.are_all_children_of_inertial() {
            self.kinetic_energy_matrix(model, velocities, &model.q_dot())
        } else {
            symmetric_derivative_matrix(arena, momenta, &model.q_dot())
        };
        (matrix, forcing, required)
    }
}

/// Matrix ∂p_i/∂x_j of momenta p by motion variables x. It is symmetric, so only its upper triangle
/// is differentiated.
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
