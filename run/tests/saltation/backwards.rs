//! Gradients through impacts, against closed forms and derivatives carried forwards.

use super::{FINE, Planted, difference, how, truth};
use crate::impacts::{PLANE, block, scene as scene_of};
use crate::saltation::balls::{BALL, PLATE, ROW, ball, bounced, plate};
use crate::sensitivity::near;
use tripos::studies::sensitivity::gradient::Slope;
use tripos::{DerivativeInstants, Overrides, Scene};

/// Checks that gradients of the quantities of these names agree with forward derivatives, by all numbers of the scene,
/// within the stated errors. Where one of them is missing the other is missing too, for the same reason. The run equals
/// the one without derivatives.
pub fn is_forwards(scene: &Scene, shown: &[&str], how: &Overrides) {
    for of in shown {
        let found = scene.gradient(of, how).unwrap_or_else(|error| panic!("{of}: {error}"));
        assert!(found.run.failure().is_none(), "{:?}", found.run.failure());
        let how = Overrides { method: Some(found.scene.integration.method), ..how.clone() };
        let plain = scene.simulate(&how).unwrap();
        assert_eq!(found.run.states, plain.states, "a run with a gradient is the run without");
        assert_eq!(found.run.solution.work, plain.solution.work);
        assert_eq!((found.run.impacts(), found.run.events()), (plain.impacts(), plain.events()));
        let (with, without): (Vec<&Slope>, Vec<&Slope>) =
            found.slopes.iter().partition(|slope| slope.missing.is_none());
        for slope in without {
            assert!(slope.value.is_nan(), "{slope:?}");
            match scene.sensitivities(&[&slope.by], DerivativeInstants::End, &how) {
                Ok(forwards) => assert_eq!(slope.missing, forwards.ended[0], "{slope:?}"),
                Err(refused) => assert!(refused.to_string().contains(slope.missing.as_ref().unwrap()), "{slope:?}"),
            }
        }
        let names: Vec<&str> = with.iter().map(|slope| slope.by.as_str()).collect();
        if names.is_empty() {
            continue;
        }
        let forwards = scene.sensitivities(&names, DerivativeInstants::End, &how).unwrap();
        let place = forwards.names.iter().position(|name| name == of).unwrap();
        for (at, slope) in with.into_iter().enumerate() {
            let truth = forwards.end[at][place];
            let stated = forwards.errors.as_ref().map_or(0.0, |list| list[at][place]) + slope.error.unwrap_or(0.0);
            let size = truth.abs().max(1.0);
            let off = (slope.value - truth).abs();
            let what = format!("d({of})/d({}) = {} and {truth}", slope.by, slope.value);
            assert!(
                off <= 1e-8 * size && off <= 30.0 * stated + 1e-11 * size,
                "{what}: off by {off:e}, not {stated:e}"
            );
            assert_eq!(slope.unit, forwards.units[at][place], "{what}");
        }
    }
}

/// Goal: height and speed of a ball after its bounces, by all numbers that they depend on. Truth: the closed form in 32
/// digits, at 12 random points, by either law, all formulations and all methods with a sweep.
#[test]
fn a_ball_has_the_gradient_of_its_closed_form_through_its_bounces() {
    let mut planted = Planted(17);
    for case in 0..12 {
        let values = [
            planted.next(5.0, 12.0),
            planted.next(0.9, 1.0),
            planted.next(0.5, 2.0),
            planted.next(-1.0, 2.0),
            planted.next(-0.5, 0.25),
        ];
        let (law, method) = (["newton", "poisson"][case % 2], ["dop853", "ode45", "dopri5"][case % 3]);
        let scene = scene_of(BALL, &ball(&values, 1.5, law));
        let how = how(["kane", "lagrange", "newton-euler"][case % 3], method);
        let all = truth(&values, &|numbers| bounced(numbers, 1.5).0);
        for (place, of) in ["z", "w"].into_iter().enumerate() {
            let found = scene.gradient(of, &how).unwrap_or_else(|e| panic!("{e}"));
            assert!(found.missing().is_none() && found.run.failure().is_none(), "{:?}", found.missing());
            for (at, by) in ["g", "e", "z", "w", "L"].into_iter().enumerate() {
                let slope = found.slope_by(by).unwrap();
                let (truth, stated) = (all[at][place], slope.error.expect("a second run comes to the end"));
                let off = (slope.value - truth).abs();
                assert!(off <= 1e-9 * truth.abs().max(1.0), "{method} d({of})/d({by}) = {} for {truth}", slope.value);
                assert!(off <= 30.0 * stated + 1e-13 * truth.abs().max(1.0), "{by}: {off:e}, not {stated:e}");
            }
            near(found.slope_by("m").unwrap().value, 0.0, 1e-12, "the mass");
            near(found.slope_by("v").unwrap().value, 0.0, 1e-12, "the speed along the floor");
        }
    }
}

