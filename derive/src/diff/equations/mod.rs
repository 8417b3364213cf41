//! Rows of linear systems compared, whatever factors and multipliers an author chose.

pub(super) mod claim;
pub(super) mod multipliers;
pub(super) mod ordered;
pub(super) mod row_text;
pub mod rows;
