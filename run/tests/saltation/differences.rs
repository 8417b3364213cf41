//! Friction that depends on the force that it presses with, against differences of whole runs.

use super::backwards::is_forwards;
use super::{Planted, difference, how};
use crate::friction::{BLOCK, FINE, on_plane};
use crate::impacts::{PLANE, scene as scene_of};
use tripos::DerivativeInstants;

/// Goal: a rod whose end slips on the floor, with friction that depends on the normal force; and a rod that falls on
/// its end at an angle, so that impulses along gap and slip are coupled. Truth: differences of whole runs.
#[test]
fn a_rod_that_slides_or_falls_on_its_end_is_differentiated_as_differences_of_runs_have_it() {
    let how = how("kane", "dop853");
    let leaning = |vx: f64| {
        format!(
            "span = [0, 0.25]\n[parameters]\nI = 1\nh = 0\n[start]\nx = 0\ny = \"sin(1.0)\"\nth = 1.0\nvx = {vx:?}\nvy = 0\nom = 0\n[impacts.A]\ngap = \"p(A) @ N [2]\"\n\
             restitution = 0\nfriction = \"e\"\nalong = \"v(A) @ N [1]\"\n{FINE}"
        )
    };
    let falling = |vx: f64, e: f64, law: &str| {
        format!(
            "span = [0, 0.3]\n[parameters]\nI = 1\ne = {e:?}\n[start]\nx = 0\ny = 1\nth = 0.9\nvx = {vx:?}\nvy = 0\nom = 0.5\n[impacts.A]\ngap = \"p(A) @ N [2]\"\n\
             restitution = \"e\"\nfriction = \"0.3 + h/a\"\nalong = \"v(A) @ N [1]\"\nlaw = \"{law}\"\n{FINE}"
        )
    };
    let cases = [
        (leaning(2.0), vec![("m", 3.0), ("I", 1.0), ("g", 9.81), ("e", 0.5), ("vx", 2.0)]),
        (leaning(-2.0), vec![("m", 3.0), ("I", 1.0), ("g", 9.81), ("e", 0.5), ("vx", -2.0)]),
        (
            falling(4.0, 0.4, "newton"),
            vec![("m", 3.0), ("I", 1.0), ("a", 1.0), ("e", 0.4), ("h", 0.0), ("vx", 4.0), ("y", 1.0)],
        ),
        (
            falling(-4.0, 0.4, "poisson"),
            vec![("m", 3.0), ("I", 1.0), ("a", 1.0), ("e", 0.4), ("h", 0.0), ("th", 0.9), ("om", 0.5)],
        ),
        (
            falling(0.125, 0.25, "poisson"),
            vec![("m", 3.0), ("I", 1.0), ("a", 1.0), ("e", 0.25), ("h", 0.0), ("vx", 0.125)],
        ),
    ];
    for (text, numbers) in cases {
        let scene = scene_of(PLANE, &text);
        let names: Vec<&str> = numbers.iter().map(|(name, _)| *name).collect();
        let found = scene.sensitivities(&names, DerivativeInstants::End, &how).unwrap_or_else(|e| panic!("{e}"));
        assert!(found.missing_derivative().is_none(), "{:?}", found.missing_derivative());
        for (name, value) in &numbers {
            for of in ["x", "th", "vx", "om"] {
                let truth = difference(&scene, of, name, *value, 1e-3, &how);
                let own = found.derivative_of(of, name).unwrap();
                assert!(
                    (own - truth).abs() <= 2e-7 * truth.abs().max(1.0),
                    "d({of})/d({name}) = {own} for {truth}: {text}"
                );
            }
        }
        is_forwards(&scene, &["x", "th", "om"], &how);
    }
}

