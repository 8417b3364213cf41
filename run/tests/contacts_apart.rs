//! Contacts that change at one instant, and contacts of bodies that have nothing to do with one another. Right values
//! are closed forms: what happens to one body is what happens to it alone.

use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;

/// Runs a scene by a method, at these tolerances.
fn run(model: &str, scene: &str, method: &str, tolerance: f64) -> Run {
    let model = load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let text = format!("model = \"model.toml\"\ntitle = \"together\"\n{scene}");
    let scene = Scene::parse(Mechanism::new(model), &text).unwrap_or_else(|e| panic!("{e}"));
    let how = Overrides {
        method: Some(method.parse().unwrap()),
        rtol: Some(tolerance),
        atol: Some(tolerance),
        ..Overrides::default()
    };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{method}: {e}"));
    assert!(run.failure().is_none(), "{method}, {tolerance:e}: {:?}", run.objections());
    run
}

fn end(run: &Run, name: &str) -> f64 {
    *run.column_of_quantity(name).unwrap().last().unwrap()
}

/// Two particles on floors of their own, lifted by forces f and f2 in N, in t.
fn two_masses(f: &str, f2: &str) -> String {
    format!(
        r#"
name = "Two masses"
[parameters]
m = "2 kg"
g = "10 m/s^2"
c = "33.33 N/s"
[coordinates]
y1 = {{ unit = "m" }}
y2 = {{ unit = "m" }}
[speeds]
v1 = "y1'"
v2 = "y2'"
[inertial]
frame = "N"
origin = "O"
[points]
C = {{ from = "O", frame = "N", position = [0, "y1", 0] }}
D = {{ from = "O", frame = "N", position = [0, "y2", 0] }}
[particles]
a = {{ point = "C", mass = "m" }}
b = {{ point = "D", mass = "m" }}
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces.up]
on = "a"
frame = "N"
vector = [0, "{f}", 0]
[forces.up2]
on = "b"
frame = "N"
vector = [0, "{f2}", 0]
"#
    )
}

const AT_REST: &str = "span = [0, 1]\n[start]\ny1 = 0\ny2 = 0\nv1 = 0\nv2 = 0\n[impacts.p]\ngap = \"y1\"\nrestitution = 0\n\
                       [impacts.q]\ngap = \"y2\"\nrestitution = 0\n";

/// Goal: contacts that open at one instant all open. Closed form: each mass leaves its floor at t0 = m g/c, and rises
/// by c (1 − t0)³/(6 m). Method: equal forces, and forces that differ in the last digits.
#[test]
fn contacts_that_open_at_one_instant_all_open() {
    let (m, g, c) = (2.0, 10.0, 33.33);
    let rise = c * (1.0_f64 - m * g / c).powi(3) / (6.0 * m);
    for factor in ["", "1.0000000001*", "1.0000001*", "1.001*"] {
        let model = two_masses(&format!("{factor}c*t"), "c*t");
        for (method, tolerance) in [("ode45", 1e-9), ("dop853", 1e-10), ("dopri5", 1e-9)] {
            let run = run(&model, AT_REST, method, tolerance);
            assert!((end(&run, "y2") - rise).abs() < 1e-8, "{factor:?}, {method}: {}", end(&run, "y2"));
            if factor.is_empty() {
                assert!((end(&run, "y1") - rise).abs() < 1e-8, "{method}: {}", end(&run, "y1"));
            }
        }
    }
}

/// Goal: as before, on one body. Closed form: a rod that is lifted at its middle does not turn.
#[test]
fn feet_that_are_lifted_together_leave_together() {
    let model = r#"
name = "Rod on two feet"
[parameters]
m = "2 kg"
I = "0.1 kg*m^2"
a = "0.4 m"
g = "10 m/s^2"
c = "33.33 N/s"
[coordinates]
y = { unit = "m" }
th = { unit = "rad" }
[speeds]
vy = "y'"
om = "th'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "th" }
[points]
C = { from = "O", frame = "N", position = [0, "y", 0] }
P = { from = "C", frame = "B", position = ["-a", 0, 0] }
Q = { from = "C", frame = "B", position = ["a", 0, 0] }
[bodies.rod]
frame = "B"
centre = "C"
mass = "m"
inertia = "I"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces.up]
on = "rod"
frame = "N"
vector = [0, "c*t", 0]
"#;
    let scene = "span = [0, 1]\n[start]\ny = 0\nth = 0\nvy = 0\nom = 0\n[impacts.p]\ngap = \"p(P) @ N [2]\"\n\
                 restitution = 0\n[impacts.q]\ngap = \"p(Q) @ N [2]\"\nrestitution = 0\n";
    let rise = 33.33 * (1.0_f64 - 20.0 / 33.33).powi(3) / 12.0;
    for (method, tolerance) in [("ode45", 1e-9), ("dop853", 1e-10), ("taylor", 1e-10)] {
        let run = run(model, scene, method, tolerance);
        assert!((end(&run, "y") - rise).abs() < 1e-8, "{method}: {}", end(&run, "y"));
        assert!(end(&run, "th").abs() < 1e-9 && end(&run, "om").abs() < 1e-9, "{method}: {}", end(&run, "th"));
    }
}

