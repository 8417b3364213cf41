//! Command `tripos diff --find-coordinates`: searches for the coordinates that a publication uses.

use super::{Comparison, CoordinateReport, verdicts};
use crate::files::judged_publication::JudgedPublication;
use crate::files::workspace::model_file;
use crate::terminal::failure::Failure;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{CoordinateSearch, CoordinateTable, find_coordinates};
use tripos_derive::model::is_model;

/// Searches for the coordinates of a publication, and returns the verdicts on the publication in these coordinates. If
/// several choices are equally good, they are listed, and the verdicts use the coordinates that the publication states.
///
/// # Errors
/// `Failure` if the file is a model, if it cannot be read, or if there are no coordinates to search for.
pub fn in_found_coordinates(model: &Mechanism, other: &Path) -> Result<Comparison, Failure> {
    let source = Source::read(&model_file(other))?;
    if is_model(&source) {
        let what = "--find-coordinates is about a publication, and this file is a model";
        return Err(Failure::request(what, "name a publication file, or leave out --find-coordinates"));
    }
    let mut stated = JudgedPublication::new(model, &source)?;
    let search = find_coordinates(&stated.model, &mut stated.derivations, &stated.publication).map_err(|why| {
        let help = "state the coordinates of the publication in [coordinates]";
        Failure::request(format!("the coordinates cannot be searched for: {why}"), help)
    })?;
    let report = CoordinateReport { text: coordinate_search_text(&search), json: coordinate_search_json(&search) };
    let judged = match search.best.as_slice() {
        [table] => JudgedPublication::judge_in_coordinates(model, &source, table)?,
        _ => JudgedPublication::new(model, &source)?,
    };
    Ok(verdicts(judged, Some(report)))
}

/// Returns the result of the search as text.
fn coordinate_search_text(search: &CoordinateSearch) -> String {
    let CoordinateSearch { compared, as_stated, most, best, tried } = search;
    let mut out = format!("{tried} choices of coordinates were tried, in numbers, with {compared} formulas.\n");
    match best.as_slice() {
        [] => {
            let _ = writeln!(
                out,
                "No other choice of coordinates makes more formulas right than the stated one: {as_stated} of {compared}."
            );
        }
        [one] => {
            let _ = writeln!(
                out,
                "{most} of {compared} are right, {as_stated} before, in these coordinates:\n\n{}",
                found_coordinates_table(one)
            );
            out.push_str("The verdicts are proved in these coordinates.\n");
        }
        several => {
            let _ = writeln!(
                out,
                "{most} of {compared} are right, {as_stated} before, in each of {} choices:",
                several.len()
            );
            for one in several {
                let _ = writeln!(out, "\n{}", found_coordinates_table(one));
            }
            out.push_str("None of them is better. The verdicts are those in the coordinates stated.\n");
        }
    }
    out.push('\n');
    out
}

/// Returns the table `[coordinates]` in the form of a publication file.
fn found_coordinates_table(table: &CoordinateTable) -> String {
    let lines = table.iter().map(|(name, formula)| format!("{name} = \"{formula}\"\n"));
    format!("[coordinates]\n{}", lines.collect::<String>())
}

/// Returns the result of the search as JSON.
fn coordinate_search_json(search: &CoordinateSearch) -> Value {
    let table = |table: &CoordinateTable| {
        let pairs = table.iter().map(|(name, formula)| (name.clone(), json!(formula)));
        Value::Object(pairs.collect())
    };
    json!({
        "compared": search.compared,
        "as_stated": search.as_stated,
        "most": search.most,
        "tried": search.tried,
        "best": search.best.iter().map(table).collect::<Vec<_>>(),
    })
}
