//! Basis of reductions: a model's equations with the parameters of a scene, and elimination in
//! chosen columns.

pub(super) mod hoisted_constants;
pub(super) mod moving_frame;
pub(super) mod prose;
pub(super) mod reaction_balance;
pub(super) mod reduction_basis;
pub(super) mod search_work;
pub(super) mod solved_rows;
