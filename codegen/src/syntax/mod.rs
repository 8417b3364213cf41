//! Syntax that languages with infix formulas share: formulas, statements and comments.
//!
//! A [`CodeWriter`] turns a planned [`Function`](crate::plan::Function) into text. A [`Syntax`] states how one
//! language spells numbers, calls, declarations and comments. It decides nothing about the computation. Rust is not
//! among these languages: its text is made of tokens.

mod formula;
mod writer;

pub use formula::{formula, number_literal};
pub use writer::{CodeWriter, Comments};

use crate::lines::wrap;
use std::fmt::Write;

/// Largest number of bytes in a line of comments or code.
pub const WIDTH: usize = 110;

/// Character for a space at which no line may be broken. The written text has a normal space in its place.
pub const FIRM_SPACE: char = '\u{a0}';

/// Returns a text whose spaces are replaced by firm spaces, so that no line is broken inside it.
#[must_use]
pub fn with_firm_spaces(text: &str) -> String {
    text.replace(' ', &FIRM_SPACE.to_string())
}

/// Returns the texts `name = value` of several variables, joined by `separator`. If there is more than one, no line
/// is broken inside an assignment.
#[must_use]
pub fn assignment_statements(list: &[(String, String)], separator: &str) -> String {
    let one = |(name, value): &(String, String)| {
        let text = format!("{name} = {value}");
        if list.len() > 1 { with_firm_spaces(&text) } else { text }
    };
    list.iter().map(one).collect::<Vec<_>>().join(separator)
}

/// Syntax of one language: the form of numbers, calls, declarations and comments.
pub trait Syntax {
    /// Returns the characters that begin a comment up to the end of the line.
    fn comment_mark(&self) -> &'static str;

    /// Returns a text that is safe in a comment of this language: on one line, without characters that end or change
    /// the comment.
    fn escape_comment(&self, text: &str) -> String;

    /// Returns the operators of multiplication and division, without spaces.
    fn operators(&self) -> [&'static str; 2] {
        ["*", "/"]
    }

    /// Returns the literal of a whole number, given by its digits.
    fn integer_literal(&self, digits: &str) -> String {
        digits.to_owned()
    }

    /// Returns the literal of a decimal number, given as decimal text. It also serves for whole numbers that are too
    /// long for integers.
    fn decimal_literal(&self, text: &str) -> String {
        text.to_owned()
    }

    /// Returns the constant "not a number".
    fn not_a_number(&self) -> &'static str;

    /// Returns the constant π.
    fn pi(&self) -> &'static str;

    /// Returns the call of the mathematical function that model files call `name`, with its
    /// argument.
    fn call(&self, name: &str, argument: &str) -> String;

    /// Returns the text of a power. The base is given in two forms: `argument` for a call, and `operand`, which is in
    /// parentheses if it has operators.
    fn power(&self, argument: &str, operand: &str, exponent: i32) -> String;

    /// True if products in sums are ordered as in Rust, where one product is fused with the sum. Results can then
    /// have the same bits as those of Rust.
    fn is_ordered_as_rust(&self) -> bool {
        false
    }

    /// Returns the expression for an entry of an array, counted from 0.
    fn entry(&self, array: &str, at: usize) -> String {
        format!("{array}[{at}]")
    }

    /// Writes statements that declare variables and set their values. The list must not be empty.
    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]);

    /// Returns statements that compute the sine and cosine of an angle at once. `None` if the
    /// language computes them separately.
    fn sine_and_cosine_statements(&self, _sine: &str, _cosine: &str, _angle: &str) -> Option<Vec<String>> {
        None
    }

    /// Writes a statement on as many lines as it needs. It must not contain string literals,
    /// because lines are broken at spaces.
    fn statement(&self, out: &mut String, indent: &str, text: &str) {
        for (at, part) in wrap(text, WIDTH - indent.len() - 4).iter().enumerate() {
            let hang = if at == 0 { "" } else { "    " };
            let _ = writeln!(out, "{indent}{hang}{}", part.replace(FIRM_SPACE, " "));
        }
    }
}
