//! Jumps and bends of drives at instants that move.

use super::{FINE, Planted, Wide, how, largest_error, truth, wide};
use crate::impacts::scene as scene_of;
use crate::sensitivity::near;
use tripos::{DerivativeInstants, Overrides};
use tripos_traits::{Real, Scalar};

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

fn driven(values: &[f64], more: &str) -> String {
    let [m, k, a, c, x] = values[..] else { panic!("five") };
    format!(
        "span = [0, 3]\n[start]\nx = {x:?}\nv = 0\n[parameters]\nm = {m:?}\nk = {k:?}\na = {a:?}\nc = {c:?}\n{FINE}{more}"
    )
}

/// Closed form of x and v at t of m x'' + k x = a sign(t − T), T = 10/c, from x₀ at rest: x = x₀ cos ωt − A (1 − cos
/// ωt) + 2A (1 − cos ω(t − T)) with A = a/k, the last term from T on.
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

/// Goal: the instant of a jump moves, and the derivatives jump with it, by every method whose steps end there. Truth:
/// the closed form, at 24 random points of all numbers.
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
        let found = scene.sensitivities(&DRIVE, DerivativeInstants::End, &how).unwrap_or_else(|e| panic!("{e}"));
        let worst = largest_error(&found, &["x", "v"], &values, &|numbers| switched(numbers, 3.0));
        assert!(worst < if loose.is_some() { 1e-6 } else { 1e-10 }, "{method} {by} {values:?}: {worst:e}");
    }
}

/// Goal: samples have the derivatives of their own instants: before the switch those without it, from it on those after
/// it. Events during the run move accordingly.
#[test]
fn samples_and_events_beside_a_switch_have_the_slopes_of_their_side() {
    let values = [2.0, 18.0, 3.0, 7.0, 0.75];
    let more = "[[events]]\nname = \"passes\"\nzero = \"x\"\n";
    let scene = scene_of(DRIVEN, &driven(&values, more));
    let found = scene.sensitivities(&DRIVE, DerivativeInstants::Samples, &Overrides::default()).unwrap();
    let solution = &found.run.solution;
    let after = solution.t.iter().position(|t| *t >= 10.0 / 7.0).unwrap();
    let column = |name: &str| found.names.iter().position(|known| known == name).unwrap();
    let (x, v) = (column("x"), column("v"));
    assert!((solution.t[after] - 10.0 / 7.0).abs() < 1e-15 && after > 3 && after + 3 < solution.t.len());
    for (at, t) in solution.t.iter().enumerate() {
        // The derivatives at the switch itself are those after it.
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
    // The count is that of sign changes of the closed form between three thousand instants.
    let place = |step: u32| switched(&values.map(wide), f64::from(step) / 1000.0)[0].to_f64();
    let crossings =
        (0..3000).filter(|step| place(*step).is_sign_negative() != place(step + 1).is_sign_negative()).count();
    assert!(crossings > 1 && found.events.len() == crossings, "{crossings} {:?}", found.run.events());
    for (event, moves) in found.run.events().iter().zip(&found.events) {
        let slopes = truth(&values, &|numbers| switched(numbers, event.t));
        let speed = switched(&values.map(wide), event.t)[1].to_f64();
        for (by, list) in slopes.iter().enumerate() {
            near(moves.as_ref().unwrap()[by], -list[0] / speed, 1e-9, &format!("dt/d({}) at {}", DRIVE[by], event.t));
        }
    }
}

/// Goal: a moving bend is differentiated. Truth: m x'' + k x = a |c t − 10|, whose derivative by c is the response to a
/// t sign(c t − 10); by differences of the closed form.
#[test]
fn a_force_with_a_bend_that_moves_is_differentiated() {
    let model = DRIVEN.replace("a*sign(c*t - 10)", "a*abs(c*t - 10)");
    let closed = |numbers: &[Wide]| {
        let [m, k, a, c, x] = numbers[..] else { panic!("five") };
        let (w, t, one) = ((k / m).sqrt(), wide(3.0), wide(1.0));
        let (s, co) = (w * t).sin_cos();
        let bend = wide(10.0) / c;
        // The drive is a (10 − c t), and 2 a c (t − T) from T on.
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
        let found =
            scene.sensitivities(&DRIVE, DerivativeInstants::End, &how("kane", ["dop853", "ode45"][case % 2])).unwrap();
        let worst = largest_error(&found, &["x"], &values, &closed);
        assert!(worst < 1e-10, "{values:?}: {worst:e}");
    }
}

/// Goal: a table whose knots move is differentiated: a force that rises from 0 at T to b at T + d and stays. Truth: the
/// closed form of an oscillator under ramps.
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
    let found = scene_of(&model, &text).sensitivities(&names, DerivativeInstants::End, &Overrides::default()).unwrap();
    let closed = |numbers: &[Wide]| {
        let [m, k, d, c, x, at] = numbers[..] else { panic!("six") };
        let (w, t) = ((k / m).sqrt(), wide(3.0));
        let from = |at: Wide| c / k * (t - at - (w * (t - at)).sin_cos().0 / w);
        vec![x * (w * t).sin_cos().1 + from(at) - from(at + d)]
    };
    let worst = largest_error(&found, &["x"], &values, &closed);
    assert!(worst < 1e-10, "{worst:e}");
}

/// Goal: cases without a derivative are refused: jumps that are moved apart, or in and out of the span, and steps that
/// go across.
#[test]
fn jumps_without_a_derivative_are_refused() {
    let values = [2.0, 18.0, 3.0, 5.0, 0.75];
    let refused = |model: &str, text: &str, by: &str, method: &str| {
        let how = Overrides { step: (method == "rk4").then_some(0.01), ..how("kane", method) };
        match scene_of(model, text).sensitivities(&[by], DerivativeInstants::End, &how) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("{by} is differentiated by"),
        }
    };
    let text = driven(&values, "");
    assert!(refused(DRIVEN, &text, "c", "rk4").contains("steps of equal length cross this instant"));
    let end = refused(DRIVEN, &text.replace("[0, 3]", "[0, 2]"), "c", "dop853");
    assert!(end.contains("into the span or out of it"), "{end}");
    let two = DRIVEN.replace("a*sign(c*t - 10)", "a*sign(c*t - 10) + a*sign(5*t - 10)").replace("5*t - 10", "t - m");
    let two = two.replace("t - m", "t - T").replace("[coordinates]", "T = { unit = \"s\", value = 2 }\n[coordinates]");
    let apart = refused(&two, &text, "c", "dop853");
    assert!(apart.contains("separates the jumps"), "{apart}");
    let scene = scene_of(&two, &text);
    assert!(
        scene.sensitivities(&["k", "a"], DerivativeInstants::End, &Overrides::default()).is_ok(),
        "neither moves a jump"
    );
}
