//! Balls that bounce, roll on as they touch, or lie on a moving plate.

use super::{FINE, Planted, Wide, how, largest_error, truth, wide};
use crate::impacts::scene as scene_of;
use crate::sensitivity::near;
use tripos::{DerivativeInstants, Overrides};
use tripos_traits::Scalar;

pub const BALL: &str = r#"
name = "Ball"
[parameters]
m = { unit = "kg", value = 2, positive = true }
g = { unit = "m/s^2", value = 10 }
e = { unit = "1", value = 0.5 }
L = { unit = "m", value = 0 }
[coordinates]
x = { unit = "m" }
z = { unit = "m" }
[speeds]
v = "x'"
w = "z'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, "z"] }
[particles]
ball = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
zero_at = { z = 0 }
"#;

pub fn ball(values: &[f64], end: f64, law: &str) -> String {
    let [g, e, h, w, floor] = values[..] else { panic!("five") };
    format!(
        "span = [0, {end:?}]\n[start]\nx = 0\nz = {h:?}\nv = 1\nw = {w:?}\n[parameters]\ng = {g:?}\ne = {e:?}\nL = {floor:?}\n{FINE}\
         [impacts.floor]\ngap = \"z - L\"\nrestitution = \"e^2\"\nlaw = \"{law}\"\n"
    )
}

/// Height and speed at an instant of a ball that is thrown up with w from h, over a floor at L that gives back e² of
/// its speed; and the instants of its impacts.
pub fn bounced(numbers: &[Wide], t: f64) -> (Vec<Wide>, Vec<Wide>) {
    let [g, e, h, w, floor] = numbers[..] else { panic!("five") };
    let (half, mut from, mut z, mut w) = (wide(0.5), wide(0.0), h, w);
    let mut met = Vec::new();
    loop {
        let after = (w + (w * w + wide(2.0) * g * (z - floor)).sqrt()) / g;
        let left = wide(t) - from;
        if after > left {
            return (vec![z + w * left - half * g * left * left, w - g * left], met);
        }
        (from, z, w) = (from + after, floor, e * e * (g * after - w));
        met.push(from);
    }
}

/// Goal: height and speed after bounces, and the instants of these, by all numbers that they depend on. These are
/// gravity, a restitution that is a formula, height and speed at the start, and the floor's height. Truth: the closed
/// form, at 24 random points, by either law, all formulations and most methods.
#[test]
fn a_ball_is_differentiated_through_its_bounces() {
    let (mut planted, mut bounces) = (Planted(3), 0);
    for case in 0..24 {
        let values = [
            planted.next(5.0, 12.0),
            planted.next(0.9, 1.0),
            planted.next(0.5, 2.0),
            planted.next(-1.0, 2.0),
            planted.next(-0.5, 0.25),
        ];
        let (law, method) =
            (["newton", "poisson"][case % 2], ["dop853", "ode45", "dopri5", "taylor", "gauss6", "radau5"][case % 6]);
        let scene = scene_of(BALL, &ball(&values, 1.5, law));
        let by = ["kane", "lagrange", "newton-euler"][case % 3];
        let names = ["g", "e", "z", "w", "L", "m"];
        let found =
            scene.sensitivities(&names, DerivativeInstants::End, &how(by, method)).unwrap_or_else(|e| panic!("{e}"));
        let (_, met) = bounced(&values.map(wide), 1.5);
        bounces += met.len();
        assert_eq!(found.run.impacts().len(), met.len(), "{values:?}");
        assert!(found.run.warnings.is_empty(), "{:?}", found.run.warnings);
        let with_mass = [&values[..], &[2.0]].concat();
        let worst = largest_error(&found, &["z", "w"], &with_mass, &|numbers| bounced(&numbers[..5], 1.5).0);
        assert!(worst < 1e-9, "{law} {method} {by} {values:?}: {worst:e}");
        let instants = truth(&values, &|numbers| bounced(numbers, 1.5).1);
        for (bounce, moves) in found.events.iter().enumerate() {
            let moves = moves.as_ref().expect("the floor is met");
            for (by, list) in instants.iter().enumerate() {
                near(moves[by], list[bounce], 1e-9, &format!("dt/d({}) of bounce {bounce}", names[by]));
            }
        }
    }
    assert!(bounces > 30, "{bounces}");
}

