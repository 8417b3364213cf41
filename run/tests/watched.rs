//! Events of scenes are all found, in any integration variables.

use tripos::{Integrator, Mechanism, Method, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_sim::Kind;

/// A point that a force pushes along a line, with a speed that is no rate: w = 2 x' + x.
const POINT: &str = r#"
name = "Point on a line"
[parameters]
m = { unit = "kg", value = 1, positive = true }
F = { unit = "N", value = 0 }
L = { unit = "m", value = 1, positive = true }
T = { unit = "s", value = 1, positive = true }
[coordinates]
x = { unit = "m" }
[speeds]
w = "2*x' + x/T"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
b = { point = "P", mass = "m" }
[forces.f]
on = "b"
frame = "N"
vector = ["F", 0, 0]
"#;

fn scene(force: f64, events: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", POINT)).unwrap_or_else(|e| panic!("{e}"));
    let text = format!(
        "model = \"model.toml\"\nspan = [0, 10]\n[parameters]\nF = {force:?}\n[start]\nx = 0\n\"x'\" = {}\n{events}",
        1.0 - force
    );
    Scene::parse(Mechanism::new(model), &text).unwrap_or_else(|e| panic!("{e}"))
}

/// Runs by every kind of equations and every method, in as few steps as possible.
fn runs(scene: &Scene) -> Vec<(String, Run)> {
    let methods = ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5", "taylor"];
    let all = [None, Some("kane"), Some("lagrange")].into_iter().flat_map(|by| methods.map(|method| (by, method)));
    let run = |(by, method): (Option<&str>, &str)| {
        let how = Overrides {
            by: by.map(Into::into),
            method: Some(method.parse().unwrap()),
            step: (method == "rk4").then_some(1.0),
            ..Overrides::default()
        };
        (format!("{by:?} {method}"), scene.simulate(&how).unwrap_or_else(|e| panic!("{by:?} {method}: {e}")))
    };
    all.map(run).collect()
}

/// Truth: x = t. A gate as wide as a sixth of a second is crossed twice in one step, sin 10x 31 times in 10 s.
#[test]
fn a_gate_within_a_step_ends_the_run_and_every_tick_is_heard() {
    let gate = "[[events]]\nname = \"gate\"\nzero = \"exp(-((x/L-3)*10)^2)-0.5\"\nterminal = true\n";
    let tick = "[[events]]\nname = \"tick\"\nzero = \"sin(10*x/L)\"\n";
    let opens = 3.0 - 0.1 * 2_f64.ln().sqrt();
    for (what, run) in runs(&scene(0.0, gate)) {
        assert_eq!(run.solution.stop.code(), "event:gate", "{what}");
        assert!((run.solution.t_end - opens).abs() < 1e-12, "{what}: {}", run.solution.t_end);
    }
    for (what, run) in runs(&scene(0.0, tick)) {
        let ticks: Vec<f64> = run.events().iter().filter(|e| e.kind != Kind::AtStart).map(|e| e.t).collect();
        assert_eq!(ticks.len(), 31, "{what}: {ticks:?}");
        for (n, t) in (1..).zip(&ticks) {
            assert!((t - f64::from(n) * std::f64::consts::PI / 10.0).abs() < 1e-12, "{what}: {ticks:?}");
        }
    }
}

/// Truth: x' = t by a constant force. Gates are in the rate and in the speed, which are functions of the state in other
/// variables.
#[test]
fn rates_and_speeds_are_watched_in_the_variables_that_are_integrated() {
    let gate = |of: &str| format!("[[events]]\nname = \"gate\"\nzero = \"exp(-(({of} - 3*L/T)*T/L*10)^2)-0.5\"\n");
    let far = 0.1 * 2_f64.ln().sqrt();
    // Here x = t²/2, so that w = 2 t + t²/2 is 3 at t = √10 − 2.
    let at_speed = |w: f64| (4.0 + 2.0 * w).sqrt() - 2.0;
    for (of, expected) in [("x'", [3.0 - far, 3.0 + far]), ("w", [at_speed(3.0 - far), at_speed(3.0 + far)])] {
        for (what, run) in runs(&scene(1.0, &gate(of))) {
            let found: Vec<f64> = run.events().iter().map(|e| e.t).collect();
            assert_eq!(found.len(), 2, "{of} {what}: {found:?}");
            assert!(
                found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5),
                "{of} {what}: {found:?} {expected:?}"
            );
        }
    }
}

/// Goal: q2 of the disk is watched, which is integrated as its distance from 90°.
#[test]
fn a_coordinate_is_watched_that_is_integrated_as_a_distance() {
    let model = include_str!("../../models/disk/model.toml");
    let model = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let scene = |distance: &str| {
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 1]\n[start]\nq1 = 0.1\nq2 = 1.2\nq3 = 0\nq4 = 0\nq5 = 0\nu1 = 0.4\nu2 = 0.7\nu3 = 0.2\n\
             u4 = 0\nu5 = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-12\ndomain = \"watch\"\n{distance}\n\
             [[events]]\nname = \"lean\"\nzero = \"sin(40*q2)\"\n"
        );
        Scene::parse(Mechanism::new(model.clone()), &text).unwrap_or_else(|e| panic!("{e}"))
    };
    let how = Overrides { by: Some("kane".into()), ..Overrides::default() };
    let events = |scene: Scene| -> Vec<f64> {
        let run = scene.simulate(&how).unwrap();
        run.events().iter().filter(|e| e.name == "lean").map(|e| e.t).collect()
    };
    let (plain, in_distance) = (events(scene("")), events(scene("distance = { q2 = \"90*deg\" }")));
    assert!(plain.len() > 3, "{plain:?}");
    assert_eq!(plain.len(), in_distance.len(), "{plain:?} {in_distance:?}");
    assert!(plain.iter().zip(&in_distance).all(|(a, b)| (a - b).abs() < 1e-8), "{plain:?} {in_distance:?}");
}

#[test]
fn the_longest_step_bounds_every_step_and_is_said() {
    let scene = scene(0.0, "");
    let how = Overrides { max_step: Some(0.125), method: Some(Method::Dop853.into()), ..Overrides::default() };
    let run = scene.simulate(&how).unwrap();
    assert!(run.solution.steps >= 80, "{}", run.solution.steps);
    let free = scene.simulate(&Overrides { max_step: None, ..how.clone() }).unwrap();
    assert!(free.solution.steps < 40, "{}", free.solution.steps);
    for (how, message) in [
        (Overrides { max_step: Some(0.0), ..how.clone() }, "max-step is 0"),
        (Overrides { max_step: Some(f64::NAN), ..how.clone() }, "max-step is NaN"),
        (Overrides { step: Some(0.1), ..how.clone() }, "where every step has one length, none is longer"),
        (Overrides { method: Some(Integrator::Quadrature), ..how }, "quadrature takes no steps: none is the longest"),
    ] {
        let refused = scene.simulate(&how).err().unwrap();
        assert!(refused.to_string().contains(message), "{refused}");
    }
}
