//! Text that languages with infix formulas have in common: formulas, statements and comments.
//!
//! The flow: a planned [`Function`](crate::plan::Function) → a [`Writer`] → text. A [`Syntax`] states how one language
//! spells numbers, calls, declarations and comments; it decides nothing about the computation. Rust is not among these
//! languages: its text is made of tokens.

mod formula;
mod writer;

pub use formula::{constant, formula};
pub use writer::{Comments, Writer};

use crate::lines::wrap;
use std::fmt::Write;

/// Most bytes of a line of comments and code.
pub const WIDTH: usize = 110;

/// Space at which no statement is broken; it is written as a space.
pub const FIRM_SPACE: char = '\u{a0}';

/// Text in which no statement is broken.
#[must_use]
pub fn firm(text: &str) -> String {
    text.replace(' ', &FIRM_SPACE.to_string())
}

/// Texts `name = value` of several variables, separated by `separator`. If there are several, no line ends inside one.
#[must_use]
pub fn assigned(list: &[(String, String)], separator: &str) -> String {
    let one = |(name, value): &(String, String)| {
        let text = format!("{name} = {value}");
        if list.len() > 1 { firm(&text) } else { text }
    };
    list.iter().map(one).collect::<Vec<_>>().join(separator)
}

/// Spelling of one language.
pub trait Syntax {
    /// Characters that begin a comment up to the end of the line.
    fn comment_mark(&self) -> &'static str;

    /// Text of a comment in one line, with nothing that the language would read as more than a comment.
    fn harmless(&self, text: &str) -> String;

    /// Operators of multiplication and division, without spaces.
    fn operators(&self) -> [&'static str; 2] {
        ["*", "/"]
    }

    /// Literal of a whole number, given by its digits.
    fn whole(&self, digits: &str) -> String {
        digits.to_owned()
    }

    /// Literal of a number that is not whole, or too long for a whole one, given in decimals.
    fn decimal(&self, text: &str) -> String {
        text.to_owned()
    }

    /// Value "not a number".
    fn not_a_number(&self) -> &'static str;

    /// Ratio of a circle's circumference to its diameter.
    fn pi(&self) -> &'static str;

    /// Call of a function that model files know by this name, with its argument.
    fn call(&self, name: &str, argument: &str) -> String;

    /// Power of a base, which is given as an argument of a call and as an operand: in parentheses if it has operators.
    fn power(&self, argument: &str, operand: &str, exponent: i32) -> String;

    /// True if products in sums are ordered as in Rust, where one of them is fused, so that results have equal bits.
    fn is_ordered_as_rust(&self) -> bool {
        false
    }

    /// Entry of an array, counted from 0.
    fn entry(&self, array: &str, at: usize) -> String {
        format!("{array}[{at}]")
    }

    /// Writes statements that declare variables with their values; there is at least one.
    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]);

    /// Statements that declare the sine and the cosine of an angle at once; `None` if the language computes them one
    /// by one.
    fn circular(&self, _sine: &str, _cosine: &str, _angle: &str) -> Option<Vec<String>> {
        None
    }

    /// Writes a statement without string literals on as many lines as it needs.
    fn statement(&self, out: &mut String, indent: &str, text: &str) {
        for (at, part) in wrap(text, WIDTH - indent.len() - 4).iter().enumerate() {
            let hang = if at == 0 { "" } else { "    " };
            let _ = writeln!(out, "{indent}{hang}{}", part.replace(FIRM_SPACE, " "));
        }
    }
}
