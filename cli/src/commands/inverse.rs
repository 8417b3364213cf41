//! Command `tripos inverse`: computes the generalized forces that a motion needs, and the inputs that produce them.

use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, print, print_json, warn};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::studies::inverse::{InverseDynamics, RequiredForces, motion_samples};
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_derive::scene::{Motion, MotionForm, MotionSample, load_motion, load_samples};
use tripos_traits::DoubleDouble;

/// Format of printed results: text, CSV or JSON.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// The result is printed as text for people.
    Text,
    /// The result is printed as a CSV table.
    Csv,
    /// The result is printed as JSON for programs.
    Json,
}

impl Shape {
    /// Selects the format from the flags `--json` and `--csv`, of which at most one is true. Without a flag it is text.
    pub fn of(json: bool, csv: bool) -> Self {
        match (json, csv) {
            (true, _) => Self::Json,
            (_, true) => Self::Csv,
            _ => Self::Text,
        }
    }
}

/// Gap of a loop, in the unit of its constraint, above which a warning says that the loop is open.
const LARGEST_LOOP_GAP: f64 = 1e-6;

/// Reads a motion from a file. A TOML file is read by [`load_motion`]. A file with the extension `.csv` is a table of
/// samples, for the default parameter values of the model.
///
/// # Errors
/// `Failure` if the file has errors, or if a parameter has no default value for a table of samples.
pub fn read_motion(path: &Path, model: &mut Mechanism) -> Result<Motion, Failure> {
    let source = Source::read(path)?;
    if !path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv")) {
        return Ok(load_motion(&source, model)?);
    }
    let mut parameters = Vec::new();
    for parameter in &model.parameters {
        parameters.push(match &parameter.value {
            Some(value) => DoubleDouble::from_rational(value),
            None if parameter.is_input => 0.0.into(),
            None => {
                let message = format!("the parameter `{}` has no value", parameter.name);
                let help = "give it a default in the model file";
                let list = vec![Diagnostic::of_file(message, help)];
                return Err(Diagnostics::new(model.source.clone(), list).into());
            }
        });
    }
    Ok(Motion { parameters, given: MotionForm::Samples(load_samples(&source, model)?) })
}

/// Returns a table as CSV text. `heads` are the column names.
pub fn table(heads: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut out = heads.join(",") + "\n";
    for row in rows {
        out.push_str(&row.join(","));
        out.push('\n');
    }
    out
}

/// Runs `tripos inverse`: computes and prints the generalized forces that a motion needs. Returns the exit status,
/// which is 1 if the chosen inputs cannot produce them.
///
/// # Errors
/// `Failure` if a file has errors, an input is unknown, or the forces cannot be computed.
pub fn inverse(model: &Path, motion: &Path, inputs: &[String], shape: Shape) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let motion = read_motion(motion, &mut model)?;
    let inverse = InverseDynamics::new(&model, inputs)?;
    let mut list: Vec<(MotionSample, RequiredForces)> = Vec::new();
    for moving in motion_samples(&model, &motion)? {
        let forces = inverse.required_forces_at(&motion.parameters, &moving)?;
        list.push((moving, forces));
    }
    let open = list.iter().fold(0.0, |most: f64, (_, forces)| most.max(forces.open));
    if open > LARGEST_LOOP_GAP {
        warn(&format!(
            "a loop is open by up to {} in this motion: the forces are not those of a closed mechanism",
            with_significant_digits(open, 2)
        ));
    }
    match shape {
        Shape::Json => print_json(&json_of(&model, &inverse, &list))?,
        Shape::Csv => print(&csv_of(&model, &inverse, &list))?,
        Shape::Text => print(&text_of(&model, &inverse, &list))?,
    }
    let is_left = !inverse.inputs.is_empty() && list.iter().any(|(_, forces)| forces.inputs.is_none());
    Ok(u8::from(is_left))
}

/// Returns named numbers as a JSON object.
fn inverse_numbers_json(names: &[String], values: &[f64]) -> Map<String, Value> {
    names.iter().cloned().zip(values.iter().map(|x| json!(x))).collect()
}

/// Returns the required generalized force along each speed, rounded to `f64`.
fn force_values(forces: &RequiredForces) -> Vec<f64> {
    forces.along.iter().map(|x| x.hi()).collect()
}

/// Returns the names and values of coordinates, speeds and their rates at an instant.
fn state_of(model: &Mechanism, moving: &MotionSample) -> Vec<(String, f64)> {
    let q = model.coordinates.iter().map(|c| c.name.clone()).zip(&moving.q);
    let u = model.speeds.iter().map(|s| s.name.clone()).zip(&moving.u);
    let rates = model.speeds.iter().map(|s| format!("{}'", s.name)).zip(&moving.rates);
    q.chain(u).chain(rates).map(|(name, x)| (name, x.hi())).collect()
}

/// Returns the required forces and inputs at all instants as JSON.
fn json_of(model: &Mechanism, inverse: &InverseDynamics, list: &[(MotionSample, RequiredForces)]) -> Value {
    let one = |(moving, forces): &(MotionSample, RequiredForces)| {
        let (names, values): (Vec<String>, Vec<f64>) = state_of(model, moving).into_iter().unzip();
        json!({
            "t": moving.t,
            "at": inverse_numbers_json(&names, &values),
            "forces": inverse_numbers_json(&inverse.speeds, &force_values(forces)),
            "inputs": forces.inputs.as_ref().map(|inputs| inverse_numbers_json(&inverse.inputs, inputs)),
            "left": inverse_numbers_json(&inverse.speeds, &forces.left),
            "reached": forces.reached,
            "loops_open": forces.open,
        })
    };
    json!({
        "model": short_name(model),
        "speeds": inverse.speeds,
        "inputs": inverse.inputs,
        "motion": list.iter().map(one).collect::<Vec<_>>(),
    })
}

