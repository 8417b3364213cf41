//! Accelerations of frames and points of large models, computed along the tree with a name for each long subterm.
//! Rates of momenta and the acceleration energy are computed from these accelerations.

use super::kinematics::{Kinematics, Velocities, kinematic_rates, rates_to_speeds};
use super::loads::Load;
use crate::algebra::solve::quadratic_minimum::{QuadraticBlock, QuadraticForm};
use crate::algebra::term::calculus::Differential;
use crate::algebra::{Expr, Rational};
use crate::geometry::{Components, Placement, Vector, apply_tensor, cross_components};
use crate::model::{Body, Model};

/// Accelerations of all frames and points of a model; those of points are relative to free fall.
pub(in crate::mechanics) struct Accelerations {
    /// Angular acceleration α of each frame of the model, rad/s².
    pub angular: Vec<Vector>,
    /// Acceleration of each point of the model less the acceleration of free fall, m/s².
    pub linear: Vec<Vector>,
}

/// Choice of how the angular acceleration α of a frame enters the accelerations of its points.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::mechanics) enum AlphaTerms {
    /// Angular acceleration α is part of the named matrix α× + ω×ω× of the frame.
    InMatrix,
    /// Angular acceleration α stays outside the named matrix, which is then only ω×ω×. This is chosen if α is
    /// unknown.
    Separate,
}

/// Angular accelerations and angular velocities of all frames of a model.
#[derive(Clone, Copy)]
struct FrameRotations<'a> {
    /// Angular acceleration of each frame of the model, rad/s².
    angular: &'a [Vector],
    /// Components of each frame's angular velocity along its own axes, rad/s.
    spins: &'a [Components],
}

impl Kinematics {
    /// Angular acceleration α of each frame and acceleration a − g of each point, in a motion in which the state has
    /// the given `rates`. Subtracting g makes the weight an inertia force.
    pub(in crate::mechanics) fn accelerations(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        rates: &mut Differential,
        fall: &Vector,
        terms: AlphaTerms,
    ) -> Accelerations {
        let mut angular: Vec<Vector> = Vec::new();
        let mut spins: Vec<Components> = Vec::new();
        for (at, frame) in model.frames.iter().enumerate() {
            let Some((parent, _)) = frame.rotation else {
                angular.push(Vector::default());
                spins.push([Expr::ZERO; 3]);
                continue;
            };
            let name = &frame.name;
            let omega = self.frames.express_frame_by_frame(&mut self.arena, &velocities.angular[at], at, "w", name);
            let own = velocities.angular[at].parts.iter().find(|(of, _)| *of == at);
            let own = own.map_or([Expr::ZERO; 3], |(_, components)| *components);
            let arena = &mut self.arena;
            // ᴺd(σ' e)/dt = σ'' e + ω × σ' e.
            let turning = cross_components(arena, &omega, &own);
            let rate = std::array::from_fn(|i| {
                let along = rates.apply(arena, own[i]);
                arena.add(along, turning[i])
            });
            let step = Vector::in_frame(at, rate);
            angular.push(angular[parent].add(arena, &step));
            spins.push(omega);
        }
        let linear =
            self.linear_accelerations(model, FrameRotations { angular: &angular, spins: &spins }, rates, fall, terms);
        Accelerations { angular, linear }
    }