/// Goal: a slipping contact opens where nothing presses it, and a sticking end of a rod that tips over begins to slip.
/// Truth: differences of whole runs.
#[test]
fn what_opens_as_it_slips_or_slips_as_it_tips_is_differentiated_as_differences_of_runs_have_it() {
    let how = how("kane", "dop853");
    let lift = "[forces.lift]\non = \"block\"\nframe = \"N\"\nvector = [0, 0, \"m*g*t/T\"]\n";
    let model = (BLOCK.to_owned() + lift).replace("e = {", "T = { unit = \"s\", value = 1 }\ne = {");
    let lifted = scene_of(&model, &on_plane("mu = 0.3", 0.0, 4.0, 2.0));
    let th: f64 = std::f64::consts::FRAC_PI_2 - 0.1;
    let om = -(1.5 * 9.81 * (1.0 - 0.1_f64.cos())).sqrt();
    let tips = format!(
        "span = [0, 1]\n[parameters]\nI = 1\nh = 0\n[start]\nx = 0\ny = \"sin({th:?})\"\nth = {th:?}\nvx = {:?}\nvy = {:?}\nom = {om:?}\n[impacts.A]\n\
         gap = \"p(A) @ N [2]\"\nrestitution = 0\nfriction = \"0.6*e\"\nalong = \"v(A) @ N [1]\"\n{FINE}",
        -th.sin() * om,
        th.cos() * om
    );
    let tips = scene_of(PLANE, &tips);
    let opens = [("mu", 0.3), ("g", 10.0), ("vx", 4.0), ("T", 1.0), ("m", 2.0)];
    for (scene, what, numbers, shown) in [
        (&lifted, "plane opens", &opens[..], &["x", "z", "vx", "vz"][..]),
        (&tips, "A slips", &[("e", 0.5), ("g", 9.81), ("m", 3.0), ("I", 1.0)], &["x", "th", "vx", "om"]),
    ] {
        let names: Vec<&str> = numbers.iter().map(|(name, _)| *name).collect();
        let found = scene.sensitivities(&names, DerivativeInstants::End, &how).unwrap();
        assert!(found.missing_derivative().is_none(), "{:?}", found.missing_derivative());
        let event = found.run.events().iter().position(|event| event.name == what).expect("it happens");
        assert!(found.events[event].is_some(), "its instant moves");
        for (name, value) in numbers {
            for of in shown {
                let (truth, own) =
                    (difference(scene, of, name, *value, 1e-3, &how), found.derivative_of(of, name).unwrap());
                assert!(
                    (own - truth).abs() <= 3e-7 * truth.abs().max(1.0),
                    "{what}: d({of})/d({name}) = {own} for {truth}"
                );
            }
        }
        is_forwards(scene, shown, &how);
    }
}

/// Goal: a bar that is thrown to the floor and bounces, slips and sticks on either end, or both, at random starts.
/// Truth: differences of whole runs; backwards as forwards.
#[test]
fn a_bar_thrown_at_random_is_differentiated_as_differences_of_runs_have_it() {
    let (mut planted, mut impacts, mut known) = (Planted(77), 0, 0);
    for case in 0..10 {
        let foot = |name: &str| {
            format!(
                "[impacts.{name}]\ngap = \"p({name}) @ N [2]\"\nrestitution = \"e\"\nfriction = \"h + 0.25\"\nalong = \"v({name}) @ N [1]\"\nlaw = \"{}\"\n",
                ["poisson", "newton"][case % 2]
            )
        };
        let e = if case % 2 == 0 { planted.next(0.2, 0.6) } else { 0.0 };
        let (th, vx, om) = (planted.next(-0.5, 0.5), planted.next(-2.0, 2.0), planted.next(-3.0, 3.0));
        let text = format!(
            "span = [0, 0.75]\n[parameters]\nI = 0.75\ne = {e:?}\nh = 0.0625\n[start]\nx = 0\ny = 0.9\nth = {th:?}\nvx = {vx:?}\nvy = 0\nom = {om:?}\n{}{}{FINE}",
            foot("A"),
            foot("B")
        );
        let scene = scene_of(PLANE, &text);
        let how = how(["kane", "lagrange"][case % 2], "dop853");
        let run = scene.simulate(&how).unwrap();
        if run.failure().is_some() {
            continue;
        }
        impacts += run.impacts().len();
        let found = scene.sensitivities(&["vx", "g", "h"], DerivativeInstants::End, &how).unwrap();
        assert!(found.missing_derivative().is_none(), "{case}: {:?}", found.missing_derivative());
        for (by, value) in [("vx", vx), ("g", 9.81), ("h", 0.0625)] {
            for of in ["x", "th", "om"] {
                let (own, truth) =
                    (found.derivative_of(of, by).unwrap(), difference(&scene, of, by, value, 1e-5, &how));
                assert!(
                    (own - truth).abs() <= 1e-5 * truth.abs().max(1.0),
                    "{case}: d({of})/d({by}) = {own} for {truth}"
                );
            }
        }
        known += 1;
        is_forwards(&scene, &["x", "om"], &how);
    }
    assert!(impacts > 40 && known >= 8, "{impacts} {known}");
}
