//! The publication beside a model file; none where there are no files.

use super::Publication;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use std::path::{Path, PathBuf};

/// File name of the publication beside a model file.
const NAME: &str = "publication.toml";

/// The path of the publication beside a model file, whether it is there or not.
#[must_use]
pub fn beside(path: &Path) -> PathBuf {
    path.with_file_name(NAME)
}

/// True if a path ends in the file name of the publication beside a model.
#[must_use]
pub fn is_beside(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == NAME)
}

/// Reads the publication beside a model file, if there is one; formulas go to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the file.
#[cfg(feature = "files")]
pub fn load_beside(path: &Path, model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    let found = beside(path);
    if !found.exists() {
        return Ok(None);
    }
    super::load(&crate::diagnostic::Source::read(&found)?, model).map(Some)
}

/// No publication, since there are no files.
///
/// # Errors
/// None.
#[cfg(not(feature = "files"))]
pub fn load_beside(_path: &Path, _model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    Ok(None)
}

/// The hash of the text of the publication beside a model file; empty if none can be read.
#[must_use]
#[cfg(feature = "files")]
pub fn hash_beside(path: &Path) -> String {
    std::fs::read_to_string(beside(path)).map(|text| crate::model::text_hash(&text)).unwrap_or_default()
}

/// The hash of no text, since there are no files.
#[must_use]
#[cfg(not(feature = "files"))]
pub fn hash_beside(_path: &Path) -> String {
    String::new()
}
