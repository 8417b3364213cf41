//! Basis of reductions: a model's equations with the parameters of a scene, and elimination in
//! chosen columns.

pub(super) mod frame;
pub(super) mod hoist;
pub(super) mod pivots;
pub(super) mod prose;
pub(super) mod reactions;
pub(super) mod reduction_basis;
pub(super) mod work;
