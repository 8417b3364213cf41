//! Command `tripos linearise`: prints the linear system of a mechanism near rest or a steady motion.

mod notations;

use crate::arguments::Notation;
use crate::files::workspace::{read_model, short_name};
use crate::phrases::decimal_text;
use crate::terminal::failure::{Failure, print, print_json};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::studies::steady::{
    LinearisationOptions, Mode, SteadyLinearSystem, SymbolicEntry, SymbolicLinearForm, TransferFunction, WideMatrix,
    linearise as linearise_model, symbolic_linear_system,
};
use tripos::{Error, Mechanism};
use tripos_derive::diagnostic::Source;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{load_output, load_state_with_unknowns};

/// Format in which a linear system is printed.
#[derive(Clone, Copy)]
pub enum LinearSystemFormat {
    /// The linear system is printed as JSON for programs.
    Json,
    /// The linear system is printed as text or as matrices, in this notation.
    Notation(Notation),
}

/// Runs `tripos linearise`: linearises a model about the state of a file, and prints the linear system. `letters` are
/// names of parameters that remain symbols in the matrices. Returns the exit status.
///
/// # Errors
/// `Failure` if a file has errors, an output is listed twice, or the state cannot be linearised.
pub fn linearise(
    model: &Path,
    about: &Path,
    wanted: &LinearisationOptions,
    outputs: &[String],
    letters: &[String],
    written: LinearSystemFormat,
) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    model.model = model.model.reread_with_varied_inputs(&wanted.inputs)?;
    let mut asked = load_state_with_unknowns(&Source::read(about)?, &mut model, &[])?;
    for text in outputs {
        let output = load_output(text, &mut model)?;
        if asked.outputs.iter().any(|known| known.name == output.name) {
            return Err(Error::request(
                format!("the output `{}` is listed twice", output.name),
                "leave one of them out",
            )
            .into());
        }
        asked.outputs.push(output);
    }
    let found = linearise_model(&model, &asked, wanted)?;
    let letters =
        if letters.is_empty() { None } else { Some(symbolic_linear_system(&model, &asked, &found, letters)?) };
    match written {
        LinearSystemFormat::Json => {
            let mut value = json_of(&model, &found);
            if let Some(letters) = &letters {
                value["symbolic"] = symbolic_linearisation_json(letters);
            }
            print_json(&value)?;
        }
        LinearSystemFormat::Notation(Notation::Text) => {
            let letters = letters.as_ref().map_or_else(String::new, |letters| text_of_letters(&found, letters));
            print(&format!("{}{letters}", text_of(&model, &found)))?;
        }
        LinearSystemFormat::Notation(notation) => {
            print(&notations::written(&model, &found, letters.as_ref(), notation))?;
        }
    }
    Ok(0)
}

/// Returns the values of all states of a linearised motion as JSON, by name.
pub fn state_json(found: &SteadyLinearSystem) -> Map<String, Value> {
    found.states().map(|(name, x)| (name.to_owned(), json!(x))).collect()
}

/// Returns the modes of a linear system as JSON, each with its eigenvalue and the states that take
/// part in it.
pub fn linearised_modes_json(found: &SteadyLinearSystem) -> Vec<Value> {
    let shares = |mode: &Mode| -> Map<String, Value> {
        linearised_mode_states(found, mode).into_iter().map(|(n, s)| (n, json!(s))).collect()
    };
    let mode = |mode: &Mode| {
        json!({
            "eigenvalue": mode.value, "condition": mode.condition, "error": mode.error,
            "frequency": mode.value[0].hypot(mode.value[1]), "damping": damping(mode), "shares": shares(mode),
        })
    };
    found.modes.iter().map(mode).collect()
}

/// Returns the damping ratio of a mode, −Re λ/|λ|: 1 for pure decay, 0 for pure oscillation,
/// negative for growth. `None` for the eigenvalue 0.
fn damping(mode: &Mode) -> Option<f64> {
    let size = mode.value[0].hypot(mode.value[1]);
    (size > 0.0).then(|| -mode.value[0] / size)
}

