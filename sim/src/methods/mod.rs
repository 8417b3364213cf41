//! Integration methods: a trial step of each method, its error and its dense output, with the options
//! of a run.

pub(crate) mod control;
pub(crate) mod dense;
pub(crate) mod dop853;
pub(crate) mod dormand_prince;
pub(crate) mod dormand_prince_853;
pub(crate) mod explicit;
pub(crate) mod gauss;
pub(crate) mod method;
pub(crate) mod options;
pub(crate) mod radau;
pub(crate) mod rk4;
pub(crate) mod tableau;
pub(crate) mod taylor;
