//! Behaviour of methods over many steps, whatever the mechanism: limits of fixed steps, drifts of long runs, tolerances
//! below rounding. Truth: theory and the pendulum's exact solution; passages and unstable motions are in
//! `stability.rs`.

use crate::support;

use support::stability::{Equations, Start, fixed, options, rounded, wide};
use tripos_sim::error_growth::{Trend, drift_trend, error_growth};
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption, Warning};
use tripos_traits::{DoubleDouble, Scalar};

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

/// Goal: fixed steps give way where theory says. Small swings of a pendulum with ω = 1: the amplitude after 2 000 steps
/// just below and just above the end of the stability interval on the imaginary axis.
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
    let run = equations.run(&start, span, &Options { output: OutputOption::At(times), ..options.clone() }, &mut []);
    assert_eq!(run.stop.code(), "end");
    let energy = |y: &Vec<f64>| 0.5 * y[1] * y[1] - y[0].cos();
    run.y.iter().map(|y| energy(y) - energy(&run.y[0])).collect()
}

/// 1e5 s of a pendulum. Runge–Kutta 4 loses 1.021e-2 at h = 0.1 and 3.209e-4 at h = 0.05 (published measurements, to 1
/// %); Gauss–Legendre swings within a bound that does not grow, and loses that when its step adapts.
#[test]
fn energy_drifts_for_ever_or_stays_bounded_by_method() {
    for (h, known) in [(0.1, -1.021e-2), (0.05, -3.209e-4)] {
        let changes = energy_changes(1e5, &fixed(Method::Rk4, h));
        let end = changes[changes.len() - 1];
        assert!((end / known - 1.0).abs() < 0.01, "{h}: {end:e}");
        assert_eq!(drift_trend(&changes), Trend::Secular);
    }
    let fixed_steps = energy_changes(1e5, &fixed(Method::Gauss6, 0.2));
    let largest = fixed_steps.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert_eq!(drift_trend(&fixed_steps), Trend::Bounded, "{largest:e}");
    assert!(largest < 1e-6, "{largest:e}");
    let adaptive = energy_changes(2e4, &options(Method::Gauss6, 1e-5));
    assert_eq!(drift_trend(&adaptive), Trend::Secular, "a step that adapts is no longer symplectic");
    let ode45 = energy_changes(1e4, &options(Method::Ode45, 1e-6));
    assert_eq!(drift_trend(&ode45), Trend::Secular);
}

/// Goal: a tolerance finer than rounding costs steps, gains nothing, and is said. Method: the pendulum's exact
/// solution.
#[test]
fn a_tolerance_below_rounding_is_longer_no_better_and_said() {
    let start = Start::new(&["1", "1", "9.81"], &["3"], &["0"]);
    let equations = Equations::new("pendulum", "kane");
    let exact = tripos_sim::exact::Pendulum::new(wide("9.81"), wide("3"), wide("0"));
    let truth = [exact.angle(DoubleDouble::int(20)), exact.rate(DoubleDouble::int(20))];
    let at = |atol: f64| {
        let how = Options { rtol: 0.0, atol: atol.into(), step_limit: 100_000, ..options(Method::Dop853, 1e-6) };
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

/// Goal: a regular motion has a horizon too, since every step adds an error. Method: a pendulum whose phase is lost
/// within 2 500 s at a loose tolerance, by its exact solution.
#[test]
fn the_phase_of_a_long_run_is_lost_where_it_is_predicted() {
    let (tolerance, span) = (1e-3, 2500.0);
    let start = Start::new(&["1", "1", "9.81"], &["2"], &["0"]);
    let equations = Equations::new("pendulum", "kane");
    let exact = tripos_sim::exact::Pendulum::new(wide("9.81"), wide("2"), wide("0"));
    let run = equations.run(&start, span, &options(Method::Dop853, tolerance), &mut []);
    let seconds = DoubleDouble::from_f64(span);
    let lost = equations.error(&start, &run, &[exact.angle(seconds), exact.rate(seconds)]);
    assert!(lost > 0.1, "{lost:e} {run}");
    let mut rhs = EliminatedDynamics::new(equations.system.double, &rounded(&start.p)).unwrap();
    let follow = Options { output: OutputOption::Steps { refine: 1 }, ..options(Method::Dop853, 1e-9) };
    let found = error_growth(&mut rhs, (0.0, span), &rounded(&equations.state(&start)), &[1.0, 1.0], &follow).unwrap();
    let steps = run.steps as f64;
    let horizon = found.horizon(|t| tolerance * (steps * t / span).max(1.0)).expect("before the end");
    assert!((1.0..1000.0).contains(&horizon), "{horizon}");
    // One error alone would be said to last far longer.
    assert!(found.horizon(|_| tolerance).is_none_or(|t| t > 3.0 * horizon));
}
