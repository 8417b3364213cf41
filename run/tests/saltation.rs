//! Derivatives through impacts and through jumps that move, against closed forms in 32 digits.

use crate::sensitivity::near;
use tripos::{At, Mechanism, Overrides, Scene, Sensitivities};
use tripos_derive::diagnostic::Source;
use tripos_traits::{DoubleDouble, Real, Scalar};

type Wide = DoubleDouble;

fn scene_of(model: &str, scene: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), &format!("model = \"model.toml\"\n{scene}")).unwrap_or_else(|e| panic!("{e}"))
}

fn how(by: &str, method: &str) -> Overrides {
    Overrides { by: Some(by.to_owned()), method: Some(method.to_owned()), ..Overrides::default() }
}

fn wide(x: f64) -> Wide {
    DoubleDouble::from_f64(x)
}

/// The derivatives by each of these numbers of a closed form, as differences of order 4 in 32 digits.
fn truth(numbers: &[f64], of: &dyn Fn(&[Wide]) -> Vec<Wide>) -> Vec<Vec<f64>> {
    let by = |which: usize| {
        let step = wide(numbers[which].abs().max(1.0) / 262_144.0);
        let at = |place: i32| {
            let mut list: Vec<Wide> = numbers.iter().map(|x| wide(*x)).collect();
            list[which] = list[which] + step * wide(f64::from(place));
            of(&list)
        };
        let (list, weights) = ([at(-2), at(-1), at(1), at(2)], [1.0, -8.0, 8.0, -1.0]);
        let sum = |value: usize| {
            let terms = list.iter().zip(weights).map(|(list, weight)| list[value] * wide(weight));
            (terms.fold(wide(0.0), |sum, term| sum + term) / (step * wide(12.0))).to_f64()
        };
        (0..list[0].len()).map(sum).collect::<Vec<f64>>()
    };
    (0..numbers.len()).map(by).collect()
}

/// The largest error of the derivatives at the end, by the largest of their size and 1, of what is shown under these names, whose closed form is given. What is stated of them holds.
fn off(found: &Sensitivities, shown: &[&str], numbers: &[f64], of: &dyn Fn(&[Wide]) -> Vec<Wide>) -> f64 {
    assert!(
        found.run.failure().is_none() && found.missing().is_none(),
        "{:?} {:?}",
        found.run.objections(),
        found.missing()
    );
    let errors = found.errors.as_ref().expect("a second run comes to the end");
    let mut worst = 0.0_f64;
    for (by, list) in truth(numbers, of).iter().enumerate() {
        for (name, truth) in shown.iter().zip(list) {
            let at = found.names.iter().position(|known| known == name).unwrap();
            let (own, stated) = (found.end[by][at], errors[by][at]);
            let (off, size) = ((own - truth).abs(), truth.abs().max(1.0));
            println!("d({name})/d({}) = {own:e} ± {stated:.1e}, not {truth:e}: off by {off:.1e}", found.by[by]);
            assert!(
                off <= 100.0 * stated + 1e-12 * size,
                "d({name})/d({}) = {own:e} ± {stated:.1e}, not {truth:e}",
                found.by[by]
            );
            worst = worst.max(off / size);
        }
    }
    worst
}

/// Numbers that are spread over a range, the same on every machine.
struct Planted(u64);

impl Planted {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // Twelve bits, so that texts have the number itself.
        low + (high - low) * (f64::from(u16::try_from(self.0 >> 52).unwrap()) / 4096.0)
    }
}

const DRIVEN: &str = r#"
name = "Oscillator under a force of time"
[parameters]
m = { unit = "kg", value = 2, positive = true }
k = { unit = "N/m", value = 18, positive = true }
a = { unit = "N", value = 3 }
c = { unit = "1/s", value = 7 }
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
[forces.drive]
on = "b"
frame = "N"
vector = ["a*sign(c*t - 10) - k*x", 0, 0]
"#;

const FINE: &str = "[integration]\nmethod = \"dop853\"\nrtol = 1e-13\natol = 1e-14\n";

