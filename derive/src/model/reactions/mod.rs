//! Reactions: forces and torques that bodies exert on each other through connections. They are stated in the model
//! file or found automatically.

pub(super) mod actions;
pub(super) mod closures;
pub(super) mod found_reactions;
pub(super) mod interactions;
pub(super) mod potential_forces;
pub(super) mod random_pose;
pub(super) mod relative_motion;
pub(super) mod self_stress;
pub(super) mod supports;
