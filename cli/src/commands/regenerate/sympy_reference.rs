//! SymPy reference of each model: a second derivation. It is renewed if Python is available, and recorded only if it
//! agrees.

use super::python::{find_python, run_with_time_limit};
use crate::phrases::formula_beginning;
use crate::terminal::failure::{Failure, Output, print, status, warn};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::time::Duration;
use tripos_derive::Model;
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::reference::{ComparedEntry, Reference, compare_reference};

/// Time limit for SymPy on one model. The models of the library take seconds.
const TIME: Duration = Duration::from_secs(120);

/// Outcome of renewing the SymPy reference of one model.
enum Outcome {
    /// The reference agrees in this number of entries, and has been recorded now.
    Recorded(usize),
    /// The reference agrees in this number of entries, and was recorded before.
    Unchanged(usize),
    /// SymPy does not derive this model. The text is the reason, which is recorded in the reference.
    NotDerived(String),
    /// SymPy did not run to its end, for a reason that is independent of the equations. The text is the reason.
    NotRenewed(String),
    /// The reference disagrees, or cannot be compared. The text has lines for the user.
    Refused(String),
}

/// Derives every model again with SymPy and records the references that agree. Returns the exit status, which is 1 if a
/// reference disagrees, and a line for each model. The lines are printed at once, unless the result is JSON. `Err` if a
/// line cannot be printed.
pub fn renew_references(root: &Path, models: &[String], output: Output) -> Result<(u8, Vec<String>), Failure> {
    let python = match find_python(root) {
        Ok(python) => python,
        Err(why) => {
            let count = if models.len() == 1 { "1 model".to_owned() } else { format!("{} models", models.len()) };
            warn(&format!("the SymPy reference of {count} was not renewed: {why}"));
            return Ok((0, Vec::new()));
        }
    };
    let (mut answer, mut lines) = (0, Vec::new());
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    for some in models.chunks(workers) {
        let outcomes: Vec<Outcome> = std::thread::scope(|scope| {
            let tasks: Vec<_> =
                some.iter().map(|model| scope.spawn(|| renew_reference(root, &python, model))).collect();
            let defect =
                |_| Outcome::Refused("the comparison failed unexpectedly: please report this model".to_owned());
            tasks.into_iter().map(|task| task.join().unwrap_or_else(defect)).collect()
        });
        for (model, outcome) in some.iter().zip(outcomes) {
            let line = match outcome {
                Outcome::Recorded(n) => format!("{model}: SymPy agrees in {n} entries; reference recorded"),
                Outcome::Unchanged(n) => format!("{model}: SymPy agrees in {n} entries"),
                Outcome::NotDerived(why) => format!("{model}: not derived by SymPy: {why}"),
                Outcome::NotRenewed(why) => {
                    warn(&format!("the SymPy reference of {model} was not renewed: {why}"));
                    continue;
                }
                Outcome::Refused(lines) => {
                    answer = status::NO;
                    format!("{model}: {}", lines.trim_end())
                }
            };
            if output == Output::Text {
                print(&format!("{line}\n"))?;
            }
            lines.push(line);
        }
    }
    Ok((answer, lines))
}

/// Derives one model with SymPy and compares the result with the model's equations. Records the result if they agree.
fn renew_reference(root: &Path, python: &Path, name: &str) -> Outcome {
    let path = root.join("models").join(name).join("model.toml");
    let script = root.join("tests/sympy/reference.py");
    let output = match run_with_time_limit(Command::new(python).arg(script).arg(&path), TIME) {
        Ok(output) if output.status.success() => output,
        Ok(output) => return Outcome::NotRenewed(output.last_line()),
        Err(why) => return Outcome::NotRenewed(why),
    };
    let source = Source { path: path.with_file_name("reference.json"), text: output.stdout };
    if let Ok(Reference { not_derived: Some(why), .. }) = Reference::read(&source) {
        return match record_reference(&source, 0) {
            Outcome::Refused(lines) => Outcome::Refused(lines),
            _ => Outcome::NotDerived(why),
        };
    }
    match disagreements(&path, &source) {
        Err(why) => Outcome::Refused(format!("the SymPy reference cannot be compared\n  {why}")),
        Ok((count, lines)) if lines.is_empty() => record_reference(&source, count),
        Ok((count, lines)) => Outcome::Refused(format!(
            "SymPy DISAGREES in {} of {count} entries; the reference is not recorded\n{}",
            lines.len(),
            lines.concat()
        )),
    }
}

