//! Where methods fail: a fixed battery, every item an assertion.
//!
//! References are exact solutions, eigenvalues by hand, or double-double runs that two formulations certify.

mod support;

use support::compiled;
use support::stability::{Equations, Start, fixed, options, right_angle, rounded, wide};
use tripos_sim::stability::{Trend, growth, slope, trend};
use tripos_sim::work_precision::error;
use tripos_sim::{Direction, Dynamics, Eliminated, Event, Method, Options, Output, Warning, linear};
use tripos_traits::{DoubleDouble, Scalar};

/// The near-flat ladder: u2 at the start, the least cos q2 on the way, the aim for the error at t = 2 s.
const LADDER: [(&str, f64, f64); 5] = [
    ("1.60619131", 1e-1, 2e-12),
    ("0.8279472526", 1e-2, 1e-11),
    ("0.7465081481", 1e-3, 1e-10),
    ("0.7383250309", 1e-4, 2e-9),
    ("0.737424449158", 1e-6, 1e-7),
];

fn rung(u2: &str) -> Start {
    Start::new(&["1", "1", "9.81"], &["0.2", "0.3", "0.1", "0", "0"], &["-0.1", u2, "0.5", "0.2", "-0.1"])
}

/// Two formulations at two tolerances, at an instant; a thousand times better than what is measured.
fn certified(start: &Start, t: f64, aim: f64) -> Vec<DoubleDouble> {
    let reference = Equations::new("disk", "lagrange@q2-90deg").reference(start, t, 1e-21);
    let check = Equations::new("disk", "kane@q2-90deg").reference(start, t, 1e-20);
    let difference = error(&reference, &check);
    assert!(difference < 1e-3 * aim, "the reference is known to {difference:e} only");
    reference
}

/// The report's start at t = 2 s, certified elsewhere to 20 digits.
#[test]
fn references_in_double_double_have_the_certified_digits() {
    let degrees = |n: i64| DoubleDouble::pi() * DoubleDouble::ratio(n, 180);
    let mut start = Start::new(&["1", "1", "9.81"], &["0", "0", "0", "5", "1"], &["0", "0", "0", "0.4", "0.1"]);
    start.q[..3].copy_from_slice(&[degrees(10), degrees(2), degrees(45)]);
    // u1 = −q2', u2 = q1' cos q2, u3 = q3' + q1' sin q2.
    let (sine, cosine) = start.q[1].sin_cos();
    start.u[0] = wide("0.1");
    start.u[1] = wide("0.01") * cosine;
    start.u[2] = wide("0.02") + wide("0.01") * sine;
    let state = certified(&start, 2.0, 1e-13);
    let off = |found: DoubleDouble, known: &str| (found - wide(known)).abs().to_f64();
    assert!(off(state[0], "-6.8618023442785915037") < 1e-18, "{}", state[0]);
    assert!(off(state[1], "0.0318063926846857794") < 1e-18, "{}", state[1]);
}

/// Goal: the errors that the distance variable is there for. DOP853, eliminated, at its finest tolerance.
#[test]
fn in_the_distance_errors_stay_small_on_every_rung() {
    for (u2, least, aim) in LADDER {
        let start = rung(u2);
        let reference = certified(&start, 2.0, aim);
        for name in ["kane@q2-90deg", "lagrange@q2-90deg", "newton-euler@q2-90deg"] {
            let equations = Equations::new("disk", name);
            let run = equations.run(&start, 2.0, &options(Method::Dop853, 3e-14), &mut []);
            let found = equations.error(&start, &run, &reference);
            assert!(found < aim, "{name}, least cos q2 {least:e}: {found:e} is not under {aim:e}");
        }
    }
}

