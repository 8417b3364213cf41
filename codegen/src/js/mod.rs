//! Plans as JavaScript: modules for Node and browsers, in doubles, and the code that runs them.
//!
//! This module decides only how a line is written; the plan decides what is computed. Absent on purpose: Jacobians and
//! recurrences, which the method that goes with the modules does not use.

pub mod emit;
mod expression;
mod function;
mod module;
mod names;
mod text;
mod written;

pub use module::Module;
pub use names::{LANGUAGE, is_name};
pub use text::{in_page, string};
pub use written::Written;

/// Sources of the runners, by name: the method, the projection onto constraints, and runs of mechanisms by both.
pub const RUNNERS: [(&str, &str); 3] = [
    ("dop853", include_str!("dop853.js")),
    ("constraints", include_str!("constraints.js")),
    ("run", include_str!("run.js")),
];