/// Goal: samples around an impact have the slopes of their own flight. A run with derivatives equals the one without,
/// bit by bit, through impacts, held contacts and jumps.
#[test]
fn a_bouncing_run_with_derivatives_is_the_run_without() {
    let values = [10.0, 0.75, 1.0, 0.0, 0.0];
    let cases = [
        ("dop853", 1.5, 0.75, 0.0),
        ("ode45", 2.5, 0.5, 0.0),
        ("taylor", 1.5, 0.75, 0.25),
        ("radau5", 1.5, 0.0, 0.25),
        ("dop853", 3.0, 0.625, 0.25),
    ];
    for (method, end, e, floor) in cases {
        let text = ball(&[10.0, e, 1.0, 0.0, floor], end, "newton");
        let scene = scene_of(BALL, &text);
        let names = ["g", "z", "w", "L", "m", "v"];
        let all = scene
            .sensitivities(&names, DerivativeInstants::Samples, &how("kane", method))
            .unwrap_or_else(|e| panic!("{e}"));
        let plain = scene.simulate(&how("kane", method)).unwrap();
        println!("{method} {e}: {:?} {:?}", all.run.failure(), plain.failure());
        assert_eq!(all.run.states, plain.states, "{method}");
        assert_eq!(all.run.solution.t, plain.solution.t, "{method}");
        assert_eq!(all.run.solution.work, plain.solution.work, "{method}");
        assert_eq!(all.run.impacts(), plain.impacts(), "{method}");
        assert_eq!(all.run.events(), plain.events(), "{method}");
        let last = all.samples.iter().map(|list| list.last().unwrap().clone()).collect::<Vec<_>>();
        assert_eq!(last, all.end, "{method}: the last sample is the end");
    }
    let scene = scene_of(BALL, &ball(&values, 1.5, "newton"));
    let found = scene.sensitivities(&["g"], DerivativeInstants::Samples, &Overrides::default()).unwrap();
    let met: Vec<f64> = found.run.impacts().iter().map(|impact| impact.t).collect();
    for (at, t) in found.run.solution.t.iter().enumerate().filter(|(_, t)| !met.contains(*t)) {
        let list = &truth(&values, &|numbers| bounced(numbers, *t).0)[0];
        near(found.samples[0][at][1], list[0], 1e-10, &format!("d(z)/d(g) at {t}"));
        near(found.samples[0][at][3], list[1], 1e-10, &format!("d(w)/d(g) at {t}"));
    }
}

/// Truth: a ball against a wall at L, without gravity: x = L − e v (t − L/v), so dx/dL = 1 + e, dx/de = L − v t, dx/dv
/// = −e t.
#[test]
fn a_ball_thrown_against_a_wall_comes_back_as_it_must() {
    let text = format!(
        "span = [0, 2]\n[start]\nx = 0\nz = 0\nv = 3\nw = 0.5\n[parameters]\ng = 0\nL = 1.5\n{FINE}[impacts.wall]\ngap = \"L - p(P) @ N [1]\"\nrestitution = \"e\"\n"
    );
    let found = scene_of(BALL, &text)
        .sensitivities(&["L", "e", "v", "w", "m"], DerivativeInstants::End, &Overrides::default())
        .unwrap();
    for (by, x, z) in [("L", 1.5, 0.0), ("e", 1.5 - 6.0, 0.0), ("v", -1.0, 0.0), ("w", 0.0, 2.0), ("m", 0.0, 0.0)] {
        near(found.derivative_of("x", by).unwrap(), x, 1e-13, by);
        near(found.derivative_of("z", by).unwrap(), z, 1e-13, by);
    }
    near(found.derivative_of("v", "e").unwrap(), -3.0, 1e-13, "the speed by the restitution");
    near(found.derivative_of("v", "v").unwrap(), -0.5, 1e-13, "the speed by the speed");
}