/// Returns the result as CSV, with a row for each instant. The columns are t if known, the state, `force(u)` along each
/// speed u, and the inputs. Fields of inputs are empty if no inputs produce the forces.
fn csv_of(model: &Mechanism, inverse: &InverseDynamics, list: &[(MotionSample, RequiredForces)]) -> String {
    let has_instants = list.iter().all(|(moving, _)| moving.t.is_some()) && model.time().is_none();
    let names = list.first().map_or(Vec::new(), |(moving, _)| state_of(model, moving));
    let names_of_forces = inverse.speeds.iter().map(|speed| format!("force({speed})"));
    let instant = has_instants.then(|| "t".to_owned());
    let heads: Vec<String> = instant
        .into_iter()
        .chain(names.into_iter().map(|(name, _)| name))
        .chain(names_of_forces)
        .chain(inverse.inputs.iter().cloned())
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let row = |(moving, forces): &(MotionSample, RequiredForces)| {
        let number = |x: &f64| format!("{x:?}");
        let inputs: Vec<String> = match &forces.inputs {
            Some(inputs) => inputs.iter().map(number).collect(),
            None => vec![String::new(); inverse.inputs.len()],
        };
        let t = moving.t.filter(|_| has_instants).map(|t| number(&t));
        let state = state_of(model, moving).into_iter().map(|(_, x)| number(&x));
        t.into_iter().chain(state).chain(force_values(forces).iter().map(number)).chain(inputs).collect()
    };
    table(&heads, list.iter().map(row))
}

/// Returns the result as text: all numbers if there is one instant, otherwise the largest values.
fn text_of(model: &Mechanism, inverse: &InverseDynamics, list: &[(MotionSample, RequiredForces)]) -> String {
    let mut out = format!("{}: what its motion needs\n", model.title);
    match list {
        [(_, forces)] => {
            out.push_str("\nM u' - f, what must act beside the loads, along each speed\n");
            let mut lines = |names: &[String], values: &[f64]| {
                names.iter().zip(values).for_each(|(name, x)| {
                    let _ = writeln!(out, "  {name}: {x:?}");
                });
            };
            lines(&inverse.speeds, &force_values(forces));
            if let Some(inputs) = &forces.inputs {
                let _ = writeln!(out, "\ninputs{}", surplus_inputs_remark(inverse, forces));
                let mut lines = |names: &[String], values: &[f64]| {
                    names.iter().zip(values).for_each(|(name, x)| {
                        let _ = writeln!(out, "  {name} = {x:?}");
                    });
                };
                lines(&inverse.inputs, inputs);
            }
        }
        _ => {
            let first = list.first().and_then(|(moving, _)| moving.t);
            let last = list.last().and_then(|(moving, _)| moving.t);
            let span = first.zip(last).map_or_else(String::new, |(a, b)| format!(", t from {a} s to {b} s"));
            let _ = writeln!(out, "\n{} instants{span}; --csv and --json print them all\n", list.len());
            let mut peaks = |name: &str, value: &dyn Fn(&RequiredForces) -> Option<f64>| {
                let values = list.iter().filter_map(|(moving, forces)| Some((moving.t, value(forces)?)));
                if let Some((t, x)) = values.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())) {
                    let when = t.map_or_else(String::new, |t| format!(" at t = {} s", with_reliable_digits(t, None)));
                    let _ = writeln!(out, "  {name}: most {x:?}{when}");
                }
            };
            for (at, speed) in inverse.speeds.iter().enumerate() {
                peaks(&format!("force along {speed}"), &|forces| Some(forces.along[at].hi()));
            }
            for (at, input) in inverse.inputs.iter().enumerate() {
                peaks(input, &|forces| Some(forces.inputs.as_ref()?[at]));
            }
        }
    }
    let _ = write!(out, "{}", unreachable_motion_sentence(inverse, list));
    out
}

/// Returns a remark if there are more inputs than needed, else an empty text.
fn surplus_inputs_remark(inverse: &InverseDynamics, forces: &RequiredForces) -> String {
    let more = inverse.inputs.len() - forces.reached;
    if more == 0 { String::new() } else { format!(", the least of those that give the same ({more} may be chosen)") }
}

/// Returns a sentence that says why the inputs do not produce the motion. Empty if they do.
fn unreachable_motion_sentence(inverse: &InverseDynamics, list: &[(MotionSample, RequiredForces)]) -> String {
    if inverse.inputs.is_empty() {
        return "\nthe model has no inputs; --input NAME asks for parameters that loads are linear in\n".to_owned();
    }
    let missed: Vec<&(MotionSample, RequiredForces)> =
        list.iter().filter(|(_, forces)| forces.inputs.is_none()).collect();
    let worst = missed.iter().flat_map(|(moving, forces)| {
        inverse.speeds.iter().zip(&forces.left).map(|(speed, left)| (moving.t, speed, *left, forces.reached))
    });
    let Some((t, speed, left, reached)) = worst.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs())) else {
        return String::new();
    };
    let when = t.map_or_else(String::new, |t| format!(" at t = {} s", with_reliable_digits(t, None)));
    format!(
        "\nno inputs give this motion{when}: they reach {reached} of {} dimensions, and leave {left:?} along {speed} at best\n",
        inverse.speeds.len()
    )
}