fn driven(values: &[f64], more: &str) -> String {
    let [m, k, a, c, x] = values[..] else { panic!("five") };
    format!(
        "span = [0, 3]\n[start]\nx = {x:?}\nv = 0\n[parameters]\nm = {m:?}\nk = {k:?}\na = {a:?}\nc = {c:?}\n{FINE}{more}"
    )
}

/// x and v at t of m x'' + k x = a sign(t − T), T = 10/c, from x₀ at rest: x = x₀ cos ωt − A (1 − cos ωt) + 2A (1 − cos ω(t − T)) with A = a/k, the last from T on.
fn switched(numbers: &[Wide], t: f64) -> Vec<Wide> {
    let [m, k, a, c, x] = numbers[..] else { panic!("five") };
    let (w, t, size) = ((k / m).sqrt(), wide(t), a / k);
    let switch = wide(10.0) / c;
    let (s, co) = (w * t).sin_cos();
    let (mut place, mut speed) = (x * co - size * (wide(1.0) - co), -x * w * s - size * w * s);
    if t > switch {
        let (s, co) = (w * (t - switch)).sin_cos();
        place = place + wide(2.0) * size * (wide(1.0) - co);
        speed = speed + wide(2.0) * size * w * s;
    }
    vec![place, speed]
}

const DRIVE: [&str; 5] = ["m", "k", "a", "c", "x"];

/// Goal: the instant of a jump moves, and slopes jump with it, by every method that has steps end there. Truth: the closed form, at 24 plantings of all numbers.
#[test]
fn a_force_that_switches_is_differentiated_by_when_it_does() {
    let mut planted = Planted(7);
    for case in 0..24 {
        let values = [
            planted.next(1.0, 3.0),
            planted.next(5.0, 40.0),
            planted.next(-4.0, 4.0),
            planted.next(3.6, 20.0),
            planted.next(-1.0, 1.0),
        ];
        let method = ["dop853", "dopri5", "ode45", "gauss6", "radau5"][case % 5];
        let by = ["kane", "lagrange", "newton-euler"][case % 3];
        let scene = scene_of(DRIVEN, &driven(&values, ""));
        let loose = if method == "radau5" || method == "gauss6" { Some(1e-10) } else { None };
        let how = Overrides { rtol: loose, atol: loose, ..how(by, method) };
        let found = scene.sensitivities(&DRIVE, At::End, &how).unwrap_or_else(|e| panic!("{e}"));
        let worst = off(&found, &["x", "v"], &values, &|numbers| switched(numbers, 3.0));
        assert!(worst < if loose.is_some() { 1e-6 } else { 1e-10 }, "{method} {by} {values:?}: {worst:e}");
    }
}

/// Goal: samples have the slopes of their own instants: before the switch those without it, from it on those after it. And events on the way move as they do.
#[test]
fn samples_and_events_beside_a_switch_have_the_slopes_of_their_side() {
    let values = [2.0, 18.0, 3.0, 7.0, 0.75];
    let more = "[[events]]\nname = \"passes\"\nzero = \"x\"\n";
    let scene = scene_of(DRIVEN, &driven(&values, more));
    let found = scene.sensitivities(&DRIVE, At::Samples, &Overrides::default()).unwrap();
    let solution = &found.run.solution;
    let after = solution.t.iter().position(|t| *t >= 10.0 / 7.0).unwrap();
    let column = |name: &str| found.names.iter().position(|known| known == name).unwrap();
    let (x, v) = (column("x"), column("v"));
    assert!((solution.t[after] - 10.0 / 7.0).abs() < 1e-15 && after > 3 && after + 3 < solution.t.len());
    for (at, t) in solution.t.iter().enumerate() {
        // At the switch itself the slopes are those after it.
        let instant = if at == after { t + 1e-13 } else { *t };
        for (by, list) in truth(&values, &|numbers| switched(numbers, instant)).iter().enumerate() {
            if at == after && by == 3 {
                let later = -10.0 / 49.0;
                near(found.samples[by][at][v], -2.0 * 1.5 * later, 1e-10, "the jump of the speed");
                continue;
            }
            near(found.samples[by][at][x], list[0], 1e-10, &format!("d(x)/d({}) at {t}", DRIVE[by]));
            near(found.samples[by][at][v], list[1], 1e-10, &format!("d(v)/d({}) at {t}", DRIVE[by]));
        }
    }
    assert!(!found.events.is_empty());
    for (event, moves) in found.run.events().iter().zip(&found.events) {
        let slopes = truth(&values, &|numbers| switched(numbers, event.t));
        let speed = switched(&values.map(wide), event.t)[1].to_f64();
        for (by, list) in slopes.iter().enumerate() {
            near(moves.as_ref().unwrap()[by], -list[0] / speed, 1e-9, &format!("dt/d({}) at {}", DRIVE[by], event.t));
        }
    }
}

