//! Which code runs a model: compiled in, or interpreted.

use crate::failure::Failure;
use crate::interpreted::{Interpreted, NotInterpreted};
use crate::run::method;
use std::path::{Path, PathBuf};
use tripos_codegen::scene_files::is_same;
use tripos_codegen::workspace::report_beside;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, Distance, derive_all, in_distance};
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{QUADRATURE, Scene, Solve};
use tripos_derive::{Equations, Formulation, Model, derive};
use tripos_traits::{CompiledModel, CompiledSystem, DoubleDouble, System};

/// Equations ready to run.
#[derive(Clone)]
pub enum Code {
    /// Generated Rust, compiled in.
    Compiled(&'static CompiledSystem),
    /// A tape made just now.
    Interpreted(Box<Interpreted>),
}

impl Code {
    /// The equations.
    pub fn system(&self) -> &dyn System<f64> {
        match self {
            Self::Compiled(system) => system.double,
            Self::Interpreted(system) => system.as_ref(),
        }
    }

    /// The same in twice the precision of a double, which only compiled code has.
    pub fn extended(&self) -> Option<&dyn System<DoubleDouble>> {
        match self {
            Self::Compiled(system) => Some(system.extended),
            Self::Interpreted(_) => None,
        }
    }

    /// Whether they are compiled in.
    pub fn is_compiled(&self) -> bool {
        matches!(self, Self::Compiled(_))
    }

    /// How tables name it.
    pub fn name(&self) -> &'static str {
        if self.is_compiled() { "compiled" } else { "interpreted" }
    }
}

/// The model file that an argument means: a file, or a folder with `model.toml` in it.
pub fn model_file(argument: &Path) -> PathBuf {
    if argument.is_dir() { argument.join("model.toml") } else { argument.to_owned() }
}

/// Reads the model that an argument means.
pub fn read_model(argument: &Path) -> Result<Model, Failure> {
    if std::fs::symlink_metadata(argument).is_err_and(|error| error.kind() == std::io::ErrorKind::NotFound) {
        let what = format!("there is no model at `{}`: no such file or folder", argument.display());
        let help = "give a model file, or a folder that holds `model.toml`".to_owned();
        return Err(Failure::Request(what, help));
    }
    let path = model_file(argument);
    Ok(tripos_derive::model::load(&Source::read(&path)?)?)
}

/// The short name of a model: its folder, or the file's own name if it is not called `model.toml`.
pub fn short_name(model: &Model) -> String {
    let path = &model.source.path;
    let stem = path.file_stem().map_or("model".into(), |s| s.to_string_lossy().into_owned());
    if stem != "model" {
        return stem;
    }
    let full = path.canonicalize().unwrap_or_else(|_| path.clone());
    full.parent().and_then(Path::file_name).map_or(stem, |folder| folder.to_string_lossy().into_owned())
}

/// The formulation of this name.
pub fn formulation(name: &str) -> Result<Formulation, Failure> {
    Formulation::ALL.into_iter().find(|f| f.name() == name).ok_or_else(|| {
        let names = Formulation::ALL.map(Formulation::name);
        Failure::Request(format!("there is no formulation `{name}`"), tripos_derive::diagnostic::nearest(name, names))
    })
}

/// Which equations run: derived ones, or printed ones of the report beside the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct By {
    /// `kane`, `lagrange`, `newton-euler` or `printed:ID`.
    pub name: String,
    /// The name in a heading.
    pub title: String,
    /// The formulation; none for printed equations.
    derived: Option<Formulation>,
}

impl From<Formulation> for By {
    fn from(f: Formulation) -> Self {
        Self { name: f.name().to_owned(), title: f.title().to_owned(), derived: Some(f) }
    }
}

impl By {
    /// Printed equations.
    pub fn printed(equations: &Equations) -> Self {
        Self { name: equations.name.clone(), title: equations.title.clone(), derived: None }
    }

    /// A scene's own equations.
    pub fn reduced() -> Self {
        Self { name: "reduced".to_owned(), title: "Reduced equations".to_owned(), derived: None }
    }

    /// Whether these are a scene's own equations.
    pub fn is_reduced(&self) -> bool {
        self.name == "reduced"
    }

    /// The formulation; none for printed and for reduced equations.
    pub fn formulation(&self) -> Option<Formulation> {
        self.derived
    }
}

/// What `--by` means for this model.
pub fn by(model: &Model, name: &str) -> Result<By, Failure> {
    if !name.starts_with("printed:") {
        return formulation(name).map(By::from);
    }
    let list = printed(model)?;
    list.iter().find(|by| by.name == name).cloned().ok_or_else(|| {
        let names = list.iter().map(|by| by.name.as_str());
        let help = if list.is_empty() {
            "the model has no report.toml beside it".to_owned()
        } else {
            tripos_derive::diagnostic::nearest(name, names)
        };
        Failure::Request(format!("there are no printed equations `{name}`"), help)
    })
}

