//! Prescribed motions for inverse dynamics, which computes their forces, and tables of motion samples and of measured
//! quantities.

#[cfg(feature = "files")]
pub(super) mod measurements;
#[cfg(feature = "files")]
pub(super) mod motion_samples;
pub(super) mod prescribed_motion;
