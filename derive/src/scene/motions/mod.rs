//! Prescribed motions for inverse dynamics, which finds their forces, and tables of motion samples.

pub(super) mod motion;
#[cfg(feature = "files")]
pub(super) mod samples;
