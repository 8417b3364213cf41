//! The library as a program uses it.

mod abbreviations;
mod closed_sliders;
mod conditions;
mod contacts_apart;
mod dead_points;
mod driven;
mod energy;
mod excitations;
mod fits;
mod flights;
mod frames;
mod friction;
mod given_potentials;
mod gradient;
mod impacts;
mod inverse;
mod newton;
mod planar;
#[path = "../../tests/support/random.rs"]
mod random;
mod random_trees;
mod reactions;
mod rigorous;
mod rough;
mod saltation;
mod sampled;
mod sensitivity;
mod shared;
mod sketch;
mod spectra;
mod steady;
mod steady_kinds;
mod steady_loops;
mod stiff;
mod told_motions;
mod touching;
#[path = "../../tests/support/tree.rs"]
mod tree;
mod view;
mod watched;

use tripos::{Error, Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_traits::Real;

const BOUNCER: &str = r#"
name = "Mass on a spring"
[parameters]
m = { unit = "kg", value = 2, positive = true }
k = { unit = "N/m", value = 8, positive = true }
[coordinates]
x = { unit = "m" }
[speeds]
v = "x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
b = { point = "P", mass = "m" }
[forces.spring]
on = "b"
frame = "N"
vector = ["-k*x", 0, 0]
"#;

const SWING: &str = r#"
model = "model.toml"
span = [0, 10]
[start]
x = "0.5*m/m"
v = 0
[integration]
method = "dop853"
rtol = 1e-11
atol = 1e-12
[[events]]
name = "centre"
zero = "x"
direction = "falling"
"#;

fn scene() -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", BOUNCER)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), SWING).unwrap_or_else(|e| panic!("{e}"))
}

fn end_of(run: &Run, name: &str) -> f64 {
    *run.column_of_quantity(name).unwrap().last().unwrap()
}

/// Exact solution: x = 0.5 cos(ω t), ω = √(k/m).
#[test]
fn a_scene_from_strings_runs_by_every_kind_of_equations_and_meets_its_events() {
    let scene = scene();
    for by in [None, Some("kane"), Some("lagrange")] {
        let run = scene.simulate(&Overrides { by: by.map(Into::into), ..Overrides::default() }).unwrap();
        assert!((end_of(&run, "x") - 0.5 * 20_f64.cos()).abs() < 1e-9, "{by:?}");
        assert!(run.failure().is_none() && run.warnings.is_empty(), "{by:?}: {:?}", run.objections());
        let instants: Vec<f64> = run.events().iter().map(|event| event.t).collect();
        assert_eq!(instants.len(), 3, "{by:?}: {instants:?}");
        assert!((instants[0] - std::f64::consts::FRAC_PI_4).abs() < 1e-9, "{by:?}: {instants:?}");
    }
    assert!(scene.prove().unwrap().is_equivalent());
}

/// Exact solution: x = 0.5 cos(ω t) with ω = 2, so x(1) = 0.5 cos 2.
#[test]
fn equations_references_and_samples_are_a_call_away() {
    let scene = scene();
    let derivation = scene.mechanism().derive(tripos_derive::Formulation::Kane).unwrap();
    assert_eq!(derivation.equations.matrix.len(), 1);
    assert!(matches!(
        scene.mechanism().derive(tripos_derive::Formulation::NewtonEuler),
        Ok(_) | Err(Error::Unsupported(_))
    ));
    assert_eq!(scene.reduce().unwrap().reduction.derivation.equations.coordinates.len(), 1);
    let reference = scene.reference(&[1.0]).unwrap();
    assert!((reference.end()[0].to_f64() - 0.5 * 2_f64.cos()).abs() < 1e-16 && reference.uncertainty < 1e-16);
    let run = scene.simulate(&Overrides::default()).unwrap();
    let samples: Vec<(f64, &[f64])> = run.samples().collect();
    assert!(samples.len() > 10 && samples.iter().all(|(t, x)| (x[0] - 0.5 * (2.0 * t).cos()).abs() < 1e-9));
}

#[test]
fn what_is_set_stays_set_and_what_cannot_be_is_an_error() {
    let mut scene = scene();
    scene.set_number("k", 32.0).unwrap();
    scene.set_number("x", 0.25).unwrap();
    let run = scene.simulate(&Overrides::default()).unwrap();
    assert!((end_of(&run, "x") - 0.25 * 40_f64.cos()).abs() < 1e-9, "both are set");
    scene.set_number("k", 8.0).unwrap();
    let run = scene.simulate(&Overrides::default()).unwrap();
    assert!((end_of(&run, "x") - 0.25 * 20_f64.cos()).abs() < 1e-9, "the last value counts");

    let refused = scene.set_number("kk", 1.0).unwrap_err();
    assert!(refused.to_string().contains("did you mean `k`?"), "{refused}");
    let refused = scene.set_number("m", -1.0).unwrap_err();
    assert!(matches!(refused, Error::Input(_)), "{refused}");
    let refused = scene.set_number("x", f64::NAN).unwrap_err();
    assert!(refused.to_string().contains("`x` is NaN"), "{refused}");
    let run = scene.simulate(&Overrides::default()).unwrap();
    assert!((end_of(&run, "x") - 0.25 * 20_f64.cos()).abs() < 1e-9, "what was refused changes nothing");

    let refused = run.column_of_quantity("y").unwrap_err();
    assert!(refused.to_string().contains("the run shows no `y`"), "{refused}");
    let refused = Error::from("euler".parse::<tripos::Integrator>().unwrap_err());
    assert!(matches!(refused, Error::Request { .. }), "{refused}");
    assert!(Scene::read("no/such/scene.toml").is_err());
}

#[test]
fn a_follower_ends_a_run_and_gets_what_there_is() {
    use std::ops::ControlFlow;
    let stops = |t: f64| if t >= 2.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let follow = tripos::observer::Observer::new(tripos_sim::Poll::new(stops), || false);
    let run = scene().with_observer(follow).simulate(&Overrides::default()).unwrap();
    assert!(run.solution.stop == tripos_sim::Stop::Interrupted && run.solution.t_end < 3.0, "{}", run.ending);
}

#[test]
fn what_programs_hold_can_be_sent_and_shared() {
    const fn shared<T: Send + Sync + 'static>() {}
    shared::<Scene>();
    shared::<Mechanism>();
    shared::<Run>();
    shared::<Error>();
}

/// Goal: the program of the README is one that compiles and runs. Method: it is the example of the crate, which is a
/// test.
#[test]
fn the_program_of_the_readme_is_the_example_of_the_crate() {
    let readme = include_str!("../../README.md");
    let program = readme
        .split("## As a library\n")
        .nth(1)
        .and_then(|rest| rest.split("```rust\n").nth(1))
        .and_then(|rest| rest.split("```").next())
        .expect("a program");
    let example: Vec<&str> = include_str!("../src/lib.rs")
        .lines()
        .skip_while(|line| *line != "//! ```")
        .skip(1)
        .take_while(|line| !line.starts_with("//! #"))
        .map(|line| line.trim_start_matches("//!").trim_start())
        .collect();
    assert_eq!(program.trim_end(), example.join("\n").replace("../models", "models"));
    assert!(program.lines().count() <= 12);
}
