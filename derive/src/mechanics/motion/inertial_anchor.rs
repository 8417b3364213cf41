//! Anchor of a body: the reference point and the axes of its inertial parameters, both fixed in the body.
//!
//! Base parameters of textbooks refer to a point on the axis of the joint that carries a body. One of their axes lies
//! along the joint (W. Khalil & E. Dombre, *Modeling, Identification and Control of Robots* (2002), §§ 3.2, 9.4). So
//! an anchor is the point and the frame nearest to the ground that are still fixed in the body.

use super::inertial_parameter::InertialParameter;
use crate::algebra::Expr;
use crate::geometry::{Placement, Turn};
use crate::model::Model;

/// Body-fixed point and frame to which the inertial parameters of a body refer.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// Index of the body in the model's list of bodies.
    pub body: usize,
    /// Index of the reference point, which is fixed in the body, in the model's list of points.
    pub point: usize,
    /// Index of the frame of the axes, which is fixed in the body, in the model's list of frames.
    pub frame: usize,
    /// Axis of `frame` about which the body's joint turns: 0, 1 or 2. It is 2 if there is no such joint.
    pub axis: usize,
    /// Index of the frame that turns with the body; `None` for a particle.
    pub(in crate::mechanics) turns: Option<usize>,
    /// Symbols of all generalized coordinates of the model. A term without them is constant.
    pub(in crate::mechanics) moved: Vec<Expr>,
}

impl Anchor {
    /// Finds the point and frame nearest to the ground that are fixed in a body.
    pub(in crate::mechanics) fn of(model: &Model, body: usize) -> Self {
        let moved = model.q();
        let Some((own, _)) = &model.bodies[body].rigid else {
            let point = model.bodies[body].centre;
            let frame = model.points[point].position.map_or(0, |placement| placement.frame);
            return Self { body, point, frame, axis: 2, turns: None, moved };
        };
        let frame = anchor_frame(model, &moved, *own);
        let mut point = model.bodies[body].centre;
        while let Some(Placement { parent: before, frame: of, components }) = model.points[point].position {
            if anchor_frame(model, &moved, of) != frame || !is_fixed_in_anchor(model, &moved, &components) {
                break;
            }
            point = before;
        }
        let axis = match &model.frames[frame].rotation {
            Some((_, Turn::About(axis, _))) => *axis,
            _ => 2,
        };
        Self { body, point, frame, axis, turns: Some(*own), moved }
    }

    /// Inertial parameters of the body, those first that base parameters should keep. The first are those that a
    /// revolute joint leaves identifiable, grouped as by Khalil and Dombre. Then come the first moment along the
    /// axis, one inertia and the mass. A particle has only its mass.
    #[must_use]
    pub fn parameters(&self) -> Vec<InertialParameter> {
        if self.turns.is_none() {
            return vec![InertialParameter::Mass];
        }
        let k = self.axis;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        vec![
            InertialParameter::Inertia(k, k),
            InertialParameter::Inertia(i, i),
            InertialParameter::Inertia(i, j),
            InertialParameter::Inertia(i, k),
            InertialParameter::Inertia(j, k),
            InertialParameter::FirstMoment(i),
            InertialParameter::FirstMoment(j),
            InertialParameter::FirstMoment(k),
            InertialParameter::Inertia(j, j),
            InertialParameter::Mass,
        ]
    }

    /// Inertial parameters of the body with second moments instead of moments of inertia, those first that base
    /// parameters should keep. A revolute joint leaves the second moments across its axis identifiable, and so they
    /// come first.
    #[must_use]
    pub fn parameters_with_second_moments(&self) -> Vec<InertialParameter> {
        let second = |parameter| match parameter {
            InertialParameter::Inertia(i, j) if i == j => InertialParameter::SecondMoment((i + 1) % 3),
            other => other,
        };
        self.parameters().into_iter().map(second).collect()
    }
}

/// True if the terms contain none of the coordinates in `moved`, so that they are constant.
fn is_fixed_in_anchor(model: &Model, moved: &[Expr], terms: &[Expr]) -> bool {
    let reached = model.arena.reachable(terms);
    !reached.iter().any(|part| moved.contains(part))
}

/// Index of the frame nearest to the ground that does not move relative to the given frame.
fn anchor_frame(model: &Model, moved: &[Expr], mut frame: usize) -> usize {
    while let Some((before, turn)) = &model.frames[frame].rotation {
        if !is_fixed_in_anchor(model, moved, &[turn.terms(), turn.quantities()].concat()) {
            break;
        }
        frame = *before;
    }
    frame
}
