//! The pose that is drawn: that of a start, with other values for angles and lengths that would not be seen there.

use super::terms::Terms;
use crate::code::tape;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::view::space::length;
use crate::view::{Configuration, Pose, Poses, View};
use tripos_derive::diagnostic::Source;
use tripos_derive::model::TIME;
use tripos_derive::scene::load;

/// Angles that are drawn where the start has about 0, degrees, one after another.
const ANGLES: [f64; 6] = [30.0, 40.0, 25.0, 50.0, 35.0, 45.0];
/// Lengths that are drawn where the start has about 0 or more than the sheet can hold, as shares of the size of the mechanism.
const LENGTHS: [f64; 3] = [0.8, 0.65, 0.5];
/// Angles, rad, and lengths, as a share, below which nothing of them is seen, and the share above which nothing else is.
const UNSEEN: (f64, f64, f64) = (0.14, 0.06, 1.8);

/// A coordinate that is drawn at another value than the start has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Changed {
    /// The coordinate.
    pub coordinate: usize,
    /// Its value at the start.
    pub was: f64,
    /// The value that is drawn.
    pub is: f64,
}

/// Which coordinates turn a frame about an axis, and which are a component of a way.
pub struct Kinds {
    /// Angles.
    pub angles: Vec<usize>,
    /// Lengths.
    pub lengths: Vec<usize>,
}

impl Kinds {
    /// The kinds of the coordinates of a mechanism.
    pub fn new(mechanism: &Mechanism, terms: &Terms, at: Configuration<'_>) -> Self {
        let told = |term: usize, c: usize| terms.told(mechanism, (at.parameters, at.q), term, c).is_some();
        let frames = 0..mechanism.frames.len();
        let turns = |c: &usize| frames.clone().any(|f| terms.turn(f).is_some_and(|(.., term)| told(term, *c)));
        let points = 0..mechanism.points.len();
        let component = |p: usize, c: usize| terms.components(p).is_some_and(|(.., t)| (t..t + 3).any(|t| told(t, c)));
        let moves = |c: &usize| points.clone().any(|p| component(p, *c));
        let all = 0..mechanism.coordinates.len();
        let (angles, others): (Vec<usize>, Vec<usize>) = all.partition(turns);
        let lengths = others.into_iter().filter(|c| mechanism.coordinates[*c].unit.is_length()).filter(moves).collect();
        Self { angles, lengths }
    }
}

/// What is drawn of a start, and what is changed of it. What loops hold stays as it is.
///
/// # Errors
/// [`Error::Request`] if a shape has a length that is nothing at these parameters.
pub fn shown(
    mechanism: &Mechanism,
    terms: &Terms,
    poses: &Poses,
    at: Configuration<'_>,
) -> Result<(Vec<f64>, Vec<Changed>), Error> {
    let start = at.q.to_vec();
    if !mechanism.loops.is_empty() || !mechanism.closed.is_empty() {
        return Ok((start, Vec::new()));
    }
    let kinds = Kinds::new(mechanism, terms, at);
    let mut q = start.clone();
    let tiny = kinds.angles.iter().filter(|c| near_turn(start[**c]).abs() < UNSEEN.0);
    for (c, angle) in tiny.zip(ANGLES.iter().cycle()) {
        q[*c] = angle.to_radians().copysign(if start[*c] < 0.0 { -1.0 } else { 1.0 });
    }
    // How large it is without what places it.
    let mut without = q.clone();
    kinds.lengths.iter().for_each(|c| without[*c] = 0.0);
    let pose = poses.of(at.parameters, &without);
    let view = View::of_poses(mechanism, Configuration { q: &without, ..at }, &[std::slice::from_ref(&pose)])?;
    let reaches = |pose: &Pose| pose.points.iter().map(|point| length(*point)).fold(0.0, f64::max);
    let size = if reaches(&pose) > 1e-9 || view.size.to_bits() != 1.0_f64.to_bits() {
        view.size
    } else {
        // A particle that lengths alone place is as large as they are.
        let largest = kinds.lengths.iter().map(|c| start[*c].abs()).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    };
    for (at, c) in kinds.lengths.iter().enumerate() {
        let share = start[*c].abs() / size;
        if !(UNSEEN.1..=UNSEEN.2).contains(&share) {
            let far = if share > UNSEEN.2 { 1.5 } else { 1.0 };
            let sign = if start[*c] < 0.0 { -1.0 } else { 1.0 };
            q[*c] = rounded(far * LENGTHS[at % LENGTHS.len()] * size) * sign;
        }
    }
    if !is_good(mechanism, poses, at.parameters, &q) {
        return Ok((start, Vec::new()));
    }
    let pairs = start.iter().zip(&q).enumerate().filter(|(_, (was, is))| was.to_bits() != is.to_bits());
    let changed = pairs.map(|(coordinate, (was, is))| Changed { coordinate, was: *was, is: *is }).collect();
    Ok((q, changed))
}

