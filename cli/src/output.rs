//! Output of commands to files: tables, texts, folders.
//!
//! Invariant: everything goes through [`tripos_codegen::files`], so that a file under its final name is whole. No
//! command overwrites an input: [`keep_inputs`] is called before work begins.

use crate::failure::Failure;
use std::io::{Error, Read, Write};
use std::path::{Path, PathBuf};
use tripos_codegen::files::{self, Draft, Existing, Unfinished, WriteError, would_change};
use tripos_derive::Model;
use tripos_derive::plain::path_in_line;
use tripos_derive::publication::beside;
use tripos_derive::scene::Scene;

/// Writes a table as a file, and replaces an existing one.
///
/// # Errors
/// [`Failure`] if the table cannot be written; then no part of it remains.
pub fn table<H: AsRef<str>>(
    path: &Path,
    header: &[H],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<(), Failure> {
    let failed = |error: csv::Error| match error.into_kind() {
        csv::ErrorKind::Io(error) => WriteError::Io(path.to_owned(), error),
        other => WriteError::Io(path.to_owned(), Error::other(format!("{other:?}"))),
    };
    let draft = Draft::create(path, Existing::Replaced, Unfinished::Removed)?;
    let mut writer = csv::Writer::from_writer(draft);
    writer.write_record(header.iter().map(AsRef::as_ref)).map_err(failed)?;
    for row in rows {
        writer.write_record(row).map_err(failed)?;
    }
    let draft = writer.into_inner().map_err(|error| WriteError::Io(path.to_owned(), error.into_error()))?;
    Ok(draft.finish()?)
}

/// Endings of files in formats that are not text, and that nothing here writes.
const NOT_TEXT: [&str; 11] = ["parquet", "feather", "arrow", "xlsx", "xls", "ods", "mat", "h5", "hdf5", "npy", "npz"];

/// Refuses the name of a table whose ending promises another format than CSV.
///
/// # Errors
/// [`Failure::Refused`] for the ending of a format that is not text.
pub fn csv_name(path: &Path) -> Result<(), Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
    if NOT_TEXT.contains(&ending.as_str()) {
        let what = format!("`{}` ends in `.{ending}`, and this command writes CSV", path_in_line(path));
        return Err(Failure::request(what, "give a file that ends in .csv, which other programs convert"));
    }
    Ok(())
}

/// Writes a text as a file, and replaces an existing one.
///
/// # Errors
/// [`Failure`] if the text cannot be written.
pub fn text(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(files::write(path, text)?)
}

/// Writes bytes as a file, and replaces an existing one.
///
/// # Errors
/// [`Failure`] if the bytes cannot be written.
#[cfg(feature = "pictures")]
pub fn bytes(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    Ok(files::write(path, bytes)?)
}

/// Makes a folder if it does not exist.
///
/// # Errors
/// [`Failure::Output`] if the folder cannot be made.
pub fn folder(path: &Path) -> Result<(), Failure> {
    Ok(files::folder(path)?)
}

/// Refuses outputs that would change an input of a command: a model, the publication beside it, and a scene if there is
/// one.
///
/// # Errors
/// [`Failure::Refused`] that names the output and the input.
pub fn keep_inputs<'a>(
    model: &Model,
    scene: Option<&Scene>,
    outputs: impl IntoIterator<Item = &'a Path>,
) -> Result<(), Failure> {
    let publication = beside(&model.source.path);
    let scene = scene.map(|scene| scene.source.path.clone());
    let inputs: Vec<PathBuf> = [model.source.path.clone(), publication].into_iter().chain(scene).collect();
    for output in outputs {
        if let Some(input) = inputs.iter().find(|input| would_change(output, input)) {
            let what =
                format!("the output `{}` would overwrite the input `{}`", path_in_line(output), path_in_line(input));
            return Err(Failure::request(what, "give another file".to_owned()));
        }
    }
    Ok(())
}

/// A table file that grows row by row, and keeps the rows that it has if the command is interrupted.
pub struct Rows(Draft);

impl Rows {
    /// Creates the file of the table, under an unfinished name.
    ///
    /// # Errors
    /// [`Failure`] if the file exists and is to be kept, another command is writing it, or it cannot be written.
    pub fn create(path: &Path, existing: Existing) -> Result<Self, Failure> {
        Ok(Self(Draft::create(path, existing, Unfinished::Left)?))
    }

    /// Opens the table that an earlier command has left unfinished; `None` if there is none.
    ///
    /// # Errors
    /// [`Failure`], as for [`Self::create`]; then no file is changed.
    pub fn resume(path: &Path, existing: Existing) -> Result<Option<Self>, Failure> {
        Ok(Draft::resume(path, existing)?.map(Self))
    }

    /// Reader over the rows that an earlier command has left, from the first row.
    pub fn left(&self) -> impl Read + '_ {
        self.0.left()
    }

    /// Cuts the rows that an earlier command has left to this number of bytes; further rows are added behind them.
    ///
    /// # Errors
    /// [`Failure::Output`] if the file cannot be cut.
    pub fn keep(&mut self, bytes: u64) -> Result<(), Failure> {
        Ok(self.0.keep(bytes)?)
    }

    /// Adds lines to the file, without a delay.
    ///
    /// # Errors
    /// [`Failure::Output`] if the lines cannot be written.
    pub fn add(&mut self, lines: &[u8]) -> Result<(), Failure> {
        let written = self.0.write_all(lines).and_then(|()| self.0.flush());
        written.map_err(|error| WriteError::Io(self.0.place().to_owned(), error).into())
    }

    /// Path of the unfinished file of the table.
    pub fn place(&self) -> &Path {
        self.0.place()
    }

    /// Finishes the table, and gives its file the final name.
    ///
    /// # Errors
    /// [`Failure`] if the file cannot be renamed, or a file of its name has appeared that is to be kept.
    pub fn finish(self) -> Result<(), Failure> {
        Ok(self.0.finish()?)
    }
}
