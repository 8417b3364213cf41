//! Reading of printed programs: their assignments and arrays, the linear systems that they solve, and listings.

mod array_formulas;
mod array_functions;
mod arrays;
pub(super) mod assignments;
mod indices;
pub(super) mod listing;
