//! Projection onto invariants: the quantities that it keeps, and its report.
#![allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]

use crate::lent::{integrate, integrate_projected};
use tripos_sim::projection::{Invariants, ProjectionReport};
use tripos_sim::{Direction, Event, Failure, Method, Options, OutputOption, RightHandSide, Solution};
use tripos_traits::{DoubleDouble, Real};

fn pendulum(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    dydt.copy_from_slice(&[y[1], -9.81 * y[0].sin()]);
    Ok(())
}

fn energy(y: &[f64]) -> f64 {
    0.5 * y[1] * y[1] - 9.81 * y[0].cos()
}

/// The energy, with its gradient times a factor.
fn invariants(factor: f64) -> Invariants<'static> {
    Invariants {
        count: 1,
        function: Box::new(move |_t, y, values, gradients| {
            values[0] = energy(y);
            gradients.copy_from_slice(&[factor * 9.81 * y[0].sin(), factor * y[1]]);
        }),
    }
}

const START: [f64; 2] = [2.5, 0.0];

fn options(method: Method, rtol: f64) -> Options {
    Options { method, output: OutputOption::Ends, ..Options::tolerances(rtol, rtol) }
}

fn projected(options: &Options, span: f64, factor: f64) -> (Solution, ProjectionReport) {
    let solution =
        integrate_projected(pendulum, (0.0, span), &START, options, &mut [], &mut invariants(factor)).unwrap();
    let report = solution.projection.clone().unwrap();
    (solution, report)
}

/// A thousand seconds. 16 ε of the energies that are added: each correction ends within 2 of them.
#[test]
fn the_energy_stays_at_rounding_on_a_long_run() {
    for method in [Method::Ode45, Method::Dopri5, Method::Dop853] {
        let (solution, report) = projected(&options(method, 1e-6), 1000.0, 1.0);
        let drift = energy(&solution.y_end) - energy(&START);
        assert!(drift.abs() < 16.0 * f64::EPSILON * 30.0, "{method:?}: {drift:e}");
        assert!(report.corrections > solution.steps / 2 && report.singular + report.not_converged == 0, "{report:?}");
        let plain = integrate(pendulum, (0.0, 1000.0), &START, &options(method, 1e-6), &mut []).unwrap();
        assert!((energy(&plain.y_end) - energy(&START)).abs() > 1e-5, "or nothing is shown");
        assert_eq!(plain.projection, None);
    }
}

/// The removed drift is the drift of the method, of the same sign and size. Tolerance: a third, since the states of the
/// two runs differ.
#[test]
fn the_drift_removed_is_that_of_the_run_without_projection() {
    for method in [Method::Dopri5, Method::Dop853] {
        let plain = integrate(pendulum, (0.0, 200.0), &START, &options(method, 1e-7), &mut []).unwrap();
        let drift = energy(&plain.y_end) - energy(&START);
        let (_, report) = projected(&options(method, 1e-7), 200.0, 1.0);
        assert!((report.removed[0] / drift - 1.0).abs() < 0.33, "{method:?}: {} and {drift}", report.removed[0]);
        assert!(report.largest[0].abs() <= report.removed[0].abs() && report.largest[0] != 0.0);
        assert!(report.moved.iter().all(|moved| *moved > 0.0));
    }
}

/// Half the step, errors smaller by 2⁴ and 2⁸, less a little; the reference has a step of a tenth.
#[test]
fn the_order_of_convergence_is_that_of_the_method() {
    for (method, step, order) in [(Method::Rk4, 0.02, 4.0), (Method::Dop853, 0.1, 8.0)] {
        let run = |step: f64| {
            let options = Options { step: Some(step), ..options(method, 1e-6) };
            projected(&options, 4.0, 1.0).0.y_end[0]
        };
        let exact = run(step / 10.0);
        let found = ((run(step) - exact) / (run(0.5 * step) - exact)).abs().log2();
        assert!(found > order - 0.7, "{method:?}: {found}");
    }
}

/// Gradients of twice or minus the size, or none: nothing is corrected, and each step says so.
#[test]
fn wrong_gradients_are_noticed() {
    let options = options(Method::Dop853, 1e-6);
    for factor in [4.0, -1.0, 0.4, 0.0, f64::NAN] {
        let (solution, report) = projected(&options, 20.0, factor);
        assert_eq!(report.corrections, 0, "{factor}");
        let counted = if factor.abs() > 0.0 { report.not_converged } else { report.singular };
        assert!(counted > solution.steps / 2, "{factor}: {report:?}");
        let plain = integrate(pendulum, (0.0, 20.0), &START, &options, &mut []).unwrap();
        assert_eq!((plain.y_end, plain.steps), (solution.y_end, solution.steps), "the run is the plain one");
    }
}

