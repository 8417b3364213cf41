//! Notations of formulas: translation of LaTeX and of program text into the language of model
//! files.
//!
//! Each notation is translated token by token, and [`super::parse`] then reads the result: one
//! grammar, one set of limits. Every token keeps its place in the original text, so that every
//! error points at the place where the text is wrong.
//!
//! Invariant: nothing is guessed. A text that can be read in two ways is refused, and the error
//! shows how to write each: for example `\sin q u` or `a/2 b`. Operators keep the meaning of their
//! language: `1/2` is 0 in C. A [`SymbolNames`] gives the name of each symbol in the language of
//! model files. Absent on purpose: statements and vectors.

mod calls;
mod function_names;
mod kind;
mod latex;
mod latex_symbol;
mod program;
mod program_derivatives;
mod quotient;
mod symbol_names;
mod translation;
mod translation_errors;
mod unicode;

pub use kind::Notation;
pub use latex::read_symbol;
pub use latex_symbol::LatexSymbol;
pub(crate) use program::is_program_index;
pub use symbol_names::{SymbolNames, Unknown};
pub use translation::Translation;
pub use unicode::ascii_names_of_unicode;

use super::parse::ParseError;

/// Translates a formula from a notation into the language of model files. `spell` gives the names
/// of symbols. Each token keeps its place in the original text.
///
/// # Errors
/// First [`ParseError`] that the notation itself causes. Other errors are found later, when the
/// translation is parsed.
pub fn translate(text: &str, notation: Notation, spell: &mut dyn SymbolNames) -> Result<Translation, ParseError> {
    match notation {
        Notation::Tripos if text.is_ascii() => Ok(Translation::unchanged(text)),
        Notation::Tripos => unicode::translate_unicode(text, spell),
        Notation::Latex => latex::translate(text, spell),
        Notation::Python | Notation::Matlab | Notation::C => program::translate(text, notation, spell),
    }
}