/// Storing q2 near π/2 costs Kane's form, where q1' = u2 / cos q2, its digits; Lagrange's keeps q1' itself.
#[test]
fn in_the_coordinate_kane_loses_digits_near_flat() {
    for (u2, least, aim) in &LADDER[2..4] {
        let start = rung(u2);
        let reference = certified(&start, 2.0, *aim);
        let error_of = |name: &str| {
            let equations = Equations::new("disk", name);
            let run = equations.run(&start, 2.0, &options(Method::Dop853, 3e-14), &mut []);
            equations.error(&start, &run, &reference)
        };
        let (coordinate, distance) = (error_of("kane"), error_of("kane@q2-90deg"));
        assert!(coordinate > 10.0 * distance, "least {least:e}: {coordinate:e} in q2, {distance:e} in the distance");
        assert!(error_of("lagrange") < 3.0 * aim, "least {least:e}");
    }
}

/// Inside the passage, where q1 turns fastest, and not only after it: when q2 is nearest to 90°.
#[test]
fn errors_inside_a_passage_are_as_small_as_after_it() {
    let start = rung(LADDER[2].0);
    let t = 0.578;
    let reference = certified(&start, t, 1e-10);
    let equations = Equations::new("disk", "lagrange@q2-90deg");
    let run = equations.run(&start, t, &options(Method::Dop853, 3e-14), &mut []);
    let found = equations.error(&start, &run, &reference);
    assert!(found < 1e-9, "{found:e}");
}

/// A numeric solve of Kane's or Lagrange's system has no digits left at cos q2 = 1e-6: it does not get through within the steps of
/// a run that does, many times over.
#[test]
fn numeric_solves_do_not_get_through_the_narrowest_passage() {
    let start = rung(LADDER[4].0);
    for name in ["kane@q2-90deg", "lagrange@q2-90deg"] {
        let equations = Equations::new("disk", name);
        let limited = Options { step_limit: 20_000, ..options(Method::Dop853, 3e-14) };
        let eliminated = equations.run(&start, 2.0, &limited, &mut []);
        assert!(eliminated.stop.code() == "end" && eliminated.steps < 2_000, "{name}: {eliminated}");
        let numeric = equations.run_numeric(&start, 2.0, &limited);
        assert!(numeric.stop.is_failure(), "{name}: {numeric}");
    }
}

/// A state on the way to lying flat, at this distance, with exact accelerations u̇ there.
fn near_flat(delta: f64) -> (Vec<f64>, Vec<f64>, Vec<DoubleDouble>) {
    let q = vec![0.2, right_angle().to_f64() - delta, 0.1, 0.3, -0.2];
    // u2 = q1' cos q2 stays of the order of 1 in a passage, q1' does not.
    let u = vec![1.3, 1.1, 0.5, 0.2, -0.1];
    let lagrange = compiled("disk", "lagrange").extended;
    let lift = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let (p, q_wide, u_wide) = (lift(&[1.0, 1.0, 9.81]), lift(&q), lift(&u));
    let zeros = vec![DoubleDouble::int(0); 5];
    let (mut v, mut v_dot, mut u_dot) = (zeros.clone(), zeros.clone(), zeros);
    lagrange.motion_variables(&p, &q_wide, &u_wide, &mut v);
    lagrange.accelerations(&p, &q_wide, &v, &mut v_dot);
    lagrange.generalized_speed_rates(&p, &q_wide, &v, &v_dot, &mut u_dot);
    (q, u, u_dot)
}

