//! Translation of formulas in LaTeX and in programs into the language of model files.
//!
//! Each notation is translated token by token, and [`super::parse`] then reads the result: one grammar, one set of
//! limits. Every token keeps its place in the original text. So an error of either stage points at the place where the
//! text is wrong.
//!
//! Invariant: nothing is guessed. A text that two people may read differently, such as `\sin q u` or `a/2 b`, is
//! refused with both ways to write it. Marks keep the meaning that they have in their language: `1/2` is 0 in C. A
//! [`Spell`]er gives the name of each symbol in the language of model files. Absent on purpose: statements and
//! vectors.

mod calls;
mod kind;
mod latex;
mod lexicon;
mod plain;
mod program;
mod quotient;
mod refusal;
mod spell;
mod symbol;
mod sympy;
mod unicode;

pub use kind::Notation;
pub use latex::read_symbol;
pub use plain::Plain;
pub(crate) use program::is_index;
pub use spell::{Spell, Unknown};
pub use symbol::Symbol;
pub use unicode::ascii_names;

use super::parse::ParseError;

/// Translates a formula into the language of model files; each token keeps its place in the original text.
///
/// # Errors
/// The first [`ParseError`] that belongs to the notation itself; other errors are found when the result is read.
pub fn translate(text: &str, notation: Notation, spell: &mut dyn Spell) -> Result<Plain, ParseError> {
    match notation {
        Notation::Tripos if text.is_ascii() => Ok(Plain::same(text)),
        Notation::Tripos => unicode::translate(text, spell),
        Notation::Latex => latex::translate(text, spell),
        Notation::Python | Notation::Matlab | Notation::C => program::translate(text, notation, spell),
    }
}