/// Contact of a ball that lies on a plate, which moves as A sin(k t). The ball leaves where A k² sin(k t) = g, and
/// flies.
pub const PLATE: &str = "[impacts.plate]\ngap = \"p(P) @ N [3] - p(S) @ N [3]\"\nrestitution = 0\n";

pub fn plate() -> String {
    let model = BALL.replace("P = {", "S = { from = \"O\", frame = \"N\", position = [0, 0, \"A*sin(k*t)\"] }\nP = {");
    model.replace("L = {", "A = { unit = \"m\", value = 0.1 }\nk = { unit = \"1/s\", value = 12 }\nL = {")
}

/// Goal: the force of a held contact and the instant at which it no longer pushes are differentiated. Truth: the ball
/// goes with the plate until sin(k t) = g/(A k²), which is before the plate is highest, and from there along a
/// parabola.
#[test]
fn a_ball_that_leaves_a_plate_is_differentiated_by_the_force_that_held_it() {
    let closed = |numbers: &[Wide]| {
        let [size, k, g] = numbers[..] else { panic!("three") };
        let leaves = (g / (size * k * k)).asin() / k;
        let (s, c) = (k * leaves).sin_cos();
        let left = wide(0.21875) - leaves;
        vec![size * s + size * k * c * left - wide(0.5) * g * left * left, size * k * c - g * left, leaves]
    };
    let mut planted = Planted(9);
    for case in 0..8 {
        let values = [planted.next(0.09, 0.12), planted.next(11.5, 13.0), planted.next(9.0, 10.0)];
        let [size, k, g] = values;
        let text = format!(
            "span = [0, 0.21875]\n[start]\nx = 0\nz = 0\nv = 1\nw = \"A*k\"\n[parameters]\nA = {size:?}\nk = {k:?}\ng = {g:?}\n{FINE}{PLATE}"
        );
        let scene = scene_of(&plate(), &text);
        let how = how(["kane", "lagrange"][case % 2], ["dop853", "ode45"][case % 2]);
        let found = scene.sensitivities(&["A", "k", "g", "m"], DerivativeInstants::End, &how).unwrap();
        let numbers = [&values[..], &[2.0]].concat();
        let worst = largest_error(&found, &["z", "w"], &numbers, &|numbers| closed(&numbers[..3])[..2].to_vec());
        assert!(worst < 1e-8, "{values:?}: {worst:e}");
        let opens = found.run.events().iter().position(|event| event.name == "plate opens").expect("it leaves");
        let moves = found.events[opens].as_ref().expect("the instant moves");
        for (by, list) in truth(&values, &closed).iter().enumerate() {
            near(moves[by], list[2], 1e-8, &format!("the instant by number {by}"));
        }
    }
}

/// Three balls in a row on a line, the second and third touching.
pub const ROW: &str = r#"
name = "Three balls in a row"
[parameters]
m1 = { unit = "kg", value = 1, positive = true }
m2 = { unit = "kg", value = 2, positive = true }
m3 = { unit = "kg", value = 1.5, positive = true }
e = { unit = "1", value = 0.5 }
[coordinates]
x1 = { unit = "m" }
x2 = { unit = "m" }
x3 = { unit = "m" }
[speeds]
u1 = "x1'"
u2 = "x2'"
u3 = "x3'"
[inertial]
frame = "N"
origin = "O"
[points]
A = { from = "O", frame = "N", position = ["x1", 0, 0] }
B = { from = "O", frame = "N", position = ["x2", 0, 0] }
C = { from = "O", frame = "N", position = ["x3", 0, 0] }
[particles]
a = { point = "A", mass = "m1" }
b = { point = "B", mass = "m2" }
c = { point = "C", mass = "m3" }
"#;

