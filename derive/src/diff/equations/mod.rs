//! Comparison of rows of linear systems, independent of the factors and multipliers that an author chose.

pub(super) mod claim;
pub(super) mod derived_system;
mod independence;
mod matching;
pub(super) mod multipliers;
pub mod rows;
