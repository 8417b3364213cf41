//! Chains of displacements and turns that lead from the ground to a body.
//!
//! Frames that are turned by a constant rotation form a *group* with the frame from which they are turned. The first
//! frame of a group is the inertial frame or a frame that turns with coordinates. Vectors of a group are in the axes of
//! its first frame.

use super::numbers::Numbers;
use nalgebra::{Matrix3, Vector3};
use tripos_derive::Model;
use tripos_derive::geometry::{Placement, Turn};
use tripos_robots::axis_turn;

/// Relative difference up to which two places or axes of joints count as one, as rounding of doubles.
pub const ROUNDING: f64 = 1e-12;

/// Rotation from the frame before to a frame.
pub enum FrameTurn {
    /// Constant rotation, or none for the inertial frame.
    Constant,
    /// Turn by slope · coordinate + constant about an axis.
    About {
        /// Axis of the turn, from 0.
        axis: usize,
        /// Index of the coordinate.
        coordinate: usize,
        /// Angle for each unit of the coordinate.
        slope: f64,
        /// Angle where the coordinate is 0, rad.
        constant: f64,
    },
    /// Rotation by four Euler parameters, the indices of their coordinates.
    EulerParameters([usize; 4]),
    /// Rotation without a form in URDF, with the reason.
    Other(&'static str),
}

/// Frame of the model, as a joint of URDF sees it.
pub struct FrameFacts {
    /// Index of the first frame of the group.
    pub group: usize,
    /// Rotation matrix of the frame in the axes of the group.
    pub in_group: Matrix3<f64>,
    /// Rotation from the frame before.
    pub turn: FrameTurn,
    /// Index of the frame before; 0 for the inertial frame.
    pub before: usize,
}

/// Step of a chain.
#[derive(Clone, Debug)]
pub enum Step {
    /// Displacement by vector · coordinate.
    Slide(usize, Vector3<f64>),
    /// Constant displacement.
    Shift(Vector3<f64>),
    /// Turn to a frame, the first of its group.
    Turn(usize),
}

/// Chain from the ground to a point of a body.
pub struct Chain {
    /// Steps, each in the axes that the steps before have reached.
    pub steps: Vec<Step>,
}

/// Reason why a body has no chain: a message and advice, both about the frame with this index.
pub struct NoChain {
    /// Message for the user.
    pub message: String,
    /// Advice for the user.
    pub advice: String,
    /// Index of the frame at fault; `None` if a point is at fault.
    pub frame: Option<usize>,
    /// Index of the point at fault.
    pub point: Option<usize>,
}

/// Frames and points of a model with their numbers.
pub struct Places<'m> {
    /// Model whose frames and points these are.
    pub model: &'m Model,
    /// Facts about each frame, by index.
    pub frames: Vec<FrameFacts>,
}

impl<'m> Places<'m> {
    /// Finds the groups of a model's frames.
    pub fn new(model: &'m Model, numbers: &mut Numbers) -> Self {
        let mut frames: Vec<FrameFacts> = Vec::new();
        for (at, frame) in model.frames.iter().enumerate() {
            let Some((before, turn)) = &frame.rotation else {
                frames.push(FrameFacts {
                    group: at,
                    in_group: Matrix3::identity(),
                    turn: FrameTurn::Constant,
                    before: at,
                });
                continue;
            };
            let (turn, constant) = frame_turn(turn, numbers);
            let facts = match turn {
                FrameTurn::Constant => FrameFacts {
                    group: frames[*before].group,
                    in_group: frames[*before].in_group * constant,
                    turn,
                    before: *before,
                },
                _ => FrameFacts { group: at, in_group: Matrix3::identity(), turn, before: *before },
            };
            frames.push(facts);
        }
        Self { model, frames }
    }

    /// Group before a group: that from which the first frame of a group is turned. `None` for the inertial frame.
    pub fn group_before(&self, group: usize) -> Option<usize> {
        let facts = &self.frames[group];
        (facts.before != group).then(|| self.frames[facts.before].group)
    }

    /// Groups from the inertial frame to a group, in this order.
    fn groups_to(&self, group: usize) -> Vec<usize> {
        let mut list = vec![group];
        while let Some(before) = list.last().and_then(|last| self.group_before(*last)) {
            list.push(before);
        }
        list.reverse();
        list
    }

