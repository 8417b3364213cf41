//! Constraints of a model file, frames of joints, explicit time, and generalized speeds.

pub(super) mod closed_pose_choices;
pub(crate) mod closed_poses;
pub(super) mod comparison;
pub(super) mod configuration_constraints;
pub(super) mod explicit_time;
pub(super) mod independent_constraints;
pub(super) mod joint_frames;
pub(super) mod motion_constraints;
pub(super) mod openings;
pub(super) mod speeds;
pub(super) mod turns;
