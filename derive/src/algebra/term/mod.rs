//! Terms: rational numbers, the arena that stores expressions, and operations that build new terms
//! from given terms.

pub mod adjoint;
pub mod arena;
pub mod calculus;
pub(super) mod construct;
pub mod contraction;
pub mod divided_difference;
pub(crate) mod elementary;
pub mod fold;
pub mod named;
pub mod period;
pub(super) mod rational;
pub mod steps;
pub(super) mod structure_hashes;
pub(crate) mod transfer;
