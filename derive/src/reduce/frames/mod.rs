//! Moving frames, differences of variables, and distances from a singular surface.

pub(super) mod differences;
pub(super) mod framing;
pub(super) mod section;
pub(super) mod surface;
