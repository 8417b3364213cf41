//! Result of a reduction: the reduced equations, their proof, and the list of omissions.

pub(super) mod ledger;
pub(super) mod pack;
pub(super) mod proof;
pub(super) mod reduction;
