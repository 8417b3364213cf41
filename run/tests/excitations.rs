//! Motions for identification: limits, information, and combinations that no motion determines.
//!
//! Truth: formulas of the series in this file, random motions within the limits, and numbers by NumPy from a regressor
//! that is written by hand (tests/data/excite/reference.py).

use crate::random::Random;
use std::f64::consts::TAU;
use std::path::Path;
use tripos::fit::excitation::{
    Excitation, ExcitationOptions, FourierSeries, QuantityLimit, design_excitation, information_of_samples,
};
use tripos::studies::identification::identify;
use tripos::{Error, Mechanism};
use tripos_derive::diagnostic::Source;
use tripos_derive::identify::Identification;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::scene::{MotionSample, load_samples};

/// Number of random motions with which a designed motion is compared.
const OTHERS: usize = 100;

/// Number of instants of the grid of the design, for each period of the highest harmonic.
const FINE: usize = 1024;

/// Pendulum with friction, and with limits of its angle in the domain.
const PENDULUM: &str = r#"
name = "Pendulum"
[parameters]
g = "9.81 m/s^2"
l = "0.5 m"
m = "2 kg"
I = "0.1 kg*m^2"
d = "0.3 N*m*s"
reach = "1.2 rad"
fast = "4 rad/s"
[coordinates]
theta = { unit = "rad" }
[speeds]
omega = "theta'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "theta" }
[points]
C = { from = "O", frame = "B", position = [0, "-l", 0] }
[bodies]
rod = { frame = "B", centre = "C", mass = "m", inertia = "I" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[torques]
friction = { on = "rod", frame = "N", vector = [0, 0, "-d*omega"] }
[domain]
near = "abs(theta - 0.1) < reach"
slow = "omega < fast"
"#;

fn mechanism(text: &str) -> Mechanism {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    Mechanism::new(model)
}

fn file(path: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data").join(path)
}

fn arm() -> Mechanism {
    Mechanism::read(&file("fit/arm.toml")).unwrap_or_else(|e| panic!("{e}"))
}

fn base(model: &Mechanism) -> Identification {
    identify(model, RegressorParameters::Bodies).unwrap_or_else(|e| panic!("{e}"))
}

fn limit(name: &str, low: f64, high: f64) -> QuantityLimit {
    QuantityLimit { name: name.to_owned(), low, high }
}

fn limits_of_arm() -> Vec<QuantityLimit> {
    vec![
        limit("q1", -1.2, 1.2),
        limit("q2", -1.5, 1.5),
        limit("u1", -3.0, 3.0),
        limit("q1''", -12.0, 12.0),
        limit("u2'", -12.0, 12.0),
    ]
}

fn design(model: &Mechanism, found: &Identification, options: &ExcitationOptions) -> Excitation {
    design_excitation(model, found, options).unwrap_or_else(|e| panic!("{e}"))
}

fn refused(model: &Mechanism, options: &ExcitationOptions) -> String {
    match design_excitation(model, &base(model), options) {
        Ok(_) => panic!("a motion was found"),
        Err(error) => error.to_string(),
    }
}

/// Value, rate and second rate of a series at an instant, by its formula.
fn at(series: &FourierSeries, period: f64, t: f64) -> [f64; 3] {
    let mut values = [series.mean, 0.0, 0.0];
    for (k, (sine, cosine)) in series.sines.iter().zip(&series.cosines).enumerate() {
        let w = TAU * (k + 1) as f64 / period;
        let (sin, cos) = (w * t).sin_cos();
        values[0] += sine * sin + cosine * cos;
        values[1] += w * (sine * cos - cosine * sin);
        values[2] -= w * w * (sine * sin + cosine * cos);
    }
    values
}

/// Checks limits and extreme values on a grid ten times finer than the one of the design.
fn check_limits(motion: &Excitation, period: f64) {
    for (series, quantities) in motion.series.iter().zip(motion.extremes.chunks(3)) {
        let points = 10 * FINE * series.sines.len();
        let (mut least, mut largest) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in 0..=points {
            let values = at(series, period, period * point as f64 / points as f64);
            for (order, value) in values.into_iter().enumerate() {
                (least[order], largest[order]) = (least[order].min(value), largest[order].max(value));
            }
        }
        for ((quantity, least), largest) in quantities.iter().zip(least).zip(largest) {
            let name = &quantity.name;
            assert!(quantity.low.is_none_or(|low| least >= low), "{name}: {least}");
            assert!(quantity.high.is_none_or(|high| largest <= high), "{name}: {largest}");
            // The grid misses extreme values by up to (2π/10 240)²/8 of them. The design refines them.
            let (span, tiny) = (largest - least, 1e-12 * (largest - least));
            let missed = [least - quantity.least, quantity.largest - largest];
            assert!(missed.iter().all(|missed| (-tiny..=1e-7 * span).contains(missed)), "{name}: {missed:?}");
        }
    }
}

/// Samples of a motion of which the speeds are the rates of the coordinates.
fn samples(series: &[FourierSeries], options: &ExcitationOptions) -> Vec<MotionSample> {
    let sample = |k: usize| {
        let t = options.period * k as f64 / (options.samples - 1) as f64;
        let values: Vec<[f64; 3]> = series.iter().map(|series| at(series, options.period, t)).collect();
        let of = |order: usize| values.iter().map(|x| x[order].into()).collect();
        MotionSample { t: Some(t), q: of(0), u: of(1), rates: of(2) }
    };
    (0..options.samples).map(sample).collect()
}

/// Random motion of the same size as a designed one, which touches a limit of each coordinate.
fn random_motion(motion: &Excitation, options: &ExcitationOptions, random: &mut Random) -> Vec<MotionSample> {
    let (period, harmonics) = (options.period, options.harmonics);
    let series: Vec<FourierSeries> = motion
        .extremes
        .chunks(3)
        .map(|quantities| {
            let mut draw = || (1..=harmonics).map(|l| random.between(-1.0, 1.0) / l as f64).collect::<Vec<f64>>();
            let mut series = FourierSeries { mean: 0.0, sines: draw(), cosines: draw() };
            let values: Vec<[f64; 3]> =
                (0..=4000).map(|k| at(&series, period, period * f64::from(k) / 4000.0)).collect();
            let least = |order: usize| values.iter().fold(f64::INFINITY, |least, x| least.min(x[order]));
            let largest = |order: usize| values.iter().fold(f64::NEG_INFINITY, |most, x| most.max(x[order]));
            let bound = |quantity: usize| {
                let of = &quantities[quantity];
                (of.low.unwrap_or(f64::NEG_INFINITY), of.high.unwrap_or(f64::INFINITY))
            };
            let (low, high) = bound(0);
            let mut factor = (high - low) / (largest(0) - least(0));
            for order in 1..3 {
                let (low, high) = bound(order);
                factor = factor.min(low / least(order)).min(high / largest(order));
            }
            series.sines.iter_mut().chain(&mut series.cosines).for_each(|x| *x *= factor);
            let room = (high - low) - factor * (largest(0) - least(0));
            series.mean = low - factor * least(0) + random.between(0.0, 1.0) * room;
            series
        })
        .collect();
    samples(&series, options)
}

/// Checks that a designed motion tells more than random motions with the same limits, and returns it.
fn check_against_random(model: &Mechanism, found: &Identification, options: &ExcitationOptions) -> Excitation {
    let motion = design(model, found, options);
    check_limits(&motion, options.period);
    let again = information_of_samples(model, found, &motion.samples, &options.noise).unwrap();
    assert!((again.log_determinant - motion.information.log_determinant).abs() < 1e-9);
    let mut random = Random(7);
    for _ in 0..OTHERS {
        let samples = random_motion(&motion, options, &mut random);
        let other = information_of_samples(model, found, &samples, &options.noise).unwrap();
        assert!(
            other.log_determinant < again.log_determinant,
            "{} and {}",
            other.log_determinant,
            again.log_determinant
        );
    }
    let same = design(model, found, options);
    assert_eq!(motion.series, same.series, "equal input gives equal motions");
    motion
}

/// Goal: a designed motion keeps its limits and beats random ones. Method: a pendulum with limits in its domain.
#[test]
fn a_pendulum_moves_within_its_domain() {
    let model = mechanism(PENDULUM);
    let options = ExcitationOptions {
        period: 4.0,
        starts: 2,
        limits: vec![limit("omega'", -20.0, 20.0)],
        ..ExcitationOptions::default()
    };
    let found = base(&model);
    let motion = check_against_random(&model, &found, &options);
    let close = |x: Option<f64>, wanted: f64| x.is_some_and(|x| (x - wanted).abs() < 1e-14);
    assert!(close(motion.extremes[0].low, -1.1) && close(motion.extremes[0].high, 1.3), "{:?}", motion.extremes[0]);
    assert!(motion.extremes[1].low.is_none() && close(motion.extremes[1].high, 4.0), "{:?}", motion.extremes[1]);
    assert!(motion.unchecked.is_empty() && motion.conditions.is_empty());
}

/// Goal: a designed motion keeps its limits and beats random ones, and all pairs of sines. Method: an arm of two links,
/// with known noise; a sine of each joint at each harmonic, which touches a limit.
#[test]
fn an_arm_moves_better_than_at_random() {
    let model = arm();
    let options = ExcitationOptions {
        limits: limits_of_arm(),
        starts: 2,
        noise: vec![("force(u2)".to_owned(), 0.2)],
        ..ExcitationOptions::default()
    };
    let found = base(&model);
    let best = check_against_random(&model, &found, &options).information.log_determinant;
    let sine = |harmonic: usize, most: [f64; 3]| {
        let w = TAU * harmonic as f64 / options.period;
        let mut series = FourierSeries::constant(0.0, options.harmonics);
        series.sines[harmonic - 1] = most[0].min(most[1] / w).min(most[2] / w.powi(2));
        series
    };
    for pair in 0..25 {
        let list = [sine(pair / 5 + 1, [1.2, 3.0, 12.0]), sine(pair % 5 + 1, [1.5, f64::INFINITY, 12.0])];
        let other = information_of_samples(&model, &found, &samples(&list, &options), &options.noise).unwrap();
        assert!(other.log_determinant < best, "{pair}: {} and {best}", other.log_determinant);
    }
}

/// Goal: a motion begins and ends at rest and at home. Method: the first and the last sample of an arm, of which one
/// coordinate has a home, and decimals of the coefficients.
#[test]
fn a_motion_begins_at_rest_and_at_home() {
    let model = arm();
    let options = ExcitationOptions {
        limits: limits_of_arm(),
        starts: 1,
        is_at_rest: true,
        home: vec![("q2".to_owned(), 0.25)],
        ..ExcitationOptions::default()
    };
    let motion = design(&model, &base(&model), &options);
    check_limits(&motion, options.period);
    for series in &motion.series {
        for t in [0.0, options.period] {
            let values = at(series, options.period, t);
            assert!(values[1].abs() < 1e-12 && values[2].abs() < 1e-11, "{values:?}");
        }
    }
    assert!((at(&motion.series[1], options.period, 0.0)[0] - 0.25).abs() < 1e-14);
    assert!(motion.information.untold.is_empty());
}

/// Goal: conditions for several coordinates hold. Method: an arm whose angles have a bounded sum of squares, at all
/// instants of a fine grid.
#[test]
fn conditions_for_several_coordinates_hold() {
    let text = std::fs::read_to_string(file("fit/arm.toml")).unwrap() + "[domain]\nround = \"q1^2 + q2^2 < 1.5\"\n";
    let model = mechanism(&text);
    let options = ExcitationOptions { limits: limits_of_arm(), starts: 1, ..ExcitationOptions::default() };
    let motion = design(&model, &base(&model), &options);
    check_limits(&motion, options.period);
    let [(name, least)] = motion.conditions.as_slice() else { panic!("{:?}", motion.conditions) };
    let margin = (0..=60_000).fold(f64::INFINITY, |margin, k| {
        let t = options.period * f64::from(k) / 60_000.0;
        let [q1, q2] = [0, 1].map(|k| at(&motion.series[k], options.period, t)[0]);
        margin.min(1.5 - q1 * q1 - q2 * q2)
    });
    assert!(name == "round" && margin > 0.0 && (least - margin).abs() < 1e-4, "{name}: {least} and {margin}");
    assert!(margin < 0.1, "the motion uses its room: {margin}");
}

/// Goal: determinant, condition number and standard errors are those of NumPy. Method: a motion that was designed for
/// the arm, and a new design that is at least as good.
#[test]
fn information_is_that_of_numpy() {
    let model = arm();
    let found = base(&model);
    let source = Source::read(&file("excite/motion.csv")).unwrap();
    let samples = load_samples(&source, &model).unwrap_or_else(|e| panic!("{e}"));
    let own = information_of_samples(&model, &found, &samples, &[]).unwrap();
    let text = std::fs::read_to_string(file("excite/reference.json")).unwrap();
    let number = |line: &str| line.trim().trim_end_matches(',').rsplit(' ').next().and_then(|x| x.parse::<f64>().ok());
    let known: Vec<f64> = text.lines().filter_map(number).collect();
    let errors = own.errors.iter().map(|error| error.expect("told"));
    let values: Vec<f64> = [own.log_determinant, own.condition].into_iter().chain(errors).collect();
    assert_eq!(values.len(), known.len());
    for (own, known) in values.iter().zip(&known) {
        assert!((own / known - 1.0).abs() < 1e-10, "{own}, not {known}");
    }
    let options = ExcitationOptions { limits: limits_of_arm(), ..ExcitationOptions::default() };
    let new = design(&model, &found, &options);
    assert!(new.information.log_determinant > known[0] - 0.05, "{} and {}", new.information.log_determinant, known[0]);
}

/// Goal: what no motion tells is named. Method: a pendulum without gravity, of which the first moments have no effect,
/// and an arm whose first joint is held.
#[test]
fn what_no_motion_tells_is_named() {
    let model = mechanism(&PENDULUM.replace("9.81 m/s^2", "0 m/s^2"));
    let found = base(&model);
    let name = |at: usize| found.regressor.columns[found.base[at].column].name.as_str();
    let options = ExcitationOptions { starts: 1, ..ExcitationOptions::default() };
    let motion = design(&model, &found, &options);
    let information = &motion.information;
    let mut untold: Vec<&str> = information.untold.iter().flatten().map(|(at, _)| name(*at)).collect();
    untold.sort_unstable();
    assert_eq!(untold, ["mx_rod", "my_rod"]);
    assert_eq!(information.rank, 2);
    assert!(information.condition.is_finite() && information.log_determinant.is_finite());

    let model = arm();
    let found = base(&model);
    let name = |at: usize| found.regressor.columns[found.base[at].column].name.as_str();
    let options = ExcitationOptions {
        limits: vec![limit("q1", 0.3, 0.3), limit("q2", -1.0, 1.0)],
        starts: 1,
        ..ExcitationOptions::default()
    };
    let motion = design(&model, &found, &options);
    let mut untold: Vec<&str> = motion.information.untold.iter().flatten().map(|(at, _)| name(*at)).collect();
    untold.sort_unstable();
    assert_eq!(untold, ["Izz_upper", "d1"], "the first link does not move");
    assert!(motion.samples.iter().all(|sample| sample.q[0] == 0.3.into() && sample.u[0] == 0.0.into()));
}

/// Goal: models and limits without a motion are refused with a reason. Method: one of each kind, by the library.
#[test]
fn models_without_a_free_motion_are_refused() {
    let library = |model: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
        Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
    };
    let options = ExcitationOptions::default();
    assert!(refused(&library("four_bar"), &options).contains("the model has loops"));
    assert!(refused(&library("disk"), &options).contains("is no rate of a coordinate"));
    assert!(refused(&library("knife_edge"), &options).contains("rate"));
    let held = ExcitationOptions {
        limits: vec![limit("q1", 0.3, 0.3), limit("q2", 0.1, 0.1)],
        ..ExcitationOptions::default()
    };
    assert!(refused(&arm(), &held).contains("no motion within the limits determines a base parameter"));
    for (low, high, message) in [
        (f64::NAN, 1.0, "the limits of `q1`, NaN and 1, are not both numbers"),
        (-1.0, f64::NAN, "the limits of `q1`, -1 and NaN, are not both numbers"),
        (1.0, -1.0, "the limits of `q1` exclude one another: 1 is above -1"),
    ] {
        let limits = vec![limit("q1", low, high), limit("q2", -1.0, 1.0)];
        let wrong = ExcitationOptions { limits, ..ExcitationOptions::default() };
        assert!(refused(&arm(), &wrong).contains(message), "{message}");
    }
    let text = std::fs::read_to_string(file("fit/arm.toml")).unwrap() + "[domain]\nfar = \"q1^2 + q2^2 > 9\"\n";
    let near = ExcitationOptions { limits: limits_of_arm(), starts: 1, ..ExcitationOptions::default() };
    assert!(refused(&mechanism(&text), &near).contains("keeps the conditions of the domain: `far`"));
}

/// Goal: a search that is interrupted ends with an error. Method: an observer that ends it at once.
#[test]
fn an_interrupted_search_ends() {
    let follow =
        tripos::observer::Observer::new(tripos_sim::Poll::new(|_| std::ops::ControlFlow::Continue(())), || true);
    let model = arm().with_observer(follow);
    let options = ExcitationOptions { limits: limits_of_arm(), ..ExcitationOptions::default() };
    assert!(matches!(design_excitation(&model, &base(&model), &options), Err(Error::Interrupted)));
}
