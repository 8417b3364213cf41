//! What is seen of a mechanism and its motion: solids, and where they are at each instant. Absent on purpose: how it is drawn.
//!
//! ```
//! use tripos::{Scene, view::{Motion, View}};
//!
//! let scene = Scene::read("../models/pendulum/scenes/over.toml")?;
//! let motion = Motion::of_scene(scene.mechanism(), scene.description(), None)?;
//! let view = View::new(scene.mechanism(), scene.description(), &[&motion])?;
//! assert!(view.solids.iter().any(|solid| solid.label == "bob"));
//! // The bob hangs a metre below the origin at first.
//! let bob = scene.mechanism().points.iter().position(|point| point.name == "P").unwrap();
//! assert_eq!(motion.poses[0].points[bob], [0.0, -1.0, 0.0]);
//! # Ok::<(), tripos::Error>(())
//! ```

mod arrows;
mod guessed;
mod inertia;
mod made;
mod motion;
mod pose;
mod solid;
pub(crate) mod space;
mod stated;
mod swept;

pub use arrows::{Arrow, ArrowKind, Forces};
pub use motion::Motion;
pub use pose::{Configuration, Links, Pose, Poses};
pub use solid::{Form, Place, Solid};
pub use space::{Quaternion, Rotation, Triple, quaternion};
pub use stated::lengths;

use crate::error::Error;
use crate::mechanism::Mechanism;
use guessed::Guess;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::scene::Scene;

/// What is seen of a mechanism at the parameters of a scene.
#[derive(Clone, Debug)]
pub struct View {
    /// Everything that is drawn, in no order that matters.
    pub solids: Vec<Solid>,
    /// Whether the model file says how it looks; else that was made of bodies, points and joints.
    pub is_stated: bool,
    /// Which way is up, of length 1: against gravity, or the third inertial axis.
    pub up: Triple,
    /// The normal of the plane that all points stay in, if there is one, of length 1.
    pub plane: Option<Triple>,
    /// How large the mechanism is, m: the greatest distance of two points that are seen at one instant.
    pub size: f64,
    /// Points whose ways are worth a look: points of contact, particles, mass centres.
    pub traced: Vec<usize>,
    /// Where the axes of each rigid body stand: its frame, and the point of its mass centre.
    pub triads: Vec<(usize, usize)>,
}

impl View {
    /// A view of these motions, all of one mechanism; the first counts where they differ.
    ///
    /// # Errors
    /// [`Error::Request`] if a shape has a length that is nothing at the parameters of the scene.
    pub fn new(mechanism: &Mechanism, scene: &Scene, motions: &[&Motion]) -> Result<Self, Error> {
        let at = Configuration { parameters: &scene.parameters, q: &scene.q };
        let motions: Vec<&[Pose]> = motions.iter().map(|motion| motion.poses.as_slice()).collect();
        Self::of_poses(mechanism, at, &motions)
    }

    /// A view of a mechanism that moves through these poses, beginning at a configuration; the first motion counts where they differ.
    ///
    /// # Errors
    /// [`Error::Request`] if a shape has a length that is nothing at these parameters.
    pub fn of_poses(mechanism: &Mechanism, at: Configuration<'_>, motions: &[&[Pose]]) -> Result<Self, Error> {
        let poses = Poses::new(mechanism)?;
        let stated = stated::solids(mechanism, at.parameters)?;
        let is_stated = !stated.is_empty();
        let first = motions.first().copied().unwrap_or_default();
        let guess = Guess::new(mechanism, at, &poses, first)?;
        let seen = guess.seen(&stated);
        let reach =
            if is_stated { stated.iter().map(|solid| solid.form.reach()).fold(0.0, f64::max) } else { guess.reach() };
        let size = Some(swept::diameter(first, &seen).max(2.0 * reach)).filter(|size| *size > 0.0).unwrap_or(1.0);
        let mut view = Self {
            is_stated,
            up: up(mechanism, at.parameters, first)?,
            plane: swept::plane(first, &seen, size),
            size,
            traced: guess.traced(),
            triads: guess.triads(),
            solids: if is_stated { stated } else { guess.solids(size) },
        };
        if !is_stated {
            view.solids.extend(guess.ground(&view, motions));
        }
        Ok(view)
    }
}

/// The direction against gravity at the start.
fn up(mechanism: &Mechanism, parameters: &[f64], poses: &[Pose]) -> Result<Triple, Error> {
    let third = [0.0, 0.0, 1.0];
    let (Some(gravity), Some(pose)) = (&mechanism.gravity, poses.first()) else { return Ok(third) };
    let fall = values(mechanism, parameters, &gravity.acceleration, "gravity")?;
    let fall = space::rotated(&pose.rotations[gravity.frame], [fall[0], fall[1], fall[2]]);
    Ok(space::unit(fall).map_or(third, |down| down.map(|x| 0.0 - x)))
}

/// Values of terms in parameters.
fn values(
    mechanism: &Mechanism,
    parameters: &[f64],
    terms: &[tripos_derive::algebra::Expr],
    what: &str,
) -> Result<Vec<f64>, Error> {
    let tape: Tape = crate::code::tape(&mechanism.arena, &mechanism.p(), terms, what)?;
    Ok(tape.evaluate(parameters))
}
