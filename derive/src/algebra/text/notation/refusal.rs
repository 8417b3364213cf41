//! Errors in formulas that are written in LaTeX or in a program, with their places.

use super::spell::Unknown;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Creates an error with a help text.
pub(super) fn wrong(span: Range<usize>, message: impl Into<String>, help: &str) -> ParseError {
    ParseError { span, message: message.into(), help: Some(help.to_owned()) }
}

/// Creates the error for a symbol that has no name in the model.
pub(super) fn unknown(span: Range<usize>, (message, help): Unknown) -> ParseError {
    ParseError { span, message, help }
}

/// Character at byte `at` as messages show it, and its place.
pub(super) fn found(text: &str, at: usize) -> (String, Range<usize>) {
    let c = text[at..].chars().next().unwrap_or(' ');
    let shown = if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    (shown, at..at + c.len_utf8())
}
