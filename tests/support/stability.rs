//! Runs of compiled equations from stated starts, in doubles and in twice their precision.

use super::compiled;
use tripos_sim::work_precision::work_precision_error;
use tripos_sim::{Dynamics, EliminatedDynamics, Event, Method, Options, OutputOption, Solution, integrate};
use tripos_traits::{CompiledSystem, DoubleDouble, Real, Scalar};

/// A number to 32 digits from its decimals.
pub fn wide(text: &str) -> DoubleDouble {
    DoubleDouble::decimal(text)
}

/// π/2 to 32 digits.
pub fn right_angle() -> DoubleDouble {
    DoubleDouble::pi() * DoubleDouble::ratio(1, 2)
}

/// Parameters and a state (q, u), exactly as they are stated.
#[derive(Clone)]
pub struct Start {
    pub p: Vec<DoubleDouble>,
    pub q: Vec<DoubleDouble>,
    pub u: Vec<DoubleDouble>,
}

impl Start {
    pub fn new(p: &[&str], q: &[&str], u: &[&str]) -> Self {
        let all = |list: &[&str]| list.iter().map(|t| wide(t)).collect();
        Self { p: all(p), q: all(q), u: all(u) }
    }
}

/// Compiled equations, with the distance of one coordinate from a right angle where their name says so.
pub struct Equations {
    pub system: &'static CompiledSystem,
    distance: Option<usize>,
}

pub fn rounded(list: &[DoubleDouble]) -> Vec<f64> {
    list.iter().map(|x| x.to_f64()).collect()
}

impl Equations {
    pub fn new(model: &str, name: &str) -> Self {
        let distance = name.contains('@').then_some(1);
        Self { system: compiled(model, name), distance }
    }

    /// (q, v) as the equations have them.
    pub fn state(&self, start: &Start) -> Vec<DoubleDouble> {
        let mut q = start.q.clone();
        if let Some(at) = self.distance {
            q[at] = q[at] - right_angle();
        }
        let mut v = vec![DoubleDouble::int(0); start.u.len()];
        self.system.extended.motion_variables(&start.p, &q, &start.u, &mut v);
        [q, v].concat()
    }

    /// (q, u) of a state of the equations.
    pub fn seen(&self, p: &[DoubleDouble], y: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let (q, v) = y.split_at(self.system.extended.lengths().coordinates);
        let mut u = vec![DoubleDouble::int(0); v.len()];
        self.system.extended.generalized_speeds(p, q, v, &mut u);
        let mut q = q.to_vec();
        if let Some(at) = self.distance {
            q[at] = q[at] + right_angle();
        }
        [q, u].concat()
    }

    /// (q, u) at the end of a run in twice the precision of a double.
    pub fn reference(&self, start: &Start, t: f64, tolerance: f64) -> Vec<DoubleDouble> {
        let rhs = EliminatedDynamics::new(self.system.extended, &start.p).unwrap();
        let solution = integrate(rhs, (0.0, t), &self.state(start), &options(Method::Dop853, tolerance), &mut []);
        self.seen(&start.p, &solution.unwrap().y_end)
    }

    /// A run in doubles, with accelerations eliminated.
    pub fn run(&self, start: &Start, t: f64, options: &Options, events: &mut [Event<'_>]) -> Solution {
        let rhs = EliminatedDynamics::new(self.system.double, &rounded(&start.p)).unwrap();
        integrate(rhs, (0.0, t), &rounded(&self.state(start)), options, events).unwrap()
    }

    /// The same with accelerations from the linear system at each state.
    pub fn run_numeric(&self, start: &Start, t: f64, options: &Options) -> Solution {
        let rhs = Dynamics::new(self.system.double, &rounded(&start.p)).unwrap();
        integrate(rhs, (0.0, t), &rounded(&self.state(start)), options, &mut []).unwrap()
    }

    /// The error of a run's end; not a number if it did not arrive.
    pub fn error(&self, start: &Start, solution: &Solution, reference: &[DoubleDouble]) -> f64 {
        if solution.stop.code() != "end" {
            return f64::NAN;
        }
        let y: Vec<DoubleDouble> = solution.y_end.iter().map(|x| DoubleDouble::from_f64(*x)).collect();
        work_precision_error(&self.seen(&start.p, &y), reference)
    }
}

/// Adaptive, the same relative and absolute tolerance, only the ends kept.
pub fn options(method: Method, tolerance: f64) -> Options {
    Options { method, step_limit: 5_000_000, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) }
}

/// Equal steps.
pub fn fixed(method: Method, step: f64) -> Options {
    Options { step: Some(step), ..options(method, 1e-6) }
}
