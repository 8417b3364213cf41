//! JavaScript code from plans: modules in double precision for Node and browsers, and the code that runs them.
//!
//! This module decides only the form of a line; the plan decides the computation. Jacobians and Taylor recurrences
//! are deliberately absent, because the integrator of the modules does not use them.

pub mod emit;
mod function;
mod javascript_names;
mod javascript_strings;
mod module;
mod syntax;
mod written_equations;

pub use javascript_names::{LANGUAGE, is_name};
pub use javascript_strings::{javascript_script_text, javascript_string};
pub use module::JavaScriptModule;
pub use written_equations::WrittenEquations;

/// JavaScript sources that run the modules, each with its name: the integrator, the projection onto
/// constraints, and runs that use both.
pub const RUNNERS: [(&str, &str); 3] = [
    ("dop853", include_str!("dop853.js")),
    ("constraints", include_str!("constraints.js")),
    ("run", include_str!("run.js")),
];
