//! Text of terms: parsing from every notation, and printing in every notation.

pub mod definitions;
pub mod display_tree;
pub mod notation;
pub mod parse;
pub mod print;
