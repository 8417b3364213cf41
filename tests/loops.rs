//! Mechanisms with loops, and a blade that does not slip sideways: from model file to run.
//!
//! Truth: closed forms of the motion, and geometry by other formulas than the program's.

use crate::support::Random;
use std::path::Path;
use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::{Formulation, Model, model};
use tripos_sim::Dynamics;
use tripos_traits::System;

const FOUR_BAR: &str = include_str!("../models/four_bar/model.toml");

fn scene(model: Model, text: &str) -> Result<Scene, String> {
    Scene::parse(Mechanism::new(model), text).map_err(|e| e.to_string())
}

fn four_bar() -> Model {
    model::load(&Source::from_text("four_bar.toml", FOUR_BAR)).unwrap_or_else(|e| panic!("{e}"))
}

fn start(text: &str) -> tripos_derive::scene::Scene {
    let source = Source::from_text("turning.toml", text);
    tripos_derive::scene::load(&source, &mut four_bar()).unwrap_or_else(|e| panic!("{e}"))
}

fn run(scene: &Scene, by: &str, solve: Option<&str>, method: Option<&str>) -> Run {
    let step = ["gauss6", "radau5"].into_iter().any(|m| method == Some(m)).then_some(2e-4);
    let how = Overrides {
        by: Some(by.into()),
        solve: solve.map(|s| s.parse().unwrap()),
        method: method.map(|m| m.parse().unwrap()),
        step,
        ..Overrides::default()
    };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{by}, {solve:?}, {method:?}: {e}"));
    assert!(run.failure().is_none(), "{by}, {solve:?}, {method:?}: {:?}", run.objections());
    run
}

const TURNING: &str = "model = \"four_bar.toml\"\nspan = [0, 2]\n[start]\nq1 = 0.5\nu1 = 20\n[guess]\nq2 = 0.6\nq3 = 1.2\n\
                       [integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-12\n";

/// Coupler and rocker angles of the open (1) or the crossed (-1) linkage by the diagonal between its moving pin and the
/// fixed one, and the energy by the velocity ratios that an instant centre gives.
fn by_hand(q1: f64, branch: f64) -> (f64, f64, f64, f64) {
    let (a, b, c, d, [ma, mb, mc], g) = (0.3, 0.8, 0.6, 0.7, [1.0, 2.0, 1.5], 9.81);
    let (x, y) = (d - a * f64::cos(q1), -a * f64::sin(q1));
    let diagonal = f64::hypot(x, y);
    let q2 = y.atan2(x) + branch * f64::acos((b * b + diagonal * diagonal - c * c) / (2.0 * b * diagonal));
    let (px, py) = (b * q2.cos() - x, b * q2.sin() - y);
    let q3 = py.atan2(px);
    let (w2, w3) = (-a / b * f64::sin(q1 - q3) / f64::sin(q2 - q3), a / c * f64::sin(q1 - q2) / f64::sin(q3 - q2));
    let (vx, vy) = (-a * q1.sin() - b / 2.0 * w2 * q2.sin(), a * q1.cos() + b / 2.0 * w2 * q2.cos());
    let inertia = ma * a * a / 3.0 + mb * (vx * vx + vy * vy + b * b / 12.0 * w2 * w2) + mc * c * c / 3.0 * w3 * w3;
    let heights = ma * a / 2.0 * q1.sin() + mb * (a * q1.sin() + b / 2.0 * q2.sin()) + mc * c / 2.0 * q3.sin();
    (q2, q3, inertia, g * heights)
}

