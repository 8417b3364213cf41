//! Contacts that are just touched, and contacts that are nearly touched.

use super::{FINE, Planted};
use crate::impacts::scene as scene_of;
use crate::saltation::balls::BALL;
use crate::sensitivity::near;
use tripos::{DerivativeInstants, Overrides, Scene};

const WHY: &str = "is touched without a closing velocity";

/// A pendulum whose bob is stopped at an angle.
const PENDULUM: &str = r#"
name = "Pendulum with a stop"
[parameters]
m = { unit = "kg", value = 2, positive = true }
l = { unit = "m", value = 0.7, positive = true }
g = { unit = "m/s^2", value = 9.81 }
stop = { unit = "rad", value = 1 }
e = { unit = "1", value = 0.75 }
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Checks that there are derivatives by the numbers `with` to the end, and by the numbers `without` none, because
/// something is only touched. This holds forwards and backwards alike.
fn ends(scene: &Scene, with: &[&str], without: &[&str], of: &str, case: &str) {
    let all = [with, without].concat();
    let found = scene.sensitivities(&all, DerivativeInstants::Samples, &Overrides::default()).unwrap();
    let back = scene.gradient(of, &Overrides::default()).unwrap();
    assert!(found.run.failure().is_none(), "{case}: {:?}", found.run.failure());
    for (at, name) in all.iter().enumerate() {
        let why = found.ended[at].as_ref();
        assert_eq!(&back.slope_by(name).unwrap().missing, &found.ended[at], "{case}: `{name}`, backwards as forwards");
        if with.contains(name) {
            assert!(why.is_none() && found.end[at].iter().all(|x| x.is_finite()), "{case}: `{name}`: {why:?}");
        } else {
            assert!(why.is_some_and(|why| why.contains(WHY)), "{case}: `{name}`: {why:?}, {:?}", found.end[at]);
            assert!(found.end[at].iter().all(|x| x.is_nan()), "{case}: `{name}` has no derivative");
            assert!(found.samples[at][0].iter().all(|x| x.is_finite()), "{case}: `{name}` has one before");
        }
    }
}

/// Goal: derivatives are given where they exist and nowhere else. Method: balls thrown up until they just touch a
/// ceiling at w²/(2 g), by exact parabolas, along which steps and samples may end anywhere. Pendulums swing up until
/// they just touch a stop at cos q = cos q₀ − u² l/(2 g), which steps follow only to their tolerance. A touch is
/// undecided for numbers that change the height or the way up to it, and for no others.
#[test]
fn a_touch_ends_derivatives_by_what_would_move_it() {
    let mut planted = Planted(11);
    for case in 0..8 {
        let (w, g) = (planted.next(2.0, 6.0), planted.next(5.0, 12.0));
        let text = format!(
            "span = [0, {:?}]\n[start]\nx = 0\nz = 0\nv = 1\nw = {w:?}\n[parameters]\ng = {g:?}\nL = {:?}\n{FINE}[impacts.ceiling]\ngap = \"L - z\"\nrestitution = \"e\"\n",
            1.5 * w / g,
            w * w / (2.0 * g),
        );
        let case = format!("ball {case}");
        ends(&scene_of(BALL, &text), &["x", "v", "m"], &["w", "g", "L", "z"], "z", &case);
    }
    for case in 0..4 {
        let (q, u) = (planted.next(-0.4, 0.4), planted.next(1.0, 4.0));
        let stop = (q.cos() - u * u * 0.7 / (2.0 * 9.81)).acos();
        let text = format!(
            "span = [0, 1.2]\n[start]\nq = {q:?}\nu = {u:?}\n[parameters]\nstop = {stop:?}\n{FINE}[impacts.stop]\ngap = \"stop - q\"\nrestitution = \"e\"\n"
        );
        let case = format!("pendulum {case}");
        ends(&scene_of(PENDULUM, &text), &["m"], &["u", "q", "l", "g", "stop"], "q", &case);
    }
}

/// Goal: a near touch is not a touch. Truth: a ball that stays below a ceiling flies as without one. One that is thrown
/// a little faster meets it at the root of a parabola, and comes down with e times its speed: d(w after)/d(w) = e w/v +
/// e w (1/v − 1/w)…, here by differences of the closed form.
#[test]
fn what_is_nearly_touched_has_derivatives() {
    let (g, e) = (8.0, 0.5);
    let end = |w: f64, l: f64| {
        let v = w * w - 2.0 * g * l;
        if v <= 0.0 {
            return w - g * 0.8;
        }
        let (v, t) = (v.sqrt(), (w - v.sqrt()) / g);
        -e * v - g * (0.8 - t)
    };
    for (w, l) in [(4.0, 1.0 + 1e-5), (4.0, 1.0 - 1e-5), (4.0, 1.0 - 0.2)] {
        let text = format!(
            "span = [0, 0.8]\n[start]\nx = 0\nz = 0\nv = 1\nw = {w:?}\n[parameters]\ng = {g:?}\nL = {l:?}\n{FINE}[impacts.ceiling]\ngap = \"L - z\"\nrestitution = \"e\"\n"
        );
        let found =
            scene_of(BALL, &text).sensitivities(&["w", "L"], DerivativeInstants::End, &Overrides::default()).unwrap();
        assert!(found.missing_derivative().is_none(), "{l}: {:?}", found.missing_derivative());
        let h = 1e-8;
        let by_w = (end(w + h, l) - end(w - h, l)) / (2.0 * h);
        let by_l = (end(w, l + h) - end(w, l - h)) / (2.0 * h);
        near(found.derivative_of("w", "w").unwrap(), by_w, 1e-4 * by_w.abs().max(1.0), "w");
        near(found.derivative_of("w", "L").unwrap(), by_l, 1e-4 * by_l.abs().max(1.0), "L");
    }
}
