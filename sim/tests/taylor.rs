//! Taylor's method on equations whose recurrences are written by hand.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::{Direction, Event, Failure, Method, Options, OutputOption, RightHandSide, SimError, Stop};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// y' = y², whose solution through 1 at 0 is 1/(1 − t).
struct Square;

impl<S: Real> RightHandSide<S> for Square {
    fn rhs(&mut self, _t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        dydt[0] = y[0] * y[0];
        Ok(())
    }

    fn taylor(&mut self, _t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        for k in 0..order {
            let sum = (0..=k).fold(S::int(0), |sum, j| sum + x[j] * x[k - j]);
            x[k + 1] = sum / S::int(i64::try_from(k + 1).unwrap());
        }
        Some(Ok(()))
    }
}

/// The plane oscillator y'' = −y.
struct Oscillator;

impl<S: Real> RightHandSide<S> for Oscillator {
    fn rhs(&mut self, _t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        (dydt[0], dydt[1]) = (y[1], -y[0]);
        Ok(())
    }

    fn taylor(&mut self, _t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        for k in 0..order {
            let over = S::ratio(1, i64::try_from(k + 1).unwrap());
            (x[2 * k + 2], x[2 * k + 3]) = (x[2 * k + 1] * over, -x[2 * k] * over);
        }
        Some(Ok(()))
    }
}

fn adaptive(tolerance: f64) -> Options {
    Options { method: Method::Taylor, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) }
}

fn fixed(order: usize, step: f64) -> Options {
    Options { order: Some(order), step: Some(step), ..adaptive(1e-6) }
}

/// Goal: the order that was asked for. Method: the error of the oscillator with steps of 0.2 s and half of that, in 32
/// digits;
/// |log2 of their ratio − p| < 0.3, since the next term is smaller by h = 0.1.
#[test]
fn fixed_steps_converge_at_the_order_asked_for() {
    for order in [2, 3, 6, 11, 16] {
        let error = |step| {
            let start = [DoubleDouble::int(1), DoubleDouble::int(0)];
            let end = integrate(Oscillator, (0.0, 1.0), &start, &fixed(order, step), &mut []).unwrap().y_end;
            let (sine, cosine) = DoubleDouble::int(1).sin_cos();
            (end[0] - cosine).abs().to_f64() + (end[1] + sine).abs().to_f64()
        };
        let observed = (error(0.2) / error(0.1)).log2();
        assert!((observed - order as f64).abs() < 0.3, "order {order}: {observed}");
    }
}

/// Ten seconds of the oscillator gather some errors of one step each, none of which is larger than the tolerance.
#[test]
fn errors_stay_near_the_tolerance_at_every_accuracy() {
    for digits in 2..14 {
        let tolerance = 10_f64.powi(-digits);
        let solution = integrate(Oscillator, (0.0, 10.0), &[1.0, 0.0], &adaptive(tolerance), &mut []).unwrap();
        let error = (solution.y_end[0] - 10_f64.cos()).abs().max((solution.y_end[1] + 10_f64.sin()).abs());
        assert!(error < 10.0 * tolerance, "{tolerance:e}: {error:e}");
        assert!(solution.rejected == 0 && solution.steps < 40, "{tolerance:e}: {solution}");
    }
}

/// In 32 digits the order is some 40, and the error that of the tolerance.
#[test]
fn a_wider_scalar_reaches_its_own_accuracy() {
    let start = [DoubleDouble::int(1)];
    let solution = integrate(Square, (0.0, 0.9), &start, &adaptive(1e-28), &mut []).unwrap();
    let exact = DoubleDouble::int(1) / (DoubleDouble::int(1) - DoubleDouble::from_f64(0.9));
    let error = ((solution.y_end[0] - exact) / exact).abs().to_f64();
    assert!(error < 1e-25 && solution.steps < 60, "{error:e} {solution}");
}

/// The polynomial of a step is as good inside it as at its end, before and after: ten times the tolerance.
#[test]
fn the_solution_inside_a_step_is_as_exact_as_at_its_end() {
    let times: Vec<f64> = (0..=100).map(|i| 0.1 * f64::from(i)).collect();
    let options = Options { output: OutputOption::At(times.clone()), ..adaptive(1e-10) };
    let solution = integrate(Oscillator, (0.0, 10.0), &[1.0, 0.0], &options, &mut []).unwrap();
    assert!(solution.steps < 20);
    for (t, y) in times.iter().zip(&solution.y) {
        assert!((y[0] - t.cos()).abs() < 1e-9 && (y[1] + t.sin()).abs() < 1e-9, "{t}");
    }
}

#[test]
fn an_event_is_found_in_the_polynomial() {
    let event = Event::terminal("level", Direction::Falling, |_t, y: &[f64]| y[0] - 0.25);
    let solution = integrate(Oscillator, (0.0, 10.0), &[1.0, 0.0], &adaptive(1e-12), &mut [event]).unwrap();
    assert_eq!(solution.stop.code(), "event:level");
    assert!((solution.t_end - 0.25_f64.acos()).abs() < 1e-11, "{}", solution.t_end);
}

#[test]
fn a_run_backward_is_a_run_of_the_mirrored_time() {
    let solution = integrate(Square, (0.0, -3.0), &[1.0], &adaptive(1e-12), &mut []).unwrap();
    assert!((solution.y_end[0] - 0.25).abs() < 1e-12, "{solution}");
}

