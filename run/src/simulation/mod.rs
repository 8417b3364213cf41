//! Runs of scenes, and the results that they return.

pub(super) mod outputs;
pub(super) mod run;
pub(super) mod run_problem;
pub(super) mod sampled;
pub(super) mod simulate;
