//! Contacts of bodies that the model file states, other than reactions: rolling, friction, and
//! constraints that compare the motions of two bodies.

use crate::algebra::text::parse::VelocityOf;

/// Velocity component that is the only velocity in a constraint.
#[derive(Clone, Debug)]
pub struct ConstrainedVelocity {
    /// Point, frame or material of a body whose velocity is stated, by index.
    pub of: VelocityOf<usize>,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// Velocities, positions and bodies that a constraint of the model file relates. Related bodies may touch.
#[derive(Clone, Debug)]
pub struct ComparedBodies {
    /// Name of the constraint in the model file.
    pub name: String,
    /// Velocity component of a constraint that contains no other velocity, rate or speed. `None` for any other
    /// constraint.
    pub alone: Option<ConstrainedVelocity>,
    /// Velocities and positions that occur by name in the constraint.
    pub named: Vec<VelocityOf<usize>>,
    /// Indices of bodies whose own coordinates or rates occur in the constraint, in the order of the model file.
    /// Empty if the constraint contains a speed, or more than one named velocity.
    pub own: Vec<usize>,
    /// Indices of bodies whose own coordinates or rates occur in the constraint after its named velocities are
    /// replaced by terms. They are in the order of the model file.
    pub moved: Vec<usize>,
    /// True if the constraint compares bodies: it stays satisfied when all related bodies move together.
    pub is_difference: bool,
}

/// Contacts of bodies that the model file states, other than reactions.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    /// Names of the rolling contacts, in the order of the model file.
    pub rolling: Vec<String>,
    /// Bodies on which friction acts, as (body, body against which it rubs). The second is `None` for the ground.
    pub rubbing: Vec<(usize, Option<usize>)>,
    /// Bodies and velocities that each constraint of the model file relates.
    pub compared: Vec<ComparedBodies>,
    /// Indices of bodies on which the ground, or the body that they touch, exerts no forces except those that the
    /// model file states. Other connections support these bodies.
    pub idle: Vec<usize>,
}
