//! Reading of authors' own files: LaTeX files with macros, and programs with assignments.
//!
//! Every formula keeps its place in the author's file. All work is limited by constants.

mod displayed_equations;
pub(super) mod equalities;
mod latex_macros;
pub(super) mod printed_matrix;
mod program_statements;
mod traced_text;

pub use displayed_equations::{LabelChoice, LatexFile};
pub use latex_macros::{Macros, latex_without_comments};
pub use program_statements::{
    Statement, comma_parts, is_program_number, marks_outside_brackets, statement_copies_value, statements,
};
pub use traced_text::{TracedError, TracedText};
