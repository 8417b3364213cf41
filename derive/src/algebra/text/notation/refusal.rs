//! Errors in a formula of another notation, with their places.

use super::spell::Unknown;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// An error with its help.
pub(super) fn wrong(span: Range<usize>, message: impl Into<String>, help: &str) -> ParseError {
    ParseError { span, message: message.into(), help: Some(help.to_owned()) }
}

/// An error of a symbol that stands for nothing.
pub(super) fn unknown(span: Range<usize>, (message, help): Unknown) -> ParseError {
    ParseError { span, message, help }
}

/// The character that begins at a place, as messages show it.
pub(super) fn found(text: &str, at: usize) -> (String, Range<usize>) {
    let c = text[at..].chars().next().unwrap_or(' ');
    let shown = if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    (shown, at..at + c.len_utf8())
}
