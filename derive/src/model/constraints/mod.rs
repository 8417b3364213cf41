//! Constraints of a model file, frames of joints, explicit time, and generalized speeds.

pub(super) mod assembly;
pub(crate) mod closed_pose_search;
pub(super) mod closed_poses;
pub(super) mod comparison;
pub(super) mod configuration_constraints;
pub(super) mod constant_loops;
pub(super) mod independent_constraints;
pub(super) mod joint_frames_and_points;
pub(super) mod loop_closures;
pub(super) mod motion_constraints;
pub(super) mod openings;
pub(super) mod redundant_constraints;
pub(super) mod speeds;
pub(super) mod time_coordinate;
pub(super) mod turns;
mod vanishing_rows;
