//! Rigorous runs against exact solutions, references in 32 digits, and one another.

use crate::{BOUNCER, SWING};
use tripos::{CrossingCount, EnclosedInstants, Error, Mechanism, RigorousRequest, RigorousScene, Scene, enclose_scene};
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
    let request = RigorousRequest {
        by: by.as_ref(),
        set,
        instants: EnclosedInstants::Parts(parts),
        claims: &claims,
        operation_limit: u64::MAX,
        options,
    };
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
        assert!(to <= std::f64::consts::FRAC_PI_4 && std::f64::consts::FRAC_PI_4 < by && by - to < 0.3, "{to} {by}");
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
    assert!(refused.contains("--claim") && refused.contains("`y`"), "{refused}");
    let refused = enclosed(&scene, None, 1, &["x = 1"]).unwrap_err().to_string();
    assert!(refused.contains("is not understood"), "{refused}");
    let refused = enclosed(&scene, Some("reduced"), 1, &["determinant > 0"]).unwrap_err().to_string();
    assert!(refused.contains("needs the mass matrix of whole equations"), "{refused}");
    // x'' = x² /m from x = 1 ends in finite time.
    let model = BOUNCER.replace("\"-k*x\"", "\"k*x^2\"").replace("N/m\"", "N/m^2\"");
    let found = enclosed(&scene_of(&model, SWING), None, 1, &["x > 0"]).unwrap();
    assert!(found.boxes.is_empty() && found.run.end != RigorousEnd::Reached);
    let (_, verdict) = &found.claims[0];
    assert!(!verdict.is_proved() && verdict.refuted_by.is_none() && verdict.proved_to.is_some_and(|t| t > 1.0));
    assert!(found.run.t_end > 1.0 && found.run.t_end < 4.0, "{}", found.run.t_end);
}

/// The spring with events and claims: x = 0.5 cos 2 t, v = −sin 2 t, T + V = 1 J, and the mass matrix is m = 2 kg.
fn spring_with(outputs: &str, tables: &str) -> Scene {
    let (plain, _) = SWING.split_once("[[events]]").unwrap();
    scene_of(BOUNCER, &format!("{outputs}\n{plain}\n{tables}"))
}

/// Event of a scene file.
fn event(name: &str, zero: &str, direction: &str, is_terminal: bool) -> String {
    format!("[[events]]\nname = \"{name}\"\nzero = \"{zero}\"\ndirection = \"{direction}\"\nterminal = {is_terminal}\n")
}

/// Goal: instants of events are enclosed, each once, in the right direction. Method: the zeros of cos 2 t and sin 2 t.
#[test]
fn instants_of_events_are_enclosed() {
    use std::f64::consts::PI;
    let more = event("middle", "x", "either", false)
        + &event("left turn", "v", "rising", false)
        + &event("never", "x + 0.6", "either", false);
    for by in [None, Some("kane"), Some("lagrange")] {
        let found = enclosed(&spring_with("", &more), by, 3, &[]).unwrap();
        assert_eq!(found.run.end, RigorousEnd::Reached);
        let of = |event: usize| found.crossings.iter().filter(move |crossing| crossing.event == event);
        assert!(found.crossings.iter().all(|c| c.count == CrossingCount::One), "{by:?}: {:?}", found.crossings);
        // Up to 10 s, cos 2 t is zero at π/4 + k π/2 for k = 0 to 5; v rises through 0 at π/2 + k π for k = 0 to 2.
        let middle: Vec<f64> = (0..6).map(|k| PI * (0.25 + 0.5 * f64::from(k))).collect();
        let left: Vec<f64> = (0..3).map(|k| PI * (0.5 + f64::from(k))).collect();
        for (event, instants) in [(0, middle), (1, left), (2, Vec::new())] {
            assert_eq!(of(event).count(), instants.len(), "{by:?}, event {event}: {:?}", found.crossings);
            for (crossing, t) in of(event).zip(instants) {
                // The double nearest to the instant may lie one rounding outside.
                assert!(crossing.from - 2e-15 <= t && t <= crossing.to + 2e-15, "{by:?}: {crossing:?} and {t}");
                assert!(crossing.to - crossing.from < 1e-13, "{by:?}: {crossing:?}");
                let x = crossing.shown[found.names.iter().position(|name| name == "x").unwrap()];
                let truth = 0.5 * (2.0 * t).cos();
                assert!(x.low() - 4e-15 <= truth && truth <= x.high() + 4e-15 && x.radius < 1e-13, "{x:?}, {truth}");
            }
        }
    }
}