/// Goal: a closed loop moves as it must, by every formulation, solve and method. Method: positions by trigonometry and
/// the speed by the energy, at every sample; and the ends agree.
#[test]
fn a_four_bar_linkage_turns() {
    let scene = scene(four_bar(), TURNING).unwrap();
    let (_, _, inertia, potential) = by_hand(0.5, 1.0);
    let energy = inertia / 2.0 * 400.0 + potential;
    let mut ends: Vec<(String, Vec<f64>)> = Vec::new();
    for formulation in Formulation::ALL {
        let methods = ["taylor", "gauss6", "radau5"].map(|method| (None, Some(method)));
        for (solve, method) in [(None, None), (Some("numeric"), None)].into_iter().chain(methods) {
            let run = run(&scene, formulation.name(), solve, method);
            // Samples inside steps of implicit methods, three of four, are of order 3: rates are off by up to 9.5e-9
            // there.
            let is_implicit = matches!(method, Some("gauss6" | "radau5"));
            let of = |name: &str| run.column_of_quantity(name).unwrap();
            let samples = of("q1").into_iter().zip(of("q2")).zip(of("q3")).zip(of("u1")).enumerate();
            for (at, (((q1, q2), q3), u1)) in samples {
                let loose = if is_implicit && at % 4 != 0 { 40.0 } else { 1.0 };
                let (coupler, rocker, inertia, potential) = by_hand(q1, 1.0);
                let speed = (2.0 * (energy - potential) / inertia).sqrt();
                assert!(
                    (q2 - coupler).abs() < loose * 5e-12 && (q3 - rocker).abs() < loose * 5e-12,
                    "{q1}: {q2}, {coupler}; {q3}, {rocker}"
                );
                assert!((u1 - speed).abs() < loose * 3e-10, "{u1}, {speed}");
            }
            let largest = run.residuals.iter().map(|residual| residual.largest.abs()).fold(0.0, f64::max);
            assert!(run.residuals.len() >= 2 && largest < 5e-11, "{:?}", run.residuals);
            ends.push((format!("{} {solve:?} {method:?}", formulation.name()), run.end.clone()));
        }
    }
    for (by, end) in &ends {
        for (a, b) in end.iter().zip(&ends[0].1) {
            assert!((a - b).abs() < 1e-9, "{by} against {}: {a}, {b}", ends[0].0);
        }
    }
}

/// Goal: the states that a run reports satisfy the constraints. Method: without projection a loose run drifts visibly,
/// with it the last state is closed to rounding.
#[test]
fn projection_keeps_loops_closed() {
    let loose = TURNING.replace("1e-12", "1e-5");
    let scene = scene(four_bar(), &loose).unwrap();
    let run = run(&scene, "kane", None, None);
    let report = run.solution.projection.as_ref().unwrap();
    assert!(report.corrections > 50 && report.singular + report.not_converged == 0, "{report:?}");
    assert!(report.largest.iter().any(|drift| drift.abs() > 1e-9), "{report:?}");
    let [q1, q2, q3, ..] = run.end[..] else { panic!("{:?}", run.end) };
    let x = 0.3 * q1.cos() + 0.8 * q2.cos() - 0.7 - 0.6 * q3.cos();
    let y = 0.3 * q1.sin() + 0.8 * q2.sin() - 0.6 * q3.sin();
    assert!(x.abs() < 1e-14 && y.abs() < 1e-14, "{x}, {y}");
}

/// Goal: the start decides how a loop is closed. Method: guesses on either side of the diagonal.
#[test]
fn a_guess_chooses_the_branch() {
    let open = start(TURNING);
    let crossed = start(&TURNING.replace("q2 = 0.6\nq3 = 1.2", "q2 = -1.2\nq3 = -2"));
    let (q2, q3, ..) = by_hand(0.5, 1.0);
    assert!((open.q[1] - q2).abs() < 1e-15 && (open.q[2] - q3).abs() < 1e-15, "{:?}", open.q);
    let (q2, q3, ..) = by_hand(0.5, -1.0);
    assert!((crossed.q[1] - q2).abs() < 1e-15 && (crossed.q[2] - q3).abs() < 1e-15, "{:?}", crossed.q);
    let named: Vec<&str> = open.closed.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(named, ["q2", "q3"]);
}

