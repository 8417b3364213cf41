//! Reader of names of quantities, word by word: `v(P of disk) @ A [1]`.

use super::error::{ParseError, error};
use std::ops::Range;

/// A word of the text and its place, in bytes.
pub type Word<'a> = (&'a str, Range<usize>);

/// Place in a text, and the form of the quantity that should stand there.
pub struct Cursor<'a> {
    pub text: &'a str,
    pub at: usize,
    /// Help for errors: the form in which the quantity is written.
    pub form: &'static str,
}

impl<'a> Cursor<'a> {
    fn skip_space(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_whitespace()).len();
    }

    pub fn next_is(&self, mark: char) -> bool {
        self.text[self.at..].starts_with(mark)
    }

    /// Skips this word if it comes next; true if it did.
    pub fn takes(&mut self, word: &str) -> bool {
        let is_next = self.text[self.at..].strip_prefix(word).is_some_and(|rest| rest.starts_with(char::is_whitespace));
        if is_next {
            self.at += word.len();
            self.skip_space();
        }
        is_next
    }

    pub fn missing(&self, what: &str) -> ParseError {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        error(self.at..self.at + length, format!("{what} is missing here"), Some(self.form))
    }

    pub fn mark(&mut self, mark: char) -> Result<(), ParseError> {
        if !self.next_is(mark) {
            return Err(self.missing(&format!("`{mark}`")));
        }
        self.at += mark.len_utf8();
        self.skip_space();
        Ok(())
    }

    pub fn word(&mut self, what: &str) -> Result<Word<'a>, ParseError> {
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

    pub fn after(&mut self, mark: char, what: &str) -> Result<Word<'a>, ParseError> {
        self.mark(mark)?;
        self.word(what)
    }

    /// Reads `@ FRAME [COMPONENT]`, from its `@` on. Returns the frame and the axis, 0, 1 or 2.
    pub fn component(&mut self) -> Result<(Word<'a>, usize), ParseError> {
        let frame = self.after('@', "a frame")?;
        let (axis, place) = self.after('[', "a component")?;
        self.mark(']')?;
        let Some(axis) = ["1", "2", "3"].iter().position(|a| *a == axis) else {
            let message = format!("there is no component `{}`", crate::diagnostic::shown(axis));
            return Err(error(place, message, Some("components are 1, 2 and 3")));
        };
        Ok((frame, axis))
    }
}
