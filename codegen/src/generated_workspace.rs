//! Generated code of all models in a workspace, in the folder `generated/`.

use crate::draft_file::{self, WriteError};
pub use crate::model_folders::model_folders;
use crate::model_folders::{is_same_model_file, scene_path_in_model_folder, scenes_in_model_folder};
use crate::optional_functions::{Extras, requested_extras};
use crate::origin::Origin;
use crate::rust::{
    ModuleHeaderData, RustTarget, SceneFile, SceneHeaderData, generated_library_text, is_name,
    module_files as module_files_of, scene_file, scene_list,
};
use crate::target::{self, UnsupportedFormulations};
use std::collections::BTreeMap;
use std::path::Path;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::mechanics::{has_reducible_form, unsolved_equations_error};
use tripos_derive::publication::hash_publication_of_model;
use tripos_derive::reduce::reduce;
use tripos_derive::scene::{load_scene_with_inputs as load_scene, model_path_of_scene as scene_model};
use tripos_derive::{Formulation, Model};

/// Generated files of all models of a workspace, with the models and scenes that have errors.
#[derive(Debug, Default)]
pub struct GeneratedFiles {
    /// Texts of the files, by path under `generated/src`, with `/` between folders.
    pub files: BTreeMap<String, String>,
    /// Names of the folders under `models/` whose models have generated files, in alphabetical
    /// order.
    pub models: Vec<String>,
    /// Folder names of models with errors, each with its errors. Their committed files stay
    /// unchanged.
    pub broken: Vec<(String, Diagnostics)>,
    /// Paths of scene files with errors, such as `disk/scenes/report.toml`, each with its errors. No code is
    /// generated for them.
    pub broken_scenes: Vec<(String, Diagnostics)>,
}

/// Derives the models in the given folders under `models/` and generates their code.
///
/// A model with errors does not stop the generation for other models: it is listed in [`GeneratedFiles::broken`].
#[must_use]
pub fn generate(models: &Path, folders: &[String]) -> GeneratedFiles {
    let mut generated = GeneratedFiles::default();
    for folder in folders.iter().cloned() {
        match workspace_module_without_panic(&models.join(&folder).join("model.toml"), &folder) {
            Ok(module) => {
                let files = module.files.into_iter().map(|(name, text)| (format!("{folder}/{name}"), text));
                generated.files.extend(files);
                let scenes = module.broken_scenes.into_iter();
                generated.broken_scenes.extend(scenes.map(|(scene, why)| (format!("{folder}/{scene}"), why)));
                generated.models.push(folder);
            }
            Err(diagnostics) => generated.broken.push((folder, diagnostics)),
        }
    }
    generated
}

/// Generates the module of one model. A panic during the derivation becomes an error of this model.
fn workspace_module_without_panic(path: &Path, folder: &str) -> Result<ModuleFiles, Diagnostics> {
    std::panic::catch_unwind(|| workspace_module(path, folder)).unwrap_or_else(|_| {
        let source = Source { path: path.to_owned(), text: String::new() };
        let help = "this is a defect of the program, not of the model: please report it with the model file";
        let diagnostic = Diagnostic::of_file("the derivation of this model failed unexpectedly", help);
        Err(Diagnostics::new(source, vec![diagnostic]))
    })
}

/// Generates the files of one model of the workspace, and returns their texts by relative path. `folder` is the
/// model's folder name.
///
/// # Errors
/// Returns [`Diagnostics`] of the model file.
pub fn generated_model_files(path: &Path, folder: &str) -> Result<BTreeMap<String, String>, Diagnostics> {
    Ok(workspace_module(path, folder)?.files)
}

/// Generates the module of one workspace model, and adds a copy of the model text for later comparison. `Err` holds
/// the errors of the model, its publication or `code.toml`.
fn workspace_module(path: &Path, folder: &str) -> Result<ModuleFiles, Diagnostics> {
    let origin = Origin { folder: format!("models/{folder}/"), model: "model.toml".to_owned(), command: "regenerate" };
    let model = Model::read(path)?;
    let extras = requested_extras(&model, path)?;
    let mut module = generated_module_files(&model, folder, &origin, &[], extras)?;
    module.files.insert(DERIVED_MODEL_COPY.to_owned(), model.source.text);
    Ok(module)
}

