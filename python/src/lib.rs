//! Extension module of the Python package `tripos`: models and scenes of the library `tripos`, with NumPy arrays.
//!
//! The module contains no mechanics. The Python code in `python/tripos` defines the public classes and their
//! documentation.

mod arrays;
mod command;
mod failure;
mod model;
mod scene;

use pyo3::prelude::*;

#[pymodule(gil_used = true)]
fn _tripos(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("TriposError", module.py().get_type::<failure::TriposError>())?;
    module.add("InputError", module.py().get_type::<failure::InputError>())?;
    module.add("RequestError", module.py().get_type::<failure::RequestError>())?;
    module.add("StoppedError", module.py().get_type::<failure::StoppedError>())?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_class::<model::Model>()?;
    module.add_class::<scene::Scene>()?;
    module.add_class::<scene::Run>()?;
    module.add_class::<scene::SampledRun>()
}
