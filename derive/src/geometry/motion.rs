//! Motion of frames and points: their positions, angular velocities and velocities in the inertial
//! frame.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §§ 2.4 (addition theorem), 2.7, 2.8 (points
//! fixed on a body, and moving on it).

use super::frames::Frames;
use super::vector::Vector;
use super::{Frame, Placement, Point};
use crate::algebra::Arena;
use crate::algebra::term::calculus::Differential;

/// Positions of all points, and velocities of all frames and points relative to the inertial frame.
pub struct Motion {
    /// Position p_OP of each point from the origin of the inertial frame, m, by index of the point.
    pub positions: Vec<Vector>,
    /// Angular velocity ω of each frame in the inertial frame, rad/s, by index of the frame.
    pub angular: Vec<Vector>,
    /// Velocity v of each point in the inertial frame, m/s, by index of the point.
    pub linear: Vec<Vector>,
}

impl Motion {
    /// Computes positions and velocities. `rates` is the time derivative: it has the rate of each
    /// coordinate and of each other quantity that varies.
    #[must_use]
    pub fn new(
        arena: &mut Arena,
        frames: &mut Frames,
        tree: &[Frame],
        points: &[Point],
        rates: &mut Differential,
    ) -> Self {
        let angular = angular_velocities(arena, tree, rates);
        let (positions, linear) = linear_velocities(arena, frames, points, &angular, rates);
        Self { positions, angular, linear }
    }

    /// Velocity in the inertial frame, m/s, of the body's material at `point`: v_C + ω × p_CP. The
    /// body rotates with `frame`, and the point C, `centre`, is fixed in the body.
    pub fn of_material(
        &self,
        arena: &mut Arena,
        frames: &mut Frames,
        frame: usize,
        centre: usize,
        point: usize,
    ) -> Vector {
        let back = self.positions[centre].neg(arena);
        let arm = self.positions[point].add(arena, &back);
        let turning = frames.cross(arena, &self.angular[frame], &arm);
        self.linear[centre].add(arena, &turning)
    }
}

/// Angular velocity ω of each frame in the inertial frame, rad/s, by index of the frame. `rates` is
/// the time derivative: it has the rate of each coordinate and of each other quantity that varies.
#[must_use]
pub fn angular_velocities(arena: &mut Arena, tree: &[Frame], rates: &mut Differential) -> Vec<Vector> {
    let mut angular: Vec<Vector> = Vec::new();
    for (at, frame) in tree.iter().enumerate() {
        let Some((parent, turn)) = &frame.rotation else {
            angular.push(Vector::default());
            continue;
        };
        // Addition theorem: ω_F = ω_parent + ω of frame F in its parent frame, with components in
        // F.
        let own = turn.spin(arena, rates);
        let total = angular[*parent].add(arena, &Vector::in_frame(at, own));
        angular.push(total);
    }
    angular
}

/// Positions of all points from the origin, m, and their velocities in the inertial frame, m/s, as
/// (positions, velocities). Both lists are by index of the point. `rates` is the time derivative:
/// it has the rate of each coordinate and of each other quantity that varies.
#[must_use]
pub fn linear_velocities(
    arena: &mut Arena,
    frames: &mut Frames,
    points: &[Point],
    angular: &[Vector],
    rates: &mut Differential,
) -> (Vec<Vector>, Vec<Vector>) {
    let (mut positions, mut linear): (Vec<Vector>, Vec<Vector>) = (Vec::new(), Vec::new());
    for point in points {
        let Some(Placement { parent, frame, components }) = point.position else {
            positions.push(Vector::default());
            linear.push(Vector::default());
            continue;
        };
        let step = Vector::in_frame(frame, components);
        let moving = frames.time_derivative(arena, &step, angular, rates);
        let position = positions[parent].add(arena, &step);
        let velocity = linear[parent].add(arena, &moving);
        positions.push(position);
        linear.push(velocity);
    }
    (positions, linear)
}
