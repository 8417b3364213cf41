//! Command `tripos emit`: writes generated code from any model file, for use in another program.

use crate::files::scene_file::read_scene;
use crate::files::workspace::model_file;
use crate::terminal::failure::{Failure, Output, print_result, print_to_stderr, warn};
use crate::urdf::{Description, describe_robot};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tripos::equations_name::formulation_of_name;
use tripos_codegen::Extras;
use tripos_codegen::emit::{Emission, EmissionError, EmittedFileChange, emit_rust_module as emission, write_emission};
use tripos_codegen::js::RUNNERS;
use tripos_codegen::js::emit::{EXTENSION, emit_javascript_modules};
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::description::emit_description;
use tripos_codegen::languages::matlab::Matlab;
use tripos_codegen::languages::python::Python;
use tripos_codegen::languages::{self, Dialect, Selection};
use tripos_codegen::plan::{MissingOutputReason, ModulePlan, RegressorFunctions};
use tripos_derive::diagnostic::{Source, nearest_name_advice};
use tripos_derive::identify::BaseEquations;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{Scene, is_scene};
use tripos_derive::{Formulation, Model};
use tripos_robots::urdf_text;

/// Names of the languages in which equations can be written.
const LANGUAGES: [&str; 7] = ["rust", "js", "c", "python", "matlab", "casadi", "urdf"];

/// Arguments of `tripos emit`: the model, the language and the choice of equations and functions.
pub struct EmitRequest {
    /// Path of the model file, or of a scene file.
    pub model: PathBuf,
    /// Folder into which the files are written.
    pub out: PathBuf,
    /// Name of the language, such as `c`.
    pub language: String,
    /// Names of the formulations to write; if empty, all that the model supports.
    pub formulations: Vec<String>,
    /// Names of the optional functions to write; only for Rust.
    pub with: Vec<String>,
    /// Names of the functions to write; if empty, all functions. Not used for Rust and JavaScript.
    pub functions: Vec<String>,
    /// True if the equations are written in base parameters. Not used for Rust and JavaScript.
    pub in_base_parameters: bool,
}

/// Runs `tripos emit`: writes the equations of a model as code of a language into a folder, and prints the change of
/// each file. Returns the exit status.
///
/// # Errors
/// `Failure` if the request is refused, if the model has errors, or if a file of another origin would be replaced or
/// cannot be written.
pub fn emit(request: &EmitRequest, output: Output) -> Result<u8, Failure> {
    let EmitRequest { model, out, language, with, .. } = request;
    let formulations =
        request.formulations.iter().map(|name| formulation_of_name(name)).collect::<Result<Vec<_>, _>>()?;
    let extras = Extras::extras_from_names(with.iter().map(String::as_str))
        .map_err(|(what, help)| Failure::request(what, help))?;
    if language != "rust" && extras != Extras::default() {
        let what = "functions beside the equations are written in Rust alone".to_owned();
        return Err(Failure::request(what, "leave `--with` out, or give `--language rust`".to_owned()));
    }
    let dialect: Option<&dyn Dialect> = match language.as_str() {
        "c" => Some(&C),
        "python" => Some(&Python),
        "matlab" => Some(&Matlab),
        "casadi" => Some(&CasADi),
        _ => None,
    };
    if dialect.is_none() && !request.functions.is_empty() {
        let what = "functions can be chosen in C, Python, MATLAB and for CasADi".to_owned();
        return Err(Failure::request(what, "leave `--functions` out, or give one of these languages".to_owned()));
    }
    if request.in_base_parameters {
        check_base_request(request, dialect.is_some(), &formulations)?;
    }
    if language == "urdf" {
        return emit_robot(request, output);
    }
    let is_known = LANGUAGES.contains(&language.as_str());
    if dialect.is_none() && is_known && Source::read(&model_file(model)).is_ok_and(|source| is_scene(&source)) {
        let what = format!("the outputs and events of a scene are not written in `{language}`");
        let help = "give the model file in place of the scene, or --language c, python, matlab or casadi";
        return Err(Failure::request(what, help.to_owned()));
    }
    let (emission, then) = match (dialect, language.as_str()) {
        (Some(dialect), _) => emit_in_dialect(request, dialect, &formulations)?,
        (None, "rust") => emit_rust(model, out, &formulations, extras)?,
        (None, "js") => emit_javascript(model, &formulations)?,
        (None, name) => {
            let what = format!("equations are not written in `{name}`");
            return Err(Failure::request(what, nearest_name_advice(name, LANGUAGES)));
        }
    };
    for (_, error) in &emission.left_out {
        print_to_stderr(&format!("not emitted: {error}"));
    }
    let left_out: Vec<Value> =
        emission.left_out.iter().map(|(f, why)| json!({ "formulation": f.name(), "why": why.to_string() })).collect();
    place_emission(&emission, out, &left_out, &then, output)
}

