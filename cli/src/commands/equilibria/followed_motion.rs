//! Output for a steady motion that is followed along one number, or over two numbers.

use super::super::linearise::value_text;
use super::figure;
use super::point_of;
use super::range::Range;
use crate::failure::{Failure, Output, print, print_json, say};
use crate::workspace::short_name;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::studies::steady::{Course, Crossing, CrossingKind, Map, Point, follow, map};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::load_asked;

/// Follows a steady motion along the values of a number, prints stability and eigenvalues, and
/// draws them if `out` is given. Returns the exit status.
///
/// # Errors
/// [`Failure`] if there is no steady motion at the first value, or if the figure cannot be written.
pub fn along(
    model: &mut Mechanism,
    source: &Source,
    range: &Range,
    out: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let of_model = model.clone();
    let mut asked_at = |value: f64| Ok(load_asked(source, model, &[(range.name.clone(), value)])?);
    let course = follow(&of_model, &mut asked_at, &range.values)?;
    if output == Output::Json {
        let mut value = json_of(&course);
        value["model"] = json!(short_name(model));
        value["over"] = json!(range.name);
        print_json(&value)?;
    } else {
        print(&course_text(model, &range.name, &course))?;
    }
    out.map_or(Ok(()), |out| figure::modes(out, &range.name, &course))?;
    Ok(0)
}

/// Follows a steady motion along one number for each value of a second number. Prints the map of
/// stability changes, and draws it if `out` is given. Returns the exit status.
///
/// # Errors
/// [`Failure`] if there is no steady motion for any value, or if the figure cannot be written.
pub fn over_two(
    model: &mut Mechanism,
    source: &Source,
    [first, second]: [&Range; 2],
    out: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let of_model = model.clone();
    let mut asked_at =
        |one: f64, two: f64| Ok(load_asked(source, model, &[(first.name.clone(), one), (second.name.clone(), two)])?);
    let found = map(&of_model, &mut asked_at, &first.values, &second.values)?;
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
        print(&map_text(model, names, &found))?;
    }
    out.map_or(Ok(()), |out| figure::map(out, names, &found))?;
    Ok(0)
}

/// Returns a followed motion as JSON: points with eigenvalues, and crossings of the imaginary axis.
fn json_of(course: &Course) -> Value {
    let point = |point: &Point| {
        let mut value = point_of(&point.about);
        value["value"] = json!(point.value);
        value
    };
    let crossing = |c: &Crossing| json!({ "kind": c.kind.name(), "value": c.value, "frequency": c.frequency });
    json!({
        "points": course.points.iter().map(point).collect::<Vec<_>>(),
        "crossings": course.crossings.iter().map(crossing).collect::<Vec<_>>(),
        "ended": course.ended,
    })
}

/// Returns a followed motion as text, a line for each value of the number `name`.
fn course_text(model: &Mechanism, name: &str, course: &Course) -> String {
    let mut out = format!("{}, over {name}\n\n", model.title);
    for point in &course.points {
        let list = point.about.modes.iter().filter(|mode| mode.value[1] >= 0.0);
        let list: Vec<String> = list.map(|mode| value_text(mode, 9)).collect();
        let _ = writeln!(out, "{name} = {}: {}; {}", point.value, point.about.stability.name(), list.join(", "));
    }
    if !course.crossings.is_empty() {
        out.push('\n');
    }
    for crossing in &course.crossings {
        let _ = writeln!(out, "{}", crossing_text(name, crossing));
    }
    if let Some(ended) = &course.ended {
        let _ = writeln!(out, "{ended}");
    }
    out
}

/// Returns a line about a change of stability at a value of the number `name`.
fn crossing_text(name: &str, crossing: &Crossing) -> String {
    let value = crossing.value;
    match crossing.kind {
        CrossingKind::Real => format!("{name} = {value}: a real eigenvalue passes 0"),
        CrossingKind::Pair => {
            format!("{name} = {value}: a pair passes the imaginary axis at {} rad/s", crossing.frequency)
        }
        CrossingKind::Fold => format!("{name} = {value}: it ends there"),
    }
}

/// Returns the map of stability changes as text, a line for each value of the second number.
fn map_text(model: &Mechanism, [first, second]: [&str; 2], found: &Map) -> String {
    let mut out = format!("{}, over {first} and {second}\n\n", model.title);
    for (value, course) in &found.rows {
        let line = match course {
            Ok(course) if course.crossings.is_empty() => {
                let stability = course.points.first().map_or("not found", |point| point.about.stability.name());
                format!("{stability} for all {first}")
            }
            Ok(course) => {
                course.crossings.iter().map(|crossing| crossing_text(first, crossing)).collect::<Vec<_>>().join("; ")
            }
            Err(error) => {
                say(&format!("note: {second} = {value}: {}", error.first_line()));
                "no steady motion to begin with".to_owned()
            }
        };
        let _ = writeln!(out, "{second} = {value}: {line}");
    }
    out
}
