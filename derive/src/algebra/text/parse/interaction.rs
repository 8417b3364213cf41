//! A component of the force or torque that one body exerts on another through the elements that connect them, as it is
//! written: `force(base on arm) @ N [1]`, `torque(base on arm) @ arm_frame [3]`, `torque(base on arm about P) @ N [3]`.

use super::cursor::{Cursor, Word};
use super::error::ParseError;

/// A component of a force or of a torque between two bodies, by names that the algebra knows nothing of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InteractionName<'a> {
    /// True for a torque, false for a force.
    pub is_torque: bool,
    /// The body that exerts it.
    pub by: Word<'a>,
    /// The body that feels it.
    pub on: Word<'a>,
    /// The point about which a torque is meant, if it is named.
    pub about: Option<Word<'a>>,
    /// The frame of the component.
    pub frame: Word<'a>,
    /// The axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// Help for errors: the forms of a force and a torque.
const FORM: &str =
    "write force(BODY on BODY) @ FRAME [1], or torque(BODY on BODY about POINT) @ FRAME [1]; `ground` is a body here";

/// True if an interaction is written with this word in front of its parenthesis.
pub(super) fn is_interaction(word: &str) -> bool {
    ["force", "torque"].contains(&word)
}

impl<'a> InteractionName<'a> {
    /// Reads what follows the `word` of an interaction, from its parenthesis on; returns with it where it ends.
    pub(super) fn read(word: &str, text: &'a str, at: usize) -> Result<(Self, usize), ParseError> {
        let mut cursor = Cursor { text, at, form: FORM };
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

    /// The name in one form, however it was written.
    #[must_use]
    pub fn text(&self) -> String {
        let what = if self.is_torque { "torque" } else { "force" };
        let about = self.about.as_ref().map_or_else(String::new, |(point, _)| format!(" about {point}"));
        format!("{what}({} on {}{about}) @ {} [{}]", self.by.0, self.on.0, self.frame.0, self.axis + 1)
    }
}
