//! Errors in the text of an expression: place, description and advice.

use crate::algebra::{Arena, PowerError};
use crate::plain_text::with_visible_characters;
use std::ops::Range;

/// Error in the text of an expression, with its place, a description and advice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Place of the error, as a byte range of the text.
    pub span: Range<usize>,
    /// Description of the error.
    pub message: String,
    /// Advice on how to correct the text; `None` if there is none.
    pub help: Option<String>,
}

impl ParseError {
    /// Creates the error for an unexpected character at byte `at`, or for an early end of the text.
    /// `primes` is the largest number of primes that a name may end in; the advice depends on it.
    pub(super) fn unexpected(text: &str, at: usize, primes: usize) -> Self {
        let Some(found) = text[at..].chars().next() else {
            return error(at..at, "the expression ends too early", Some("an operand is missing here"));
        };
        let span = at..at + found.len_utf8();
        let before = text[..at].trim_end();
        let alone = before.is_empty() || before.ends_with(['+', '-', '*', '/', '^', '(']);
        if !alone && is_degree(&text[at..]) {
            let help =
                "angles are in radians: in a scene or state write 90 degrees as `90*deg`, in a model as `90*pi/180`";
            return error(span, "an operator is missing here", Some(help));
        }
        if !alone && (found.is_ascii_alphanumeric() || found == '(' || found == '_') {
            return error(span, "an operator is missing here", Some("write products with `*`, as in `2*q1`"));
        }
        let help = match found {
            '\'' if primes > 1 => "a prime stands right after a name, as in q1' and q1''",
            '\'' => "one prime only, as in q1', and only after a coordinate; second derivatives are derived",
            '.' => "a time derivative is written with a prime: q1'",
            '*' if before.ends_with('*') => "powers are written with `^`",
            ')' if alone => "an operand is missing here",
            ')' => "there is no `(` to close here",
            '+' | '-' | '*' | '/' | '^' => "an operand is missing here",
            ',' => "functions have one argument; decimals are written with a point",
            '=' => "an expression has no `=`",
            '<' | '>' => "only [domain] may contain inequalities, one in each condition",
            '−' | '–' => "use the ASCII minus `-`",
            '·' | '×' => "use `*` for products",
            '°' => "angles are in radians: write `10*pi/180`",
            '²' | '³' => "write powers with `^`",
            'π' => "write `pi`",
            '√' => "write `sqrt(…)`",
            '’' | '′' | '`' => "the prime is the ASCII apostrophe: q1'",
            _ if found.is_alphabetic() => "names have ASCII letters only: write `alpha` for the Greek letter",
            _ => "allowed are numbers, names, + - * / ^ ( ) and functions such as sin(q1)",
        };
        let found = with_visible_characters(&found.to_string()).replace('\n', "\\n");
        error(span, format!("unexpected `{found}`"), Some(help))
    }

    /// Creates the error for a power that cannot be built: a division by zero, or a power that is
    /// too large.
    pub(super) fn power(span: Range<usize>, kind: PowerError) -> Self {
        match kind {
            PowerError::DivisionByZero => error(span, "division by zero", Some("this divisor is zero")),
            PowerError::TooLarge => {
                let limit =
                    format!("exponents reach to ±{}, numbers to about 30 000 digits", Arena::MAX_WRITTEN_EXPONENT);
                error(span, "this power is too large", Some(&limit))
            }
        }
    }
}

/// Creates an error with a place, a message and an optional help text.
pub(super) fn error(span: Range<usize>, message: impl Into<String>, help: Option<&str>) -> ParseError {
    ParseError { span, message: message.into(), help: help.map(str::to_owned) }
}

/// True if the text begins with a word or sign for degrees, such as `deg` or `°`.
fn is_degree(text: &str) -> bool {
    let word: String = text.chars().take_while(|c| c.is_alphanumeric() || *c == '°').collect();
    matches!(word.as_str(), "deg" | "degree" | "degrees" | "°")
}
