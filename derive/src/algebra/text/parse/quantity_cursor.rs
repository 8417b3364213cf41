//! Cursor that reads the name of a quantity, such as `v(P of disk) @ A [1]`, word by word.

use super::error::{ParseError, error};
use std::ops::Range;

/// Word of a text, with its place as a byte range.
pub type Word<'a> = (&'a str, Range<usize>);

/// Position in a text at which the name of a quantity is read.
pub struct QuantityCursor<'a> {
    /// Whole text of the expression.
    pub text: &'a str,
    /// Position of the next character, in bytes.
    pub at: usize,
    /// Help text for errors: the syntax of the quantity.
    pub form: &'static str,
}

impl<'a> QuantityCursor<'a> {
    fn skip_space(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_whitespace()).len();
    }

    /// True if the character `mark` comes next.
    pub fn next_is(&self, mark: char) -> bool {
        self.text[self.at..].starts_with(mark)
    }

    /// Skips the word `word` and the space after it, if both come next. Returns true if they were
    /// skipped.
    pub fn takes(&mut self, word: &str) -> bool {
        let is_next = self.text[self.at..].strip_prefix(word).is_some_and(|rest| rest.starts_with(char::is_whitespace));
        if is_next {
            self.at += word.len();
            self.skip_space();
        }
        is_next
    }

    /// Creates the error that `what` is missing at the present position.
    pub fn missing(&self, what: &str) -> ParseError {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        error(self.at..self.at + length, format!("{what} is missing here"), Some(self.form))
    }

    /// Skips the character `mark` and the space after it. Error if another character comes next.
    pub fn mark(&mut self, mark: char) -> Result<(), ParseError> {
        if !self.next_is(mark) {
            return Err(self.missing(&format!("`{mark}`")));
        }
        self.at += mark.len_utf8();
        self.skip_space();
        Ok(())
    }

    /// Reads a word of ASCII letters, digits and underscores. Error if no word comes next; `what`
    /// says in the message which word is missing.
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

    /// Skips the character `mark`, then reads a word. Error if either is missing; `what` says in
    /// the message which word is missing.
    pub fn after(&mut self, mark: char, what: &str) -> Result<Word<'a>, ParseError> {
        self.mark(mark)?;
        self.word(what)
    }

    /// Reads `@ FRAME [COMPONENT]`. Returns the frame, and the axis as 0, 1 or 2. Error if the
    /// syntax is wrong or the component is not 1, 2 or 3.
    pub fn component(&mut self) -> Result<(Word<'a>, usize), ParseError> {
        let frame = self.after('@', "a frame")?;
        let (axis, place) = self.after('[', "a component")?;
        self.mark(']')?;
        let Some(axis) = ["1", "2", "3"].iter().position(|a| *a == axis) else {
            let message = format!("there is no component `{}`", crate::diagnostic::shortened_for_message(axis));
            return Err(error(place, message, Some("components are 1, 2 and 3")));
        };
        Ok((frame, axis))
    }
}
