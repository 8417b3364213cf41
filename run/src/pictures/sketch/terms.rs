//! Turns of frames and positions of points as numbers. The angle or length that a coordinate is can be read from their
//! terms.

use crate::code::tape;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::pictures::view::Links;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::evaluate::Tape;

/// Relative difference below which two numbers count as equal.
const SAME: f64 = 1e-9;

/// Terms that give the frames and points of a mechanism, as a tape.
pub struct Terms {
    tape: Tape,
    /// Parents of the frames and points, with the terms that place them.
    pub links: Links,
    /// Index of the first term of each frame.
    frames: Vec<usize>,
    /// Index of the first term of each point.
    points: Vec<usize>,
}

/// A term that is a coordinate times 1 or -1, plus a rest that does not depend on the coordinate.
#[derive(Clone, Copy, Debug)]
pub struct SignedCoordinate {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// Factor of the coordinate, 1 or -1.
    pub sign: f64,
    /// Value of the term at coordinate 0.
    pub zero: f64,
    /// Value of the term in the present pose.
    pub now: f64,
}

/// Turn of a frame about a single axis of its parent.
pub struct Turn {
    /// Index of the parent frame.
    pub parent: usize,
    /// Index of the axis, from 0 to 2.
    pub axis: usize,
    /// Index of the term that is the angle.
    pub term: usize,
}

/// Vector to a point in components of a frame.
#[derive(Default)]
pub struct Components {
    /// Index of the point from which the vector is measured.
    pub from: usize,
    /// Index of the frame of the components.
    pub frame: usize,
    /// Index of the term that is the first of the three components.
    pub first: usize,
}

impl Terms {
    /// Compiles the terms of a mechanism.
    ///
    /// # Errors
    /// [`Error::Request`] if a place depends on a symbol other than parameters and coordinates. No loaded model has
    /// one.
    pub fn new(mechanism: &Mechanism) -> Result<Self, Error> {
        let links = Links::of(mechanism);
        let inputs = [mechanism.p(), mechanism.q()].concat();
        let tape = tape(&mechanism.arena, &inputs, &links.values, "the place of a frame or point")?;
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

    /// Turn of a frame about a single axis; `None` if the frame does not turn about a single axis.
    pub fn turn(&self, frame: usize) -> Option<Turn> {
        let (parent, axis) = self.links.frames[frame]?;
        Some(Turn { parent, axis: axis?, term: self.frames[frame] })
    }

    /// Components of the vector to a point; `None` for the origin.
    pub fn components(&self, point: usize) -> Option<Components> {
        let (from, frame) = self.links.points[point]?;
        Some(Components { from, frame, first: self.points[point] })
    }

    /// True if a term mentions a coordinate.
    pub fn mentions(&self, mechanism: &Mechanism, term: usize, coordinate: usize) -> bool {
        mechanism.arena.mentions(self.links.values[term], mechanism.coordinates[coordinate].symbol)
    }

    /// True if the turn of a frame from its parent mentions a coordinate.
    pub fn turns_by(&self, mechanism: &Mechanism, frame: usize, coordinate: usize) -> bool {
        let count = match self.links.frames[frame] {
            None => 0,
            Some((_, Some(_))) => 1,
            Some((_, None)) => 9,
        };
        (self.frames[frame]..self.frames[frame] + count).any(|term| self.mentions(mechanism, term, coordinate))
    }

    /// Values of all terms at parameters and coordinates.
    pub fn values(&self, p: &[f64], q: &[f64]) -> Vec<f64> {
        self.tape.evaluate(&[p, q].concat())
    }

    /// Reads a coordinate from a term. `None` unless the term is the coordinate or its opposite, plus a rest that does
    /// not depend on it.
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
