//! Inputs that are held between instants, and controllers in the loop.
//!
//! Truth: sampled-data systems in closed form. Under a held force a linear oscillator turns about k⁻¹F by the angle ω h
//! in its phase plane, for any rule that decides the force (K. J. Åström & B. Wittenmark, *Computer-Controlled
//! Systems*, 3rd edition (1997), § 2.3).

use std::cell::Cell;
use tripos::{ControllerSample, HeldSignal, Integrator, Mechanism, Overrides, SampledRun, Scene};
use tripos_derive::Formulation;
use tripos_derive::diagnostic::Source;

const MODEL: &str = r#"
name = "driven oscillator"
[parameters]
m = "2 kg"
k = "8 N/m"
[inputs]
F = { unit = "N", value = 0.5 }
G = { unit = "N", value = "-k*x/2" }
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
cart = { point = "P", mass = "m" }
[forces]
spring = { on = "cart", frame = "N", vector = ["-k*x/2", 0, 0] }
push = { on = "cart", frame = "N", vector = ["F + G", 0, 0] }
"#;

const SCENE: &str =
    "span = [0, 3]\n[start]\nx = 0.1\nv = 0.3\n[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-12\n";

fn scene(more: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), &format!("{SCENE}{more}")).unwrap_or_else(|e| panic!("{e}"))
}

/// State after `h` seconds under a held force.
fn turned([x, v]: [f64; 2], force: f64, h: f64) -> [f64; 2] {
    let (rest, (sin, cos)) = (force / 8.0, (2.0 * h).sin_cos());
    let away = x - rest;
    [rest + away * cos + v * sin / 2.0, v * cos - 2.0 * away * sin]
}

fn feedback([x, v]: [f64; 2]) -> f64 {
    -3.0 * x - 2.5 * v
}

/// Instants every tenth of a second from 0.05 s on, which are not sums of powers of two.
fn instants() -> Vec<f64> {
    (0..29).map(|k| 0.05 + f64::from(k) * 0.1).collect()
}

/// Exact states at the instants and at the end.
fn exact() -> Vec<[f64; 2]> {
    let (mut y, mut t, mut force) = ([0.1, 0.3], 0.0, 0.5);
    let mut list = Vec::new();
    for instant in instants() {
        y = turned(y, force, instant - t);
        (t, force) = (instant, feedback(y));
        list.push(y);
    }
    list.push(turned(y, force, 3.0 - t));
    list
}

fn controlled(scene: &Scene, how: &Overrides) -> SampledRun {
    let controller = || |sample: &ControllerSample<'_>| vec![feedback([sample.values[0], sample.value("v").unwrap()])];
    scene.simulate_sampled(&["F"], &instants(), controller, how).unwrap_or_else(|e| panic!("{how:?}: {e}"))
}

#[test]
fn a_closed_loop_is_the_sampled_data_system_of_the_textbook_by_every_method() {
    for (method, step, tolerance) in [
        ("ode45", None, 1e-8),
        ("dopri5", None, 1e-8),
        ("dop853", None, 1e-9),
        ("gauss6", None, 1e-8),
        ("taylor", None, 1e-9),
        ("rk4", Some(0.01), 1e-7),
        ("dop853", Some(0.03), 1e-9),
    ] {
        for by in [Formulation::Kane, Formulation::Lagrange] {
            let (method, by) = (Some(method.parse().unwrap()), Some(by.name().into()));
            let run = controlled(&scene(""), &Overrides { method, by, step, ..Overrides::default() });
            let exact = exact();
            assert_eq!(run.decisions.len(), 29);
            for ((decision, instant), truth) in run.decisions.iter().zip(instants()).zip(&exact) {
                assert_eq!(decision.t.to_bits(), instant.to_bits());
                let error = (decision.values[0] - truth[0]).abs().max((decision.values[1] - truth[1]).abs());
                assert!(error < tolerance, "{method:?}: {error:e} at {instant}");
                assert!(run.t.iter().any(|t| t.to_bits() == instant.to_bits()), "a step ends at {instant}");
            }
            assert!((run.end[0] - exact[29][0]).abs() < tolerance, "{method:?}");
            assert!((run.t_end - 3.0).abs() < f64::EPSILON, "{}", run.t_end);
            assert_eq!(run.warnings, Vec::<String>::new(), "{method:?}");
        }
    }
}

