//! Table of a sweep as a file that grows row by row. An interrupted sweep leaves the file unfinished.

use crate::files::output_files::TableFormat;
use crate::terminal::failure::Failure;
use std::io::{Read, Write};
use std::path::Path;
use tripos_codegen::draft_file::{Draft, ExistingFilePolicy, UnfinishedFilePolicy, WriteError};

/// Table file that grows row by row. If the command is interrupted, the rows remain in a file with an unfinished name.
pub struct GrowingTable {
    /// Rows as CSV, in the file with the unfinished name.
    rows: Draft,
    /// Format of the finished file.
    format: TableFormat,
}

impl GrowingTable {
    /// Creates the file of the table, with the unfinished name `NAME.part`.
    ///
    /// # Errors
    /// [`Failure`] if the file exists and must be kept, if another command is writing it, or if it cannot be written.
    pub fn create(path: &Path, existing: ExistingFilePolicy) -> Result<Self, Failure> {
        let format = TableFormat::of_name(path)?;
        Ok(Self { rows: Draft::create(path, existing, UnfinishedFilePolicy::Left)?, format })
    }

    /// Opens the table that an earlier command has left unfinished; `None` if there is none.
    ///
    /// # Errors
    /// [`Failure`] if the final file exists and must be kept, or if another command is writing it. In this case no file
    /// is changed.
    pub fn resume(path: &Path, existing: ExistingFilePolicy) -> Result<Option<Self>, Failure> {
        let format = TableFormat::of_name(path)?;
        Ok(Draft::resume(path, existing)?.map(|rows| Self { rows, format }))
    }

    /// Returns a reader over the rows that an earlier command has left, from the first row.
    pub fn unfinished_rows_reader(&self) -> impl Read + '_ {
        self.rows.unfinished_file_reader()
    }

    /// Truncates the rows of an earlier command to their first `bytes` bytes. Further rows are added after them.
    ///
    /// # Errors
    /// [`Failure::Output`] if the file cannot be truncated.
    pub fn truncate_rows(&mut self, bytes: u64) -> Result<(), Failure> {
        Ok(self.rows.truncate_unfinished_file(bytes)?)
    }

    /// Adds lines to the file, and passes them to the operating system at once.
    ///
    /// # Errors
    /// [`Failure::Output`] if the lines cannot be written.
    pub fn add(&mut self, lines: &[u8]) -> Result<(), Failure> {
        let written = self.rows.write_all(lines).and_then(|()| self.rows.flush());
        written.map_err(|error| WriteError::Io(self.rows.draft_path().to_owned(), error).into())
    }

    /// Returns the path of the unfinished file of the table.
    pub fn unfinished_table_path(&self) -> &Path {
        self.rows.draft_path()
    }

    /// Finishes the table, and gives its file the final name.
    ///
    /// # Errors
    /// [`Failure`] if the file cannot be renamed, or if another file with the final name has appeared and must be kept.
    pub fn finish(self) -> Result<(), Failure> {
        self.format.finish(self.rows)
    }
}
