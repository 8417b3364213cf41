//! Files that authors have, read as they are: LaTeX with its macros, and programs with their assignments.
//!
//! Every formula keeps its place in the author's file. All work is bounded.

mod displays;
mod macros;
mod program;
mod traced_text;

pub use displays::{Choice, Paper};
pub use macros::{Macros, without_comments};
pub use program::{Statement, is_access, is_number, statements};
pub use traced_text::{Problem, Traced};
