//! Forces and torques between bodies that do the work of potentials, for the Newton–Euler equations.
//!
//! A potential in coordinates states its work, but not the bodies on which it acts, which the Newton–Euler equations
//! need. Its forces and torques are those that motors and springs in joints would exert: they act along and about
//! axes of frames, between each body and its support ([`super::relative_motion`]). The relative velocities along
//! these axes, r = R q̇, determine q̇. Axes whose velocities depend on the fewest coordinates come first.
//!
//! The forces and torques w do the work of the potential in every motion: Rᵀ w = −∂V/∂q. If the motions of the bodies
//! do not determine q̇, as with Euler parameters, they determine the speeds u, and the work is equal in every
//! permitted motion. Accelerations do not depend on the choice of axes; reactions do.

use super::random_pose::{RandomModel, VectorResidues};
use super::relative_motion::{BodyPair, Holder, RelativeMotion};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::value::rank::Basis;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Frames, Motion, Vector};
use crate::model::{ForcePlace, Model, PotentialForce, ReactionKind};

/// Largest number of bodies for which forces and torques of potentials are searched.
const MOST_BODIES: usize = 24;

/// Axis along or about which a force or torque of a potential acts, as (kind, frame, axis 0, 1 or 2).
type Axis = (ReactionKind, usize, usize);

impl Model {
    /// Finds the loads that the model file does not state: forces and torques of potentials, then reactions.
    pub(in crate::model) fn add_potential_forces_and_reactions(&mut self) {
        self.find_potential_forces();
        self.add_found_reactions();
    }

    /// Finds forces and torques that do the work of the potentials. Sets none if the search finds none.
    fn find_potential_forces(&mut self) {
        if self.potentials.is_empty() || self.bodies.len() > MOST_BODIES {
            return;
        }
        let mut arena = self.arena.clone();
        let Some(drawn) = RandomModel::new(self, &mut arena) else { return };
        let relative = RelativeMotion { model: self, drawn, ways_if_open: None };
        // The potential V no longer contains coordinates that closing joints determine.
        let own: Vec<usize> = relative.own_motions().filter(|at| *at < self.coordinates.len()).collect();
        let along = |motions: &[usize]| {
            let listed = |velocity: &dyn Fn(usize) -> VectorResidues| motions.iter().map(|at| velocity(*at)).collect();
            let independent_axes = relative.potential_force_axes(motions.len(), listed)?;
            let rates: Vec<Expr> = motions.iter().map(|at| self.coordinates[*at].rate).collect();
            self.efforts_along(&independent_axes, &rates, &mut Substitution::new(&[]))
        };
        // Along a drive, too, the forces must do the work of the potential. A drive may turn about the axis of a joint,
        // so that no forces of the joints tell the two apart.
        let with_time = self.time().map(|time| own.iter().copied().chain([time]).collect::<Vec<_>>());
        let found = match with_time.and_then(|motions| along(&motions)).or_else(|| along(&own)) {
            Some(found) => Some(found),
            None => {
                let rates = self.q_dot().into_iter().zip(self.kinematic_equations.rates.iter().copied());
                let mut to_speeds = Substitution::new(&rates.collect::<Vec<_>>());
                let axes = relative
                    .potential_force_axes(self.speeds.len(), |velocity| relative.permitted_velocities(velocity));
                axes.and_then(|independent_axes| self.efforts_along(&independent_axes, &self.u(), &mut to_speeds))
            }
        };
        if let Some((arena, efforts)) = found {
            self.arena = arena;
            self.efforts = efforts;
        }
    }

    /// Solves Rᵀ w = −∂V/∂q for the forces and torques w along the given axes. `put` replaces q̇ by terms in u if the
    /// `variables` are speeds. `None` if there is no solution.
    fn efforts_along(
        &self,
        axes: &[Axis],
        variables: &[Expr],
        put: &mut Substitution,
    ) -> Option<(Arena, Vec<PotentialForce>)> {
        let mut arena = self.arena.clone();
        let mut simplifier = Simplifier::default();
        let rates: Vec<(Expr, Expr)> = self.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut frames = Frames::new(&self.frames);
        let mut d_dt = Differential::along(&rates);
        let motion = Motion::new(&mut arena, &mut frames, &self.frames, &self.points, &mut d_dt);
        let mut along = Gradient::new(variables);
        let mut slopes = |arena: &mut Arena, e: Expr| {
            let e = put.apply(arena, e);
            let mut list = vec![Expr::ZERO; variables.len()];
            for (at, slope) in along.apply(arena, e).iter() {
                list[*at] = simplifier.simplify(arena, *slope);
            }
            list
        };
        let mut columns = Vec::new();
        for (kind, frame, axis) in axes {
            let velocity = self.relative_velocity(&mut arena, &mut frames, &motion, *kind);
            let component = frames.component(&mut arena, &velocity, *frame, *axis);
            columns.push(slopes(&mut arena, component));
        }
        let with_time = self.time().is_some_and(|time| variables.contains(&self.coordinates[time].rate));
        let power = self.potential_power(&mut arena, with_time);
        let right: Vec<Vec<Expr>> = slopes(&mut arena, power).into_iter().map(|e| vec![e]).collect();
        let matrix: Vec<Vec<Expr>> =
            (0..variables.len()).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
        let (sizes, _) = solve_linear(&mut arena, &mut simplifier, &matrix, &right).ok()?;
        let mut efforts = Vec::new();
        for ((kind, frame, axis), size) in axes.iter().zip(sizes) {
            if zero_test(&arena, size[0]) != ZeroTest::Zero {
                let mut vector = [Expr::ZERO; 3];
                vector[*axis] = size[0];
                efforts.push(PotentialForce { kind: *kind, frame: *frame, vector });
            }
        }
        Some((arena, efforts))
    }

