//! Command `tripos regenerate`: the only command that writes `generated/` and the SymPy references in the models'
//! folders.

mod equation_changes;
mod python;
mod sympy_reference;

use crate::files::workspace::workspace_here;
use crate::terminal::failure::{Failure, Output, print, print_json, print_result, status};
use equation_changes::{EquationComparison, compare_with_committed_equations};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos::Error;
use tripos_codegen::generated_workspace::{
    DERIVED_MODEL_COPY, Freshness, GeneratedFileDifference, freshness, model_folders, write,
};
use tripos_codegen::plan::module_name;
use tripos_derive::Formulation;
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_derive::plain_text::path_as_plain_text;

/// Runs `tripos regenerate --check`: prints generated files and references that differ. Returns the exit status, which
/// is 1 if there are any.
///
/// # Errors
/// `Failure` outside a workspace, for an unknown model, and for models with errors.
pub fn check(models: &[PathBuf], output: Output) -> Result<u8, Failure> {
    let root = workspace_here()?;
    let (found, committed, asked) = compare_with_committed(&root, models)?;
    let text = regeneration_summary(&root, &found, &committed, asked.len());
    if output == Output::Text {
        print(&text)?;
    }
    let references = sympy_reference::check_references(&root, &models_without_errors(&found, asked));
    let lines: Vec<String> = references.iter().map(|line| format!("{line}\n")).collect();
    print_result(output, &lines.concat(), &json_of(&found, &text, &references))?;
    fail_for_broken_models(&found)?;
    Ok(if found.differences.is_empty() && references.is_empty() { 0 } else { status::NO })
}

/// Runs `tripos regenerate`: writes generated files that differ, prints the changes of the equations, and renews the
/// SymPy references. Returns the exit status, which is 1 if a reference disagrees.
///
/// # Errors
/// `Failure` outside a workspace, for an unknown model, for models with errors, and if a file cannot be written.
pub fn regenerate(models: &[PathBuf], output: Output) -> Result<u8, Failure> {
    let root = workspace_here()?;
    let (found, committed, asked) = compare_with_committed(&root, models)?;
    let text = regeneration_summary(&root, &found, &committed, asked.len());
    write(&found, &committed)?;
    if output == Output::Text {
        print(&text)?;
    }
    let (answer, references) = sympy_reference::renew_references(&root, &models_without_errors(&found, asked), output)?;
    if output == Output::Json {
        print_json(&json_of(&found, &text, &references))?;
    }
    fail_for_broken_models(&found)?;
    Ok(answer)
}

/// Returns, as JSON, the files that differ, the summary of the changes, and the lines about the references.
fn json_of(found: &Freshness, summary: &str, references: &[String]) -> Value {
    let files: Vec<String> = found.differences.iter().map(|difference| difference.file().to_owned()).collect();
    json!({ "differ": files, "summary": summary.lines().collect::<Vec<_>>(), "references": references })
}

/// Returns the names from `asked` whose models have no errors.
fn models_without_errors(found: &Freshness, mut asked: Vec<String>) -> Vec<String> {
    asked.retain(|name| !found.generated.broken.iter().any(|(broken, _)| broken == name));
    asked
}

/// Compares the models with the committed files. Returns the comparison, the folder of the
/// committed files, and the folder names of the chosen models.
///
/// # Errors
/// `Failure` if a folder cannot be read, or a chosen model does not exist.
fn compare_with_committed(root: &Path, models: &[PathBuf]) -> Result<(Freshness, PathBuf, Vec<String>), Failure> {
    let (folder, committed) = (root.join("models"), root.join("generated/src"));
    let unreadable = |error| {
        let what = format!("cannot read {}: {error}", path_as_plain_text(&folder));
        Failure::request(what, "run this in a checkout that has models/ and generated/".to_owned())
    };
    let all = model_folders(&folder).map_err(unreadable)?;
    let mut asked = Vec::new();
    for model in models {
        // The argument is a name such as `disk`, or a folder that a shell has completed.
        let name = model.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        if !all.contains(&name) {
            let what = format!("there is no model `{}` in {}", path_as_plain_text(model), path_as_plain_text(&folder));
            return Err(Failure::request(what, nearest_name_advice(&name, all.iter().map(String::as_str))));
        }
        asked.push(name);
    }
    let only = (!asked.is_empty()).then_some(asked.as_slice());
    let found = freshness(&folder, &committed, only).map_err(unreadable)?;
    Ok((found, committed, if models.is_empty() { all } else { asked }))
}

