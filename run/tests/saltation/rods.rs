//! Rods that land on their ends.

use super::balls::bounced;
use super::{FINE, Planted, Wide, how, largest_error, wide};
use crate::impacts::{PLANE, scene as scene_of};
use crate::sensitivity::near;
use tripos::{DerivativeInstants, Overrides};
use tripos_traits::Scalar;

fn rod(values: &[f64], more: &str) -> String {
    let [m, i, a, g, e, y, th] = values[..] else { panic!("seven") };
    format!(
        "span = [0, 0.375]\n[start]\nx = 0\ny = {y:?}\nth = {th:?}\nvx = 0.5\nvy = 0\nom = 0\n[parameters]\nm = {m:?}\nI = {i:?}\na = {a:?}\ng = {g:?}\ne = {e:?}\n{FINE}{more}"
    )
}

const ROD: [&str; 7] = ["m", "I", "a", "g", "e", "y", "th"];
const FLOOR_A: &str = "[impacts.A]\ngap = \"p(A) @ N [2]\"\nrestitution = \"e\"\n";
const FLOOR_B: &str = "[impacts.B]\ngap = \"p(B) @ N [2]\"\nrestitution = \"e\"\n";

/// Goal: an impact off the centre, by masses, lengths and the angle. Truth: J = (1 + e) v/(1/m + a² cos² th/I), then y
/// = y₁ + (J/m − v) τ − g τ²/2 and th − J a cos th τ/I; by Kane and Lagrange, at 16 random points.
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
        let found =
            scene.sensitivities(&ROD, DerivativeInstants::End, &how(["kane", "lagrange"][case % 2], "dop853")).unwrap();
        assert_eq!(found.run.impacts().len(), 1, "{values:?}");
        let worst = largest_error(&found, &["y", "th", "vy", "om"], &values, &closed);
        assert!(worst < 1e-10, "{values:?}: {worst:e}");
    }
}

/// Goal: both ends land at once and are differentiated by numbers that keep them together. Where the angle moves them
/// apart the reason is given. Truth: the ball's closed form, since a rod that lands flat does not turn.
#[test]
fn a_rod_that_falls_flat_is_differentiated_by_what_keeps_it_flat() {
    let values = [3.0, 0.5, 1.0, 9.75, 0.625, 0.25, 0.0];
    for law in ["newton", "poisson"] {
        let floors = format!("{FLOOR_A}law = \"{law}\"\n{FLOOR_B}law = \"{law}\"\n");
        let scene = scene_of(PLANE, &rod(&values, &floors));
        let found = scene.sensitivities(&ROD[..6], DerivativeInstants::End, &Overrides::default()).unwrap();
        assert_eq!(found.run.impacts().len(), 1);
        let closed =
            |numbers: &[Wide]| bounced(&[numbers[3], numbers[4].sqrt(), numbers[5], wide(0.0), wide(0.0)], 0.375).0;
        let worst = largest_error(&found, &["y", "vy"], &values[..6], &closed);
        assert!(worst < 1e-11, "{law}: {worst:e}");
        let apart = scene.sensitivities(&["g", "th"], DerivativeInstants::Samples, &Overrides::default()).unwrap();
        let why = apart.missing_derivative().expect("the angle moves the ends apart");
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

/// Goal: a rod that lands on one end and stays on it, held by a force that turns it. Truth: differences of runs without
/// derivatives, which are right to some 1e-8.
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
            let found = scene
                .sensitivities(&names, DerivativeInstants::End, &how(by, "dop853"))
                .unwrap_or_else(|e| panic!("{e}"));
            assert!(found.missing_derivative().is_none(), "{:?}", found.missing_derivative());
            for (at, (name, value)) in names.iter().zip(numbers).enumerate() {
                let run = |place: f64| {
                    let mut scene = scene.clone();
                    scene.set_number(name, value + place / 4096.0).unwrap();
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
