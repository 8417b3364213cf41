//! Parity of `dopri5` and `dop853` with Hairer's programs, by way of the crate `ode_solvers`, a translation of them.

#[path = "../sim/tests/support/lent.rs"]
#[allow(dead_code, reason = "its part")]
mod lent;
mod problems;

use lent::integrate;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{DVector, Dop853, Dopri5, System};
use problems::{ARENSTORF, KEPLER, PENDULUM, Problem, RIGID_BODY, VAN_DER_POL};
use tripos_sim::{Method, Options, OutputOption};

const PROBLEMS: [Problem; 5] = [PENDULUM, KEPLER, ARENSTORF, VAN_DER_POL, RIGID_BODY];

struct Theirs<'p>(&'p Problem);

impl System<f64, DVector<f64>> for Theirs<'_> {
    fn system(&self, t: f64, y: &DVector<f64>, dy: &mut DVector<f64>) {
        (self.0.rhs)(t, y.as_slice(), dy.as_mut_slice()).unwrap();
    }
}

/// Accepted steps, attempted steps, evaluations, and the last state.
#[derive(Debug)]
struct Outcome {
    accepted: u64,
    attempted: u64,
    evaluations: u64,
    y_end: Vec<f64>,
}

/// Their run. They count no rejection before the first accepted step, so that attempts are found from the
/// evaluations; and they evaluate f at the start twice, of which one is taken off.
fn theirs(method: Method, problem: &Problem, tolerance: f64) -> Outcome {
    let y0 = DVector::from_column_slice(problem.y0);
    let system = Theirs(problem);
    // A test for stiffness every so many steps would end the run: Hairer's programs have it too, ours has not.
    let never = u32::MAX;
    let (stats, y) = match method {
        Method::Dop853 => {
            let mut stepper = Dop853::from_param(
                system,
                0.0,
                problem.span,
                0.0,
                y0,
                tolerance,
                tolerance,
                0.9,
                0.0,
                0.333,
                6.0,
                problem.span,
                0.0,
                never,
                never,
                OutputType::Sparse,
            );
            (stepper.integrate().unwrap(), stepper.y_out().last().unwrap().as_slice().to_vec())
        }
        _ => {
            let mut stepper = Dopri5::from_param(
                system,
                0.0,
                problem.span,
                0.0,
                y0,
                tolerance,
                tolerance,
                0.9,
                0.04,
                0.2,
                10.0,
                problem.span,
                0.0,
                never,
                never,
                OutputType::Sparse,
            );
            (stepper.integrate().unwrap(), stepper.y_out().last().unwrap().as_slice().to_vec())
        }
    };
    let evaluations = u64::from(stats.num_eval) - 1;
    let accepted = u64::from(stats.accepted_steps);
    let attempted = match method {
        Method::Dop853 => (evaluations - 2 - accepted) / 11,
        _ => (evaluations - 2) / 6,
    };
    Outcome { accepted, attempted, evaluations, y_end: y }
}

fn ours(method: Method, problem: &Problem, tolerance: f64) -> Outcome {
    let options = Options { method, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) };
    let solution = integrate(problem.rhs, (0.0, problem.span), problem.y0, &options, &mut []).unwrap();
    Outcome {
        accepted: solution.steps,
        attempted: solution.steps + solution.rejected,
        evaluations: solution.evaluations,
        y_end: solution.y_end,
    }
}

/// Goal: our formulae, norms and step control are Hairer's. Method: five problems at nine tolerances; counts equal, and
/// states equal up to rounding. 1e-7 since rounding is magnified by the pendulum near its upper rest (e^(3.1 · 6) a
/// period) and by the close passages of Arenstorf's orbit.
fn assert_parity(method: Method) {
    for problem in &PROBLEMS {
        for digits in 4..=12 {
            let tolerance = 10_f64.powi(-digits);
            let (a, b) = (ours(method, problem, tolerance), theirs(method, problem, tolerance));
            let counts = |o: &Outcome| (o.accepted, o.attempted, o.evaluations);
            assert_eq!(counts(&a), counts(&b), "{} at {tolerance:e}", problem.name);
            for (a, b) in a.y_end.iter().zip(&b.y_end) {
                assert!((a - b).abs() < 1e-7, "{} at {tolerance:e}: {a} {b}", problem.name);
            }
        }
    }
}

#[test]
fn dopri5_takes_the_steps_of_ode_solvers() {
    assert_parity(Method::Dopri5);
}

#[test]
fn dop853_takes_the_steps_of_ode_solvers() {
    assert_parity(Method::Dop853);
}

/// The authors' own example for `dopri5.f`, Arenstorf's orbit at 1e-7, prints "fcn= 1442 step= 240 accpt= 216 rejct=
/// 22": two rejections came before the first accepted step, which their program does not count.
#[test]
fn dopri5_takes_the_steps_that_its_authors_print() {
    let found = ours(Method::Dopri5, &ARENSTORF, 1e-7);
    assert_eq!((found.evaluations, found.attempted, found.accepted), (1442, 240, 216));
}

/// Goal: `dop853` is exact for right-hand sides with time. `ode_solvers` is no oracle for them: it evaluates the
/// twelfth stage at t instead of t + h (its c₁₂ is 0; in `dop853.f` the stage has `XPH = X + H`).
#[test]
fn dop853_integrates_powers_of_time_exactly() {
    let rhs = |t: f64, _y: &[f64], dydt: &mut [f64]| {
        dydt[0] = 8.0 * t.powi(7);
        Ok(())
    };
    let options = Options { method: Method::Dop853, step: Some(1.0), ..Options::default() };
    let solution = integrate(rhs, (0.0, 1.0), &[0.0], &options, &mut []).unwrap();
    // Terms up to 20 (the largest weights) cancel: 32 ε.
    assert!((solution.y_end[0] - 1.0).abs() < 32.0 * f64::EPSILON, "{}", solution.y_end[0]);
}
