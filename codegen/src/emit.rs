//! Modules of generated code for any model file, in Rust or another target language, for use in other programs.
//!
//! Invariant: a file that [`write_emission`] did not write is never changed. If such a foreign file has the name of a
//! new file, no file is changed at all. The header of a file tells if [`write_emission`] wrote it. A Rust module
//! comes without a crate around it, and needs the crate `tripos-traits`.

use crate::draft_file::{self, Draft, WriteError};
#[cfg(feature = "rust")]
use crate::generated_workspace::{ModuleFiles, generated_module_files};
#[cfg(feature = "rust")]
use crate::optional_functions::{Extras, requested_extras};
#[cfg(feature = "rust")]
use crate::origin::Origin;
use crate::origin::{EMIT, is_written_by, read_origin_source};
use crate::target::UnsupportedFormulations;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};
#[cfg(feature = "rust")]
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::plain_text::path_as_plain_text;
#[cfg(feature = "rust")]
use tripos_derive::{Formulation, Model};

/// Generated files of one model's module in one target language.
#[derive(Debug)]
pub struct Emission {
    /// Texts of the files, by file name. In Rust: `mod.rs`, one file of equations for each formulation, and their code
    /// in `code/`.
    pub files: BTreeMap<String, String>,
    /// Formulations that the model does not support, each with the reason. No file is generated for them.
    pub left_out: UnsupportedFormulations,
    /// Subcommand of `tripos` that writes the files, as their headers state it. Files written by
    /// other commands are not touched.
    pub command: &'static str,
    /// File name extensions of the language. Files with other extensions are not touched.
    pub extensions: &'static [&'static str],
    /// Earlier files of the same model that are removed if this emission does not write them again.
    pub replaced: ReplacedFiles,
}

/// Earlier files of a model that an emission removes if it does not write them again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReplacedFiles {
    /// All files of the model in this language. A Rust module is one unit: its `mod.rs` names all its files.
    All,
    /// Files with these names: those that the written sets of equations had with other functions. Files of other sets
    /// of equations stay.
    Named(BTreeSet<String>),
}

/// Generates the Rust module `module` of the model file at `path`.
///
/// It contains the given formulations. If none are given, it contains all that the model supports, and the printed
/// equations of the publication in the model's folder. The optional functions are those in `extras` and those that
/// `code.toml` in the model's folder requests.
///
/// The text equals that in `generated/src/MODULE` of a workspace, except for the header line with its origin.
///
/// # Errors
/// Returns [`Diagnostics`] of the model file or the publication, or of a given formulation that the model does not
/// support.
#[cfg(feature = "rust")]
pub fn emit_rust_module(
    path: &Path,
    module: &str,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<Emission, Diagnostics> {
    emit_rust_model(&Model::read(path)?, module, formulations, extras)
}

/// Generates the Rust module `module` of a model that was already read, and perhaps changed after reading.
///
/// An empty list of formulations means all that the model supports, and the printed equations of its publication.
///
/// # Errors
/// Returns [`Diagnostics`] of the model, the publication or `code.toml`, or of a given formulation that the model
/// does not support.
#[cfg(feature = "rust")]
pub fn emit_rust_model(
    model: &Model,
    module: &str,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<Emission, Diagnostics> {
    let origin = Origin::origin_of_model_file(&model.source.path, EMIT);
    let extras = extras.and(requested_extras(model, &model.source.path)?);
    let ModuleFiles { files, left_out, .. } = generated_module_files(model, module, &origin, formulations, extras)?;
    Ok(Emission { files, left_out, command: EMIT, extensions: &["rs"], replaced: ReplacedFiles::All })
}

/// Change of one file when a module is written into a folder. Each variant holds the file's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EmittedFileChange {
    /// The file is new, or its text has changed. It was written.
    Written(String),
    /// The file already had the new text and was not touched.
    Unchanged(String),
    /// The file was written by an earlier emission and no longer belongs to the module, so it was removed.
    Removed(String),
    /// The file was written by an earlier emission from the same model, for other equations. It was not touched.
    Kept(String),
}

impl EmittedFileChange {
    /// Returns the word for the change (`written`, `unchanged`, `removed` or `kept`) and the name of
    /// the file.
    #[must_use]
    pub fn word_and_file(&self) -> (&'static str, &str) {
        match self {
            Self::Written(file) => ("written", file),
            Self::Unchanged(file) => ("unchanged", file),
            Self::Removed(file) => ("removed", file),
            Self::Kept(file) => ("kept", file),
        }
    }
}

impl fmt::Display for EmittedFileChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (word, file) = self.word_and_file();
        write!(f, "{word:9}  {file}")
    }
}

/// Reason why the files of a module could not be written into a folder.
#[derive(Debug)]
pub enum EmissionError {
    /// A file that [`write_emission`] did not write has the name of a file of the module. The entry is its path.
    Foreign(PathBuf),
    /// A file of the module was written earlier from a different model. The entries are the path of this file, and
    /// the path of that model as the file's header states it.
    OtherModel(PathBuf, String),
    /// The operating system refuses to read or remove a file or folder. The entries are its path and the system's
    /// error.
    Io(PathBuf, std::io::Error),
    /// The operating system refuses to write a file. The entry is the error of the writer.
    Write(WriteError),
}