/// (error of u̇ in units of the largest, plain and equilibrated condition) of Kane's or Newton–Euler's equations.
fn solve_error(name: &str, delta: f64, eliminated: bool) -> (f64, f64, f64) {
    let (q, u, exact) = near_flat(delta);
    let system = compiled("disk", name).double;
    let p = [1.0, 1.0, 9.81];
    let mut v = vec![0.0; 5];
    system.motion_variables(&p, &q, &u, &mut v);
    let mut v_dot = vec![0.0; 5];
    if eliminated {
        system.accelerations(&p, &q, &v, &mut v_dot);
    } else {
        v_dot.copy_from_slice(&Dynamics::new(system, &p).unwrap().unknowns(&q, &v).unwrap()[..5]);
    }
    let largest = exact.iter().map(|a| a.abs().to_f64()).fold(0.0, f64::max);
    let off = v_dot.iter().zip(&exact).map(|(a, b)| (DoubleDouble::from_f64(*a) - *b).abs().to_f64());
    let n = system.unknowns();
    let mut matrix = vec![0.0; n * n];
    system.mass_matrix(&p, &q, &v, &mut matrix);
    let conditions = [linear::plain_reciprocal_condition(&matrix, n), linear::reciprocal_condition(&matrix, n)];
    (off.fold(0.0, f64::max) / largest, 1.0 / conditions[0], 1.0 / conditions[1])
}

/// At cos q2 = 0.0034: eliminated accelerations are exact to a few roundings, Newton–Euler's pivoted LU nearly so, and
/// the Cholesky solve of Kane's system loses more than 1e-13. (How much more changes from state to state.)
#[test]
fn eliminated_accelerations_are_exact_where_numeric_solves_lose_digits() {
    let worst = |name: &str, eliminated: bool| {
        let near = (0..50).map(|i| 0.0034 * (1.0 + 0.01 * f64::from(i)));
        near.map(|delta| solve_error(name, delta, eliminated).0).fold(0.0, f64::max)
    };
    assert!(worst("kane", true) < 2e-15, "{:e}", worst("kane", true));
    assert!(worst("newton-euler", true) < 2e-15);
    assert!(worst("newton-euler", false) < 1e-14, "{:e}", worst("newton-euler", false));
    let lost = worst("kane", false);
    assert!((1e-13..1e-9).contains(&lost), "{lost:e}");
}

/// The laws of the condition numbers in the printed scaling: cos⁻⁴ for Kane, cos⁻² for Newton–Euler; and errors follow the
/// equilibrated ones.
#[test]
fn condition_numbers_follow_their_laws_and_errors_the_equilibrated_ones() {
    let deltas: Vec<f64> = (0..=12).map(|i| 10_f64.powf(-1.5 - 0.25 * f64::from(i))).collect();
    let logarithms: Vec<f64> = deltas.iter().map(|d| d.ln()).collect();
    for (name, law) in [("kane", -4.0), ("newton-euler", -2.0)] {
        let looks: Vec<(f64, f64, f64)> = deltas.iter().map(|d| solve_error(name, *d, false)).collect();
        let plain: Vec<f64> = looks.iter().map(|l| l.1.ln()).collect();
        let found = slope(&logarithms, &plain);
        assert!((found - law).abs() < 0.1, "{name}: {found}");
        for (error, plain, equilibrated) in looks {
            assert!(error < 10.0 * f64::EPSILON * equilibrated.max(10.0), "{name}: {error:e} {equilibrated:e}");
            assert!(equilibrated < plain);
        }
    }
}

/// Released at rest at 0.1 rad the disk meets the plane at this time with this rate (by quadrature in 30 digits).
const FLAT_FALL: (f64, f64) = (0.758_966_569_575_714, 3.951_909);

/// Goal: only the domain sees the floor. Every method sails through it, with energy kept and a good end; with the domain each
/// stops at the right time.
#[test]
fn the_flat_fall_is_stopped_by_the_domain_alone() {
    let start = Start::new(&["1", "1", "9.81"], &["0", "0.1", "0", "0", "0"], &["0"; 5]);
    for name in ["kane", "lagrange", "newton-euler"] {
        let equations = Equations::new("disk", name);
        let dynamics = Dynamics::new(equations.system.double, &rounded(&start.p)).unwrap();
        for method in [Method::Ode45, Method::Dop853] {
            let through = equations.run(&start, 1.2, &options(method, 1e-12), &mut []);
            assert_eq!(through.stop.code(), "end", "{name} {}", method.name());
            assert!(through.y_end[1] > 1.6, "it fell through: q2 = {}", through.y_end[1]);
            assert!(dynamics.energy_drift(&through) < 1e-9);
            let floor = Event::domain("floor", |_t, y: &[f64]| std::f64::consts::FRAC_PI_2 - y[1].abs());
            let stopped = equations.run(&start, 1.2, &options(method, 1e-12), &mut [floor]);
            assert_eq!(stopped.stop.code(), "domain:floor");
            assert!((stopped.t_end - FLAT_FALL.0).abs() < 1e-10, "{name} {}: {}", method.name(), stopped.t_end);
            // q2' is −u1, or the motion variable itself.
            let rate = stopped.y_end[if name == "lagrange" { 6 } else { 5 }].abs();
            assert!((rate - FLAT_FALL.1).abs() < 1e-6, "{rate}");
        }
    }
}

