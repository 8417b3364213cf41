//! What is sketched, from where, and what is on the sheet so far.

use super::camera::Camera;
use super::drawing::{Mark, Role, Spot, Word};
use super::place::Wish;
use super::terms::Terms;
use crate::mechanism::Mechanism;
use crate::view::space::{about, length, minus, product, rotated};
use crate::view::{Pose, Poses, Rotation, Triple, View};

/// A mechanism in one pose, as it is looked at.
pub struct Subject<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// How its frames turn and its points are placed.
    pub terms: &'a Terms,
    /// What gives its poses.
    pub poses: &'a Poses,
    /// Parameters.
    pub p: &'a [f64],
    /// Coordinates.
    pub q: &'a [f64],
    /// Where everything is.
    pub pose: &'a Pose,
    /// Poses far from it and from one another: what rests in all of them rests.
    pub far: &'a [Pose],
    /// What it looks like.
    pub view: &'a View,
    /// From where it is looked at.
    pub camera: Camera,
    /// Whether it moves in a plane, and is seen along its normal.
    pub is_planar: bool,
}

/// What is on the sheet.
#[derive(Default)]
pub struct Sheet {
    /// Lines, from behind to before.
    pub marks: Vec<Mark>,
    /// Labels to be placed, those that need their places most first.
    pub wishes: Vec<Wish>,
}

impl Subject<'_> {
    /// Where a point of the model is on the sheet.
    pub fn spot(&self, point: usize) -> Spot {
        self.camera.spot(self.pose.points[point])
    }

    /// Whether nothing moves a point.
    pub fn is_fixed(&self, point: usize) -> bool {
        let here = self.pose.points[point];
        self.far.iter().all(|pose| length(minus(pose.points[point], here)) <= 1e-9 * self.view.size)
    }

    /// Whether two points are at one place, in this pose.
    pub fn is_same(&self, a: usize, b: usize) -> bool {
        length(minus(self.pose.points[a], self.pose.points[b])) <= 1e-7 * self.view.size
    }

    /// The body that a joint carries, if the frame is its own and named after it, as the file does not.
    fn named_after(&self, frame: usize) -> Option<&str> {
        let carried = self.mechanism.hung.iter().map(|hung| &self.mechanism.bodies[hung.body]);
        let mut own = carried.filter(|body| body.rigid.as_ref().is_some_and(|rigid| rigid.0 == frame));
        let name = &self.mechanism.frames[frame].name;
        own.find(|body| *name == format!("{}_frame", body.name)).map(|body| body.name.as_str())
    }

    /// Whether a frame has its name from a body that a joint carries.
    pub fn is_generated(&self, frame: usize) -> bool {
        self.named_after(frame).is_some()
    }

    /// An axis of a frame, by the name of the body where the frame has its own from that.
    pub fn basis(&self, frame: usize, axis: usize) -> Word {
        let name = self.named_after(frame).unwrap_or(&self.mechanism.frames[frame].name);
        Word::Basis(name.to_owned(), axis)
    }

    /// Whether a point has its name from a joint: the mass centre of the body that it carries, or the end of the loop that it closes.
    pub fn is_of_joint(&self, point: usize) -> bool {
        let name = &self.mechanism.points[point].name;
        let carried = self.mechanism.hung.iter().map(|hung| &self.mechanism.bodies[hung.body]);
        let is_centre =
            carried.filter(|body| body.centre == point).any(|body| *name == format!("{}_centre", body.name));
        is_centre || self.mechanism.points.iter().any(|joint| *name == format!("{}_closed", joint.name))
    }

    /// The frames that a frame is turned from, itself first.
    pub fn chain(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(frame), |at| Some(self.terms.links.frames[*at]?.0))
    }

    /// A direction that is told in a frame as if its turn about an axis from its parent were this angle.
    pub fn turned(&self, (parent, axis): (usize, usize), angle: f64, direction: Triple) -> Triple {
        let rotation: Rotation = product(&self.pose.rotations[parent], &about(axis, angle));
        rotated(&rotation, direction)
    }
}

impl Sheet {
    /// Adds marks before those that are there.
    pub fn add(&mut self, marks: impl IntoIterator<Item = Mark>) {
        self.marks.extend(marks);
    }

    /// Asks for a label that must be there.
    pub fn name(&mut self, role: Role, words: Vec<Word>, anchor: Spot, towards: Option<Spot>, gap: f64) {
        self.wishes.push(Wish { role, words, anchor, towards, gap, is_needed: true });
    }

    /// Asks for a label that is there if there is room.
    pub fn may_name(&mut self, role: Role, words: Vec<Word>, anchor: Spot, towards: Option<Spot>, gap: f64) {
        self.wishes.push(Wish { role, words, anchor, towards, gap, is_needed: false });
    }
}