/// Goal: several contacts push together, with impulses that masses and restitutions share out. Truth: G Λ = (v₁ (1 +
/// e), 0) by Newton's law with both contacts pushing, G = [[1/m₁ + 1/m₂, −1/m₂], [−1/m₂, 1/m₂ + 1/m₃]]. By Poisson's
/// law Λ = (1 + e) times that of the compression, which is the same here. There is no derivative by the place of one of
/// the touching balls.
#[test]
fn an_impact_that_goes_through_a_row_is_differentiated() {
    let names = ["m1", "m2", "m3", "e", "u1", "x1"];
    let values = [1.25, 2.0, 1.5, 0.375, 2.0, -1.0];
    for law in ["newton", "poisson"] {
        let [m1, m2, m3, e, u, x] = values;
        let text = format!(
            "span = [0, 1.25]\n[start]\nx1 = {x:?}\nx2 = 0\nx3 = 0\nu1 = {u:?}\nu2 = 0\nu3 = 0\n[parameters]\nm1 = {m1:?}\nm2 = {m2:?}\nm3 = {m3:?}\ne = {e:?}\n{FINE}\
             [impacts.ab]\ngap = \"x2 - x1\"\nrestitution = \"e\"\nlaw = \"{law}\"\n[impacts.bc]\ngap = \"x3 - x2\"\nrestitution = \"e\"\nlaw = \"{law}\"\n"
        );
        let scene = scene_of(ROW, &text);
        let found = scene.sensitivities(&names, DerivativeInstants::End, &Overrides::default()).unwrap();
        assert_eq!(found.run.impacts()[0].impulses.len(), 2, "{:?}", found.run.impacts());
        let closed = |numbers: &[Wide]| {
            let [m1, m2, m3, e, u, x] = numbers[..] else { panic!("six") };
            let one = wide(1.0);
            let (a, b, d) = (one / m1 + one / m2, -one / m2, one / m2 + one / m3);
            let side = (one + e) * u;
            let (first, second) = (d * side / (a * d - b * b), -b * side / (a * d - b * b));
            let left = wide(1.25) + x / u;
            let speeds = [u - first / m1, (first - second) / m2, second / m3];
            vec![speeds[0] * left, speeds[1] * left, speeds[2] * left, speeds[0], speeds[1], speeds[2]]
        };
        let worst = largest_error(&found, &["x1", "x2", "x3", "u1", "u2", "u3"], &values, &closed);
        assert!(worst < 1e-12, "{law}: {worst:e}");
        let place = scene.sensitivities(&["x3"], DerivativeInstants::End, &Overrides::default()).unwrap();
        let why = place.missing_derivative().expect("its place opens the contact");
        assert!(why.contains("`bc` is closed at the start, and `x3` opens it"), "{why}");
    }
}

/// Goal: bounces that accumulate end in rest. Height and speed then depend only on the floor, and independent motions
/// go on as before. Truth: z = L and w = 0; x = v t.
#[test]
fn bounces_without_end_leave_what_is_at_rest_with_its_derivatives() {
    let scene = scene_of(BALL, &ball(&[10.0, 0.625, 1.0, 0.0, 0.25], 3.0, "newton"));
    let found =
        scene.sensitivities(&["g", "e", "z", "L", "v"], DerivativeInstants::End, &Overrides::default()).unwrap();
    assert!(found.missing_derivative().is_none() && found.run.impacts().iter().any(|impact| !impact.held.is_empty()));
    for (by, z, x) in [("g", 0.0, 0.0), ("e", 0.0, 0.0), ("z", 0.0, 0.0), ("L", 1.0, 0.0), ("v", 0.0, 3.0)] {
        near(found.derivative_of("z", by).unwrap(), z, 1e-9, by);
        near(found.derivative_of("w", by).unwrap(), 0.0, 1e-9, by);
        near(found.derivative_of("x", by).unwrap(), x, 1e-12, by);
    }
    // With T = t₁ (1 + e²)/(1 − e²), t₁ = √(2 (h − L)/g), the derivative by g is −T/(2 g).
    let last = found.run.impacts().last().unwrap().t;
    let at = found.run.events().iter().rposition(|event| event.name == "floor").unwrap();
    near(found.events[at].as_ref().unwrap()[0], -last / 20.0, 1e-7, "the instant at which they accumulate");
}
