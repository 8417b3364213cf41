//! Inverse dynamics, with forces and inputs of given motions, and regressors in numbers.
//!
//! Truth: closed forms; P. I. Corke, *Robotics, Vision and Control* (2011), section 9.1.

use std::path::Path;
use tripos::studies::identification::{base_parameter_values, identify, regressor_rows};
use tripos::studies::inverse::{InverseDynamics, RequiredForces, motion_samples};
use tripos::{Error, Mechanism};
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::scene::{MotionSample, load_motion, load_samples};
use tripos_traits::DoubleDouble;

fn read(model: &str) -> Mechanism {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn parse(text: &str) -> Mechanism {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    Mechanism::new(model)
}

fn run(mut model: Mechanism, motion: &str, inputs: &[&str]) -> Result<Vec<(MotionSample, RequiredForces)>, Error> {
    let motion = load_motion(&Source::from_text("motion.toml", motion), &mut model).unwrap_or_else(|e| panic!("{e}"));
    let inputs: Vec<String> = inputs.iter().map(|name| (*name).to_owned()).collect();
    let inverse = InverseDynamics::new(&model, &inputs)?;
    motion_samples(&model, &motion)?
        .into_iter()
        .map(|moving| inverse.required_forces_at(&motion.parameters, &moving).map(|forces| (moving, forces)))
        .collect()
}

const PENDULUM: &str = r#"
name = "Driven pendulum"
[parameters]
m = { unit = "kg", value = 2, positive = true }
l = { unit = "m", value = 0.5, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
c = { unit = "N*m*s", value = 0.125 }
[inputs]
tau = { unit = "N*m" }
more = { unit = "N*m" }
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
[bodies]
rod = { frame = "A", centre = "P", mass = "m", inertia = 0 }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[torques]
drive = { on = "rod", frame = "N", vector = [0, 0, "tau - c*u"] }
other = { on = "rod", frame = "N", vector = [0, 0, "2*more"] }
"#;

const SWING: &str = "[motion]\nq = \"sin(3*t)\"\n[times]\nfrom = 0\nto = 2\ncount = 9\n";

/// Goal: the torque of a motion that is given by a formula. Method: m l² q'' + c q' + m g l sin q in closed form, to
/// rounding.
#[test]
fn a_driven_pendulum_needs_its_closed_form() {
    for (moving, forces) in run(parse(PENDULUM), SWING, &["tau"]).unwrap() {
        let t = moving.t.unwrap();
        let (q, u, rate) = ((3.0 * t).sin(), 3.0 * (3.0 * t).cos(), -9.0 * (3.0 * t).sin());
        let torque = 0.5 * rate + 0.125 * u + 9.81 * q.sin();
        assert!((moving.u[0].hi() - u).abs() < 1e-14 && (moving.rates[0].hi() - rate).abs() < 1e-13);
        assert!((forces.along[0].hi() - torque).abs() < 1e-13, "{t}");
        assert!((forces.inputs.unwrap()[0] - torque).abs() < 1e-13, "{t}");
    }
}

/// Goal: if there are more inputs than degrees of freedom, the least inputs are given. Method: τ₁ + 2 τ₂ = f by (f, 2
/// f)/5.
#[test]
fn inputs_that_are_too_many_are_the_least() {
    for (_, forces) in run(parse(PENDULUM), SWING, &[]).unwrap() {
        let (f, inputs) = (forces.along[0].hi(), forces.inputs.unwrap());
        assert!((inputs[0] - f / 5.0).abs() < 1e-14 && (inputs[1] - 2.0 * f / 5.0).abs() < 1e-14, "{inputs:?}");
        assert_eq!(forces.reached, 1);
    }
}

/// Goal: a parameter can serve as an input where loads are linear in it, and is refused elsewhere. Method: the damper's
/// constant gives the effect of the torque; the length does not enter only through loads.
#[test]
fn parameters_stand_for_inputs_where_loads_are_linear() {
    let state = "[state]\nq = 0.5\nu = 2\n[accelerations]\n\"u'\" = 0\n";
    let (_, forces) = run(parse(PENDULUM), state, &["c"]).unwrap().remove(0);
    assert!((forces.inputs.unwrap()[0] + 9.81 * 0.5_f64.sin() / 2.0).abs() < 1e-14);
    let wrong = run(parse(PENDULUM), state, &["l"]).unwrap_err().first_line();
    assert_eq!(wrong, "forces are not linear in `l`");
}

/// Goal: the gravity load of an arm with a motor at each joint is the published one. Method: Corke's gravity load of
/// the PUMA 560 in the pose `qn`.
#[test]
fn an_arm_at_rest_needs_its_published_gravity_load() {
    let state = "[state]\nq1 = 0\nq2 = \"pi/4\"\nq3 = \"pi\"\nq4 = 0\nq5 = \"pi/4\"\nq6 = 0\nu1 = 0\nu2 = 0\nu3 = 0\nu4 = 0\nu5 = 0\nu6 = 0\n\
                 [accelerations]\n\"u1'\" = 0\n\"u2'\" = 0\n\"u3'\" = 0\n\"u4'\" = 0\n\"u5'\" = 0\n\"u6'\" = 0\n";
    let (_, forces) = run(read("puma560"), state, &[]).unwrap().remove(0);
    let inputs = forces.inputs.expect("six motors hold six joints");
    for (torque, printed) in inputs.iter().zip([0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0]) {
        assert!((torque - printed).abs() < 1e-4, "{inputs:?}");
    }
}

/// A crank with a rod whose end slides along an axis, the slide's place tied by a loop.
const CRANK: &str = r#"
name = "Crank and slide"
[parameters]
m = { unit = "kg", value = 3, positive = true }
J = { unit = "kg*m^2", value = 0.25, positive = true }
a = { unit = "m", value = 0.5, positive = true }
b = { unit = "m", value = 1.5, positive = true }
[inputs]
tau = { unit = "N*m" }
F = { unit = "N" }
[coordinates]
q = { unit = "rad" }
r = { unit = "rad" }
x = { unit = "m" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q" }
B = { from = "N", axis = 3, angle = "r" }
[points]
P = { from = "O", frame = "A", position = ["a", 0, 0] }
Q = { from = "P", frame = "B", position = ["b", 0, 0] }
S = { from = "O", frame = "N", position = ["x", 0, 0] }
[bodies]
crank = { frame = "A", centre = "O", mass = "m", inertia = "J" }
[particles]
slide = { point = "S", mass = "m" }
[constraints]
along = { equation = "a*cos(q) + b*cos(r) = x" }
across = { equation = "a*sin(q) = -b*sin(r)" }
[torques]
motor = { on = "crank", frame = "N", vector = [0, 0, "tau"] }
[forces]
push = { on = "slide", frame = "N", vector = ["F", 0, 0] }
"#;

/// Goal: dependent coordinates follow from the given one. Method: crank and slide in closed form, x = a cos q + √(b² −
/// a² sin² q), with q = t + t². The torque is τ = J q'' + m x'' dx/dq, by differences of the closed form without
/// cancellation.
#[test]
fn dependent_coordinates_of_a_loop_are_solved_for() {
    let motion = "[motion]\nq = \"t + t^2\"\n[guess]\nr = -0.1\n[times]\nfrom = 0\nto = 3\ncount = 301\n";
    for (moving, forces) in run(parse(CRANK), motion, &["tau"]).unwrap_or_else(|e| panic!("{e}")) {
        let t = moving.t.unwrap();
        let (q, rate) = (t + t * t, 1.0 + 2.0 * t);
        let (s, c) = (0.5 * q.sin(), 0.5 * q.cos());
        let root = (2.25 - s * s).sqrt();
        let slope = -s - s * c / root;
        let bend = -c - (c * c - s * s) / root - (s * c).powi(2) / root.powi(3);
        let torque = 0.25 * 2.0 + 3.0 * (bend * rate * rate + slope * 2.0) * slope;
        assert!((moving.q[1].hi() + (s / 1.5).asin()).abs() < 1e-14, "{t}");
        assert!((forces.inputs.as_ref().unwrap()[0] - torque).abs() < 1e-11 * torque.abs().max(1.0), "{t}: {forces:?}");
    }
}

/// Goal: a motion that the inputs cannot give is refused with the missing force, and an incomplete motion with the
/// missing coordinate. Method: a cart that is pushed, with a pendulum that is not; a push along a slide where it stands
/// still; a free coordinate.
#[test]
fn motions_that_inputs_do_not_give_are_refused() {
    let dead = "[motion]\nq = 0\n[guess]\nr = 0\n[times]\nfrom = 0\nto = 0\ncount = 1\n";
    let (_, forces) = run(parse(CRANK), dead, &["F"]).unwrap().remove(0);
    assert_eq!((forces.reached, forces.inputs), (0, Some(vec![0.0])));
    let turning = dead.replace("q = 0", "q = \"t^2\"");
    let (_, forces) = run(parse(CRANK), &turning, &["F"]).unwrap().remove(0);
    assert!(forces.inputs.is_none() && (forces.left[0] - 0.5).abs() < 1e-14, "{forces:?}");
    let open = run(parse(CRANK), &dead.replace("q = 0", "").replace("[guess]", "[guess]\nq = 1"), &["F"]).unwrap_err();
    assert!(
        open.first_line().contains("the loops are not closed near the last pose, or do not determine it"),
        "{open}"
    );
}

/// Goal: however many coordinates have formulas, a motion is computed, or refused with the place of the conflict.
/// Method: each choice among the three angles of a four-bar linkage, at values that close it (by the law of cosines)
/// and at values that do not.
#[test]
fn formulas_that_contradict_a_loop_are_refused() {
    // Pins at 0 and d, the crank at q1. The coupler and the rocker meet at the crossing of two circles.
    let (a, b, c, d, q1) = (0.3_f64, 0.8_f64, 0.6_f64, 0.7_f64, 0.4_f64);
    let (px, py) = (a * q1.cos(), a * q1.sin());
    let (dx, dy) = (d - px, -py);
    let apart = dx.hypot(dy);
    let bend = ((b * b + apart * apart - c * c) / (2.0 * b * apart)).acos();
    let q2 = dy.atan2(dx) + bend;
    let q3 = (py + b * q2.sin()).atan2(px + b * q2.cos() - d);
    let values = [q1, q2, q3];
    for chosen in 0..8_usize {
        let formula = |at: usize, off: f64| format!("q{} = {:?}\n", at + 1, values[at] + off);
        let is_given = |at: &usize| chosen >> at & 1 == 1;
        let file = |off: f64| {
            let given: String =
                (0..3).filter(is_given).map(|at| formula(at, if at == 2 { off } else { 0.0 })).collect();
            let guess: String = (0..3).filter(|at| !is_given(at)).map(|at| formula(at, 0.01)).collect();
            format!("[motion]\n{given}[guess]\n{guess}[times]\nfrom = 0\nto = 1\ncount = 2\n")
        };
        let (told, wrong) = (run(read("four_bar"), &file(0.0), &[]), run(read("four_bar"), &file(0.3), &[]));
        match chosen.count_ones() {
            0 => assert!(told.is_err()),
            1 => assert!(told.is_ok() && (wrong.is_ok() || chosen == 4), "{chosen}"),
            _ => {
                let list = told.unwrap_or_else(|e| panic!("{chosen}: {e}"));
                assert!(list.iter().all(|(m, _)| m.q.iter().zip(values).all(|(q, x)| (q.hi() - x).abs() < 1e-12)));
                assert_eq!(wrong.is_err(), chosen >= 4, "{chosen}");
            }
        }
        if chosen == 7 {
            let why = run(read("four_bar"), &file(0.3), &[]).unwrap_err().to_string();
            let parts = ["t = 0 s", "the formulas of `q1`, `q2`, `q3` contradict the loops", " by ", "[guess]"];
            assert!(parts.iter().all(|part| why.contains(part)), "{why}");
        }
    }
}

/// Goal: base parameters do not depend on the states that are drawn at random. Method: a free rigid body has ten, its
/// mass, its first and its second moments, in angles and in Euler parameters. On a ball joint with a weight it has
/// nine, without its mass.
#[test]
fn a_free_body_has_ten_base_parameters() {
    let text = |kind: &str, sequence: &str, gravity: &str| {
        format!(
            "name = \"Body\"\n[parameters]\nm = \"3 kg\"\nA = \"0.4 kg*m^2\"\nB = \"0.5 kg*m^2\"\nC = \"0.6 kg*m^2\"\ng = \"9.81 m/s^2\"\n\
             [inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\n\
             sat = {{ mass = \"m\", inertia = {{ diagonal = [\"A\", \"B\", \"C\"] }} }}\n[joints]\n\
             J = {{ kind = \"{kind}\", body = \"sat\", sequence = \"{sequence}\" }}\n{gravity}"
        )
    };
    let gravity = "[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n";
    for (kind, count) in [("free", 10), ("ball", 9)] {
        for sequence in ["euler", "321"] {
            let found = identify(&parse(&text(kind, sequence, gravity)), RegressorParameters::Bodies)
                .unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(found.base.len(), count, "{kind} {sequence}");
            assert!(found.base.iter().all(|base| base.with.is_empty()), "{kind} {sequence}");
        }
    }
}

/// Seeded states of a mechanism without loops.
fn states(model: &Mechanism) -> Vec<MotionSample> {
    let wide = |k: usize| DoubleDouble::from((12.9898 * (1.0 + k as f64)).sin() * 1.5 + 0.2);
    let (n, p) = (model.coordinates.len(), model.speeds.len());
    let list = |from: usize, count: usize| (from..from + count).map(wide).collect::<Vec<_>>();
    (0..5)
        .map(|k| MotionSample { t: None, q: list(100 * k, n), u: list(100 * k + 30, p), rates: list(100 * k + 60, p) })
        .collect()
}

/// Goal: the regressor with the values of the base parameters gives the forces of the model. Method: M u' − f by Kane's
/// equations at seeded states in 32 digits; rolling, time, springs, an arm.
#[test]
fn regressors_give_the_forces_of_the_model_in_32_digits() {
    for name in ["puma560", "pendulum", "driven_pendulum", "rolling_disc", "cart_with_spring", "gimbals"] {
        let model = read(name);
        let value = |p: &tripos_derive::model::Parameter| match &p.value {
            Some(value) => DoubleDouble::from_rational(value),
            None => DoubleDouble::from(if p.is_input { 0.0 } else { 0.7 }),
        };
        let p: Vec<DoubleDouble> = model.parameters.iter().map(value).collect();
        let (inverse, states) = (InverseDynamics::new(&model, &[]).unwrap(), states(&model));
        for varied in [RegressorParameters::Bodies, RegressorParameters::Declared] {
            let found = identify(&model, varied).unwrap();
            let values: Vec<DoubleDouble> = base_parameter_values(&model, &found, &p)
                .unwrap()
                .into_iter()
                .map(|x| x.expect("closed forms"))
                .collect();
            for row in regressor_rows(&model, &found, &p, &states).unwrap() {
                let wanted = inverse.required_forces_at(&p, &states[row.state]).unwrap().along[row.speed];
                let sum = row.factors.iter().zip(&values).fold(row.rest, |sum, (y, x)| sum + *y * *x);
                let size =
                    row.factors.iter().zip(&values).fold(1.0, |most: f64, (y, x)| most.max((*y * *x).hi().abs()));
                let off = (sum - wanted).hi().abs();
                assert!(off < 1e-27 * size, "{name}: {off:e} of {size:e}");
            }
        }
    }
}

/// Motions of mechanisms with loops, on the branch of closed poses of their scenes.
const CLOSED_MOTIONS: [(&str, &str); 5] = [
    ("four_bar", "[motion]\nq1 = \"1 + 0.5*sin(3*t)\"\n[guess]\nq2 = 0.3\nq3 = 1\n"),
    (
        "governor",
        "[motion]\npsi = \"2*t\"\ntheta = \"0.5 + 0.3*sin(3*t)\"\n\
         [guess]\nq_right_top = -0.5\nq_left_ball = -1\nq_right_ball = 1\n",
    ),
    // The other assembly of the same governor: both arms on one side.
    (
        "governor",
        "[motion]\npsi = \"2*t\"\ntheta = \"0.5 + 0.3*sin(3*t)\"\n\
         [guess]\nq_right_top = 0.5\nq_left_ball = -1\nq_right_ball = -1\n",
    ),
    (
        "window_linkage",
        "[motion]\nq = \"-0.9 + 0.4*sin(3*t)\"\n\
         [guess]\nq_ground1 = -0.9\nq_ground2 = -0.9\nq_pin1 = 0.9\nq_pin2 = 0.9\n",
    ),
    (
        "bricard",
        "[motion]\nq_P4 = \"0.5 + 0.2*sin(3*t)\"\n\
         [guess]\nq_P1 = -0.33\nq_P2 = -0.5\nq_P3 = 0.33\nq_P5 = 0.33\n",
    ),
];

/// Goal: base parameters of mechanisms with loops give the forces of the model in closed poses, grouped by these poses
/// and not, and the ungrouped ones at other lengths too. Method: M u' − f by Kane's equations, on the branch of the
/// scenes, which is one of several. Random closed poses of the governor and of the windows are singular in most cases
/// (links folded back on arms): columns that were rounding errors there gave factors of 6e14.
#[test]
fn groups_of_closed_poses_give_the_forces_of_the_model() {
    for (name, motion) in CLOSED_MOTIONS {
        for longer in ["", "[parameters]\nl = 0.9\n"] {
            if !longer.is_empty() && name == "four_bar" {
                continue;
            }
            let mut model = read(name);
            let text = format!("{longer}{motion}[times]\nfrom = 0\nto = 1\ncount = 11\n");
            let motion =
                load_motion(&Source::from_text("motion.toml", &text), &mut model).unwrap_or_else(|e| panic!("{e}"));
            let states = motion_samples(&model, &motion).unwrap_or_else(|e| panic!("{name}: {e}"));
            let (inverse, p) = (InverseDynamics::new(&model, &[]).unwrap(), &motion.parameters);
            let mut found = identify(&model, RegressorParameters::Bodies).unwrap();
            assert!(found.is_minimal(), "{name}: {:?}", found.on_loops);
            for grouped in [true, false] {
                if !grouped {
                    found.ungroup();
                }
                if grouped && !longer.is_empty() {
                    continue;
                }
                let values = base_parameter_values(&model, &found, p).unwrap();
                let values: Vec<DoubleDouble> = values.into_iter().map(|x| x.expect("a value")).collect();
                for row in regressor_rows(&model, &found, p, &states).unwrap() {
                    let wanted = inverse.required_forces_at(p, &states[row.state]).unwrap().along[row.speed];
                    let terms = row.factors.iter().zip(&values).map(|(y, x)| *y * *x);
                    let (mut sum, mut size) = (row.rest, 1.0_f64);
                    for term in terms {
                        sum = sum + term;
                        size = size.max(term.hi().abs());
                    }
                    let off = (sum - wanted).hi().abs();
                    // Factors of groups are doubles.
                    let most = if found.before_grouping().is_some() { 1e-8 } else { 1e-22 };
                    assert!(off < most * size && size < 1e6, "{name} {grouped} {longer}: {off:e} of {size:e}");
                }
            }
        }
    }
}

/// Goal: a table of samples is read by names, and its errors are reported. Method: columns in another order, and one of
/// each error.
#[test]
fn tables_of_samples_are_read_by_names() {
    let model = parse(PENDULUM);
    let read = |text: &str| load_samples(&Source::from_text("samples.csv", text), &model);
    let list = read("u',t,q,u\n0.5,1,2,3\n1,2,3,4\n").unwrap();
    assert_eq!((list.len(), list[0].t, list[0].rates[0].hi(), list[1].q[0].hi()), (2, Some(1.0), 0.5, 3.0));
    for (text, wrong) in [
        ("q,u\n1,2\n", "the table has no column `u'`"),
        ("q,u,u'\n1,2,x\n", "row 1 has no number in `u'`: `x`"),
        ("q,u,u'\n", "the table has no rows"),
        ("q,u,u'\n1,2\n", "a row has 2 cells, but the head has 3"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.list[0].message.starts_with(wrong), "{}", error.list[0].message);
        assert!(error.place(&error.list[0]).is_some(), "{text}: the error has a place in the table");
    }
}

/// Goal: every error in a given motion is reported. Method: one of each kind.
#[test]
fn wrong_motions_are_refused() {
    for (text, wrong) in [
        ("[parameters]\n", "the file is no motion"),
        ("[motion]\nq = \"sin(3*z)\"\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "`z` cannot stand in a motion"),
        ("[motion]\np = 1\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "the model has no coordinate `p`"),
        ("[motion]\nq = 1\n[times]\nfrom = 0\nto = 1\ncount = 2.5\n", "`count` is 2.5"),
        ("[motion]\nq = 1\n", "the motion has no `times`"),
        ("[motion]\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "no formula for q"),
        ("[state]\nq = 1\nu = 1\n", "no value for u'"),
        ("[state]\nq = 1\nu = 1\n[accelerations]\n\"w'\" = 1\n", "the model has no acceleration `w'`"),
    ] {
        let error = load_motion(&Source::from_text("motion.toml", text), &mut parse(PENDULUM)).unwrap_err();
        assert!(error.list.iter().any(|d| d.message.starts_with(wrong)), "{text}: {error}");
    }
}
