//! View of a mechanism: its solids, and their poses during a motion. This module computes the view and does
//! not draw it.

mod body_forms;
mod force_arrows;
mod guessed_solids;
mod homogeneous_solids;
mod pose;
mod pose_extent;
mod solid;
pub(crate) mod space;
mod stated_solids;
mod view_motion;

pub use force_arrows::{ForceArrow, ForceArrows, ForceSource};
pub use pose::{Configuration, FrameTree, Pose, Poses};
pub use solid::{Solid, SolidForm, SolidPlace};
pub use space::{Quaternion, Rotation, Triple, quaternion};
pub use stated_solids::stated_solid_lengths;
pub use view_motion::ViewMotion;

use crate::error::Error;
use crate::mechanism::Mechanism;
use guessed_solids::SolidGuess;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::scene::Scene;

/// Solids of a mechanism at the parameters of a scene, with the size and the directions for drawing.
#[derive(Clone, Debug)]
pub struct View {
    /// All solids of the mechanism, in no particular order.
    pub solids: Vec<Solid>,
    /// True if the model file states the shapes. False if they are guessed from bodies, points and joints.
    pub is_stated: bool,
    /// Unit vector that points upwards in the inertial frame: against gravity, or along the third inertial axis without
    /// gravity.
    pub up: Triple,
    /// Unit normal of the plane in which all points stay; `None` if there is no such plane.
    pub plane: Option<Triple>,
    /// Size of the mechanism, m: the greatest distance between two visible points at one instant.
    pub size: f64,
    /// Indices of the points whose paths are shown. They are the points of contact, otherwise the particles,
    /// otherwise one mass centre.
    pub traced: Vec<usize>,
    /// Axes to draw, one entry for each rigid body: the index of its frame and the index of its mass centre.
    pub triads: Vec<(usize, usize)>,
}

impl View {
    /// Makes the view of a mechanism for several motions of a scene. The first motion determines the size
    /// and the plane.
    ///
    /// # Errors
    /// [`Error::Request`] if a shape has a length that is not positive at the parameters of the
    /// scene.
    pub fn new(mechanism: &Mechanism, scene: &Scene, motions: &[&ViewMotion]) -> Result<Self, Error> {
        let at = Configuration { parameters: &scene.parameters, q: &scene.q };
        let motions: Vec<&[Pose]> = motions.iter().map(|motion| motion.poses.as_slice()).collect();
        Self::of_poses(mechanism, at, &motions)
    }

    /// Makes the view of a mechanism that starts at the configuration `at`, for several motions given as poses.
    /// The first motion determines the size and the plane.
    ///
    /// # Errors
    /// [`Error::Request`] if a shape has a length that is not positive at the given parameters.
    pub fn of_poses(mechanism: &Mechanism, at: Configuration<'_>, motions: &[&[Pose]]) -> Result<Self, Error> {
        let poses = Poses::new(mechanism)?;
        let stated = stated_solids::stated_solids(mechanism, at.parameters)?;
        let is_stated = !stated.is_empty();
        let first = motions.first().copied().unwrap_or_default();
        let guess = SolidGuess::new(mechanism, at, &poses, first)?;
        let seen = guess.visible_points(&stated);
        let reach = if is_stated {
            stated.iter().map(|solid| solid.form.reach()).fold(0.0, f64::max)
        } else {
            guess.solids_reach()
        };
        let size = Some(pose_extent::diameter_over_poses(first, &seen).max(2.0 * reach))
            .filter(|size| *size > 0.0)
            .unwrap_or(1.0);
        let mut view = Self {
            is_stated,
            up: upward_direction(mechanism, at.parameters, first)?,
            plane: pose_extent::plane_of_motion(first, &seen, size),
            size,
            traced: guess.traced_points(),
            triads: guess.body_axes(),
            solids: if is_stated { stated } else { guess.guessed_solids(size) },
        };
        if !is_stated {
            view.solids.extend(guess.ground(&view, motions));
        }
        Ok(view)
    }
}

/// Unit vector against gravity in the inertial frame, at the start of a motion. Without gravity, it is the
/// third inertial axis.
fn upward_direction(mechanism: &Mechanism, parameters: &[f64], poses: &[Pose]) -> Result<Triple, Error> {
    let third = [0.0, 0.0, 1.0];
    let (Some(gravity), Some(pose)) = (&mechanism.gravity, poses.first()) else { return Ok(third) };
    let fall = evaluate_parameters_only(mechanism, parameters, &gravity.acceleration, "gravity")?;
    let fall = space::rotate_vector(&pose.rotations[gravity.frame], [fall[0], fall[1], fall[2]]);
    Ok(space::unit_vector(fall).map_or(third, |down| down.map(|x| 0.0 - x)))
}

/// Computes expressions that depend only on parameters. `what` names the expressions in an error.
fn evaluate_parameters_only(
    mechanism: &Mechanism,
    parameters: &[f64],
    terms: &[tripos_derive::algebra::Expr],
    what: &str,
) -> Result<Vec<f64>, Error> {
    let tape: Tape = crate::code::compile_tape(&mechanism.arena, &mechanism.p(), terms, what)?;
    Ok(tape.evaluate(parameters))
}