/// Name of the generated file that contains the model text from which a module was derived. After the model file is
/// edited, both texts are derived and compared.
pub const DERIVED_MODEL_COPY: &str = "derived_from.toml";

/// Generated files of one model, with the formulations and scenes that were left out.
pub(crate) struct ModuleFiles {
    /// Texts of the model's generated files, by relative path.
    pub files: BTreeMap<String, String>,
    /// Formulations that the model does not support, each with the reason.
    pub left_out: UnsupportedFormulations,
    /// Scene files with errors, each as (path relative to the model, errors).
    pub broken_scenes: Vec<(String, Diagnostics)>,
}

/// Generates the files of the module `module` of a model. They contain the given formulations. If none are given,
/// they contain all that the model supports, and the printed equations of its publication.
///
/// # Errors
/// Returns [`Diagnostics`] of the publication or a formulation, or if `module` cannot be a Rust module name.
pub(crate) fn generated_module_files(
    model: &Model,
    module: &str,
    origin: &Origin,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<ModuleFiles, Diagnostics> {
    let path = model.source.path.as_path();
    if !is_name(module) {
        let message = format!("the folder's name `{module}` cannot be a Rust module");
        let help = "rename the folder: a letter, then letters, digits and `_`";
        let diagnostic = Diagnostic::of_file(message, help);
        return Err(Diagnostics::new(model.source.clone(), vec![diagnostic]));
    }
    let mut text = RustTarget::new(origin, extras);
    let left_out = target::pass_equations_to_target(model, formulations, &mut text)?;
    let (mut files, entries) = text.finish(model)?;
    let publication_hash = if formulations.is_empty() { hash_publication_of_model(path) } else { String::new() };
    let (mut scenes, mut broken_scenes) = (Vec::<SceneFile>::new(), Vec::new());
    if origin.has_scenes() {
        for scene in scenes_in_model_folder(path) {
            match generated_scene_file(model, &scene, origin, extras, &scenes) {
                Ok(file) => scenes.extend(file),
                Err(diagnostics) => broken_scenes.push((scene_path_in_model_folder(path, &scene), diagnostics)),
            }
        }
    }
    let about = ModuleHeaderData {
        module,
        origin: &origin.model_origin_sentence(),
        publication_hash: &publication_hash,
        has_scenes: !scenes.is_empty(),
    };
    let [own, code] = module_files_of(model, &about, &entries);
    files.extend([("mod.rs".to_owned(), own), ("code/mod.rs".to_owned(), code)]);
    if !scenes.is_empty() {
        let [list, code] = scene_list(&model.title, &origin.model_origin_sentence(), &scenes);
        files.extend([("scenes/mod.rs".to_owned(), list), ("scenes/code/mod.rs".to_owned(), code)]);
    }
    for SceneFile { module, text, code, .. } in scenes {
        files.insert(format!("scenes/{module}.rs"), text);
        files.extend(code.map(|text| (format!("scenes/code/{module}.rs"), text)));
    }
    Ok(ModuleFiles { files, left_out, broken_scenes })
}

/// Generates the file of one scene. Its name and functions differ from those of the earlier scenes `before`. `None`
/// if the scene belongs to another model, or if the model has no reduced equations.
///
/// # Errors
/// Returns [`Diagnostics`] of the scene file, or if its reduced equations cannot be solved.
fn generated_scene_file(
    model: &Model,
    path: &Path,
    origin: &Origin,
    extras: Extras,
    before: &[SceneFile],
) -> Result<Option<SceneFile>, Diagnostics> {
    let source = Source::read(path)?;
    let belongs = scene_model(&source)?;
    if !is_same_model_file(&belongs, &model.source.path) {
        return Ok(None);
    }
    if !has_reducible_form(model) {
        return Ok(None);
    }
    // The scene gets its own arena, so that its text does not depend on other scenes.
    let mut model = model.clone();
    let loaded = load_scene(&source, &mut model)?;
    let reduction = reduce(&model, &loaded).map_err(|error| model.diagnose(&error))?;
    let name = scene_path_in_model_folder(&model.source.path, path);
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let named = SceneHeaderData { name: &stem, title: &loaded.title, origin: &origin.scene_origin_sentence(&name) };
    let file = scene_file(&model, &reduction, &named, extras, before);
    file.map(Some).map_err(|why| unsolved_equations_error(&source, "the scene's reduced equations", why))
}

/// Difference between a committed file of `generated/src` and the file that the models generate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GeneratedFileDifference {
    /// The models generate the file, but it is not committed.
    Missing(String),
    /// The committed file differs from the generated text.
    Changed(String),
    /// No model generates the committed file any more.
    Extra(String),
}