/// Goal: a bend that moves is differentiated by. Truth: m x'' + k x = a |c t − 10|, whose derivative by c is the response to a t sign(c t − 10); by differences of the closed form.
#[test]
fn a_force_with_a_bend_that_moves_is_differentiated() {
    let model = DRIVEN.replace("a*sign(c*t - 10)", "a*abs(c*t - 10)");
    let closed = |numbers: &[Wide]| {
        let [m, k, a, c, x] = numbers[..] else { panic!("five") };
        let (w, t, one) = ((k / m).sqrt(), wide(3.0), wide(1.0));
        let (s, co) = (w * t).sin_cos();
        let bend = wide(10.0) / c;
        // a (10 − c t), and 2 a c (t − T) from T on.
        let line = a / k * (wide(10.0) * (one - co) - c * (t - s / w));
        let (late, _) = (w * (t - bend)).sin_cos();
        let more = if t > bend { wide(2.0) * a * c / k * (t - bend - late / w) } else { wide(0.0) };
        vec![x * co + line + more]
    };
    let mut planted = Planted(11);
    for case in 0..12 {
        let values = [
            planted.next(1.0, 3.0),
            planted.next(5.0, 40.0),
            planted.next(-4.0, 4.0),
            planted.next(3.6, 20.0),
            planted.next(-1.0, 1.0),
        ];
        let scene = scene_of(&model, &driven(&values, ""));
        let found = scene.sensitivities(&DRIVE, At::End, &how("kane", ["dop853", "ode45"][case % 2])).unwrap();
        let worst = off(&found, &["x"], &values, &closed);
        assert!(worst < 1e-10, "{values:?}: {worst:e}");
    }
}

/// Goal: a table whose knots move: a force that rises from 0 at T to b at T + d and stays. Truth: the closed form of an oscillator under ramps.
#[test]
fn a_table_whose_knots_move_is_differentiated() {
    let ramp = "c*(abs(t - T) - abs(t - T - a) + a)/2";
    let model = DRIVEN
        .replace("a*sign(c*t - 10)", ramp)
        .replace("[coordinates]", "T = { unit = \"s\", value = 0.7 }\n[coordinates]");
    let model = model
        .replace("a = { unit = \"N\"", "a = { unit = \"s\"")
        .replace("c = { unit = \"1/s\"", "c = { unit = \"N/s\"");
    let values = [2.0, 18.0, 0.8125, 5.0, 0.25, 0.6875];
    let text = driven(&values[..5], "").replace("[parameters]", "[parameters]\nT = 0.6875");
    let names = ["m", "k", "a", "c", "x", "T"];
    let found = scene_of(&model, &text).sensitivities(&names, At::End, &Overrides::default()).unwrap();
    let closed = |numbers: &[Wide]| {
        let [m, k, d, c, x, at] = numbers[..] else { panic!("six") };
        let (w, t) = ((k / m).sqrt(), wide(3.0));
        let from = |at: Wide| c / k * (t - at - (w * (t - at)).sin_cos().0 / w);
        vec![x * (w * t).sin_cos().1 + from(at) - from(at + d)]
    };
    let worst = off(&found, &["x"], &values, &closed);
    assert!(worst < 1e-10, "{worst:e}");
}

