//! Properties of Gauss–Legendre collocation alone: conservation, Newton's method, its error estimate.
#![allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]

use crate::lent::integrate;
use tripos_sim::{Failure, Method, Options, OutputOption, RightHandSide, Solution, Stop, WithJacobian};

const TAU: f64 = std::f64::consts::TAU;

/// Kepler's problem with eccentricity 0.6.
fn kepler() -> impl RightHandSide<f64> {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        let r3 = (y[0] * y[0] + y[1] * y[1]).powf(1.5);
        dydt.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
        Ok(())
    };
    let jacobian = |_t: f64, y: &[f64], out: &mut [f64]| {
        let r2: f64 = y[0] * y[0] + y[1] * y[1];
        let (r3, r5) = (r2.powf(1.5), r2.powf(2.5));
        let force = |i: usize, j: usize| 3.0 * y[i] * y[j] / r5 - if i == j { 1.0 / r3 } else { 0.0 };
        out.fill(0.0);
        (out[2], out[7]) = (1.0, 1.0);
        (out[8], out[9], out[12], out[13]) = (force(0, 0), force(0, 1), force(1, 0), force(1, 1));
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

const START: [f64; 4] = [0.4, 0.0, 0.0, 2.0];

fn energy(y: &[f64]) -> f64 {
    0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / y[0].hypot(y[1])
}

fn momentum(y: &[f64]) -> f64 {
    y[0] * y[3] - y[1] * y[2]
}

fn fixed(step: f64) -> Options {
    Options {
        method: Method::Gauss6,
        step: Some(step),
        output: OutputOption::Steps { refine: 1 },
        ..Options::default()
    }
}

/// Largest distance of an invariant from its start over part of the samples.
fn drift(solution: &Solution, invariant: fn(&[f64]) -> f64, part: std::ops::Range<f64>) -> f64 {
    let n = solution.y.len() as f64;
    let start = invariant(&solution.y[0]);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positions of samples")]
    let samples = &solution.y[(part.start * n) as usize..(part.end * n) as usize];
    samples.iter().map(|y| (invariant(y) - start).abs()).fold(0.0, f64::max)
}

/// Goal: no secular drift. Method: 300 revolutions, 30 000 steps. The angular momentum is quadratic: 64 ε of its size
/// 0.8 after so many roundings. The energy swings within the band of its first tenth.
#[test]
fn equal_steps_conserve_momentum_to_rounding_and_energy_in_a_band() {
    let solution = integrate(kepler(), (0.0, 300.0 * TAU), &START, &fixed(TAU / 100.0), &mut []).unwrap();
    assert_eq!((solution.stop.clone(), solution.steps, solution.jacobians), (Stop::End, 30_000, 30_000));
    assert!(drift(&solution, momentum, 0.0..1.0) < 64.0 * f64::EPSILON);
    let (first, last) = (drift(&solution, energy, 0.0..0.1), drift(&solution, energy, 0.9..1.0));
    assert!(first < 1e-7 && (last / first - 1.0).abs() < 1e-3, "{first:e} {last:e}");
}

/// The two quadratic invariants of Euler's equations, over 100 000 steps of a tumbling body. 256 ε of their size 5.
#[test]
fn a_rigid_body_keeps_its_energy_and_momentum_to_rounding() {
    let rhs = |_t: f64, w: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[-w[1] * w[2], w[2] * w[0], -w[0] * w[1] / 3.0]);
        Ok(())
    };
    let jacobian = |_t: f64, w: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&[0.0, -w[2], -w[1], w[2], 0.0, w[0], -w[1] / 3.0, -w[0] / 3.0, 0.0]);
        Ok(())
    };
    let equations = WithJacobian { rhs, jacobian };
    let solution = integrate(equations, (0.0, 5_000.0), &[0.01, 2.0, 0.02], &fixed(0.05), &mut []).unwrap();
    let energy = |w: &[f64]| 0.5 * (w[0] * w[0] + 2.0 * w[1] * w[1] + 3.0 * w[2] * w[2]);
    let momentum = |w: &[f64]| w[0] * w[0] + 4.0 * w[1] * w[1] + 9.0 * w[2] * w[2];
    for (invariant, size) in [(energy as fn(&[f64]) -> f64, 4.0), (momentum, 16.0)] {
        let found = drift(&solution, invariant, 0.0..1.0);
        assert!(found < 64.0 * f64::EPSILON * size, "{found:e}");
    }
}

