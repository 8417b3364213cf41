//! Output of commands to files: tables, texts and folders.
//!
//! Invariant: everything is written through [`tripos_codegen::files`], so that a file under its
//! final name is whole. No command overwrites an input: [`refuse_overwriting_inputs`] is called before work
//! begins.

use crate::failure::Failure;
use std::io::{Error, Read, Write};
use std::path::{Path, PathBuf};
use tripos_codegen::draft_file::{
    self, Draft, ExistingFilePolicy, UnfinishedFilePolicy, WriteError, draft_would_change,
};
use tripos_derive::Model;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::publication::publication_path_of_model;
use tripos_derive::scene::Scene;

/// Writes a table as a CSV file, and replaces an existing file.
///
/// # Errors
/// [`Failure`] if the table cannot be written; then no part of it remains.
pub fn write_csv_file<H: AsRef<str>>(
    path: &Path,
    header: &[H],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<(), Failure> {
    let failed = |error: csv::Error| match error.into_kind() {
        csv::ErrorKind::Io(error) => WriteError::Io(path.to_owned(), error),
        other => WriteError::Io(path.to_owned(), Error::other(format!("{other:?}"))),
    };
    let draft = Draft::create(path, ExistingFilePolicy::Replaced, UnfinishedFilePolicy::Removed)?;
    let mut writer = csv::Writer::from_writer(draft);
    writer.write_record(header.iter().map(AsRef::as_ref)).map_err(failed)?;
    for row in rows {
        writer.write_record(row).map_err(failed)?;
    }
    let draft = writer.into_inner().map_err(|error| WriteError::Io(path.to_owned(), error.into_error()))?;
    Ok(draft.finish()?)
}

/// File name extensions of table formats that are not text, which no command writes.
const NOT_TEXT: [&str; 11] = ["parquet", "feather", "arrow", "xlsx", "xls", "ods", "mat", "h5", "hdf5", "npy", "npz"];

/// Refuses a file name for a table whose extension promises another format than CSV.
///
/// # Errors
/// [`Failure::Refused`] for the extension of a format that is not text, such as `.xlsx`.
pub fn csv_name(path: &Path) -> Result<(), Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    if NOT_TEXT.contains(&ending.as_str()) {
        let what = format!("`{}` ends in `.{ending}`, and this command writes CSV", path_as_plain_text(path));
        return Err(Failure::request(what, "give a file that ends in .csv, which other programs convert"));
    }
    Ok(())
}

/// Writes a text file, and replaces an existing file.
///
/// # Errors
/// [`Failure`] if the file cannot be written.
pub fn write_text_file(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(draft_file::write(path, text)?)
}

/// Writes a binary file, and replaces an existing file.
///
/// # Errors
/// [`Failure`] if the file cannot be written.
#[cfg(feature = "pictures")]
pub fn write_binary_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Ok(draft_file::write(path, bytes)?)
}

/// Makes a folder and its parents, unless the folder exists.
///
/// # Errors
/// [`Failure::Output`] if the folder cannot be made.
pub fn make_folder(path: &Path) -> Result<(), Failure> {
    Ok(draft_file::create_folder(path)?)
}

/// Refuses output paths that would overwrite an input: the model, the publication in its folder, or
/// the scene.
///
/// # Errors
/// [`Failure::Refused`] that names the output and the input.
pub fn refuse_overwriting_inputs<'a>(
    model: &Model,
    scene: Option<&Scene>,
    outputs: impl IntoIterator<Item = &'a Path>,
) -> Result<(), Failure> {
    let publication = publication_path_of_model(&model.source.path);
    let scene = scene.map(|scene| scene.source.path.clone());
    let inputs: Vec<PathBuf> = [model.source.path.clone(), publication].into_iter().chain(scene).collect();
    for output in outputs {
        if let Some(input) = inputs.iter().find(|input| draft_would_change(output, input)) {
            let what = format!(
                "the output `{}` would overwrite the input `{}`",
                path_as_plain_text(output),
                path_as_plain_text(input)
            );
            return Err(Failure::request(what, "give another file".to_owned()));
        }
    }
    Ok(())
}

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
