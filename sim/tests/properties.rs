//! Properties of every method with any equations: runs end, samples are numbers, and the way back leads to the start.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use proptest::prelude::*;
use tripos_sim::{
    AbsoluteTolerance, Direction, Event, Failure, Method, Options, OutputOption, RightHandSide, Solution, Stop,
    WithJacobian, integrate,
};

/// y' = A y of order 3.
fn linear(a: [f64; 9]) -> impl RightHandSide<f64> {
    let rhs = move |_t: f64, y: &[f64], dydt: &mut [f64]| {
        for (d, row) in dydt.iter_mut().zip(a.chunks(3)) {
            *d = row.iter().zip(y).map(|(a, y)| a * y).sum();
        }
        Ok(())
    };
    let jacobian = move |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&a);
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

/// Adaptive where the method can be, else a step that is short for the problems here.
fn options(method: Method, tolerance: f64) -> Options {
    Options {
        method,
        step: (method == Method::Rk4).then_some(1e-3),
        step_limit: 20_000,
        output: OutputOption::Steps { refine: 3 },
        ..Options::tolerances(tolerance, tolerance)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    /// Entries below 1 and a span of 2: errors of 1e-9 grow by e^6 at most each way. Some hundred steps.
    #[test]
    fn a_linear_system_run_forth_and_back_returns(
        a in prop::array::uniform9(-1.0..1.0_f64),
        y0 in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        for method in Method::WITHOUT_SERIES {
            let options = options(method, 1e-9);
            let forth = integrate(linear(a), (0.5, 2.5), &y0, &options, &mut []).unwrap();
            let back = integrate(linear(a), (2.5, 0.5), &forth.y_end, &options, &mut []).unwrap();
            prop_assert_eq!((&forth.stop, &back.stop, back.t_end), (&Stop::End, &Stop::End, 0.5));
            for (found, start) in back.y_end.iter().zip(y0) {
                prop_assert!((found - start).abs() < 1e-5, "{:?} {} {}", method, found, start);
            }
            prop_assert!(back.warnings.is_empty());
        }
    }

    /// Whatever f does to large numbers, samples are finite, times are in order, and the counts within the limit.
    #[test]
    fn wild_equations_end_without_odd_samples(
        coefficients in prop::array::uniform4(-1e3..1e3_f64),
        y0 in prop::array::uniform2(-1e2..1e2_f64),
        backward in any::<bool>(),
    ) {
        let [a, b, c, d] = coefficients;
        for method in Method::WITHOUT_SERIES {
            let rhs = move |t: f64, y: &[f64], dydt: &mut [f64]| {
                dydt[0] = a * y[1] * y[1] + b * t.sin();
                dydt[1] = c * y[0] * y[1] + (d - y[1]).sqrt();
                Ok(())
            };
            let jacobian = move |_t: f64, y: &[f64], out: &mut [f64]| {
                out.copy_from_slice(&[0.0, 2.0 * a * y[1], c * y[1], c * y[0] - 0.5 / (d - y[1]).sqrt()]);
                Ok(())
            };
            let end = if backward { -1.0 } else { 1.0 };
            let options = Options { step_limit: 500, ..options(method, 1e-6) };
            let solution = integrate(WithJacobian { rhs, jacobian }, (0.0, end), &y0, &options, &mut []).unwrap();
            assert_sound(method, &solution, end, 500);
        }
    }
}

fn assert_sound(method: Method, solution: &Solution, direction: f64, limit: u64) {
    assert!(solution.y.iter().flatten().chain(&solution.y_end).all(|y| y.is_finite()), "{method:?} {solution}");
    assert!(solution.t.windows(2).all(|t| (t[1] - t[0]) * direction > 0.0), "{method:?} {solution}");
    assert!(solution.steps + solution.rejected <= limit, "{method:?} {solution}");
    assert_eq!(solution.y.last(), Some(&solution.y_end), "{method:?} {solution}");
}

/// A scalar equation with its derivative.
fn scalar<'a>(
    f: impl Fn(f64, f64) -> Result<f64, Failure> + 'a,
    slope: impl Fn(f64, f64) -> f64 + 'a,
) -> impl RightHandSide<f64> + 'a {
    let rhs = move |t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = f(t, y[0])?;
        Ok(())
    };
    let jacobian = move |t: f64, y: &[f64], out: &mut [f64]| {
        out[0] = slope(t, y[0]);
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

#[test]
fn every_method_stops_before_a_blow_up() {
    for method in Method::WITHOUT_SERIES {
        let equations = scalar(|_t, y| Ok(y * y), |_t, y| 2.0 * y);
        let solution = integrate(equations, (0.0, 2.0), &[1.0], &options(method, 1e-6), &mut []).unwrap();
        assert_sound(method, &solution, 1.0, 20_000);
        assert!(solution.stop.is_failure(), "{method:?} {solution}");
        // Equal steps cannot approach t = 1, and may reach a little beyond it before numbers overflow.
        let near = if method == Method::Rk4 { 0.02 } else { 1e-3 };
        assert!((solution.t_end - 1.0).abs() < near, "{method:?} {solution}");
    }
}

#[test]
fn every_method_stops_where_the_equations_are_no_number() {
    for method in Method::WITHOUT_SERIES {
        let equations = scalar(|t, _y| Ok(if t > 1.0 { f64::NAN } else { 1.0 }), |_t, _y| 0.0);
        let solution = integrate(equations, (0.0, 2.0), &[0.0], &options(method, 1e-6), &mut []).unwrap();
        assert_sound(method, &solution, 1.0, 20_000);
        assert_eq!(solution.stop, Stop::NotFinite { component: 0 }, "{method:?}");
        let near = if method == Method::Rk4 { 2e-3 } else { 1e-14 };
        assert!(solution.t_end <= 1.0 && solution.t_end > 1.0 - near, "{method:?} {solution}");
    }
}

#[test]
fn every_method_stops_where_the_equations_fail() {
    for method in Method::WITHOUT_SERIES {
        let fail = |_t: f64, y: f64| {
            let message = "beyond the table".to_owned();
            if y > 1.0 { Err(Failure { code: "table", message }) } else { Ok(1.0) }
        };
        let equations = scalar(fail, |_t, _y| 0.0);
        let solution = integrate(equations, (0.0, 2.0), &[0.0], &options(method, 1e-6), &mut []).unwrap();
        assert_sound(method, &solution, 1.0, 20_000);
        assert_eq!(solution.stop.code(), "table", "{method:?}");
        assert!(solution.t_end > 0.99 && solution.t_end < 1.0 + 1e-12, "{method:?} {solution}");
    }
}

#[test]
fn every_method_keeps_to_the_step_limit_on_a_stiff_problem() {
    for method in Method::WITHOUT_SERIES {
        let equations = scalar(|t, y| Ok(-1e6 * (y - t.cos())), |_t, _y| -1e6);
        let options = Options { step_limit: 300, step: None, ..options(method, 1e-6) };
        let options = Options { step: (method == Method::Rk4).then_some(1e-6), ..options };
        let solution = integrate(equations, (0.0, 10.0), &[0.0], &options, &mut []).unwrap();
        assert_sound(method, &solution, 1.0, 300);
        // Implicit methods may arrive, and one that damps what is stiff does.
        let arrives = solution.stop == Stop::End;
        assert!(arrives || solution.stop == Stop::StepLimit { limit: 300 }, "{method:?} {solution}");
        assert!(if arrives { method.needs_jacobian() } else { method != Method::Radau5 }, "{method:?} {solution}");
    }
}

/// The weight of one component must not stand in for another: a coarse tolerance for one of two equal oscillators lets
/// only that one err, and each method takes as many steps as the finer tolerance needs.
#[test]
fn every_adaptive_method_heeds_the_tolerance_of_each_component() {
    let a = [0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0];
    for method in Method::WITHOUT_SERIES.into_iter().filter(|m| *m != Method::Rk4) {
        let run = |atol: AbsoluteTolerance| {
            let options = Options { rtol: 0.0, atol, ..options(method, 1e-9) };
            integrate(linear(a), (0.0, 5.0), &[1.0, 0.0, 1.0], &options, &mut []).unwrap()
        };
        let steps = |fine: f64, coarse: f64| run(vec![fine, fine, coarse].into()).steps;
        let (both, oscillator, decay, none) = (steps(1e-9, 1e-9), steps(1e-9, 1e9), steps(1e9, 1e-9), steps(1e9, 1e9));
        assert!(none < oscillator && none < decay, "{method:?}: {none} {oscillator} {decay}");
        assert!(oscillator <= both && decay < both, "{method:?}: {oscillator} {decay} {both}");
    }
}

/// Watching does not change a run: steps and end are the same with events and any output.
#[test]
fn watching_changes_no_step_of_any_method() {
    let a = [0.0, 1.0, 0.0, -4.0, 0.0, 0.0, 0.0, 1.0, -1.0];
    for method in Method::WITHOUT_SERIES {
        let run = |output: OutputOption, events: &mut [Event<'_>]| {
            let options = Options { output, ..options(method, 1e-7) };
            integrate(linear(a), (0.0, 5.0), &[1.0, 0.0, 1.0], &options, events).unwrap()
        };
        let bare = run(OutputOption::Ends, &mut []);
        let event = Event::recorded("zero", Direction::Either, |_t, y: &[f64]| y[0]);
        let watched = run(OutputOption::At(vec![0.1, 0.2, 4.9]), &mut [event]);
        let fine = run(OutputOption::Steps { refine: 5 }, &mut []);
        for other in [&watched, &fine] {
            assert_eq!((bare.steps, bare.rejected, &bare.y_end), (other.steps, other.rejected, &other.y_end));
        }
        // cos 2t is zero at π/4, 3π/4 and 5π/4 up to 5. The dense output of collocation has
        // order 3, and its steps are long.
        assert_eq!(watched.events.len(), 3, "{method:?}");
        for (k, event) in watched.events.iter().enumerate() {
            let exact = std::f64::consts::FRAC_PI_4 * (2.0 * k as f64 + 1.0);
            let near = if method.needs_jacobian() { 0.05 } else { 1e-4 };
            assert!((event.t - exact).abs() < near, "{method:?}: {} {exact}", event.t);
        }
    }
}
