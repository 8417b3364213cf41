//! Bodies of a model file, with their frames, points, joints, loads, inputs and shapes.

mod added_mass;
pub(super) mod elements;
pub(super) mod friction;
pub(super) mod input_signals;
pub(super) mod joint_kinds;
pub(super) mod joints;
pub(super) mod loads;
pub(super) mod mechanism_motion;
pub(super) mod potentials;
pub(super) mod shapes;
pub(super) mod springs;