/// Goal: the estimate is honest. Method: three revolutions; the error over the tolerance must be moderate at each of
/// nine tolerances, which the motion magnifies by some 100, and fall with it.
#[test]
fn adaptive_steps_follow_the_tolerance() {
    for digits in 4..=12 {
        let tolerance = 10_f64.powi(-digits);
        let options =
            Options { method: Method::Gauss6, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) };
        let solution = integrate(kepler(), (0.0, 3.0 * TAU), &START, &options, &mut []).unwrap();
        let error = solution.y_end.iter().zip(START).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error < 200.0 * tolerance && error > tolerance, "{tolerance:e}: {error:e}");
        assert!(solution.steps < 1_500, "{tolerance:e}: {solution}");
    }
}

/// A linear system that decays a thousand times a step: the implicit method goes through in a few steps.
#[test]
fn a_stiff_linear_system_is_stable_at_long_steps() {
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = -1e4 * (y[0] - t.cos()) - t.sin();
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = -1e4;
        Ok(())
    };
    let solution = integrate(WithJacobian { rhs, jacobian }, (0.0, 10.0), &[1.0], &fixed(0.1), &mut []).unwrap();
    assert!((solution.y_end[0] - 10_f64.cos()).abs() < 1e-6, "{:?}", solution.y_end);
}

/// y' = −1000 y with a Jacobian of the wrong sign.
fn wrong_jacobian() -> impl RightHandSide<f64> {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = -1e3 * y[0];
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = 1e3;
        Ok(())
    };
    WithJacobian { rhs, jacobian }
}

#[test]
fn a_fixed_step_that_newton_cannot_solve_ends_the_run_with_that_reason() {
    let solution = integrate(wrong_jacobian(), (0.0, 1.0), &[1.0], &fixed(0.1), &mut []).unwrap();
    assert!(matches!(solution.stop, Stop::NotConverged { .. }), "{solution}");
    assert_eq!((solution.stop.code().as_str(), solution.steps, solution.t_end), ("not-converged", 0, 0.0));
    assert!(solution.to_string().contains("Newton's method does not solve"), "{solution}");
}

#[test]
fn an_adaptive_step_that_newton_cannot_solve_is_shortened() {
    let options = Options {
        method: Method::Gauss6,
        rtol: 1e-6,
        initial_step: Some(0.1),
        output: OutputOption::Ends,
        ..Options::default()
    };
    let solution = integrate(wrong_jacobian(), (0.0, 0.01), &[1.0], &options, &mut []).unwrap();
    assert_eq!(solution.stop, Stop::End);
    assert!(solution.rejected > 0 && (solution.y_end[0] - (-10_f64).exp()).abs() < 1e-6, "{solution}");
}

#[test]
fn a_jacobian_that_fails_ends_the_run_with_its_own_reason() {
    let rhs = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        dydt[0] = y[0];
        Ok(())
    };
    let jacobian = |_t: f64, _y: &[f64], out: &mut [f64]| {
        out[0] = 1.0;
        Err(Failure { code: "singular", message: "no derivative".to_owned() })
    };
    let solution = integrate(WithJacobian { rhs, jacobian }, (0.0, 1.0), &[1.0], &fixed(0.1), &mut []).unwrap();
    assert_eq!((solution.stop.code().as_str(), solution.steps), ("singular", 0));
}
