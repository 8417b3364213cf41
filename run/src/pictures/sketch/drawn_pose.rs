//! Drawn pose of a sketch: the pose at a start, with other values for angles and lengths that could not be
//! seen.

use super::pose_formulas::PoseFormulas;
use crate::code::compile_tape;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::pictures::view::space::length;
use crate::pictures::view::{Configuration, Pose, Poses, View};

/// Angles that replace values close to 0 at the start, degrees, used in turn.
pub(super) const ANGLES: [f64; 6] = [30.0, 40.0, 25.0, 50.0, 35.0, 45.0];
/// Lengths that replace values close to 0, or values too large for the sheet. They are relative to the size
/// of the mechanism, and used in turn.
const LENGTHS: [f64; 3] = [0.8, 0.65, 0.5];
/// Absolute angle below which the arc of an angle cannot be seen, rad.
const UNSEEN_ANGLE: f64 = 0.14;
/// Length below which its dimension line cannot be seen, relative to the size of the mechanism.
const UNSEEN_SHARE: f64 = 0.06;
/// Length above which the mechanism would be drawn too small, relative to the size of the mechanism.
const LARGEST_SHARE: f64 = 1.8;

/// Coordinate that is drawn at another value than at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChangedCoordinate {
    /// Index of the coordinate whose value is changed.
    pub coordinate: usize,
    /// Value of the coordinate at the start, rad or m.
    pub was: f64,
    /// Value of the coordinate in the drawing, rad or m.
    pub is: f64,
}

/// Coordinates sorted by kind: angles that turn a frame about an axis, and lengths that are
/// components of a position.
pub struct CoordinateKinds {
    /// Indices of the coordinates that are the angle of a frame about an axis.
    pub angles: Vec<usize>,
    /// Indices of the coordinates that are a component of a point's position.
    pub lengths: Vec<usize>,
}

impl CoordinateKinds {
    /// Sorts the coordinates of a mechanism into angles and lengths. Other coordinates are in neither list.
    pub fn new(mechanism: &Mechanism, terms: &PoseFormulas, at: Configuration<'_>) -> Self {
        let told = |term: usize, c: usize| terms.signed_coordinate(mechanism, at.parameters, at.q, term, c).is_some();
        let frames = 0..mechanism.frames.len();
        let turns = |c: &usize| frames.clone().any(|f| terms.turn(f).is_some_and(|turn| told(turn.term, *c)));
        let points = 0..mechanism.points.len();
        let component =
            |p: usize, c: usize| terms.components(p).is_some_and(|of| (of.first..of.first + 3).any(|t| told(t, c)));
        let moves = |c: &usize| points.clone().any(|p| component(p, *c));
        let all = 0..mechanism.coordinates.len();
        let (angles, others): (Vec<usize>, Vec<usize>) = all.partition(turns);
        let lengths = others.into_iter().filter(|c| mechanism.coordinates[*c].unit.is_length()).filter(moves).collect();
        Self { angles, lengths }
    }
}

/// Computes the values of the coordinates in the drawn pose, and the list of changes from the start `at`.
/// The coordinates of a mechanism with loops stay unchanged.
///
/// # Errors
/// [`Error::Request`] if a shape has a length that is not positive at the given parameters.
pub fn drawn_coordinates(
    mechanism: &Mechanism,
    terms: &PoseFormulas,
    poses: &Poses,
    at: Configuration<'_>,
) -> Result<(Vec<f64>, Vec<ChangedCoordinate>), Error> {
    let start = at.q.to_vec();
    if !mechanism.loops.is_empty() || !mechanism.closed.is_empty() {
        return Ok((start, Vec::new()));
    }
    let kinds = CoordinateKinds::new(mechanism, terms, at);
    let mut q = start.clone();
    let tiny = kinds.angles.iter().filter(|c| drawn_angle_without_turns(start[**c]).abs() < UNSEEN_ANGLE);
    for (c, angle) in tiny.zip(ANGLES.iter().cycle()) {
        q[*c] = angle.to_radians().copysign(if start[*c] < 0.0 { -1.0 } else { 1.0 });
    }
    // The size of the mechanism is measured with all lengths at 0, because lengths only place the mechanism.
    let mut without = q.clone();
    kinds.lengths.iter().for_each(|c| without[*c] = 0.0);
    let pose = poses.pose_at(at.parameters, &without);
    let view = View::of_poses(mechanism, Configuration { q: &without, ..at }, &[std::slice::from_ref(&pose)])?;
    let reaches = |pose: &Pose| pose.points.iter().map(|point| length(*point)).fold(0.0, f64::max);
    let size = if reaches(&pose) > 1e-9 || view.size.to_bits() != 1.0_f64.to_bits() {
        view.size
    } else {
        // If only lengths place a particle, the largest of these lengths is the size of the mechanism.
        let largest = kinds.lengths.iter().map(|c| start[*c].abs()).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    };
    for (at, c) in kinds.lengths.iter().enumerate() {
        let share = start[*c].abs() / size;
        if !(UNSEEN_SHARE..=LARGEST_SHARE).contains(&share) {
            let far = if share > LARGEST_SHARE { 1.5 } else { 1.0 };
            let sign = if start[*c] < 0.0 { -1.0 } else { 1.0 };
            q[*c] = round_drawn_length(far * LENGTHS[at % LENGTHS.len()] * size) * sign;
        }
    }
    if !is_drawable_pose(mechanism, poses, at.parameters, &q) {
        return Ok((start, Vec::new()));
    }
    let pairs = start.iter().zip(&q).enumerate().filter(|(_, (was, is))| was.to_bits() != is.to_bits());
    let changed = pairs.map(|(coordinate, (was, is))| ChangedCoordinate { coordinate, was: *was, is: *is }).collect();
    Ok((q, changed))
}

/// Angle without whole turns, rad, from −π to below π.
fn drawn_angle_without_turns(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    angle - TAU * ((angle + PI) / TAU).floor()
}

/// Rounds a length to two significant digits.
fn round_drawn_length(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

/// True if every frame and point has finite values, and the pose satisfies the conditions of the model's
/// domain. Conditions that depend on more than the pose are ignored.
fn is_drawable_pose(mechanism: &Mechanism, poses: &Poses, p: &[f64], q: &[f64]) -> bool {
    let pose = poses.pose_at(p, q);
    let inputs = [mechanism.p(), mechanism.q()].concat();
    let is_inside = |positive| {
        // A condition on speeds or reactions cannot be checked by a pose, and is ignored.
        let Ok(tape) = compile_tape(&mechanism.arena, &inputs, &[positive], "a condition") else { return true };
        tape.evaluate(&[p, q].concat())[0] > 0.0
    };
    pose.is_finite() && mechanism.domain.iter().all(|condition| is_inside(condition.positive))
}
