//! Mechanisms without free speeds and their drives; reactions between bodies, by every formulation.
//!
//! Truth: closed forms, virtual power and the equilibrium of each body, by hand.

use tripos::{Error, Integrator, Mechanism, Overrides, Run, Scene};
use tripos_derive::Formulation;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;
use tripos_sim::Stop;

pub const G: f64 = 9.81;

pub fn scene(model: &str, scene: &str) -> Scene {
    let model = load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|e| panic!("{e}"))
}

pub fn run(scene: &Scene, by: &str) -> Run {
    let by = (by != "own").then(|| by.into());
    scene.simulate(&Overrides { by, ..Overrides::default() }).unwrap_or_else(|e| panic!("{e}"))
}

/// Samples of a run: time, and the values under these names.
pub fn samples(run: &Run, names: &[&str]) -> Vec<(f64, Vec<f64>)> {
    let columns: Vec<Vec<f64>> =
        names.iter().map(|name| run.column_of_quantity(name).unwrap_or_else(|e| panic!("{e}"))).collect();
    let times = run.samples().map(|(t, _)| t);
    times.enumerate().map(|(at, t)| (t, columns.iter().map(|column| column[at]).collect())).collect()
}

pub fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1.0), "{what}: {found}, not {expected}");
}

pub const PENDULUM: &str = r#"
name = "rod"
[parameters]
m = "2 kg"
l = "0.6 m"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[bodies]
rod = { mass = "m", inertia = "m*l^2/12" }
[joints]
A = { kind = "pin", body = "rod", centre = [0, "-l/2", 0], coordinates = ["q"], speeds = ["u"] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: the pin force is right by all equations. Method: the closed form for a uniform rod, m (g cos q + l u²/2) along
/// it and m g sin(q)/4 across, as output and where an event waits for it to vanish; J. L. Meriam & L. G. Kraige,
/// *Dynamics*, 7th edition (2012), article 6/4.
#[test]
fn the_pin_force_of_a_pendulum_is_the_closed_form_by_every_formulation() {
    let scene = scene(
        PENDULUM,
        "model = \"model.toml\"\nspan = [0, 1]\noutputs = [\"q\", \"u\", { name = \"along\", value = \"force(ground on rod) @ rod_frame [2]\" }, { name \
         = \"across\", value = \"force(ground on rod) @ rod_frame [1]\" }, { name = \"up\", value = \"-force(rod on ground) @ N [2]\" }]\n[start]\nq = \
         2.5\nu = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-12\n[[events]]\nname = \"slack\"\nzero = \"force(ground on rod) @ \
         rod_frame [2]\"\n",
    );
    let (m, l) = (2.0, 0.6);
    // m (g cos q + l u²/2) = 0 with u² = 3 g (cos q − cos q₀)/l.
    let slack = (0.6 * f64::cos(2.5)).acos();
    for by in ["own", "kane", "lagrange", "newton-euler"] {
        let run = run(&scene, by);
        assert!(run.failure().is_none(), "{by}: {:?}", run.objections());
        for (_, values) in samples(&run, &["q", "u", "along", "across", "up"]) {
            let [q, u, along, across, up] = values[..] else { panic!("five") };
            near(along, m * (G * q.cos() + l * u * u / 2.0), 1e-10, by);
            near(across, m * G * q.sin() / 4.0, 1e-10, by);
            near(up, along * q.cos() + across * q.sin(), 1e-10, by);
        }
        let event = run.events().first().unwrap_or_else(|| panic!("{by}: the rod is pushed, then pulled"));
        let at = run
            .samples()
            .map(|(t, x)| (t, x[0]))
            .min_by(|a, b| (a.0 - event.t).abs().total_cmp(&(b.0 - event.t).abs()));
        assert!((at.unwrap().1.abs() - slack).abs() < 0.2, "{by}: {at:?} {slack}");
    }
}

/// A block on a table that shakes, z = a sin(ω t).
const BLOCK: &str = r#"
name = "block on a shaking table"
[parameters]
m = "2 kg"
a = "0.1 m"
w = "12 rad/s"
g = "9.81 m/s^2"
[coordinates]
z = { unit = "m" }
[inertial]
frame = "N"
origin = "O"
[points]
C = { from = "O", frame = "N", position = [0, "z", 0] }
[particles]
block = { point = "C", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
table = { equation = "z = a*sin(w*t)" }
"#;

/// Goal: a condition of the domain can name a force between bodies, or a reaction that was found. Method: the block
/// leaves the table where g = a ω² sin(ω t).
#[test]
fn a_block_leaves_the_table_where_nothing_pushes_it() {
    let leaves = (G / (0.1 * 144.0)).asin() / 12.0;
    for condition in
        ["force(ground on block) @ N [2] > 0", "block_force_n2 > 0", "m*g/1000 < block_force_n2 + m*g/1000"]
    {
        let model = format!("{BLOCK}[domain]\ncontact = \"{condition}\"\n");
        let scene =
            scene(&model, "model = \"model.toml\"\nspan = [0, 1]\noutputs = [\"z\", \"block_force_n2\"]\n[start]\n");
        for by in ["own", "kane", "lagrange", "newton-euler"] {
            let run = run(&scene, by);
            assert!(matches!(run.solution.stop, Stop::LeftDomain { .. }), "{condition}, {by}: {}", run.ending);
            near(run.solution.t_end, leaves, 1e-9, by);
            for (t, values) in samples(&run, &["z", "block_force_n2"]) {
                near(values[0], 0.1 * (12.0 * t).sin(), 1e-12, by);
                near(values[1], 2.0 * (G - 0.1 * 144.0 * (12.0 * t).sin()), 1e-11, by);
            }
        }
    }
}

#[test]
fn a_domain_that_names_no_reaction_of_the_model_is_refused() {
    for (condition, message) in [
        ("block_force_n1 > 0", "no reaction `block_force_n1` is found"),
        ("force(ground on block) @ N [1] > 0", "does not depend on the motion: the reaction is zero"),
        ("force(ground on blok) @ N [2] > 0", "there is no body `blok`"),
        ("force(ground on block) @ N [2] > m", "the left side is in"),
    ] {
        let model = format!("{BLOCK}[domain]\ncontact = \"{condition}\"\n");
        let errors =
            load(&Source::from_text("model.toml", &model)).err().unwrap_or_else(|| panic!("{condition}")).to_string();
        assert!(errors.contains(message) && errors.matches("error: ").count() == 1, "{condition}: {errors}");
    }
}

const CRANK: &str = r#"
name = "slider-crank whose crank is driven"
[parameters]
m1 = "1 kg"
m2 = "2 kg"
m3 = "0.5 kg"
a = "0.1 m"
b = "0.4 m"
w = "10 rad/s"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[bodies]
crank = { mass = "m1", inertia = "m1*a^2/12" }
rod = { mass = "m2", inertia = "m2*b^2/12" }
piston = { mass = "m3", inertia = 0 }
[joints]
A = { kind = "pin", body = "crank", centre = ["a/2", 0, 0], coordinates = ["q1"] }
B = { kind = "pin", body = "rod", to = "crank", at = ["a", 0, 0], centre = ["b/2", 0, 0], coordinates = ["q2"] }
S = { kind = "slider", body = "piston", axis = 1, coordinates = ["x"] }
P = { kind = "pin", body = "piston", to = "rod", at = ["b", 0, 0] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

const TURN: &str = r#"
model = "model.toml"
span = [0, 0.7]
outputs = [
    "x",
    { name = "motor", value = "torque(ground on crank) @ N [3]" },
    { name = "bx", value = "force(crank on rod) @ N [1]" },
    { name = "by", value = "force(crank on rod) @ N [2]" },
    { name = "px", value = "force(rod on piston) @ N [1]" },
    { name = "wall", value = "force(ground on piston) @ N [2]" },
]
[start]
[guess]
q2 = 0
x = 0.5
[integration]
method = "dop853"
rtol = 1e-10
atol = 1e-12
"#;

/// Slider-crank at an instant: the piston, the motor's torque by virtual power, and forces by the equilibrium of piston
/// and rod.
struct ByHand {
    x: f64,
    motor: f64,
    at_crank: [f64; 2],
    on_piston: f64,
    wall: f64,
}

fn by_hand(t: f64) -> ByHand {
    let ([m1, m2, m3], [a, b], w) = ([1.0, 2.0, 0.5], [0.1, 0.4], 10.0);
    let (sin, cos) = (w * t).sin_cos();
    // b sin β = −a sin φ, with the rod at β from axis 1.
    let beta = (-a * sin / b).asin();
    let rate = -a * w * cos / (b * beta.cos());
    let second = (a * w * w * sin + b * rate * rate * beta.sin()) / (b * beta.cos());
    let turned = |r: f64, angle: f64, rate: f64, second: f64| {
        let (s, c) = angle.sin_cos();
        ([-r * rate * s, r * rate * c], [-r * (second * s + rate * rate * c), r * (second * c - rate * rate * s)])
    };
    let add = |p: [f64; 2], q: [f64; 2]| [p[0] + q[0], p[1] + q[1]];
    let (v_pin, a_pin) = turned(a, w * t, w, 0.0);
    let (v_half, a_half) = turned(b / 2.0, beta, rate, second);
    let (v_crank, a_crank) = turned(a / 2.0, w * t, w, 0.0);
    let (v_rod, a_rod) = (add(v_pin, v_half), add(a_pin, a_half));
    let (v_piston, a_piston) = (add(v_rod, v_half), add(a_rod, a_half));
    let power = |m: f64, v: [f64; 2], acc: [f64; 2]| m * (acc[0] * v[0] + (acc[1] + G) * v[1]);
    let inertia = m2 * b * b / 12.0;
    let all = power(m1, v_crank, a_crank) + power(m2, v_rod, a_rod) + power(m3, v_piston, a_piston);
    let motor = (all + inertia * second * rate) / w;
    // The equilibrium of the piston along axis 1, of the rod along both axes, and the rod's moments about the piston's
    // pin.
    let on_piston = m3 * a_piston[0];
    let bx = m2 * a_rod[0] + on_piston;
    let (s, c) = beta.sin_cos();
    // Σ moments about P: −b (c by − s bx) − (b/2)(c (−m₂ g) ...) = I β″ + r × m₂ a, with r = −b/2 (c, s) from P to the
    // centre.
    let moment = inertia * second - b / 2.0 * (c * m2 * (a_rod[1] + G) - s * m2 * a_rod[0]);
    let by = (s * bx * b - moment) / (c * b);
    // The rod pushes the piston by the remainder of its own equilibrium.
    let py = by - m2 * (a_rod[1] + G);
    ByHand { x: a * cos + b * beta.cos(), motor, at_crank: [bx, by], on_piston, wall: m3 * G - py }
}

/// Goal: inverse dynamics gives the torque of the motor and the forces of the pins. Method: virtual power and
/// equilibrium by hand. The drive is a constrained rate, a formula for the coordinate, or a formula for two; each by
/// every formulation.
#[test]
fn a_driven_slider_crank_shows_what_its_motor_gives() {
    for drive in ["q1 = w*t", "q1' = w", "sin(q1 - w*t) = 0"] {
        let scene = if drive == "q1 = w*t" {
            scene(&format!("{CRANK}[constraints]\ndrive = {{ equation = \"{drive}\" }}\n"), TURN)
        } else {
            let start = TURN.replace("[start]\n", if drive.contains('t') { "[start]\n" } else { "[start]\nq1 = 0\n" });
            scene(&format!("{CRANK}[constraints]\ndrive = {{ equation = \"{drive}\" }}\n"), &start)
        };
        let model = scene.mechanism();
        assert!(model.speeds.is_empty(), "{drive}");
        assert!(scene.prove().unwrap().is_equivalent(), "{drive}");
        for by in ["own", "kane", "lagrange", "newton-euler"] {
            let what = format!("{drive}, {by}");
            let run = run(&scene, by);
            assert!(run.failure().is_none(), "{what}: {:?}", run.objections());
            assert!(run.residuals.iter().all(|r| r.largest.abs() < 1e-12), "{what}: {:?}", run.residuals);
            let tolerance = if drive == "q1' = w" || by == "lagrange" { 1e-7 } else { 1e-9 };
            for (t, values) in samples(&run, &["x", "motor", "bx", "by", "px", "wall"]) {
                let truth = by_hand(t);
                let all = [truth.x, truth.motor, truth.at_crank[0], truth.at_crank[1], truth.on_piston, truth.wall];
                for (found, expected) in values.iter().zip(all) {
                    near(*found, expected, tolerance, &format!("{what} at {t}"));
                }
            }
        }
    }
}

/// Goal: a structure stands, and its pins hold it. Method: two bars under their weights, by the equilibrium of each.
/// The lower one lies level, so that the upper one pushes it with −W l/h along and W/2 up.
#[test]
fn a_bracket_is_held_as_statics_says() {
    let model = r#"
name = "bracket"
[parameters]
mb = "3 kg"
l = "1 m"
h = "0.5 m"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[points]
D = { from = "O", frame = "N", position = [0, "h", 0] }
[bodies]
low = { mass = "mb", inertia = "mb*l^2/12" }
high = { mass = "mb", inertia = "mb*(l^2 + h^2)/12" }
[joints]
A = { kind = "pin", body = "low", centre = ["l/2", 0, 0] }
B = { kind = "pin", body = "high", to = "low", at = ["l", 0, 0], centre = ["sqrt(l^2 + h^2)/2", 0, 0] }
C = { kind = "pin", body = "high", at = "D", body_at = ["sqrt(l^2 + h^2)", 0, 0] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;
    let text = "model = \"model.toml\"\nspan = [0, 2]\noutputs = [\"q_A\", \"force(high on low) @ N [1]\", \"force(high on low) @ N [2]\", \"force(ground \
                on low) @ N [1]\", \"force(ground on high) @ N [2]\"]\n[start]\n[guess]\nq_A = 0.1\nq_B = 2.6\n";
    let scene = scene(model, text);
    assert!(scene.mechanism().speeds.is_empty() && scene.prove().unwrap().is_equivalent());
    let weight = 3.0 * G;
    for by in ["own", "kane", "lagrange", "newton-euler"] {
        let run = run(&scene, by);
        assert!(run.failure().is_none(), "{by}: {:?}", run.objections());
        let shown = &run.names;
        for (found, expected) in run.end.iter().zip(shown).filter_map(|(value, name)| {
            let expected = match name.as_str() {
                "q_A" => 0.0,
                "force(high on low) @ N [1]" => -weight * 2.0,
                "force(high on low) @ N [2]" => weight / 2.0,
                "force(ground on low) @ N [1]" => weight * 2.0,
                "force(ground on high) @ N [2]" => 1.5 * weight,
                _ => return None,
            };
            Some((*value, expected))
        }) {
            near(found, expected, 1e-12, by);
        }
    }
}

/// Goal: a mechanism without speeds is refused where speeds are needed, with the reason. Method: every function of the
/// library about motions of its own.
#[test]
fn questions_about_motions_of_their_own_are_refused() {
    let driven = scene(BLOCK, "model = \"model.toml\"\nspan = [0, 1]\n[start]\n");
    for formulation in Formulation::ALL {
        assert!(driven.mechanism().derive(formulation).is_ok(), "{formulation:?}");
    }
    let refused = driven.reduce().err().unwrap().to_string();
    assert!(refused.contains("the constraints leave no speed"), "{refused}");
    let by = Overrides { by: Some("reduced".into()), ..Overrides::default() };
    let refused = driven.simulate(&by).err().unwrap().to_string();
    assert!(refused.contains("the constraints leave no speed"), "{refused}");
    let method = Overrides { method: Some(Integrator::Quadrature), ..Overrides::default() };
    assert!(matches!(
        driven.simulate(&method),
        Err(Error::Request { .. } | Error::Input(_) | Error::Unsupported(_) | Error::Stopped(_))
    ));
    for method in ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5", "taylor"] {
        let how = Overrides {
            method: Some(method.parse().unwrap()),
            step: (method == "rk4").then_some(0.01),
            ..Overrides::default()
        };
        let run = driven.simulate(&how).unwrap_or_else(|e| panic!("{method}: {e}"));
        assert!(run.failure().is_none(), "{method}: {:?}", run.objections());
    }
}

/// A column welded to the ground, an arm pinned to it, and a tip welded to the arm. Mass centres lie on the axis of the
/// pin or beside it.
const COLUMN: &str = r#"
name = "column"
[parameters]
m = "1 kg"
l = "1 m"
I = "1 kg*m^2"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[bodies]
base = { mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
arm = { mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
tip = { mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
rotor = { mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
[joints]
G = { kind = "weld", body = "base", at = ["l", 0, 0], centre = [0, "l", 0] }
J = { kind = "pin", body = "arm", to = "base", at = [0, "l", 0], coordinates = ["q"], speeds = ["u"], centre = [0, "-l/2", 0] }
K = { kind = "weld", body = "tip", to = "arm", at = [0, "-l", 0] }
R = { kind = "pin", body = "rotor", at = ["-l", 0, 0], coordinates = ["r"], speeds = ["v"], centre = [0, 0, "l"] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: bodies are connected as the file says, also where a body does not move against the ground. Method: the weight
/// of three bodies that hang at rest, joint by joint, and the torque of a weight beside its joint about this joint.
#[test]
fn forces_go_through_the_joints_of_the_file() {
    let outputs = [
        ("force(ground on base) @ N [2]", 3.0 * G),
        ("force(base on arm) @ N [2]", 2.0 * G),
        ("force(tip on arm) @ N [2]", -G),
        ("torque(ground on base) @ N [3]", 0.0),
        ("torque(ground on rotor) @ N [1]", -G),
        ("torque(ground on rotor about rotor_centre) @ N [1]", 0.0),
    ];
    let list: Vec<String> = outputs.iter().map(|(text, _)| format!("{text:?}")).collect();
    let start = "[start]\nq = 0\nu = 0\nr = 0\nv = 0\n";
    let text = format!("model = \"model.toml\"\nspan = [0, 1]\noutputs = [{}]\n{start}", list.join(", "));
    let run = run(&scene(COLUMN, &text), "kane");
    for (name, expected) in outputs {
        let found = run.column_of_quantity(name).unwrap_or_else(|e| panic!("{e}"));
        near(*found.last().unwrap(), expected, 1e-9, name);
    }
}
