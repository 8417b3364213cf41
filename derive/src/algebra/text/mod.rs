//! Terms from text, and as text in every notation.

pub mod definitions;
pub mod notation;
pub mod parse;
pub mod print;
pub mod view;
