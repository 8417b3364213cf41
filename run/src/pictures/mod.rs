//! Where everything is, and how it looks.

pub mod sketch;
pub mod view;
