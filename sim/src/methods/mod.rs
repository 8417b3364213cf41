//! Integration methods, each with its trial step, its error estimate and its dense output, and the options of a run.

pub(crate) mod dop853;
pub(crate) mod dop853_dense_output;
pub(crate) mod dormand_prince;
pub(crate) mod dormand_prince_853;
pub(crate) mod explicit_runge_kutta;
pub(crate) mod gauss6;
pub(crate) mod method_rules;
pub(crate) mod radau;
pub(crate) mod rk4;
pub(crate) mod run_options;
pub(crate) mod step_size_rules;
pub(crate) mod tableau;
pub(crate) mod taylor;