/// N of the disk by its meaning, M (g + z̈) with z = R cos q2, in any number, from Lagrange's accelerations.
fn reaction<S: Scalar>(system: &dyn tripos_traits::System<S>, p: &[S], y: &[S]) -> S {
    let mut v_dot = vec![S::int(0); 5];
    system.accelerations(p, &y[..5], &y[5..], &mut v_dot);
    let (sine, cosine) = y[1].sin_cos();
    p[0] * (p[2] - p[1] * (cosine * y[6] * y[6] + sine * v_dot[1]))
}

/// An event and the function that is zero there.
type Side<'a> = (&'a str, &'a dyn Fn(&[DoubleDouble]) -> DoubleDouble);

/// Contact loss and the tumble over the upright position, to 1e-10 s: the double-double run is on one side just before
/// and on the other just after.
#[test]
fn contact_loss_and_tumbles_are_located_to_a_tenth_of_a_nanosecond() {
    // Thrown up from a lean of 1.2 rad: contact is lost before the disk is upright.
    let start =
        Start::new(&["1", "1", "9.81"], &["0.3", "-1.2", "0.1", "0", "0"], &["-6.5", "0.4", "0.5", "0.2", "-0.1"]);
    let equations = Equations::new("disk", "lagrange");
    let (double, extended) = (equations.system.double, equations.system.extended);
    let p = rounded(&start.p);
    let q2 = |y: &[DoubleDouble]| y[1];
    let n = |y: &[DoubleDouble]| reaction(extended, &start.p, y);
    let sides: [Side<'_>; 2] = [("contact", &n), ("upright", &q2)];
    let truth = |t: f64| {
        let rhs = Eliminated::new(extended, &start.p).unwrap();
        let run =
            tripos_sim::integrate(rhs, (0.0, t), &equations.state(&start), &options(Method::Dop853, 1e-19), &mut []);
        run.unwrap().y_end
    };
    for method in [Method::Ode45, Method::Dop853] {
        let contact = Event::recorded("contact", Direction::Falling, |_t, y: &[f64]| reaction(double, &p, y));
        let upright = Event::recorded("upright", Direction::Rising, |_t, y: &[f64]| y[1]);
        let tight = if method == Method::Ode45 { 1e-12 } else { 1e-13 };
        let run = equations.run(&start, 1.0, &options(method, tight), &mut [contact, upright]);
        for (name, function) in sides {
            let event = run.events.iter().find(|e| e.name == name).unwrap_or_else(|| panic!("no {name}: {run}"));
            let values = [-1e-10, 1e-10].map(|dt| function(&truth(event.t + dt)).to_f64());
            assert!(values[0] * values[1] < 0.0, "{} {name} at {}: {values:?}", method.name(), event.t);
        }
    }
}

/// The rate at which a component grows from 1e-6 until it is 1e-3, by least squares.
fn growth_rate(model: &str, start: &Start, component: usize, until: f64) -> (f64, f64) {
    let equations = Equations::new(model, "kane");
    let times: Vec<f64> = (0..=400).map(|i| until * f64::from(i) / 400.0).collect();
    let sampled = Options { output: Output::At(times), ..options(Method::Dop853, 1e-13) };
    let run = equations.run(start, until, &sampled, &mut []);
    let size: Vec<f64> =
        run.y.iter().map(|y| y[component].hypot(if model == "heavy_top" { y[1] } else { 0.0 })).collect();
    let largest = size.iter().copied().fold(0.0, f64::max);
    // The first time only: what falls comes back.
    let grown = size.iter().position(|s| *s >= 1e-3).unwrap_or(size.len());
    let window: Vec<usize> = (0..grown).filter(|i| size[*i] >= 1e-5).collect();
    let (t, logarithm): (Vec<f64>, Vec<f64>) = window.iter().map(|i| (run.t[*i], size[*i].ln())).unzip();
    (slope(&t, &logarithm), largest)
}

/// Sleeping top (m = 1, l = 0.5, I1 = 0.35, I3 = 0.05): the critical spin is 52.4099227 rad/s; at 0.9 of it the linearized growth is
/// 1.63178254853834 1/s, above it there is none.
#[test]
fn a_sleeping_top_wakes_at_the_linearized_rate() {
    let top =
        |spin: &str| Start::new(&["1", "0.5", "0.35", "0.05", "9.81"], &["0.000001", "0", "0"], &["0", "0", spin]);
    let (rate, _) = growth_rate("heavy_top", &top("47.16893045214325"), 0, 5.5);
    assert!((rate / 1.631_782_548_538_341_8 - 1.0).abs() < 0.01, "{rate}");
    let (_, largest) = growth_rate("heavy_top", &top("57.65091499693735"), 0, 20.0);
    assert!(largest < 1e-5, "a fast top sleeps: {largest:e}");
}

/// Upright, spinning about its axis with n: q2'' = 4 (g/R − n²) q2; turning about the vertical with Ω: q2'' = (4 g/R − Ω²) q2.
#[test]
fn the_upright_disk_falls_at_the_linearized_rate_and_stands_beyond_its_limits() {
    let g = 9.81_f64;
    let lean = 1e-6;
    let spinning = |square: f64| {
        let n = square.sqrt();
        // u2 = −2 n q2 keeps the constant of the second equation zero.
        let numbers = [0.0, -2.0 * n * lean, n, 0.0, 0.0].map(DoubleDouble::from_f64);
        let mut start = Start::new(&["1", "1", "9.81"], &["0", "0.000001", "0", "0", "0"], &["0"; 5]);
        start.u = numbers.to_vec();
        start
    };
    let turning = |square: f64| {
        let mut start = Start::new(&["1", "1", "9.81"], &["0", "0.000001", "0", "0", "0"], &["0"; 5]);
        start.u[1] = DoubleDouble::from_f64(square.sqrt());
        start
    };
    for part in [0.5, 0.8] {
        let (rate, _) = growth_rate("disk", &spinning(part * g), 1, 12.0);
        let expected = 2.0 * ((1.0 - part) * g).sqrt();
        assert!((rate / expected - 1.0).abs() < 0.01, "spin {part}: {rate} {expected}");
        let (rate, _) = growth_rate("disk", &turning(part * 4.0 * g), 1, 12.0);
        let expected = (4.0 * (1.0 - part) * g).sqrt();
        assert!((rate / expected - 1.0).abs() < 0.01, "pivot {part}: {rate} {expected}");
    }
    for part in [1.2, 2.0] {
        let (_, spin) = growth_rate("disk", &spinning(part * g), 1, 20.0);
        let (_, pivot) = growth_rate("disk", &turning(part * 4.0 * g), 1, 20.0);
        assert!(spin < 1e-5 && pivot < 1e-5, "{part}: {spin:e} {pivot:e}");
    }
}

/// Goal: the horizon of a chaotic motion is predicted by the growth of a small error. Method: at 60 % of the predicted time
/// digits are left, at 130 % none is, against a double-double run.
#[test]
fn the_horizon_of_a_chaotic_pendulum_is_predicted_and_confirmed() {
    // Cart and three links, no force on the cart, the links released near upright.
    let start = Start::new(
        &["1", "0.5", "0.4", "0.3", "1", "0.8", "0.6", "9.81", "0"],
        &["0", "0.5", "1", "-0.5"],
        &["0", "0", "0", "0"],
    );
    let equations = Equations::new("cart_pendulum_3", "kane");
    let tolerance = 1e-9;
    let mut rhs = Eliminated::new(equations.system.double, &rounded(&start.p)).unwrap();
    let y0 = rounded(&equations.state(&start));
    let follow = Options { output: Output::Steps { refine: 1 }, ..options(Method::Dop853, 1e-9) };
    let found = growth(&mut rhs, (0.0, 60.0), &y0, &vec![1.0; y0.len()], &follow).unwrap();
    let limit = -f64::ln(tolerance);
    let at = found.logarithms.iter().position(|l| *l >= limit).expect("a chaotic motion");
    let horizon = found.times[at];
    assert!((1.0..55.0).contains(&horizon), "{horizon}");
    let error_at = |t: f64| {
        let reference = equations.reference(&start, t, 1e-24);
        let run = equations.run(&start, t, &options(Method::Dop853, tolerance), &mut []);
        equations.error(&start, &run, &reference)
    };
    assert!(error_at(0.6 * horizon) < 0.01, "{:e}", error_at(0.6 * horizon));
    assert!(error_at(1.3 * horizon) > 0.1, "{:e}", error_at(1.3 * horizon));
}

/// |R(iy)|² of a Runge–Kutta method with this stability polynomial.
fn amplification(coefficients: &[f64], y: f64) -> f64 {
    let (mut re, mut im) = (0.0, 0.0);
    for (power, c) in coefficients.iter().enumerate() {
        let term = c * y.powi(i32::try_from(power).unwrap());
        match power % 4 {
            0 => re += term,
            1 => im += term,
            2 => re -= term,
            _ => im -= term,
        }
    }
    re * re + im * im
}

/// Goal: fixed steps give way where theory says. Small swings of a pendulum with ω = 1: the amplitude after 2 000 steps just
/// below and just above the end of the stability interval on the imaginary axis.
#[test]
fn fixed_steps_are_stable_up_to_the_limit_of_theory() {
    let rk4 = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0];
    // Dormand–Prince 5: exp to order 5, and z⁶/600.
    let dopri5 = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 600.0];
    let start = Start::new(&["1", "1", "1"], &["0.000001"], &["0"]);
    let equations = Equations::new("pendulum", "kane");
    let amplitude = |method: Method, h: f64, steps: f64| {
        let run = equations.run(&start, h * steps, &fixed(method, h), &mut []);
        run.y_end[0].hypot(run.y_end[1]) / 1e-6
    };
    for (method, polynomial) in [(Method::Rk4, &rk4[..]), (Method::Dopri5, &dopri5)] {
        let limit =
            (1..5000).map(|i| 0.001 * f64::from(i)).find(|y| amplification(polynomial, *y) > 1.0 + 1e-9).unwrap();
        let (below, above) = (amplitude(method, 0.98 * limit, 2000.0), amplitude(method, 1.02 * limit, 2000.0));
        assert!(below <= 1.0 + 1e-6, "{}: {below} at 0.98 of {limit}", method.name());
        assert!(above > 1.01, "{}: {above} at 1.02 of {limit}", method.name());
        for (part, found) in [(0.98, below), (1.02, above)] {
            let expected = amplification(polynomial, part * limit).powi(1000);
            // Beyond that a swing of 1e-6 is a small one no longer.
            assert!(expected > 1e3 || (found / expected - 1.0).abs() < 0.01, "{}: {found} {expected}", method.name());
        }
    }
    assert!((amplification(&rk4, 8_f64.sqrt()) - 1.0).abs() < 1e-12, "Runge–Kutta 4: up to √8");
    // Gauss–Legendre has no limit: |R(iy)| = 1 for every step.
    assert!((amplitude(Method::Gauss6, 5.0, 2000.0) - 1.0).abs() < 1e-6);
}

