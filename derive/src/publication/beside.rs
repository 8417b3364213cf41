//! The publication file in the folder of a model file; none if the program has no access to files.

use super::Publication;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use std::path::{Path, PathBuf};

/// Name of the publication file in the folder of a model file.
const NAME: &str = "publication.toml";

/// Path of the publication file in the folder of a model file, even if no such file exists.
#[must_use]
pub fn beside(path: &Path) -> PathBuf {
    path.with_file_name(NAME)
}

/// True if a path ends in the name of publication files, `publication.toml`.
#[must_use]
pub fn is_beside(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == NAME)
}

/// Reads the publication in the folder of a model file; `None` if there is none. Its formulas go to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the publication file.
#[cfg(feature = "files")]
pub fn load_beside(path: &Path, model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    let found = beside(path);
    if !found.exists() {
        return Ok(None);
    }
    super::load(&crate::diagnostic::Source::read(&found)?, model).map(Some)
}

/// No publication, since the program has no access to files.
///
/// # Errors
/// Never an error.
#[cfg(not(feature = "files"))]
pub fn load_beside(_path: &Path, _model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    Ok(None)
}

/// Hash of the text of the publication file in the folder of a model file; empty if none can be read.
#[must_use]
#[cfg(feature = "files")]
pub fn hash_beside(path: &Path) -> String {
    std::fs::read_to_string(beside(path)).map(|text| crate::model::text_hash(&text)).unwrap_or_default()
}

/// Empty hash, since the program has no access to files.
#[must_use]
#[cfg(not(feature = "files"))]
pub fn hash_beside(_path: &Path) -> String {
    String::new()
}
