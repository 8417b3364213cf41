//! Sections of the page about the mechanism, its derivations, and the proofs.

pub(super) mod derivation;
mod laws;
pub(super) mod mechanism;
pub(super) mod proof;
