//! Text that is assembled from parts of an author's file. Every byte keeps its place in the file.

use std::ops::Range;

/// Text with the place of each of its bytes in the author's file.
#[derive(Clone, Debug, Default)]
pub struct TracedText {
    /// Text assembled from parts of the author's file.
    pub text: String,
    /// Place of each byte of the text in the author's file, as a byte range (start, end).
    pub places: Vec<(u32, u32)>,
}

/// Error in an author's file, with its place, a message and advice.
#[derive(Clone, Debug)]
pub struct TracedError {
    /// Byte range of the error in the author's file.
    pub place: Range<usize>,
    /// Message that says what is wrong.
    pub message: String,
    /// Advice on how to correct the error.
    pub help: String,
}

impl TracedError {
    pub fn new(place: Range<usize>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { place, message: message.into(), help: help.into() }
    }
}

/// Byte position as a 32-bit number, which is enough since files are far smaller than 4 GiB.
fn traced_place(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

impl TracedText {
    /// Creates the text `text`, which begins at byte `start` of the author's file.
    pub fn text_at_place(text: &str, start: usize) -> Self {
        let places = (start..start + text.len()).map(|at| (traced_place(at), traced_place(at + 1))).collect();
        Self { text: text.to_owned(), places }
    }

    /// Creates a text in which every byte has the same place, a byte range in the author's file.
    pub fn from_place(text: &str, place: &Range<usize>) -> Self {
        Self { text: text.to_owned(), places: vec![(traced_place(place.start), traced_place(place.end)); text.len()] }
    }

    /// Appends a text in which every byte has the place `place`, a byte range in the author's file.
    pub fn push_with_place(&mut self, text: &str, place: &Range<usize>) {
        self.text.push_str(text);
        self.places.extend(std::iter::repeat_n((traced_place(place.start), traced_place(place.end)), text.len()));
    }

    /// Appends the bytes `range` of another text, with their places.
    pub fn push_part(&mut self, other: &Self, range: Range<usize>) {
        self.text.push_str(&other.text[range.clone()]);
        self.places.extend_from_slice(&other.places[range]);
    }

    /// Part of the text, given by a byte range, with its places in the author's file.
    pub fn part_with_places(&self, range: Range<usize>) -> Self {
        Self { text: self.text[range.clone()].to_owned(), places: self.places[range].to_vec() }
    }

    /// Byte range in the author's file of a part of the text. For an empty part, the range of the nearest byte.
    pub fn place_of_part(&self, range: Range<usize>) -> Range<usize> {
        let last = self.places.len();
        let inside = &self.places[range.start.min(last)..range.end.min(last).max(range.start.min(last))];
        let bounds = inside.iter().copied().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        let bounds = bounds.or_else(|| self.places.get(range.start).map(|place| (place.0, place.0)));
        let bounds = bounds.or_else(|| self.places.last().map(|place| (place.1, place.1))).unwrap_or_default();
        bounds.0 as usize..bounds.1 as usize
    }

    /// Text in a single line: every run of spaces and line breaks becomes one space, and both ends are trimmed.
    pub fn in_one_line(&self) -> Self {
        let mut line = Self::default();
        for (at, c) in self.text.char_indices() {
            if !c.is_whitespace() {
                line.push_part(self, at..at + c.len_utf8());
            } else if !line.text.is_empty() && !line.text.ends_with(' ') {
                line.push_with_place(" ", &self.place_of_part(at..at + c.len_utf8()));
            }
        }
        if line.text.ends_with(' ') {
            line.text.pop();
            line.places.pop();
        }
        line
    }
}
