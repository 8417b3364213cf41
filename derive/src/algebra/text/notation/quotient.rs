//! Quotients of integers in C. C rounds them towards zero, so they are refused.

use super::translation::Translation;
use super::translation_errors::translation_error;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// State of one level of parentheses while the tokens of a formula are read.
#[derive(Default)]
struct Level {
    /// True if an earlier term of the sum is not an integer.
    is_real: bool,
    /// True if the current term is an integer so far; `None` if no operand was read yet.
    term: Option<bool>,
    /// Place of the slash before the next operand; `None` if no slash was read.
    slash: Option<Range<usize>>,
}

/// Checks a translated C formula for quotients of two integers, which C rounds: `1/2` is 0. Error
/// at the first such quotient.
pub(super) fn refuse_whole_quotients(plain: &Translation) -> Result<(), ParseError> {
    let mut levels = vec![Level::default()];
    for (token, place) in plain.tokens() {
        let Some(level) = levels.last_mut() else { return Ok(()) };
        match token {
            "(" => levels.push(Level::default()),
            ")" => {
                let inner = levels.pop().unwrap_or_default();
                let Some(outer) = levels.last_mut() else { return Ok(()) };
                let is_whole = !inner.is_real && inner.term != Some(false);
                add_quotient_operand(outer, if is_whole { Operand::Whole } else { Operand::Real })?;
            }
            "/" => level.slash = Some(place.clone()),
            // Powers and functions of several arguments have real values in C.
            "^" => level.term = Some(false),
            "," => *level = Level { is_real: true, ..Level::default() },
            "+" | "-" => {
                level.is_real |= level.term == Some(false);
                level.term = None;
            }
            "*" => {}
            number if number.bytes().all(|b| b.is_ascii_digit()) => add_quotient_operand(level, Operand::Whole)?,
            _ => add_quotient_operand(level, Operand::Real)?,
        }
    }
    Ok(())
}

/// Type of an operand in C.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Operand {
    /// Integer, or a term of integers in parentheses.
    Whole,
    /// Number with decimals, variable, or a term that contains either.
    Real,
}

/// Adds an operand to the current term of a level. Error if it divides an integer by an integer.
fn add_quotient_operand(level: &mut Level, operand: Operand) -> Result<(), ParseError> {
    let is_whole = operand == Operand::Whole;
    if let Some(slash) = level.slash.take().filter(|_| is_whole && level.term == Some(true)) {
        let help = "C rounds quotients of whole numbers towards zero: 1/2 is 0; write 1.0/2 if the program has it so";
        return Err(translation_error(slash, "a quotient of whole numbers", help));
    }
    level.term = Some(is_whole && level.term != Some(false));
    Ok(())
}
