//! Scenes of random mechanisms: a number is what its name says, whatever is asked for and however it is computed.
//!
//! What the command prints is held against the whole model: Kane's equations as terms, their linear system solved at
//! each state with partial pivoting, integrated by DOP853 at 1e-13; reactions from the Newton–Euler rows, energies from
//! T and V. None of the command's own ways to a number is among these: neither reduction, nor elimination, nor its
//! outputs.
//!
//! `TRIPOS_RANDOM_SCENES=1000` runs that many.

mod gyros;
#[path = "../support/mechanism.rs"]
mod mechanism;
mod whole;

use crate::spoilt::Random;
use gyros::Gyro;
use mechanism::Mechanism;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use whole::Whole;

/// Number of scenes that are compared, unless the environment gives another.
const SCENES: u64 = 80;
/// Bound of |e| / (1 + |exact|). Both runs are at 1e-12 or finer, and half a second of these motions multiplies that by
/// less than a thousand. Reactions and accelerations divide by small masses.
const BOUND: f64 = 2e-8;

/// Result of comparing one scene: kinds of compared quantities, and differences.
struct Compared {
    kinds: Vec<&'static str>,
    differences: Vec<String>,
}

#[test]
fn every_output_of_every_scene_is_that_of_the_whole_model() {
    let count = std::env::var("TRIPOS_RANDOM_SCENES").map_or(SCENES, |text| text.parse().expect("a number"));
    let folder = tempfile::tempdir().unwrap();
    let (mut counts, mut wrong) = (BTreeMap::<&str, usize>::new(), Vec::new());
    for seed in 0..count {
        let place = folder.path().join(seed.to_string());
        std::fs::create_dir(&place).unwrap();
        let Compared { kinds, differences } = compare(&place, seed);
        for kind in kinds {
            *counts.entry(kind).or_default() += 1;
        }
        wrong.extend(differences.into_iter().map(|d| format!("scene {seed}: {d}")));
    }
    eprintln!("compared: {counts:?}");
    assert!(wrong.is_empty(), "{} differences\n{}", wrong.len(), wrong.join("\n"));
    for kind in ["state", "rate", "acceleration", "reaction", "energy", "formula", "event", "domain"] {
        assert!(count < SCENES || counts.get(kind).copied().unwrap_or(0) > 0, "nothing of kind {kind} was compared");
    }
}

/// Runs one random scene and holds each of its numbers against the whole model.
fn compare(place: &Path, seed: u64) -> Compared {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(41));
    let mechanism = Mechanism::new(&mut random);
    let scene = mechanism.scene(&mut random);
    std::fs::write(place.join("model.toml"), mechanism.text()).unwrap();
    std::fs::write(place.join("scene.toml"), scene.text(&mechanism)).unwrap();
    let whole = Whole::new(&place.join("model.toml"), &place.join("scene.toml"));
    let mut arguments = vec!["simulate".to_owned(), "scene.toml".to_owned(), "--json".to_owned()];
    arguments.extend(scene.way.iter().map(|word| (*word).to_owned()));
    let output = Command::new(env!("CARGO_BIN_EXE_tripos")).args(&arguments).current_dir(place).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let context = || format!("{}\n{}\n{arguments:?}\n{said}", mechanism.text(), scene.text(&mechanism));
    let mut differences = Vec::new();
    let Ok(json) = serde_json::from_slice::<Value>(&output.stdout) else {
        return Compared { kinds: Vec::new(), differences: vec![format!("no answer\n{}", context())] };
    };
    // A method that these equations do not have is refused, which is an answer too; these are asked for only where they
    // are.
    let t = json["t"].as_f64().expect("an end");
    let (expected, noise) = (whole.ends_at(scene.stops_in_domain), whole.event_is_noise());
    if !noise && (t - expected).abs() > BOUND * (1.0 + expected.abs()) {
        differences.push(format!("ends at {t}, not {expected}\n{}", context()));
    }
    let right = whole.outputs(t);
    let mut kinds = Vec::new();
    for (wanted, value) in scene.outputs.iter().zip(right) {
        kinds.push(wanted.kind);
        let found = json["state"][&wanted.name].as_f64();
        if !found.is_some_and(|found| (found - value).abs() <= BOUND * (1.0 + value.abs())) {
            differences.push(format!("{} is {found:?}, not {value}\n{}", wanted.name, context()));
        }
    }
    let times = |kind: &str| -> Vec<f64> {
        let events = json["events"].as_array().expect("events").iter();
        // A function that is zero at the start has not crossed.
        let crossed = events.filter(|e| e["kind"] != "atstart");
        crossed
            .filter(|e| e["name"].as_str().is_some_and(|n| n.starts_with(kind)))
            .filter_map(|e| e["t"].as_f64())
            .collect()
    };
    let events = [("noticed", "event", whole.crossings(t, 0)), ("inside", "domain", whole.crossings(t, 1))];
    for (name, kind, right) in events.into_iter().skip(usize::from(noise)) {
        let found = times(name);
        kinds.extend(right.iter().map(|_| kind));
        let near = found.len() == right.len() && found.iter().zip(&right).all(|(a, b)| (a - b).abs() < 1e-6);
        if !near {
            differences.push(format!("{name} at {found:?}, not {right:?}\n{}", context()));
        }
    }
    Compared { kinds, differences }
}

/// Number of gyros that are run, unless the environment gives another.
const GYROS: u64 = 60;
/// |e| / (1 + |exact|) of a run at 1e-11 against one whose slopes of M are differences.
const GYRO_BOUND: f64 = 1e-7;

/// Goal: a default run never fails, and gives the motion of the mechanism. Method: tops, gyros and planar mechanisms
/// with every kind of speeds and of equal moments, against Lagrange's equations made of rotation matrices here.
#[test]
fn every_top_and_gyro_runs_by_default_as_it_moves() {
    let count = std::env::var("TRIPOS_RANDOM_SCENES").map_or(GYROS, |text| text.parse().expect("a number"));
    let folder = tempfile::tempdir().unwrap();
    let (mut wrong, mut own, mut all) = (Vec::new(), 0, 0);
    for seed in 0..count {
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(77));
        let Some(gyro) = Gyro::new(&mut random) else { continue };
        let place = folder.path().join(seed.to_string());
        std::fs::create_dir(&place).unwrap();
        std::fs::write(place.join("model.toml"), gyro.model()).unwrap();
        std::fs::write(place.join("scene.toml"), gyro.scene()).unwrap();
        let arguments = ["simulate", "scene.toml", "--json"];
        let output = Command::new(env!("CARGO_BIN_EXE_tripos")).args(arguments).current_dir(&place).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let context = || format!("{}\n{}\n{said}", gyro.model(), gyro.scene());
        let json = serde_json::from_slice::<Value>(&output.stdout).unwrap_or_default();
        all += 1;
        own += usize::from(json["formulation"] == "reduced");
        for (name, right) in gyro.right() {
            let found = json["state"][&name].as_f64();
            if !found.is_some_and(|found| (found - right).abs() <= GYRO_BOUND * (1.0 + right.abs())) {
                wrong.push(format!("gyro {seed}: {name} is {found:?}, not {right}\n{}", context()));
            }
        }
        if !output.status.success() {
            wrong.push(format!("gyro {seed}: {:?}\n{}", output.status, context()));
        }
    }
    eprintln!("{own} of {all} by equations of their own");
    assert!(wrong.is_empty(), "{} differences\n{}", wrong.len(), wrong.join("\n"));
    assert!(count < GYROS || (own > 20 && all > 40), "{own} of {all} by equations of their own");
}