/// Writes a reference that agrees in `count` entries, unless its file already has this text.
fn record_reference(reference: &Source, count: usize) -> Outcome {
    if std::fs::read(&reference.path).is_ok_and(|old| old == reference.text.as_bytes()) {
        return Outcome::Unchanged(count);
    }
    match tripos_codegen::draft_file::write(&reference.path, &reference.text) {
        Ok(()) => Outcome::Recorded(count),
        Err(error) => Outcome::Refused(error.to_string()),
    }
}

/// Compares a model with its SymPy reference. Returns the number of entries, and lines about each entry that is not
/// proved equal. `Err` is the reason why there is no comparison.
fn disagreements(model: &Path, reference: &Source) -> Result<(usize, Vec<String>), String> {
    let model = Model::read(model).map_err(|error| error.to_string())?;
    let reference = Reference::read(reference).map_err(|error| error.to_string())?;
    let mut derivations = derive_all(&model).map_err(|error| error.to_string())?;
    let found = compare_reference(&model, &mut derivations, &reference).map_err(|error| error.to_string())?;
    let arena = &derivations.kinematics.arena;
    let wrong = found.iter().filter(|entry| !entry.verdict.is_equal());
    Ok((found.len(), wrong.map(|entry| disagreement_lines(arena, entry)).collect()))
}

/// Returns lines about an entry that disagrees: both formulas, and a state in which they differ or the reason why they
/// are undecided.
fn disagreement_lines(arena: &Arena, entry: &ComparedEntry) -> String {
    let mut out = format!("  {}\n", entry.name);
    for (label, e) in [("derived    ", entry.derived), ("SymPy      ", entry.reference)] {
        if let Some(e) = e {
            let _ = writeln!(out, "    {label} {}", formula_beginning(&print_text(arena, e)));
        }
    }
    let _ = match &entry.verdict {
        Verdict::Different(witness) => {
            let at: Vec<String> = witness.at.iter().map(|(name, x)| format!("{name} = {x}")).collect();
            let place = if at.is_empty() { String::new() } else { format!(" at {}", at.join(", ")) };
            writeln!(out, "    witness     {} derived, {} by SymPy{place}", witness.right, witness.left)
        }
        Verdict::Undecided(why) => writeln!(out, "    undecided   {why}"),
        Verdict::Equal(_) => Ok(()),
    };
    out
}

/// Returns lines about recorded references that are missing, broken, or made from another model text. Python is not
/// run.
pub fn check_references(root: &Path, models: &[String]) -> Vec<String> {
    let mut lines = Vec::new();
    for name in models {
        let path = root.join("models").join(name).join("reference.json");
        let file = format!("models/{name}/reference.json");
        if !path.exists() {
            lines.push(format!("missing  {file}"));
            continue;
        }
        // A model that cannot be read is reported elsewhere.
        let Ok(model) = Source::read(&path.with_file_name("model.toml")) else { continue };
        let reference = match Source::read(&path) {
            Ok(source) => Reference::read(&Source { path: file.clone().into(), ..source }),
            Err(error) => {
                lines.push(format!("broken   {file}: {}", error.list.first().map_or("", |d| &d.message)));
                continue;
            }
        };
        match reference.map(|reference| reference.check_text(&model.text)) {
            Ok(Ok(())) => {}
            Ok(Err(_)) => lines.push(format!("stale    {file}: the file was made from another model text")),
            Err(error) => lines.push(format!("broken   {error}")),
        }
    }
    lines
}