/// What `--by` means, or the first formulation that the model supports if it is not given.
pub fn by_or_first(model: &Model, name: Option<&str>) -> Result<By, Failure> {
    let first = || Formulation::ALL.into_iter().find(|f| derive(model, *f).is_ok()).unwrap_or(Formulation::Kane);
    name.map_or_else(|| Ok(By::from(first())), |name| by(model, name))
}

/// The printed equations of the report beside a model, in the order of the report.
pub fn printed(model: &Model) -> Result<Vec<By>, Failure> {
    let list = printed_derivation(model)?.map(|(_, equations)| equations).unwrap_or_default();
    Ok(list.iter().map(By::printed).collect())
}

/// Printed equations, with the model that holds their terms.
fn printed_derivation(model: &Model) -> Result<Option<(Arena, Vec<Equations>)>, Failure> {
    let mut with_report = model.clone();
    let Some(report) = report_beside(&model.source.path, &mut with_report)? else { return Ok(None) };
    let mut derivations = derive_all(&with_report).map_err(|error| model.diagnose(&error))?;
    let list = printed_equations(&with_report, &mut derivations, &report);
    Ok(Some((derivations.kinematics.arena, list)))
}

/// How much of interpreted equations is made ready: compiled ones have everything.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ready {
    /// The equations as they were derived: a matrix, a right-hand side, energies.
    AsDerived,
    /// Also the accelerations solved for, with their Jacobian and their recurrences, which takes much longer.
    Solved,
}

impl Ready {
    /// What runs of a scene need: a numeric solve asks for nothing that elimination gives but the Jacobian.
    ///
    /// # Errors
    /// [`Failure::Request`] if there is no such method.
    pub fn for_runs(scene: &Scene) -> Result<Self, Failure> {
        let how = &scene.integration;
        let numeric = how.solve == Some(Solve::Numeric) && how.method != QUADRATURE;
        Ok(if numeric && !method(&how.method)?.needs_jacobian() { Self::AsDerived } else { Self::Solved })
    }
}

/// The equations of a model: compiled in if they were derived from this very text.
///
/// In a distance, if one is given.
pub fn code(model: &Model, by: &By, distance: Option<Distance>, ready: Ready) -> Result<Code, Failure> {
    if let Some(code) = compiled_code(model, by, distance) {
        return Ok(code);
    }
    let derivation = derivation(model, by)?;
    let derivation = match distance {
        Some(distance) => in_distance(model, derivation, distance),
        None => derivation,
    };
    code_of(model, by, &derivation, ready)
}

/// The equations of a model that were compiled in, if there are such and they are current.
pub fn compiled_code(model: &Model, by: &By, distance: Option<Distance>) -> Option<Code> {
    let compiled = compiled(model)?;
    let name = match distance {
        Some(distance) => format!("{}@{}", by.name, distance.name(model)),
        None => by.name.clone(),
    };
    let found = compiled.systems.iter().find(|system| system.name == name);
    let current = by.derived.is_some() || report_hash(model) == compiled.report_hash;
    found.filter(|_| current).map(Code::Compiled)
}

/// The equations of a scene that were compiled in, if they are of what it says.
pub fn compiled_scene(reduction: &Reduction) -> Option<Code> {
    let key = reduction.key();
    let found = tripos::MODELS.iter().flat_map(|model| model.scenes).find(|scene| scene.key == key);
    found.map(|scene| Code::Compiled(&scene.system))
}

/// Equations made ready to be run by interpretation. Printed ones are run as they stand.
///
/// # Errors
/// [`Failure::Request`] if they depend on what has no value during a run, as only printed ones can.
pub fn code_of(model: &Model, by: &By, derivation: &Derivation, ready: Ready) -> Result<Code, Failure> {
    let code = Interpreted::new(model, derivation).map_err(NotInterpreted::from);
    let code = match ready {
        Ready::Solved if by.derived.is_some() => code.and_then(|code| code.solved(derivation)),
        _ => code,
    };
    Ok(Code::Interpreted(Box::new(code.map_err(|why| not_interpreted(&by.name, &why))?)))
}

/// The equations of a scene made ready to be run by interpretation.
///
/// # Errors
/// [`Failure::Request`] if they depend on what has no value during a run, which what a reduction gives never does.
pub fn interpreted_scene(reduction: &Reduction) -> Result<Code, Failure> {
    let derivation = &reduction.derivation;
    let code = Interpreted::new(&reduction.model, derivation).map_err(NotInterpreted::from);
    let code = code.and_then(|code| Ok(code.solved(derivation)?.showing(reduction)?));
    Ok(Code::Interpreted(Box::new(code.map_err(|why| not_interpreted(&derivation.equations.name, &why))?)))
}