/// Returns the states with a share of more than 0.01 in a mode, with their shares. The largest share is first.
fn linearised_mode_states(found: &SteadyLinearSystem, mode: &Mode) -> Vec<(String, f64)> {
    let names = found.system.kept.iter().map(|at| found.all[*at].clone());
    let mut list: Vec<(String, f64)> =
        names.zip(mode.shares.iter().copied()).filter(|(_, share)| *share > 0.01).collect();
    list.sort_by(|a, b| b.1.total_cmp(&a.1));
    list
}

/// Returns the names of the states with these indices.
fn names(found: &SteadyLinearSystem, places: &[usize]) -> Vec<String> {
    places.iter().map(|at| found.all[*at].clone()).collect()
}

/// Returns the linear system with its modes as JSON.
fn json_of(model: &Mechanism, found: &SteadyLinearSystem) -> Value {
    let system = &found.system;
    let [a, b, c, d] = [&system.a, &system.b, &system.c, &system.d].map(WideMatrix::doubles);
    let eigenvalues: Vec<[f64; 2]> = found.modes.iter().map(|mode| mode.value).collect();
    let transfer = |t: &TransferFunction| {
        json!({
            "input": found.inputs[t.input], "output": found.outputs[t.output],
            "numerator": t.numerator, "denominator": t.denominator,
        })
    };
    json!({
        "model": short_name(model),
        "states": names(found, &system.kept),
        "inputs": found.inputs,
        "outputs": found.outputs,
        "A": a,
        "B": b,
        "C": c,
        "D": d,
        "eigenvalues": eigenvalues,
        "residual": found.steady.residual,
        "stability": found.stability.name(),
        "power_of_t": found.stability.growth_power(),
        "family": found.family,
        "modes": linearised_modes_json(found),
        "controllable": found.controllable,
        "observable": found.observable,
        "transfer_functions": found.transfers.iter().map(transfer).collect::<Vec<_>>(),
        "at": state_json(found),
        "moves": linearised_motion_json(found),
        "closed_by_loops": names(found, &system.closed),
        "shifted_by_symmetries": names(found, &system.shifted),
    })
}

/// Returns the matrices with symbolic parameters as JSON.
fn symbolic_linearisation_json(letters: &SymbolicLinearForm) -> Value {
    let letter = letters.names.first().map_or("", String::as_str);
    let rows = |matrix: &Vec<Vec<SymbolicEntry>>| -> Vec<Vec<String>> {
        matrix.iter().map(|row| row.iter().map(|entry| entry.text(letter)).collect()).collect()
    };
    let [a, b, c, d] = [0, 1, 2, 3].map(|at| rows(&letters.matrices[at]));
    json!({ "letters": letters.names, "A": a, "B": b, "C": c, "D": d })
}

/// Returns the nonzero entries of the matrices A, B, C and D with symbolic parameters as text, one entry per line.
fn text_of_letters(found: &SteadyLinearSystem, letters: &SymbolicLinearForm) -> String {
    let letter = letters.names.first().map_or("", String::as_str);
    let mut out = format!("\nfor every {}, by exact algebra; all other entries are 0\n", letters.names.join(", "));
    let states = names(found, &found.system.kept);
    let rates: Vec<String> = states.iter().map(|name| format!("{name}'")).collect();
    let sides =
        [(&rates, &states), (&rates, &found.inputs), (&found.outputs, &states), (&found.outputs, &found.inputs)];
    for (matrix, (rows, columns)) in letters.matrices.iter().zip(sides) {
        for (row, name) in matrix.iter().zip(rows) {
            for (entry, by) in row.iter().zip(columns) {
                if !entry.is_zero() {
                    let _ = writeln!(out, "  d {name}/d {by} = {}", entry.text(letter));
                }
            }
        }
    }
    out
}

/// Returns, as JSON, the coordinates along which a steady motion proceeds, with their rates.
pub fn linearised_motion_json(found: &SteadyLinearSystem) -> Vec<Value> {
    found.moves.iter().map(|(along, rate)| json!({ "along": along, "rate": rate })).collect()
}

