//! Subject of a sketch: the mechanism in its drawn pose, and the camera.

use super::camera::Camera;
use super::drawing_elements::{DrawingPoint, LabelWord};
use super::pose_formulas::PoseFormulas;
use crate::mechanism::Mechanism;
use crate::pictures::view::space::{length, product, rotate_vector, rotation_about_axis, subtract_vectors};
use crate::pictures::view::{Pose, Poses, Rotation, Triple, View};
use tripos_derive::algebra::Expr;

/// Mechanism in the drawn pose, and the camera of its sketch.
pub struct SketchSubject<'a> {
    /// Mechanism that is drawn.
    pub mechanism: &'a Mechanism,
    /// Formulas for the rotations of frames and the positions of points.
    pub terms: &'a PoseFormulas,
    /// Compiled functions that compute poses from parameters and coordinates.
    pub poses: &'a Poses,
    /// Values of the parameters, in the order of the model.
    pub p: &'a [f64],
    /// Values of the coordinates in the drawn pose, in the order of the model.
    pub q: &'a [f64],
    /// Orientations of the frames and positions of the points in the drawn pose.
    pub pose: &'a Pose,
    /// Poses far from the drawn pose and from one another. A point at the same place in all of them is
    /// fixed.
    pub far: &'a [Pose],
    /// Solids of the mechanism, its size and its up direction.
    pub view: &'a View,
    /// Projection of the mechanism onto the sheet.
    pub camera: Camera,
    /// True if the mechanism moves in a plane and is seen along the normal of this plane.
    pub is_planar: bool,
}

impl SketchSubject<'_> {
    /// True if the mechanism has gravity whose acceleration is not zero.
    pub fn has_gravity(&self) -> bool {
        let gravity = self.mechanism.gravity.as_ref();
        gravity.is_some_and(|gravity| gravity.acceleration.iter().any(|e| *e != Expr::ZERO))
    }

    /// Point of the sheet, px, where a point of the model is drawn.
    pub fn spot(&self, point: usize) -> DrawingPoint {
        self.camera.project_point(self.pose.points[point])
    }

    /// True if no coordinate moves the point, so that it has the same place in all poses.
    pub fn is_fixed(&self, point: usize) -> bool {
        let here = self.pose.points[point];
        self.far.iter().all(|pose| length(subtract_vectors(pose.points[point], here)) <= 1e-9 * self.view.size)
    }

    /// True if the points with the indices `a` and `b` are at the same place in the drawn pose.
    pub fn points_coincide(&self, a: usize, b: usize) -> bool {
        length(subtract_vectors(self.pose.points[a], self.pose.points[b])) <= 1e-7 * self.view.size
    }

    /// Name of the body that gave a frame its name. The program names a frame after a body if a joint of the
    /// model file gives the body this frame. `None` for any other frame.
    fn body_named_after(&self, frame: usize) -> Option<&str> {
        let carried = self.mechanism.carried.iter().map(|joint| &self.mechanism.bodies[joint.body]);
        let mut own = carried.filter(|body| body.rigid.as_ref().is_some_and(|rigid| rigid.0 == frame));
        let name = &self.mechanism.frames[frame].name;
        own.find(|body| *name == format!("{}_frame", body.name)).map(|body| body.name.as_str())
    }

    /// True if the program named the frame after a body, because the model file attaches the body by a joint.
    pub fn is_generated(&self, frame: usize) -> bool {
        self.body_named_after(frame).is_some()
    }

    /// Basis vector of a frame, as a word of a label. A frame that the program named after a body gets the
    /// name of this body.
    pub fn basis(&self, frame: usize, axis: usize) -> LabelWord {
        let name = self.body_named_after(frame).unwrap_or(&self.mechanism.frames[frame].name);
        LabelWord::Basis(name.to_owned(), axis)
    }

    /// True if the program named the point after a joint. Such a point is the mass centre of a body, or the
    /// closing end of a loop.
    pub fn is_named_after_joint(&self, point: usize) -> bool {
        let name = &self.mechanism.points[point].name;
        let carried = self.mechanism.carried.iter().map(|joint| &self.mechanism.bodies[joint.body]);
        let is_centre =
            carried.filter(|body| body.centre == point).any(|body| *name == format!("{}_centre", body.name));
        is_centre || self.mechanism.points.iter().any(|joint| *name == format!("{}_closed", joint.name))
    }

    /// Indices of the frames from a frame up to the inertial frame: the frame itself, its parent, and so on.
    pub fn frame_and_parents(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(frame), |at| Some(self.terms.links.frames[*at]?.0))
    }

    /// Rotates a vector that is fixed in a frame, if the frame is turned by `angle`, rad, from its parent.
    /// `axis` is the index of the axis of rotation. `direction` has components in the turned frame. The result
    /// has components in the inertial frame.
    pub fn direction_after_rotation(&self, parent: usize, axis: usize, angle: f64, direction: Triple) -> Triple {
        let rotation: Rotation = product(&self.pose.rotations[parent], &rotation_about_axis(axis, angle));
        rotate_vector(&rotation, direction)
    }
}
