//! Modules of code for any model file, for use in other programs: in Rust, or in another target's language.
//!
//! Invariant: a file that [`place`] did not write is never changed, and no file is changed if one is in the way. The
//! header of a file tells whether [`place`] wrote it. A Rust module comes without a crate around it; it needs the crate
//! `tripos-traits`.

#[cfg(feature = "rust")]
use crate::extras::Extras;
use crate::files::{self, Draft, WriteError};
#[cfg(feature = "rust")]
use crate::origin::Origin;
use crate::origin::{EMIT, is_written_by, source_in};
use crate::target::LeftOut;
#[cfg(feature = "rust")]
use crate::workspace::{ModuleFiles, asked_for, module_files};
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
#[cfg(feature = "rust")]
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::plain::path_in_line;
#[cfg(feature = "rust")]
use tripos_derive::{Formulation, Model};

/// Files of one model's module in one language.
#[derive(Debug)]
pub struct Emission {
    /// Texts of the files, by file name. In Rust: `mod.rs`, one file of equations for each formulation, and their code
    /// in `code/`.
    pub files: BTreeMap<String, String>,
    /// Formulations that the model does not support, each with the reason.
    pub left_out: LeftOut,
    /// Command of `tripos` that writes the files, as their headers state it. Files of other commands are not touched.
    pub command: &'static str,
    /// Extensions of the names of the files. Files with other extensions belong to other languages and are not touched.
    pub extensions: &'static [&'static str],
}

/// Emits the module `module` of a model file. It contains the given formulations, or, if none are given, all that the
/// model supports and the printed equations of the publication beside it. It contains the given extras, and those that
/// the file `code.toml` beside the model asks for.
///
/// The text equals that in `generated/src/MODULE` of a workspace, except for the line with its origin.
///
/// # Errors
/// [`Diagnostics`] of the model file or the publication, or of a given formulation that the model does not support.
#[cfg(feature = "rust")]
pub fn emit(path: &Path, module: &str, formulations: &[Formulation], extras: Extras) -> Result<Emission, Diagnostics> {
    emit_model(&Model::read(path)?, module, formulations, extras)
}

/// Emits a model that is already read, or was changed after reading, like [`emit`].
///
/// # Errors
/// [`Diagnostics`], for the same reasons as [`emit`].
#[cfg(feature = "rust")]
pub fn emit_model(
    model: &Model,
    module: &str,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<Emission, Diagnostics> {
    let origin = Origin::emitted(&model.source.path, EMIT);
    let extras = extras.and(asked_for(model, &model.source.path)?);
    let ModuleFiles { files, left_out, .. } = module_files(model, module, &origin, formulations, extras)?;
    Ok(Emission { files, left_out, command: EMIT, extensions: &["rs"] })
}

/// Change of one file of a module, with the name of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Placed {
    /// The file is new or its text has changed.
    Written(String),
    /// The file had this text already, and was not touched.
    Unchanged(String),
    /// An earlier emission wrote the file, and the module no longer contains it.
    Removed(String),
}

impl Placed {
    /// Word for the change, and name of the file.
    #[must_use]
    pub fn word_and_file(&self) -> (&'static str, &str) {
        match self {
            Self::Written(file) => ("written", file),
            Self::Unchanged(file) => ("unchanged", file),
            Self::Removed(file) => ("removed", file),
        }
    }
}

impl fmt::Display for Placed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (word, file) = self.word_and_file();
        write!(f, "{word:9}  {file}")
    }
}

/// Reason why a module could not be placed in a folder.
#[derive(Debug)]
pub enum PlaceError {
    /// A file that [`place`] did not write has the name of a file of the module.
    Foreign(PathBuf),
    /// A file of the module was written from another model, which has the same name as a word: the path of the file,
    /// and the other model file.
    OtherModel(PathBuf, String),
    /// A file or folder cannot be read or removed.
    Io(PathBuf, std::io::Error),
    /// A file cannot be written.
    Write(WriteError),
}

impl From<WriteError> for PlaceError {
    fn from(error: WriteError) -> Self {
        Self::Write(error)
    }
}

impl std::error::Error for PlaceError {}

impl fmt::Display for PlaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign(path) => write!(f, "the file `{}` was not written by `tripos {EMIT}`", path_in_line(path)),
            Self::OtherModel(path, model) => {
                write!(f, "the file `{}` was written from another model, `{model}`", path_in_line(path))
            }
            Self::Io(path, error) => write!(f, "cannot read or remove `{}`: {error}", path_in_line(path)),
            Self::Write(error) => error.fmt(f),
        }
    }
}

/// Makes a folder contain the files of a module, and removes other files of an earlier emission of the same model. All
/// other files stay.
///
/// # Errors
/// [`PlaceError`]. If a file is in the way, is another model's, or cannot be written, no file is changed.
pub fn place(emission: &Emission, folder: &Path) -> Result<Vec<Placed>, PlaceError> {
    let old = written_before(folder, emission)?;
    for (file, text) in &emission.files {
        let path = folder.join(file);
        let Some(old) = old.get(file) else {
            if path.symlink_metadata().is_ok() {
                return Err(PlaceError::Foreign(path));
            }
            continue;
        };
        let sources = source_in(text, emission.command).zip(source_in(old, emission.command));
        if let Some(other) = sources.and_then(|(own, old)| own.other_model(&old)) {
            return Err(PlaceError::OtherModel(path, other));
        }
    }
    files::folder(folder)?;
    let (mut placed, mut drafts) = (Vec::new(), Vec::new());
    for (file, text) in &emission.files {
        if old.get(file) == Some(text) {
            placed.push(Placed::Unchanged(file.clone()));
            continue;
        }
        let path = folder.join(file);
        files::folder(path.parent().unwrap_or(folder))?;
        drafts.push(files::draft(&path, text)?);
        placed.push(Placed::Written(file.clone()));
    }
    // All texts are on the disk, under temporary names, before the first file is replaced.
    drafts.into_iter().try_for_each(Draft::finish)?;
    // Files of other models stay, so that several can share a folder.
    let own: Vec<_> = emission.files.values().filter_map(|text| source_in(text, emission.command)).collect();
    let is_own = |text: &str| {
        source_in(text, emission.command).is_some_and(|old| own.iter().any(|own| own.is_of_one_model(&old)))
    };
    let gone = old.into_iter().filter(|(file, text)| !emission.files.contains_key(file) && is_own(text));
    for file in gone.map(|(file, _)| file) {
        let path = folder.join(&file);
        std::fs::remove_file(&path).map_err(|error| PlaceError::Io(path, error))?;
        placed.push(Placed::Removed(file));
    }
    Ok(placed)
}

/// Files of a module that an earlier emission wrote, with their texts; empty if the folder does not exist.
fn written_before(folder: &Path, emission: &Emission) -> Result<BTreeMap<String, String>, PlaceError> {
    let mut files = written_in(folder, emission)?;
    let code = written_in(&folder.join("code"), emission)?;
    files.extend(code.into_iter().map(|(name, text)| (format!("code/{name}"), text)));
    Ok(files)
}

fn written_in(folder: &Path, emission: &Emission) -> Result<BTreeMap<String, String>, PlaceError> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |error| PlaceError::Io(path, error)
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