/// Goal: the stated errors are given. Method: loose tolerances, against the exact motion.
#[test]
fn told_errors_are_of_the_size_of_true_ones() {
    for (method, rtol) in [("ode45", 1e-3), ("dop853", 1e-3), ("dopri5", 1e-5), ("gauss6", 1e-4)] {
        let how = Overrides {
            method: Some(method.parse().unwrap()),
            rtol: Some(rtol),
            atol: Some(rtol),
            ..Overrides::default()
        };
        let run = controlled(&scene(""), &how);
        let (told, truth) = (run.errors_at_end.clone().unwrap(), exact()[29]);
        for (at, truth) in truth.iter().enumerate() {
            let error = (run.end[at] - truth).abs();
            assert!(error <= 3.0 * told[at], "{method}: {error:e} true, {:e} told", told[at]);
        }
    }
}

#[test]
fn the_same_controller_gives_the_same_bits() {
    let bits = |run: &SampledRun| -> Vec<u64> {
        run.states
            .iter()
            .flatten()
            .chain(&run.t)
            .chain(run.errors_at_end.iter().flatten())
            .map(|x| x.to_bits())
            .collect()
    };
    let (a, b) = (controlled(&scene(""), &Overrides::default()), controlled(&scene(""), &Overrides::default()));
    assert_eq!(bits(&a), bits(&b));
}

/// Goal: a relay sees the errors of its own run. Method: its decisions depend on the sign of a state that is rounding
/// alone. The second run decides differently, and the stated error contains the effect.
#[test]
fn the_second_run_decides_by_itself() {
    let made = Cell::new(0);
    let controller = || {
        made.set(made.get() + 1);
        let which = f64::from(made.get());
        move |_: &ControllerSample<'_>| vec![which]
    };
    let run = scene("").simulate_sampled(&["F"], &[0.0], controller, &Overrides::default()).unwrap();
    assert_eq!(made.get(), 2);
    assert_eq!(run.decisions[0].inputs, [1.0]);
    let apart = (turned([0.1, 0.3], 1.0, 3.0)[0] - turned([0.1, 0.3], 2.0, 3.0)[0]).abs();
    assert!((run.errors_at_end.unwrap()[0] - apart).abs() < 1e-9);
}

/// Goal: outputs are shown, and a controller may use them. Method: an acceleration, whose force is the input before the
/// decision, and an energy; both have closed forms at the exact states.
#[test]
fn a_controller_receives_the_outputs_of_the_scene() {
    let more = "outputs = [\"x\", { name = \"a\", value = \"v'\" }, \"kinetic_energy\"]\n";
    let model = tripos_derive::model::load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::parse(Mechanism::new(model), &format!("{more}{SCENE}")).unwrap_or_else(|e| panic!("{e}"));
    let controller = || {
        |sample: &ControllerSample<'_>| {
            vec![feedback([sample.value("x").unwrap(), sample.value("v").unwrap()]) + 0.0 * sample.value("a").unwrap()]
        }
    };
    let run = scene.simulate_sampled(&["F"], &instants(), controller, &Overrides::default()).unwrap();
    assert_eq!(run.names, ["x", "v", "a", "kinetic_energy"]);
    let mut force = 0.5;
    for (decision, [x, v]) in run.decisions.iter().zip(exact()) {
        assert!((decision.values[2] - (force - 8.0 * x) / 2.0).abs() < 1e-9, "{decision:?}");
        assert!((decision.values[3] - v * v).abs() < 1e-9, "{decision:?}");
        force = feedback([x, v]);
    }
    assert!(run.is_trusted() && run.digits_at_end.unwrap().iter().all(|digits| *digits > 7.0));
    assert_eq!(run.end.len(), 4);

    // An output without a value is an objection.
    let more = "outputs = [\"x\", { name = \"root\", value = \"sqrt(x - 0.05)\" }]\n";
    let model = tripos_derive::model::load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::parse(Mechanism::new(model), &format!("{more}{SCENE}")).unwrap_or_else(|e| panic!("{e}"));
    let run = scene.simulate_sampled(&["F"], &[], controller, &Overrides::default()).unwrap();
    assert!(run.objections().iter().any(|text| text.starts_with("`root` has no value at t = ")), "{:?}", run.warnings);
    assert!(!run.is_trusted());
}

