//! Result of a reduction: its equations, its proof, and the list of omissions.

pub(super) mod ledger;
pub(super) mod pack;
pub(super) mod proof;
pub(super) mod reduction;
