//! Command `tripos new`: makes a new folder with a commented model and a scene as a starting point.

use crate::files::workspace::{model_file, workspace_around};
use crate::terminal::failure::{Failure, print, warn};
use std::path::{Path, PathBuf};
use tripos_codegen::draft_file;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::is_model;
use tripos_derive::plain_text::{one_line, path_as_plain_text};
use tripos_robots::Import;

/// Text of the commented model file for a new folder.
const MODEL: &str = include_str!("new/model.toml");
/// Text of the commented scene file for a new folder.
const SCENE: &str = include_str!("new/scene.toml");

/// Contents of the new folder: a model and its scenes.
struct Folder {
    /// Text of the new folder's file `model.toml`.
    model: String,
    /// Scenes, each with its file name and its text.
    scenes: Vec<(PathBuf, String)>,
    /// Remarks for the user, one line each.
    remarks: Vec<String>,
    /// Robot description from which the model was made; `None` for other models.
    import: Option<Import>,
}

/// Beginning of a new model: a commented example, a model to copy, or a robot description.
pub struct Beginning {
    /// Model to copy.
    pub like: Option<PathBuf>,
    /// Robot description to read, in URDF or MJCF.
    pub from: Option<PathBuf>,
    /// File with the loops of a robot in URDF.
    pub loops: Option<PathBuf>,
    /// Options of reading the robot description.
    pub options: tripos_robots::Options,
}

/// Runs `tripos new`: writes a model and its scenes into a new folder, and prints the next
/// commands. Returns the exit status.
///
/// A model of a robot description is read again. If it is refused, it is written all the same, with a warning that
/// gives the reasons, so that its author can mend the description or the model.
///
/// # Errors
/// [`Failure`] if the folder is not empty, the model to copy or the robot description cannot be
/// read, or a file cannot be written.
pub fn new(folder: &Path, beginning: &Beginning) -> Result<u8, Failure> {
    let is_free = match std::fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == std::io::ErrorKind::NotFound,
    };
    let title = folder.file_name().map(|name| one_line(&name.to_string_lossy()));
    let (true, Some(title)) = (is_free, title) else {
        let what =
            format!("the new folder `{}` cannot be made: something with this name exists", path_as_plain_text(folder));
        return Err(Failure::request(what, "give the name of a folder that does not exist, or is empty".to_owned()));
    };
    let made = match beginning {
        Beginning { like: Some(like), .. } => read_model_to_copy(like)?,
        Beginning { from: Some(from), loops, options, .. } => read_robot(from, loops.as_deref(), *options)?,
        Beginning { .. } => Folder {
            model: MODEL.replace("TITLE", &title.replace(['\\', '"'], "_")),
            scenes: vec![("first.toml".into(), SCENE.to_owned())],
            remarks: Vec::new(),
            import: None,
        },
    };
    let model = folder.join("model.toml");
    let place_of = |scene: &Path| folder.join("scenes").join(scene);
    let scenes = made.scenes.iter().map(|(name, text)| (place_of(name), text));
    for (path, text) in [(model.clone(), &made.model)].into_iter().chain(scenes) {
        let parent = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(parent).map_err(|error| Failure::Output(path_as_plain_text(parent), error))?;
        draft_file::write(&path, text)?;
        print(&format!("new      {}\n", path_as_plain_text(&path)))?;
    }
    for remark in &made.remarks {
        print(&format!("{remark}\n"))?;
    }
    if let Some(reasons) = made.import.as_ref().and_then(|import| refusal_of_import(import, &model)) {
        warn(&format!("`tripos check` refuses the model that was written:\n{reasons}"));
    }
    let model = path_as_plain_text(&model);
    print(&format!("\nnext:\n  tripos check {model}\n  tripos prove {model}\n"))?;
    if let Some((scene, _)) = made.scenes.first() {
        print(&format!("  tripos simulate {}\n", path_as_plain_text(&place_of(scene))))?;
    }
    Ok(0)
}

/// Reads the model to copy, with its scenes. `like` is a file, a folder, or the name of a model in `models/` of the
/// workspace.
///
/// # Errors
/// [`Failure`] if there is no such model, or if a file cannot be read.
fn read_model_to_copy(like: &Path) -> Result<Folder, Failure> {
    let named = || {
        let root = workspace_around(&std::env::current_dir().ok()?)?;
        Some(root.join("models").join(like).join("model.toml")).filter(|path| path.is_file())
    };
    let path = if like.exists() { model_file(like) } else { named().unwrap_or_else(|| model_file(like)) };
    let source = Source::read(&path).map_err(tripos::Error::from)?;
    if !is_model(&source) {
        let what = format!("`{}` is no model file", path_as_plain_text(&path));
        return Err(Failure::request(what, "give a model.toml, or the folder that holds it"));
    }
    let model = source.text;
    let folder = path.parent().unwrap_or(Path::new("")).join("scenes");
    let entries = match std::fs::read_dir(&folder) {
        Ok(entries) => entries.collect::<Result<Vec<_>, _>>(),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(error),
    };
    let entries = entries.map_err(|error| Failure::Output(path_as_plain_text(&folder), error))?;
    let mut paths: Vec<PathBuf> = entries.iter().map(std::fs::DirEntry::path).collect();
    paths.retain(|path| path.is_file() && path.extension().is_some_and(|end| end == "toml"));
    paths.sort();
    let mut scenes = Vec::new();
    for path in paths {
        let Some(name) = path.file_name() else { continue };
        let text = Source::read(&path).map_err(tripos::Error::from)?.text;
        scenes.push((name.into(), text));
    }
    Ok(Folder { model, scenes, remarks: Vec::new(), import: None })
}

/// Reads a robot description, with the file of its loops, as a model with one scene.
///
/// # Errors
/// [`Failure`] with all mistakes of the description, or else of the file of loops.
fn read_robot(path: &Path, loops: Option<&Path>, options: tripos_robots::Options) -> Result<Folder, Failure> {
    let source = Source::read(path).map_err(tripos::Error::from)?;
    let loops = loops.map(Source::read).transpose().map_err(tripos::Error::from)?;
    let import = tripos_robots::import(&source, loops.as_ref(), options).map_err(tripos::Error::from)?;
    let remarks = import.omissions.iter().map(|omission| format!("left out {omission}")).collect();
    let scenes = vec![("first.toml".into(), import.scene.clone())];
    Ok(Folder { remarks, model: import.model.clone(), scenes, import: Some(import) })
}

/// Reasons why the model of a robot description is refused; `None` if it is a valid model. Loops that cannot close have
/// the place at which their file states them, other reasons the place in the model file at `path`.
fn refusal_of_import(import: &Import, path: &Path) -> Option<Diagnostics> {
    let errors = tripos_derive::model::load(&Source::from_text(&path_as_plain_text(path), &import.model)).err()?;
    Some(import.errors_of_loops(&errors).unwrap_or(errors))
}