/// Goal: a terminal event ends the motion, and nothing is claimed or ranged after it. Method: x reaches −0.3 m at
/// acos(−0.6)/2.
#[test]
fn a_terminal_event_ends_the_enclosure() {
    let more = event("bound", "x + 0.3", "falling", true) + &event("middle", "x", "either", false);
    let found = enclosed(&spring_with("", &more), None, 4, &["x > -0.3001", "x > -0.2999", "v > -1.1"]).unwrap();
    let end = found.last_event().expect("an event ends the motion");
    let t = (-0.6f64).acos() / 2.0;
    assert_eq!((end.event, end.count, found.crossings.len()), (0, CrossingCount::One, 2));
    assert!(found.is_whole() && (end.to - t).abs() < 1e-14 && end.from <= end.to);
    let range = found.ranges[found.names.iter().position(|name| name == "x").unwrap()];
    assert!(range.lo() <= -0.3 && range.lo() > -0.3001, "{range:?}");
    let [(_, kept), (_, broken), (_, fast)] = found.claims.as_slice() else { panic!("three claims") };
    assert!(kept.is_proved() && fast.is_proved(), "{kept:?} {fast:?}");
    assert!(broken.refuted_by.is_some_and(|by| (by - t).abs() < 1e-2), "{broken:?}");
}

/// Goal: an event function that touches 0 is not counted as a crossing and is not lost. Method: x + 0.5 touches 0 at
/// π/2. As a terminal event, it leaves the claims open.
#[test]
fn a_touch_of_zero_stays_open() {
    let found = enclosed(&spring_with("", &event("touch", "x + 0.5", "either", false)), None, 1, &["x < 1"]).unwrap();
    assert!(!found.crossings.is_empty() && found.crossings.iter().all(|c| c.count == CrossingCount::Open));
    assert!(found.is_whole() && found.claims[0].1.is_proved());
    let found = enclosed(&spring_with("", &event("touch", "x + 0.5", "either", true)), None, 1, &["x < 1"]).unwrap();
    assert!(found.last_event().is_some_and(|end| (end.from..=end.to).contains(&std::f64::consts::FRAC_PI_2)));
    assert!(!found.is_whole() && !found.claims[0].1.is_proved());
}

/// Goal: claims may be formulas of all that a scene can show, and of the determinant. Method: T + V = 1 J, v' = −4 x,
/// and the determinant is m.
#[test]
fn claims_are_formulas() {
    let scene = spring_with("outputs = [\"x\", { name = \"twice\", value = \"2*x\" }]", "");
    let kept = ["total_energy < 1 + 1e-6", "0.999999 < total_energy", "v' < 2.001", "twice < x + 0.501*m/m"];
    let broken = ["total_energy < 0.999", "v' < 1.9", "twice < 0.4"];
    for by in [None, Some("kane"), Some("lagrange")] {
        let found = enclosed(&scene, by, 1, &[&kept[..], &broken].concat()).unwrap_or_else(|e| panic!("{by:?}: {e}"));
        for (claim, verdict) in &found.claims {
            let is_kept = kept.contains(&claim.text.as_str());
            assert_eq!((verdict.is_proved(), verdict.refuted_by.is_some()), (is_kept, !is_kept), "{by:?}: {claim:?}");
        }
    }
    let found = enclosed(&scene, Some("kane"), 1, &["determinant > m - 1e-12*m", "determinant < 1.9"]).unwrap();
    assert!(found.claims[0].1.is_proved() && found.claims[1].1.refuted_by.is_some());
}

