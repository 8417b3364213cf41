//! Anchors of bodies: for each body, the body-fixed point and axes to which its inertial parameters refer.
//!
//! The base parameters of textbooks refer to a point on the axis of the joint that carries a body. One of their axes
//! lies along the joint (W. Khalil & E. Dombre, *Modeling, Identification and Control of Robots* (2002), §§ 3.2, 9.4).
//! So an anchor is the point and the frame nearest to the ground that are still fixed in the body.

use super::inertial::Inertial;
use crate::algebra::Expr;
use crate::geometry::{Placement, Turn};
use crate::model::Model;

/// Body-fixed point and frame to which the inertial parameters of a body refer.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// Index of the body in the model.
    pub body: usize,
    /// Index of the point in the model.
    pub point: usize,
    /// Index of the frame of the axes in the model.
    pub frame: usize,
    /// Axis of the joint that turns the frame, 0 to 2; 2 if there is no joint.
    pub axis: usize,
    /// Index of the frame that turns with the body; `None` for a particle.
    pub(in crate::mechanics) turns: Option<usize>,
    /// Symbols of the model's coordinates.
    pub(in crate::mechanics) moved: Vec<Expr>,
}

impl Anchor {
    /// Finds the anchor of a body.
    pub(in crate::mechanics) fn of(model: &Model, body: usize) -> Self {
        let moved = model.q();
        let Some((own, _)) = &model.bodies[body].rigid else {
            let point = model.bodies[body].centre;
            let frame = model.points[point].position.map_or(0, |placement| placement.frame);
            return Self { body, point, frame, axis: 2, turns: None, moved };
        };
        let frame = outermost(model, &moved, *own);
        let mut point = model.bodies[body].centre;
        while let Some(Placement { parent: before, frame: of, components }) = model.points[point].position {
            if outermost(model, &moved, of) != frame || !is_fixed(model, &moved, &components) {
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

    /// Inertial parameters of the body, in the order of preference in which base parameters keep them. First come those
    /// that remain of the ten beyond a revolute joint, grouped as by Khalil and Dombre. The moment along the axis, one
    /// inertia and the mass follow.
    pub(in crate::mechanics) fn parameters(&self) -> Vec<Inertial> {
        if self.turns.is_none() {
            return vec![Inertial::Mass];
        }
        let k = self.axis;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        vec![
            Inertial::Inertia(k, k),
            Inertial::Inertia(i, i),
            Inertial::Inertia(i, j),
            Inertial::Inertia(i, k),
            Inertial::Inertia(j, k),
            Inertial::FirstMoment(i),
            Inertial::FirstMoment(j),
            Inertial::FirstMoment(k),
            Inertial::Inertia(j, j),
            Inertial::Mass,
        ]
    }
}

/// True if the terms contain no coordinate.
fn is_fixed(model: &Model, moved: &[Expr], terms: &[Expr]) -> bool {
    let reached = model.arena.reachable(terms);
    !reached.iter().any(|part| moved.contains(part))
}

/// Frame nearest to the ground in which the given frame is fixed.
fn outermost(model: &Model, moved: &[Expr], mut frame: usize) -> usize {
    while let Some((before, turn)) = &model.frames[frame].rotation {
        if !is_fixed(model, moved, &[turn.terms(), turn.quantities()].concat()) {
            break;
        }
        frame = *before;
    }
    frame
}
