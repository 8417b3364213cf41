//! Parameters from measurements: forces by linear least squares, and runs by nonlinear ones.
//!
//! Truth: the parameters with which the data were made. Noise comes from a seeded generator, so that the draws are the
//! same on every machine. Numbers by SciPy are in tests/cli/fit.rs.

use crate::random::Random;
use nalgebra::Matrix4;
use std::fmt::Write;
use std::path::Path;
use tripos::fit::force_fit::{ForceFit, MeasuredMotion, fit_to_forces};
use tripos::fit::motion_tables::motion_of_table;
use tripos::fit::possible_inertia::possible_inertia;
use tripos::fit::run_fit::{Experiment, fit_to_runs};
use tripos::fit::{Fit, FitOptions, Unknown};
use tripos::studies::identification::{base_parameter_values, identify};
use tripos::studies::inverse::InverseDynamics;
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::diagnostic::Source;
use tripos_derive::identify::Identification;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::scene::{MeasuredTable, MotionSample};
use tripos_traits::{DoubleDouble, Real};

/// Number of draws of the noise.
const DRAWS: usize = 100;
/// Least number of draws in which an estimate is within three standard errors of the truth.
const WITHIN: usize = 95;

/// Number of the normal distribution of standard deviation 1 (Box & Muller 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.between(1e-300, 1.0).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.between(0.0, 1.0)).cos()
}

fn mechanism(text: &str) -> Mechanism {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    Mechanism::new(model)
}

fn library(model: &str) -> Mechanism {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

/// Three joints: a column and two links in a plane that turns with it. All links have full inertias.
const ARM: &str = r#"
name = "Arm of three joints"
[parameters]
g = "9.81 m/s^2"
a = "0.4 m"
m1 = "6 kg"
m2 = "4 kg"
m3 = "2 kg"
d = "0.3 N*m*s"
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
q3 = { unit = "rad" }
[speeds]
u1 = "q1'"
u2 = "q2'"
u3 = "q3'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q1" }
B0 = { from = "A", axis = 1, angle = "pi/2" }
B = { from = "B0", axis = 3, angle = "q2" }
C = { from = "B", axis = 3, angle = "q3" }
[points]
elbow = { from = "O", frame = "B", position = ["a", 0, 0] }
C1 = { from = "O", frame = "A", position = ["0.02 m", "0.01 m", "0.1 m"] }
C2 = { from = "O", frame = "B", position = ["0.2 m", "0.03 m", "-0.02 m"] }
C3 = { from = "elbow", frame = "C", position = ["0.15 m", "-0.02 m", "0.04 m"] }
[bodies]
column = { frame = "A", centre = "C1", mass = "m1", inertia = { diagonal = ["0.05 kg*m^2", "0.06 kg*m^2", "0.04 kg*m^2"], products = ["0.002 kg*m^2", "0.001 kg*m^2", "0.003 kg*m^2"] } }
upper = { frame = "B", centre = "C2", mass = "m2", inertia = { diagonal = ["0.01 kg*m^2", "0.06 kg*m^2", "0.065 kg*m^2"], products = ["0.001 kg*m^2", "0.002 kg*m^2", "-0.001 kg*m^2"] } }
fore = { frame = "C", centre = "C3", mass = "m3", inertia = { diagonal = ["0.004 kg*m^2", "0.02 kg*m^2", "0.021 kg*m^2"], products = ["0.0005 kg*m^2", "-0.0005 kg*m^2", "0.001 kg*m^2"] } }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
[torques]
friction = { on = "fore", against = "upper", frame = "B", vector = [0, 0, "-d*u3"] }
"#;

/// Default values of the parameters, with 0 for inputs.
fn defaults(model: &Mechanism) -> Vec<DoubleDouble> {
    let value = |p: &tripos_derive::model::Parameter| {
        p.value.as_ref().map_or_else(|| DoubleDouble::from(0.0), DoubleDouble::from_rational)
    };
    model.parameters.iter().map(value).collect()
}