    /// Power of the forces of all potentials, W, as a term: −∂V/∂q · q̇ and, with time, what they do along a drive.
    fn potential_power(&self, arena: &mut Arena, with_time: bool) -> Expr {
        let energies: Vec<Expr> = self.potentials.iter().map(|potential| potential.energy).collect();
        let energy = arena.sum(&energies);
        let time = self.time();
        let own = self.coordinates.iter().enumerate().filter(|(at, _)| with_time || Some(*at) != time);
        let rates: Vec<(Expr, Expr)> = own.map(|(_, c)| (c.symbol, c.rate)).collect();
        let growth = Differential::along(&rates).apply(arena, energy);
        let explicit: Vec<Expr> = self.potentials.iter().map(|potential| potential.explicit_rate).collect();
        let explicit = arena.sum(&explicit);
        match time.filter(|_| with_time) {
            Some(time) => {
                let explicit = arena.mul(explicit, self.coordinates[time].rate);
                arena.sub(explicit, growth)
            }
            None => arena.neg(growth),
        }
    }

    /// Velocity at which a reaction does work: velocity of the body on which the reaction acts, relative to the body
    /// on which its opposite acts. For a torque it is the relative angular velocity.
    pub(in crate::model) fn relative_velocity(
        &self,
        arena: &mut Arena,
        frames: &mut Frames,
        motion: &Motion,
        kind: ReactionKind,
    ) -> Vector {
        let mut material = |arena: &mut Arena, ForcePlace { body, point }: ForcePlace| {
            let body = &self.bodies[body];
            match &body.rigid {
                Some((frame, _)) => motion.of_material(arena, frames, *frame, body.centre, point),
                None => motion.linear[body.centre].clone(),
            }
        };
        let turning =
            |body: usize| motion.angular[self.bodies[body].rigid.as_ref().map_or(0, |(frame, _)| *frame)].clone();
        let (velocity, opposite) = match kind {
            ReactionKind::Force { on, against } => (material(arena, on), against.map(|place| material(arena, place))),
            ReactionKind::Torque { on, against } => (turning(on), against.map(turning)),
        };
        opposite.map_or(velocity.clone(), |opposite| {
            let back = opposite.neg(arena);
            velocity.add(arena, &back)
        })
    }
}

impl RelativeMotion<'_> {
    /// Finds `count` axes along which the relative velocities of bodies are independent. Axes whose velocities depend
    /// on the fewest variables are preferred. `listed` converts velocities per q̇ into velocities per variable.
    /// `None` if there are not enough axes.
    fn potential_force_axes(
        &self,
        count: usize,
        listed: impl Fn(&dyn Fn(usize) -> VectorResidues) -> Vec<VectorResidues>,
    ) -> Option<Vec<Axis>> {
        let mut candidates: Vec<(usize, Vec<u64>, Axis)> = Vec::new();
        for BodyPair { body, against: holder } in self.supported_pairs() {
            for (kind, velocities) in self.support_reactions(body, holder, &listed) {
                for frame in self.frames(body, holder) {
                    for axis in 0..3 {
                        let direction = self.drawn.frames[frame].axes[axis];
                        let row: Vec<u64> = velocities.iter().map(|v| self.drawn.space.dot(*v, direction)).collect();
                        let changing = row.iter().filter(|x| **x != 0).count();
                        candidates.push((changing, row, (kind, frame, axis)));
                    }
                }
            }
        }
        candidates.sort_by_key(|(changing, ..)| *changing);
        let mut basis = Basis::new(self.drawn.space.0);
        candidates.retain(|(_, row, _)| basis.len() < count && basis.add_row(row.clone()).is_some());
        (basis.len() == count).then(|| candidates.into_iter().map(|(.., axis)| axis).collect())
    }

    /// Force and torque that may act between a body and its support, each with the relative velocities
    /// at which it does work.
    fn support_reactions(
        &self,
        body: usize,
        holder: Holder,
        listed: &impl Fn(&dyn Fn(usize) -> VectorResidues) -> Vec<VectorResidues>,
    ) -> Vec<(ReactionKind, Vec<VectorResidues>)> {
        let space = self.drawn.space;
        let mut list = Vec::new();
        if self.is_rigid(Some(body)) {
            // A particle takes no torque, so the opposite torque acts on the ground.
            let against = holder.filter(|_| self.is_rigid(holder));
            let turns = |along: usize| {
                space.sub(self.angular_velocity(Some(body), along), self.angular_velocity(against, along))
            };
            list.push((ReactionKind::Torque { on: body, against }, listed(&turns)));
        }
        let point = self.least_moving_point(body, holder);
        let against = holder.map(|body| ForcePlace { body, point });
        let slips = |along: usize| {
            space.sub(self.material_velocity(Some(body), point, along), self.material_velocity(holder, point, along))
        };
        list.push((ReactionKind::Force { on: ForcePlace { body, point }, against }, listed(&slips)));
        list
    }
}