/// Reports models with errors as an error of the whole command.
fn fail_for_broken_models(found: &Freshness) -> Result<(), Failure> {
    if found.generated.broken.is_empty() {
        return Ok(());
    }
    Err(Error::Inputs(found.generated.broken.iter().map(|(_, diagnostics)| diagnostics.clone()).collect()).into())
}

/// Returns the report on the differences: changed files, changes of equations, and the number of changed code files.
fn regeneration_summary(root: &Path, found: &Freshness, committed: &Path, asked: usize) -> String {
    if found.differences.is_empty() {
        let models = if asked == 1 { "1 model".to_owned() } else { format!("{asked} models") };
        return format!("generated/ is fresh: {models}\n");
    }
    let (code, read): (Vec<_>, Vec<_>) =
        found.differences.iter().partition(|difference| is_regenerated_code(difference.file()));
    let mut out = String::new();
    let mut with_same_equations = Vec::new();
    let models: BTreeSet<&str> = found.differences.iter().filter_map(model_to_regenerate).collect();
    let known: BTreeMap<&str, EquationComparison> = models
        .into_iter()
        .map(|model| (model, compare_with_committed_equations(&root.join("models"), committed, model)))
        .collect();
    // Changed copies of edited models are not listed, since the person who edited the model knows of the edit.
    let is_model = |file: &str| file.ends_with(&format!("/{DERIVED_MODEL_COPY}"));
    for difference in
        read.into_iter().filter(|d| !matches!(d, GeneratedFileDifference::Changed(file) if is_model(file)))
    {
        match formulation_model_to_regenerate(difference).map(|model| &known[model]) {
            Some(EquationComparison::Same) => with_same_equations.push(difference.file()),
            _ => out.extend([difference.to_string(), "\n".to_owned()]),
        }
    }
    for (model, equations) in &known {
        match equations {
            EquationComparison::Same => {}
            EquationComparison::Changed(lines) => out.extend([model, ": ", lines]),
            EquationComparison::Unknown(why) => {
                let _ = writeln!(out, "{model}: what changed in the equations is not known: {why}");
            }
        }
    }
    if !with_same_equations.is_empty() {
        let _ = writeln!(out, "with the same equations in other text: {}", with_same_equations.join(", "));
    }
    if !code.is_empty() {
        let plural = if code.len() == 1 { "file" } else { "files" };
        let _ = writeln!(out, "and the code of these equations, {} {plural} under `code`", code.len());
    }
    out
}

/// Returns the name of the model whose equations, code or model file changed in this difference. `None` for other
/// files. Equations with many terms exist only as code.
fn model_to_regenerate(difference: &GeneratedFileDifference) -> Option<&str> {
    let GeneratedFileDifference::Changed(file) = difference else { return None };
    let (model, file) = file.split_once('/')?;
    (file == DERIVED_MODEL_COPY || file.starts_with("code/") || formulation_model_to_regenerate(difference).is_some())
        .then_some(model)
}

/// Returns the name of the model whose readable file of a formulation changed in this difference. `None` for all other
/// files.
fn formulation_model_to_regenerate(difference: &GeneratedFileDifference) -> Option<&str> {
    let GeneratedFileDifference::Changed(file) = difference else { return None };
    let (model, file) = file.split_once('/')?;
    let is_formulation = |f: &Formulation| file == format!("{}.rs", module_name(f.name()));
    Formulation::ALL.iter().any(is_formulation).then_some(model)
}

/// True if a generated file is code. Readable equations are in another file.
fn is_regenerated_code(file: &str) -> bool {
    Path::new(file).parent().is_some_and(|folder| folder.ends_with("code"))
}
