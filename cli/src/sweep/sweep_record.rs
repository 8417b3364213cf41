//! Record of the settings of an unfinished sweep. It is in the file `FILE.part.json` until the table is complete.
//!
//! Invariant: a sweep is resumed only with the settings with which it was started. The record contains everything that
//! a row depends on: texts of the files, values, points, equations, and integration.

use crate::files::output_files::write_text_file;
use crate::terminal::failure::Failure;
use serde_json::{Map, Value};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use tripos::integration_method_words;
use tripos::studies::sweep::Sweep;
use tripos_derive::Model;
use tripos_derive::model::text_hash;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::publication::hash_publication_of_model;

/// Returns a hash of the formulas that a scene gives to inputs, including those from its tables.
/// Empty without such formulas.
fn sweep_record_input_hash(model: &Model) -> String {
    if model.bindings.is_empty() {
        return String::new();
    }
    let lines: Vec<String> = model.bindings.iter().map(|b| format!("{} = {}\n", b.input, b.formula)).collect();
    text_hash(&lines.concat())
}

/// Record of all settings that determine the rows of a sweep, as pairs (name, value).
pub struct Record(Vec<(&'static str, String)>);

impl Record {
    /// Collects the settings of a sweep. `over` are the varied values as written in the options, and `shard` is the
    /// part of the points.
    pub fn new(sweep: &Sweep<'_>, over: &[String], shard: &str) -> Self {
        let Sweep { model, scene, by, solve, code, tells_digits, .. } = sweep;
        Self(vec![
            ("version of tripos", env!("CARGO_PKG_VERSION").to_owned()),
            ("text of the model", text_hash(&model.source.text)),
            ("text of the scene", text_hash(&scene.source.text)),
            ("signals of the inputs", sweep_record_input_hash(model)),
            ("text of the publication", hash_publication_of_model(&model.source.path)),
            ("values", over.join(" ")),
            ("part of the points", shard.to_owned()),
            ("equations", by.name()),
            ("code", code.name().to_owned()),
            ("accelerations", solve.name().to_owned()),
            ("method", integration_method_words(scene)),
            ("span", format!("{} s to {} s", scene.span.0, scene.span.1)),
            ("column of digits", if *tells_digits { "yes" } else { "no" }.to_owned()),
        ])
    }

    /// Writes the record to its file `PART.json`, where `part` is the unfinished table.
    ///
    /// # Errors
    /// [`Failure`] if the record cannot be written.
    pub fn write(&self, part: &Path) -> Result<(), Failure> {
        let entries: Map<String, Value> =
            self.0.iter().map(|(name, value)| ((*name).to_owned(), value.clone().into())).collect();
        write_text_file(&record_path(part), &format!("{:#}\n", Value::Object(entries)))
    }

    /// Checks that an unfinished table was started with the same settings.
    ///
    /// # Errors
    /// [`Failure::Refused`] with all settings that differ, or if the record is missing.
    pub fn check_same_settings(&self, part: &Path) -> Result<(), Failure> {
        let beside = record_path(part);
        let read = std::fs::read_to_string(&beside).ok().and_then(|text| serde_json::from_str::<Value>(&text).ok());
        let Some(read) = read else {
            let what = format!(
                "the sweep `{}` cannot be resumed: its record `{}` is missing",
                path_as_plain_text(part),
                path_as_plain_text(&beside)
            );
            return Err(Failure::request(what, HELP));
        };
        let differs = |(name, value): &(&str, String)| {
            let begun = read.get(name).and_then(Value::as_str).unwrap_or("nothing");
            (begun != value).then(|| format!("{name}: `{begun}` then, `{value}` now"))
        };
        let differences: Vec<String> = self.0.iter().filter_map(differs).collect();
        if differences.is_empty() {
            return Ok(());
        }
        Err(other_sweep_failure(part, &differences.join("; ")))
    }
}

/// Removes the record of a complete table. A failure is ignored, because a record is only read together with its
/// unfinished table.
pub fn remove_record(part: &Path) {
    // A record without its unfinished table is never read, so that a failure does not matter.
    let _ = std::fs::remove_file(record_path(part));
}

/// Returns the failure for an unfinished table that does not belong to this sweep, with the reason.
pub fn other_sweep_failure(part: &Path, why: &str) -> Failure {
    Failure::request(format!("`{}` was begun by another sweep: {why}", path_as_plain_text(part)), HELP)
}

/// Help for an unfinished table that this sweep cannot continue.
const HELP: &str = "give the options and files that it was begun with, or leave --resume out to start anew";

/// Returns the path of the record: the path of the unfinished table with `.json` appended.
fn record_path(part: &Path) -> PathBuf {
    let mut name = OsString::from(part);
    name.push(".json");
    name.into()
}
