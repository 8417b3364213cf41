//! Words that no variable of Rust can have.

use crate::plan::Language;

/// Rust, with the names that generated functions use for other things.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE };

/// Names in scope of the bodies of generated functions, and those that a pattern takes for something else.
const IN_SCOPE: [&str; 30] = [
    "p",
    "q",
    "u",
    "q_dot",
    "v_dot",
    "out",
    "zero",
    // What parts of a long function hand on.
    "values",
    "S",
    "Parameters",
    "Scalar",
    "System",
    // Of the recurrences.
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
    // Constants and variants that a name cannot hide.
    "None",
    "Some",
    "Ok",
    "Err",
];

/// True if a word may be a name of a variable, a field or a module.
#[must_use]
pub fn is_name(word: &str) -> bool {
    // `gen` is a keyword since the edition of 2024.
    syn::parse_str::<syn::Ident>(word).is_ok() && !["_", "gen"].contains(&word)
}
