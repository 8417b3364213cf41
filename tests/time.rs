//! Explicit time: forces that follow a signal, pivots and lengths that are driven, constraints that move.
//!
//! Truth: closed forms, equations written down by hand, and one motion in several descriptions.

use crate::support::Random;
use std::fmt::Write;
use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;
use tripos_sim::{Dynamics, Method, Options, OutputOption, integrate};

fn model(text: &str) -> Result<Model, String> {
    tripos_derive::model::load(&Source::from_text("timed.toml", text)).map_err(|e| e.to_string())
}

fn scene(model_text: &str, start: &str, span: &str, outputs: &str) -> Scene {
    let text = format!(
        "model = \"timed.toml\"\nspan = {span}\n{outputs}[start]\n{start}\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\n\
         atol = 1e-12\n"
    );
    let mechanism = Mechanism::new(model(model_text).unwrap_or_else(|e| panic!("{e}")));
    Scene::parse(mechanism, &text).unwrap_or_else(|e| panic!("{e}"))
}

fn run(scene: &Scene, by: &str, solve: &str, method: &str) -> Run {
    let step = ["gauss6", "radau5"].contains(&method).then_some(1e-3);
    let solve = if by == "reduced" { None } else { Some(solve.parse().unwrap()) };
    let how =
        Overrides { by: Some(by.into()), solve, method: Some(method.parse().unwrap()), step, ..Overrides::default() };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{by}, {method}: {e}"));
    assert!(
        run.failure().is_none() && run.warnings.is_empty(),
        "{by}, {method}: {:?} {:?}",
        run.failure(),
        run.warnings
    );
    run
}

const WAYS: [(&str, &str, &str); 10] = [
    ("newton-euler", "numeric", "dop853"),
    ("kane", "eliminated", "dop853"),
    ("kane", "numeric", "dop853"),
    ("lagrange", "eliminated", "dop853"),
    ("lagrange", "numeric", "dop853"),
    ("lagrange", "eliminated", "taylor"),
    ("kane", "eliminated", "taylor"),
    ("kane", "eliminated", "gauss6"),
    ("kane", "eliminated", "radau5"),
    ("reduced", "", "dop853"),
];

fn end(run: &Run, name: &str) -> f64 {
    *run.column_of_quantity(name).unwrap_or_else(|e| panic!("{e}")).last().unwrap()
}

/// Goal: a force that follows a signal. Method: x'' + 4 x = cos 3t from rest is x = (cos 2t − cos 3t)/5; its work is
/// the change of T + V.
#[test]
fn a_force_follows_a_signal() {
    let text = "name = \"forced\"\n[parameters]\nm = { unit = \"kg\", value = 1, positive = true }\nk = { unit = \"N/m\", \
                value = 4 }\nF = { unit = \"N\", value = 1 }\nw = { unit = \"rad/s\", value = 3 }\n[coordinates]\nx = { unit = \
                \"m\" }\n[speeds]\nu = \"x'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\nP = { from = \"O\", frame = \
                \"N\", position = [\"x\", 0, 0] }\n[particles]\nbob = { point = \"P\", mass = \"m\" }\n[forces.spring]\non = \
                \"bob\"\nat = \"P\"\nframe = \"N\"\nvector = [\"F*cos(w*t) - k*x\", 0, 0]\n";
    let scene = scene(text, "x = 0\nu = 0", "[0, 5]", "");
    let exact = |t: f64| ((2.0 * t).cos() - (3.0 * t).cos()) / 5.0;
    for (by, solve, method) in WAYS {
        let run = run(&scene, by, solve, method);
        for (t, x) in run.solution.t.iter().zip(run.column_of_quantity("x").unwrap()) {
            assert!((x - exact(*t)).abs() < 1e-10, "{by} {method} at {t}: {x}, {}", exact(*t));
        }
        let drift = run.energy_drift.unwrap();
        assert!(drift < 1e-10 && run.solution.work_end.abs() > 0.1, "{by} {method}: {drift:e}");
    }
    // Backward, from where the run ended.
    let back = self::scene(
        text,
        &format!("x = {}\nu = {}", exact(5.0), (3.0 * 15_f64.sin() - 2.0 * 10_f64.sin()) / 5.0),
        "[5, 0]",
        "",
    );
    assert!(end(&run(&back, "kane", "eliminated", "dop853"), "x").abs() < 1e-11);
}

/// A pendulum in a plane with its rope or its pivot driven: [coordinates] and what depends on them.
fn pendulum(what: &str) -> String {
    let parameters =
        [("m", "kg", "1.3"), ("l", "m", "1"), ("g", "m/s^2", "9.81"), ("a", "m", "0.2"), ("w", "rad/s", "5")];
    let mut text = "name = \"driven pendulum\"\n[parameters]\n".to_owned();
    for (name, unit, value) in parameters {
        writeln!(text, "{name} = {{ unit = \"{unit}\", value = {value}, positive = true }}").unwrap();
    }
    text + "[inertial]\nframe = \"N\"\norigin = \"O\"\n[particles]\nbob = { point = \"C\", mass = \"m\" }\n[gravity]\nframe = \
            \"N\"\nacceleration = [0, \"-g\", 0]\n"
        + what
}

