//! Inputs that drive loads: numbers, formulas and tables of scenes.
//!
//! Truth: the motions of a linear oscillator under constant, harmonic and piecewise linear forces, in closed form.

use std::path::Path;
use tripos::{Mechanism, Method, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::{Formulation, model};

const MODEL: &str = r#"
name = "driven oscillator"
[parameters]
m = "2 kg"
k = "8 N/m"
c = { unit = "N*s/m", value = 0 }
[inputs]
F = { unit = "N", about = "what pushes" }
G = { unit = "N", value = "c*t" }
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
spring = { on = "cart", frame = "N", vector = ["-k*x - c*v", 0, 0] }
push = { on = "cart", frame = "N", vector = ["F + G", 0, 0] }
"#;

const START: &str =
    "span = [0, 5]\n[start]\nx = 0.1\nv = 0.3\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-13\n";

fn mechanism() -> Mechanism {
    Mechanism::new(model::load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}")))
}

fn scene(rest: &str) -> Result<Scene, String> {
    Scene::parse(mechanism(), &format!("model = \"model.toml\"\n{START}{rest}")).map_err(|e| e.to_string())
}

fn run(scene: &Scene, by: Formulation) -> Run {
    let how = Overrides { by: Some(by.name().into()), ..Overrides::default() };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{}: {e}", by.name()));
    assert!(run.failure().is_none(), "{}: {:?}", by.name(), run.objections());
    run
}

/// x at the samples of a run.
fn held(run: &Run, tolerance: f64, truth: impl Fn(f64) -> f64) {
    let x = run.column_of_quantity("x").unwrap();
    assert!(run.solution.t.len() > 20);
    for (t, x) in run.solution.t.iter().zip(x) {
        assert!((x - truth(*t)).abs() < tolerance, "{t}: {x}, {}", truth(*t));
    }
}

/// x and v after a time under a force that grows along a line, of an oscillator of frequency 2 rad/s and 2 kg.
fn under_a_line([x, v]: [f64; 2], force: f64, growth: f64, time: f64) -> [f64; 2] {
    let (k, w) = (8.0, 2.0);
    // x = (F + F' t)/k + a cos wt + b sin wt.
    let (a, b) = (x - force / k, (v - growth / k) / w);
    let (sin, cos) = (w * time).sin_cos();
    [(force + growth * time) / k + a * cos + b * sin, growth / k + w * (b * cos - a * sin)]
}

#[test]
fn numbers_are_parameters_that_are_inputs() {
    for (input, force) in [
        ("", 0.0),
        ("[inputs]\nF = 3\n", 3.0),
        ("[inputs]\nF = \"0.004 kN\"\n", 4.0),
        ("[inputs]\nF = \"pi\"\nG = 1\n", 1.0 + std::f64::consts::PI),
    ] {
        let scene = scene(input).unwrap();
        for by in Formulation::ALL {
            held(&run(&scene, by), 1e-11, |t| under_a_line([0.1, 0.3], force, 0.0, t)[0]);
        }
    }
    let mut scene = scene("[inputs]\nF = 3\n").unwrap();
    scene.set_number("F", -2.0).unwrap();
    held(&run(&scene, Formulation::Kane), 1e-11, |t| under_a_line([0.1, 0.3], -2.0, 0.0, t)[0]);
}

/// Goal: formulas replace inputs before the equations are derived. Method: a harmonic force; a force that is a damper;
/// by series as well, which need slopes.
#[test]
fn formulas_are_of_time_place_and_speed() {
    let driven = scene("[inputs]\nF = \"6*sin(3*t)\"\n").unwrap();
    // x = A sin 3t + ..., A = F/(k - m 9).
    let a = 6.0 / (8.0 - 18.0);
    let truth = |t: f64| a * (3.0 * t).sin() + 0.1 * (2.0 * t).cos() + (0.3 - 3.0 * a) / 2.0 * (2.0 * t).sin();
    let damped = scene("[inputs]\nF = \"-1.2*v - 10*x + c*t\"\n").unwrap();
    let (decay, w) = (0.3, (9.0_f64 - 0.09).sqrt());
    let fading = |t: f64| (-decay * t).exp() * (0.1 * (w * t).cos() + (0.3 + decay * 0.1) / w * (w * t).sin());
    for by in Formulation::ALL {
        held(&run(&driven, by), 1e-11, truth);
        held(&run(&damped, by), 1e-11, fading);
    }
    let how = Overrides { method: Some(Method::Taylor.into()), ..Overrides::default() };
    held(&driven.simulate(&how).unwrap(), 1e-11, truth);
    assert_ne!(driven.mechanism().model.text_hash(), damped.mechanism().model.text_hash());
    assert_ne!(driven.mechanism().model.text_hash(), mechanism().model.text_hash());
}

/// Goal: an input is no potential of the mechanism, and its work is counted.
#[test]
fn inputs_work() {
    let run = run(&scene("[inputs]\nF = 3\n").unwrap(), Formulation::Kane);
    let gained = |x: f64, v: f64| v * v + 4.0 * x * x;
    let (x, v) = (run.column_of_quantity("x").unwrap(), run.column_of_quantity("v").unwrap());
    let change = gained(*x.last().unwrap(), *v.last().unwrap()) - gained(x[0], v[0]);
    assert!((change - 3.0 * (x.last().unwrap() - x[0])).abs() < 1e-10);
    let ((t0, v0), (t1, v1)) = (run.energies[0], *run.energies.last().unwrap());
    assert!((t1 + v1 - t0 - v0 - change).abs() < 1e-10 && run.energy_drift.expect("balanced").abs() < 1e-9);
}

/// Writes a scene with a table beside it, and reads it.
fn with_table(csv: &str, input: &str) -> Result<Scene, String> {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let write = |path: &Path, text: &str| std::fs::write(path, text).unwrap();
    write(&at("model.toml"), MODEL);
    write(&at("drive.csv"), csv);
    write(&at("scene.toml"), &format!("model = \"model.toml\"\n{START}[inputs]\nF = {input}\n"));
    Scene::read(at("scene.toml")).map_err(|e| e.to_string())
}

const ROWS: [(f64, f64); 6] = [(0.0, 1.0), (0.5, -2.0), (1.3, 4.0), (2.0, 4.0), (3.7, -6.0), (5.0, 0.25)];

#[test]
fn a_table_is_lines_between_its_rows() {
    let csv: String = ROWS.map(|(t, f)| format!("{t}, {f}, 7\n")).concat();
    let scene = with_table(
        &format!("time, force, other\n{csv}"),
        "{ table = \"drive.csv\", time = \"time\", column = \"force\" }",
    )
    .unwrap();
    let truth = |t: f64| {
        let mut state = [0.1, 0.3];
        for pair in ROWS.windows(2) {
            let [(from, force), (to, next)] = [pair[0], pair[1]];
            if t > from {
                state = under_a_line(state, force, (next - force) / (to - from), t.min(to) - from);
            }
        }
        state[0]
    };
    for by in Formulation::ALL {
        held(&run(&scene, by), 1e-11, truth);
    }
}

/// A force that jumps and one that bends, at an instant that parameters give: no step goes across.
#[test]
fn forces_that_jump_in_time() {
    let jump = |t: f64| {
        let [x, v] = under_a_line([0.1, 0.3], -3.0, 0.0, t.min(1.25));
        under_a_line([x, v], 3.0, 0.0, (t - 1.25).max(0.0))[0]
    };
    let bend = |t: f64| {
        let [x, v] = under_a_line([0.1, 0.3], 10.0, -8.0, t.min(1.25));
        under_a_line([x, v], 0.0, 8.0, (t - 1.25).max(0.0))[0]
    };
    for by in Formulation::ALL {
        held(&run(&scene("[inputs]\nF = \"3*sign(k*t - 10)\"\n").unwrap(), by), 1e-11, jump);
        held(&run(&scene("[inputs]\nF = \"m*abs(10 - k*t)/2\"\n").unwrap(), by), 1e-11, bend);
    }
    // A step of the force does work that is counted; it is not taken for a jump of the potential.
    for by in Formulation::ALL {
        let step = run(&scene("[inputs]\nF = \"1 + 2*sign(k*t - 10)\"\n").unwrap(), by);
        assert!(step.objections().is_empty(), "{}: {:?}", by.name(), step.objections());
    }
    let jumps = scene("[inputs]\nF = \"3*sign(k*t - 10)\"\n").unwrap();
    let times: Vec<f64> = (1..=20).map(|k| f64::from(k) / 4.0).collect();
    let reference = jumps.reference(&times).unwrap();
    for (t, state) in times.iter().zip(&reference.states) {
        assert!((state[0].hi() - jump(*t)).abs() < 1e-14, "{t}");
    }
}

/// A cubic is its own spline, so that the table of one and its formula give one motion.
#[test]
fn a_table_is_a_spline_where_that_is_wanted() {
    let csv: String = ROWS.map(|(t, _)| format!("{t},{}\n", 1.0 - 2.0 * t + 0.25 * t * t * t)).concat();
    let table = with_table(&format!("t,F\n{csv}"), "{ table = \"drive.csv\", interpolation = \"cubic\" }").unwrap();
    let formula = scene("[inputs]\nF = \"1 - 2*t + t^3/4\"\n").unwrap();
    let [one, other] = [table, formula].map(|scene| run(&scene, Formulation::Kane));
    for (a, b) in one.end.iter().zip(&other.end) {
        assert!((a - b).abs() < 1e-11, "{:?}, {:?}", one.end, other.end);
    }
}

#[test]
fn inputs_that_cannot_be() {
    let refused = |rest: &str| scene(rest).err().unwrap_or_else(|| panic!("{rest}"));
    for (rest, what) in [
        ("[inputs]\nH = 3\n", "the model has no input `H`"),
        ("[inputs]\nF = \"2*y\"\n", "`y` cannot stand in an input"),
        ("[inputs]\nF = \"2*G\"\n", "`G` cannot stand in an input"),
        ("[inputs]\nF = \"3 m\"\n", "`F` is in N, but this number in m"),
        ("[inputs]\nF = \"1/(x - x)\"\n", "division by zero"),
        (
            "[inputs]\nF = \"1/(sin(x)^2 + cos(x)^2 - 1)\"\n",
            "the model is not possible with these inputs: division by zero",
        ),
        ("[inputs]\nF = []\n", "an input must be a number"),
        ("[parameters]\nF = 3\n", "`F` is an input"),
        ("[inputs]\nF = { table = \"no.csv\" }\n", "the table cannot be read"),
    ] {
        let error = refused(rest);
        assert!(error.contains(what) && error.contains("help"), "{rest}: {error}");
    }
    for (csv, what) in [
        ("t,F\n0,1\n4,2\n", "the table goes from 0 s to 4 s, but the run from 0 s to 5 s"),
        ("t,F\n0,1\n6,2\n6,3\n", "the instants of the table do not increase"),
        ("t,F\n0,1\n6,\n", "row 2 of the table has no number"),
        ("t,F\n0,1\n6,inf\n", "row 2 of the table has no number"),
        ("t,F\n0,1\n6\n", "line 3 of the table: a row has one cell, but the head has 2"),
        ("t,H\n0,1\n6,2\n", "the table has no column `F`"),
        ("t,F\n0,1\n", "the table has 1 rows"),
        ("", "the table has no column"),
    ] {
        let error = with_table(csv, "{ table = \"drive.csv\" }").err().unwrap_or_else(|| panic!("{csv}"));
        assert!(error.contains(what) && error.contains("help"), "{csv}: {error}");
    }
    let load = |text: &str| model::load(&Source::from_text("model.toml", text)).err().map(|e| e.to_string());
    for (from, to, what) in [
        ("mass = \"m\"", "mass = \"F\"", "the input `F` cannot stand in the mass"),
        ("position = [\"x\", 0, 0]", "position = [\"F\", 0, 0]", "the input `F` cannot stand in"),
        ("unit = \"N\", about", "unit = \"m\", about", "`F` is in m but `G` in N"),
        ("value = \"c*t\"", "value = \"F\"", "the input `F` cannot stand in the value of input `G`"),
        ("value = \"c*t\"", "values = 3", "unknown key `values`"),
    ] {
        let error = load(&MODEL.replace(from, to)).unwrap_or_else(|| panic!("{to}"));
        assert!(error.contains(what), "{to}: {error}");
    }
}

/// Goal: a controller in the loop sees the same of compiled and of interpreted equations. Method: the PUMA 560 held by
/// sampled damping of its joints; the two sum in different orders, which half a second of a damped motion does not
/// amplify.
#[test]
fn a_controller_closes_the_loop_of_compiled_and_of_interpreted_equations() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/puma560/scenes/collapse.toml");
    let scene = Scene::read(path).unwrap_or_else(|e| panic!("{e}"));
    let inputs = ["tau1", "tau2", "tau3", "tau4", "tau5", "tau6"];
    let instants: Vec<f64> = (0..50).map(|k| f64::from(k) * 0.01).collect();
    // Feedback sampled at 100 Hz and held stays bounded only if the gain is below the inertia over a sample: the wrist
    // is light.
    let gains = [4.0, 4.0, 4.0, 0.01, 0.01, 0.002];
    let damped = || {
        move |sample: &tripos::ControllerSample<'_>| {
            sample.values[6..12].iter().zip(gains).map(|(u, gain)| -gain * u).collect()
        }
    };
    let how = Overrides { until: Some(0.5), ..Overrides::default() };
    let run =
        |scene: &Scene| scene.simulate_sampled(&inputs, &instants, damped, &how).unwrap_or_else(|e| panic!("{e}"));
    let (interpreted, compiled) = (run(&scene), run(&scene.clone().with_compiled_equations(tripos_models::MODELS)));
    assert_eq!([interpreted.code.name(), compiled.code.name()], ["interpreted", "compiled"]);
    assert_eq!(interpreted.decisions.len(), 50);
    assert!(interpreted.decisions[49].inputs.iter().any(|tau| tau.abs() > 1.0));
    for (a, b) in interpreted.end.iter().zip(&compiled.end) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
}