impl std::fmt::Display for GeneratedFileDifference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Missing(file) => write!(f, "missing  {file}"),
            Self::Changed(file) => write!(f, "changed  {file}"),
            Self::Extra(file) => write!(f, "extra    {file}"),
        }
    }
}

impl GeneratedFileDifference {
    /// Path of the file, relative to `generated/src`.
    #[must_use]
    pub fn file(&self) -> &str {
        match self {
            Self::Missing(file) | Self::Changed(file) | Self::Extra(file) => file,
        }
    }
}

/// Freshly generated files of all models, and their differences from the committed files.
#[derive(Debug)]
pub struct Freshness {
    /// Freshly generated files, including `lib.rs`. Models with errors and models that were not requested keep their
    /// committed files.
    pub generated: GeneratedFiles,
    /// Files that are missing, changed or no longer generated.
    pub differences: Vec<GeneratedFileDifference>,
}

/// Generates every model, or only those in the folders `only`. Compares the text with the committed files byte by
/// byte.
///
/// # Errors
/// Returns the error of the operating system if a folder or a file cannot be read.
pub fn freshness(models: &Path, committed: &Path, only: Option<&[String]>) -> std::io::Result<Freshness> {
    let all = model_folders(models)?;
    let mut generated = generate(models, only.unwrap_or(&all));
    let on_disk = read_tree(committed)?;
    // A model with errors keeps its committed files.
    for name in all.into_iter().filter(|name| !generated.models.contains(name)).collect::<Vec<_>>() {
        let kept: Vec<_> = on_disk.iter().filter(|(file, _)| Path::new(file).starts_with(&name)).collect();
        if !kept.is_empty() {
            generated.models.push(name);
            generated.files.extend(kept.into_iter().map(|(file, text)| (file.clone(), text.clone())));
        }
    }
    generated.models.sort();
    generated.files.insert("lib.rs".to_owned(), generated_library_text(&generated.models));
    let mut differences = Vec::new();
    for (file, text) in &generated.files {
        match on_disk.get(file) {
            None => differences.push(GeneratedFileDifference::Missing(file.clone())),
            Some(old) if old != text => differences.push(GeneratedFileDifference::Changed(file.clone())),
            Some(_) => {}
        }
    }
    let extra = on_disk.into_keys().filter(|file| !generated.files.contains_key(file));
    differences.extend(extra.map(GeneratedFileDifference::Extra));
    Ok(Freshness { generated, differences })
}

/// Reads all files under a folder, and returns their texts by path relative to it. Empty if the folder does not
/// exist. `Err` if a folder or a file cannot be read.
fn read_tree(root: &Path) -> std::io::Result<BTreeMap<String, String>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        let path = root.join(&folder);
        if !path.is_dir() {
            continue;
        }
        for entry in std::fs::read_dir(path)? {
            let entry = entry?;
            let name = format!("{folder}{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                folders.push(format!("{name}/"));
            } else {
                files.insert(name, String::from_utf8_lossy(&std::fs::read(entry.path())?).into_owned());
            }
        }
    }
    Ok(files)
}

/// Writes the changed and new generated files to the folder `committed`, and removes files that are no longer
/// generated.
///
/// # Errors
/// Returns a [`WriteError`] if a file cannot be written or removed.
pub fn write(freshness: &Freshness, committed: &Path) -> Result<(), WriteError> {
    for difference in &freshness.differences {
        let path = committed.join(difference.file());
        match freshness.generated.files.get(difference.file()) {
            Some(text) => {
                if let Some(folder) = path.parent() {
                    draft_file::create_folder(folder)?;
                }
                draft_file::write(&path, text)?;
            }
            None => {
                std::fs::remove_file(&path).map_err(|error| WriteError::Io(path.clone(), error))?;
                // The folder of a removed model is also removed, once it is empty.
                if let Some(folder) = path.parent().filter(|folder| *folder != committed) {
                    let _ = std::fs::remove_dir(folder);
                }
            }
        }
    }
    Ok(())
}
