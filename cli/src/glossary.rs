//! Glossary of a document: definitions of the names in its formulas.
//!
//! Invariant: a document contains no name that it does not define.

use crate::phrases::NAMED;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use tripos_derive::algebra::text::definitions::glossary;
use tripos_derive::algebra::text::print::{text, whole_text};
use tripos_derive::algebra::{Arena, Expr};

/// Returns a paragraph that defines every name in the formulas `shown`, each line by names of
/// earlier lines. Empty if the formulas contain no names.
pub fn names_text(arena: &Arena, shown: &[Expr]) -> String {
    let names = glossary(arena, shown);
    if names.is_empty() {
        return String::new();
    }
    let mut out = format!("\n{NAMED}, each line by those before it\n");
    for definition in names {
        let _ = writeln!(out, "  {} = {}", text(arena, definition.symbol), whole_text(arena, definition.value));
    }
    out
}

/// Returns the definitions of every name in the formulas `shown` as a JSON object.
pub fn names_json(arena: &Arena, shown: &[Expr]) -> Value {
    let names = glossary(arena, shown).into_iter();
    Value::Object(names.map(|d| (text(arena, d.symbol), json!(whole_text(arena, d.value)))).collect::<Map<_, _>>())
}
