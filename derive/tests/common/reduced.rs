//! Reductions of models and scenes that tests state as text.

#![allow(dead_code, reason = "each test file uses a part")]

use std::fmt::Write;
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::model;
use tripos_derive::reduce::{Omission, ReducedQuantity, Reduction, reduce};
use tripos_derive::scene::{self, Scene};

/// A model of the library, and one of its scenes with these outputs: `["q2", "u1"]`; its own without.
pub fn library(model: &str, scene: &str, outputs: &str) -> Reduction {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model);
    let mut model = Model::read(&folder.join("model.toml")).unwrap();
    let source = Source::read(&folder.join(format!("scenes/{scene}.toml"))).unwrap();
    let stated = if outputs.is_empty() { source.text } else { format!("outputs = {outputs}\n{}", source.text) };
    let scene = scene_of(&mut model, &stated);
    reduce(&model, &scene).unwrap_or_else(|e| panic!("{e}"))
}

/// A scene of a model.
pub fn scene_of(model: &mut Model, text: &str) -> Scene {
    scene::load(&Source::from_text("scene.toml", text), model).unwrap_or_else(|e| panic!("{e}"))
}

/// The reduction of a model for a scene with this text, and a start.
pub fn reduced(model: &str, scene: &str) -> Reduction {
    let mut model = model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let scene = with_start(&model, scene);
    let scene = scene_of(&mut model, &scene);
    reduce(&model, &scene).unwrap_or_else(|e| panic!("{e}"))
}

/// A scene's text, keys before tables, with a span and a start.
pub fn with_start(model: &Model, scene: &str) -> String {
    let (keys, tables) = scene.split_once("\n[").unwrap_or((scene, ""));
    let mut text = format!("span = [0, 1]\n{keys}\n[start]\n");
    for name in model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name)) {
        let _ = writeln!(text, "{name} = 0.25");
    }
    match tables {
        "" => text,
        tables => format!("{text}[{tables}"),
    }
}

/// The names of quantities.
pub fn names(list: &[ReducedQuantity]) -> Vec<&str> {
    list.iter().map(|q| q.name.as_str()).collect()
}

/// Names of the states, then of the quadratures.
pub fn integrated(r: &Reduction) -> (Vec<&str>, Vec<&str>) {
    (names(&r.states), names(&r.quadratures))
}

/// Value of an output in the reduced system, as text.
pub fn output(r: &Reduction, name: &str) -> String {
    let output = r.outputs.iter().find(|o| o.name == name).unwrap_or_else(|| panic!("no output {name}"));
    print_text(r.arena(), output.value)
}

/// A reduced system as people read it.
pub fn show(r: &Reduction) -> String {
    let (a, e, mut out) = (r.arena(), &r.derivation.equations, String::new());
    for (kind, list) in [("states", &r.states), ("quadratures", &r.quadratures)] {
        if !list.is_empty() {
            let _ = writeln!(out, "{kind}: {}", names(list).join(", "));
        }
    }
    for q in &r.constants {
        let _ = writeln!(out, "{} [{}] = {}", q.name, q.unit, print_text(a, q.of_start));
    }
    for d in &e.definitions {
        let _ = writeln!(out, "{} = {}", print_text(a, d.symbol), print_text(a, d.value));
    }
    for (q, rate) in e.coordinates.iter().zip(&e.coordinate_rates) {
        let _ = writeln!(out, "{}' = {}", print_text(a, *q), print_text(a, *rate));
    }
    for (i, (row, f)) in e.matrix.iter().zip(&e.forcing).enumerate() {
        let entries = row.iter().zip(&e.unknowns).filter(|(m, _)| print_text(a, **m) != "0");
        let factor = |m: &str| if m == "1" { String::new() } else { format!("({m})*") };
        let terms: Vec<String> =
            entries.map(|(m, x)| format!("{}{}", factor(&print_text(a, *m)), print_text(a, *x))).collect();
        let _ = writeln!(out, "{} = {}", terms.join(" + "), print_text(a, *f));
        assert!(i < e.variables.len());
    }
    for o in &r.outputs {
        let value = print_text(a, o.value);
        if value != o.name {
            let _ = writeln!(out, "{} -> {value}", o.name);
        }
    }
    for c in &r.model.domain {
        let _ = writeln!(out, "{} while {} > 0", c.name, print_text(a, c.positive));
    }
    let energy = if r.has_energy { "known" } else { "unknown" };
    let divisors: Vec<String> = r.divisors.iter().map(|d| print_text(a, *d)).collect();
    let by = if divisors.is_empty() { "nothing".to_owned() } else { divisors.join("; ") };
    let _ = writeln!(out, "energy {energy}; divided by: {by}");
    // Long equations are for machines.
    let short =
        |line: &str| line.char_indices().nth(240).map_or(line.to_owned(), |(at, _)| format!("{}…", &line[..at]));
    out.lines().map(|line| short(line) + "\n").collect()
}

/// Every omission on a line.
pub fn ledger(r: &Reduction) -> String {
    let line = |o: &Omission| format!("{} | {} | {}\n", o.what.text(r.arena()), o.why.text(r.arena()), o.proof);
    r.omitted.iter().map(line).collect()
}