/// Sums of sines for all coordinates, of which the speeds are the rates, and the forces that they need. Coordinates
/// beyond the first `moving` ones rest.
fn motions(model: &Mechanism, instants: usize, moving: usize) -> Vec<MeasuredMotion> {
    let inverse = InverseDynamics::new(model, &[]).unwrap_or_else(|e| panic!("{e}"));
    let p = defaults(model);
    let at = |k: usize| {
        let t = 8.0 * k as f64 / instants as f64;
        let (mut q, mut u, mut rates) = (Vec::new(), Vec::new(), Vec::new());
        for joint in 0..model.coordinates.len() {
            let (mut x, mut v, mut a) = (0.3, 0.0, 0.0);
            for wave in 1..=4 {
                let (w, phase) = (0.8 * f64::from(wave), 1.1 * joint as f64 + 0.6 * f64::from(wave));
                let size = if joint < moving { 0.9 / f64::from(wave) } else { 0.0 };
                x += size * (w * t + phase).sin();
                v += size * w * (w * t + phase).cos();
                a -= size * w * w * (w * t + phase).sin();
            }
            q.push(x);
            u.push(v);
            rates.push(a);
        }
        let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from(*x)).collect::<Vec<_>>();
        let sample = MotionSample { t: Some(t), q: wide(&q), u: wide(&u), rates: wide(&rates) };
        let forces = inverse.required_forces_at(&p, &sample).unwrap_or_else(|e| panic!("{e}"));
        let forces = forces.along.iter().map(|force| force.to_f64()).collect();
        MeasuredMotion { t: Some(t), p: p.iter().map(|x| x.to_f64()).collect(), q, u, rates, forces }
    };
    (0..instants).map(at).collect()
}

/// Motions whose forces have noise, of this size relative to the largest force along each speed.
fn noisy(exact: &[MeasuredMotion], noise: f64, random: &mut Random) -> Vec<MeasuredMotion> {
    let speeds = exact[0].forces.len();
    let size = |speed: usize| exact.iter().fold(0.0_f64, |most, moving| most.max(moving.forces[speed].abs()));
    let sizes: Vec<f64> = (0..speeds).map(size).collect();
    let mut list = exact.to_vec();
    for moving in &mut list {
        for (force, size) in moving.forces.iter_mut().zip(&sizes) {
            *force += noise * size * normal(random);
        }
    }
    list
}

fn identified(model: &Mechanism) -> (Identification, Vec<f64>) {
    let found = identify(model, RegressorParameters::Bodies).unwrap_or_else(|e| panic!("{e}"));
    let values = base_parameter_values(model, &found, &defaults(model)).unwrap_or_else(|e| panic!("{e}"));
    let values = values.into_iter().map(|value| value.expect("a formula").to_f64()).collect();
    (found, values)
}

fn forces(model: &Mechanism, found: &Identification, data: Vec<MeasuredMotion>, options: &FitOptions) -> ForceFit {
    fit_to_forces(model, found, &[data], options).unwrap_or_else(|e| panic!("{e}"))
}

/// Goal: standard errors are honest. Method: base parameters of a Furuta pendulum and of an arm with three joints from
/// noisy forces; each is within three standard errors in at least 95 of 100 draws.
#[test]
fn base_parameters_are_within_three_standard_errors() {
    for (model, name) in [(library("furuta"), "furuta"), (mechanism(ARM), "arm")] {
        let (found, truth) = identified(&model);
        let exact = motions(&model, 150, 3);
        let mut random = Random(81);
        let mut hits = vec![0; truth.len()];
        for _ in 0..DRAWS {
            let data = noisy(&exact, 0.03, &mut random);
            let fit = forces(&model, &found, data, &FitOptions::default());
            assert!(fit.fit.untold.is_empty() && fit.unseen.unwrap() < 1.5, "{name}: {:?}", fit.unseen);
            for (hit, (estimate, truth)) in hits.iter_mut().zip(fit.fit.estimates.iter().zip(&truth)) {
                *hit += usize::from((estimate.value - truth).abs() <= 3.0 * estimate.error.unwrap());
            }
        }
        assert!(hits.iter().all(|hit| *hit >= WITHIN), "{name}: {hits:?} of {DRAWS}");
    }
}

/// Goal: without noise, the fit gives the parameters of the model. Method: an arm with three joints.
#[test]
fn exact_forces_give_back_the_model() {
    let model = mechanism(ARM);
    let (found, truth) = identified(&model);
    let fit = forces(&model, &found, motions(&model, 60, 3), &FitOptions::default());
    for (estimate, truth) in fit.fit.estimates.iter().zip(&truth) {
        assert!((estimate.value - truth).abs() < 1e-11, "{}: {} not {truth}", estimate.name, estimate.value);
        assert!((estimate.stated.unwrap() - truth).abs() < 1e-12);
    }
}

