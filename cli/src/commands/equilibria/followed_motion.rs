//! Output for a steady motion that is followed along one number, or over two numbers.

use super::super::linearise::eigenvalue_text;
use super::range::Range;
use super::{equilibria_figure, point_of};
use crate::files::workspace::short_name;
use crate::terminal::failure::{Failure, Output, print, print_json, print_to_stderr};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::studies::steady::{
    Continuation, ContinuationMap, ContinuationPoint, CrossingKind, StabilityCrossing, continuation_map,
    continue_steady_motion,
};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::load_state_with_unknowns;

/// Follows a steady motion along the values of a number, prints stability and eigenvalues, and
/// draws them if `out` is given. Returns the exit status.
///
/// # Errors
/// [`Failure`] if there is no steady motion at the first value, or if the figure cannot be written.
pub fn follow_along_number(
    model: &mut Mechanism,
    source: &Source,
    range: &Range,
    out: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let of_model = model.clone();
    let mut asked_at = |value: f64| Ok(load_state_with_unknowns(source, model, &[(range.name.clone(), value)])?);
    let course = continue_steady_motion(&of_model, &mut asked_at, &range.values)?;
    if output == Output::Json {
        let mut value = json_of(&course);
        value["model"] = json!(short_name(model));
        value["over"] = json!(range.name);
        print_json(&value)?;
    } else {
        print(&followed_course_text(model, &range.name, &course))?;
    }
    out.map_or(Ok(()), |out| equilibria_figure::draw_eigenvalues(out, &range.name, &course))?;
    Ok(0)
}

/// Follows a steady motion along one number, for each value of a second number. Prints the map of stability changes,
/// and draws it if `out` is given. Returns the exit status.
///
/// # Errors
/// [`Failure`] if there is no steady motion for any value, or if the figure cannot be written.
pub fn map_over_two_numbers(
    model: &mut Mechanism,
    source: &Source,
    [first, second]: [&Range; 2],
    out: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let of_model = model.clone();
    let mut asked_at = |one: f64, two: f64| {
        Ok(load_state_with_unknowns(source, model, &[(first.name.clone(), one), (second.name.clone(), two)])?)
    };
    let found = continuation_map(&of_model, &mut asked_at, &first.values, &second.values)?;
    let names = [first.name.as_str(), second.name.as_str()];
    if output == Output::Json {
        let row = |(value, course): &(f64, _)| match course {
            Ok(course) => {
                let mut row = json_of(course);
                row["value"] = json!(value);
                row
            }
            Err(error) => json!({ "value": value, "none": tripos::Error::first_line(error) }),
        };
        let rows: Vec<Value> = found.rows.iter().map(row).collect();
        print_json(&json!({ "model": short_name(model), "over": names, "rows": rows }))?;
    } else {
        print(&followed_motion_map_text(model, names, &found))?;
    }
    out.map_or(Ok(()), |out| equilibria_figure::draw_stability_map(out, names, &found))?;
    Ok(0)
}

/// Returns a followed motion as JSON: points with their eigenvalues, and crossings of the imaginary axis.
fn json_of(course: &Continuation) -> Value {
    let point = |point: &ContinuationPoint| {
        let mut value = point_of(&point.about);
        value["value"] = json!(point.value);
        value
    };
    let crossing = |c: &StabilityCrossing| json!({ "kind": c.kind.name(), "value": c.value, "frequency": c.frequency });
    json!({
        "points": course.points.iter().map(point).collect::<Vec<_>>(),
        "crossings": course.crossings.iter().map(crossing).collect::<Vec<_>>(),
        "ended": course.ended,
    })
}

/// Returns a followed motion as text, with a line for each value of the number `name`.
fn followed_course_text(model: &Mechanism, name: &str, course: &Continuation) -> String {
    let mut out = format!("{}, over {name}\n\n", model.title);
    for point in &course.points {
        let list = point.about.modes.iter().filter(|mode| mode.value[1] >= 0.0);
        let list: Vec<String> = list.map(|mode| eigenvalue_text(mode, 9)).collect();
        let _ = writeln!(out, "{name} = {}: {}; {}", point.value, point.about.stability.name(), list.join(", "));
    }
    if !course.crossings.is_empty() {
        out.push('\n');
    }
    for crossing in &course.crossings {
        let _ = writeln!(out, "{}", followed_crossing_text(name, crossing));
    }
    if let Some(ended) = &course.ended {
        let _ = writeln!(out, "{ended}");
    }
    out
}

/// Returns a line about a change of stability at a value of the number `name`.
fn followed_crossing_text(name: &str, crossing: &StabilityCrossing) -> String {
    let value = crossing.value;
    match crossing.kind {
        CrossingKind::Real => format!("{name} = {value}: a real eigenvalue passes 0"),
        CrossingKind::Pair => {
            format!("{name} = {value}: a pair passes the imaginary axis at {} rad/s", crossing.frequency)
        }
        CrossingKind::Fold => format!("{name} = {value}: it ends there"),
    }
}

/// Returns the map of stability changes as text, with a line for each value of the second number.
fn followed_motion_map_text(model: &Mechanism, [first, second]: [&str; 2], found: &ContinuationMap) -> String {
    let mut out = format!("{}, over {first} and {second}\n\n", model.title);
    for (value, course) in &found.rows {
        let line = match course {
            Ok(course) if course.crossings.is_empty() => {
                let stability = course.points.first().map_or("not found", |point| point.about.stability.name());
                format!("{stability} for all {first}")
            }
            Ok(course) => course
                .crossings
                .iter()
                .map(|crossing| followed_crossing_text(first, crossing))
                .collect::<Vec<_>>()
                .join("; "),
            Err(error) => {
                print_to_stderr(&format!("note: {second} = {value}: {}", error.first_line()));
                "no steady motion to begin with".to_owned()
            }
        };
        let _ = writeln!(out, "{second} = {value}: {line}");
    }
    out
}
