//! Equations of motion as right-hand sides.

pub(crate) mod dynamics;
pub(crate) mod eliminated;
pub(crate) mod tangents;
