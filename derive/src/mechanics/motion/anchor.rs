//! Anchors of bodies: for each body, the point and the axes, fixed in it, to which its inertial parameters refer.
//!
//! The base parameters of textbooks refer to a point on the axis of the joint that carries a body, and to axes of which
//! one lies along the joint (W. Khalil & E. Dombre, *Modeling, Identification and Control of Robots* (2002), §§ 3.2,
//! 9.4). So an anchor is the point and the frame nearest to the ground that are still fixed in the body.

use super::inertial::Inertial;
use crate::algebra::Expr;
use crate::geometry::Turn;
use crate::model::Model;

/// A point and a frame, both fixed in a body.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// The body, by its place.
    pub body: usize,
    /// The point.
    pub point: usize,
    /// The frame of the axes.
    pub frame: usize,
    /// The axis of the joint that turns the frame, 0 to 2; 2 if there is no joint.
    pub axis: usize,
    /// The frame that turns with the body; `None` for a particle.
    pub(in crate::mechanics) turns: Option<usize>,
    /// The coordinates of the model.
    pub(in crate::mechanics) moved: Vec<Expr>,
}

impl Anchor {
    /// Finds the anchor of a body.
    pub(in crate::mechanics) fn of(model: &Model, body: usize) -> Self {
        let moved = model.q();
        let Some((own, _)) = &model.bodies[body].rigid else {
            let point = model.bodies[body].centre;
            let frame = model.points[point].position.map_or(0, |(_, frame, _)| frame);
            return Self { body, point, frame, axis: 2, turns: None, moved };
        };
        let frame = outermost(model, &moved, *own);
        let mut point = model.bodies[body].centre;
        while let Some((before, of, components)) = model.points[point].position {
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

    /// The inertial parameters of the body, in the order in which they are kept where several act as one. First those
    /// of the ten that the joint's axis leaves, then the moment along it, an inertia beside it, and the mass, as Khalil
    /// and Dombre group them.
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

/// True if these terms contain no coordinate.
fn is_fixed(model: &Model, moved: &[Expr], terms: &[Expr]) -> bool {
    let reached = model.arena.reachable(terms);
    !reached.iter().any(|part| moved.contains(part))
}

/// The frame nearest to the ground in which a frame is fixed.
fn outermost(model: &Model, moved: &[Expr], mut frame: usize) -> usize {
    while let Some((before, turn)) = &model.frames[frame].rotation {
        if !is_fixed(model, moved, &[turn.terms(), turn.quantities()].concat()) {
            break;
        }
        frame = *before;
    }
    frame
}
