//! Poses of a mechanism: the orientation of every frame and the position of every point in a configuration.

use super::space::{
    IDENTITY, Rotation, Triple, add_scaled_vector, product, rotate_vector, rotation_about_axis, transpose,
};
use crate::code::compile_tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::model::Turn;

/// Parameters and coordinates that determine a pose.
#[derive(Clone, Copy, Debug)]
pub struct Configuration<'a> {
    /// Values of the parameters, in the order of the model.
    pub parameters: &'a [f64],
    /// Values of the coordinates, in the order of the model.
    pub q: &'a [f64],
}

/// Orientations of frames and positions of points at one instant, relative to the inertial frame and its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Rotation matrix of each frame of the model. It converts components in this frame to components in the
    /// inertial frame.
    pub rotations: Vec<Rotation>,
    /// Position of each point of the model in the inertial frame, m.
    pub points: Vec<Triple>,
}

impl Pose {
    /// True if every frame and point of the pose has finite values. Values may be missing if a run ends in a
    /// state in which a formula has no value.
    pub(in crate::pictures) fn is_finite(&self) -> bool {
        self.points.iter().flatten().chain(self.rotations.iter().flatten().flatten()).all(|x| x.is_finite())
    }
}

/// Tree of the frames and points of a model, with the formulas that place each of them relative to its
/// parent. Formulas are not multiplied out. So the cost of a long chain is the sum of the costs of its
/// links.
#[derive(Clone, Debug)]
pub struct FrameTree {
    /// Formulas in parameters and coordinates: first the formulas of the frames, then those of the points, in
    /// the order of the model.
    pub values: Vec<Expr>,
    /// Parent of each frame, and the index of its axis of rotation; `None` for the inertial frame. A frame with
    /// an axis has one formula, the angle. A frame without an axis has nine formulas, its cosines row by row.
    pub frames: Vec<Option<(usize, Option<usize>)>>,
    /// Parent of each point, and the frame of its three position components; `None` for the origin of the
    /// inertial frame.
    pub points: Vec<Option<(usize, usize)>>,
}

impl FrameTree {
    /// Collects the parents and formulas of the frames and points of a model.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let mut values: Vec<Expr> = Vec::new();
        let mut frames = Vec::with_capacity(model.frames.len());
        for frame in &model.frames {
            frames.push(frame.rotation.as_ref().map(|(parent, turn)| match turn {
                Turn::About(axis, angle) => {
                    values.push(*angle);
                    (*parent, Some(*axis))
                }
                Turn::Oriented(turn) => {
                    values.extend(turn.cosines.iter().flatten());
                    (*parent, None)
                }
            }));
        }
        let mut points = Vec::with_capacity(model.points.len());
        for point in &model.points {
            points.push(point.position.map(|placement| {
                values.extend(placement.components);
                (placement.parent, placement.frame)
            }));
        }
        Self { values, frames, points }
    }
}

/// Compiled function that computes the poses of a model from parameters and coordinates.
#[derive(Clone)]
pub struct Poses {
    /// Program that computes all formulas for the places of frames and points.
    tape: Tape,
    /// Parents of the frames and points, in the order of the formulas.
    links: FrameTree,
}

impl Poses {
    /// Compiles the poses of a model.
    ///
    /// # Errors
    /// [`Error::Request`] if a place depends on a symbol that is neither a parameter nor a coordinate. No model that
    /// could be loaded has such a place.
    pub fn new(model: &Model) -> Result<Self, Error> {
        let links = FrameTree::of(model);
        let inputs = [model.p(), model.q()].concat();
        Ok(Self { tape: compile_tape(&model.arena, &inputs, &links.values, "the place of a frame or point")?, links })
    }

    /// Computes the pose at the parameters `p` and the coordinates `q`, both in the order of the model.
    #[must_use]
    pub fn pose_at(&self, p: &[f64], q: &[f64]) -> Pose {
        let mut values = self.tape.evaluate(&[p, q].concat()).into_iter();
        let mut next = || values.next().unwrap_or(f64::NAN);
        let mut rotations: Vec<Rotation> = Vec::with_capacity(self.links.frames.len());
        for frame in &self.links.frames {
            rotations.push(match frame {
                None => IDENTITY,
                Some((parent, Some(axis))) => product(&rotations[*parent], &rotation_about_axis(*axis, next())),
                Some((parent, None)) => {
                    let cosines = [(); 3].map(|()| [(); 3].map(|()| next()));
                    product(&rotations[*parent], &transpose(&cosines))
                }
            });
        }
        let mut points: Vec<Triple> = Vec::with_capacity(self.links.points.len());
        for point in &self.links.points {
            points.push(match point {
                None => [0.0; 3],
                Some((parent, frame)) => {
                    let components = [(); 3].map(|()| next());
                    add_scaled_vector(points[*parent], 1.0, rotate_vector(&rotations[*frame], components))
                }
            });
        }
        Pose { rotations, points }
    }
}
