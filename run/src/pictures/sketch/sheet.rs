//! Mechanism and pose that are sketched, the camera, and the sheet with its marks.

use super::camera::Camera;
use super::drawing::{Mark, Role, SheetPoint, Word};
use super::place::Wish;
use super::terms::Terms;
use crate::mechanism::Mechanism;
use crate::pictures::view::space::{about, length, minus, product, rotated};
use crate::pictures::view::{Pose, Poses, Rotation, Triple, View};
use tripos_derive::algebra::Expr;

/// Mechanism in one pose, with the camera of its sketch.
pub struct Subject<'a> {
    /// Mechanism that is sketched.
    pub mechanism: &'a Mechanism,
    /// Turns of the mechanism's frames and positions of its points, as numbers.
    pub terms: &'a Terms,
    /// Poses of the mechanism's model, as a function of parameters and coordinates.
    pub poses: &'a Poses,
    /// Values of the parameters.
    pub p: &'a [f64],
    /// Values of the coordinates in the drawn pose.
    pub q: &'a [f64],
    /// Frames and points in the drawn pose.
    pub pose: &'a Pose,
    /// Poses far from the drawn one and from each other. A point that rests in all of them is fixed.
    pub far: &'a [Pose],
    /// Solids of the mechanism, its size and its up direction.
    pub view: &'a View,
    /// Projection of the mechanism onto the sheet.
    pub camera: Camera,
    /// True if the mechanism moves in a plane and is seen along the plane's normal.
    pub is_planar: bool,
}

/// Marks and wishes for labels on the sheet.
#[derive(Default)]
pub struct Sheet {
    /// Marks on the sheet, from back to front.
    pub marks: Vec<Mark>,
    /// Labels to be placed. Needed labels choose their places first, then the others in the order of the list.
    pub wishes: Vec<Wish>,
}

impl Subject<'_> {
    /// True if the mechanism has gravity whose acceleration is not zero.
    pub fn has_gravity(&self) -> bool {
        let gravity = self.mechanism.gravity.as_ref();
        gravity.is_some_and(|gravity| gravity.acceleration.iter().any(|e| *e != Expr::ZERO))
    }

    /// Spot of a point of the model on the sheet.
    pub fn spot(&self, point: usize) -> SheetPoint {
        self.camera.spot(self.pose.points[point])
    }

    /// True if no coordinate moves a point.
    pub fn is_fixed(&self, point: usize) -> bool {
        let here = self.pose.points[point];
        self.far.iter().all(|pose| length(minus(pose.points[point], here)) <= 1e-9 * self.view.size)
    }

    /// True if two points coincide in this pose.
    pub fn is_same(&self, a: usize, b: usize) -> bool {
        length(minus(self.pose.points[a], self.pose.points[b])) <= 1e-7 * self.view.size
    }

    /// Name of the body that a joint carries, if the frame belongs to that body and was named after it by the program.
    fn named_after(&self, frame: usize) -> Option<&str> {
        let carried = self.mechanism.carried.iter().map(|joint| &self.mechanism.bodies[joint.body]);
        let mut own = carried.filter(|body| body.rigid.as_ref().is_some_and(|rigid| rigid.0 == frame));
        let name = &self.mechanism.frames[frame].name;
        own.find(|body| *name == format!("{}_frame", body.name)).map(|body| body.name.as_str())
    }

    /// True if the program named a frame after a body that a joint carries.
    pub fn is_generated(&self, frame: usize) -> bool {
        self.named_after(frame).is_some()
    }

    /// Basis vector of a frame as a part of a label. If the frame is named after a body, it has the name of the body.
    pub fn basis(&self, frame: usize, axis: usize) -> Word {
        let name = self.named_after(frame).unwrap_or(&self.mechanism.frames[frame].name);
        Word::Basis(name.to_owned(), axis)
    }

    /// True if the program named a point after a joint: the mass centre of the carried body, or the end of the closed
    /// loop.
    pub fn is_of_joint(&self, point: usize) -> bool {
        let name = &self.mechanism.points[point].name;
        let carried = self.mechanism.carried.iter().map(|joint| &self.mechanism.bodies[joint.body]);
        let is_centre =
            carried.filter(|body| body.centre == point).any(|body| *name == format!("{}_centre", body.name));
        is_centre || self.mechanism.points.iter().any(|joint| *name == format!("{}_closed", joint.name))
    }

    /// Iterates over a frame and the frames that it is turned from, itself first.
    pub fn chain(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(frame), |at| Some(self.terms.links.frames[*at]?.0))
    }

    /// Direction in the inertial frame that a direction of a frame has if the frame is turned about an axis of its
    /// parent by an angle.
    pub fn turned(&self, parent: usize, axis: usize, angle: f64, direction: Triple) -> Triple {
        let rotation: Rotation = product(&self.pose.rotations[parent], &about(axis, angle));
        rotated(&rotation, direction)
    }
}

impl Sheet {
    /// Adds marks in front of those on the sheet.
    pub fn add(&mut self, marks: impl IntoIterator<Item = Mark>) {
        self.marks.extend(marks);
    }

    /// Requests a label that must be placed.
    pub fn name(&mut self, role: Role, words: Vec<Word>, anchor: SheetPoint, towards: Option<SheetPoint>, gap: f64) {
        self.wishes.push(Wish { role, words, anchor, towards, gap, is_needed: true });
    }

    /// Requests a label that is placed only if there is room.
    pub fn may_name(
        &mut self,
        role: Role,
        words: Vec<Word>,
        anchor: SheetPoint,
        towards: Option<SheetPoint>,
        gap: f64,
    ) {
        self.wishes.push(Wish { role, words, anchor, towards, gap, is_needed: false });
    }
}
