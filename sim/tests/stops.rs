//! Runs that cannot go on say so, and keep what they have.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};

use crate::lent::integrate;
use tripos_sim::{Failure, Method, Options, OutputOption, Poll, Stop};

/// y' = y², y(0) = 1 is 1 / (1 − t): the run must end just before t = 1, with a reason.
#[test]
fn a_blow_up_in_finite_time_stops_before_it() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = y[0] * y[0];
        Ok(())
    };
    let options = Options { rtol: 1e-8, ..Options::default() };
    let solution = integrate(rhs, (0.0, 2.0), &[1.0], &options, &mut []).unwrap();
    assert!(matches!(solution.stop, Stop::StepTooSmall { step } if step < 1e-14), "{solution}");
    assert!((solution.t_end - 1.0).abs() < 1e-6, "{solution}");
    assert_eq!(solution.y.last(), Some(&solution.y_end));
    assert!(solution.y_end[0] > 1e6 && solution.y_end[0].is_finite());
    assert!(solution.to_string().contains("below rounding"), "{solution}");
}

#[test]
fn the_step_limit_counts_accepted_and_rejected_steps() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = -1e3 * (y[0] - 1.0);
        Ok(())
    };
    for limit in [0, 1, 7, 40] {
        let options = Options { step_limit: limit, ..Options::default() };
        let solution = integrate(rhs, (0.0, 10.0), &[0.0], &options, &mut []).unwrap();
        assert_eq!(solution.stop, Stop::StepLimit { limit });
        assert_eq!(solution.steps + solution.rejected, limit);
        assert_eq!(solution.t.last(), Some(&solution.t_end));
    }
}

/// f is not a number beyond t = 0.5. Halving approaches 0.5 to 16 ulp and no closer.
#[test]
fn not_a_number_is_approached_and_then_reported() {
    for direction in [1.0, -1.0] {
        let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
            dydt[0] = 1.0;
            dydt[1] = (0.5 - direction * t).sqrt();
            Ok(())
        };
        let options = Options::default();
        let solution = integrate(rhs, (0.0, direction), &[0.0, 0.0], &options, &mut []).unwrap();
        assert_eq!(solution.stop, Stop::NotFinite { component: 1 });
        assert!((solution.t_end.abs() - 0.5).abs() < 1e-14, "{solution}");
        assert!(solution.t_end.abs() <= 0.5);
        // ∫ √(0.5 − t) dt over [0, 0.5]; 1e-3 is the relative tolerance.
        let exact = 2.0 / 3.0 * 0.5_f64.powf(1.5);
        assert!((solution.y_end[1].abs() - exact).abs() < 1e-3, "{solution}");
    }
}

#[test]
fn a_right_hand_side_that_fails_ends_the_run_with_its_own_reason() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 1.0;
        if y[0] > 0.25 {
            let message = "matrix of order 1 is singular".to_owned();
            return Err(Failure { code: "singular", message });
        }
        Ok(())
    };
    let solution = integrate(rhs, (0.0, 1.0), &[0.0], &Options::default(), &mut []).unwrap();
    assert_eq!((solution.stop.code().as_str(), solution.stop.is_failure()), ("singular", true));
    assert!((solution.t_end - 0.25).abs() < 1e-14 && solution.rejected > 0, "{solution}");
    assert!(solution.to_string().ends_with("matrix of order 1 is singular"), "{solution}");
}

#[test]
fn a_start_without_a_derivative_is_a_run_of_no_steps() {
    let rhs = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = f64::INFINITY;
        Ok(())
    };
    for output in [OutputOption::Steps { refine: 4 }, OutputOption::Ends, OutputOption::At(vec![0.0, 1.0])] {
        let options = Options { output, ..Options::default() };
        let solution = integrate(rhs, (0.0, 1.0), &[3.0], &options, &mut []).unwrap();
        assert_eq!(solution.stop, Stop::NotFinite { component: 0 });
        assert_eq!((solution.t, solution.y), (vec![0.0], vec![vec![3.0]]));
        assert_eq!((solution.steps, solution.t_end, solution.evaluations), (0, 0.0, 1));
    }
}

