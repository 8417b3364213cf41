//! Output of commands to files: tables, texts and folders.
//!
//! Invariant: everything is written through [`tripos_codegen::draft_file`], so that a file with its final name is
//! always complete. No command overwrites an input: [`refuse_overwriting_inputs`] is called before work begins.

mod table_format;

pub use table_format::TableFormat;

use crate::terminal::failure::Failure;
use std::io::Error;
use std::path::{Path, PathBuf};
use tripos_codegen::draft_file;
use tripos_codegen::draft_file::{Draft, ExistingFilePolicy, UnfinishedFilePolicy, WriteError, draft_would_change};
use tripos_derive::Model;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::publication::publication_path_of_model;
use tripos_derive::scene::Scene;

/// Writes a table to a file, and replaces an existing file. The extension of the file name determines the format.
///
/// # Errors
/// [`Failure`] if the table cannot be written. In this case no part of it remains.
pub fn write_table_file<H: AsRef<str>>(
    path: &Path,
    header: &[H],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<(), Failure> {
    let failed = |error: csv::Error| match error.into_kind() {
        csv::ErrorKind::Io(error) => WriteError::Io(path.to_owned(), error),
        other => WriteError::Io(path.to_owned(), Error::other(format!("{other:?}"))),
    };
    let format = TableFormat::of_name(path)?;
    let draft = Draft::create(path, ExistingFilePolicy::Replaced, UnfinishedFilePolicy::Removed)?;
    let mut writer = csv::Writer::from_writer(draft);
    writer.write_record(header.iter().map(AsRef::as_ref)).map_err(failed)?;
    for row in rows {
        writer.write_record(row).map_err(failed)?;
    }
    let draft = writer.into_inner().map_err(|error| WriteError::Io(path.to_owned(), error.into_error()))?;
    format.finish(draft)
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

/// Refuses an output path that would overwrite one of the given input files.
///
/// # Errors
/// [`Failure::Refused`] that names the output and the input.
pub fn refuse_overwriting_files(inputs: &[PathBuf], output: &Path) -> Result<(), Failure> {
    match inputs.iter().find(|input| draft_would_change(output, input)) {
        Some(input) => Err(overwriting_failure(output, input)),
        None => Ok(()),
    }
}

/// Failure of an output that would overwrite an input.
fn overwriting_failure(output: &Path, input: &Path) -> Failure {
    let what = format!(
        "the output `{}` would overwrite the input `{}`",
        path_as_plain_text(output),
        path_as_plain_text(input)
    );
    Failure::request(what, "give another file".to_owned())
}

/// Refuses output paths that would overwrite an input: the model, the publication in the model's folder, or the scene.
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
        refuse_overwriting_files(&inputs, output)?;
    }
    Ok(())
}
