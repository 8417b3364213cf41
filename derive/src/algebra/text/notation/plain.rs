//! Tokens of the language of model files with the places that they are from.

use std::ops::Range;

/// A formula in the language of model files, made of another notation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plain {
    /// The tokens, a space between them.
    text: String,
    /// Each token's place in the text, and where it is from; empty for a text that is its own source.
    places: Vec<(Range<usize>, Range<usize>)>,
    /// True if the text is the original one, unchanged.
    is_same: bool,
}

impl Plain {
    /// A text that is in the language already.
    pub(super) fn same(text: &str) -> Self {
        Self { text: text.to_owned(), places: Vec::new(), is_same: true }
    }

    pub(super) fn new() -> Self {
        Self { text: String::new(), places: Vec::new(), is_same: false }
    }

    /// Appends a token.
    pub(super) fn push(&mut self, token: &str, from: Range<usize>) {
        if !self.text.is_empty() {
            self.text.push(' ');
        }
        let start = self.text.len();
        self.text.push_str(token);
        self.places.push((start..self.text.len(), from));
    }

    /// Appends tokens that one mark stands for.
    pub(super) fn push_all(&mut self, tokens: &[&str], from: &Range<usize>) {
        for token in tokens {
            self.push(token, from.clone());
        }
    }

    /// The tokens, with the places that they are from.
    pub(super) fn tokens(&self) -> impl DoubleEndedIterator<Item = (&str, &Range<usize>)> + Clone {
        self.places.iter().map(|(at, from)| (&self.text[at.clone()], from))
    }

    /// The text, for the parser.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Range of the source that a part of the text comes from.
    #[must_use]
    pub fn source(&self, part: Range<usize>) -> Range<usize> {
        if self.is_same {
            return part;
        }
        let last = self.places.last().map_or(0, |(_, from)| from.end);
        let inside = |at: &Range<usize>| at.end > part.start && at.start < part.end.max(part.start + 1);
        // Parentheses that a mark such as \frac stands for are where that is: what they are around says more.
        let is_parenthesis = |at: &Range<usize>| matches!(&self.text[at.clone()], "(" | ")");
        let union = |skip: bool| {
            let touched = self.places.iter().filter(|(at, _)| inside(at) && !(skip && is_parenthesis(at)));
            touched.map(|(_, from)| from.clone()).reduce(|a, b| a.start.min(b.start)..a.end.max(b.end))
        };
        union(true).or_else(|| union(false)).unwrap_or(last..last)
    }
}