fn not_interpreted(name: &str, why: &NotInterpreted) -> Failure {
    match why {
        NotInterpreted::Unknown(unknown) => Failure::Request(
            format!("`{name}` mentions `{}`, which has no value during a run", unknown.0),
            "equations that run hold parameters, coordinates and motion variables only".to_owned(),
        ),
        NotInterpreted::Singular => Failure::Request(
            format!("`{name}` determines its accelerations in no configuration"),
            "its mass matrix is singular everywhere: give every coordinate something that resists it".to_owned(),
        ),
    }
}

/// What computes these values of inputs.
///
/// # Errors
/// [`Failure::Request`] if one of them mentions what is no input.
pub fn tape(arena: &Arena, inputs: &[Expr], values: &[Expr], what: &str) -> Result<Tape, Failure> {
    Tape::new(arena, inputs, values).map_err(|unknown| {
        let what = format!("{what} mentions `{}`, which has no value during a run", unknown.0);
        Failure::Request(what, "use parameters, coordinates, q', speeds and reactions".to_owned())
    })
}

/// The equations of a model as terms.
///
/// # Errors
/// [`Failure::Unsupported`] if the model does not have this formulation; [`Failure::Input`] if it cannot be derived.
pub fn derivation(model: &Model, by: &By) -> Result<Derivation, Failure> {
    if let Some(formulation) = by.derived {
        return derive(model, formulation).map_err(|error| {
            let kind = if error.is_unsupported() { Failure::Unsupported } else { Failure::Input };
            kind(model.diagnose(&error))
        });
    }
    let (arena, list) = printed_derivation(model)?.unwrap_or_default();
    let equations = list.into_iter().find(|e| e.name == by.name);
    let missing = || {
        let help = "the report has changed while it was read: try again".to_owned();
        Failure::Request(format!("there are no equations `{}`", by.name), help)
    };
    Ok(Derivation { arena, equations: equations.ok_or_else(missing)? })
}

/// The hash of the text of the report beside a model; empty if there is none.
fn report_hash(model: &Model) -> String {
    let text = std::fs::read_to_string(model.source.path.with_file_name("report.toml"));
    text.map(|text| tripos_derive::model::text_hash(&text)).unwrap_or_default()
}

fn compiled(model: &Model) -> Option<&'static CompiledModel> {
    let hash = model.text_hash();
    tripos::MODELS.iter().find(|m| m.text_hash == hash)
}

/// What is to be said of a model of the workspace that was edited since its equations were compiled.
pub fn edited(model: &Model) -> Option<String> {
    let of_place = tripos::MODELS.iter().find(|m| is_workspace_model(model, m.name))?;
    (compiled(model).is_none()).then(|| {
        let name = of_place.name;
        format!(
            "the equations of `{name}` that were compiled are of another text, so this one is interpreted: \
             `tripos regenerate {name}` writes its equations, and the next build compiles them"
        )
    })
}

/// Whether the model file is the one that a compiled model was derived from, by place.
fn is_workspace_model(model: &Model, name: &str) -> bool {
    let path = &model.source.path;
    let folder = path.canonicalize().ok().and_then(|path| path.parent().map(Path::to_owned));
    let root = folder.and_then(|folder| workspace_around(&folder));
    root.is_some_and(|root| is_same(&root.join("models").join(name).join("model.toml"), path))
}

/// The workspace that a folder lies in: the nearest folder, from this one upwards, that holds `models` and `generated/src`.
pub fn workspace_around(folder: &Path) -> Option<PathBuf> {
    let is_root = |folder: &&Path| folder.join("models").is_dir() && folder.join("generated/src").is_dir();
    folder.ancestors().find(is_root).map(Path::to_owned)
}

/// The workspace that the command was called in.
///
/// # Errors
/// [`Failure::Request`] if it was called elsewhere: no command looks for a workspace that it was not called in.
pub fn workspace_here() -> Result<PathBuf, Failure> {
    let here = current_folder()?;
    workspace_around(&here).ok_or_else(|| {
        let what = format!(
            "no workspace: neither `{}` nor a folder above it holds `models` and `generated/src`",
            here.display()
        );
        let help = "go to a checkout that has both; `tripos emit MODEL --out DIR` writes the code of a model anywhere";
        Failure::Request(what, help.to_owned())
    })
}

/// The folder that the command was called in.
///
/// # Errors
/// [`Failure::Request`] if it is gone.
pub fn current_folder() -> Result<PathBuf, Failure> {
    let gone =
        |error| Failure::Request(format!("there is no current folder: {error}"), "go to one that exists".to_owned());
    std::env::current_dir().map_err(gone)
}
