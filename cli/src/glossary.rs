//! Definitions of the names that a document shows.
//!
//! Invariant: a name stands in no document that does not define it.

use crate::words::NAMED;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use tripos_derive::algebra::text::definitions::glossary;
use tripos_derive::algebra::text::print::{text, whole_text};
use tripos_derive::algebra::{Arena, Expr};

/// A paragraph that defines every name in the formulas that are shown, each by those before it; empty without names.
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

/// Every name in the formulas that are shown, with its formula.
pub fn names_json(arena: &Arena, shown: &[Expr]) -> Value {
    let names = glossary(arena, shown).into_iter();
    Value::Object(names.map(|d| (text(arena, d.symbol), json!(whole_text(arena, d.value)))).collect::<Map<_, _>>())
}
