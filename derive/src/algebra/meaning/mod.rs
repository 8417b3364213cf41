//! Decisions on the meaning of terms: equality, signs, permitted states.

pub mod compare;
pub mod identity;
mod permitted_samples;
pub mod permitted_states;
pub(crate) mod signs;
pub(super) mod witness;
