//! Option `tripos simulate --gradient`: derivatives of one number at the end of a run with respect to all parameters
//! and start values.

use super::sensitivity::sensitivity_unit_suffix;
use super::{as_json, as_text, report_run};
use crate::arguments::Simulate;
use crate::terminal::failure::{Failure, print, print_json};
use crate::terminal::interruption;
use serde_json::{Value, json};
use std::fmt::Write;
use tripos::studies::sensitivity::gradient::Slope;
use tripos::{EquationsName, Gradient, Mechanism, gradient};
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_derive::scene::Scene;

/// Runs a scene. Prints its end, and the derivatives of the number `of` at the end with respect to all parameters and
/// start values. Returns the exit status.
///
/// # Errors
/// `Failure` if options cannot be combined, if the scene cannot be run, or if the output cannot be printed.
pub fn simulate_gradient(
    request: &Simulate,
    model: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    of: &str,
    by: Option<&EquationsName>,
) -> Result<u8, Failure> {
    check_gradient_options(request)?;
    interruption::listen_for_interruption();
    interruption::show_progress_bar(scene.span);
    let found = gradient(model, scene, set, of, by)?;
    interruption::hide_progress_bar();
    let status = report_run(request, &found.run, found.missing());
    if request.json {
        let mut whole = as_json(model, &found.scene, &found.run);
        add_gradient_json(&mut whole, &found);
        print_json(&whole)?;
    } else {
        print(&(as_text(model, &found.scene, &found.run) + &gradient_text(&found)))?;
    }
    Ok(status)
}

/// Refuses options that cannot be combined with `--gradient`.
/// `Err` is the refusal.
fn check_gradient_options(request: &Simulate) -> Result<(), Failure> {
    let refuse = |what: &str, help: &str| Err(Failure::request(what.to_owned(), help.to_owned()));
    if !request.sensitivity.is_empty() {
        let help = "give one of the two: --gradient differentiates one value with respect to all numbers, --sensitivity all shown values with respect to one";
        return refuse("--gradient and --sensitivity are two runs", help);
    }
    if request.csv.is_some() {
        let help = "leave --csv out, or give --sensitivity, whose derivatives are known at each sample";
        return refuse("a gradient belongs to the end of a run, and --csv writes samples along the run", help);
    }
    Ok(())
}

/// Adds the gradient to the JSON of a run.
fn add_gradient_json(whole: &mut Value, of: &Gradient) {
    let Value::Object(whole) = whole else { return };
    let slope = |slope: &Slope| json!({ "name": slope.by, "value": slope.value, "error": slope.error, "unit": slope.unit, "missing": slope.missing });
    whole.insert("gradient_of".to_owned(), json!(of.of));
    whole.insert("gradient".to_owned(), of.slopes.iter().map(slope).collect());
    whole.insert("gradient_is_total".to_owned(), json!(of.is_total));
    whole.insert("gradient_assessed_by".to_owned(), json!(of.assessed_by));
}

/// Returns the gradient as text, one derivative per line.
fn gradient_text(of: &Gradient) -> String {
    let what = if of.is_total { "in all, as that instant moves" } else { "at that instant" };
    let mut out =
        format!("\ngradient of {} at t = {} s, {what}\n", of.of, with_reliable_digits(of.run.solution.t_end, None));
    let width = of.slopes.iter().map(|slope| slope.by.chars().count()).max().unwrap_or(0);
    for slope in &of.slopes {
        let by = &slope.by;
        if !slope.value.is_finite() {
            let why = slope.missing.as_ref().map_or_else(String::new, |why| format!(": {why}"));
            let _ = writeln!(out, "  by {by:width$}  no value{why}");
            continue;
        }
        let error = slope.error.map_or_else(String::new, |error| format!(" ± {}", with_significant_digits(error, 1)));
        let unit = sensitivity_unit_suffix(slope.unit.as_ref());
        let _ = writeln!(out, "  by {by:width$}  {}{error}{unit}", slope.value);
    }
    let _ = match &of.assessed_by {
        Some(words) => writeln!(out, "errors of the derivatives, by comparison with {words}"),
        None => writeln!(out, "the errors of the derivatives are not known: no second run came to the same end"),
    };
    out
}
