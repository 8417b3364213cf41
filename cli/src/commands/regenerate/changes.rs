//! Changes that an edit makes to the equations of a model of the workspace. The model from which the committed
//! equations were derived is derived again, and compared with the model as it is now. The text of equations is not
//! compared: most names in it mean something else after an edit.

use crate::commands::diff::changed_equations;
use std::path::Path;
use tripos_codegen::workspace::DERIVED_FROM;
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::load;
use tripos_derive::plain::path_in_line;

/// Comparison of the equations of a model before and after an edit.
pub enum Equations {
    /// The equations have the same meaning.
    Same,
    /// The equations changed; the text has a line for each change.
    Changed(String),
    /// The comparison failed, for this reason.
    Unknown(String),
}

/// Compares the equations of the model in a folder with the committed equations.
pub fn equations_of(models: &Path, committed: &Path, folder: &str) -> Equations {
    let (path, before) = (models.join(folder).join("model.toml"), committed.join(folder).join(DERIVED_FROM));
    let Ok(text) = std::fs::read_to_string(&before) else {
        let before = path_in_line(&before);
        return Equations::Unknown(format!("{before}, the model that they were derived from, is not there"));
    };
    match compared(&path, text) {
        Ok(Some(lines)) => Equations::Changed(lines),
        Ok(None) => Equations::Same,
        Err(why) => Equations::Unknown(format!("they cannot be derived again:\n{why}")),
    }
}

fn compared(path: &Path, before: String) -> Result<Option<String>, Diagnostics> {
    let new = Model::read(path)?;
    if new.source.text == before {
        return Ok(None);
    }
    // Files that the old model names are sought beside the model as it is now.
    let old = load(&Source { path: path.to_owned(), text: before })?;
    changed_equations(&old, &new)
}
