//! Simulation of scenes, and the results of their runs.

pub(super) mod run;
pub(super) mod run_problem;
pub(super) mod sampled_inputs;
pub(super) mod shown_quantities;
pub(super) mod simulate;
