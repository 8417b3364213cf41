//! Table of a sweep as a file that grows row by row, and that an interrupted sweep leaves unfinished.

use crate::failure::Failure;
use std::io::{Read, Write};
use std::path::Path;
use tripos_codegen::draft_file::{Draft, ExistingFilePolicy, UnfinishedFilePolicy, WriteError};

/// Table file that grows row by row. If the command is interrupted, it keeps its rows under an
/// unfinished name.
pub struct GrowingTable(Draft);

impl GrowingTable {
    /// Creates the file of the table, under the unfinished name `NAME.part`.
    ///
    /// # Errors
    /// [`Failure`] if the file exists and is to be kept, another command is writing it, or it
    /// cannot be written.
    pub fn create(path: &Path, existing: ExistingFilePolicy) -> Result<Self, Failure> {
        Ok(Self(Draft::create(path, existing, UnfinishedFilePolicy::Left)?))
    }

    /// Opens the table that an earlier command has left unfinished; `None` if there is none.
    ///
    /// # Errors
    /// [`Failure`] if the final file exists and is to be kept, or another command is writing it. No
    /// file is changed then.
    pub fn resume(path: &Path, existing: ExistingFilePolicy) -> Result<Option<Self>, Failure> {
        Ok(Draft::resume(path, existing)?.map(Self))
    }

    /// Returns a reader over the rows that an earlier command has left, from the first row.
    pub fn unfinished_rows_reader(&self) -> impl Read + '_ {
        self.0.unfinished_file_reader()
    }

    /// Cuts the rows of an earlier command to their first `bytes` bytes. Further rows are added
    /// after them.
    ///
    /// # Errors
    /// [`Failure::Output`] if the file cannot be cut.
    pub fn truncate_rows(&mut self, bytes: u64) -> Result<(), Failure> {
        Ok(self.0.truncate_unfinished_file(bytes)?)
    }

    /// Adds lines to the file and writes them to the system at once.
    ///
    /// # Errors
    /// [`Failure::Output`] if the lines cannot be written.
    pub fn add(&mut self, lines: &[u8]) -> Result<(), Failure> {
        let written = self.0.write_all(lines).and_then(|()| self.0.flush());
        written.map_err(|error| WriteError::Io(self.0.draft_path().to_owned(), error).into())
    }

    /// Returns the path of the unfinished file of the table.
    pub fn unfinished_table_path(&self) -> &Path {
        self.0.draft_path()
    }

    /// Finishes the table, and gives its file the final name.
    ///
    /// # Errors
    /// [`Failure`] if the file cannot be renamed, or if a file of its name has appeared that is to
    /// be kept.
    pub fn finish(self) -> Result<(), Failure> {
        Ok(self.0.finish()?)
    }
}
