//! Translation of formulas in LaTeX into the language of model files.

mod cursor;
mod formula;
mod function;
mod tokens;

pub use cursor::read_symbol;

use super::symbol_names::SymbolNames;
use super::translation::Translation;
use crate::algebra::text::parse::ParseError;

/// Translates a formula of LaTeX math mode into the language of model files; `spell` gives the
/// names of symbols. Error if the formula is ambiguous or not understood.
pub(super) fn translate(text: &str, spell: &mut dyn SymbolNames) -> Result<Translation, ParseError> {
    let list = tokens::tokens(text)?;
    let cursor = cursor::LatexCursor { list: &list, at: 0, depth: 0, end: text.len() };
    formula::Formula { cursor, spell, out: Translation::new() }.whole()
}