/// A passing NaN: f has no value in a gap narrower than a step; a smaller step jumps it.
#[test]
fn a_step_is_tried_again_where_a_stage_has_no_value() {
    let mut failures = 0;
    let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
        let gap = (t - 0.5).abs() < 1e-3 && failures < 3;
        failures += i32::from(gap);
        dydt[0] = if gap { f64::NAN } else { 1.0 };
        Ok(())
    };
    let options = Options { initial_step: Some(0.5), max_step: Some(0.5), ..Options::default() };
    let solution = integrate(rhs, (0.0, 1.0), &[0.0], &options, &mut []).unwrap();
    assert_eq!(solution.stop, Stop::End);
    assert!(solution.rejected >= 1, "{solution}");
    assert!((solution.y_end[0] - 1.0).abs() < 1e-14, "{solution}");
}

#[test]
fn a_state_that_overflows_is_not_finite() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = y[0];
        Ok(())
    };
    let options = Options { output: OutputOption::Ends, ..Options::default() };
    let solution = integrate(rhs, (0.0, 100.0), &[1e300], &options, &mut []).unwrap();
    assert!(solution.stop.is_failure(), "{solution}");
    assert!(solution.y_end[0].is_finite());
    // e^t reaches the largest number, 1.8e308, at t = ln 1.8e8 = 19.0.
    assert!((solution.t_end - 19.0).abs() < 0.1, "{solution}");
}

#[test]
fn keeping_only_the_ends_keeps_two_points_of_many_steps() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = y[1];
        dydt[1] = -y[0];
        Ok(())
    };
    let options = Options { output: OutputOption::Ends, ..Options::tolerances(1e-12, 1e-12) };
    let solution = integrate(rhs, (0.0, 100.0), &[1.0, 0.0], &options, &mut []).unwrap();
    assert!(solution.steps > 5_000, "{solution}");
    assert_eq!((solution.t, solution.y.len()), (vec![0.0, 100.0], 2));
    // The global error of an oscillator grows linearly: about steps × tolerance.
    assert!((solution.y_end[0] - 100_f64.cos()).abs() < 1e-8);
}

/// A span of a few ulp, a span around zero, and a first step larger than the span.
#[test]
fn spans_of_any_size_are_crossed() {
    let rhs = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 1.0;
        Ok(())
    };
    for (t0, t1) in [(1.0, 1.0 + 4.0 * f64::EPSILON), (1e9, 1e9 + 1e-6), (-1e-300, 1e-300)] {
        for options in [Options::default(), Options { initial_step: Some(1e3), ..Options::default() }] {
            let solution = integrate(rhs, (t0, t1), &[0.0], &options, &mut []).unwrap();
            assert_eq!((solution.stop, solution.t_end), (Stop::End, t1));
        }
    }
}

/// Goal: who follows a run sees every step, may end it, and changes nothing. Method: the same run with nobody, with one
/// who only looks, and with one who ends it in the middle.
#[test]
fn a_run_that_is_ended_from_outside_keeps_what_it_has() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        (dydt[0], dydt[1]) = (y[1], -y[0]);
        Ok(())
    };
    let run = |method: Method, poll: Option<Poll>| {
        let step = (method == Method::Rk4).then_some(0.01);
        let options = Options { method, step, poll, ..Options::default() };
        integrate(rhs, (0.0, 10.0), &[1.0, 0.0], &options, &mut []).unwrap()
    };
    for method in [Method::Rk4, Method::Ode45, Method::Dop853] {
        let alone = run(method, None);
        let seen = Arc::new(Mutex::new(Vec::new()));
        let list = Arc::clone(&seen);
        let look = Poll::new(move |t| {
            list.lock().unwrap().push(t);
            ControlFlow::Continue(())
        });
        assert_eq!(run(method, Some(look)), alone, "{}", method.name());
        let seen = seen.lock().unwrap();
        // The end of the span is the end, whoever looks.
        assert_eq!(seen.len() as u64 + 1, alone.steps);
        let end = Poll::new(|t| if t > 5.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) });
        let ended = run(method, Some(end));
        assert_eq!(ended.stop, Stop::Interrupted);
        assert!(ended.stop.is_failure() && ended.to_string().ends_with("rejected): interrupted"), "{ended}");
        assert_eq!(Some(&ended.t_end), seen.iter().find(|t| **t > 5.0));
        assert_eq!(ended.y, alone.y[..ended.y.len()], "{}", method.name());
        assert_eq!((ended.t.last(), ended.y.last()), (Some(&ended.t_end), Some(&ended.y_end)));
    }
}