const TURNED: &str = "[frames]\nB = { from = \"N\", axis = 3, angle = \"q\" }\n";

/// Models of a rope whose length changes in time. The length is put into a point, prescribed for a coordinate,
/// prescribed as a rate, or stated as a loop in Cartesian coordinates.
fn ropes() -> [(String, String); 4] {
    let angle = "[coordinates]\nq = { unit = \"rad\" }\n";
    let with_length = "[coordinates]\nq = { unit = \"rad\" }\nr = { unit = \"m\" }\n";
    let hung = "[speeds]\nu = \"q'\"\n[points]\nC = { from = \"O\", frame = \"B\", position = [0, \"-r\", 0] }\n[constraints]\n";
    let (length, slope) = (1.0 + 0.2 * f64::sin(2.5), f64::cos(2.5));
    let q = f64::asin(0.3 / length);
    let rate = (0.4 - slope * q.sin()) / (length * q.cos());
    let by_angle = format!("q = {q:?}\nu = {rate:?}");
    [
        (
            format!(
                "{angle}[speeds]\nu = \"q'\"\n{TURNED}[points]\nC = {{ from = \"O\", frame = \"B\", position = [0, \"-l - \
                 a*sin(w*t)\", 0] }}\n"
            ),
            by_angle.clone(),
        ),
        (format!("{with_length}{TURNED}{hung}rope = {{ equation = \"r = l + a*sin(w*t)\" }}\n"), by_angle.clone()),
        (
            format!("{with_length}{TURNED}{hung}rope = {{ equation = \"r' = a*w*cos(w*t)\" }}\n"),
            format!("{by_angle}\nr = {length:?}"),
        ),
        (
            "[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n[speeds]\nu = \"x'\"\n[points]\nC = { from = \"O\", frame \
             = \"N\", position = [\"x\", \"y\", 0] }\n[constraints]\nrope = { equation = \"x^2 + y^2 = (l + a*sin(w*t))^2\" }\n"
                .to_owned(),
            "x = 0.3\nu = 0.4\n[guess]\ny = -1".to_owned(),
        ),
    ]
}

/// Goal: one driven motion in four descriptions. Method: each by each way against r q'' + 2 r' q' + g sin q = 0,
/// written by hand and integrated apart.
#[test]
fn a_rope_of_prescribed_length_swings_alike_in_every_description() {
    let by_hand = |t: f64, y: &[f64], out: &mut [f64]| {
        let (r, r_dot) = (1.0 + 0.2 * (5.0 * t).sin(), (5.0 * t).cos());
        (out[0], out[1]) = (y[1], -(2.0 * r_dot * y[1] + 9.81 * y[0].sin()) / r);
        Ok(())
    };
    let (length, slope) = (1.0 + 0.2 * f64::sin(2.5), f64::cos(2.5));
    let q = f64::asin(0.3 / length);
    let start = [q, (0.4 - slope * q.sin()) / (length * q.cos())];
    let how = Options { method: Method::Dop853, output: OutputOption::Ends, ..Options::tolerances(1e-13, 1e-13) };
    let truth = integrate(by_hand, (0.5, 3.0), &start, &how, &mut []).unwrap().y_end[0];
    let r = 1.0 + 0.2 * f64::sin(15.0);
    for (at, (what, start)) in ropes().into_iter().enumerate() {
        let is_cartesian = at == 3;
        let scene = scene(&pendulum(&what), &start, "[0.5, 3]", "");
        // A scene's reduced equations are not made of loops.
        for (by, solve, method) in WAYS.into_iter().filter(|(by, ..)| !is_cartesian || *by != "reduced") {
            let run = run(&scene, by, solve, method);
            let (name, truth) = if is_cartesian { ("x", r * truth.sin()) } else { ("q", truth) };
            let found = end(&run, name);
            assert!((found - truth).abs() < 1e-10, "{at}, {by} {solve} {method}: {found}, {truth}");
            // Who pulls the rope works, and nobody says how much.
            assert!(run.energy_drift.is_none() && run.notes.iter().any(|n| n.contains("drive the mechanism")));
        }
        let reference = scene.reference(&[3.0]).unwrap();
        assert!(reference.uncertainty < 1e-18, "{at}: {}", reference.uncertainty);
    }
}

/// Goal: driven mechanisms are proved. Method: Kane's and Lagrange's equations of each description, and no conserved
/// energy.
#[test]
fn driven_mechanisms_are_proved_and_keep_no_energy() {
    for (what, _) in ropes() {
        let model = model(&pendulum(&what)).unwrap_or_else(|e| panic!("{e}"));
        assert!(model.is_driven() && model.counts_in_words().ends_with(", time"), "{}", model.counts_in_words());
        let proof = prove(&model, &mut derive_all(&model).unwrap());
        assert!(proof.is_equivalent() && proof.pairs.len() == 3, "{what}");
        assert!(proof.integrals.is_empty(), "{what}");
    }
}

