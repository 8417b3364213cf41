//! Search on disk for the folders of models, and for the scene files of a model.
//!
//! Invariant: the page and the code generator get the scenes of a model from here, in the same order. A file in
//! `scenes/` counts as a scene, even with errors. The model's own folder also contains other files (a publication,
//! states, other models). A file in this folder is a scene only if its key `model` names this model. Unreadable files
//! are listed too, so that their readers report the errors.

use std::path::{Path, PathBuf};
use tripos_derive::diagnostic::Source;
use tripos_derive::publication::is_publication_path;
use tripos_derive::scene::model_path_of_scene;

/// Names of the folders under `models/` that contain a `model.toml`, in alphabetical order.
///
/// # Errors
/// Returns the error of the operating system if the folder cannot be listed.
pub fn model_folders(models: &Path) -> std::io::Result<Vec<String>> {
    let mut folders: Vec<String> = Vec::new();
    for entry in std::fs::read_dir(models)? {
        let entry = entry?;
        if entry.path().join("model.toml").exists() {
            folders.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
    folders.sort();
    Ok(folders)
}

/// Returns the scene files of a model file: first those in `scenes/`, then those in the model's
/// folder. Each group is in alphabetical order.
#[must_use]
pub fn scenes_in_model_folder(model: &Path) -> Vec<PathBuf> {
    let beside = model.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let is_scene = |path: &PathBuf| {
        let is_other = path.file_name() == model.file_name() || is_publication_path(path);
        let belongs = || {
            Source::read(path)
                .and_then(|source| model_path_of_scene(&source))
                .map_or(true, |of| is_same_model_file(&of, model))
        };
        !is_other && belongs()
    };
    let mut list = toml_files_in_model_folder(&model.with_file_name("scenes"));
    list.extend(toml_files_in_model_folder(beside).into_iter().filter(is_scene));
    list
}

/// Returns the path of a scene file relative to its model, such as `scenes/swing.toml` or
/// `swing.toml`.
#[must_use]
pub fn scene_path_in_model_folder(model: &Path, scene: &Path) -> String {
    let name = scene.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let is_inside = scene.parent() == Some(&model.with_file_name("scenes"));
    if is_inside { format!("scenes/{name}") } else { name }
}

/// True if two paths lead to the same existing file. False if one of the files does not exist.
#[must_use]
pub fn is_same_model_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// Paths of the TOML files in a folder, in alphabetical order. Empty if the folder cannot be read.
fn toml_files_in_model_folder(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let names = entries.filter_map(|entry| Some(entry.ok()?.file_name()));
    let mut list: Vec<PathBuf> = names.map(|name| folder.join(name)).collect();
    list.retain(|path| path.extension().is_some_and(|extension| extension == "toml") && !path.is_dir());
    list.sort();
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_in_their_folder_and_beside_their_model() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        for name in ["model.toml", "publication.toml", "state.toml", "notes.txt", "other/model.toml"] {
            put(name, "name = \"x\"\n");
        }
        put("scenes/b.toml", "");
        put("scenes/a.toml", "broken");
        put("own.toml", "model = \"model.toml\"\n");
        put("another's.toml", "model = \"other/model.toml\"\n");
        put("broken.toml", "model = \n");
        let model = folder.path().join("model.toml");
        let names: Vec<String> =
            scenes_in_model_folder(&model).iter().map(|path| scene_path_in_model_folder(&model, path)).collect();
        assert_eq!(names, ["scenes/a.toml", "scenes/b.toml", "broken.toml", "own.toml"]);
    }
}
