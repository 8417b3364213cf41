//! Simulation of scenes, and the results of their runs.

pub(super) mod outputs;
pub(super) mod run;
pub(super) mod run_problem;
pub(super) mod sampled;
pub(super) mod simulate;
