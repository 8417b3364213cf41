//! Translation of formulas in LaTeX into the language of model files.

mod formula;
mod function;
mod marks;
mod symbol;

pub use symbol::read_symbol;

use super::plain::Plain;
use super::spell::Spell;
use crate::algebra::text::parse::ParseError;

/// Translates a formula of LaTeX math mode into the language of model files; `spell` names the
/// symbols. Error if the formula is ambiguous or not understood.
pub(super) fn translate(text: &str, spell: &mut dyn Spell) -> Result<Plain, ParseError> {
    let list = marks::marks(text)?;
    let cursor = symbol::Cursor { list: &list, at: 0, depth: 0, end: text.len() };
    formula::Formula { cursor, spell, out: Plain::new() }.whole()
}
