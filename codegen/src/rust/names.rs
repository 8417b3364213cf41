//! Names that no Rust variable of generated code can have.

use crate::plan::Language;

/// Language Rust, with the names that generated functions use for other purposes.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE, longest: usize::MAX };

/// Names in the scope of generated function bodies, and names that a pattern would match as something else.
const IN_SCOPE: [&str; 30] = [
    "p",
    "q",
    "u",
    "q_dot",
    "v_dot",
    "out",
    "zero",
    // Array in which parts of a long function pass values.
    "values",
    "S",
    "Parameters",
    "Scalar",
    "System",
    // Names used by the recurrences.
    "series",
    "history",
    "order",
    "count",
    "count_last",
    "over_k",
    "sums",
    "next",
    "pair",
    "pair_sums",
    "padded",
    "rows",
    "Factors",
    "SLACK",
    // Constants and variants that a variable's name cannot hide.
    "None",
    "Some",
    "Ok",
    "Err",
];

/// True if a word may be the name of a Rust variable, field or module of generated code.
#[must_use]
pub fn is_name(word: &str) -> bool {
    // The word `gen` is a keyword since the 2024 edition.
    syn::parse_str::<syn::Ident>(word).is_ok() && !["_", "gen"].contains(&word)
}
