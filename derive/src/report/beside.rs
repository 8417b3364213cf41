//! The publication beside a model file; none where there are no files.

use super::Report;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use std::path::{Path, PathBuf};

/// File names of the publication beside a model file: the present one, then the former one.
const NAMES: [&str; 2] = ["publication.toml", "report.toml"];

/// The file of the publication beside a model file: `publication.toml`, or `report.toml` where that alone is there.
#[must_use]
pub fn beside(path: &Path) -> PathBuf {
    let [new, old] = NAMES.map(|name| path.with_file_name(name));
    if !new.exists() && old.exists() { old } else { new }
}

/// True if a path ends in a file name of the publication beside a model.
#[must_use]
pub fn is_beside(path: &Path) -> bool {
    path.file_name().is_some_and(|name| NAMES.iter().any(|known| name == *known))
}

/// Reads the publication beside a model file, if there is one; formulas go to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the file, or that it is there by both of its names.
#[cfg(feature = "files")]
pub fn load_beside(path: &Path, model: &mut Model) -> Result<Option<Report>, Diagnostics> {
    use crate::diagnostic::{Diagnostic, Source};
    let [new, old] = NAMES.map(|name| path.with_file_name(name));
    let found = beside(path);
    if !found.exists() {
        return Ok(None);
    }
    let source = Source::read(&found)?;
    if new.exists() && old.exists() {
        let message = "beside this publication stands another, `report.toml`: that is the older name of the same file";
        return Err(Diagnostics::new(source, vec![Diagnostic::of_file(message, "keep one of them")]));
    }
    super::load(&source, model).map(Some)
}

/// No publication, since there are no files.
///
/// # Errors
/// None.
#[cfg(not(feature = "files"))]
pub fn load_beside(_path: &Path, _model: &mut Model) -> Result<Option<Report>, Diagnostics> {
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