/// Goal: a start that cannot be is refused, by how much and with what would do.
#[test]
fn an_open_start_is_refused() {
    let refused = |from: &str, to: &str| scene(four_bar(), &TURNING.replace(from, to)).err().unwrap();
    let stated = refused("q1 = 0.5\n", "q1 = 0.5\nq2 = 0.52\nq3 = 1.12\n");
    assert!(stated.contains("stated and guessed"), "{stated}");
    let open = refused("[guess]\nq2 = 0.6\nq3 = 1.2", "q2 = 0.52\nq3 = 1.12");
    assert!(open.contains("breaks the constraint `loop_") && open.contains("the nearest closed"), "{open}");
    let far = FOUR_BAR
        .replace("value = 0.7, positive = true, about = \"distance", "value = 7, positive = true, about = \"distance");
    let far = model::load(&Source::from_text("four_bar.toml", &far)).unwrap_or_else(|e| panic!("{e}"));
    let far = scene(far, TURNING).err().unwrap();
    assert!(far.contains("no configuration that closes the loops was found") && far.contains("stays open by"), "{far}");
    // In as many digits as people write, a state is close enough, and is closed.
    let near = TURNING.replace("[guess]\nq2 = 0.6\nq3 = 1.2", "q2 = 0.52116623167\nq3 = 1.12802694567");
    let near = start(&near);
    let (q2, ..) = by_hand(near.q[0], 1.0);
    assert!((near.q[1] - q2).abs() < 1e-14 && near.closed.is_empty());
}

/// Goal: no run begins where the motion is not determined. Method: a linkage that folds flat, and one beside it.
#[test]
fn a_singular_pose_is_no_start() {
    let flat = FOUR_BAR.replace(
        "value = 0.7, positive = true, about = \"distance",
        "value = 0.5, positive = true, about = \"distance",
    );
    let folding = || model::load(&Source::from_text("four_bar.toml", &flat)).unwrap_or_else(|e| panic!("{e}"));
    let at = |q1: &str| TURNING.replace("q1 = 0.5", q1).replace("q2 = 0.6\nq3 = 1.2", "q2 = 0.1\nq3 = 0.1");
    let refused = scene(folding(), &at("q1 = 0")).err().unwrap();
    assert!(refused.contains("a singular pose") && refused.contains("start beside q1 = 0"), "{refused}");
    if let Err(refused) = scene(folding(), &at("q1 = 0.1")) {
        panic!("{refused}");
    }
}

/// Goal: a reference in 32 digits keeps loops closed, too. Method: a tight run against it.
#[test]
fn a_reference_knows_a_loop() {
    let scene = scene(four_bar(), &TURNING.replace("[0, 2]", "[0, 0.5]")).unwrap();
    let reference = scene.reference(&[0.5]).unwrap();
    assert!(reference.uncertainty < 1e-18, "{}", reference.uncertainty);
    let run = run(&scene, "lagrange", None, None);
    for (found, exact) in run.end.iter().zip(reference.end()) {
        let exact = exact.hi();
        assert!((found - exact).abs() < 1e-11, "{found}, {exact}");
    }
}

/// Goal: a nonholonomic motion in closed form. Method: x = g sin α sin²(ω t)/(2 ω²), y = g sin α (ω t − sin ω t cos ω
/// t)/(2 ω²).
#[test]
fn a_knife_edge_goes_along_a_cycloid() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/knife_edge/model.toml");
    let text = "model = \"model.toml\"\nspan = [0, 10]\n[start]\nx = 0\ny = 0\nphi = 0\nu = 0\nw = 1.3\n[integration]\n\
                method = \"dop853\"\nrtol = 1e-12\natol = 1e-12\n";
    let scene = scene(Model::read(&path).unwrap(), text).unwrap();
    for by in ["kane", "lagrange", "newton-euler", "reduced"] {
        let run = run(&scene, by, None, None);
        let (turn, fall): (f64, f64) = (1.3 * 10.0, 9.81 * f64::sin(0.3) / (2.0 * 1.3 * 1.3));
        let expected = [("x", fall * turn.sin().powi(2)), ("y", fall * (turn - turn.sin() * turn.cos()))];
        for (name, expected) in expected {
            let found = *run.column_of_quantity(name).unwrap().last().unwrap();
            assert!((found - expected).abs() < 1e-9, "{by}: {name} = {found}, {expected}");
        }
    }
}

