//! Dry friction, smooth at rest.
//!
//! Truth: the time that a slip takes to fall, in closed form; the law written out as a formula; momentum and energy.

use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::{Formulation, Model, model};

const WORLD: &str = r#"
name = "friction"
[parameters]
m = "2 kg"
M = "5 kg"
I = { unit = "kg*m^2", value = 0.3, positive = true }
mu = { unit = "1", value = 0.4 }
more = { unit = "1", value = 0.7 }
N = "12 N"
v0 = "0.02 m/s"
vs = "0.5 m/s"
w0 = { unit = "1/s", value = 0.05 }
l = "0.2 m"
T = "0.6 N*m"
[inertial]
frame = "N0"
origin = "O"
"#;

const BLOCKS: &str = r#"
[bodies]
plank = { mass = "M", inertia = { diagonal = ["I", "I", "I"] } }
block = { mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
[joints]
floor = { kind = "slider", body = "plank", axis = 1, coordinates = ["x"], speeds = ["v"] }
top = { kind = "planar", body = "block", to = "plank", axis = 3, coordinates = ["y", "z", "q"], speeds = ["s", "r", "w"] }
"#;

fn load(rest: &str) -> Result<Model, String> {
    model::load(&Source::from_text("model.toml", &format!("{WORLD}{rest}"))).map_err(|e| e.to_string())
}

fn run(rest: &str, start: &str, by: Formulation) -> Run {
    let model = load(rest).unwrap_or_else(|e| panic!("{e}"));
    let text = format!(
        "model = \"model.toml\"\nspan = [0, 1.5]\n{start}[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-13\n"
    );
    let scene = Scene::parse(Mechanism::new(model), &text).unwrap_or_else(|e| panic!("{e}"));
    let how = Overrides { by: Some(by.name().into()), ..Overrides::default() };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{}: {e}", by.name()));
    assert!(run.failure().is_none(), "{}: {:?}", by.name(), run.objections());
    run
}

/// For s' = -k s/sqrt(s^2 + a^2): k t is what this loses.
fn left(s: f64, a: f64) -> f64 {
    let size = s.hypot(a);
    size - a * ((a + size) / s).ln()
}

/// Goal: friction between two moving bodies follows a closed form. Method: a block slides on a plank that slides; the
/// block does not turn, so that its slip falls as in closed form, and the momentum of both is constant.
#[test]
fn a_block_slides_on_a_plank_as_in_closed_form() {
    let rest = format!(
        "{BLOCKS}[friction]\nrub = {{ on = \"block\", against = \"plank\", frame = \"N0\", normal = 3, coefficient = \"mu\", normal_force = \"N\", smoothing = \"v0\" }}\n"
    );
    let rate = 0.4 * 12.0 * (1.0 / 2.0 + 1.0 / 5.0);
    for by in Formulation::ALL {
        let run = run(&rest, "[start]\nx = 0\ny = 0\nz = 0\nq = 0\nv = 1\ns = 3\nr = 0\nw = 0\n", by);
        let [v, s] = ["v", "s"].map(|name| run.column_of_quantity(name).unwrap());
        assert!(s.last().unwrap() < &1e-3, "it comes to rest");
        for ((t, v), s) in run.solution.t.iter().zip(v).zip(s) {
            assert!((5.0 * v + 2.0 * (v + s) - 13.0).abs() < 1e-10);
            if s > 1e-6 {
                assert!((left(3.0, 0.02) - left(s, 0.02) - rate * t).abs() < 1e-8, "{}: {t}, {s}", by.name());
            }
        }
    }
}

/// Method: a rotor on a dry bearing, alone and against another.
#[test]
fn a_rotor_stops_on_its_bearing_as_in_closed_form() {
    let rotors = "[bodies]\none = { mass = \"m\", inertia = \"I\" }\ntwo = { mass = \"m\", inertia = \"2*I\" }\n[joints]\na = { kind = \"pin\", body = \"one\", speeds = [\"w1\"] }\nb = { kind = \"pin\", body = \"two\", speeds = [\"w2\"] }\n[friction]\n";
    let start = "[start]\nq_a = 0\nq_b = 0\nw1 = 2\nw2 = -1\n";
    for (against, rate, slip, whole) in [("", 2.0, 2.0, false), ("against = \"two\", ", 3.0, 3.0, true)] {
        let rest = format!(
            "{rotors}bearing = {{ on = \"one\", {against}frame = \"N0\", axis = 3, torque = \"T\", smoothing = \"w0\" }}\n"
        );
        for by in Formulation::ALL {
            let run = run(&rest, start, by);
            let [w1, w2] = ["w1", "w2"].map(|name| run.column_of_quantity(name).unwrap());
            for ((t, w1), w2) in run.solution.t.iter().zip(w1).zip(w2) {
                let s = if whole { w1 - w2 } else { w1 };
                if s > 1e-6 {
                    assert!((left(slip, 0.05) - left(s, 0.05) - rate * t).abs() < 1e-8, "{}: {t}, {s}", by.name());
                }
                if whole {
                    assert!((w1 + 2.0 * w2).abs() < 1e-11, "the spin momentum stays");
                }
            }
        }
    }
}

/// Goal: the law with a hump at rest, across a normal, on material that turns. Method: the formula written out, in
/// components of another frame, gives the same motion; energy is only lost.
#[test]
fn stribecks_law_is_its_formula() {
    let rub = "[friction]\nrub = { on = \"block\", at = \"edge\", against = \"plank\", frame = \"N0\", normal = 3, coefficient = \"mu\", normal_force = \"N\", static = \"more\", stribeck = \"vs\", smoothing = \"v0\" }\n";
    let points = "[points]\nedge = { from = \"block_centre\", frame = \"block_frame\", position = [\"l\", 0, 0] }\n";
    let slip = |axis: usize| format!("(v(block, edge) @ block_frame [{axis}] - v(plank, edge) @ block_frame [{axis}])");
    let square = format!("({}^2 + {}^2)", slip(1), slip(2));
    let law =
        |axis: usize| format!("\"-N*(mu + (more - mu)*exp(-{square}/vs^2))*{}/sqrt({square} + v0^2)\"", slip(axis));
    let written = format!(
        "[forces]\nrub = {{ on = \"block\", at = \"edge\", against = \"plank\", against_at = \"edge\", frame = \"block_frame\", vector = [{}, {}, 0] }}\n",
        law(1),
        law(2)
    );
    let start = "[start]\nx = 0\ny = 0\nz = 0\nq = 0.3\nv = 1\ns = 1.2\nr = -0.4\nw = 2\n";
    for by in Formulation::ALL {
        let [one, other] = [rub, &written].map(|law| run(&format!("{BLOCKS}{points}{law}"), start, by));
        for (a, b) in one.end.iter().zip(&other.end) {
            assert!((a - b).abs() < 1e-10, "{}: {:?}, {:?}", by.name(), one.end, other.end);
        }
        let total: Vec<f64> = one.energies.iter().map(|(kinetic, potential)| kinetic + potential).collect();
        assert!(total.windows(2).all(|pair| pair[1] < pair[0] + 1e-12), "energy is lost alone");
    }
}

#[test]
fn friction_that_cannot_be() {
    let rub = "on = \"block\", against = \"plank\", frame = \"N0\", normal = 3, coefficient = \"mu\", normal_force = \"N\", smoothing = \"v0\"";
    for (from, to, what) in [
        (", smoothing = \"v0\"", "", "has no `smoothing`"),
        ("smoothing = \"v0\"", "smoothing = 0", "jumps where the slip is 0"),
        ("smoothing = \"v0\"", "smoothing = \"w0\"", "must be in m/s"),
        ("coefficient = \"mu\"", "coefficient = \"N\"", "must be in 1 or rad"),
        ("normal_force = \"N\"", "normal_force = \"v0\"", "must be in N"),
        (
            "normal_force = \"N\"",
            "normal_force = \"lift\"",
            "the reaction `lift` cannot stand in `normal_force` of friction `rub`: a reaction follows",
        ),
        (
            "normal_force = \"N\"",
            "normal_force = \"force(plank on block) @ N0 [3]\"",
            "the reaction `force(plank on block) @ N0 [3]` cannot stand in `normal_force` of friction `rub`: a reaction follows",
        ),
        (
            "normal_force = \"N\"",
            "normal_force = \"block_force_n01\"",
            "the reaction `block_force_n01` cannot stand in `normal_force` of friction `rub`: a reaction follows",
        ),
        ("normal = 3", "normal = 4", "the axis of a rotation is 1, 2 or 3"),
        ("against = \"plank\"", "against = \"block\"", "nothing slips at friction `rub`"),
        ("smoothing", "static = \"more\", smoothing", "has no `stribeck`"),
        ("smoothing", "speed = 3, smoothing", "unknown key `speed`"),
    ] {
        let lift = "[reactions]\nlift = { on = \"block\", frame = \"N0\", direction = [0, 0, 1] }\n";
        let error = load(&format!("{BLOCKS}{lift}[friction]\nrub = {{ {} }}\n", rub.replace(from, to)))
            .err()
            .unwrap_or_else(|| panic!("{to}"));
        assert!(error.contains(what) && error.contains("help"), "{to}: {error}");
        let presses =
            error.contains("state the normal force as a formula of parameters and of the motion, such as `m*g`");
        assert_eq!(presses, what.contains("a reaction follows"), "{to}: {error}");
    }
}