/// A pole: the steps shrink with the radius of convergence until they are below rounding. The pole of what is computed
/// is off by some tolerances.
#[test]
fn a_run_ends_at_a_pole_with_a_reason() {
    let solution = integrate(Square, (0.0, 2.0), &[1.0], &adaptive(1e-9), &mut []).unwrap();
    assert!(solution.stop.is_failure(), "{solution}");
    assert!((solution.t_end - 1.0).abs() < 1e-6, "{}", solution.t_end);
}

/// At 1e20 the coefficients of orders above 15 overflow; the others serve.
#[test]
fn coefficients_that_overflow_lower_the_order_and_nothing_else() {
    let start = 1e20;
    let solution =
        integrate(Square, (0.0, 5e-21), &[start], &Options { order: Some(40), ..adaptive(1e-9) }, &mut []).unwrap();
    assert_eq!(solution.stop, Stop::End, "{solution}");
    assert!((solution.y_end[0] / (2.0 * start) - 1.0).abs() < 1e-7, "{solution}");
}

#[test]
fn a_state_without_a_derivative_ends_the_run_there() {
    struct Wall;
    impl RightHandSide for Wall {
        fn rhs(&mut self, t: f64, _y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
            dydt[0] = if t > 0.55 { f64::NAN } else { 1.0 };
            Ok(())
        }
        fn taylor(&mut self, t: f64, order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
            x[1..=order].fill(0.0);
            x[1] = if t > 0.55 { f64::NAN } else { 1.0 };
            Some(Ok(()))
        }
    }
    let equal = integrate(Wall, (0.0, 1.0), &[0.0], &fixed(4, 0.1), &mut []).unwrap();
    assert_eq!((equal.steps, equal.stop, equal.t_end), (5, Stop::NotFinite { component: 0 }, 0.5));
    let adapted = integrate(Wall, (0.0, 1.0), &[0.0], &adaptive(1e-6), &mut []).unwrap();
    assert_eq!(adapted.stop, Stop::NotFinite { component: 0 });
    assert!(adapted.t_end <= 0.55 && adapted.t_end > 0.55 - 1e-14, "{}", adapted.t_end);
}

#[test]
fn equations_without_a_series_and_orders_out_of_range_are_refused() {
    let plain = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 1.0;
        Ok(())
    };
    let error = integrate(plain, (0.0, 1.0), &[0.0], &adaptive(1e-6), &mut []).unwrap_err();
    assert_eq!(error, SimError::NoSeries { method: "taylor" });
    assert!(error.to_string().contains("choose another method"), "{error}");
    for order in [0, 1, 61, usize::MAX] {
        let options = Options { order: Some(order), ..adaptive(1e-6) };
        let error = integrate(Square, (0.0, 0.5), &[1.0], &options, &mut []).unwrap_err();
        assert!(matches!(error, SimError::Option { name: "order", .. }), "{order}: {error}");
    }
}

/// A million steps of a circle with a truncation error below 1e-22 each: only rounding changes the radius. With the
/// rounding error carried from step to step that is some ulp.
#[test]
fn what_rounding_cuts_off_is_carried_along() {
    let options = Options { step_limit: 2_000_000, ..fixed(8, 0.01) };
    let solution = integrate(Oscillator, (0.0, 10_000.0), &[1.0, 0.0], &options, &mut []).unwrap();
    let radius = f64::hypot(solution.y_end[0], solution.y_end[1]);
    assert!((radius - 1.0).abs() < 1e-14, "{:e}", radius - 1.0);
}

/// x'' = −x³: through x = 0 three of four coefficients vanish.
struct Cubic;

impl RightHandSide for Cubic {
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        (dydt[0], dydt[1]) = (y[1], -y[0] * y[0] * y[0]);
        Ok(())
    }

    fn taylor(&mut self, _t: f64, order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
        let mut square = vec![0.0; order];
        for k in 0..order {
            square[k] = (0..=k).map(|j| x[2 * j] * x[2 * (k - j)]).sum();
            let cube: f64 = (0..=k).map(|j| square[j] * x[2 * (k - j)]).sum();
            let over = 1.0 / (k + 1) as f64;
            (x[2 * k + 2], x[2 * k + 3]) = (x[2 * k + 1] * over, -cube * over);
        }
        Some(Ok(()))
    }
}

/// Goal: last terms that vanish do not pass for a solution that is a polynomial. Method: every tolerance from 1e-3 to
/// 1e-13, some of whose orders have two gaps at the end; exact and nearly exact zeros. The energy x'²/2 + x⁴/4 is
/// constant; a hundred tolerances: some ten steps, each allowed ten at a gap.
#[test]
fn terms_that_vanish_do_not_pass_for_a_polynomial() {
    for exponent in 3..=13 {
        for x in [0.0, 1e-9, 1e-6] {
            let tolerance = 10.0_f64.powi(-exponent);
            let end = integrate(Cubic, (0.0, 10.0), &[x, 1.0], &adaptive(tolerance), &mut []).unwrap();
            let energy = |y: &[f64]| y[1] * y[1] / 2.0 + y[0].powi(4) / 4.0;
            let change = (energy(&end.y_end) - energy(&[x, 1.0])).abs();
            assert!(change < 100.0 * tolerance, "{change} at {tolerance} from {x}");
        }
    }
}

/// A tolerance relative to a component that is zero at the start says nothing about it.
#[test]
fn a_component_without_a_weight_does_not_hold_the_run_up() {
    let relative = Options { atol: 0.0.into(), ..adaptive(1e-9) };
    let end = integrate(Oscillator, (0.0, 3.0), &[0.0, 1.0], &relative, &mut []).unwrap();
    assert!(end.steps < 100 && (end.y_end[0] - 3.0_f64.sin()).abs() < 1e-8, "{end}");
}
