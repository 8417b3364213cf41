//! Where every frame and point of a mechanism is in one configuration.

use super::space::{IDENTITY, Rotation, Triple, about, plus, product, rotated, transposed};
use crate::code::tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::model::Turn;

/// Where everything is at one instant, seen from the inertial frame and its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The rotation of each frame of the model: (components in the inertial frame) = rotation · (components in the frame).
    pub rotations: Vec<Rotation>,
    /// Where each point of the model is, m.
    pub points: Vec<Triple>,
}

/// What gives the poses of a model: the turn of each frame from the one before it and the place of each point from the one before
/// it, as they stand in the model. Nothing is multiplied out, so that a long chain costs no more than its links.
#[derive(Clone)]
pub struct Poses {
    tape: Tape,
    frames: Vec<Option<(usize, Way)>>,
    /// The point before, and the frame of the components.
    points: Vec<Option<(usize, usize)>>,
}

/// How many values of the tape a turn takes.
#[derive(Clone, Copy)]
enum Way {
    /// An angle about this axis.
    About(usize),
    /// Nine cosines, by rows.
    Cosines,
}

impl Poses {
    /// Poses of this model.
    ///
    /// # Errors
    /// [`Error::Request`] if a place depends on what is neither a parameter nor a coordinate; a model that was read has none such.
    pub fn new(model: &Model) -> Result<Self, Error> {
        let mut values: Vec<Expr> = Vec::new();
        let mut frames = Vec::with_capacity(model.frames.len());
        for frame in &model.frames {
            frames.push(frame.rotation.as_ref().map(|(parent, turn)| match turn {
                Turn::About(axis, angle) => {
                    values.push(*angle);
                    (*parent, Way::About(*axis))
                }
                Turn::Oriented(turn) => {
                    values.extend(turn.cosines.iter().flatten());
                    (*parent, Way::Cosines)
                }
            }));
        }
        let mut points = Vec::with_capacity(model.points.len());
        for point in &model.points {
            points.push(point.position.as_ref().map(|(parent, frame, components)| {
                values.extend(components);
                (*parent, *frame)
            }));
        }
        let inputs = [model.p(), model.q()].concat();
        Ok(Self { tape: tape(&model.arena, &inputs, &values, "the place of a frame or point")?, frames, points })
    }

    /// The pose at these parameters and coordinates.
    #[must_use]
    pub fn of(&self, p: &[f64], q: &[f64]) -> Pose {
        let mut values = self.tape.evaluate(&[p, q].concat()).into_iter();
        let mut next = || values.next().unwrap_or(f64::NAN);
        let mut rotations: Vec<Rotation> = Vec::with_capacity(self.frames.len());
        for frame in &self.frames {
            rotations.push(match frame {
                None => IDENTITY,
                Some((parent, Way::About(axis))) => product(&rotations[*parent], &about(*axis, next())),
                Some((parent, Way::Cosines)) => {
                    let cosines = [(); 3].map(|()| [(); 3].map(|()| next()));
                    product(&rotations[*parent], &transposed(&cosines))
                }
            });
        }
        let mut points: Vec<Triple> = Vec::with_capacity(self.points.len());
        for point in &self.points {
            points.push(match point {
                None => [0.0; 3],
                Some((parent, frame)) => {
                    let components = [(); 3].map(|()| next());
                    plus(points[*parent], 1.0, rotated(&rotations[*frame], components))
                }
            });
        }
        Pose { rotations, points }
    }
}
