//! Places and errors of CSV tables, in words.

use crate::diagnostic::Source;
use std::ops::Range;

/// Sentence about text that is no CSV table.
pub(crate) fn csv_error_message(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("a row has {}, but the head has {expected_len}", cells(*len))
        }
        _ => "the file is no CSV".to_owned(),
    }
}

/// Number of cells in words, such as `3 cells`.
fn cells(count: u64) -> String {
    if count == 1 { "one cell".to_owned() } else { format!("{count} cells") }
}

/// Place of the line that begins at or after a position, in the text of a file. Empty lines before it are skipped.
pub(crate) fn csv_line_span(source: &Source, position: &csv::Position) -> Range<usize> {
    let text = &source.text;
    let start = usize::try_from(position.byte()).unwrap_or(0).min(text.len());
    let Some(rest) = text.get(start..) else { return 0..0 };
    let start = start + (rest.len() - rest.trim_start().len());
    let length = text[start..].find(['\r', '\n']).unwrap_or(text.len() - start);
    start..start + length
}

/// Place of the head of a table: its first line.
pub(crate) fn csv_head_span(source: &Source) -> Range<usize> {
    0..source.text.find(['\r', '\n']).unwrap_or(source.text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of the first row that is no row.
    fn first_error(text: &str) -> csv::Error {
        csv::Reader::from_reader(text.as_bytes()).records().find_map(Result::err).unwrap()
    }

    #[test]
    fn a_row_of_another_length_is_said_in_words() {
        let error = first_error("t,q\n1,2\n3\n");
        assert_eq!(csv_error_message(&error), "a row has one cell, but the head has 2");
        let source = Source::from_text("data.csv", "t,q\n1,2\n3\n");
        assert_eq!(csv_line_span(&source, error.position().unwrap()), 8..9);
    }
}