/// Goal: a motion that excites too little names what it leaves open. Method: only the column moves; the forces do not
/// change along each named combination.
#[test]
fn what_data_leave_open_is_named() {
    let model = mechanism(ARM);
    let (found, _) = identified(&model);
    let exact = motions(&model, 60, 1);
    let fit = forces(&model, &found, noisy(&exact, 0.01, &mut Random(82)), &FitOptions::default()).fit;
    assert!(!fit.untold.is_empty());
    let rows = |model: &Mechanism| {
        let samples: Vec<MotionSample> = exact
            .iter()
            .map(|moving| {
                let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from(*x)).collect::<Vec<_>>();
                MotionSample { t: None, q: wide(&moving.q), u: wide(&moving.u), rates: wide(&moving.rates) }
            })
            .collect();
        tripos::studies::identification::regressor_rows(model, &found, &defaults(model), &samples).unwrap()
    };
    let rows = rows(&model);
    for direction in &fit.untold {
        for row in &rows {
            let terms = direction.iter().map(|(at, rate)| row.factors[*at].to_f64() * rate);
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
            assert!(sum.abs() <= 1e-2 * size.max(1e-9), "{direction:?}: {sum}");
        }
    }
    let is_open = |at: usize| fit.untold.iter().flatten().any(|(open, _)| *open == at);
    for (at, estimate) in fit.estimates.iter().enumerate() {
        assert_eq!(estimate.error.is_none(), is_open(at), "{}", estimate.name);
    }
}

/// Goal: outliers move robust estimates little. Method: every twentieth force is far off.
#[test]
fn outliers_move_robust_estimates_little() {
    let model = mechanism(ARM);
    let (found, truth) = identified(&model);
    let mut data = noisy(&motions(&model, 300, 3), 0.01, &mut Random(83));
    for moving in data.iter_mut().step_by(20) {
        moving.forces.iter_mut().for_each(|force| *force += 30.0);
    }
    let off = |is_robust: bool| {
        let options = FitOptions { is_robust, ..FitOptions::default() };
        let fit = forces(&model, &found, data.clone(), &options).fit;
        let each = fit.estimates.iter().zip(&truth).map(|(estimate, truth)| (estimate.value - truth).powi(2));
        each.sum::<f64>().sqrt()
    };
    assert!(3.0 * off(true) < off(false), "{} and {}", off(true), off(false));
}

/// Goal: possible inertias are those of real bodies, and near the forces. Method: pseudo-inertias are positive definite
/// at any noise; at little noise, the forces are met as well as without the condition.
#[test]
fn possible_inertias_are_those_of_real_bodies() {
    let model = mechanism(ARM);
    let (found, _) = identified(&model);
    let exact = motions(&model, 100, 3);
    for (seed, noise) in [(1, 0.001), (2, 0.1), (3, 0.5), (4, 2.0)] {
        let data = vec![noisy(&exact, noise, &mut Random(seed))];
        let fit = fit_to_forces(&model, &found, &data, &FitOptions::default()).unwrap_or_else(|e| panic!("{e}"));
        let possible = possible_inertia(&model, &found, &data, &fit).unwrap_or_else(|e| panic!("{e}"));
        assert!(possible.residual >= 0.999_999 * possible.free_residual, "{noise}");
        if noise < 0.01 {
            assert!(
                possible.residual < 1.001 * possible.free_residual,
                "{} {}",
                possible.residual,
                possible.free_residual
            );
        }
        let value = |name: &str| possible.parameters.iter().find(|(known, ..)| known == name).unwrap().2;
        for body in ["column", "upper", "fore"] {
            let of = |name: &str| value(&format!("{name}_{body}"));
            let trace = 0.5 * (of("Ixx") + of("Iyy") + of("Izz"));
            let [x, y, z] = [of("mx"), of("my"), of("mz")];
            let pseudo = Matrix4::from_row_slice(&[
                trace - of("Ixx"),
                -of("Ixy"),
                -of("Ixz"),
                x,
                -of("Ixy"),
                trace - of("Iyy"),
                -of("Iyz"),
                y,
                -of("Ixz"),
                -of("Iyz"),
                trace - of("Izz"),
                z,
                x,
                y,
                z,
                of("m"),
            ]);
            let least = pseudo.symmetric_eigenvalues().min();
            assert!(least > -1e-12 * pseudo.norm(), "{body} at {noise}: {least}");
        }
    }
}

