//! Rigorous runs of scenes: boxes that provably contain what a scene shows, claims about the motion, and instants of
//! events.

pub(crate) mod claims;
pub(crate) mod crossings;
pub(crate) mod enclosed_run;
mod motion_watch;
mod observed_equations;
