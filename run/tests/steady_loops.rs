//! Rests of mechanisms with redundant loops, ball joints, and speeds that fail in dead points.
//!
//! Truth: closed forms, and one description of a mechanism against another.

use crate::steady_kinds::{closed, loaded, model, rests};
use tripos::studies::steady::{FoundMotion, Stability};
/// Two bodies on one hinge that a second pin ties. The loop closes in one relative pose, by equations one of which
/// follows from the other.
const TIED: &str = r#"
name = "Two bodies on one hinge, tied"
[parameters]
g = { unit = "m/s^2", value = 9.81, positive = true }
m = { unit = "kg", value = 1.9, positive = true }
h = { unit = "m", value = 0.42, positive = true }
a = { unit = "m", value = 0.3, positive = true }
b = { unit = "m", value = 0.4, positive = true }
c = { unit = "m", value = 0.4, positive = true }
d = { unit = "m", value = -0.3 }
J = { unit = "kg*m^2", value = 0.05, positive = true }
[inertial]
frame = "N"
origin = "O"
[points]
E = { from = "J2", frame = "b2_frame", position = ["a", "b", 0] }
[bodies]
b1 = { mass = "m", inertia = "J" }
b2 = { mass = "m", inertia = "J" }
[joints]
J1 = { kind = "pin", body = "b1", axis = 3, centre = [0, "h", 0] }
J2 = { kind = "pin", body = "b2", at = [0, 0, 0], axis = 3 }
C1 = { kind = "pin", body = "b2", at = ["c", "d", 0], body_at = "E", to = "b1" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: rest positions close all loops, redundant ones among them, and all are found. Method: the tied bodies rest
/// where the first stands or hangs, the second turned against it by the angle from (c, d) to (a, b): two positions, one
/// of them stable.
#[test]
fn rests_of_a_redundant_loop_close_it() {
    let names = { model(TIED).speeds.iter().map(|s| s.name.clone()).collect::<Vec<_>>() };
    let held = names.iter().map(|name| format!("{name} = 0\n")).collect::<Vec<_>>().concat();
    let found = rests(TIED, &format!("[state]\n{held}[guess]\nq_J1 = 0.4\nq_J2 = -0.3\n"), 40);
    let turn = f64::atan2(0.4, 0.3) - f64::atan2(-0.3, 0.4);
    let mut stable = 0;
    for rest in &found {
        let [q1, q2] = [0, 1].map(|at| rest.steady.x[at].hi());
        let off = |angle: f64| (angle / 2.0).sin().abs();
        assert!(q1.sin().abs() < 1e-12 && off(q2 - q1 + turn) < 1e-9, "{q1} {q2}");
        let told = rest.about.as_ref().unwrap_or_else(|e| panic!("{e}")).stability;
        assert_eq!(told, if q1.cos() > 0.0 { Stability::Unstable } else { Stability::Energy }, "{q1}");
        stable += usize::from(told == Stability::Energy);
    }
    assert_eq!((found.len(), stable), (2, 1));
    let form = closed(TIED);
    let mut mechanism = model(TIED);
    let state = loaded(&mut mechanism, &format!("[state]\n{held}q_J1 = 0\nq_J2 = 0\n"));
    for rest in &found {
        let on = form.branches_at(&state.parameters, &rest.steady).map(|at| at.branches.len());
        assert_eq!(on, Some(1), "{:?}", form.list[0].branches);
    }
}

/// Body on a ball joint, turned by this sequence, with a disc on it and a bead that slides along it.
fn hung(sequence: &str) -> String {
    format!(
        r#"
name = "Hung body with a slider"
[parameters]
g = {{ unit = "m/s^2", value = 9.81, positive = true }}
m = {{ unit = "kg", value = 0.71, positive = true }}
a = {{ unit = "m", value = 0.6, positive = true }}
b = {{ unit = "m", value = 0.8, positive = true }}
I = {{ unit = "kg*m^2", value = 0.2, positive = true }}
[coordinates]
s = {{ unit = "m" }}
[speeds]
us = "s'"
[inertial]
frame = "N"
origin = "O"
[points]
S = {{ from = "J1", frame = "b1_frame", position = ["s", 0, 0] }}
[bodies]
b1 = {{ mass = "m", inertia = {{ diagonal = ["I*1.098", "I*1.183", "I*1.199"], products = ["I*0.0915", "-I*0.0663", 0] }} }}
b2 = {{ mass = "m", inertia = {{ diagonal = ["I", "I", "I"] }} }}
[particles]
bead = {{ point = "S", mass = "m" }}
[joints]
J1 = {{ kind = "ball", body = "b1", sequence = "{sequence}", centre = ["2*a/3", "-a", "b"] }}
J2 = {{ kind = "pin", body = "b2", to = "b1", at = ["b", "a", 0], axis = 1, centre = [0, "-b/3", "a"] }}
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#
    )
}

/// Goal: eigenvalues do not depend on the coordinates, and zeros are 0 where a norm and a symmetry are taken out.
/// Method: a hung body with a slider and a pendulum on it, by Euler parameters and by angles. Each rest by one
/// description has the eigenvalues of a rest by the other.
#[test]
fn euler_parameters_have_the_eigenvalues_of_angles() {
    let spectra = |sequence: &str, places: &[&str], starts: u64| -> Vec<Vec<[f64; 2]>> {
        let text = hung(sequence);
        let names: Vec<String> = model(&text).speeds.iter().map(|s| s.name.clone()).collect();
        let held = names.iter().map(|name| format!("{name} = 0\n")).collect::<Vec<_>>().concat();
        let guess = places.iter().map(|place| format!("{place}\n")).collect::<Vec<_>>().concat();
        let found = rests(&text, &format!("[state]\n{held}[guess]\n{guess}"), starts);
        let values =
            |found: &FoundMotion| found.about.as_ref().ok().map(|about| about.modes.iter().map(|m| m.value).collect());
        found.iter().filter_map(values).collect()
    };
    let euler = spectra(
        "euler",
        &["s = 0.25", "q_J1_1 = 0.39", "q_J1_2 = 0.78", "q_J1_3 = 0.11", "q_J1_4 = -0.46", "q_J2 = -0.25"],
        0,
    );
    let angles = spectra("321", &["s = 0.25", "q_J1_1 = 0.4", "q_J1_2 = 0.9", "q_J1_3 = -0.6", "q_J2 = -0.25"], 24);
    let [found] = euler.as_slice() else { panic!("{euler:?}") };
    let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-10;
    let is_same =
        |other: &&Vec<[f64; 2]>| other.len() == found.len() && found.iter().all(|a| other.iter().any(|b| near(a, b)));
    assert!(angles.iter().any(|other| is_same(&other)), "{found:?}\n{angles:?}");
    assert!(found.iter().flatten().all(|x| x.abs() <= 0.0 || x.abs() > 1e-3), "{found:?}");
}

/// Slider-crank with torsion springs on crank and coupler, a damper on the crank, and this generalized speed.
fn sprung_crank(speed: &str) -> String {
    format!(
        r#"
name = "Sprung slider-crank"
[parameters]
g = {{ unit = "m/s^2", value = 9.81 }}
m = {{ unit = "kg", value = 1.2 }}
I = {{ unit = "kg*m^2", value = 0.1 }}
a = {{ unit = "m", value = 0.29 }}
b = {{ unit = "m", value = 1.09 }}
e = {{ unit = "m", value = -0.01 }}
k1 = {{ unit = "N*m", value = 11.76 }}
a1 = {{ unit = "rad", value = -0.17 }}
k2 = {{ unit = "N*m", value = 8.77 }}
a2 = {{ unit = "rad", value = 0.94 }}
cd = {{ unit = "N*m*s", value = 0.7 }}
[coordinates]
q1 = {{ unit = "rad" }}
q2 = {{ unit = "rad" }}
x = {{ unit = "m" }}
[speeds]
u1 = "{speed}"
[inertial]
frame = "N"
origin = "O"
[frames]
B1 = {{ from = "N", axis = 3, angle = "q1" }}
B2 = {{ from = "N", axis = 3, angle = "q2" }}
[points]
A = {{ from = "O", frame = "B1", position = ["a", 0, 0] }}
Q = {{ from = "A", frame = "B2", position = ["b", 0, 0] }}
R = {{ from = "O", frame = "N", position = ["x", "e", 0] }}
C1 = {{ from = "O", frame = "B1", position = ["a/2", 0, 0] }}
C2 = {{ from = "A", frame = "B2", position = ["b/2", 0, 0] }}
[bodies]
b1 = {{ frame = "B1", centre = "C1", mass = "m", inertia = "I" }}
b2 = {{ frame = "B2", centre = "C2", mass = "m", inertia = "I" }}
[particles]
sl = {{ point = "R", mass = "m" }}
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
lx = {{ equation = "p(Q) @ N [1] = p(R) @ N [1]" }}
ly = {{ equation = "p(Q) @ N [2] = p(R) @ N [2]" }}
[potentials]
v1 = "k1*(q1 - a1)^2/2"
v2 = "k2*(q2 - a2)^2/2"
[torques.dd]
on = "b1"
frame = "N"
vector = [0, 0, "-cd*q1'"]
"#
    )
}

/// Goal: a state where only the chosen speed does not move the mechanism is no rest, and the search finds the true
/// rests. Method: a slider-crank whose coupler's rate is the speed, which fails at q1 = ±90°. Its energy is V = k1 (q1
/// − a1)²/2 + k2 (q2 − a2)²/2 + m g (a sin q1)/2 + m g (a sin q1 + e)/2, with a sin q1 + b sin q2 = e. So rest needs b
/// cos q2 (k1 (q1 − a1) + m g a cos q1) = a cos q1 k2 (q2 − a2), which is tested here. Both rests are those that the
/// speed q1' finds.
#[test]
fn a_dead_point_of_the_chosen_speed_is_no_rest() {
    let state =
        "[state]\nu1 = 0\n[guess]\nq1 = -2.5036063454922566\nq2 = 0.14984260363410173\nx = 0.8448300569558761\n";
    let cosine = |x: f64| x.cos();
    for speed in ["q2'", "q1'"] {
        let found = rests(&sprung_crank(speed), state, 6);
        let mut seen = [false; 2];
        for found in &found {
            let [q1, q2] = [0, 1].map(|at| found.steady.x[at].hi());
            let turning = 1.09 * cosine(q2) * (11.76 * (q1 + 0.17) + 1.2 * 9.81 * 0.29 * cosine(q1));
            let left = turning - 0.29 * cosine(q1) * 8.77 * (q2 - 0.94);
            assert!(left.abs() < 1e-9, "{speed}: {q1} {q2} is left at {left}");
            let about = found.about.as_ref().unwrap_or_else(|e| panic!("{speed}: {e}"));
            for (at, [wanted, angle]) in [[-0.554_420, 0.131_267], [0.310_652, -3.050_967]].into_iter().enumerate() {
                if (q1 - wanted).abs() < 1e-6 && (q2 - angle).abs() < 1e-6 {
                    seen[at] = true;
                    assert_eq!(about.stability, Stability::Attracting, "{speed}");
                }
            }
        }
        assert_eq!(seen, [true; 2], "{speed}: {:?}", found.iter().map(|f| &f.steady.x).collect::<Vec<_>>());
    }
}

/// Goal: a rest in a dead point of the chosen speed is still found, with the reason why it has no linear system.
/// Method: without springs on the coupler and gravity, a crank whose spring is slack at −90° rests there.
#[test]
fn a_rest_in_a_dead_point_is_kept() {
    let text = sprung_crank("q2'")
        .replace("a1 = { unit = \"rad\", value = -0.17 }", "a1 = { unit = \"rad\", value = -1.5707963267948966 }")
        .replace("value = 8.77", "value = 0")
        .replace("value = 9.81", "value = 0");
    let state = "[state]\nu1 = 0\n[guess]\nq1 = -1.5\nq2 = 0.25\nx = 1.07\n";
    let found = rests(&text, state, 0);
    assert_eq!(found.len(), 1);
    assert!((found[0].steady.x[0].hi() + std::f64::consts::FRAC_PI_2).abs() < 1e-9, "{:?}", found[0].steady.x);
    let why = found[0].about.as_ref().unwrap_err().to_string();
    assert!(why.contains("cos(q1)"), "{why}");
}
