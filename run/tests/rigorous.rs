//! Rigorous runs against exact solutions, references in 32 digits, and one another.

use crate::{BOUNCER, SWING};
use tripos::{Error, Mechanism, RigorousRequest, RigorousScene, Scene, enclose_scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::InitialMotion;
use tripos_sim::rigorous_run::{RigorousEnd, RigorousOptions};
use tripos_traits::{Ball, DoubleDouble, Scalar};

fn scene_of(model: &str, scene: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|e| panic!("{e}"))
}

fn library_scene(path: &str) -> Scene {
    let path = format!("{}/../models/{path}.toml", env!("CARGO_MANIFEST_DIR"));
    Scene::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn enclosed(scene: &Scene, by: Option<&str>, parts: usize, claims: &[&str]) -> Result<RigorousScene, Error> {
    enclosed_with(scene, &[], by, parts, claims)
}

/// Encloses a scene in which some numbers are replaced, as (name, value).
fn enclosed_with(
    scene: &Scene,
    set: &[(String, f64)],
    by: Option<&str>,
    parts: usize,
    claims: &[&str],
) -> Result<RigorousScene, Error> {
    let by = by.map(Into::into);
    let claims: Vec<String> = claims.iter().map(|&claim| claim.to_owned()).collect();
    let options = RigorousOptions::default();
    let request = RigorousRequest { by: by.as_ref(), set, parts, claims: &claims, options };
    enclose_scene(scene.mechanism(), scene.description(), &request)
}

fn ball(found: &RigorousScene, at: usize, name: &str) -> Ball {
    found.boxes[at][found.names.iter().position(|n| n == name).expect("a shown quantity")]
}

/// Goal: boxes contain the motion. Method: a mass on a spring, x = 0.5 cos 2 t, is enclosed by its formula in balls.
#[test]
fn boxes_contain_the_exact_motion_of_a_spring() {
    let scene = scene_of(BOUNCER, SWING);
    for by in [None, Some("kane"), Some("lagrange")] {
        let found = enclosed(&scene, by, 7, &["x < 0.5 + 1e-6", "x < 0.4", "x > 0"]).unwrap();
        assert_eq!((found.run.end, found.boxes.len()), (RigorousEnd::Reached, 7));
        for (at, part) in (1..=7).enumerate() {
            let t = Ball::ratio(10 * part, 7);
            let truth = Ball::<DoubleDouble>::ratio(1, 2) * (t + t).sin_cos().1;
            let x = ball(&found, at, "x");
            assert!(x.contains(truth) && x.radius < 1e-24, "{by:?}, part {at}: {x:?} against {truth:?}");
        }
        let range = found.ranges[found.names.iter().position(|n| n == "x").unwrap()];
        assert!(range.lo() <= -0.5 && range.hi() >= 0.5 && range.hi() < 0.51, "{range:?}");
        let [(_, kept), (_, broken), (_, crossed)] = found.claims.as_slice() else { panic!("three claims") };
        assert!(kept.is_proved() && kept.refuted_by.is_none());
        assert!(broken.proved_to.is_none() && broken.refuted_by.is_some_and(|t| t < 0.2));
        let (to, by) = (crossed.proved_to.unwrap(), crossed.refuted_by.unwrap());
        assert!(to < std::f64::consts::FRAC_PI_4 && std::f64::consts::FRAC_PI_4 < by && by - to < 0.3, "{to} {by}");
    }
}

/// Goal: boxes contain the certified states. Method: references in 32 digits by another integrator, whose stated error
/// is added to the radius ten times. A reference rounds speeds such as 2.02 sqrt(g/l) to doubles; the boxes get the
/// same.
#[test]
fn boxes_contain_the_references() {
    for (path, widest) in [
        ("pendulum/scenes/over", 1e-20),
        ("disk/scenes/report", 1e-20),
        ("chaotic_pendulum/scenes/swing", 1e-20),
        ("spherical_pendulum/scenes/wide", 1e-20),
        ("knife_edge/scenes/cycloid", 1e-20),
    ] {
        let scene = library_scene(path);
        let (model, start) = (scene.mechanism(), scene.description());
        let speeds = model.speeds.iter().map(|s| s.name.clone()).zip(start.u.iter().copied());
        let doubles: Vec<(String, f64)> = match &start.exact.motion {
            InitialMotion::Speeds(_) => speeds.collect(),
            InitialMotion::Rates(_) => Vec::new(),
        };
        let found = enclosed_with(&scene, &doubles, None, 2, &[]).unwrap_or_else(|e| panic!("{path}: {e}"));
        assert_eq!(found.run.end, RigorousEnd::Reached, "{path}");
        let names = tripos::state_names(scene.mechanism());
        let reference = scene.reference(&found.t).unwrap_or_else(|e| panic!("{path}: {e}"));
        for (at, state) in reference.states.iter().enumerate() {
            let size = state.iter().fold(1.0, |most: f64, x| most.max(x.hi().abs()));
            for (x, name) in state.iter().zip(&names) {
                let found = ball(&found, at, name);
                let error = 10.0 * reference.uncertainty * size;
                let distance = (Ball::point(*x) - Ball::point(found.centre)).size();
                assert!(distance <= found.radius + error, "{path}: {name} = {x}, {found:?}");
                assert!(found.radius < widest * size, "{path}: {name} has the radius {}", found.radius);
            }
        }
    }
}

/// Goal: reduced and whole equations enclose the same motion. Method: their boxes of the report's disk have common
/// points, and each is much narrower than any error of a run in doubles.
#[test]
fn formulations_enclose_the_same_motion() {
    let scene = library_scene("disk/scenes/report");
    let boxes: Vec<RigorousScene> =
        [None, Some("kane"), Some("lagrange")].iter().map(|by| enclosed(&scene, *by, 2, &[]).unwrap()).collect();
    for other in &boxes[1..] {
        for at in 0..2 {
            for name in ["q1", "q2", "q3", "q4", "q5"] {
                let (a, b) = (ball(&boxes[0], at, name), ball(other, at, name));
                let gap = (Ball::point(a.centre) - Ball::point(b.centre)).size();
                assert!(gap <= a.radius + b.radius && a.radius + b.radius < 1e-17, "{name}: {a:?} and {b:?}");
            }
        }
    }
}

/// Goal: starts that are solved for are proved. Method: two linkages whose loops close at the start, one whose stated
/// coordinates close it exactly, and a disc that rolls, each against an ordinary run at 1e-12.
#[test]
fn solved_starts_are_proved() {
    for path in [
        "slider_crank/scenes/coasting",
        "four_bar/scenes/crossed",
        "cartesian_pendulum/scenes/released",
        "rolling_disc/scenes/roll",
    ] {
        let scene = library_scene(path);
        let found = enclosed(&scene, Some("kane"), 1, &[]).unwrap_or_else(|e| panic!("{path}: {e}"));
        assert_eq!(found.run.end, RigorousEnd::Reached, "{path}");
        assert!(found.boxes[0].iter().all(|x| x.radius < 1e-18), "{path}: {:?}", found.boxes[0]);
        let run = scene.simulate(&tripos::Overrides { rtol: Some(1e-12), ..Default::default() }).unwrap();
        for (x, name) in found.boxes[0].iter().zip(&found.names) {
            let end = *run.column_of_quantity(name).unwrap().last().unwrap();
            assert!((end - x.centre.hi()).abs() < 1e-8 * end.abs().max(1.0), "{path}, {name}: {end} against {x:?}");
        }
    }
}

#[test]
fn what_is_not_enclosed_is_refused_or_ends() {
    let scene = scene_of(BOUNCER, SWING);
    let refused = enclosed(&scene, None, 1, &["y < 1"]).unwrap_err().to_string();
    assert!(refused.contains("is about no shown quantity"), "{refused}");
    let refused = enclosed(&scene, None, 1, &["x = 1"]).unwrap_err().to_string();
    assert!(refused.contains("is not understood"), "{refused}");
    let refused = enclosed(&scene, None, 1, &["x < sqrt(-1)"]).unwrap_err().to_string();
    assert!(refused.contains("--claim"), "{refused}");
    // x'' = x² /m from x = 1 ends in finite time.
    let model = BOUNCER.replace("\"-k*x\"", "\"k*x^2\"").replace("N/m\"", "N/m^2\"");
    let found = enclosed(&scene_of(&model, SWING), None, 1, &["x > 0"]).unwrap();
    assert!(found.boxes.is_empty() && found.run.end != RigorousEnd::Reached);
    let (_, verdict) = &found.claims[0];
    assert!(!verdict.is_proved() && verdict.refuted_by.is_none() && verdict.proved_to.is_some_and(|t| t > 1.0));
    assert!(found.run.t_end > 1.0 && found.run.t_end < 4.0, "{}", found.run.t_end);
}