/// Returns words for the kind of the state: at rest, or a steady motion along coordinates.
pub fn motion_kind_words(found: &SteadyLinearSystem) -> String {
    if found.moves.is_empty() {
        return if found.time.is_some() { "at rest beside what is driven" } else { "at rest" }.to_owned();
    }
    let moves: Vec<String> = found.moves.iter().map(|(along, rate)| format!("{along}, rate {rate:.10}")).collect();
    format!("a steady motion along {}", moves.join("; "))
}

/// Returns an eigenvalue, or a complex pair of eigenvalues, as text with `decimals` decimals.
pub fn eigenvalue_text(mode: &Mode, decimals: usize) -> String {
    let [re, im] = mode.value.map(|x| decimal_text(x, decimals));
    if mode.value[1] > 0.0 { format!("{re} ± {im}i") } else { re }
}

/// Returns the eigenvalues as text, each on a line with the states that take part in its mode. The stability follows.
pub fn modes_text(found: &SteadyLinearSystem) -> String {
    let mut out = String::new();
    for mode in found.modes.iter().filter(|mode| mode.value[1] >= 0.0) {
        let value = eigenvalue_text(mode, 12);
        let parts: Vec<String> = linearised_mode_states(found, mode)
            .iter()
            .take(4)
            .map(|(name, share)| format!("{name} {:.0} %", 100.0 * share))
            .collect();
        let doubt = if mode.condition > 1e6 {
            format!(", condition {}", with_significant_digits(mode.condition, 1))
        } else {
            String::new()
        };
        let _ = writeln!(out, "  {value:<34} {}{doubt}", parts.join(", "));
    }
    let _ = writeln!(out, "{}", found.stability.stability_sentence());
    if !found.family.is_empty() {
        let many = if found.family.len() == 1 { "one neutral eigenvalue" } else { "neutral eigenvalues" };
        let _ = writeln!(out, "{many}: there are such motions beside it, told apart by {}", found.family.join(", "));
    }
    out
}

/// Returns the linear system with its modes as text.
fn text_of(model: &Mechanism, found: &SteadyLinearSystem) -> String {
    let system = &found.system;
    let mut out = format!("{}: near {}\n", model.title, motion_kind_words(found));
    let _ = writeln!(
        out,
        "largest residual of the equations of steady motion: {}\n",
        with_significant_digits(found.steady.residual, 2)
    );
    for (name, x) in found.states() {
        let _ = writeln!(out, "  {name} = {x:?}");
    }
    let _ = writeln!(out, "\nstates: {}", names(found, &system.kept).join(", "));
    if !system.closed.is_empty() {
        let _ = writeln!(out, "by the loops: {}", names(found, &system.closed).join(", "));
    }
    if !system.shifted.is_empty() {
        let _ = writeln!(out, "left out, since symmetries shift them: {}", names(found, &system.shifted).join(", "));
    }
    let titles = [
        "A".to_owned(),
        format!("B: {}", found.inputs.join(", ")),
        format!("C: {}", found.outputs.join(", ")),
        "D".to_owned(),
    ];
    for (wide, title) in [&system.a, &system.b, &system.c, &system.d].into_iter().zip(titles) {
        let rows = wide.doubles();
        if rows.iter().all(Vec::is_empty) {
            continue;
        }
        let _ = writeln!(out, "\n{title}");
        for row in rows {
            let row: Vec<String> = row.iter().map(|x| format!("{:>16}", decimal_text(*x, 9))).collect();
            let _ = writeln!(out, "{}", row.join(" "));
        }
    }
    let _ = write!(out, "\neigenvalues, 1/s\n{}", modes_text(found));
    let n = system.kept.len();
    if !found.inputs.is_empty() {
        let _ = writeln!(out, "the inputs reach {} of {n} dimensions", found.controllable);
    }
    if !found.outputs.is_empty() {
        let _ = writeln!(out, "the outputs show {} of {n} dimensions", found.observable);
    }
    for transfer in &found.transfers {
        let polynomial = |list: &[f64]| list.iter().map(|c| decimal_text(*c, 9)).collect::<Vec<_>>().join(", ");
        let _ = writeln!(
            out,
            "{} / {} = [{}] / [{}] by falling powers of s",
            found.outputs[transfer.output],
            found.inputs[transfer.input],
            polynomial(&transfer.numerator),
            polynomial(&transfer.denominator)
        );
    }
    out
}
