//! A component of a velocity as it is written: `v(P) @ A [1]`, of a point, and `v(disk, P) @ A [1]`, of the material of
//! a body that is at a point.

use super::error::{ParseError, error};
use std::ops::Range;

/// A word of the text and its place.
pub type Word<'a> = (&'a str, Range<usize>);

/// A component of a velocity, by names that the algebra knows nothing of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VelocityName<'a> {
    /// The body whose material is meant; none for the point itself.
    pub body: Option<Word<'a>>,
    /// The point.
    pub point: Word<'a>,
    /// The frame of the component.
    pub frame: Word<'a>,
    /// The axis of the component: 0, 1 or 2.
    pub axis: usize,
}

/// What to write.
const FORM: &str = "write v(POINT) @ FRAME [1], or v(BODY, POINT) @ FRAME [1] for the material of a body";

impl<'a> VelocityName<'a> {
    /// Reads what follows the `v` of a velocity, from its parenthesis on; returns with it where it ends.
    pub(super) fn read(text: &'a str, at: usize) -> Result<(Self, usize), ParseError> {
        let mut cursor = Cursor { text, at };
        cursor.mark('(')?;
        let first = cursor.word("a point")?;
        let second = if cursor.next_is(',') { Some(cursor.after(',', "a point")?) } else { None };
        cursor.mark(')')?;
        let frame = cursor.after('@', "a frame")?;
        let (axis, place) = cursor.after('[', "a component")?;
        cursor.mark(']')?;
        let Some(axis) = ["1", "2", "3"].iter().position(|a| *a == axis) else {
            let message = format!("there is no component `{}`", crate::diagnostic::shown(axis));
            return Err(error(place, message, Some("components are 1, 2 and 3")));
        };
        let (body, point) = match second {
            Some(point) => (Some(first), point),
            None => (None, first),
        };
        Ok((Self { body, point, frame, axis }, cursor.at))
    }

    /// The name in one form, however it was written.
    #[must_use]
    pub fn text(&self) -> String {
        let (body, point, frame) = (self.body.as_ref().map(|(body, _)| *body), self.point.0, self.frame.0);
        canonical(body, point, frame, self.axis)
    }
}

/// The name of a component of a velocity, of the material of `body` if there is one: `v(disk, P) @ A [1]`.
#[must_use]
pub fn canonical(body: Option<&str>, point: &str, frame: &str, axis: usize) -> String {
    let of = body.map_or_else(|| point.to_owned(), |body| format!("{body}, {point}"));
    format!("v({of}) @ {frame} [{}]", axis + 1)
}

struct Cursor<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Cursor<'a> {
    fn skip_space(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_whitespace()).len();
    }

    fn next_is(&self, mark: char) -> bool {
        self.text[self.at..].starts_with(mark)
    }

    fn missing(&self, what: &str) -> ParseError {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        error(self.at..self.at + length, format!("{what} is missing here"), Some(FORM))
    }

    fn mark(&mut self, mark: char) -> Result<(), ParseError> {
        if !self.next_is(mark) {
            return Err(self.missing(&format!("`{mark}`")));
        }
        self.at += mark.len_utf8();
        self.skip_space();
        Ok(())
    }

    fn word(&mut self, what: &str) -> Result<Word<'a>, ParseError> {
        let rest = &self.text[self.at..];
        let length = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        if length == 0 {
            return Err(self.missing(what));
        }
        let place = self.at..self.at + length;
        self.at = place.end;
        self.skip_space();
        Ok((&self.text[place.clone()], place))
    }

    fn after(&mut self, mark: char, what: &str) -> Result<Word<'a>, ParseError> {
        self.mark(mark)?;
        self.word(what)
    }
}