/// The energy of θ'' = −sin θ from rest at 2 rad along a long run: samples of its change.
fn energy_changes(span: f64, options: &Options) -> Vec<f64> {
    let start = Start::new(&["1", "1", "1"], &["2"], &["0"]);
    let equations = Equations::new("pendulum", "kane");
    let times = (0..=2000).map(|i| span * f64::from(i) / 2000.0).collect();
    let run = equations.run(&start, span, &Options { output: Output::At(times), ..options.clone() }, &mut []);
    assert_eq!(run.stop.code(), "end");
    let energy = |y: &Vec<f64>| 0.5 * y[1] * y[1] - y[0].cos();
    run.y.iter().map(|y| energy(y) - energy(&run.y[0])).collect()
}

/// 1e5 s of a pendulum. Runge–Kutta 4 loses 1.021e-2 at h = 0.1 and 3.209e-4 at h = 0.05 (published measurements, to 1 %);
/// Gauss–Legendre swings within a bound that does not grow, and loses that when its step adapts.
#[test]
fn energy_drifts_for_ever_or_stays_bounded_by_method() {
    for (h, known) in [(0.1, -1.021e-2), (0.05, -3.209e-4)] {
        let changes = energy_changes(1e5, &fixed(Method::Rk4, h));
        let end = changes[changes.len() - 1];
        assert!((end / known - 1.0).abs() < 0.01, "{h}: {end:e}");
        assert_eq!(trend(&changes), Trend::Secular);
    }
    let fixed_steps = energy_changes(1e5, &fixed(Method::Gauss6, 0.2));
    let largest = fixed_steps.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert_eq!(trend(&fixed_steps), Trend::Bounded, "{largest:e}");
    assert!(largest < 1e-6, "{largest:e}");
    let adaptive = energy_changes(2e4, &options(Method::Gauss6, 1e-5));
    assert_eq!(trend(&adaptive), Trend::Secular, "a step that adapts is no longer symplectic");
    let ode45 = energy_changes(1e4, &options(Method::Ode45, 1e-6));
    assert_eq!(trend(&ode45), Trend::Secular);
}