/// Goal: what has no derivative is refused: jumps that are moved apart, or in and out of the span, and steps that go across.
#[test]
fn jumps_without_a_derivative_are_refused() {
    let values = [2.0, 18.0, 3.0, 5.0, 0.75];
    let refused = |model: &str, text: &str, by: &str, method: &str| {
        let how = Overrides { step: (method == "rk4").then_some(0.01), ..how("kane", method) };
        match scene_of(model, text).sensitivities(&[by], At::End, &how) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{by} is differentiated by"),
        }
    };
    let text = driven(&values, "");
    assert!(refused(DRIVEN, &text, "c", "rk4").contains("equal steps go across"));
    let end = refused(DRIVEN, &text.replace("[0, 3]", "[0, 2]"), "c", "dop853");
    assert!(end.contains("into the span or out of it"), "{end}");
    let two = DRIVEN.replace("a*sign(c*t - 10)", "a*sign(c*t - 10) + a*sign(5*t - 10)").replace("5*t - 10", "t - m");
    let two = two.replace("t - m", "t - T").replace("[coordinates]", "T = { unit = \"s\", value = 2 }\n[coordinates]");
    let apart = refused(&two, &text, "c", "dop853");
    assert!(apart.contains("moves them apart"), "{apart}");
    let scene = scene_of(&two, &text);
    assert!(scene.sensitivities(&["k", "a"], At::End, &Overrides::default()).is_ok(), "neither moves a jump");
}

const BALL: &str = r#"
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

fn ball(values: &[f64], end: f64, law: &str) -> String {
    let [g, e, h, w, floor] = values[..] else { panic!("five") };
    format!(
        "span = [0, {end:?}]\n[start]\nx = 0\nz = {h:?}\nv = 1\nw = {w:?}\n[parameters]\ng = {g:?}\ne = {e:?}\nL = {floor:?}\n{FINE}\
         [impacts.floor]\ngap = \"z - L\"\nrestitution = \"e^2\"\nlaw = \"{law}\"\n"
    )
}

/// Height and speed at an instant of a ball that is thrown up with w from h, over a floor at L which gives back e² of its speed; and when it met the floor.
fn bounced(numbers: &[Wide], t: f64) -> (Vec<Wide>, Vec<Wide>) {
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

/// Goal: height and speed after bounces, and the instants of these, by all that they depend on: gravity, a restitution that is a formula, height and speed at the start, the floor's height. Truth: the closed
/// form, at 24 plantings, by either law, all formulations and most methods.
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
        let found = scene.sensitivities(&names, At::End, &how(by, method)).unwrap_or_else(|e| panic!("{e}"));
        let (_, met) = bounced(&values.map(wide), 1.5);
        bounces += met.len();
        assert_eq!(found.run.impacts().len(), met.len(), "{values:?}");
        assert!(found.run.warnings.is_empty(), "{:?}", found.run.warnings);
        let with_mass = [&values[..], &[2.0]].concat();
        let worst = off(&found, &["z", "w"], &with_mass, &|numbers| bounced(&numbers[..5], 1.5).0);
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

/// Goal: samples around an impact have the slopes of their own flight; a run with derivatives is that without, bit by bit, through impacts, forces that hold and jumps.
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
        let all = scene.sensitivities(&names, At::Samples, &how("kane", method)).unwrap_or_else(|e| panic!("{e}"));
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
    let found = scene.sensitivities(&["g"], At::Samples, &Overrides::default()).unwrap();
    let met: Vec<f64> = found.run.impacts().iter().map(|impact| impact.t).collect();
    for (at, t) in found.run.solution.t.iter().enumerate().filter(|(_, t)| !met.contains(*t)) {
        let list = &truth(&values, &|numbers| bounced(numbers, *t).0)[0];
        near(found.samples[0][at][1], list[0], 1e-10, &format!("d(z)/d(g) at {t}"));
        near(found.samples[0][at][3], list[1], 1e-10, &format!("d(w)/d(g) at {t}"));
    }
}

