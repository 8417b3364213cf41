//! Names of Rust variables: reserved words and names that generated code cannot use.

use crate::plan::{Allocator, Language};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use tripos_derive::Model;

/// Rules for names of Rust variables: keywords, and names that generated functions use for other
/// purposes.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE, longest: usize::MAX };

/// Names that no variable may have: names in the scope of generated function bodies, and names that a pattern would
/// match as a constant.
const IN_SCOPE: [&str; 30] = [
    "p",
    "q",
    "u",
    "q_dot",
    "v_dot",
    "out",
    "zero",
    // The array in which the parts of a long function pass values.
    "values",
    "S",
    "Parameters",
    "Scalar",
    "System",
    // Names that the Taylor recurrences use in generated code.
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

/// True if a word may be the name of a Rust variable, field or module in generated code.
#[must_use]
pub fn is_name(word: &str) -> bool {
    // The word `gen` is a keyword since the 2024 edition.
    syn::parse_str::<syn::Ident>(word).is_ok() && !["_", "gen"].contains(&word)
}

/// Returns the names of the parameter struct's fields: the parameters' names, changed if they are
/// Rust keywords.
#[must_use]
pub fn parameter_field_names(model: &Model) -> Vec<String> {
    let mut allocator = Allocator::new(&Language { in_scope: &[], ..LANGUAGE });
    model.parameters.iter().map(|p| allocator.unique(&p.name)).collect()
}

/// Returns the Rust tokens of an identifier.
pub fn rust_identifier(name: &str) -> TokenStream {
    let ident = format_ident!("{name}");
    quote!(#ident)
}