/// Writes the files of an emission into a folder, and prints the change of each file. `left_out` is listed in JSON, and
/// `then` is a sentence about the use of the files. Returns the exit status.
///
/// # Errors
/// `Failure` if a file of another origin would be replaced or cannot be written.
fn place_emission(
    emission: &Emission,
    out: &Path,
    left_out: &[Value],
    then: &str,
    output: Output,
) -> Result<u8, Failure> {
    let placed = write_emission(emission, out).map_err(|error| match error {
        EmissionError::Foreign(_) | EmissionError::OtherModel(..) => {
            Failure::request(error.to_string(), "give another folder, or move the file away".to_owned())
        }
        EmissionError::Write(error) => error.into(),
        EmissionError::Io(path, error) => Failure::Output(path_as_plain_text(&path), error),
    })?;
    let lines: Vec<String> = placed.iter().map(|file| format!("{file}\n")).collect();
    let files: Vec<Value> = placed
        .iter()
        .map(EmittedFileChange::word_and_file)
        .map(|(word, file)| json!({ "file": file, "change": word }))
        .collect();
    let value = json!({ "folder": path_as_plain_text(out), "files": files, "left_out": left_out, "use": then });
    print_result(output, &lines.concat(), &value)?;
    print_to_stderr(then);
    Ok(0)
}

/// Writes the robot description of a model in URDF. The parts that it does not have are listed on standard error and at
/// the head of the file. Returns the exit status.
///
/// # Errors
/// `Failure` if the request names equations, if the model has no description in URDF, or if the file cannot be written.
fn emit_robot(request: &EmitRequest, output: Output) -> Result<u8, Failure> {
    if !request.formulations.is_empty() {
        let what = "a robot description in URDF has no equations".to_owned();
        return Err(Failure::request(what, "leave `--formulation` out, or give another language".to_owned()));
    }
    let path = model_file(&request.model);
    if Source::read(&path).is_ok_and(|source| is_scene(&source)) {
        let what = "a scene has no form in URDF".to_owned();
        return Err(Failure::request(what, "give the model file in place of the scene".to_owned()));
    }
    let model = Model::read(&path)?;
    let Description { robot, coordinates, remarks, notes } = describe_robot(&model)?;
    let emission = emit_description(&model, &["urdf"], |origin| {
        let left_out = remarks.iter().map(|remark| format!("Left out: {remark}."));
        let notes = notes.iter().map(|note| format!("Note: {note}."));
        let comments: Vec<String> =
            [origin.to_owned()].into_iter().chain(coordinates.iter().cloned()).chain(left_out).chain(notes).collect();
        urdf_text(&robot, &comments)
    });
    for remark in &remarks {
        print_to_stderr(&format!("left out: {remark}"));
    }
    for note in &notes {
        print_to_stderr(&format!("note: {note}"));
    }
    let left_out: Vec<Value> = remarks.iter().map(|remark| json!({ "what": remark })).collect();
    let then = "each coordinate of the model belongs to one joint, with the same zero and sign; parameters have their default values";
    place_emission(&emission, &request.out, &left_out, then, output)
}

/// Checks a request for equations in base parameters. `Err` if the language, a formulation or a function has no form in
/// base parameters.
fn check_base_request(request: &EmitRequest, has_dialect: bool, formulations: &[Formulation]) -> Result<(), Failure> {
    if !has_dialect {
        let what = "equations in base parameters are written in C, Python, MATLAB and for CasADi".to_owned();
        return Err(Failure::request(what, "leave `--base` out, or give one of these languages".to_owned()));
    }
    if let Some(other) = formulations.iter().find(|f| **f != BaseEquations::FORMULATION) {
        let what = format!("equations in base parameters are those of Kane's method, not of `{}`", other.name());
        return Err(Failure::request(what, "leave `--formulation` out, or give --formulation kane".to_owned()));
    }
    let of_regressor =
        |name: &&String| RegressorFunctions::FUNCTIONS.contains(&name.as_str()) && *name != "base_parameters";
    if let Some(name) = request.functions.iter().find(of_regressor) {
        let what = format!("the function `{name}` belongs to the equations in the parameters of the model");
        return Err(Failure::request(what, "leave `--base` out".to_owned()));
    }
    Ok(())
}

