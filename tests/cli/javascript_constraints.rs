//! Mechanisms with loops in JavaScript: poses that close them, and runs that are kept on them.

use crate::javascript::{answers, has_node, moved, numbers};
use crate::support::root;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tripos::{Overrides, Scene};
use tripos_codegen::js::emit::emit_javascript_modules;
use tripos_derive::{Formulation, Model};
use tripos_models::MODELS;

/// A model and a scene of it, with its modules.
struct Linkage {
    name: &'static str,
    model: Model,
    scene: Scene,
    modules: PathBuf,
}

/// The library's models that have loops, each with its first scene.
fn linkages(folder: &Path) -> Vec<Linkage> {
    let mut list = Vec::new();
    for model in MODELS {
        let place = root().join("models").join(model.name);
        let text = Model::read(&place.join("model.toml")).unwrap();
        if text.loops.is_empty() {
            continue;
        }
        let scenes = std::fs::read_dir(place.join("scenes")).unwrap();
        let mut paths: Vec<PathBuf> = scenes.map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        let scene = paths.iter().find_map(|path| Scene::read(path).ok()).unwrap().with_compiled_equations(MODELS);
        let modules = emitted(&text, &folder.join(model.name));
        list.push(Linkage { name: model.name, model: text, scene, modules });
    }
    list
}

fn emitted(model: &Model, folder: &Path) -> PathBuf {
    std::fs::create_dir(folder).unwrap();
    for (file, text) in emit_javascript_modules(model, &[Formulation::Kane, Formulation::Lagrange]).unwrap().files {
        std::fs::write(folder.join(file), text).unwrap();
    }
    folder.to_owned()
}

/// Goal: a linkage runs in JavaScript as it does in Rust, and stays closed. Method: a scene of every library model with
/// loops, by Kane's method in independent speeds and by Lagrange's equations in all rates, at 1e-12 for at most a
/// second, against compiled equations. Outputs agree to 1e-9 of their size; residuals at the end are zero to rounding.
#[test]
fn linkages_run_as_in_rust_and_stay_closed() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (mut asked, mut expected) = (Vec::new(), Vec::new());
    for linkage in &linkages(folder.path()) {
        let start = linkage.scene.description();
        let until = start.span.1.min(start.span.0 + 1.0);
        for by in ["kane", "lagrange"] {
            let how = Overrides {
                by: Some(by.into()),
                method: Some(tripos::Method::Dop853.into()),
                rtol: Some(1e-12),
                atol: Some(1e-12),
                until: Some(until),
                ..Overrides::default()
            };
            let run = linkage.scene.simulate(&how).unwrap();
            asked.push(json!({ "module": linkage.modules.join(format!("{by}.mjs")), "run": {
                "p": start.parameters, "q": start.q, "u": start.u, "span": [start.span.0, until], "rtol": 1e-12, "atol": 1e-12
            } }));
            expected.push((linkage.name, by, run));
        }
    }
    assert!(expected.len() >= 18, "{} runs", expected.len());
    for ((name, by, run), answer) in expected.iter().zip(answers(&asked)) {
        assert_eq!(answer["stop"]["kind"], "end", "{name} by {by}: {answer}");
        // Coordinates and speeds, then what a scene shows beside them.
        let shown = numbers(&answer["shown"]);
        let scale = run.end.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        let apart = run.end.iter().zip(&shown).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(
            run.end.len() >= shown.len() && !shown.is_empty() && apart < 1e-9 * scale,
            "{name} by {by}: {apart:e} {:?} {shown:?}",
            run.end
        );
        let open = numbers(&answer["open"]);
        let worst = open.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(!open.is_empty() && worst < 1e-13 * scale, "{name} by {by}: open by {worst:e}");
    }
}

/// Goal: poses are closed as in Rust, and an open start is refused. Method: dependent coordinates of each library
/// linkage's first scene, displaced by a few hundredths and found again, to 1e-11; the displaced start does not run.
/// Where the scene states all coordinates, the pose found from a displaced one is closed and near.
#[test]
fn poses_that_close_are_found_and_others_are_refused() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let linkages = linkages(folder.path());
    let mut asked = Vec::new();
    for linkage in &linkages {
        let start = linkage.scene.description();
        let closes = |name: &str| start.closed.iter().any(|closed| closed.name == name);
        let free =
            linkage.model.coordinates.iter().enumerate().filter(|(_, c)| start.closed.is_empty() || closes(&c.name));
        let free: Vec<usize> = free.map(|(at, _)| at).collect();
        let shifted = moved(&start.q, 3, 0.06);
        let q: Vec<f64> =
            (0..start.q.len()).map(|at| if free.contains(&at) { shifted[at] } else { start.q[at] }).collect();
        let module = linkage.modules.join("kane.mjs");
        asked.push(json!({ "module": module, "assemble": { "p": start.parameters, "q": q, "free": free } }));
        asked.push(json!({ "module": module, "run": { "p": start.parameters, "q": q, "u": start.u, "span": [0, 1] } }));
    }
    for (linkage, found) in linkages.iter().zip(answers(&asked).chunks(2)) {
        let start = linkage.scene.description();
        let q = numbers(&found[0]["q"]);
        let apart = q.iter().zip(&start.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let bound = if start.closed.is_empty() { 0.1 } else { 1e-11 };
        assert!(q.len() == start.q.len() && apart < bound, "{}: {apart:e} {q:?} {:?}", linkage.name, start.q);
        assert!(numbers(&found[0]["open"]).iter().all(|x| x.abs() < 1e-13), "{}: {}", linkage.name, found[0]);
        assert_eq!(found[1]["stop"]["kind"], "open", "{}: {}", linkage.name, found[1]);
    }
}

/// A bead on a circle about the origin. The second constraint is redundant on it as long as k is l, though it would not
/// be anywhere else.
const TWICE: &str = r#"
name = "Bead on a circle"
[parameters]
m = { unit = "kg", value = 1, positive = true }
l = { unit = "m", value = 1, positive = true }
k = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81 }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
v = "x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
bead = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
first = { equation = "x^2 + y^2 = l^2" }
second = { equation = "y*(x^2 + y^2) = y*k^2" }
"#;

/// Goal: a constraint that is redundant only at some numbers is not taken for redundant at others. Method: the bead
/// above with k = l, and with another k: no pose, no run.
#[test]
fn what_a_redundant_constraint_forbids_is_refused() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bead.toml");
    std::fs::write(&file, TWICE).unwrap();
    let module = emitted(&Model::read(&file).unwrap(), &folder.path().join("bead")).join("kane.mjs");
    let ask = |k: f64| {
        let p = [1.0, 1.0, k, 9.81];
        let assemble = json!({ "p": p, "q": [0.6, -0.7], "free": [1] });
        let run = json!({ "p": p, "q": [0.6, -0.8], "u": [0], "span": [0, 1] });
        [json!({ "module": module, "assemble": assemble }), json!({ "module": module, "run": run })]
    };
    let found = answers(&[ask(1.0), ask(1.1)].concat());
    let q = numbers(&found[0]["q"]);
    assert!((q[0] - 0.6).abs() < 1e-15 && (q[1] + 0.8).abs() < 1e-14, "{q:?}");
    assert_eq!(found[1]["stop"]["kind"], "end", "{}", found[1]);
    assert_eq!((&found[2]["q"], &found[3]["stop"]["kind"]), (&Value::Null, &json!("open")), "{found:?}");
}