/// Goal: speeds and accelerations come from coordinates alone. Method: a table of coordinates and forces of the arm,
/// without noise, differentiated and filtered.
#[test]
fn tables_of_coordinates_are_differentiated() {
    let model = mechanism(ARM);
    let (found, truth) = identified(&model);
    let exact = motions(&model, 4000, 3);
    let mut text = "t,q1,q2,q3,force(u1),force(u2),force(u3)\n".to_owned();
    for moving in &exact {
        let row = [&[moving.t.unwrap()][..], &moving.q, &moving.forces].concat();
        text += &(row.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",") + "\n");
    }
    let table = MeasuredTable::read(&Source::from_text("data.csv", &text)).unwrap_or_else(|e| panic!("{e}"));
    for (cut_off, accuracy) in [(None, 1e-4), (Some(50.0), 1e-3)] {
        let data = motion_of_table(&model, "data.csv", &table, cut_off).unwrap_or_else(|e| panic!("{e}"));
        assert!(data.unused.is_empty() && !data.has_inputs_and_forces);
        let fit = forces(&model, &found, data.motions, &FitOptions::default()).fit;
        for (estimate, truth) in fit.estimates.iter().zip(&truth) {
            assert!((estimate.value - truth).abs() < accuracy, "{}: {} not {truth}", estimate.name, estimate.value);
        }
    }
}

/// Goal: standard errors stay honest after a filter, which makes neighbouring errors alike. Method: an arm of which
/// only the forces have noise, filtered well below half of the sampling frequency.
#[test]
fn filtered_forces_are_within_three_standard_errors() {
    let model = mechanism(ARM);
    let (found, truth) = identified(&model);
    let exact = motions(&model, 1600, 3);
    let mut random = Random(86);
    let mut squares = vec![0.0; truth.len()];
    let draws = 40;
    for _ in 0..draws {
        let data = noisy(&exact, 0.05, &mut random);
        let mut text = "t,q1,q2,q3,u1,u2,u3,u1',u2',u3',force(u1),force(u2),force(u3)\n".to_owned();
        for moving in &data {
            let row = [&[moving.t.unwrap()][..], &moving.q, &moving.u, &moving.rates, &moving.forces].concat();
            text += &(row.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",") + "\n");
        }
        let table = MeasuredTable::read(&Source::from_text("data.csv", &text)).unwrap_or_else(|e| panic!("{e}"));
        let data = motion_of_table(&model, "data.csv", &table, Some(15.0)).unwrap_or_else(|e| panic!("{e}"));
        let options = FitOptions { rows_for_each_error: data.rows_for_each_error, ..FitOptions::default() };
        let fit = forces(&model, &found, data.motions, &options).fit;
        for (square, (estimate, truth)) in squares.iter_mut().zip(fit.estimates.iter().zip(&truth)) {
            *square += ((estimate.value - truth) / estimate.error.unwrap()).powi(2);
        }
    }
    let mean = squares.iter().sum::<f64>() / (draws * squares.len()) as f64;
    assert!((0.7..1.4).contains(&mean.sqrt()), "{}", mean.sqrt());
}

/// Goal: a search does not leave a start that fits. Method: a chaotic run, whose truth is the scene's own.
#[test]
fn a_search_stays_at_a_start_that_fits() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/chaotic_pendulum/scenes");
    let file = std::fs::read_dir(path).unwrap().next().unwrap().unwrap().path();
    let scene = Scene::read(&file).unwrap_or_else(|e| panic!("{e}"));
    let model = scene.mechanism();
    let output = model.coordinates[0].name.clone();
    let parameter = model.parameters.iter().find(|p| !p.is_input && p.value.is_some()).unwrap().name.clone();
    let value = scene.number(&parameter).unwrap();
    let table = measured(&scene, &[(&parameter, value)], &[&output], 1e-3, &mut Random(87));
    let fit = runs(&scene, vec![table], &[unknown(&parameter)]);
    let estimate = &fit.estimates[0];
    assert!((estimate.value - value).abs() <= 4.0 * estimate.error.unwrap(), "{estimate:?}, not {value}");
    assert!(!fit.quantities[0].has_pattern);
}