/// Goal: the multipliers of a loop are the forces of the pin that closes it. Method: the numeric solves of Lagrange's
/// and Newton-Euler's systems at random states, at which the loop need not even be closed.
#[test]
fn multipliers_are_the_reactions_of_the_closing_pin() {
    let all = tripos_models::MODELS.iter().find(|m| m.name == "four_bar").unwrap();
    let system = |name: &str| all.systems.iter().find(|s| s.name == name).unwrap().double;
    let (lagrange, newton_euler) = (system("lagrange"), system("newton-euler"));
    let mut random = Random(11);
    for _ in 0..200 {
        let mut some =
            |count: usize, from: f64, to: f64| (0..count).map(|_| random.between(from, to)).collect::<Vec<_>>();
        let (p, q, u) = (some(8, 0.5, 2.0), some(3, 0.3, 2.8), some(1, -5.0, 5.0));
        // Next to a dead point digits are lost.
        if f64::sin(q[1] - q[2]).abs() < 0.1 {
            continue;
        }
        let unknowns = |system: &'static dyn System<f64>| {
            let mut v = vec![0.0; system.lengths().variables];
            system.motion_variables(&p, &q, &u, &mut v);
            let mut dynamics = Dynamics::new(system, &p).unwrap();
            dynamics.unknowns(&q, &v).unwrap()[v.len()..].to_vec()
        };
        let (multipliers, reactions) = (unknowns(lagrange), unknowns(newton_euler));
        // pin_ox, pin_oy, pin_px, pin_py, then those of the pin that closes the loop.
        let size = reactions.iter().fold(1.0, |most: f64, r| most.max(r.abs()));
        for (multiplier, reaction) in multipliers.iter().zip(&reactions[4..6]) {
            assert!((multiplier - reaction).abs() < 1e-10 * size, "{multiplier} is not {reaction}");
        }
    }
}

/// Goal: no equations run a linkage that would let its loops open. Method: the scene's reduced equations, asked for.
#[test]
fn a_linkage_has_no_equations_of_a_scene() {
    let scene = scene(four_bar(), TURNING).unwrap();
    let how = Overrides { by: Some("reduced".into()), ..Overrides::default() };
    let refused = scene.simulate(&how).err().unwrap().to_string();
    assert!(refused.contains("nothing would keep `loop_x` closed"), "{refused}");
}

/// Goal: a speed that fails in dead points does not end a run. Method: the linkage by the speed of its rocker, which
/// stands still twice in a turn of the crank, beside the same motion by the speed of the crank.
#[test]
fn a_rocker_goes_through_its_dead_points() {
    let by_rocker = FOUR_BAR.replace("u1 = \"q1'\"", "u1 = \"q3'\"");
    let model = model::load(&Source::from_text("four_bar.toml", &by_rocker)).unwrap_or_else(|e| panic!("{e}"));
    let crank = scene(four_bar(), TURNING).unwrap();
    let by_crank = run(&crank, "kane", None, None);
    let (q2, q3, ..) = by_hand(0.5, 1.0);
    let rate = 20.0 * 0.3 / 0.6 * f64::sin(0.5 - q2) / f64::sin(q3 - q2);
    let text = TURNING.replace("u1 = 20", &format!("u1 = {rate:?}"));
    let rocker = scene(model, &text).unwrap();
    let through = rocker.simulate(&Overrides::default()).unwrap();
    assert!(through.failure().is_none(), "{:?}", through.objections());
    assert!(
        through.notes.iter().any(|note| note.contains("places where `u1` does not determine the motion")),
        "{:?}",
        through.notes
    );
    for (name, tolerance) in [("q1", 1e-7), ("q2", 1e-7), ("q3", 1e-7)] {
        let end = |run: &Run| *run.column_of_quantity(name).unwrap().last().unwrap();
        assert!((end(&through) - end(&by_crank)).abs() < tolerance, "{name}: {}, {}", end(&through), end(&by_crank));
    }
}

