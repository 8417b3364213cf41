//! Scene files given as arguments, each read with its model, and new values for numbers of a scene.

use super::workspace::{edited_workspace_model_warning, model_file, read_model};
use crate::terminal::failure::{Failure, print_to_stderr, warn};
use std::path::{Path, PathBuf};
use tripos::{Error, Mechanism};
use tripos_codegen::model_folders::scenes_in_model_folder;
use tripos_derive::diagnostic::{Source, nearest_name_advice};
use tripos_derive::model::is_model;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{Family, Grid, Scene, load_scene_with_inputs, model_path_of_scene};

/// Reads a scene file and its model.
///
/// # Errors
/// [`Failure`] if the file is missing or is no scene; it suggests scenes that may be meant. Also for every error of the
/// scene and its model.
pub fn read_scene(path: &Path) -> Result<(Mechanism, Scene), Failure> {
    let source = scene_source(path)?;
    let place = model_path_of_scene(&source)?;
    if !place.exists() {
        let what = format!(
            "`{}` names a model that does not exist: `{}`",
            path_as_plain_text(path),
            path_as_plain_text(&place)
        );
        let help = "write `model = \"…\"` in the scene: the path of its model file, seen from the scene";
        return Err(Failure::request(what, help));
    }
    let mut model = read_model(&place)?;
    let scene = load_scene_with_inputs(&source, &mut model)?;
    edited_workspace_model_warning(&model).iter().chain(&scene.degree_warnings(&model)).for_each(|note| warn(note));
    Ok((model, scene))
}

/// Scene in which numbers have new values, with its model.
pub struct SceneWithSetValues {
    /// Model of the mechanism in the scene.
    pub model: Mechanism,
    /// Scene in which the new values are set.
    pub scene: Scene,
    /// Names of the changed numbers, each with its new value.
    pub set: Vec<(String, f64)>,
}

/// Reads a scene and changes numbers in it, each given as `NAME=VALUE`. Prints the new values on standard error.
///
/// # Errors
/// [`Failure`] as for [`read_scene`]. Also for a name that is neither a parameter nor a number of the start, and for
/// values that the scene cannot have.
pub fn read_scene_with(path: &Path, set: &[String]) -> Result<SceneWithSetValues, Failure> {
    let (mut model, scene) = read_scene(path)?;
    let (scene, set) = set_scene_values(scene, &mut model, set)?;
    for (name, value) in &set {
        print_to_stderr(&format!("note: {name} = {value}, not the value of the scene"));
    }
    Ok(SceneWithSetValues { model, scene, set })
}

/// Changes numbers of a scene, each given as `NAME=VALUE`. Returns the changed scene, and the names with their values.
///
/// # Errors
/// [`Failure`] for a name that is neither a parameter nor a number of the start, and for values that the scene cannot
/// have.
pub fn set_scene_values(
    scene: Scene,
    model: &mut Mechanism,
    set: &[String],
) -> Result<(Scene, Vec<(String, f64)>), Failure> {
    if set.is_empty() {
        return Ok((scene, Vec::new()));
    }
    if let Some(text) = set.iter().find(|text| !text.contains('=')) {
        return Err(Failure::request(
            format!("`--set {text}` gives no value"),
            "write --set NAME=VALUE, such as --set m=2",
        ));
    }
    let grid = Grid::read(set, "--set", &scene, model).map_err(Error::Inputs)?;
    if grid.count() != 1 {
        let what = format!("`--set` gives {} values where a run has one", grid.count());
        return Err(Failure::request(what, "give one value for each name; `tripos sweep --over` runs many"));
    }
    grid.hints(model).iter().for_each(|hint| warn(hint));
    let names = grid.names().into_iter().map(str::to_owned);
    let (values, member) = Family::new(&scene, model, &grid)?.point(0);
    let scene = Scene { ladder: scene.ladder.clone(), ..member? };
    Ok((scene, names.zip(values).collect()))
}

/// Returns the title of a scene, or the name of its file if it has no title.
pub fn scene_title(scene: &Scene) -> String {
    let stem = || scene.source.path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
    if scene.title.is_empty() { stem() } else { scene.title.clone() }
}

/// Reads the text of a scene file.
///
/// # Errors
/// [`Failure`] for a folder, a missing file or a model file; it suggests scenes that may be meant.
fn scene_source(path: &Path) -> Result<Source, Failure> {
    let scenes_of = |model: &Path| -> Vec<String> {
        scenes_in_model_folder(model).iter().map(|file| path_as_plain_text(file)).collect()
    };
    let offer = |scenes: &[String]| match scenes {
        [] => "write a scene: docs/scene.md describes it".to_owned(),
        scenes => format!("give one of its scenes: {}", scenes.join(", ")),
    };
    if path.is_dir() {
        let what = format!("`{}` is a folder, not a scene", path_as_plain_text(path));
        return Err(Failure::request(what, offer(&scenes_of(&model_file(path)))));
    }
    if !path.exists() {
        let what = format!("there is no scene at `{}`", path_as_plain_text(path));
        return Err(Failure::request(what, missing_scene_advice(path)));
    }
    let source = Source::read(path)?;
    if is_model(&source) {
        let what = format!("`{}` is a model, not a scene", path_as_plain_text(path));
        return Err(Failure::request(what, offer(&scenes_of(path))));
    }
    Ok(source)
}

/// Returns a suggestion for a scene file that does not exist: TOML files with similar names in its folder.
fn missing_scene_advice(path: &Path) -> String {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = std::fs::read_dir(folder) else {
        return format!("there is no folder `{}` either", path_as_plain_text(folder));
    };
    let files = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let files: Vec<PathBuf> = files.filter(|file| file.extension().is_some_and(|end| end == "toml")).collect();
    let name = |file: &Path| file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut names: Vec<String> = files.iter().map(|file| name(file)).collect();
    names.sort();
    if names.is_empty() {
        return format!("`{}` holds no scene", path_as_plain_text(folder));
    }
    nearest_name_advice(&name(path), names.iter().map(String::as_str))
}