/// Generates the Rust module of a model. The second result is a sentence about its use. `Err` if the folder has no
/// name, or the model has errors.
fn emit_rust(
    model: &Path,
    out: &Path,
    formulations: &[Formulation],
    extras: Extras,
) -> Result<(Emission, String), Failure> {
    let module = rust_module_name(out)?;
    let emission = emission(&model_file(model), &module, formulations, extras)?;
    let then = format!(
        "declare it as `pub mod {module};` in a crate that depends on tripos-traits, or include its mod.rs in a module"
    );
    Ok((emission, then))
}

/// Generates the JavaScript modules of a model. The second result is a sentence about their use. `Err` if the model has
/// errors.
fn emit_javascript(model: &Path, formulations: &[Formulation]) -> Result<(Emission, String), Failure> {
    let emission = emit_javascript_modules(&Model::read(&model_file(model))?, formulations)?;
    let runners = RUNNERS.map(|(name, _)| format!("{name}.{EXTENSION}"));
    let first = emission.files.keys().find(|file| !runners.contains(*file));
    let first = first.map_or("kane.mjs", String::as_str);
    let then = format!("import * as model from './{first}' and {{ run }} from './run.mjs', in Node or a browser");
    Ok((emission, then))
}

/// Generates the modules of a model in C, Python, MATLAB or for CasADi. The second result is a sentence about their
/// use. `Err` if a requested function is unknown, or the model or the scene has errors.
fn emit_in_dialect(
    request: &EmitRequest,
    dialect: &dyn Dialect,
    formulations: &[Formulation],
) -> Result<(Emission, String), Failure> {
    let known =
        || ModulePlan::FUNCTIONS.into_iter().chain(dialect.composites().iter().map(|composite| composite.name()));
    if let Some(name) = request.functions.iter().find(|name| !known().any(|known| known == *name)) {
        let what = format!("there is no function `{name}`");
        return Err(Failure::request(what, nearest_name_advice(name, known())));
    }
    let (model, scene) = read_emit_source(&request.model)?;
    let selection = Selection {
        formulations,
        functions: &request.functions,
        in_base_parameters: request.in_base_parameters,
        scene: scene.as_ref(),
    };
    let emitted = languages::emit_language_modules(&model, dialect, selection)?;
    for (name, equations, why) in &emitted.hidden {
        let why = match why {
            MissingOutputReason::Reaction => "the function needs a reaction, which has no closed form here",
            MissingOutputReason::Acceleration => "the function needs an acceleration, which has no closed form here",
        };
        warn(&format!("`{name}` is left out of the functions of {equations}: {why}"));
    }
    if let Some([base, plain]) = emitted.operations_in_base_parameters.filter(|[base, plain]| base > plain) {
        warn(&format!(
            "the mass matrix and the forcing take {base} operations in base parameters, and {plain} in the parameters of the model"
        ));
    }
    let file = &emitted.main_file;
    let stem = Path::new(file).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let then = match request.language.as_str() {
        "c" => format!(
            "#include \"{file}\", and compile {stem}.c with your program; it needs the mathematical library, -lm"
        ),
        "python" => format!("import {stem}, which needs NumPy"),
        "matlab" => format!("addpath the folder, and call {stem}() for the parameters, in MATLAB or Octave"),
        _ => format!("import {stem}, which needs CasADi; {stem}.function(\"mass_matrix\") is a casadi.Function"),
    };
    Ok((emitted.emission, then))
}

/// Reads a model file, or a scene file with its model, from the path `argument`. The scene is `None` for a model file.
/// `Err` if the file has errors.
fn read_emit_source(argument: &Path) -> Result<(Model, Option<Scene>), Failure> {
    let path = model_file(argument);
    if Source::read(&path).is_ok_and(|source| is_scene(&source)) {
        let (mechanism, scene) = read_scene(&path)?;
        return Ok((mechanism.model, Some(scene)));
    }
    Ok((Model::read(&path)?, None))
}

/// Returns the name of the Rust module, which is the name of its folder.
///
/// # Errors
/// `Failure` if the folder has no readable name.
fn rust_module_name(out: &Path) -> Result<String, Failure> {
    // `.` and `..` have no name of their own.
    let named =
        if out.file_name().is_some() { out.to_owned() } else { out.canonicalize().unwrap_or_else(|_| PathBuf::new()) };
    named.file_name().map(|name| name.to_string_lossy().into_owned()).ok_or_else(|| {
        let what = format!("the name of the folder `{}` cannot be a module's name", path_as_plain_text(out));
        Failure::request(what, "give a folder whose name is a Rust module, as in `--out src/pendulum`".to_owned())
    })
}
