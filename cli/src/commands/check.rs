//! `tripos check`: what there is to know of a model before its equations are used.

use crate::failure::{Failure, print, print_json};
use crate::words::shortened;
use crate::workspace::{read_model, short_name};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos_derive::check::{Check, Checked, ConstraintKind, check as check_model};

/// Checks a model.
pub fn check(model: &Path, as_json: bool) -> Result<u8, Failure> {
    let model = read_model(model)?;
    let found = check_model(&model).map_err(|error| model.diagnose(&error))?;
    if as_json {
        print_json(&json_of(&model, &found))?;
    } else {
        print(&text_of(&model, &found))?;
    }
    Ok(0)
}

fn word(kind: ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Configuration => "configuration",
        ConstraintKind::Motion => "motion",
    }
}

fn json_of(model: &Mechanism, found: &Check) -> Value {
    let constraint = |c: &Checked| {
        json!({
            "name": c.name, "kind": word(c.kind), "integrable": c.integrable, "integral": c.integral, "redundant": c.redundant,
        })
    };
    json!({
        "model": short_name(model),
        "coordinates": found.coordinates,
        "speeds": found.speeds,
        "constraints": found.constraints.iter().map(constraint).collect::<Vec<_>>(),
        "degrees_of_freedom": found.degrees_of_freedom,
        "configuration_freedom": found.configuration_freedom,
        "singular_where": found.singular_where,
        "notes": found.notes,
    })
}

fn text_of(model: &Mechanism, found: &Check) -> String {
    let mut out = format!("{}\n{}\n\n", model.title, model.count());
    let freedom = found.configuration_freedom.map_or_else(|| "not decided".to_owned(), |n| n.to_string());
    let _ = writeln!(out, "degrees of freedom in velocity: {}", found.degrees_of_freedom);
    let _ = writeln!(out, "freedom of configuration, what motions can reach: {freedom}");
    if !found.constraints.is_empty() {
        out += "\nConstraints\n";
    }
    for constraint in &found.constraints {
        let what = match (constraint.redundant, constraint.integrable) {
            (true, _) => "follows from the others".to_owned(),
            (_, None) => "whether it is integrable was not decided".to_owned(),
            (_, Some(false)) => "not integrable: it restricts velocities alone".to_owned(),
            (_, Some(true)) => match (&constraint.integral, constraint.kind) {
                (None, _) => "integrable".to_owned(),
                (Some(e), ConstraintKind::Configuration) => format!("{} is 0", shortened(e)),
                (Some(e), ConstraintKind::Motion) => format!("integrable: {} is constant", shortened(e)),
            },
        };
        let _ = writeln!(out, "  {} ({}): {what}", constraint.name, word(constraint.kind));
    }
    if !found.singular_where.is_empty() {
        let _ = writeln!(
            out,
            "\nThe speeds do not determine the motion where one of these is 0: {}",
            found.singular_where.iter().map(|e| shortened(e)).collect::<Vec<_>>().join(", ")
        );
    }
    if !found.notes.is_empty() {
        out.push('\n');
    }
    for note in &found.notes {
        let _ = writeln!(out, "note: {note}");
    }
    out
}