/// Goal: the instants of events are those of ordinary runs. Method: library scenes with events, at rtol 1e-12.
#[test]
fn events_agree_with_ordinary_runs() {
    for path in ["pendulum/scenes/over", "pendulum/scenes/swing"] {
        let scene = library_scene(path);
        let found = enclosed(&scene, None, 1, &[]).unwrap();
        let run = scene.simulate(&tripos::Overrides { rtol: Some(1e-12), ..Default::default() }).unwrap();
        let events: Vec<f64> = run.solution.events.iter().map(|event| event.t).collect();
        assert_eq!(found.crossings.len(), events.len(), "{path}");
        for (crossing, t) in found.crossings.iter().zip(events) {
            assert!((crossing.from - t).abs() < 1e-9 && crossing.count == CrossingCount::One, "{path}: {crossing:?}");
        }
    }
}

/// Goal: claims of a scene file are judged with the equations that they name. Method: a claim about the derived motion,
/// and one about Kane's equations.
#[test]
fn claims_of_a_scene_are_about_their_equations() {
    let more = "[[claims]]\nclaim = \"x < 0.6\"\n[[claims]]\nclaim = \"x < 0.4\"\nby = \"kane\"\n";
    let scene = spring_with("", more);
    let derived = enclosed(&scene, None, 1, &[]).unwrap();
    assert!(derived.claims.len() == 1 && derived.claims[0].1.is_proved());
    assert!(derived.notes.iter().any(|note| note.contains("`x < 0.4`") && note.contains("--by kane")));
    let kane = enclosed(&scene, Some("kane"), 1, &[]).unwrap();
    assert!(kane.claims.len() == 1 && kane.claims[0].1.refuted_by.is_some());
}

/// Goal: nothing is refuted by instants at which the motion may be over. Method: x + 0.5 touches 0 at π/2, which may
/// end the motion, and v first exceeds 0.3 m/s after it. Before it, the claim x > 0 is broken.
#[test]
fn nothing_is_refuted_after_a_motion_may_be_over() {
    let touch = event("touch", "x + 0.5", "either", true);
    let found = enclosed(&spring_with("", &touch), None, 1, &["v < 0.3", "x > 0"]).unwrap();
    let [(_, later), (_, earlier)] = found.claims.as_slice() else { panic!("two claims") };
    assert!(later.refuted_by.is_none() && !later.is_proved(), "{later:?}");
    assert!(earlier.refuted_by.is_some_and(|by| by < 1.2), "{earlier:?}");
    assert!(!found.is_whole() && found.last_event().is_some());
}

/// Goal: a motion that starts where an event function is 0 has not crossed it, if the 0 is exact; a start beside 0
/// counts by its sign. Method: v = −sin 2 t, and v − 1e-25 m/s, v + 1e-25 m/s.
#[test]
fn starts_at_zero_are_exact() {
    let ends = |zero: &str, direction: &str| {
        let found = enclosed(&spring_with("", &event("turn", zero, direction, true)), None, 1, &[]).unwrap();
        let end = found.last_event().expect("v has zeros").clone();
        assert_eq!(end.count, CrossingCount::One, "{zero}: {end:?}");
        end.to
    };
    let half = std::f64::consts::FRAC_PI_2;
    assert!((ends("v", "either") - half).abs() < 1e-12);
    assert!((ends("v - 1e-25", "either") - half).abs() < 1e-12);
    assert!(ends("v + 1e-25", "either") < 1e-12);
}

/// Goal: a reference states a proved distance beside the difference of its witnesses, and only for the numbers of its
/// file. Method: the spring, and the same with another stiffness.
#[test]
fn references_state_a_proved_distance() {
    let mut scene = scene_of(BOUNCER, SWING);
    let reference = scene.reference(&[1.0, 2.0]).unwrap();
    assert!(reference.proved.is_some_and(|distance| distance < 1e-19), "{:?}", reference.proved);
    assert!(reference.how.contains("theorem") && reference.uncertainty < 1e-16, "{}", reference.how);
    scene.set_number("k", 8.1).unwrap();
    let reference = scene.reference(&[1.0, 2.0]).unwrap();
    assert!(reference.proved.is_none() && !reference.how.contains("theorem"), "{}", reference.how);
}
