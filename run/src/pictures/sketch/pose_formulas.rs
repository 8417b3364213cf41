//! Formulas for the rotations of the frames and the positions of the points. They show which angle or length
//! a coordinate is.

use crate::code::compile_tape;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::pictures::view::FrameTree;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;

/// Relative difference below which two numbers count as equal.
const SAME: f64 = 1e-9;

/// Formulas that place the frames and points of a mechanism, compiled for evaluation.
pub struct PoseFormulas {
    /// Program that evaluates all formulas from parameters and coordinates.
    tape: Tape,
    /// Parents of the frames and points, with the formulas that place them.
    pub links: FrameTree,
    /// Index of the first formula of each frame.
    frames: Vec<usize>,
    /// Index of the first formula of each point.
    points: Vec<usize>,
}

/// Formula that equals ± a coordinate plus a rest that does not depend on this coordinate.
#[derive(Clone, Copy, Debug)]
pub struct SignedCoordinate {
    /// Index of the generalized coordinate in the formula.
    pub coordinate: usize,
    /// Factor of the coordinate in the formula, 1 or −1.
    pub sign: f64,
    /// Value of the formula at the value 0 of the coordinate, rad or m.
    pub zero: f64,
    /// Value of the formula in the drawn pose, rad or m.
    pub now: f64,
}

/// Rotation of a frame about one axis of its parent frame.
pub struct FrameTurn {
    /// Index of the parent frame. The frame is turned about an axis of it.
    pub parent: usize,
    /// Index of the axis of rotation in the parent frame, from 0 to 2.
    pub axis: usize,
    /// Index of the formula for the angle, rad, among all formulas.
    pub term: usize,
}

/// Vector from one point to another, in components of a frame.
#[derive(Default)]
pub struct Components {
    /// Index of the point from which the vector is measured.
    pub from: usize,
    /// Index of the frame in which the vector has its components.
    pub frame: usize,
    /// Index of the formula for the first component. The other two components follow.
    pub first: usize,
}

impl PoseFormulas {
    /// Compiles the formulas that place the frames and points of a mechanism.
    ///
    /// # Errors
    /// [`Error::Request`] if a place depends on a symbol that is neither a parameter nor a coordinate. No
    /// model that could be loaded has such a place.
    pub fn new(mechanism: &Mechanism) -> Result<Self, Error> {
        let links = FrameTree::of(mechanism);
        let inputs = [mechanism.p(), mechanism.q()].concat();
        let tape = compile_tape(&mechanism.arena, &inputs, &links.values, "the place of a frame or point")?;
        let mut next = 0;
        let mut offset = |count: usize| {
            next += count;
            next - count
        };
        let frames = links.frames.iter().map(|frame| match frame {
            None => offset(0),
            Some((_, Some(_))) => offset(1),
            Some((_, None)) => offset(9),
        });
        let frames = frames.collect();
        let points = links.points.iter().map(|point| offset(if point.is_some() { 3 } else { 0 })).collect();
        Ok(Self { tape, links, frames, points })
    }

    /// Rotation of a frame about one axis. `None` for a frame that is given by nine cosines, and for the
    /// inertial frame.
    pub fn turn(&self, frame: usize) -> Option<FrameTurn> {
        let (parent, axis) = self.links.frames[frame]?;
        Some(FrameTurn { parent, axis: axis?, term: self.frames[frame] })
    }

    /// Components of the vector to a point; `None` for the origin of the inertial frame.
    pub fn components(&self, point: usize) -> Option<Components> {
        let (from, frame) = self.links.points[point]?;
        Some(Components { from, frame, first: self.points[point] })
    }

    /// True if the formula with the index `term` contains a coordinate.
    pub fn mentions(&self, mechanism: &Mechanism, term: usize, coordinate: usize) -> bool {
        mechanism.arena.mentions(self.links.values[term], mechanism.coordinates[coordinate].symbol)
    }

    /// True if the rotation of a frame from its parent depends on a coordinate.
    pub fn turns_by(&self, mechanism: &Mechanism, frame: usize, coordinate: usize) -> bool {
        let count = match self.links.frames[frame] {
            None => 0,
            Some((_, Some(_))) => 1,
            Some((_, None)) => 9,
        };
        (self.frames[frame]..self.frames[frame] + count).any(|term| self.mentions(mechanism, term, coordinate))
    }

    /// Values of all formulas at the parameters `p` and the coordinates `q`.
    pub fn values(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        self.tape.evaluate(&[p, q].concat())
    }

    /// Reads a coordinate, with its sign, from the formula with the index `term`. `None` unless the formula
    /// equals ± the coordinate plus a rest that does not depend on the coordinate.
    pub fn signed_coordinate(
        &self,
        mechanism: &Mechanism,
        p: &[f64],
        q: &[f64],
        term: usize,
        coordinate: usize,
    ) -> Option<SignedCoordinate> {
        if self.links.values[term] == Expr::ZERO || !self.mentions(mechanism, term, coordinate) {
            return None;
        }
        let at = |value: f64| {
            let mut moved = q.to_vec();
            moved[coordinate] = value;
            self.values(p, &moved)[term]
        };
        let (zero, one, other, now) = (at(0.0), at(1.0), at(-2.5), at(q[coordinate]));
        let sign = (one - zero).round();
        let is_straight = |value: f64, of: f64| (of - zero - sign * value).abs() <= SAME * (1.0 + of.abs());
        ((sign.abs() - 1.0).abs() < 0.5 && is_straight(1.0, one) && is_straight(-2.5, other))
            .then_some(SignedCoordinate { coordinate, sign, zero, now })
    }
}