/// Pendulum with drag.
const PENDULUM: &str = r#"
name = "Pendulum with drag"
[parameters]
g = "9.81 m/s^2"
m = "1 kg"
l = "0.6 m"
c = "0.1 kg/s"
[coordinates]
theta = { unit = "rad" }
[speeds]
omega = "theta'"
[inertial]
frame = "N"
origin = "O"
[frames]
R = { from = "N", axis = 3, angle = "theta" }
[points]
P = { from = "O", frame = "R", position = [0, "-l", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces]
drag = { on = "bob", frame = "R", vector = ["-c*l*omega", 0, 0] }
"#;

fn unknown(name: &str) -> Unknown {
    Unknown { name: name.to_owned(), bounds: f64::NEG_INFINITY..=f64::INFINITY, prior: None }
}

/// Measured values of outputs of a scene at other numbers, with noise.
fn measured(
    scene: &Scene,
    numbers: &[(&str, f64)],
    outputs: &[&str],
    noise: f64,
    random: &mut Random,
) -> MeasuredTable {
    let instants: Vec<f64> = (1..=60).map(|k| 0.05 * f64::from(k)).collect();
    let names: Vec<String> = outputs.iter().map(|name| (*name).to_owned()).collect();
    let numbers: Vec<(String, f64)> = numbers.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect();
    let scene = scene.with_numbers(&numbers).unwrap().with_outputs_at(&names, &instants).unwrap();
    let how = Overrides { until: Some(3.0), rtol: Some(1e-9), atol: Some(1e-12), ..Overrides::default() };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{e}"));
    let mut text = format!("t,{}\n", outputs.join(","));
    for (at, t) in instants.iter().enumerate() {
        let _ = write!(text, "{t:?}");
        for name in &names {
            let value = run.column_of_quantity(name).unwrap()[at] + noise * normal(random);
            let _ = write!(text, ",{value:?}");
        }
        text.push('\n');
    }
    MeasuredTable::read(&Source::from_text("data.csv", &text)).unwrap_or_else(|e| panic!("{e}"))
}

fn runs(scene: &Scene, tables: Vec<MeasuredTable>, unknowns: &[Unknown]) -> Fit {
    let experiments =
        tables.into_iter().map(|table| Experiment { name: "data".to_owned(), scene: scene.clone(), table });
    fit_to_runs(experiments.collect(), unknowns, &FitOptions::default(), &Overrides::default())
        .unwrap_or_else(|e| panic!("{e}"))
}

/// Goal: standard errors of runs are honest. Method: length, drag and start of a pendulum from noisy angles, from a
/// guess far away; each is within three standard errors in at least 95 of 100 draws.
#[test]
fn pendulums_are_within_three_standard_errors() {
    let start = "span = [0, 3]\n[start]\ntheta = 1\nomega = 0\n";
    let scene = Scene::parse(mechanism(PENDULUM), start).unwrap_or_else(|e| panic!("{e}"));
    let truth = [("l", 0.8), ("c", 0.25), ("theta", 1.3), ("omega", 0.4)];
    let unknowns = truth.map(|(name, _)| unknown(name));
    let mut random = Random(84);
    let mut hits = [0; 4];
    for _ in 0..DRAWS {
        let table = measured(&scene, &truth, &["theta"], 0.02, &mut random);
        let fit = runs(&scene, vec![table], &unknowns);
        assert!(fit.has_converged && fit.untold.is_empty());
        for (hit, (estimate, (_, truth))) in hits.iter_mut().zip(fit.estimates.iter().zip(truth)) {
            *hit += usize::from((estimate.value - truth).abs() <= 3.0 * estimate.error.unwrap());
        }
    }
    assert!(hits.iter().all(|hit| *hit >= WITHIN), "{hits:?} of {DRAWS}");
}

/// Goal: parameters are shared by experiments, and starts are not. Method: two swings of a Furuta pendulum from
/// different angles, measured as angles and as an output with a formula.
#[test]
fn experiments_share_parameters_and_have_their_own_starts() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/furuta/scenes/swing.toml");
    let scene = Scene::read(&path).unwrap_or_else(|e| panic!("{e}"));
    let model = scene.mechanism();
    let angle = model.coordinates[1].name.clone();
    let mass = model.parameters.iter().find(|p| p.unit.to_string() == "kg").unwrap().name.clone();
    let value = scene.number(&mass).unwrap();
    let mut random = Random(85);
    let outputs = [model.coordinates[0].name.clone(), format!("sin({angle})")];
    let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
    let first = measured(&scene, &[(&mass, value), (&angle, 0.5)], &outputs, 1e-4, &mut random);
    let second = measured(&scene, &[(&mass, value), (&angle, 0.9)], &outputs, 1e-4, &mut random);
    let guess = scene.with_numbers(&[(mass.clone(), 0.9 * value), (angle.clone(), 0.6)]).unwrap();
    let fit = runs(&guess, vec![first, second], &[unknown(&mass), unknown(&angle)]);
    let of = |at: usize, truth: f64| {
        let estimate = &fit.estimates[at];
        let error = estimate.error.unwrap();
        assert!((estimate.value - truth).abs() <= 4.0 * error && error < 0.01, "{estimate:?}, not {truth}");
    };
    assert_eq!(fit.estimates.iter().map(|e| e.experiment).collect::<Vec<_>>(), [None, Some(0), Some(1)]);
    of(0, value);
    of(1, 0.5);
    of(2, 0.9);
}
