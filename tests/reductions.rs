//! Reduced systems of the library's scenes along runs: against the full equations in 32 digits, and against closed
//! forms.

use crate::support;

use std::path::Path;
use support::Random;
use support::exact::{CLOSED_FORMS, exact, start_of};
use support::reduced::Reduced;
use support::stability::Equations;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::reduce::reduce;
use tripos_derive::scene::{self, Scene};
use tripos_traits::{DoubleDouble, Real, Scalar};

type Dd = DoubleDouble;

/// Every model, a scene, and how far it is followed, s.
const RUNS: [(&str, &str, f64); 10] = [
    ("disk", "report-10s", 4.0),
    ("disk", "near-flat", 2.0),
    ("euler_top", "looping", 2.0),
    ("heavy_top", "waking", 1.0),
    ("spherical_pendulum", "narrow", 3.0),
    ("free_body", "tumbling", 4.0),
    ("floating_chain", "folding", 2.0),
    ("cart_pendulum_3", "fall", 1.0),
    ("chaotic_pendulum", "swing", 1.0),
    ("pendulum", "over", 2.0),
];

/// Bound of |e| / (1 + |exact|) of the outputs. DOP853 at 1e-14 leaves the sum of the errors of some hundred steps;
/// accelerations of 100/s² multiply it by ten.
const BOUND: f64 = 1e-11;
/// The disk passes flat by 3.3 mrad at 1.02 s, and the rounding of the start grows with the inverse of that, twice in
/// accelerations.
const NEAR_FLAT: f64 = 3e-10;

/// The model and a scene of it that wants to see this.
fn scene_with(model: &str, scene: &str, outputs: &[String]) -> (Model, Scene) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model);
    let mut model = Model::read(&folder.join("model.toml")).unwrap();
    let text = std::fs::read_to_string(folder.join(format!("scenes/{scene}.toml"))).unwrap();
    let source = Source::from_text("scene.toml", &format!("outputs = {outputs:?}\n{text}"));
    let scene = scene::load(&source, &mut model).unwrap_or_else(|e| panic!("{e}"));
    (model, scene)
}

/// Names that a scene may ask for, with their values t seconds after the start by Kane's full equations in 32 digits.
fn whole(model: &str, scene: &str, t: f64) -> Vec<(String, f64)> {
    let start = start_of(model, scene);
    let state = Equations::new(model, "kane").reference(&start, t, 1e-19);
    let system = support::compiled(model, "kane").extended;
    let (q, u) = state.split_at(start.q.len());
    let mut rates = vec![Dd::int(0); state.len()];
    let (q_dot, u_dot) = rates.split_at_mut(q.len());
    system.derivative(&start.p, q, u, q_dot, u_dot);
    let (kinetic, potential) = (system.kinetic_energy(&start.p, q, u), system.potential_energy(&start.p, q));
    let (read, _) = support::exact::read(model, scene);
    let names: Vec<String> =
        read.coordinates.iter().map(|c| c.name.clone()).chain(read.speeds.iter().map(|s| s.name.clone())).collect();
    let energies =
        [("kinetic_energy", kinetic), ("potential_energy", potential), ("total_energy", kinetic + potential)];
    let primed = names.iter().map(|n| format!("{n}'")).zip(rates);
    let energies = energies.into_iter().map(|(name, e)| (name.to_owned(), e));
    let all = names.iter().cloned().zip(state).chain(primed).chain(energies);
    all.map(|(name, x)| (name, x.to_f64())).collect()
}

/// The largest error of a reduced system that shows some of these.
fn error_of(model: &str, scene: &str, t: f64, wanted: &[(String, f64)]) -> f64 {
    let names: Vec<String> = wanted.iter().map(|(name, _)| name.clone()).collect();
    let (model, scene) = scene_with(model, scene, &names);
    let reduction = reduce(&model, &scene).unwrap();
    let found = Reduced::new(&reduction, &scene, &model).after(t, 1e-14);
    let errors = found.iter().zip(wanted).map(|(x, (_, exact))| (x - exact).abs() / (1.0 + exact.abs()));
    errors.fold(0.0, |worst, e| if e <= worst { worst } else { e })
}

