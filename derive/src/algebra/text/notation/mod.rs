//! Formulas as people have them, in LaTeX and in programs, as formulas of the language of model files.
//!
//! Each notation is read token by token into tokens of that language, which [`super::parse`] then reads: one grammar,
//! one set of limits. Every token keeps its place in the original text. So an error of either stage points at the place
//! where the text is wrong.
//!
//! Invariant: nothing is guessed. A text that two people may read differently, such as `\sin q u` or `a/2 b`, is
//! refused with both ways to write it. Marks keep the meaning that they have in their language: `1/2` is 0 in C. The
//! name of a symbol in the language of model files is asked of a [`Spell`]er. Absent on purpose: statements, vectors,
//! and derivatives of anything but symbols.

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

pub use kind::Notation;
pub use latex::read_symbol;
pub use plain::Plain;
pub use spell::{Spell, Unknown};
pub use symbol::Symbol;

use super::parse::ParseError;

/// A formula in the language of model files, each token with its place in the text.
///
/// # Errors
/// The first [`ParseError`] in the text that is the notation's own; others are found when the result is read.
pub fn translate(text: &str, notation: Notation, spell: &mut dyn Spell) -> Result<Plain, ParseError> {
    match notation {
        Notation::Tripos => Ok(Plain::same(text)),
        Notation::Latex => latex::translate(text, spell),
        Notation::Python | Notation::Matlab | Notation::C => program::translate(text, notation, spell),
    }
}