impl From<WriteError> for EmissionError {
    fn from(error: WriteError) -> Self {
        Self::Write(error)
    }
}

impl std::error::Error for EmissionError {}

impl fmt::Display for EmissionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign(path) => {
                write!(f, "the file `{}` was not written by `tripos {EMIT}`", path_as_plain_text(path))
            }
            Self::OtherModel(path, model) => {
                write!(f, "the file `{}` was written from another model, `{model}`", path_as_plain_text(path))
            }
            Self::Io(path, error) => write!(f, "cannot read or remove `{}`: {error}", path_as_plain_text(path)),
            Self::Write(error) => error.fmt(f),
        }
    }
}

/// Writes the files of a module into a folder. Removes those files of an earlier emission of the same model that
/// [`Emission::replaced`] names and that are no longer generated. All other files stay. Returns the change of each
/// file, and the kept files of other equations of the same model.
///
/// # Errors
/// Returns an [`EmissionError`]. No file is changed if a foreign file or a file of another model has the name of a
/// new file, or if a text cannot be written.
pub fn write_emission(emission: &Emission, folder: &Path) -> Result<Vec<EmittedFileChange>, EmissionError> {
    let old = earlier_emitted_files(folder, emission)?;
    for (file, text) in &emission.files {
        let path = folder.join(file);
        let Some(old) = old.get(file) else {
            if path.symlink_metadata().is_ok() {
                return Err(EmissionError::Foreign(path));
            }
            continue;
        };
        let sources = read_origin_source(text, emission.command).zip(read_origin_source(old, emission.command));
        if let Some(other) = sources.and_then(|(own, old)| own.path_of_other_model(&old)) {
            return Err(EmissionError::OtherModel(path, other));
        }
    }
    draft_file::create_folder(folder)?;
    let (mut placed, mut drafts) = (Vec::new(), Vec::new());
    for (file, text) in &emission.files {
        if old.get(file) == Some(text) {
            placed.push(EmittedFileChange::Unchanged(file.clone()));
            continue;
        }
        let path = folder.join(file);
        draft_file::create_folder(path.parent().unwrap_or(folder))?;
        drafts.push(draft_file::write_draft(&path, text)?);
        placed.push(EmittedFileChange::Written(file.clone()));
    }
    // All texts are on the disk, under temporary names, before the first file is replaced.
    drafts.into_iter().try_for_each(Draft::finish)?;
    // Files of other models stay, so that several models can share a folder.
    let own: Vec<_> = emission.files.values().filter_map(|text| read_origin_source(text, emission.command)).collect();
    let is_own = |text: &str| {
        read_origin_source(text, emission.command).is_some_and(|old| own.iter().any(|own| own.is_of_one_model(&old)))
    };
    let gone = old.into_iter().filter(|(file, text)| !emission.files.contains_key(file) && is_own(text));
    for file in gone.map(|(file, _)| file) {
        if matches!(&emission.replaced, ReplacedFiles::Named(names) if !names.contains(&file)) {
            placed.push(EmittedFileChange::Kept(file));
            continue;
        }
        let path = folder.join(&file);
        std::fs::remove_file(&path).map_err(|error| EmissionError::Io(path, error))?;
        placed.push(EmittedFileChange::Removed(file));
    }
    Ok(placed)
}

/// Reads the files that an earlier emission wrote into `folder` and its subfolder `code`. Returns their texts by
/// relative path; empty if the folder does not exist. `Err` if a file or folder cannot be read.
fn earlier_emitted_files(folder: &Path, emission: &Emission) -> Result<BTreeMap<String, String>, EmissionError> {
    let mut files = emitted_files_in_folder(folder, emission)?;
    let code = emitted_files_in_folder(&folder.join("code"), emission)?;
    files.extend(code.into_iter().map(|(name, text)| (format!("code/{name}"), text)));
    Ok(files)
}

/// Reads the files directly in `folder` that have the header of the emission's command and one of its extensions.
/// Returns their texts by file name. `Err` if a file or folder cannot be read.
fn emitted_files_in_folder(folder: &Path, emission: &Emission) -> Result<BTreeMap<String, String>, EmissionError> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |error| EmissionError::Io(path, error)
    };
    let mut files = BTreeMap::new();
    if folder.symlink_metadata().is_err() {
        return Ok(files);
    }
    for entry in std::fs::read_dir(folder).map_err(failed(folder))? {
        let entry = entry.map_err(failed(folder))?;
        let path = entry.path();
        // Folders and links are skipped, because the target of a link belongs to someone else.
        if path.extension().is_none_or(|extension| !emission.extensions.iter().any(|wanted| extension == *wanted))
            || !entry.file_type().map_err(failed(&path))?.is_file()
        {
            continue;
        }
        let text = std::fs::read(&path).map_err(failed(&path))?;
        if let (Ok(text), Ok(name)) = (String::from_utf8(text), entry.file_name().into_string())
            && is_written_by(&text, emission.command)
        {
            files.insert(name, text);
        }
    }
    Ok(files)
}