/// One of a list.
fn any<'a, T>(random: &mut Random, list: &'a [T]) -> &'a T {
    let chosen = random.between(0.0, list.len() as f64);
    list.iter().enumerate().find(|(at, _)| chosen < *at as f64 + 1.0).expect("less than their number").1
}

/// Goal: a scene gets the same numbers whatever else it asks for. Method: random outputs, each with a reduced system of
/// its own, in doubles, against the whole system in 32 digits.
#[test]
fn any_outputs_of_any_scene_are_those_of_the_whole_equations() {
    let mut random = Random(29);
    for (model, scene, t) in RUNS {
        let all = whole(model, scene, t);
        for count in [1, 1, 2, 3, 5] {
            let mut wanted: Vec<(String, f64)> = Vec::new();
            for _ in 0..count {
                let pick = any(&mut random, &all);
                if !wanted.contains(pick) {
                    wanted.push(pick.clone());
                }
            }
            let names: Vec<&str> = wanted.iter().map(|(name, _)| name.as_str()).collect();
            let error = error_of(model, scene, t, &wanted);
            let bound = if scene == "report-10s" { NEAR_FLAT } else { BOUND };
            assert!(error < bound, "{model} {scene} {names:?}: {error:e}");
        }
    }
}

/// All coordinates and speeds, at three instants. 1e-12: the tolerance of a step times some hundred steps.
#[test]
fn reduced_systems_move_by_the_closed_forms() {
    for (model, scene) in CLOSED_FORMS {
        let end = support::exact::read(model, scene).1.span.1;
        for part in [0.13, 0.5, 1.0] {
            let wanted = exact(model, scene, end * part).unwrap();
            let error = error_of(model, scene, end * part, &wanted);
            assert!(error < 1e-12, "{model} {scene} at {}: {error:e}", end * part);
        }
    }
}

/// A start as a scene's module gives it, or as runs have it.
struct Start {
    parameters: Vec<f64>,
    q: Vec<f64>,
    u: Vec<f64>,
}

/// The start of a scene's reduced equations as its runs have it, and the start of the whole model.
fn starts(model: &str, scene: &str) -> (Start, Start) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model);
    let mut model = Model::read(&folder.join("model.toml")).unwrap();
    let source = Source::read(&folder.join(format!("scenes/{scene}.toml"))).unwrap();
    let scene = scene::load(&source, &mut model).unwrap();
    let own = tripos::ReducedScene::new(&model, &scene).unwrap().scene;
    let start = |scene: &Scene| Start { parameters: scene.parameters.clone(), q: scene.q.clone(), u: scene.u.clone() };
    (start(&own), start(&scene))
}

/// Both to rounding: runs have 32 digits of the start, the generated function has doubles.
fn agree(name: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{name}");
    for (x, exact) in found.iter().zip(expected) {
        assert!((x - exact).abs() <= 1e-14 * (1.0 + exact.abs()), "{name}: {x}, {exact}");
    }
}

/// Goal: who uses a scene's module needs nothing else. Method: the module's functions from a start to its constants and
/// to its own state, against what runs of the scene begin with.
#[test]
fn generated_constants_of_a_motion_are_those_of_its_runs() {
    macro_rules! check {
        ($($model:ident $module:ident $scene:literal),*) => { $({
            use tripos_models::$model::{Parameters, scenes::$module::{PARAMETERS, constants, start}};
            let (own, whole) = starts(stringify!($model), $scene);
            let p = Parameters::from_slice(&whole.parameters);
            let (q, u) = (whole.q.as_slice().try_into().unwrap(), whole.u.as_slice().try_into().unwrap());
            let found = constants(&p, q, u);
            assert_eq!(found.len(), PARAMETERS.len());
            agree($scene, &found, &own.parameters);
            let (found_q, found_u) = start(&p, q, u);
            agree($scene, &found_q, &own.q);
            agree($scene, &found_u, &own.u);
        })* };
    }
    check!(
        cart_pendulum_3 fall "fall", chaotic_pendulum swing "swing", disk flat_fall "flat-fall", disk lean "lean",
        disk near_flat "near-flat", euler_top cusps "cusps", floating_chain folding "folding", free_body steady "steady",
        free_body tumbling "tumbling", heavy_top looping "looping", pendulum over "over", spherical_pendulum narrow "narrow"
    );
}
