//! Runs of linkages that change their independent speeds on the way, and that go through singular poses.
//!
//! Truth: a published relation, a table of another program's numbers, the same motion in speeds that do not fail.

use std::path::Path;
use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::model;

fn library(scene: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(scene);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn scene(model: &str, text: &str) -> Scene {
    let model = model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let named = format!("model = \"model.toml\"\n{text}");
    Scene::parse(Mechanism::new(model), &named).unwrap_or_else(|e| panic!("{e}"))
}

fn by(scene: &Scene, by: &str, method: Option<&str>) -> Run {
    let how = Overrides { by: Some(by.into()), method: method.map(|m| m.parse().unwrap()), ..Overrides::default() };
    scene.simulate(&how).unwrap_or_else(|e| panic!("{by}: {e}"))
}

fn largest_residual(run: &Run) -> f64 {
    run.residuals.iter().map(|residual| residual.largest.abs()).fold(0.0, f64::max)
}

fn says(run: &Run, what: &str) -> bool {
    run.notes.iter().any(|note| note.contains(what))
}

/// Goal: Kane's speed of one pin fails in dead points, and the motion goes on. Method: Bricard's mechanism over four of
/// them by Kane's and by Newton and Euler's equations; its one relation (J. E. Baker 1980, the trihedral case) at every
/// sample, and its energy.
#[test]
fn bricards_mechanism_goes_on_where_its_speed_fails() {
    let text = library("bricard/scenes/let_go.toml").replace("span = [0, 0.4]", "span = [0, 6]");
    let scene = scene(&library("bricard/model.toml"), &text);
    for formulation in ["kane", "newton-euler"] {
        let run = by(&scene, formulation, None);
        assert!(run.failure().is_none() && run.warnings.is_empty(), "{formulation}: {:?}", run.objections());
        assert!(run.by.name() == formulation && says(&run, "speeds changed"), "{:?}", run.notes);
        let of = |name: &str| run.column_of_quantity(name).unwrap();
        for (((a1, a3), a5), b4) in of("q_P1").iter().zip(of("q_P3")).zip(of("q_P5")).zip(of("q_P4")) {
            assert!((a1 + a3).abs() < 1e-12 && (a1 + a5).abs() < 1e-12, "{a1}, {a3}, {a5}");
            assert!((b4.sin() - a3.sin() - b4.sin() * a3.sin()).abs() < 1e-12, "{a3}, {b4}");
        }
        // Velocities are kept to rounding, also between steps.
        assert!(largest_residual(&run) < 1e-13, "{:?}", run.residuals);
        assert!(run.energy_drift.unwrap() < 1e-6, "{:?}", run.energy_drift);
    }
}

/// Goal: the parallelogram of a linkage is kept through the poses in which its bars lie in one line, where its
/// constraints are dependent. Truth: the angle of the cranks from the vertical and its rate, from a table for N = 2
/// (problem A02 of the IFToMM's benchmarks for multibody systems). The angle satisfies
/// ((N + 1)/3 + N) phi'' = ((N + 1)/2 + N) g sin phi.
#[test]
fn windows_go_through_their_singular_poses() {
    let table: [(f64, f64, f64); 5] = [
        (1.0, 3.337_870_803_105_099, 6.807_385_240_869_443_5),
        (2.0, 6.341_033_361_312_348, 1.018_964_591_438_591_6),
        (5.0, 16.654_353_486_654_113, 6.105_067_553_518_685),
        (10.0, 31.750_597_186_986_692, 1.506_642_180_843_437_6),
        (20.0, 63.828_669_393_149_47, 3.385_442_556_438_839_3),
    ];
    let text = library("window_linkage/scenes/upright.toml").replace("[integration]", "[integration]\nsamples = 21");
    let scene = scene(&library("window_linkage/model.toml"), &text);
    for (tolerance, of_angles, of_rates) in [(1e-8, 1e-4, 1e-4), (1e-11, 2e-8, 5e-8)] {
        let how =
            Overrides { by: Some("kane".into()), rtol: Some(tolerance), atol: Some(tolerance), ..Overrides::default() };
        let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{e}"));
        assert!(run.failure().is_none() && run.warnings.is_empty(), "{:?}", run.objections());
        assert!(says(&run, "through singular poses"), "{:?}", run.notes);
        let cranks = ["q", "q_ground1", "q_ground2"].map(|name| run.column_of_quantity(name).unwrap());
        let rates = run.column_of_quantity("u").unwrap();
        for (t, phi, rate) in table {
            let at = run.solution.t.iter().position(|sampled| (sampled - t).abs() < 1e-12).unwrap();
            for crank in &cranks {
                let apart = crank[at] - (std::f64::consts::FRAC_PI_2 - phi);
                assert!(apart.abs() < of_angles, "{tolerance}, t = {t}: {apart:e}");
            }
            assert!((rates[at] + rate).abs() < of_rates, "{tolerance}, t = {t}: {}, {rate}", rates[at]);
        }
        assert!(largest_residual(&run) < 1e-12, "{:?}", run.residuals);
    }
}

const TURNING: &str = "span = [0, 2]\n[start]\nq1 = 0.5\nu1 = 20\n[guess]\nq2 = 0.6\nq3 = 1.2\n[[events]]\nname = \"over\"\n\
                       zero = \"sin(q1)\"\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-12\nsamples = 41\n";

/// Goal: samples are in the declared speed, and events happen at their instants, whatever equations run. Method: a
/// linkage by the speed of its rocker, which fails twice in a turn of the crank, compared with the same by the speed of
/// the crank, whose events are those of `sin(q1) = 0`.
#[test]
fn changed_speeds_change_neither_samples_nor_events() {
    let model = library("four_bar/model.toml");
    let crank = by(&scene(&model, TURNING), "kane", None);
    let (q1, q2, q3) = (
        crank.column_of_quantity("q1").unwrap(),
        crank.column_of_quantity("q2").unwrap(),
        crank.column_of_quantity("q3").unwrap(),
    );
    let ratio = |at: usize| 0.3 / 0.6 * f64::sin(q1[at] - q2[at]) / f64::sin(q3[at] - q2[at]);
    let speed = format!("u1 = {:?}", 20.0 * ratio(0));
    let by_rocker = scene(&model.replace("u1 = \"q1'\"", "u1 = \"q3'\""), &TURNING.replace("u1 = 20", &speed));
    for (formulation, method) in [("kane", None), ("lagrange", None), ("kane", Some("taylor"))] {
        let rocker = by(&by_rocker, formulation, method);
        assert!(rocker.failure().is_none(), "{formulation}: {:?}", rocker.objections());
        // Lagrange's steps, and long ones, may lead across a dead point without meeting it.
        let must_change = formulation == "kane" && method.is_none();
        assert!(!must_change || says(&rocker, "speeds changed"), "{:?}", rocker.notes);
        assert!(!says(&rocker, "singular poses"), "{:?}", rocker.notes);
        assert_eq!(rocker.solution.t, crank.solution.t);
        for (name, other) in [("q1", &q1), ("q2", &q2), ("q3", &q3)] {
            for (a, b) in rocker.column_of_quantity(name).unwrap().iter().zip(other.iter()) {
                assert!((a - b).abs() < 1e-8, "{formulation}, {name}: {a}, {b}");
            }
        }
        for (at, (u3, u1)) in
            rocker.column_of_quantity("u1").unwrap().iter().zip(crank.column_of_quantity("u1").unwrap()).enumerate()
        {
            assert!((u3 - u1 * ratio(at)).abs() < 1e-6, "{formulation}: {u3}, {}", u1 * ratio(at));
        }
        let times = |run: &Run| run.solution.events.iter().map(|event| event.t).collect::<Vec<_>>();
        let (found, known) = (times(&rocker), times(&crank));
        assert!(found.len() == known.len() && found.len() > 5, "{} events, not {}", found.len(), known.len());
        assert!(found.iter().zip(&known).all(|(a, b)| (a - b).abs() < 1e-8), "{found:?}, {known:?}");
    }
}

/// Goal: loops stay closed in long runs. Method: a crank that turns on and on for 10 000 s, its residuals over the
/// lengths of the bars and its energy; some minutes, in `.ci/full`.
#[test]
#[ignore = "ten thousand seconds of motion"]
fn a_linkage_stays_closed_for_ten_thousand_seconds() {
    let text =
        TURNING.replace("[0, 2]", "[0, 10000]").replace("samples = 41", "samples = 10001\nstep_limit = 100000000");
    let run = by(&scene(&library("four_bar/model.toml"), &text.replace("1e-12", "1e-13")), "kane", None);
    assert!(run.failure().is_none(), "{:?}", run.objections());
    println!(
        "residual {:e} m, energy {:e} J, {} steps",
        largest_residual(&run),
        run.energy_drift.unwrap(),
        run.solution.steps
    );
    assert!(largest_residual(&run) < 0.3 * 1e-12, "{:?}", run.residuals);
}