    /// Acceleration of each point less that of free fall, m/s². It follows from the acceleration a of the parent
    /// point: a + α × r + ω × (ω × r) + 2 ω × r' + r''.
    fn linear_accelerations(
        &mut self,
        model: &Model,
        turning: FrameRotations<'_>,
        rates: &mut Differential,
        fall: &Vector,
        terms: AlphaTerms,
    ) -> Vec<Vector> {
        let FrameRotations { angular, spins } = turning;
        let split = terms == AlphaTerms::Separate;
        let mut turns: Vec<Option<[Components; 3]>> = vec![None; model.frames.len()];
        let mut linear: Vec<Vector> = Vec::new();
        for point in &model.points {
            let Some(Placement { parent, frame, components }) = point.position else {
                linear.push(fall.neg(&mut self.arena));
                continue;
            };
            let alpha = self.frames.express_frame_by_frame(
                &mut self.arena,
                &angular[frame],
                frame,
                "alpha",
                &model.frames[frame].name,
            );
            let (given, sought) = if split { ([Expr::ZERO; 3], alpha) } else { (alpha, [Expr::ZERO; 3]) };
            let turn = *turns[frame]
                .get_or_insert_with(|| self.relative_acceleration_matrix(model, frame, &given, &spins[frame]));
            let arena = &mut self.arena;
            let moving = components.map(|e| rates.apply(arena, e));
            // a + α × r + ω × (ω × r) + 2 ω × r' + r''.
            let fixed = apply_tensor(arena, &turn, &components);
            let fixed =
                fixed.map(|e| if split { arena.name(e, &format!("a_within_{}", model.frames[frame].name)) } else { e });
            let turning = cross_components(arena, &sought, &components);
            let coriolis = cross_components(arena, &spins[frame], &moving);
            let two = Rational::integer(2);
            let rate = std::array::from_fn(|i| {
                let within = rates.apply(arena, moving[i]);
                let twice = arena.scale(coriolis[i], &two);
                arena.sum(&[fixed[i], turning[i], twice, within])
            });
            let step = Vector::in_frame(frame, rate);
            linear.push(linear[parent].add(arena, &step));
        }
        linear
    }

    /// Named products ω_i ω_j of the components of a frame's angular velocity, s⁻², as a symmetric matrix.
    pub(in crate::mechanics) fn named_angular_velocity_products(
        &mut self,
        model: &Model,
        frame: usize,
        omega: &Components,
    ) -> [Components; 3] {
        let name = &model.frames[frame].name;
        let arena = &mut self.arena;
        let mut product = |i: usize, j: usize| {
            let (i, j) = (i.min(j), i.max(j));
            let product = arena.mul(omega[i], omega[j]);
            arena.name(product, &format!("w_{name}_{}{}", i + 1, j + 1))
        };
        std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)))
    }

    /// Named matrix α× + ω×ω× of a frame, s⁻². Multiplied by the position vector of a point that is fixed in the
    /// frame, it gives the point's relative acceleration.
    pub(in crate::mechanics) fn relative_acceleration_matrix(
        &mut self,
        model: &Model,
        frame: usize,
        alpha: &Components,
        omega: &Components,
    ) -> [Components; 3] {
        let squares = self.named_angular_velocity_products(model, frame, omega);
        let name = &model.frames[frame].name;
        let arena = &mut self.arena;
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let entry = if i == j {
                    let sum = arena.add(squares[(i + 1) % 3][(i + 1) % 3], squares[(i + 2) % 3][(i + 2) % 3]);
                    arena.neg(sum)
                } else {
                    let other = alpha[3 - i - j];
                    if (j + 3 - i) % 3 == 1 { arena.sub(squares[i][j], other) } else { arena.add(squares[i][j], other) }
                };
                arena.name(entry, &format!("turn_{name}_{}{}", i + 1, j + 1))
            })
        })
    }

    /// Rate ω' of the components of a rigid body's ω along the frame F of its inertia, and the vector ω_F × H. `None`
    /// for a particle.
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
        // The rate of the components is α − ω_F × ω.
        let turning = cross_components(arena, &of_frame, &omega);
        let within = std::array::from_fn(|i| arena.sub(alpha[i], turning[i]));
        Some((within, cross_components(arena, &of_frame, &momentum)))
    }

    /// Rate dH/dt of a rigid body's angular momentum, N m, along the frame F of its inertia. It is I ω' + ω_F × H,
    /// where ω' is the rate of the components of ω along F. `None` for a particle.
    pub(in crate::mechanics) fn angular_momentum_rate_along_tree(
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

    /// Vectors m a − weight (N) and dH/dt (N m) of a body. The given accelerations must be relative to free fall.
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

    /// Acceleration energy ½ Σ m a² + Σ ½ ω' · I ω' + ω' · (ω × H) in a given motion. It is given as blocks ½ e · K e
    /// + b · e. Here a is the acceleration of a mass centre less that of free fall.
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
}
