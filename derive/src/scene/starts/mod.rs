//! Starts of scenes: coordinates and rates that the scene file states, and those that are computed from constraints.

pub(super) mod enclosed_scene;
pub(super) mod loop_closing;
pub(super) mod loops;
pub(super) mod proved_zero;
pub(super) mod rates;
pub(super) mod start;
pub(super) mod state;
pub(super) mod state_with_unknowns;