    /// Chain to a point of a body with a frame. Without a frame, the body is a particle, and the chain ends in the last
    /// group in which the point is placed.
    pub fn chain(&self, numbers: &mut Numbers, frame: Option<usize>, point: usize) -> Result<Chain, NoChain> {
        let mut placements: Vec<(usize, &Placement)> = Vec::new();
        let mut at = point;
        while let Some(placement) = &self.model.points[at].position {
            placements.push((at, placement));
            at = placement.parent;
        }
        let group_of = |placement: &Placement| self.frames[placement.frame].group;
        // Of groups at the same depth, the one next to the point.
        let last = placements.iter().rev().map(|(_, placement)| group_of(placement));
        let last = last.max_by_key(|group| self.groups_to(*group).len()).unwrap_or(0);
        let group = frame.map_or(last, |frame| self.frames[frame].group);
        let groups = self.groups_to(group);
        if let Some((_, off)) = placements.iter().find(|(_, placement)| !groups.contains(&group_of(placement))) {
            let name = |frame: usize| &self.model.frames[frame].name;
            let (own, other) = (name(frame.unwrap_or(group)), name(off.frame));
            return Err(NoChain {
                message: format!(
                    "the frame `{own}` is not turned from `{other}`, although its position is fixed in `{other}`"
                ),
                advice: format!(
                    "URDF measures each joint from the link that carries it: measure `{own}` from `{other}`, by a relative angle"
                ),
                frame: Some(frame.unwrap_or(group)),
                point: None,
            });
        }
        let mut steps = Vec::new();
        for (place, group) in groups.iter().enumerate() {
            if place > 0 {
                self.check_turn(*group)?;
                steps.push(Step::Turn(*group));
            }
            let mut shift = Vector3::zeros();
            // Vector of each slide, and the sum of the sizes of its parts.
            let mut slides: Vec<(usize, Vector3<f64>, f64)> = Vec::new();
            for (at, placement) in placements.iter().rev().filter(|(_, placement)| group_of(placement) == *group) {
                let rotation = self.frames[placement.frame].in_group;
                for (axis, component) in placement.components.iter().enumerate() {
                    let Some(affine) = numbers.affine(*component) else { return Err(self.moves_oddly(*at)) };
                    let along = rotation.column(axis).into_owned();
                    shift += along * affine.constant;
                    for (coordinate, slope) in affine.slopes {
                        let part = along * slope;
                        match slides.iter_mut().find(|(known, ..)| *known == coordinate) {
                            Some((_, vector, size)) => {
                                *vector += part;
                                *size += part.norm();
                            }
                            None => slides.push((coordinate, part, part.norm())),
                        }
                    }
                }
            }
            // Parts that cancel, such as those of x1 and x2 - x1, move nothing.
            let slides = slides.into_iter().filter(|(_, vector, size)| vector.norm() > ROUNDING * size);
            steps.extend(slides.map(|(coordinate, vector, _)| Step::Slide(coordinate, vector)));
            steps.push(Step::Shift(shift));
        }
        Ok(Chain { steps })
    }

    /// Reason why a point is at no place that joints of URDF reach.
    fn moves_oddly(&self, point: usize) -> NoChain {
        let name = &self.model.points[point].name;
        NoChain {
            message: format!("the position of `{name}` is not a constant plus constants times coordinates"),
            advice: "URDF has joints that slide by a coordinate and joints that turn by one: place the point by constant components, and by coordinates with constant factors".to_owned(),
            frame: None,
            point: Some(point),
        }
    }

    /// Checks that a group is turned as a joint of URDF turns.
    fn check_turn(&self, group: usize) -> Result<(), NoChain> {
        let FrameTurn::Other(reason) = &self.frames[group].turn else { return Ok(()) };
        let name = &self.model.frames[group].name;
        Err(NoChain {
            message: format!("the turn of the frame `{name}` {reason}"),
            advice: "a joint of URDF turns by one coordinate of its own, or by one that follows it with a constant factor: choose the relative angle as a coordinate".to_owned(),
            frame: Some(group),
            point: None,
        })
    }

    /// Rotation matrix of a frame in the axes of another, in the pose in which all coordinates are 0, and rotations by
    /// Euler parameters are none.
    pub fn rotation_between(&self, from: usize, to: usize) -> Matrix3<f64> {
        self.reference_rotation(from).transpose() * self.reference_rotation(to)
    }

    /// Rotation matrix of a frame in the inertial frame, where all coordinates are 0.
    fn reference_rotation(&self, frame: usize) -> Matrix3<f64> {
        let mut rotation = Matrix3::identity();
        let mut at = frame;
        loop {
            let facts = &self.frames[at];
            rotation = facts.in_group * rotation;
            let first = &self.frames[facts.group];
            if let FrameTurn::About { axis, constant, .. } = first.turn {
                rotation = axis_turn(axis, constant) * rotation;
            }
            if first.before == facts.group {
                return rotation;
            }
            at = first.before;
        }
    }
}

/// Rotation to a frame, and its matrix if it is constant.
fn frame_turn(turn: &Turn, numbers: &mut Numbers) -> (FrameTurn, Matrix3<f64>) {
    let mut constant = Matrix3::identity();
    let kind = match turn {
        Turn::About(axis, angle) => match numbers.affine(*angle) {
            None => FrameTurn::Other("is not a constant plus a constant times one coordinate"),
            Some(affine) => match affine.slopes[..] {
                [] => {
                    constant = axis_turn(*axis, affine.constant);
                    FrameTurn::Constant
                }
                [(coordinate, slope)] => FrameTurn::About { axis: *axis, coordinate, slope, constant: affine.constant },
                _ => FrameTurn::Other("depends on several coordinates"),
            },
        },
        Turn::Oriented(oriented) if oriented.spins.is_empty() => {
            let [first, second, third] = &oriented.cosines;
            let rows = [first, second, third].map(|row| numbers.constants(row));
            match rows {
                [Some(first), Some(second), Some(third)] => {
                    // Rows of the cosines are the axes of the new frame.
                    constant = Matrix3::from_columns(&[first, second, third].map(Vector3::from));
                    FrameTurn::Constant
                }
                _ => FrameTurn::Other("has no constant direction cosines"),
            }
        }
        Turn::Oriented(_) => {
            let place = |e| numbers.coordinates.iter().position(|coordinate| *coordinate == e);
            let places: Option<Vec<usize>> = turn.quantities().into_iter().map(place).collect();
            match places.and_then(|places| <[usize; 4]>::try_from(places).ok()) {
                Some(places) => FrameTurn::EulerParameters(places),
                None => FrameTurn::Other("is by Euler parameters that are no coordinates"),
            }
        }
    };
    (kind, constant)
}
