//! Changes of variables in reductions: moving frames, differences, and distances from a singular
//! surface.

pub(super) mod differences;
pub(super) mod framing;
pub(super) mod section;
pub(super) mod surface;
