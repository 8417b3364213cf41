//! Changes of variables in reductions: moving frames, differences, and distances from a singular
//! surface.

pub(super) mod differences;
pub(super) mod frame_search;
pub(super) mod frame_section;
pub(super) mod singular_surface;