/// Goal: an impact changes nothing for a body that it does not touch. Closed form: a block rests inside its friction
/// cone on a slope, under both laws of impact, whatever a ball beside it does.
#[test]
fn a_block_at_rest_stays_at_rest_beside_a_bouncing_ball() {
    let model = r#"
name = "Block and ball"
[parameters]
m = "2 kg"
I = "0.1 kg*m^2"
a = "0.3 m"
b = "0.17 m"
g = "9.81 m/s^2"
al = { unit = "rad", value = 0.2 }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
th = { unit = "rad" }
z = { unit = "m" }
[speeds]
vx = "x'"
vy = "y'"
om = "th'"
vz = "z'"
[inertial]
frame = "N"
origin = "O"
[frames]
F = { from = "N", axis = 3, angle = "al" }
B = { from = "F", axis = 3, angle = "th" }
[points]
C = { from = "O", frame = "F", position = ["x", "y", 0] }
P = { from = "C", frame = "B", position = ["-a", "-b", 0] }
Q = { from = "C", frame = "B", position = ["a", "-b", 0] }
Z = { from = "O", frame = "N", position = [0, "z", 0] }
[bodies.block]
frame = "B"
centre = "C"
mass = "m"
inertia = "I"
[particles.ball]
point = "Z"
mass = "m"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;
    for (one, other) in [(0.3, 0.9), (0.77, 0.54)] {
        for law in ["newton", "poisson"] {
            let scene = format!(
                "span = [0, 2]\n[start]\nx = 0\ny = \"b\"\nth = 0\nz = 1\nvx = 0\nvy = 0\nom = 0\nvz = 0\n\
                 [impacts.p]\ngap = \"p(P) @ F [2]\"\nrestitution = 0\nlaw = \"{law}\"\nfriction = {one}\n\
                 along = \"v(block, P) @ F [1]\"\n[impacts.q]\ngap = \"p(Q) @ F [2]\"\nrestitution = 0\n\
                 law = \"{law}\"\nfriction = {other}\nalong = \"v(block, Q) @ F [1]\"\n\
                 [impacts.floor]\ngap = \"z\"\nrestitution = 0.5\nlaw = \"{law}\"\n"
            );
            for (method, tolerance) in [("ode45", 1e-6), ("dop853", 1e-9)] {
                let run = run(model, &scene, method, tolerance);
                let moved = ["x", "th", "vx", "om"].map(|name| end(&run, name).abs());
                assert!(moved.iter().all(|moved| *moved < 1e-12), "{one}, {law}, {method}: {moved:?}");
                // The bounces are over after (1 + e)/(1 − e) √(2 z/g) = 1.35 s.
                assert!(end(&run, "z").abs() < 1e-12, "{law}, {method}: {}", end(&run, "z"));
            }
        }
    }
}

/// Goal: bounces come to their end beside a body at rest. Closed form: after 3 √(2/g) s the second ball lies.
#[test]
fn bounces_that_become_shorter_end_beside_a_body_at_rest() {
    let scene = AT_REST.replace("span = [0, 1]", "span = [0, 2]").replace("y2 = 0", "y2 = 1");
    let scene = scene.replace("gap = \"y2\"\nrestitution = 0\n", "gap = \"y2\"\nrestitution = 0.5\n");
    for method in ["ode45", "dopri5", "dop853", "taylor"] {
        for tolerance in [1e-6, 1e-8, 1e-10] {
            let run = run(&two_masses("0*c*t", "0*c*t"), &scene, method, tolerance);
            assert!(end(&run, "y2").abs() < 1e-9, "{method}, {tolerance:e}: {}", end(&run, "y2"));
        }
    }
}

