//! Pictures of a mechanism: its sketch on a sheet, and its poses during a motion for moving
//! pictures.

pub mod sketch;
pub mod view;
