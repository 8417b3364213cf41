//! Fixed steps, other scalars, and questions that a method cannot answer.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::lent::integrate;
use tripos_sim::{Failure, LentRightHandSide, Method, Options, OutputOption, SimError, Stop, WithJacobian};

#[allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]
fn oscillator(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    dydt[0] = y[1];
    dydt[1] = -y[0];
    Ok(())
}

/// The oscillator with its Jacobian, for methods that need it.
fn with_jacobian() -> impl tripos_sim::RightHandSide<f64> {
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[0.0, 1.0, -1.0, 0.0]);
        Ok(())
    };
    WithJacobian { rhs: oscillator, jacobian }
}

fn fixed(method: Method, step: f64) -> Options {
    Options { method, step: Some(step), output: OutputOption::Steps { refine: 1 }, ..Options::default() }
}

#[test]
fn a_fixed_step_divides_the_span_evenly_whatever_the_method() {
    for method in Method::WITHOUT_SERIES {
        for (span, step, count) in
            [((0.0, 1.0), 0.1, 10), ((0.0, 1.0), 0.3, 4), ((2.0, -1.0), 1.5, 2), ((0.0, 0.1), 7.0, 1)]
        {
            let solution = integrate(with_jacobian(), span, &[1.0, 0.0], &fixed(method, step), &mut []).unwrap();
            assert_eq!((solution.steps, solution.rejected, solution.stop), (count, 0, Stop::End), "{method:?}");
            assert_eq!(solution.t_end, span.1);
            let size = (span.1 - span.0) / count as f64;
            for pair in solution.t.windows(2) {
                assert!((pair[1] - pair[0] - size).abs() < 4.0 * f64::EPSILON, "{method:?} {pair:?}");
            }
        }
    }
}

#[test]
fn a_fixed_step_that_fails_ends_the_run_there() {
    for method in Method::WITHOUT_SERIES {
        let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
            dydt[0] = if t > 0.55 { f64::NAN } else { 1.0 };
            Ok(())
        };
        let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
            out[0] = 0.0;
            Ok(())
        };
        let solution =
            integrate(WithJacobian { rhs, jacobian }, (0.0, 1.0), &[0.0], &fixed(method, 0.1), &mut []).unwrap();
        assert_eq!((solution.steps, solution.stop), (5, Stop::NotFinite { component: 0 }), "{method:?}");
        assert_eq!(solution.t_end, 0.5);
    }
}

#[test]
fn the_step_limit_holds_for_fixed_steps() {
    let options = Options { step_limit: 7, ..fixed(Method::Rk4, 1e-9) };
    let solution = integrate(oscillator, (0.0, 1.0), &[1.0, 0.0], &options, &mut []).unwrap();
    assert_eq!((solution.steps, solution.stop), (7, Stop::StepLimit { limit: 7 }));
}

#[test]
fn a_method_without_an_error_estimate_asks_for_a_step() {
    let options = Options { method: Method::Rk4, ..Options::default() };
    let error = integrate(oscillator, (0.0, 1.0), &[1.0, 0.0], &options, &mut []).unwrap_err();
    assert_eq!(error, SimError::NoStep { method: "rk4" });
    assert!(error.to_string().contains("give it a fixed `step`"), "{error}");
}

#[test]
fn an_implicit_method_asks_for_a_jacobian() {
    let options = Options { method: Method::Gauss6, ..Options::default() };
    let error = integrate(oscillator, (0.0, 1.0), &[1.0, 0.0], &options, &mut []).unwrap_err();
    assert_eq!(error, SimError::NoJacobian { method: "gauss6" });
    assert!(error.to_string().contains("choose an explicit method"), "{error}");
}

#[test]
fn a_step_below_the_rounding_of_time_is_refused() {
    for step in [0.0, f64::NAN, f64::INFINITY, -1.0, 1e-17] {
        let error = integrate(oscillator, (0.0, 1.0), &[1.0, 0.0], &fixed(Method::Rk4, step), &mut []).unwrap_err();
        assert!(matches!(error, SimError::Option { name: "step", .. }), "{step}: {error}");
    }
}

#[test]
fn names_are_distinct_and_stable() {
    assert_eq!(Method::ALL.map(Method::name), ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5", "taylor"]);
}

#[test]
fn a_right_hand_side_may_be_lent_and_used_again() {
    let mut calls = 0;
    let mut rhs = |_t: f64, _y: &[f64], dydt: &mut [f64]| {
        calls += 1;
        dydt[0] = 1.0;
        Ok(())
    };
    for _ in 0..2 {
        integrate(LentRightHandSide(&mut rhs), (0.0, 1.0), &[0.0], &fixed(Method::Rk4, 0.5), &mut []).unwrap();
    }
    assert_eq!(calls, 18); // each run: the start, then 4 a step
}

/// The same equation in `f32`: 1e-6 is some ulp of it, and its smallest tolerance is its own.
#[test]
fn a_run_computes_in_the_scalar_of_its_state() {
    for method in Method::WITHOUT_SERIES {
        let rhs = |_t: f64, y: &[f32], dydt: &mut [f32]| {
            dydt[0] = -y[0];
            Ok(())
        };
        let jacobian = |_t: f64, _y: &[f32], out: &mut [f32]| {
            out[0] = -1.0;
            Ok(())
        };
        let options = Options { rtol: 1e-9, ..fixed(method, 0.01) };
        let rhs = WithJacobian { rhs, jacobian };
        let solution = integrate(rhs, (0.0, 1.0), &[1.0_f32], &options, &mut []).unwrap();
        assert!((solution.y_end[0] - (-1.0_f32).exp()).abs() < 1e-6, "{method:?} {:?}", solution.y_end);
    }
}
