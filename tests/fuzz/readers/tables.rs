//! Tables and values: CSV files of measurements, of motions and of inputs, axes of sweeps, values of `--set`, and
//! reference files in JSON.

use super::files::{checked, scenes};
use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::grammar::formula;
use crate::mutation::spoilt;
use crate::refusal::{check_errors, check_text};
use crate::seeds::{Seed, files_with, quoted_text};
use std::fmt::Write as _;
use tripos_derive::algebra::text::notation::Notation;
use tripos_derive::diagnostic::Source;
use tripos_derive::reference::Reference;
use tripos_derive::scene::{Grid, MeasuredTable, load, load_output, load_samples, load_scene_with_inputs};

/// Text of a CSV table with the given names, before changes.
fn table_text(names: &[&str], random: &mut Random) -> String {
    let mut text = names.join(",") + "\n";
    let mut t = 0.0;
    for _ in 0..random.below(8) {
        text += &t.to_string();
        t += random.decimal(0.0, 0.6);
        for _ in 1..names.len() {
            let _ = write!(text, ",{}", random.decimal(-3.0, 3.0));
        }
        text += "\n";
    }
    text
}

/// A table with changes, mostly small ones.
fn spoilt_table(text: String, random: &mut Random) -> String {
    match random.below(4) {
        0 => text,
        _ => spoilt(&text, quoted_text(random), random),
    }
}

#[test]
fn tables_of_measurements() {
    let seeds = files_with(&["csv"]);
    let share = Share { short: 3000, long: 80_000 };
    campaign("CSV of `fit --data`", &share, move |random| {
        let seed = random.one(&seeds);
        let text = if random.chance(50) {
            seed.text.split_inclusive('\n').take(2 + random.below(6)).collect()
        } else {
            table_text(&["t", "q1", "u1", "F"], random)
        };
        let text = spoilt_table(text, random);
        tried(&text);
        let source = Source::from_text("data.csv", &text);
        let table = match MeasuredTable::read(&source) {
            Ok(table) => table,
            Err(errors) => {
                check_errors(&errors, &|_| false);
                return Answer::Refused;
            }
        };
        let named = table.column(["q1", "u1", "F", "nothing"][random.below(4)]);
        checked(table.instants().and(named))
    });
}

#[test]
fn tables_of_motions() {
    let share = Share { short: 1500, long: 40_000 };
    campaign("CSV of motions", &share, |random| {
        let model = &random.one(scenes()).model;
        let mut names = vec!["t"];
        names.extend(model.coordinates.iter().map(|c| c.name.as_str()));
        names.extend(model.speeds.iter().map(|u| u.name.as_str()));
        let rates: Vec<String> = model.speeds.iter().map(|u| format!("{}'", u.name)).collect();
        names.extend(rates.iter().map(String::as_str));
        let text = spoilt_table(table_text(&names, random), random);
        tried(&text);
        checked(load_samples(&Source::from_text("motion.csv", &text), model))
    });
}

/// Model with an input that a table can drive.
const DRIVEN: &str = r#"
name = "Slider"
parameters.m = { unit = "kg", value = 1, positive = true }
inputs.F = { unit = "N" }
coordinates.x = { unit = "m" }
speeds.u = "x'"
inertial = { frame = "A", origin = "O" }
points.P = { from = "O", frame = "A", position = ["x", 0, 0] }
particles.slider = { point = "P", mass = "m" }
[forces.drive]
on = "slider"
at = "P"
frame = "A"
vector = ["F", 0, 0]
"#;

#[test]
fn tables_of_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let model = tripos_derive::model::load(&Source::from_text("model.toml", DRIVEN)).unwrap_or_else(|e| panic!("{e}"));
    let share = Share { short: 800, long: 25_000 };
    campaign("CSV of inputs", &share, move |random| {
        let text = spoilt_table(table_text(&["t", "F"], random), random);
        tried(&text);
        std::fs::write(folder.path().join("drive.csv"), &text).unwrap();
        let how = *random.one(&["linear", "cubic", "hold", "step"]);
        let scene = format!(
            "model = \"model.toml\"\nspan = [0, 0.5]\n[start]\nx = 0\nu = 0\n[inputs]\nF = {{ table = \"drive.csv\", \
             time = \"t\", column = \"F\", interpolation = \"{how}\" }}\n"
        );
        let source = Source { path: folder.path().join("scene.toml"), text: scene };
        checked(load_scene_with_inputs(&source, &mut model.clone()))
    });
}

#[test]
fn axes_and_values() {
    let share = Share { short: 1500, long: 40_000 };
    campaign("values of `--over` and `--set`", &share, |random| {
        let owned = random.one(scenes());
        let mut model = owned.model.clone();
        let source = Source { path: owned.seed.path.clone(), text: owned.seed.text.clone() };
        let Ok(scene) = load(&source, &mut model) else { return Answer::Read };
        let name = random.one(&model.parameters).name.clone();
        let value = |random: &mut Random| formula(Notation::Tripos, 2, random);
        let text = match random.below(4) {
            0 => format!("{name}={}", value(random)),
            1 => format!("{name}={},{}", value(random), value(random)),
            2 => format!("{name}={}:{}:{}", value(random), value(random), random.below(9)),
            _ => format!("{name}=1..2 in {} log", random.below(9)),
        };
        let text = if random.chance(60) { spoilt(&text, quoted_text(random), random) } else { text };
        tried(&text);
        if random.chance(20) {
            return checked(load_output(&text, &mut model));
        }
        match Grid::read(&[text], "--over", &scene, &mut model) {
            Ok(_) => Answer::Read,
            Err(errors) => {
                for errors in &errors {
                    check_errors(errors, &|_| false);
                }
                Answer::Refused
            }
        }
    });
}

#[test]
fn references_in_json() {
    let seeds: Vec<Seed> = files_with(&["json"]);
    let share = Share { short: 800, long: 20_000 };
    campaign("JSON of references", &share, move |random| {
        let other = random.one(&seeds);
        let text = spoilt(&random.one(&seeds).text, &other.text, random);
        tried(&text);
        match Reference::read(&Source::from_text("reference.json", &text)) {
            Ok(_) => Answer::Read,
            Err(error) => {
                check_text("message", &error.to_string(), &text);
                Answer::Refused
            }
        }
    });
}
