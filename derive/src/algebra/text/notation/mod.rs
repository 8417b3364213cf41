//! Notations of formulas: translation of LaTeX and of program text into the language of model
//! files.
//!
//! Each notation is translated token by token, and [`super::parse`] then reads the result: one
//! grammar, one set of limits. Every token keeps its place in the original text, so that every
//! error points at the place where the text is wrong.
//!
//! Invariant: nothing is guessed. A text that can be read in two ways is refused with both ways to
//! write it, for example `\sin q u` or `a/2 b`. Marks keep the meaning of their language: `1/2` is
//! 0 in C. A [`Spell`]er gives the name of each symbol in the language of model files.
//! Absent on purpose: statements and vectors.

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

/// Translates a formula from a notation into the language of model files. `spell` names the
/// symbols; each token keeps its place in the original text.
///
/// # Errors
/// First [`ParseError`] that belongs to the notation itself; other errors are found when the
/// translation is parsed.
pub fn translate(text: &str, notation: Notation, spell: &mut dyn Spell) -> Result<Plain, ParseError> {
    match notation {
        Notation::Tripos if text.is_ascii() => Ok(Plain::same(text)),
        Notation::Tripos => unicode::translate(text, spell),
        Notation::Latex => latex::translate(text, spell),
        Notation::Python | Notation::Matlab | Notation::C => program::translate(text, notation, spell),
    }
}