/// Goal: a tolerance finer than rounding costs steps, gains nothing, and is said. Method: the pendulum's exact solution.
#[test]
fn a_tolerance_below_rounding_is_longer_no_better_and_said() {
    let start = Start::new(&["1", "1", "9.81"], &["3"], &["0"]);
    let equations = Equations::new("pendulum", "kane");
    let exact = tripos_sim::exact::Pendulum::new(wide("9.81"), wide("3"), wide("0"));
    let truth = [exact.angle(DoubleDouble::int(20)), exact.rate(DoubleDouble::int(20))];
    let at = |atol: f64| {
        let how = Options {
            rtol: 0.0,
            atol: tripos_sim::AbsoluteTolerance::Uniform(atol),
            step_limit: 100_000,
            ..options(Method::Dop853, 1e-6)
        };
        equations.run(&start, 20.0, &how, &mut [])
    };
    let (sensible, absurd) = (at(1e-14), at(1e-20));
    let best = equations.error(&start, &sensible, &truth);
    assert!(best < 1e-10 && sensible.warnings.is_empty(), "{best:e} {:?}", sensible.warnings);
    let said = |w: &Warning| matches!(w, Warning::ToleranceBelowRounding { .. });
    assert!(absurd.warnings.iter().any(said), "{absurd} {:?}", absurd.warnings);
    assert!(absurd.steps + absurd.rejected > 3 * sensible.steps, "{absurd}");
    let worse = equations.error(&start, &absurd, &truth);
    assert!(worse.is_nan() || worse > 0.1 * best, "{worse:e} {best:e}");
}
