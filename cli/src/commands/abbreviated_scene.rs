//! Command `tripos scene --within`: prints abbreviated equations of a scene, the terms that they leave out, and the
//! measured differences of the shown quantities.

use super::scene::equation_lines;
use crate::files::scene_file::SceneWithSetValues;
use crate::files::workspace::short_name;
use crate::terminal::failure::{Failure, Output, print, print_json};
use serde_json::{Value, json};
use std::fmt::Write;
use tripos::Mechanism;
use tripos::studies::abbreviation::{Abbreviation, abbreviate};
use tripos_derive::diagnostic::shortened_for_message;
use tripos_derive::plain_text::with_reliable_digits;

/// Number of terms in the text; the JSON lists all of them.
const LISTED: usize = 40;

/// Runs `tripos scene --within`: abbreviates the equations of a scene, and prints them. `within` is the largest
/// allowed change of a shown quantity, as a part of its largest size. Returns the exit status.
///
/// # Errors
/// `Failure` if the equations cannot be abbreviated, or the output cannot be printed.
pub fn abbreviated_scene(
    SceneWithSetValues { model, scene, .. }: &SceneWithSetValues,
    within: f64,
    output: Output,
) -> Result<u8, Failure> {
    let abbreviation = abbreviate(model, scene, within)?;
    if output == Output::Json {
        print_json(&abbreviation_json(model, &scene.title, within, &abbreviation))?;
    } else {
        print(&abbreviation_text(model, &scene.title, scene.span.0, within, &abbreviation))?;
    }
    Ok(0)
}

/// Returns the abbreviated equations and their differences as JSON.
fn abbreviation_json(model: &Mechanism, title: &str, within: f64, found: &Abbreviation) -> Value {
    let cost = |cost: tripos_codegen::plan::OperationCount| json!({ "operations": cost.operations, "divisions": cost.divisions, "sines_and_cosines": cost.sincos });
    let dropped = found.dropped.iter().map(|d| json!({ "term": d.term, "sum": d.sum, "effect": d.effect }));
    let differences = found
        .differences
        .iter()
        .map(|d| json!({ "name": d.name, "largest": d.largest, "scale": d.scale, "relative": d.relative() }));
    json!({
        "model": short_name(model),
        "title": title,
        "by": found.by.name(),
        "within": within,
        "terms": found.terms,
        "left_out": dropped.collect::<Vec<_>>(),
        "differences": differences.collect::<Vec<_>>(),
        "cost": { "whole": cost(found.whole_cost), "abbreviated": cost(found.cost) },
        "runs": found.runs,
        "complete": found.is_complete,
        "end": found.end,
        "constants": found.constants.iter().map(|(name, value)| json!({ "name": name, "value": value })).collect::<Vec<_>>(),
        "equations": equation_lines(&found.derivation),
    })
}

/// Returns the abbreviated equations and their differences as text.
fn abbreviation_text(model: &Mechanism, title: &str, start: f64, within: f64, found: &Abbreviation) -> String {
    let mut out = format!("{}: {}\n", model.title, if title.is_empty() { "a scene" } else { title });
    let number = |x: f64| with_reliable_digits(x, None);
    let _ = writeln!(
        out,
        "\nabbreviated equations ({}), within {within:e}: {} of {} terms are left out",
        found.by.title(),
        found.dropped.len(),
        found.terms
    );
    let _ = writeln!(
        out,
        "mass matrix and forcing: {} operations of {}, divisions {} of {}, sines and cosines {} of {}",
        found.cost.operations,
        found.whole_cost.operations,
        found.cost.divisions,
        found.whole_cost.divisions,
        found.cost.sincos,
        found.whole_cost.sincos
    );
    let _ = writeln!(
        out,
        "measured in this scene from t = {} s to {} s by {} runs: with other starts, parameters or spans, differences may be larger",
        number(start),
        number(found.end),
        found.runs
    );
    if !found.is_complete {
        let _ =
            writeln!(out, "the search ended after {} runs: more terms may be left out within the bound", found.runs);
    }
    let _ = writeln!(out, "\nlargest differences from the whole equations");
    for d in &found.differences {
        let _ =
            writeln!(out, "  {}: {:.2e}, {:.2e} of its largest size {:.3e}", d.name, d.largest, d.relative(), d.scale);
    }
    let _ = writeln!(out, "\nequations");
    for (name, value) in &found.constants {
        let _ = writeln!(out, "  constant {name} = {value:?}");
    }
    for line in equation_lines(&found.derivation) {
        let _ = writeln!(out, "  {line}");
    }
    let _ = writeln!(
        out,
        "\nleft out; each number is the largest change of an acceleration by this term alone, as a part of its largest size, or \"at rest\" if that is zero"
    );
    for d in found.dropped.iter().take(LISTED) {
        let effect = if d.effect.is_finite() { format!("{:.1e}", d.effect) } else { "at rest".to_owned() };
        let _ = writeln!(out, "  {effect}  {}  in  {}", d.term, shortened_for_message(&d.sum));
    }
    if found.dropped.len() > LISTED {
        let _ = writeln!(out, "  and {} terms with smaller changes", found.dropped.len() - LISTED);
    }
    out
}
