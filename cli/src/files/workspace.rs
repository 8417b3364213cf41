//! Models given as arguments, and the workspace around the current folder.

use crate::terminal::failure::Failure;
use crate::terminal::interruption::run_follower;
use std::path::{Path, PathBuf};
use tripos::Mechanism;
use tripos::code::compiled_model;
use tripos_codegen::model_folders::is_same_model_file;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::is_model;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{is_scene, model_path_of_scene};
use tripos_models::MODELS;

/// Returns the model file for an argument: the file itself, or `model.toml` in a folder.
pub fn model_file(argument: &Path) -> PathBuf {
    if argument.is_dir() { argument.join("model.toml") } else { argument.to_owned() }
}

/// Reads the model given by an argument, with its compiled equations if there are any.
///
/// # Errors
/// `Failure` for a missing file, for a scene, and for every error of the model.
pub fn read_model(argument: &Path) -> Result<Mechanism, Failure> {
    if std::fs::symlink_metadata(argument).is_err_and(|error| error.kind() == std::io::ErrorKind::NotFound) {
        let what = format!("there is no model at `{}`: no such file or folder", path_as_plain_text(argument));
        let help = "give a model file, or a folder that holds `model.toml`".to_owned();
        return Err(Failure::request(what, help));
    }
    let path = model_file(argument);
    if let Some(failure) = scene_instead_of_model_failure(&path) {
        return Err(failure);
    }
    Ok(Mechanism::read(&path)?.with_compiled_equations(MODELS).with_observer(run_follower()))
}

/// Returns the failure for a scene file that is given as a model; it suggests the scene's model. `None` for other
/// files.
fn scene_instead_of_model_failure(path: &Path) -> Option<Failure> {
    let source = Source::read(path).ok().filter(|source| is_scene(source) && !is_model(source))?;
    let what = format!("`{}` is a scene, not a model", path_as_plain_text(path));
    let model = model_path_of_scene(&source).ok().filter(|model| model.is_file());
    let help = model.map_or_else(
        || "give a model file".to_owned(),
        |model| format!("give its model, `{}`", path_as_plain_text(&model)),
    );
    Some(Failure::request(what, help))
}

/// Returns the short name of a model: the name of its file without extension, or of its folder if
/// the file is `model.toml`.
pub fn short_name(model: &Model) -> String {
    let path = &model.source.path;
    let stem = path.file_stem().map_or("model".into(), |s| s.to_string_lossy().into_owned());
    if stem != "model" {
        return stem;
    }
    let full = path.canonicalize().unwrap_or_else(|_| path.clone());
    full.parent().and_then(Path::file_name).map_or(stem, |folder| folder.to_string_lossy().into_owned())
}

/// Returns a warning that a workspace model was edited after its equations were compiled. `None` if it was not edited.
pub fn edited_workspace_model_warning(model: &Mechanism) -> Option<String> {
    let of_place = MODELS.iter().find(|m| is_workspace_model_file(model, m.name))?;
    (compiled_model(model).is_none()).then(|| {
        let name = of_place.name;
        format!(
            "the equations of `{name}` that were compiled are of another text, so this one is interpreted: \
             `tripos regenerate {name}` writes its equations, and the next build compiles them"
        )
    })
}

/// True if the model file is `models/NAME/model.toml` of the workspace, from which the compiled model `name` was
/// derived.
fn is_workspace_model_file(model: &Model, name: &str) -> bool {
    let path = &model.source.path;
    let folder = path.canonicalize().ok().and_then(|path| path.parent().map(Path::to_owned));
    let root = folder.and_then(|folder| workspace_around(&folder));
    root.is_some_and(|root| is_same_model_file(&root.join("models").join(name).join("model.toml"), path))
}

/// Returns the workspace around a folder: the nearest parent folder, or the folder itself, that contains `models` and
/// `generated/src`. `None` if there is none.
pub fn workspace_around(folder: &Path) -> Option<PathBuf> {
    let is_root = |folder: &&Path| folder.join("models").is_dir() && folder.join("generated/src").is_dir();
    folder.ancestors().find(is_root).map(Path::to_owned)
}

/// Returns the workspace around the current folder. No other places are searched.
///
/// # Errors
/// [`Failure::Refused`] if there is none.
pub fn workspace_here() -> Result<PathBuf, Failure> {
    let here = current_folder()?;
    workspace_around(&here).ok_or_else(|| {
        let what = format!(
            "no workspace: neither `{}` nor a folder above it holds `models` and `generated/src`",
            path_as_plain_text(&here)
        );
        let help = "go to a checkout that has both; `tripos emit MODEL --out DIR` writes the code of a model anywhere";
        Failure::request(what, help.to_owned())
    })
}

/// Returns the folder in which the command was called.
///
/// # Errors
/// [`Failure::Refused`] if that folder no longer exists.
pub fn current_folder() -> Result<PathBuf, Failure> {
    let gone =
        |error| Failure::request(format!("there is no current folder: {error}"), "go to one that exists".to_owned());
    std::env::current_dir().map_err(gone)
}
