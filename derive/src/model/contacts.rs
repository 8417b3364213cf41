//! Contacts of bodies that the model file states, other than reactions: rolling, friction, and equations that compare
//! two bodies.

use crate::algebra::text::parse::VelocityOf;

/// Component of a velocity that one constraint states.
#[derive(Clone, Debug)]
pub struct StatedVelocity {
    /// Point, frame or material whose velocity is stated.
    pub of: VelocityOf<usize>,
    /// Index of the frame that has the axis of the component.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// Velocities, places and bodies that one constraint of the model file ties together. The bodies may touch.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Name of the constraint.
    pub name: String,
    /// Velocity that the constraint states alone; `None` if the constraint contains other velocities, rates or speeds.
    pub alone: Option<StatedVelocity>,
    /// Velocities and places that the constraint names.
    pub named: Vec<VelocityOf<usize>>,
    /// Indices of bodies whose own coordinates, or their rates, the constraint contains, in the order of the model
    /// file. Empty if the constraint contains several named velocities or a speed.
    pub own: Vec<usize>,
    /// Indices of bodies whose own coordinates, or their rates, the constraint contains once terms replace its names.
    /// In the order of the model file.
    pub moved: Vec<usize>,
    /// True if the constraint stays true while everything that it ties moves together: it then compares bodies.
    pub is_difference: bool,
}

/// Contacts of bodies that the model file states, other than reactions.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    /// Names of the contacts where bodies roll, in the order of the model file.
    pub rolling: Vec<String>,
    /// Bodies on which friction acts, each with the body against which it rubs; `None` is the ground.
    pub rubbing: Vec<(usize, Option<usize>)>,
    /// Bodies and velocities that each constraint of the model file ties.
    pub compared: Vec<Compared>,
    /// Bodies on which the ground, or the body they touch, exerts only the forces that the model file names. Other
    /// connections carry these bodies.
    pub idle: Vec<usize>,
}
