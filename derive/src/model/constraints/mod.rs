//! Constraints of a model file, frames of joints, explicit time, and generalized speeds.

pub(super) mod closed_choices;
pub(crate) mod closed_poses;
pub(super) mod comparison;
pub(super) mod configuration;
pub(super) mod independent;
pub(super) mod joint_frames;
pub(super) mod motion;
pub(super) mod openings;
pub(super) mod speeds;
pub(super) mod time;
pub(super) mod turns;