/// A ball against a wall at L, and no gravity: x = L − e v (t − L/v), so dx/dL = 1 + e, dx/de = L − v t, dx/dv = −e t.
#[test]
fn a_ball_thrown_against_a_wall_comes_back_as_it_must() {
    let text = format!(
        "span = [0, 2]\n[start]\nx = 0\nz = 0\nv = 3\nw = 0.5\n[parameters]\ng = 0\nL = 1.5\n{FINE}[impacts.wall]\ngap = \"L - p(P) @ N [1]\"\nrestitution = \"e\"\n"
    );
    let found =
        scene_of(BALL, &text).sensitivities(&["L", "e", "v", "w", "m"], At::End, &Overrides::default()).unwrap();
    for (by, x, z) in [("L", 1.5, 0.0), ("e", 1.5 - 6.0, 0.0), ("v", -1.0, 0.0), ("w", 0.0, 2.0), ("m", 0.0, 0.0)] {
        near(found.of("x", by).unwrap(), x, 1e-13, by);
        near(found.of("z", by).unwrap(), z, 1e-13, by);
    }
    near(found.of("v", "e").unwrap(), -3.0, 1e-13, "the speed by the restitution");
    near(found.of("v", "v").unwrap(), -0.5, 1e-13, "the speed by the speed");
}

