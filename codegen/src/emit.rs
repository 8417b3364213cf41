//! The modules of any one model file, for programs of its user's own: Rust, or another target's.
//!
//! Invariant: a file that [`place`] did not write is never changed, and nothing is changed if one stands in the way.
//! The header of a file tells whether this module wrote it. Absent on purpose: the crate around a module of Rust; it
//! needs `tripos-traits`.

#[cfg(feature = "rust")]
use crate::extras::Extras;
use crate::files::{self, WriteError};
#[cfg(feature = "rust")]
use crate::origin::Origin;
use crate::origin::{EMIT, is_written_by};
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

/// The files of one model in one language.
#[derive(Debug)]
pub struct Emission {
    /// Text of each file by its name. In Rust: `mod.rs`, one file of equations for each formulation, and their code
    /// under `code/`.
    pub files: BTreeMap<String, String>,
    /// Formulations that the model does not support, each with the reason.
    pub left_out: LeftOut,
    /// Extension of the names of its files. Files with other extensions belong to other languages and are not touched.
    pub extension: &'static str,
}

/// Emits the module `module` of a model file: these formulations alone, or, if none are named, all that the model
/// supports and the printed equations of the publication beside it; with these extras, and those that are asked for
/// beside the model.
///
/// The text is what a workspace has in `generated/src/MODULE`, but for the line that says where it comes from.
///
/// # Errors
/// [`Diagnostics`] of the model file or the publication; a formulation that is named and cannot be had is one.
#[cfg(feature = "rust")]
pub fn emit(path: &Path, module: &str, formulations: &[Formulation], extras: Extras) -> Result<Emission, Diagnostics> {
    emit_model(&Model::read(path)?, module, formulations, extras)
}

/// Emits a model that is read already, or was changed since, like [`emit`].
///
/// # Errors
/// As [`emit`].
#[cfg(feature = "rust")]
pub fn emit_model(
    model: &Model,
    module: &str,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<Emission, Diagnostics> {
    let origin = Origin::emitted(&model.source.path);
    let extras = extras.and(asked_for(model, &model.source.path)?);
    let ModuleFiles { files, left_out, .. } = module_files(model, module, &origin, formulations, extras)?;
    Ok(Emission { files, left_out, extension: "rs" })
}

/// Outcome for one file of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Placed {
    /// It is new or has another text than before.
    Written(String),
    /// It had this text already, and was not touched.
    Unchanged(String),
    /// An earlier emission wrote it, and this one has no such file.
    Removed(String),
}

impl fmt::Display for Placed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Written(file) => write!(f, "written    {file}"),
            Self::Unchanged(file) => write!(f, "unchanged  {file}"),
            Self::Removed(file) => write!(f, "removed    {file}"),
        }
    }
}

/// Why a module could not be placed.
#[derive(Debug)]
pub enum PlaceError {
    /// A file that this did not write has the place of one of the module.
    Foreign(PathBuf),
    /// A file or folder that cannot be read or removed.
    Io(PathBuf, std::io::Error),
    /// A file that cannot be written.
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
            Self::Foreign(path) => write!(f, "`{}` is not a file that `tripos {EMIT}` wrote", path_in_line(path)),
            Self::Io(path, error) => write!(f, "cannot read or remove `{}`: {error}", path_in_line(path)),
            Self::Write(error) => error.fmt(f),
        }
    }
}

/// Makes a folder hold a module: all its files, and no others of an earlier emission. Other files stay as they are.
///
/// # Errors
/// [`PlaceError`]; [`PlaceError::Foreign`] before anything is changed.
pub fn place(emission: &Emission, folder: &Path) -> Result<Vec<Placed>, PlaceError> {
    let old = written_before(folder, emission.extension)?;
    for file in emission.files.keys() {
        let path = folder.join(file);
        if !old.contains_key(file) && path.symlink_metadata().is_ok() {
            return Err(PlaceError::Foreign(path));
        }
    }
    files::folder(folder)?;
    let mut placed = Vec::new();
    for (file, text) in &emission.files {
        if old.get(file) == Some(text) {
            placed.push(Placed::Unchanged(file.clone()));
            continue;
        }
        let path = folder.join(file);
        files::folder(path.parent().unwrap_or(folder))?;
        files::write(&path, text)?;
        placed.push(Placed::Written(file.clone()));
    }
    for file in old.into_keys().filter(|file| !emission.files.contains_key(file)) {
        let path = folder.join(&file);
        std::fs::remove_file(&path).map_err(|error| PlaceError::Io(path, error))?;
        placed.push(Placed::Removed(file));
    }
    Ok(placed)
}

/// The files of a module that an earlier emission wrote, with their texts; none if there is no such folder.
fn written_before(folder: &Path, extension: &str) -> Result<BTreeMap<String, String>, PlaceError> {
    let mut files = written_in(folder, extension)?;
    let code = written_in(&folder.join("code"), extension)?;
    files.extend(code.into_iter().map(|(name, text)| (format!("code/{name}"), text)));
    Ok(files)
}

fn written_in(folder: &Path, wanted: &str) -> Result<BTreeMap<String, String>, PlaceError> {
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
        // Neither folders nor links: what a link points to is another's.
        if path.extension().is_none_or(|extension| extension != wanted)
            || !entry.file_type().map_err(failed(&path))?.is_file()
        {
            continue;
        }
        let text = std::fs::read(&path).map_err(failed(&path))?;
        if let (Ok(text), Ok(name)) = (String::from_utf8(text), entry.file_name().into_string())
            && is_written_by(&text, EMIT)
        {
            files.insert(name, text);
        }
    }
    Ok(files)
}
