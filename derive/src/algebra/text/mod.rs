//! Reading of terms from text, and writing of terms in every notation.

pub mod definitions;
pub mod notation;
pub mod parse;
pub mod print;
pub mod view;
