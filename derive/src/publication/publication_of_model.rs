//! Access to the publication file in the folder of a model file. A program that is built without access to files finds
//! none.

use super::Publication;
#[cfg(feature = "files")]
use super::names::author_files::read_file_beside_publication;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use std::path::{Path, PathBuf};

/// Name of the publication file in the folder of a model file.
const NAME: &str = "publication.toml";

/// Path of the publication file in the folder of the model file `path`, even if no such file
/// exists.
#[must_use]
pub fn publication_path_of_model(path: &Path) -> PathBuf {
    path.with_file_name(NAME)
}

/// True if the file name of `path` is `publication.toml`, the name of publication files.
#[must_use]
pub fn is_publication_path(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == NAME)
}

/// Reads the publication file in the folder of the model file `path`; `None` if there is none.
/// The formulas of the publication are added to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the publication file.
#[cfg(feature = "files")]
pub fn load_publication_of_model(path: &Path, model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    let found = publication_path_of_model(path);
    if !found.exists() {
        return Ok(None);
    }
    super::load_publication(&crate::diagnostic::Source::read(&found)?, model).map(Some)
}

/// Always returns `None`, because the program is built without access to files.
///
/// # Errors
/// Never an error.
#[cfg(not(feature = "files"))]
pub fn load_publication_of_model(_path: &Path, _model: &mut Model) -> Result<Option<Publication>, Diagnostics> {
    Ok(None)
}

/// Hash of the publication file in the folder of the model file `path`, including the files to which it refers. Returns
/// an empty text if there is no readable publication file. A referenced file that cannot be read is left out.
#[must_use]
#[cfg(feature = "files")]
pub fn hash_publication_of_model(path: &Path) -> String {
    let Ok(mut text) = std::fs::read_to_string(publication_path_of_model(path)) else { return String::new() };
    for name in referenced_file_names(&text) {
        if let Ok(file) = read_file_beside_publication(&path.with_file_name(name)) {
            text.push_str(&file.text);
        }
    }
    crate::model::text_hash(&text)
}

/// Names of the files to which a publication file refers, each once, in alphabetical order.
#[cfg(feature = "files")]
fn referenced_file_names(text: &str) -> Vec<String> {
    use toml::de::{DeTable, DeValue};
    let (table, _) = DeTable::parse_recoverable(text);
    let mut names = std::collections::BTreeSet::new();
    let mut tables = vec![table.get_ref()];
    for (_, value) in table.get_ref() {
        if let DeValue::Array(list) = value.get_ref() {
            tables.extend(list.iter().filter_map(|entry| entry.get_ref().as_table()));
        }
    }
    let names_file =
        |table: &&DeTable<'_>| table.get("file").and_then(|file| file.get_ref().as_str().map(str::to_owned));
    names.extend(tables.iter().filter_map(names_file).filter(|name| !name.contains(['/', '\\'])));
    names.into_iter().collect()
}

/// Returns an empty hash, because the program is built without access to files.
#[must_use]
#[cfg(not(feature = "files"))]
pub fn hash_publication_of_model(_path: &Path) -> String {
    String::new()
}
