//! Glossary of a document: definitions of the names in the document's formulas.
//!
//! Invariant: a document defines every name that it contains.

use crate::phrases::NAMED_TERMS_HEADING;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use tripos_derive::algebra::text::definitions::definitions_shown;
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::{Arena, Expr};

/// Returns a paragraph that defines every name in the formulas `shown`. Each line uses only names of earlier lines.
/// Empty if the formulas contain no names.
pub fn glossary_text(arena: &Arena, shown: &[Expr]) -> String {
    let names = definitions_shown(arena, shown);
    if names.is_empty() {
        return String::new();
    }
    let mut out = format!("\n{NAMED_TERMS_HEADING}, each line by those before it\n");
    for definition in names {
        let _ =
            writeln!(out, "  {} = {}", print_text(arena, definition.symbol), print_whole_text(arena, definition.value));
    }
    out
}

/// Returns the definitions of every name in the formulas `shown` as a JSON object.
pub fn glossary_json(arena: &Arena, shown: &[Expr]) -> Value {
    let names = definitions_shown(arena, shown).into_iter();
    Value::Object(
        names.map(|d| (print_text(arena, d.symbol), json!(print_whole_text(arena, d.value)))).collect::<Map<_, _>>(),
    )
}