/// Goal: no run is called wrong because its drive does work. Method: a cart pulled at constant speed below a pendulum,
/// whose angle moves as below a cart at rest.
#[test]
fn a_constant_drive_is_no_drift() {
    let moved = |drive: &str| {
        pendulum(&format!(
            "[coordinates]\nx = {{ unit = \"m\" }}\nq = {{ unit = \"rad\" }}\n[speeds]\nu = \"q'\"\n{TURNED}[points]\nP = {{ from = \
             \"O\", frame = \"N\", position = [\"x\", 0, 0] }}\nC = {{ from = \"P\", frame = \"B\", position = [0, \"-l\", 0] \
             }}\n[constraints]\ndrive = {{ equation = \"x' = {drive}\" }}\n"
        ))
    };
    let end_of = |drive: &str| {
        let run = run(&scene(&moved(drive), "x = 0\nq = 1\nu = 0", "[0, 2]", ""), "kane", "eliminated", "dop853");
        (end(&run, "q"), run.energy_drift)
    };
    let ((driven, none), (still, drift)) = (end_of("a*w"), end_of("0"));
    assert!((driven - still).abs() < 1e-11, "{driven}, {still}");
    assert!(none.is_none() && drift.is_some_and(|drift| drift < 1e-10), "{none:?}, {drift:?}");
}

/// Goal: what is said of time where it cannot stand.
#[test]
fn time_stands_where_it_has_a_meaning() {
    let (what, start) = &ropes()[0];
    let refused = |text: &str| model(text).err().unwrap_or_else(|| panic!("accepted:\n{text}"));
    let heavy = pendulum(what).replace("mass = \"m\"", "mass = \"m*t\"");
    assert!(refused(&heavy).contains("`t` cannot stand in the mass of particle `bob`"), "{}", refused(&heavy));
    let named = pendulum(what).replace("[coordinates]\n", "[coordinates]\nt = { unit = \"s\" }\n");
    assert!(refused(&named).contains("`t` is reserved"), "{}", refused(&named));
    let unit = pendulum(what).replace("sin(w*t)", "sin(t)");
    assert!(refused(&unit).contains("unit"), "{}", refused(&unit));
    let mechanism = || Mechanism::new(model(&pendulum(what)).unwrap());
    let text = format!("model = \"timed.toml\"\nspan = [0, 1]\n[start]\nt = 1\n{start}\n");
    let refused = Scene::parse(mechanism(), &text).err().unwrap().to_string();
    assert!(refused.contains("time is not part of a start"), "{refused}");
    let text = format!("model = \"timed.toml\"\nspan = [0, 1]\n[start]\n{}\n", start.replace('u', "\"q'\""));
    let by_rates = Scene::parse(mechanism(), &text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(by_rates.simulate(&Overrides::default()).unwrap().names, ["q", "t", "u"]);
}

/// Goal: projection onto the constraints never moves time. Method: a loose run of a loop that depends on it, whose
/// steps are moved far.
#[test]
fn projection_moves_no_clock() {
    let (what, start) = &ropes()[3];
    let scene = scene(&pendulum(what), start, "[0.5, 3]", "");
    for by in ["kane", "lagrange"] {
        let how = Overrides { by: Some(by.into()), rtol: Some(1e-4), atol: Some(1e-4), ..Overrides::default() };
        let run = scene.simulate(&how).unwrap();
        let report = run.solution.projection.as_ref().unwrap();
        assert!(report.corrections > 5, "{report:?}");
        let clock = run.column_of_quantity("t").unwrap();
        for (t, shown) in run.solution.t.iter().zip(clock) {
            assert!((t - shown).abs() < 1e-12, "{by}: {shown} at {t}");
        }
    }
}

/// Goal: the multiplier of time is the power of the drive. Method: the pull of the rod, from Newton–Euler's equations,
/// times the velocity of the pivot along it, in the library's driven pendulum at random states.
#[test]
fn the_multiplier_of_time_is_the_power_of_the_drive() {
    let all = tripos_models::MODELS.iter().find(|m| m.name == "driven_pendulum").unwrap();
    let system = |name: &str| all.systems.iter().find(|s| s.name == name).unwrap().double;
    let (lagrange, newton_euler) = (system("lagrange"), system("newton-euler"));
    let mut random = Random(3);
    for _ in 0..50 {
        let p: Vec<f64> = (0..5).map(|_| random.between(0.5, 2.0)).collect();
        let (q, u, t) = (random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-3.0, 3.0));
        let multiplier = Dynamics::new(lagrange, &p).unwrap().unknowns(&[q, t], &[u, 1.0]).unwrap()[2];
        let pull = Dynamics::new(newton_euler, &p).unwrap().unknowns(&[q, t], &[u]).unwrap()[1];
        let (amplitude, frequency) = (p[3], p[4]);
        let power = pull * q.cos() * amplitude * frequency * (frequency * t).cos();
        assert!((multiplier - power).abs() < 1e-12 * (1.0 + power.abs()), "{multiplier}, {power}");
    }
}
