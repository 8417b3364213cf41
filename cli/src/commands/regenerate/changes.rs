//! Changes that an edit makes to the equations of a model of the workspace. The model that the committed equations were
//! derived from is derived again, and compared with the model as it is. No text of equations is read: most of it stands
//! by names that mean something else after an edit.

use crate::commands::diff::changed_equations;
use std::path::Path;
use tripos_codegen::workspace::DERIVED_FROM;
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::load;
use tripos_derive::plain::path_in_line;

/// Result of comparing the equations of a model before and after an edit.
pub enum Equations {
    /// They mean what they meant.
    Same,
    /// Changes, in lines.
    Changed(String),
    /// Why that is not known.
    Unknown(String),
}

/// Compares the equations of the model in a folder with the committed ones.
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
    // What a model names beside itself lies where it lay.
    let old = load(&Source { path: path.to_owned(), text: before })?;
    changed_equations(&old, &new)
}
