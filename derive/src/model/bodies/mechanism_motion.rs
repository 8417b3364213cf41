//! Motion of the frames and points of a model file: positions and velocities as terms in coordinates q and rates q̇.

use super::elements::Elements;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Differential;
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Frames, Motion, Vector};
use crate::model::velocities::NamedVelocity;
use crate::model::{Coordinate, ForcePlace};

/// Positions and velocities of the frames and points of a mechanism, as terms in coordinates q and rates q̇.
pub struct MechanismMotion {
    /// Tree of frames, with their rotation matrices.
    frames: Frames,
    /// Positions and velocities of all frames and points.
    motion: Motion,
    /// Operator of the time derivative, which replaces each coordinate's derivative by its rate q̇.
    rates: Differential,
    /// Simplifier of the computed terms.
    simplifier: Simplifier,
}

impl MechanismMotion {
    /// Computes the motion of frames and points. The elements must have been read without errors.
    pub fn new(arena: &mut Arena, elements: &Elements, coordinates: &[Coordinate]) -> Self {
        let rates: Vec<_> = coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut rates = Differential::along(&rates);
        let mut frames = Frames::new(&elements.frames);
        let motion = Motion::new(arena, &mut frames, &elements.frames, &elements.points, &mut rates);
        Self { frames, motion, rates, simplifier: Simplifier::default() }
    }

    /// Component of a velocity or position that occurs by name in a formula. The result is a simplified term in q and
    /// q̇.
    pub fn named_component(&mut self, arena: &mut Arena, elements: &Elements, name: &NamedVelocity) -> Expr {
        let vector = match name.of {
            VelocityOf::Material(body, point) => self.material_velocity(arena, elements, body, point),
            VelocityOf::Point(point) => self.motion.linear[point].clone(),
            VelocityOf::Turning(frame) => self.motion.angular[frame].clone(),
            VelocityOf::Place(point) => self.motion.positions[point].clone(),
        };
        self.component(arena, &vector, name.frame, name.axis)
    }

    /// Component of a vector along the axis 0, 1 or 2 of a frame, simplified.
    pub fn component(&mut self, arena: &mut Arena, vector: &Vector, frame: usize, axis: usize) -> Expr {
        let component = self.frames.component(arena, vector, frame, axis);
        self.simplifier.simplify(arena, component)
    }

    /// Velocity in the inertial frame, m/s, of that material of a body which is at a point.
    pub fn material_velocity(&mut self, arena: &mut Arena, elements: &Elements, body: usize, point: usize) -> Vector {
        let body = &elements.bodies[body];
        match &body.rigid {
            Some((frame, _)) => self.motion.of_material(arena, &mut self.frames, *frame, body.centre, point),
            None => self.motion.linear[body.centre].clone(),
        }
    }

    /// Angular velocity of a frame relative to the inertial frame, rad/s.
    pub fn angular_velocity(&self, frame: usize) -> Vector {
        self.motion.angular[frame].clone()
    }

    /// Vector from one point to another, m, as a function of the coordinates q.
    pub fn vector_between_points(&self, arena: &mut Arena, from: usize, to: usize) -> Vector {
        let back = self.motion.positions[from].neg(arena);
        self.motion.positions[to].add(arena, &back)
    }

    /// Square |v|² of the length of a vector v, simplified.
    pub fn square(&mut self, arena: &mut Arena, vector: &Vector) -> Expr {
        let square = self.frames.dot(arena, vector, vector);
        self.simplifier.simplify(arena, square)
    }

    /// Time derivative of a term in coordinates q, as a simplified term in q and q̇.
    pub fn rate(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let rate = self.rates.apply(arena, e);
        self.simplifier.simplify(arena, rate)
    }

    /// True if the same material of the body always is at the point. If not, the power of a force there is not the
    /// force times the velocity of the point.
    pub fn is_material_point(
        &mut self,
        arena: &mut Arena,
        elements: &Elements,
        ForcePlace { body, point }: ForcePlace,
    ) -> bool {
        let back = self.motion.linear[point].neg(arena);
        let slip = self.material_velocity(arena, elements, body, point).add(arena, &back);
        let components = self.frames.express(arena, &slip, 0);
        components.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero)
    }
}