#[test]
fn recorded_signals_are_held_and_the_scene_has_its_value_before_them() {
    let (instants, values) = ([0.7, 1.1, 2.9], [2.0, -1.0, 4.0]);
    let run = scene("")
        .simulate_held(&[HeldSignal { input: "F", instants: &instants, values: &values }], &Overrides::default())
        .unwrap();
    let mut y = turned([0.1, 0.3], 0.5, 0.7);
    for (h, force) in [(0.4, 2.0), (1.8, -1.0), (0.1, 4.0)] {
        y = turned(y, force, h);
    }
    assert!((run.end[0] - y[0]).abs() < 1e-10 && (run.end[1] - y[1]).abs() < 1e-10, "{:?} {y:?}", run.end);
    // The instants are the very start, and the end, after which nothing follows.
    let run = scene("")
        .simulate_held(&[HeldSignal { input: "F", instants: &[0.0, 3.0], values: &[8.0, 9.0] }], &Overrides::default());
    let run = run.unwrap();
    assert!((run.end[0] - turned([0.1, 0.3], 8.0, 3.0)[0]).abs() < 1e-10);
    assert_eq!(run.decisions.len(), 1);
}

#[test]
fn asked_instants_are_shown_once_and_events_are_met() {
    let more = "samples = 31\n[[events]]\nname = \"centre\"\nzero = \"x\"\n";
    let run = controlled(&scene(more), &Overrides::default());
    assert_eq!(run.t.len(), 31);
    assert!(run.t.windows(2).all(|pair| pair[0] < pair[1]));
    let crossings = run.column("x").unwrap().windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
    assert!(crossings > 0);
    assert_eq!(run.events.len(), crossings);
    let run = controlled(&scene(&format!("{more}terminal = true\n")), &Overrides::default());
    assert!(run.errors_at_end.is_some() && run.warnings.is_empty(), "{:?}", run.warnings);
    assert!(run.t_end < 3.0 && run.end[0].abs() < 1e-9, "{} {:?}", run.t_end, run.end);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let scene = scene("");
    let error = |inputs: &[&str], instants: &[f64], value: f64| {
        let run =
            scene.simulate_sampled(inputs, instants, || |_: &ControllerSample<'_>| vec![value], &Overrides::default());
        run.map(|_| ()).unwrap_err().first_line()
    };
    assert_eq!(error(&["f"], &[0.0], 0.0), "the model has no input `f`");
    assert_eq!(error(&["m"], &[0.0], 0.0), "the model has no input `m`");
    assert_eq!(error(&["G"], &[0.0], 0.0), "the input `G` is a formula here");
    assert_eq!(error(&["F", "F"], &[0.0], 0.0), "the input `F` is set twice");
    assert_eq!(error(&["F"], &[1.0, 0.5], 0.0), "the instants do not increase: 1 s comes before 0.5 s");
    assert_eq!(error(&["F"], &[1.0, 1.0], 0.0), "the instants do not increase: 1 s comes before 1 s");
    assert!(error(&["F"], &[1.0, 1.0 + 2.0 * f64::EPSILON], 0.0).ends_with("are too near to each other for a step"));
    assert!(error(&["F"], &[3.0_f64.next_down()], 0.0).ends_with("are too near to each other for a step"));
    assert_eq!(error(&["F"], &[-0.5], 0.0), "the instant -0.5 s is outside the run, from 0 s to 3 s");
    assert_eq!(error(&["F"], &[3.5], 0.0), "the instant 3.5 s is outside the run, from 0 s to 3 s");
    assert_eq!(error(&["F"], &[f64::NAN], 0.0), "the instant NaN s is outside the run, from 0 s to 3 s");
    assert_eq!(error(&["F"], &[0.5], f64::INFINITY), "the value of `F` at t = 0.5 s is inf");
    let none = scene.simulate_sampled(&["F"], &[0.5], || |_: &ControllerSample<'_>| Vec::new(), &Overrides::default());
    assert_eq!(none.unwrap_err().first_line(), "the controller gave 0 values at t = 0.5 s");
    let short = scene.simulate_held(&[HeldSignal { input: "F", instants: &[0.5], values: &[] }], &Overrides::default());
    assert_eq!(short.unwrap_err().first_line(), "`F` has 1 instants and 0 values");
    let back = Overrides { until: Some(-1.0), ..Overrides::default() };
    let back = scene.simulate_sampled(&["F"], &[-0.5], || |_: &ControllerSample<'_>| vec![0.0], &back);
    assert!(back.unwrap_err().first_line().starts_with("inputs need a run forwards in time"));
    let quadrature = Overrides { method: Some(Integrator::Quadrature), ..Overrides::default() };
    let quadrature = scene.simulate_sampled(&["F"], &[0.5], || |_: &ControllerSample<'_>| vec![0.0], &quadrature);
    assert!(quadrature.unwrap_err().first_line().contains("quadrature and projection are not possible"));
}
