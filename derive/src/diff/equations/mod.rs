//! Comparison of rows of linear systems, whatever factors and multipliers an author chose.

pub(super) mod claim;
pub(super) mod derived_system;
pub(super) mod lagrange_multipliers;
pub(super) mod matched_system;
mod multipliers_of_motion;
mod row_independence;
pub mod row_judgement;
mod row_matching;