const PLANE: &str = r#"
name = "Body in a plane"
[parameters]
m = { unit = "kg", value = 3, positive = true }
I = { unit = "kg*m^2", value = 0.5, positive = true }
a = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81 }
e = { unit = "1", value = 0.5 }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
th = { unit = "rad" }
[speeds]
vx = "x'"
vy = "y'"
om = "th'"
[inertial]
frame = "N"
origin = "O"
[frames]
F = { from = "N", axis = 3, angle = "th" }
[points]
C = { from = "O", frame = "N", position = ["x", "y", 0] }
A = { from = "C", frame = "F", position = ["-a", 0, 0] }
B = { from = "C", frame = "F", position = ["a", 0, 0] }
[bodies.body]
frame = "F"
centre = "C"
mass = "m"
inertia = { diagonal = ["I", "I", "I"] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
zero_at = { y = 0 }
"#;

fn rod(values: &[f64], more: &str) -> String {
    let [m, i, a, g, e, y, th] = values[..] else { panic!("seven") };
    format!(
        "span = [0, 0.375]\n[start]\nx = 0\ny = {y:?}\nth = {th:?}\nvx = 0.5\nvy = 0\nom = 0\n[parameters]\nm = {m:?}\nI = {i:?}\na = {a:?}\ng = {g:?}\ne = {e:?}\n{FINE}{more}"
    )
}

const ROD: [&str; 7] = ["m", "I", "a", "g", "e", "y", "th"];
const FLOOR_A: &str = "[impacts.A]\ngap = \"p(A) @ N [2]\"\nrestitution = \"e\"\n";
const FLOOR_B: &str = "[impacts.B]\ngap = \"p(B) @ N [2]\"\nrestitution = \"e\"\n";

/// Goal: an impact off the centre, by masses, lengths, the angle. Truth: J = (1 + e) v/(1/m + a² cos² th/I), then y = y₁ + (J/m − v) τ − g τ²/2 and th − J a cos th τ/I; by Kane and
/// Lagrange, at 16 plantings.
#[test]
fn a_rod_that_lands_on_one_end_is_differentiated() {
    let closed = |numbers: &[Wide]| {
        let [m, i, a, g, e, y, th] = numbers[..] else { panic!("seven") };
        let (s, c) = th.sin_cos();
        let one = wide(1.0);
        let v = (wide(2.0) * g * (y - a * s)).sqrt();
        let impulse = (one + e) * v / (one / m + a * a * c * c / i);
        let left = wide(0.375) - v / g;
        let turn = -impulse * a * c / i;
        let up = impulse / m - v;
        vec![a * s + up * left - wide(0.5) * g * left * left, th + turn * left, up - g * left, turn]
    };
    let mut planted = Planted(5);
    for case in 0..16 {
        let mut values = [
            planted.next(1.0, 4.0),
            planted.next(0.3, 1.0),
            planted.next(0.5, 1.5),
            planted.next(8.0, 11.0),
            planted.next(0.3, 0.9),
            0.0,
            planted.next(0.3, 1.0),
        ];
        values[5] = ((values[2] * values[6].sin() + planted.next(0.2, 0.4)) * 4096.0).round() / 4096.0;
        let scene = scene_of(PLANE, &rod(&values, FLOOR_A));
        let found = scene.sensitivities(&ROD, At::End, &how(["kane", "lagrange"][case % 2], "dop853")).unwrap();
        assert_eq!(found.run.impacts().len(), 1, "{values:?}");
        let worst = off(&found, &["y", "th", "vy", "om"], &values, &closed);
        assert!(worst < 1e-10, "{values:?}: {worst:e}");
    }
}

/// Goal: both ends at once, by what keeps them together, and where the angle moves them apart it is said. Truth: the ball's closed form, since a rod that lands flat does not turn.
#[test]
fn a_rod_that_falls_flat_is_differentiated_by_what_keeps_it_flat() {
    let values = [3.0, 0.5, 1.0, 9.75, 0.625, 0.25, 0.0];
    for law in ["newton", "poisson"] {
        let floors = format!("{FLOOR_A}law = \"{law}\"\n{FLOOR_B}law = \"{law}\"\n");
        let scene = scene_of(PLANE, &rod(&values, &floors));
        let found = scene.sensitivities(&ROD[..6], At::End, &Overrides::default()).unwrap();
        assert_eq!(found.run.impacts().len(), 1);
        let closed =
            |numbers: &[Wide]| bounced(&[numbers[3], numbers[4].sqrt(), numbers[5], wide(0.0), wide(0.0)], 0.375).0;
        let worst = off(&found, &["y", "vy"], &values[..6], &closed);
        assert!(worst < 1e-11, "{law}: {worst:e}");
        let apart = scene.sensitivities(&["g", "th"], At::Samples, &Overrides::default()).unwrap();
        let why = apart.missing().expect("the angle moves the ends apart");
        assert!(why.contains("`A` and `B` close at one instant, which `th` moves apart"), "{why}");
        assert!(apart.end[0].iter().all(|x| x.is_finite()) && apart.end[1].iter().all(|x| x.is_nan()));
        assert!(apart.samples[1][0].iter().all(|x| x.is_finite()), "up to there they are known");
        assert!(
            apart.run.warnings.iter().any(|warning| warning.contains("no derivatives by `th` from t = ")),
            "{:?}",
            apart.run.warnings
        );
    }
}

/// A ball that lies on a plate which moves as A sin(k t): it is held, leaves where A k² sin(k t) = g, and flies.
const PLATE: &str = "[impacts.plate]\ngap = \"p(P) @ N [3] - p(S) @ N [3]\"\nrestitution = 0\n";

fn plate() -> String {
    let model = BALL.replace("P = {", "S = { from = \"O\", frame = \"N\", position = [0, 0, \"A*sin(k*t)\"] }\nP = {");
    model.replace("L = {", "A = { unit = \"m\", value = 0.1 }\nk = { unit = \"1/s\", value = 12 }\nL = {")
}

/// Goal: a force that holds a contact, and the instant at which it no longer pushes. Truth: the ball goes with the plate until sin(k t) = g/(A k²), which is before the plate is highest, and from there along a parabola.
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
        let found = scene.sensitivities(&["A", "k", "g", "m"], At::End, &how).unwrap();
        let numbers = [&values[..], &[2.0]].concat();
        let worst = off(&found, &["z", "w"], &numbers, &|numbers| closed(&numbers[..3])[..2].to_vec());
        assert!(worst < 1e-8, "{values:?}: {worst:e}");
        let opens = found.run.events().iter().position(|event| event.name == "plate opens").expect("it leaves");
        let moves = found.events[opens].as_ref().expect("the instant moves");
        for (by, list) in truth(&values, &closed).iter().enumerate() {
            near(moves[by], list[2], 1e-8, &format!("the instant by number {by}"));
        }
    }
}

/// Three balls in a row on a line, the second and third touching.
const ROW: &str = r#"
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

