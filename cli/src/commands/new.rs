//! `tripos new`: a commented working folder to begin from.

use crate::failure::{Failure, print};
use crate::workspace::{model_file, workspace_around};
use std::path::{Path, PathBuf};
use tripos_codegen::files;
use tripos_derive::diagnostic::Source;
use tripos_derive::plain::{one_line, path_in_line};

const MODEL: &str = include_str!("new/model.toml");
const SCENE: &str = include_str!("new/scene.toml");

/// A file to be written, by its place in the folder.
type File = (PathBuf, String);

/// Writes a model and its scenes into a new folder, and says what to do with them.
///
/// # Errors
/// [`Failure`] if the folder holds something already, the model to begin from cannot be read, or nothing can be written.
pub fn new(folder: &Path, like: Option<&Path>) -> Result<u8, Failure> {
    let is_free = match std::fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == std::io::ErrorKind::NotFound,
    };
    let title = folder.file_name().map(|name| one_line(&name.to_string_lossy()));
    let (true, Some(title)) = (is_free, title) else {
        let what = format!("`{}` is no name for a new folder: there is something already", path_in_line(folder));
        return Err(Failure::request(what, "give the name of a folder that does not exist, or is empty".to_owned()));
    };
    let list = match like {
        Some(like) => copied(like)?,
        None => vec![
            ("model.toml".into(), MODEL.replace("TITLE", &title.replace(['\\', '"'], "_"))),
            ("scenes/first.toml".into(), SCENE.to_owned()),
        ],
    };
    for (place, text) in &list {
        let path = folder.join(place);
        let parent = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(parent).map_err(|error| Failure::Output(path_in_line(parent), error))?;
        files::write(&path, text)?;
        print(&format!("new      {}\n", path_in_line(&path)))?;
    }
    let at = |place: &Path| path_in_line(&folder.join(place));
    let scene = list.iter().map(|(place, _)| place).find(|place| place.starts_with("scenes"));
    print(&format!(
        "\nnext:\n  tripos check {}\n  tripos prove {}\n",
        at("model.toml".as_ref()),
        at("model.toml".as_ref())
    ))?;
    if let Some(scene) = scene {
        print(&format!("  tripos simulate {}\n", at(scene)))?;
    }
    Ok(0)
}

/// The model that an argument means, and its scenes: a file, a folder, or a name of the library of the workspace.
fn copied(like: &Path) -> Result<Vec<File>, Failure> {
    let named = || {
        let root = workspace_around(&std::env::current_dir().ok()?)?;
        Some(root.join("models").join(like).join("model.toml")).filter(|path| path.is_file())
    };
    let path = if like.exists() { model_file(like) } else { named().unwrap_or_else(|| model_file(like)) };
    let mut list = vec![("model.toml".into(), Source::read(&path).map_err(tripos::Error::from)?.text)];
    let folder = path.parent().unwrap_or(Path::new("")).join("scenes");
    let entries = match std::fs::read_dir(&folder) {
        Ok(entries) => entries.collect::<Result<Vec<_>, _>>(),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(error),
    };
    let entries = entries.map_err(|error| Failure::Output(path_in_line(&folder), error))?;
    let mut scenes: Vec<PathBuf> = entries.iter().map(std::fs::DirEntry::path).collect();
    scenes.retain(|path| path.is_file() && path.extension().is_some_and(|end| end == "toml"));
    scenes.sort();
    for scene in scenes {
        let Some(name) = scene.file_name() else { continue };
        let text = Source::read(&scene).map_err(tripos::Error::from)?.text;
        list.push((Path::new("scenes").join(name), text));
    }
    Ok(list)
}
