//! Formula in the language of model files, as tokens that keep their places in the original text.

use std::ops::Range;

/// Formula in the language of model files, translated from another notation. Each token keeps its
/// place in the original text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Translation {
    /// Tokens of the translated formula, separated by spaces.
    text: String,
    /// Pairs of byte ranges for each token: in `text`, and in the original text. Empty if `text` is
    /// the original text.
    places: Vec<(Range<usize>, Range<usize>)>,
    /// True if `text` is the original text, unchanged.
    is_same: bool,
}

impl Translation {
    /// Wraps a text that is already in the language of model files.
    pub(super) fn unchanged(text: &str) -> Self {
        Self { text: text.to_owned(), places: Vec::new(), is_same: true }
    }

    /// Creates an empty formula, to which tokens are appended.
    pub(super) fn new() -> Self {
        Self { text: String::new(), places: Vec::new(), is_same: false }
    }

    /// Appends a token that was translated from the byte range `from` of the original text.
    pub(super) fn push(&mut self, token: &str, from: Range<usize>) {
        if !self.text.is_empty() {
            self.text.push(' ');
        }
        let start = self.text.len();
        self.text.push_str(token);
        self.places.push((start..self.text.len(), from));
    }

    /// Appends tokens that were all translated from the byte range `from` of the original text.
    pub(super) fn push_all(&mut self, tokens: &[&str], from: &Range<usize>) {
        for token in tokens {
            self.push(token, from.clone());
        }
    }

    /// Iterates over the tokens of the formula, with their byte ranges in the original text.
    pub(super) fn tokens(&self) -> impl DoubleEndedIterator<Item = (&str, &Range<usize>)> + Clone {
        self.places.iter().map(|(at, from)| (&self.text[at.clone()], from))
    }

    /// Text of the formula in the language of model files, for the parser.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Byte range of the original text that was translated into the byte range `part`.
    #[must_use]
    pub fn source_range(&self, part: Range<usize>) -> Range<usize> {
        if self.is_same {
            return part;
        }
        let last = self.places.last().map_or(0, |(_, from)| from.end);
        let inside = |at: &Range<usize>| at.end > part.start && at.start < part.end.max(part.start + 1);
        // Parentheses that come from a token such as \frac have the place of that token; their
        // content has a more exact place.
        let is_parenthesis = |at: &Range<usize>| matches!(&self.text[at.clone()], "(" | ")");
        let union = |skip: bool| {
            let touched = self.places.iter().filter(|(at, _)| inside(at) && !(skip && is_parenthesis(at)));
            touched.map(|(_, from)| from.clone()).reduce(|a, b| a.start.min(b.start)..a.end.max(b.end))
        };
        union(true).or_else(|| union(false)).unwrap_or(last..last)
    }
}
