//! Planned functions as programs of named lines, with arguments, names, parts and costs, and the planner of
//! functions.

pub(super) mod arguments;
pub(super) mod cost;
pub(super) mod function;
pub(super) mod fusion;
pub(super) mod planner;
pub(super) mod program;
pub(super) mod program_parts;
pub(super) mod variable_names;
