//! A run, and what it returns.

pub(super) mod outputs;
pub(super) mod run;
pub(super) mod sampled;
pub(super) mod simulate;
