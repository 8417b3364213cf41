//! Pictures of a mechanism: a sketch on a sheet, and a series of poses for moving pictures.

pub mod sketch;
pub mod view;
