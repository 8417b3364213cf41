//! `tripos emit`: the generated code of any model file, for a program of the user's own.

use crate::failure::{Failure, Output, print_either, say};
use crate::workspace::model_file;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tripos::code::formulation;
use tripos_codegen::Extras;
use tripos_codegen::emit::{Emission, PlaceError, Placed, emit as emission, place};
use tripos_codegen::js::RUNNERS;
use tripos_codegen::js::emit::{EXTENSION, emit_model};
use tripos_derive::diagnostic::nearest;
use tripos_derive::plain::path_in_line;
use tripos_derive::{Formulation, Model};

/// Languages in which equations can be written.
const LANGUAGES: [&str; 2] = ["rust", "js"];

/// Writes the equations of a model in a language to files of `out`, and prints the outcome for each file. `with` names
/// further functions to be written.
pub fn emit(
    model: &Path,
    out: &Path,
    language: &str,
    formulations: &[String],
    with: &[String],
    output: Output,
) -> Result<u8, Failure> {
    let formulations = formulations.iter().map(|name| formulation(name)).collect::<Result<Vec<_>, _>>()?;
    let extras = Extras::named(with.iter().map(String::as_str)).map_err(|(what, help)| Failure::request(what, help))?;
    let (emission, then) = match language {
        "rust" => rust(model, out, &formulations, extras)?,
        "js" if extras != Extras::default() => {
            let what = "functions beside the equations are written in Rust alone".to_owned();
            return Err(Failure::request(what, "leave `--with` out, or give `--language rust`".to_owned()));
        }
        "js" => javascript(model, &formulations)?,
        other => {
            let what = format!("equations are not written in `{other}`");
            return Err(Failure::request(what, nearest(other, LANGUAGES)));
        }
    };
    for (_, error) in &emission.left_out {
        say(&format!("not emitted: {error}"));
    }
    let placed = place(&emission, out).map_err(|error| match error {
        PlaceError::Foreign(_) => {
            Failure::request(error.to_string(), "give another folder, or move the file away".to_owned())
        }
        PlaceError::Write(error) => error.into(),
        PlaceError::Io(path, error) => Failure::Output(path_in_line(&path), error),
    })?;
    let lines: Vec<String> = placed.iter().map(|file| format!("{file}\n")).collect();
    let left_out: Vec<Value> =
        emission.left_out.iter().map(|(f, why)| json!({ "formulation": f.name(), "why": why.to_string() })).collect();
    let files: Vec<Value> =
        placed.iter().map(Placed::word_and_file).map(|(word, file)| json!({ "file": file, "change": word })).collect();
    let value = json!({ "folder": path_in_line(out), "files": files, "left_out": left_out, "use": then });
    print_either(output, &lines.concat(), &value)?;
    say(&then);
    Ok(0)
}

/// Emits the Rust module of a model, with a sentence on its use.
fn rust(model: &Path, out: &Path, formulations: &[Formulation], extras: Extras) -> Result<(Emission, String), Failure> {
    let module = module(out)?;
    let emission = emission(&model_file(model), &module, formulations, extras)?;
    let then = format!(
        "declare it as `pub mod {module};` in a crate that depends on tripos-traits, or include its mod.rs in a module"
    );
    Ok((emission, then))
}

/// Emits the JavaScript modules of a model, with a sentence on their use.
fn javascript(model: &Path, formulations: &[Formulation]) -> Result<(Emission, String), Failure> {
    let emission = emit_model(&Model::read(&model_file(model))?, formulations)?;
    let runners = RUNNERS.map(|(name, _)| format!("{name}.{EXTENSION}"));
    let first = emission.files.keys().find(|file| !runners.contains(*file));
    let first = first.map_or("kane.mjs", String::as_str);
    let then = format!("import * as model from './{first}' and {{ run }} from './run.mjs', in Node or a browser");
    Ok((emission, then))
}

/// Name of the Rust module: that of its folder.
fn module(out: &Path) -> Result<String, Failure> {
    // `.` and `..` have no name of their own.
    let named =
        if out.file_name().is_some() { out.to_owned() } else { out.canonicalize().unwrap_or_else(|_| PathBuf::new()) };
    named.file_name().map(|name| name.to_string_lossy().into_owned()).ok_or_else(|| {
        let what = format!("`{}` has no name that a module could have", path_in_line(out));
        Failure::request(what, "give a folder whose name is a Rust module, as in `--out src/pendulum`".to_owned())
    })
}