/// Ball of mass m on a wedge of mass M with the angle al and a spring k, friction mu: X, x, y, X', x' after 1 s. The
/// ball falls from (0.1, 0.5) onto the wedge at rest, does not bounce, and slips down.
fn ball_on_wedge() -> [f64; 5] {
    let (big, m, g, k, mu) = (2.0, 1.0, 9.81, 50.0, 0.1);
    let (sin, cos) = f64::sin_cos(0.3);
    // Along and across the slope, with friction up the slope: the force on the ball for N = 1.
    let (fx, fy) = (-sin + mu * cos, cos + mu * sin);
    // Push N that gives the ball the acceleration (0, fall) relative to the wedge, at its acceleration `own`, across
    // the slope: N (fx, fy)/m + (0, fall) + N fx/M (1, 0) − own (1, 0) has no part along (−sin, cos).
    let push = |fall: f64, own: f64| -(cos * fall + sin * own) / ((-sin * fx + cos * fy) / m - sin * fx / big);
    let height = 0.5 - 0.1 * sin / cos;
    let hit = f64::sqrt(2.0 * height / g);
    let blow = push(-g * hit, 0.0);
    let mut state = [0.0, 0.1, 0.1 * sin / cos, -blow * fx / big, blow * fx / m, -g * hit + blow * fy / m];
    let rates = |s: &[f64; 6]| {
        let own = -k * s[0] / big;
        let n = push(-g, own);
        [s[3], s[4], s[5], own - n * fx / big, n * fx / m, -g + n * fy / m]
    };
    let count = 4000;
    let h = (1.0 - hit) / f64::from(count);
    for _ in 0..count {
        let moved = |by: f64, k: &[f64; 6]| -> [f64; 6] { std::array::from_fn(|i| state[i] + by * k[i]) };
        let k1 = rates(&state);
        let k2 = rates(&moved(h / 2.0, &k1));
        let k3 = rates(&moved(h / 2.0, &k2));
        let k4 = rates(&moved(h, &k3));
        state = std::array::from_fn(|i| state[i] + h * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0);
    }
    [state[0], state[1], state[2], state[3], state[4]]
}

/// Goal: contacts are held in every formulation: the unknown reactions of Newton and Euler are no multipliers. Method:
/// a ball comes down on a wedge that slides on a spring, and stays on it with friction. Truth: Newton's law for ball
/// and wedge by hand, integrated here.
#[test]
fn contacts_are_held_by_every_formulation() {
    let model = r#"
name = "particle on a wedge"
[parameters]
M = "2 kg"
m = "1 kg"
g = "9.81 m/s^2"
al = { unit = "rad", value = 0.3 }
k = "50 N/m"
[coordinates]
X = { unit = "m" }
x = { unit = "m" }
y = { unit = "m" }
[speeds]
U = "X'"
u = "x'"
v = "y'"
[inertial]
frame = "N"
origin = "O"
[frames]
F = { from = "N", axis = 3, angle = "al" }
[points]
W = { from = "O", frame = "N", position = ["X", 0, 0] }
C = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
wedge = { point = "W", mass = "M" }
ball = { point = "C", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[potentials]
s = "k*X^2/2"
"#;
    let text = r#"
model = "model.toml"
title = "a"
span = [0, 1]
[start]
X = 0
x = 0.1
y = 0.5
U = 0
u = 0
v = 0
[impacts.c]
gap = "p(C) @ F [2] - p(W) @ F [2]"
restitution = 0
friction = 0.1
along = "v(C) @ F [1] - v(W) @ F [1]"
"#;
    let model = load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::parse(Mechanism::new(model), text).unwrap_or_else(|e| panic!("{e}"));
    let by = |by: &str, solve: tripos::AccelerationSolution| {
        let how = Overrides { by: Some(by.into()), solve: Some(solve), ..Overrides::default() };
        let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{by}: {e}"));
        assert!(run.failure().is_none(), "{by}: {:?}", run.objections());
        run
    };
    let truth = ball_on_wedge();
    for other in ["kane", "lagrange", "newton-euler"] {
        for solve in [tripos::AccelerationSolution::Eliminated, tripos::AccelerationSolution::Numeric] {
            let run = by(other, solve);
            for (name, wanted) in ["X", "x", "y", "U", "u"].iter().zip(truth) {
                let found = end(&run, name);
                assert!((found - wanted).abs() < 1e-6, "{other}: {name} is {found}, not {wanted}");
            }
        }
    }
}
