//! The report beside a model file; none where there are no files.

use super::Report;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use std::path::Path;

/// Reads the report beside a model file, `report.toml`, if there is one; formulas go to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the report file.
#[cfg(feature = "files")]
pub fn load_beside(path: &Path, model: &mut Model) -> Result<Option<Report>, Diagnostics> {
    let path = path.with_file_name("report.toml");
    if !path.exists() {
        return Ok(None);
    }
    super::load(&crate::diagnostic::Source::read(&path)?, model).map(Some)
}

/// No report, since there are no files.
///
/// # Errors
/// None.
#[cfg(not(feature = "files"))]
pub fn load_beside(_path: &Path, _model: &mut Model) -> Result<Option<Report>, Diagnostics> {
    Ok(None)
}

/// The hash of the text of the report beside a model file; empty if none can be read.
#[must_use]
#[cfg(feature = "files")]
pub fn hash_beside(path: &Path) -> String {
    let text = std::fs::read_to_string(path.with_file_name("report.toml"));
    text.map(|text| crate::model::text_hash(&text)).unwrap_or_default()
}

/// The hash of no text, since there are no files.
#[must_use]
#[cfg(not(feature = "files"))]
pub fn hash_beside(_path: &Path) -> String {
    String::new()
}
