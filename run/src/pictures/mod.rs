//! Poses of a mechanism during a motion for moving pictures, and its sketch.

pub mod sketch;
pub mod view;
