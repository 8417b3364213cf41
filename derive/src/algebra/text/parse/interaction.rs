//! Interactions in expressions: components of the force or torque that one body exerts on another
//! through the elements that connect them. They are written `force(base on arm) @ N [1]`,
//! `torque(base on arm) @ arm_frame [3]` or `torque(base on arm about P) @ N [3]`.

use super::error::ParseError;
use super::quantity_cursor::{QuantityCursor, Word};

/// Name of a component of the force or torque that one body exerts on another. The parser does not
/// check that its bodies, point and frame exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InteractionName<'a> {
    /// True for a torque, false for a force.
    pub is_torque: bool,
    /// Body that exerts the force or torque.
    pub by: Word<'a>,
    /// Body that the force or torque acts on.
    pub on: Word<'a>,
    /// Point about which the torque is taken; `None` if the text names none.
    pub about: Option<Word<'a>>,
    /// Frame along whose axis the component is taken.
    pub frame: Word<'a>,
    /// Axis of the frame along which the component is taken: 0, 1 or 2.
    pub axis: usize,
}

/// Help text for errors: the syntax of a force and a torque.
const FORM: &str =
    "write force(BODY on BODY) @ FRAME [1], or torque(BODY on BODY about POINT) @ FRAME [1]; `ground` is a body here";

/// True if a word before a parenthesis begins a force or torque between bodies: `force` or
/// `torque`.
pub(super) fn is_interaction(word: &str) -> bool {
    ["force", "torque"].contains(&word)
}

impl<'a> InteractionName<'a> {
    /// Reads the name of a force or torque, beginning with its opening parenthesis at byte `at`.
    /// `word` is its keyword. Returns the name and the byte where it ends. Error if the syntax is
    /// wrong.
    pub(super) fn read(word: &str, text: &'a str, at: usize) -> Result<(Self, usize), ParseError> {
        let mut cursor = QuantityCursor { text, at, form: FORM };
        let is_torque = word == "torque";
        cursor.mark('(')?;
        let by = cursor.word("a body")?;
        if !cursor.takes("on") {
            return Err(cursor.missing("`on`"));
        }
        let on = cursor.word("a body")?;
        let about = if is_torque && cursor.takes("about") { Some(cursor.word("a point")?) } else { None };
        cursor.mark(')')?;
        let (frame, axis) = cursor.component()?;
        Ok((Self { is_torque, by, on, about, frame, axis }, cursor.at))
    }

    /// Canonical text of the name, independent of spaces: `force(base on arm) @ N [1]`.
    #[must_use]
    pub fn text(&self) -> String {
        let what = if self.is_torque { "torque" } else { "force" };
        let about = self.about.as_ref().map_or_else(String::new, |(point, _)| format!(" about {point}"));
        format!("{what}({} on {}{about}) @ {} [{}]", self.by.0, self.on.0, self.frame.0, self.axis + 1)
    }
}
