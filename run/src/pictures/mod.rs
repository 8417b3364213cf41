//! Poses of a mechanism during a motion, and its sketch.

pub mod sketch;
pub mod view;