/// Goal: several contacts that push together, with impulses that masses and restitutions share out. Truth: G Λ = (v₁ (1 + e), 0) by Newton's law with both contacts pushing, G = [[1/m₁ + 1/m₂, −1/m₂], [−1/m₂, 1/m₂ +
/// 1/m₃]]; by Poisson's Λ = (1 + e) of the compression, which is the same here. And by the place of one of the touching balls there is no derivative.
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
        let found = scene.sensitivities(&names, At::End, &Overrides::default()).unwrap();
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
        let worst = off(&found, &["x1", "x2", "x3", "u1", "u2", "u3"], &values, &closed);
        assert!(worst < 1e-12, "{law}: {worst:e}");
        let place = scene.sensitivities(&["x3"], At::End, &Overrides::default()).unwrap();
        let why = place.missing().expect("its place opens the contact");
        assert!(why.contains("`bc` is closed at the start, and `x3` opens it"), "{why}");
    }
}

/// Goal: bounces that accumulate end in rest: height and speed depend on nothing any more, and what goes on beside does as before. Truth: z = L and w = 0; x = v t.
#[test]
fn bounces_without_end_leave_what_is_at_rest_with_its_derivatives() {
    let scene = scene_of(BALL, &ball(&[10.0, 0.625, 1.0, 0.0, 0.25], 3.0, "newton"));
    let found = scene.sensitivities(&["g", "e", "z", "L", "v"], At::End, &Overrides::default()).unwrap();
    assert!(found.missing().is_none() && found.run.impacts().iter().any(|impact| !impact.held.is_empty()));
    for (by, z, x) in [("g", 0.0, 0.0), ("e", 0.0, 0.0), ("z", 0.0, 0.0), ("L", 1.0, 0.0), ("v", 0.0, 3.0)] {
        near(found.of("z", by).unwrap(), z, 1e-9, by);
        near(found.of("w", by).unwrap(), 0.0, 1e-9, by);
        near(found.of("x", by).unwrap(), x, 1e-12, by);
    }
    // T = t₁ (1 + e²)/(1 − e²), t₁ = √(2 (h − L)/g): by g it moves by −T/(2 g).
    let last = found.run.impacts().last().unwrap().t;
    let at = found.run.events().iter().rposition(|event| event.name == "floor").unwrap();
    near(found.events[at].as_ref().unwrap()[0], -last / 20.0, 1e-7, "the instant at which they accumulate");
}

/// Goal: a rod that lands on one end and stays on it, held with a force that turns it: by differences of runs without derivatives, which are right to some 1e-8.
#[test]
fn a_rod_that_stays_on_its_end_is_differentiated_while_it_is_held() {
    let values = [3.0, 0.5, 1.0, 9.75, 0.0, 0.625, 0.5];
    let slip = "no_slip = [\"v(A) @ N [1]\"]\n";
    for more in ["", slip] {
        let scene = scene_of(
            PLANE,
            &rod(&values, &FLOOR_A.replace("\"e\"", "0"))
                .replace("0.375", "0.5")
                .replace("[impacts.A]\n", &format!("[impacts.A]\n{more}")),
        );
        for by in ["kane", "lagrange"] {
            let names = ["m", "I", "a", "g", "y", "th", "vx"];
            let numbers = [3.0, 0.5, 1.0, 9.75, 0.625, 0.5, 0.5];
            let found = scene.sensitivities(&names, At::End, &how(by, "dop853")).unwrap_or_else(|e| panic!("{e}"));
            assert!(found.missing().is_none(), "{:?}", found.missing());
            for (at, (name, value)) in names.iter().zip(numbers).enumerate() {
                let run = |place: f64| {
                    let mut scene = scene.clone();
                    scene.set(name, value + place / 4096.0).unwrap();
                    scene.simulate(&how(by, "dop853")).unwrap().end
                };
                let (a, b, c, d) = (run(-2.0), run(-1.0), run(1.0), run(2.0));
                for (which, shown) in found.names.iter().take(6).enumerate() {
                    let truth = (a[which] - 8.0 * b[which] + 8.0 * c[which] - d[which]) / 12.0 * 4096.0;
                    near(found.end[at][which], truth, 1e-7, &format!("d({shown})/d({name}) {by} {more}"));
                }
            }
        }
    }
}
