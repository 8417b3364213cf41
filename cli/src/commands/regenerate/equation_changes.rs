//! Changes of the equations of a workspace model after an edit.
//!
//! The committed model text is derived again, and compared with the present model. The texts of equations are not
//! compared, because after an edit most names in them have another meaning.

use crate::commands::diff::changed_equations;
use std::path::Path;
use tripos_codegen::generated_workspace::DERIVED_MODEL_COPY;
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::load;
use tripos_derive::plain_text::path_as_plain_text;

/// Result of comparing the equations of a model before and after an edit.
pub enum EquationComparison {
    /// The equations have the same meaning.
    Same,
    /// The equations changed. The text has one line per change.
    Changed(String),
    /// The comparison failed. The text is the reason.
    Unknown(String),
}

/// Compares the present equations of the model in a folder with the committed equations.
pub fn compare_with_committed_equations(models: &Path, committed: &Path, folder: &str) -> EquationComparison {
    let (path, before) = (models.join(folder).join("model.toml"), committed.join(folder).join(DERIVED_MODEL_COPY));
    let Ok(text) = std::fs::read_to_string(&before) else {
        let before = path_as_plain_text(&before);
        return EquationComparison::Unknown(format!("{before}, the model that they were derived from, is not there"));
    };
    match compare_model_texts(&path, text) {
        Ok(Some(lines)) => EquationComparison::Changed(lines),
        Ok(None) => EquationComparison::Same,
        Err(why) => EquationComparison::Unknown(format!("they cannot be derived again:\n{why}")),
    }
}

/// Derives the model as it was before the edit, and as it is now. Returns lines about the changes; `None` if there are
/// none.
///
/// # Errors
/// `Diagnostics` if a model cannot be read or derived.
fn compare_model_texts(path: &Path, before: String) -> Result<Option<String>, Diagnostics> {
    let new = Model::read(path)?;
    if new.source.text == before {
        return Ok(None);
    }
    // Files that the old model text names are read from the folder of the present model.
    let old = load(&Source { path: path.to_owned(), text: before })?;
    changed_equations(&old, &new)
}
