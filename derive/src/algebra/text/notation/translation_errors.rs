//! Errors in formulas written in LaTeX or program text, with their places.

use super::symbol_names::Unknown;
use crate::algebra::text::parse::ParseError;
use crate::plain_text::with_visible_characters;
use std::ops::Range;

/// Creates an error with a place, a message and a help text.
pub(super) fn translation_error(span: Range<usize>, message: impl Into<String>, help: &str) -> ParseError {
    ParseError { span, message: message.into(), help: Some(help.to_owned()) }
}

/// Creates the error for a symbol that has no name in the model, from its message and help.
pub(super) fn untranslatable_symbol_error(span: Range<usize>, (message, help): Unknown) -> ParseError {
    ParseError { span, message, help }
}

/// Character at byte `at` in the form in which error messages show it, with its byte range.
pub(super) fn character_at(text: &str, at: usize) -> (String, Range<usize>) {
    let c = text[at..].chars().next().unwrap_or(' ');
    let shown = with_visible_characters(&c.to_string()).replace('\n', "\\n");
    (shown, at..at + c.len_utf8())
}
