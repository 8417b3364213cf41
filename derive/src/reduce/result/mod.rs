//! Result of a reduction: the reduced equations, their proof, and the list of omissions.

pub(super) mod omissions;
pub(super) mod pack_reduction;
pub(super) mod reduction;
pub(super) mod reduction_proof;
pub(super) mod surface_choice;