/// A plate on three parallel cranks, one more than it needs.
const THREE_CRANKS: &str = r#"
name = "plate on three cranks"
[parameters]
l = "1 m"
third = { unit = "m", value = 1, positive = true }
x = { unit = "m", value = 2 }
y = { unit = "m", value = 0 }
m = "1 kg"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[bodies]
"crank{i in 1..3}" = { mass = "m", inertia = "m*l^2/12" }
plate = { mass = "m", inertia = "m*l^2" }
[joints]
A = { kind = "pin", body = "crank1", centre = ["l/2", 0, 0], coordinates = ["q"], speeds = ["u"] }
B = { kind = "pin", body = "crank2", at = ["l", 0, 0], centre = ["l/2", 0, 0], speeds = [] }
C = { kind = "pin", body = "crank3", at = ["x", "y", 0], centre = ["third/2", 0, 0], speeds = [] }
P = { kind = "pin", body = "plate", to = "crank1", at = ["l", 0, 0], centre = ["l", 0, 0], speeds = [] }
Q = { kind = "pin", body = "crank2", to = "plate", at = ["l", 0, 0], body_at = ["l", 0, 0] }
R = { kind = "pin", body = "crank3", to = "plate", at = ["2*l", 0, 0], body_at = ["third", 0, 0] }
"#;

/// Goal: a loop that is redundant at the default values is watched at other values. Method: a third crank that is
/// parallel to the others moves; one that meets the plate in another direction stops it, and is refused; one of twice
/// the length that is parallel at the start permits the first instant alone, and the run says that it opens.
#[test]
fn loops_that_follow_from_others_are_watched() {
    let text = |parameters: &str, third: f64| {
        format!(
            "model = \"model.toml\"\nspan = [0, 0.5]\n[parameters]\n{parameters}\n[start]\nq = -0.7\nu = 1\n[guess]\nq_B = -0.7\n\
             q_C = {third}\nq_P = 0.7\n"
        )
    };
    let start = |parameters: &str, third: f64| {
        let model = model::load(&Source::from_text("model.toml", THREE_CRANKS)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!((model.loops.len(), model.closed.len()), (3, 1));
        scene(model, &text(parameters, third))
    };
    let simulated = |scene: &Scene| scene.simulate(&Overrides::default()).unwrap();
    let run = simulated(&start("", -0.7).unwrap());
    assert!(run.failure().is_none(), "{:?}", run.objections());
    assert_eq!(run.residuals.len(), 4);
    assert!(run.residuals.iter().all(|residual| residual.largest.abs() < 1e-8), "{:?}", run.residuals);
    let (sin, cos) = (-0.7_f64).sin_cos();
    let beside = format!("x = {}\ny = {}", 2.0 + cos, sin - 1.0);
    let Err(refused) = start(&beside, std::f64::consts::FRAC_PI_2) else { panic!("nothing can move") };
    assert!(refused.contains("does not follow from the other constraints"), "{refused}");
    let opens = simulated(&start(&format!("third = 2\nx = {}\ny = {}", 2.0 - cos, -sin), -0.7).unwrap());
    assert!(
        opens.objections().iter().any(|o| o.contains("this is not the motion of the mechanism")),
        "{:?}",
        opens.objections()
    );
}

/// Goal: long chains of loops move as they must. Method: ten windows swing as one pendulum, every crank parallel to the
/// first.
#[test]
fn ten_windows_swing_as_one() {
    let text = include_str!("../models/window_linkage/model.toml").replace("n = 2", "n = 10");
    let model = model::load(&Source::from_text("windows.toml", &text)).unwrap_or_else(|e| panic!("{e}"));
    let guess = |name: &str, at: f64| (1..=10).map(|i| format!("q_{name}{i} = {at}")).collect::<Vec<_>>().join("\n");
    let scene = format!(
        "model = \"model.toml\"\nspan = [0, 2]\n[start]\nq = \"-30 deg\"\nu = 0\n[guess]\n{}\n{}\n[integration]\nrtol = 1e-11\natol = \
         1e-13\n",
        guess("ground", -0.5),
        guess("pin", 0.5)
    );
    let scene = self::scene(model, &scene).unwrap();
    let run = run(&scene, "kane", None, None);
    let q = &run.column_of_quantity("q").unwrap();
    assert!(q.iter().any(|q| *q < -2.0), "it swings over");
    for name in (1..=10).map(|i| format!("q_ground{i}")) {
        let apart =
            run.column_of_quantity(&name).unwrap().iter().zip(q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-10, "{name}: {apart}");
    }
}