/// Goal: bodies that come to rest after bounces, that are held and leave, that pass impacts through a row, or that
/// land: backwards as forwards, with reasons where there is no derivative.
#[test]
fn a_gradient_through_contacts_is_what_derivatives_forwards_are() {
    let plain = how("kane", "dop853");
    is_forwards(&scene_of(BALL, &ball(&[10.0, 0.625, 1.0, 0.0, 0.25], 3.0, "newton")), &["z", "x", "w"], &plain);
    let leaves = format!(
        "span = [0, 0.21875]\n[start]\nx = 0\nz = 0\nv = 1\nw = \"A*k\"\n[parameters]\nA = 0.1\nk = 12\ng = 9.5\n{FINE}{PLATE}"
    );
    for (by, method) in [("kane", "dop853"), ("lagrange", "ode45")] {
        is_forwards(&scene_of(&plate(), &leaves), &["z", "w"], &how(by, method));
    }
    for law in ["newton", "poisson"] {
        let row = format!(
            "span = [0, 1.25]\n[start]\nx1 = -1\nx2 = 0\nx3 = 0\nu1 = 2\nu2 = 0\nu3 = 0\n[parameters]\ne = 0.375\n{FINE}\
             [impacts.ab]\ngap = \"x2 - x1\"\nrestitution = \"e\"\nlaw = \"{law}\"\n[impacts.bc]\ngap = \"x3 - x2\"\nrestitution = \"e\"\nlaw = \"{law}\"\n"
        );
        is_forwards(&scene_of(ROW, &row), &["x1", "u3"], &plain);
    }
    let rod = |th: f64, om: f64, e: f64| {
        let contact = |name: &str| format!("[impacts.{name}]\ngap = \"p({name}) @ N [2]\"\nrestitution = {e:?}\n");
        let text = format!(
            "span = [0, 0.6]\n[start]\nx = 0\ny = 1\nth = {th:?}\nvx = 1\nvy = 0\nom = {om:?}\n{FINE}{}{}",
            contact("A"),
            contact("B")
        );
        scene_of(PLANE, &text)
    };
    for scene in [rod(0.25, 0.0, 0.5), rod(0.0, 0.0, 0.5), rod(0.0, 0.0, 0.0), rod(0.5, 1.0, 0.0)] {
        is_forwards(&scene, &["y", "om"], &plain);
    }
}

/// Goal: a mechanism with a loop that hits a stop, and a block that rocks from corner to corner without slipping, in
/// speeds and in all rates. Truth: differences of whole runs; backwards as forwards.
#[test]
fn loops_and_contacts_that_do_not_slip_are_differentiated_in_speeds_and_in_rates() {
    let crank = format!(
        "span = [0, 0.09]\n[start]\nq = 0.3\nu = 60\n[guess]\np = 0\ny = 0.2\n[impacts.stop]\ngap = \"y - 3*r\"\nrestitution = 0.6\n{FINE}"
    );
    let crank = scene_of(include_str!("../../../models/slider_crank/model.toml"), &crank);
    let rocks = scene_of(PLANE, &block(0.12, 1.2, 0.0));
    for (scene, of, by, value) in [
        (&crank, "u", "u", 60.0),
        (&crank, "q", "r", f64::NAN),
        (&rocks, "om", "g", 9.81),
        (&rocks, "th", "I", f64::NAN),
    ] {
        for formulation in ["kane", "lagrange"] {
            let how = how(formulation, "dop853");
            is_forwards(scene, &[of], &how);
            if value.is_finite() {
                let (own, truth) = (
                    scene.gradient(of, &how).unwrap().slope_by(by).unwrap().value,
                    difference(scene, of, by, value, 1e-3, &how),
                );
                assert!(
                    (own - truth).abs() <= 3e-7 * truth.abs().max(1.0),
                    "{formulation} d({of})/d({by}) = {own} for {truth}"
                );
            }
        }
    }
}

/// Goal: an event ends a run between bounces, and its instant moves. Truth: after one bounce a ball that fell from h
/// over a floor at L is highest at t = √(2 (h − L)/g) (1 + 2 c) with c = e², at L + c² (h − L) more.
#[test]
fn an_event_after_a_bounce_moves_with_every_number() {
    let (g, e, h, floor) = (8.0_f64, 0.75_f64, 1.5_f64, 0.25_f64);
    let top = "[[events]]\nname = \"top\"\nzero = \"w\"\ndirection = \"falling\"\nterminal = true\n";
    let scene = scene_of(BALL, &(ball(&[g, e, h, 0.0, floor], 3.0, "newton") + top));
    let of_t = scene.gradient("t", &Overrides::default()).unwrap();
    let of_z = scene.gradient("z", &Overrides::default()).unwrap();
    assert!(of_t.is_total && of_t.run.impacts().len() == 1, "{:?}", of_t.run.events());
    let (c, fall) = (e * e, (2.0 * (h - floor) / g).sqrt());
    near(of_t.run.solution.t_end, fall * (1.0 + c), 1e-10, "the instant");
    for (by, in_t, in_z) in [
        ("g", -fall * (1.0 + c) / (2.0 * g), 0.0),
        ("e", 2.0 * e * fall, 4.0 * e * c * (h - floor)),
        ("z", (1.0 + c) / (g * fall), c * c),
        ("L", -(1.0 + c) / (g * fall), 1.0 - c * c),
    ] {
        near(of_t.slope_by(by).unwrap().value, in_t, 1e-10, by);
        near(of_z.slope_by(by).unwrap().value, in_z, 1e-10, by);
    }
}
