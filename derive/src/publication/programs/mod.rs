//! Reading of printed programs: their assignments, the linear systems that they solve, and listings.

pub(super) mod assignments;
pub(super) mod linear_solutions;
pub(super) mod listing;
