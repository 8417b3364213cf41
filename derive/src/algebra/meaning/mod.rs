//! Decisions on the meaning of terms: equality, signs, permitted states.

pub mod compare;
pub mod identity;
pub mod permitted_states;
mod samples;
pub(crate) mod signs;
pub(super) mod witness;
