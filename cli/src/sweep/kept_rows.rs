//! Rows of an unfinished table that are kept when its sweep is resumed.
//!
//! Invariant: the kept bytes are those that the sweep would write again: its header, then whole rows of its first
//! points, in order. A last row that was cut off is dropped. Any other content is refused.

use super::summary::Tally;
use super::table::Columns;
use std::io::{self, BufRead, BufReader, Read};
use std::ops::Range;

/// Part of an unfinished table that a resumed sweep keeps.
#[derive(Default)]
pub struct KeptRows {
    /// Number of whole rows of the unfinished table that are kept.
    pub rows: u64,
    /// Number of bytes of the table that are kept, including its header. 0 if the header was cut off.
    pub bytes: u64,
    /// Number of kept rows with each outcome.
    pub tally: Tally,
}

/// Reason why a sweep cannot continue an unfinished table.
pub enum UnfinishedTableMismatch {
    /// The table has content that this sweep would not write. The text is the reason.
    Other(String),
    /// The table cannot be read. The error is that of the system.
    Unread(io::Error),
}

impl KeptRows {
    /// Reads the part of an unfinished table that can be kept. `points` are the points of the sweep.
    ///
    /// # Errors
    /// [`UnfinishedTableMismatch`] if the table belongs to another sweep, or if it cannot be read.
    pub fn read(left: impl Read, columns: &Columns, points: &Range<u64>) -> Result<Self, UnfinishedTableMismatch> {
        let mut kept = Self::default();
        let mut lines = BufReader::new(left);
        let mut line = Vec::new();
        if !next_csv_line(&mut lines, &mut line).map_err(UnfinishedTableMismatch::Unread)? {
            return Ok(kept);
        }
        if line != columns.header() {
            return Err(UnfinishedTableMismatch::Other("its columns are others".to_owned()));
        }
        kept.bytes = line.len() as u64;
        while next_csv_line(&mut lines, &mut line).map_err(UnfinishedTableMismatch::Unread)? {
            let point = points.start + kept.rows;
            let number = kept.rows + 1;
            let other = || UnfinishedTableMismatch::Other(format!("row {number} is not that of point {point}"));
            if point >= points.end {
                return Err(UnfinishedTableMismatch::Other(format!(
                    "the table has more rows than the sweep has points, {}",
                    kept.rows
                )));
            }
            let fields = csv_fields(&line).filter(|fields| fields.len() == columns.count()).ok_or_else(other)?;
            if fields[0] != point.to_string() {
                return Err(other());
            }
            if let Some(name) = columns.first_without_number(&fields) {
                let why = format!("row {number} has no number in the column `{name}`");
                return Err(UnfinishedTableMismatch::Other(why));
            }
            let text = |at: usize| fields.get(at).filter(|text| !text.is_empty());
            let (warning, reason) = (text(columns.count() - 2), text(columns.count() - 1));
            kept.tally.count(point, &fields[columns.stop_column_index()], warning, reason);
            kept.rows += 1;
            kept.bytes += line.len() as u64;
        }
        Ok(kept)
    }
}

/// Reads the next line of CSV, which may contain line ends between quotes. Returns false if no whole line is left.
/// `Err` if the table cannot be read.
fn next_csv_line(lines: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    line.clear();
    loop {
        if lines.read_until(b'\n', line)? == 0 || !line.ends_with(b"\n") {
            return Ok(false);
        }
        // Quotes divide a line into pieces outside and inside quotes. A whole line has an odd number of pieces.
        let pieces = line.split(|byte| *byte == b'"').count();
        if pieces % 2 == 1 {
            return Ok(true);
        }
    }
}

/// Returns the fields of a line of CSV; `None` if it is no valid record.
fn csv_fields(line: &[u8]) -> Option<csv::StringRecord> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 10).from_reader(line);
    let mut record = csv::StringRecord::new();
    reader.read_record(&mut record).ok()?.then_some(record)
}
