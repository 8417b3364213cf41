//! Rows of an unfinished table that are kept when its sweep is resumed.
//!
//! Invariant: the kept bytes are those that the sweep would write again: its header, then whole rows of its first
//! points, in order. A last row that was cut off is dropped; any other content is refused.

use super::summary::Tally;
use super::table::Columns;
use std::io::{self, BufRead, BufReader, Read};
use std::ops::Range;

/// Kept part of an unfinished table.
#[derive(Default)]
pub struct KeptRows {
    /// Number of whole rows that are kept.
    pub rows: u64,
    /// Number of bytes of the table that are kept, with its header; 0 if not even the header was whole.
    pub bytes: u64,
    /// Counts of the outcomes of the kept rows.
    pub tally: Tally,
}

/// Reason why an unfinished table does not belong to this sweep.
pub enum Alien {
    /// The table has content that this sweep would not write; the reason in words.
    Other(String),
    /// The table cannot be read.
    Unread(io::Error),
}

impl KeptRows {
    /// Reads the part of an unfinished table that can be kept, for these points of the sweep.
    ///
    /// # Errors
    /// [`Alien`] if the table is not of this sweep, or cannot be read.
    pub fn read(left: impl Read, columns: &Columns, points: &Range<u64>) -> Result<Self, Alien> {
        let mut kept = Self::default();
        let mut lines = BufReader::new(left);
        let mut line = Vec::new();
        if !whole_line(&mut lines, &mut line).map_err(Alien::Unread)? {
            return Ok(kept);
        }
        if line != columns.header() {
            return Err(Alien::Other("its columns are others".to_owned()));
        }
        kept.bytes = line.len() as u64;
        while whole_line(&mut lines, &mut line).map_err(Alien::Unread)? {
            let point = points.start + kept.rows;
            let number = kept.rows + 1;
            let other = || Alien::Other(format!("row {number} is not that of point {point}"));
            if point >= points.end {
                return Err(Alien::Other(format!("the table has more rows than the sweep has points, {}", kept.rows)));
            }
            let fields = fields(&line).filter(|fields| fields.len() == columns.count()).ok_or_else(other)?;
            if fields[0] != point.to_string() {
                return Err(other());
            }
            let reason = fields.iter().next_back().filter(|reason| !reason.is_empty());
            kept.tally.count(point, &fields[columns.place_of_stop()], reason);
            kept.rows += 1;
            kept.bytes += line.len() as u64;
        }
        Ok(kept)
    }
}

/// Reads the next line of CSV, which may have line ends between quotes; false if no whole line is left.
fn whole_line(lines: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    line.clear();
    loop {
        if lines.read_until(b'\n', line)? == 0 || !line.ends_with(b"\n") {
            return Ok(false);
        }
        // Quotes divide a line into pieces outside and inside of them: a whole line has an odd number.
        let pieces = line.split(|byte| *byte == b'"').count();
        if pieces % 2 == 1 {
            return Ok(true);
        }
    }
}

/// Fields of a line of CSV; `None` if it is not a valid record.
fn fields(line: &[u8]) -> Option<csv::StringRecord> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 10).from_reader(line);
    let mut record = csv::StringRecord::new();
    reader.read_record(&mut record).ok()?.then_some(record)
}