/// An angle without whole turns, between minus and plus half of one.
fn near_turn(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    angle - TAU * ((angle + PI) / TAU).floor()
}

/// Two digits of a length.
fn rounded(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

/// Whether everything has a place, inside the domain of the model as far as the pose alone says.
fn is_good(mechanism: &Mechanism, poses: &Poses, p: &[f64], q: &[f64]) -> bool {
    let pose = poses.of(p, q);
    let inputs = [mechanism.p(), mechanism.q()].concat();
    let is_inside = |positive| {
        // What needs speeds or reactions says nothing of a pose.
        let Ok(tape) = tape(&mechanism.arena, &inputs, &[positive], "a condition") else { return true };
        tape.evaluate(&[p, q].concat())[0] > 0.0
    };
    is_somewhere(&pose) && mechanism.domain.iter().all(|condition| is_inside(condition.positive))
}

/// Whether every point has a place.
pub fn is_somewhere(pose: &Pose) -> bool {
    pose.points.iter().flatten().chain(pose.rotations.iter().flatten().flatten()).all(|x| x.is_finite())
}

/// A start of a mechanism that no scene gives one: the parameters of its file, all coordinates 0; with loops, closed from angles and
/// lengths that are not.
///
/// # Errors
/// [`Error::Request`] if a parameter has no value, or loops do not close from there.
pub fn without_scene(mechanism: &Mechanism) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let help = "give a scene, or --at with a state file, which gives it one";
    let value = |p: &tripos_derive::model::Parameter| {
        let none = || Error::request(format!("the parameter `{}` has no value", p.name), help);
        p.value.as_ref().map(tripos_derive::algebra::Rational::to_f64).or(p.is_input.then_some(0.0)).ok_or_else(none)
    };
    let parameters = mechanism.parameters.iter().map(value).collect::<Result<Vec<f64>, Error>>()?;
    if mechanism.loops.is_empty() {
        return Ok((parameters, vec![0.0; mechanism.coordinates.len()]));
    }
    let inputs: Vec<String> =
        mechanism.parameters.iter().filter(|p| p.is_input).map(|p| format!("\"{}\" = 0\n", p.name)).collect();
    let inputs = if inputs.is_empty() { String::new() } else { format!("[inputs]\n{}", inputs.concat()) };
    let speeds: Vec<String> = mechanism.speeds.iter().map(|speed| format!("\"{}\" = 0\n", speed.name)).collect();
    let guesses = mechanism.coordinates.iter().filter(|c| c.name != TIME).zip(ANGLES.iter().cycle());
    let guesses: Vec<String> = guesses.map(|(c, angle)| format!("\"{}\" = {}\n", c.name, angle.to_radians())).collect();
    let text = format!("span = [0, 1]\n{inputs}[start]\n{}[guess]\n{}", speeds.concat(), guesses.concat());
    let scene = load(&Source::from_text("start", &text), &mut mechanism.model.clone()).map_err(|_| {
        let help = "give a scene, or --at with a state file, which closes them";
        Error::request("no pose was found that closes the loops of this model", help)
    })?;
    Ok((scene.parameters, scene.q))
}
