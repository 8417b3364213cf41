//! Reading of authors' own files: LaTeX files with macros, and programs with assignments.
//!
//! Every formula keeps its place in the author's file. All work is limited.

mod displays;
mod macros;
mod program;
mod traced_text;

pub use displays::{Choice, Paper};
pub use macros::{Macros, without_comments};
pub use program::{Statement, is_access, is_number, statements};
pub use traced_text::{Problem, Traced};
