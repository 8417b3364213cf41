//! Quotients of whole numbers, which C rounds towards zero.

use super::plain::Plain;
use super::refusal::wrong;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// State of one level of parentheses while it is read.
#[derive(Default)]
struct Level {
    /// True if a term before the current one is not a whole number.
    is_real: bool,
    /// True if the current term is whole so far; `None` if it has not begun.
    term: Option<bool>,
    /// Place of the slash in front of the next operand; `None` without a slash.
    slash: Option<Range<usize>>,
}

/// Refuses a quotient of two whole numbers, as C computes it: `1/2` is 0.
pub(super) fn refuse_whole_quotients(plain: &Plain) -> Result<(), ParseError> {
    let mut levels = vec![Level::default()];
    for (token, place) in plain.tokens() {
        let Some(level) = levels.last_mut() else { return Ok(()) };
        match token {
            "(" => levels.push(Level::default()),
            ")" => {
                let inner = levels.pop().unwrap_or_default();
                let Some(outer) = levels.last_mut() else { return Ok(()) };
                let is_whole = !inner.is_real && inner.term != Some(false);
                operand(outer, if is_whole { Operand::Whole } else { Operand::Real })?;
            }
            "/" => level.slash = Some(place.clone()),
            // Powers and functions of several arguments are real.
            "^" => level.term = Some(false),
            "," => *level = Level { is_real: true, ..Level::default() },
            "+" | "-" => {
                level.is_real |= level.term == Some(false);
                level.term = None;
            }
            "*" => {}
            number if number.bytes().all(|b| b.is_ascii_digit()) => operand(level, Operand::Whole)?,
            _ => operand(level, Operand::Real)?,
        }
    }
    Ok(())
}

/// Kind of an operand in C.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Operand {
    /// Whole number, or a term of whole numbers in parentheses.
    Whole,
    /// Number with decimals, variable, or term that contains one.
    Real,
}

/// Takes an operand into the term of a level.
fn operand(level: &mut Level, operand: Operand) -> Result<(), ParseError> {
    let is_whole = operand == Operand::Whole;
    if let Some(slash) = level.slash.take().filter(|_| is_whole && level.term == Some(true)) {
        let help = "C rounds quotients of whole numbers towards zero: 1/2 is 0; write 1.0/2 if the program has it so";
        return Err(wrong(slash, "a quotient of whole numbers", help));
    }
    level.term = Some(is_whole && level.term != Some(false));
    Ok(())
}