/// Kepler's energy and angular momentum together, and the momentum twice: two invariants of one gradient are singular.
#[test]
fn several_invariants_are_kept_at_once_unless_they_depend_on_each_other() {
    let kepler = |_t: f64, y: &[f64], dydt: &mut [f64]| {
        let r3 = y[0].hypot(y[1]).powi(3);
        dydt.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
        Ok(())
    };
    let momentum = |y: &[f64]| y[0] * y[3] - y[1] * y[2];
    let energy = |y: &[f64]| 0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / y[0].hypot(y[1]);
    let y0 = [0.4, 0.0, 0.0, 2.0];
    for twice in [false, true] {
        let mut invariants = Invariants {
            count: 2,
            function: Box::new(move |_t, y: &[f64], values: &mut [f64], gradients: &mut [f64]| {
                let r3 = y[0].hypot(y[1]).powi(3);
                gradients[..4].copy_from_slice(&[y[3], -y[2], -y[1], y[0]]);
                let other = if twice { [y[3], -y[2], -y[1], y[0]] } else { [y[0] / r3, y[1] / r3, y[2], y[3]] };
                gradients[4..].copy_from_slice(&other);
                values.copy_from_slice(&[momentum(y), if twice { momentum(y) } else { energy(y) }]);
            }),
        };
        let options = options(Method::Dop853, 1e-7);
        let solution = integrate_projected(kepler, (0.0, 100.0), &y0, &options, &mut [], &mut invariants).unwrap();
        let report = solution.projection.unwrap();
        if twice {
            assert!(report.corrections == 0 && report.singular > 0);
        } else {
            // 2 ε of the terms of size up to 5.
            assert!((momentum(&solution.y_end) - momentum(&y0)).abs() < 1e-14);
            assert!((energy(&solution.y_end) - energy(&y0)).abs() < 1e-14);
            assert!(report.singular + report.not_converged == 0);
        }
    }
}

/// q″ = −q with all that any method asks for, in any scalar.
struct Oscillator;

impl<S: Real> RightHandSide<S> for Oscillator {
    fn rhs(&mut self, _t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        dydt.copy_from_slice(&[y[1], -y[0]]);
        Ok(())
    }

    fn jacobian(&mut self, _t: f64, _y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        out.copy_from_slice(&[S::int(0), S::int(1), S::int(-1), S::int(0)]);
        Some(Ok(()))
    }

    fn taylor(&mut self, _t: f64, order: usize, x: &mut [S]) -> Option<Result<(), Failure>> {
        for k in 0..order {
            let next = S::from_f64((k + 1) as f64);
            (x[2 * k + 2], x[2 * k + 3]) = (x[2 * k + 1] / next, -x[2 * k] / next);
        }
        Some(Ok(()))
    }
}

/// The radius after 100 s by every method, in doubles and in 32 digits: 4 roundings of 1.
fn radius_is_kept<S: Real>() {
    for method in Method::ALL {
        let mut radius = Invariants {
            count: 1,
            function: Box::new(|_t, y: &[S], values: &mut [S], gradients: &mut [S]| {
                values[0] = y[0] * y[0] + y[1] * y[1];
                gradients.copy_from_slice(&[S::int(2) * y[0], S::int(2) * y[1]]);
            }),
        };
        let options = Options { step: (method == Method::Rk4).then_some(0.05), ..options(method, 1e-5) };
        let start = [S::int(1), S::int(0)];
        let solution = integrate_projected(Oscillator, (0.0, 100.0), &start, &options, &mut [], &mut radius).unwrap();
        let [q, v] = [solution.y_end[0], solution.y_end[1]];
        let drift = (q * q + v * v - S::int(1)).to_f64();
        assert!(drift.abs() <= 8.0 * S::EPSILON, "{method:?}: {drift:e}");
        assert_eq!(solution.projection.unwrap().not_converged, 0, "{method:?}");
    }
}

#[test]
fn every_method_is_projected_in_every_scalar() {
    radius_is_kept::<f64>();
    radius_is_kept::<DoubleDouble>();
}

/// Events are those of the steps as the method took them, each seen once although the state is moved between steps.
#[test]
fn passages_are_all_seen_in_a_projected_run() {
    let mut passages = [Event::recorded("lowest", Direction::Either, |_, y: &[f64]| y[0])];
    let options = options(Method::Dop853, 1e-6);
    let solution =
        integrate_projected(pendulum, (0.0, 100.0), &START, &options, &mut passages, &mut invariants(1.0)).unwrap();
    let half = 0.5 * tripos_sim::exact::Pendulum::new(9.81, 2.5, 0.0).period();
    let passages = (0..1000).filter(|k| (f64::from(*k) + 0.5) * half < 100.0).count();
    assert_eq!(solution.events.len(), passages);
    // The energy is right, so that the phase is off by what the steps' own errors in phase add up to, 1e-6 each at
    // most.
    for (k, event) in solution.events.iter().enumerate() {
        assert!((event.t - (k as f64 + 0.5) * half).abs() < 1e-4, "{}", event.t);
    }
}
