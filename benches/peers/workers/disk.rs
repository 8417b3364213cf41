//! What the workers for the disk share: the question, equations that are known when a worker is compiled, and the lines
//! that `benches/peers/run.py` documents.

use std::io::{BufRead, Write};
use std::process::ExitCode;

use tripos_sim::{AbsoluteTolerance, Failure, Method, Options, Output, RightHandSide};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

/// Coordinates; as many rates follow them in a state.
pub const N: usize = 5;
/// End of the run, in s.
pub const SPAN: f64 = 10.0;
/// M, R and g.
pub const PARAMETERS: [&str; 3] = ["1", "1", "9.81"];
/// q, of which the first three are in degrees, and q̇.
pub const START: [&str; 2 * N] = ["10", "2", "45", "5", "1", "0.01", "-0.1", "0.02", "0.4", "0.1"];

/// The scene's start and parameters, rounded once to `S`.
pub fn question<S: Real>() -> (Vec<S>, Vec<S>) {
    let degree = DoubleDouble::pi() / DoubleDouble::int(180);
    let state = START.iter().enumerate().map(|(i, text)| {
        let value = DoubleDouble::decimal(text);
        narrow(if i < 3 { value * degree } else { value })
    });
    (PARAMETERS.iter().map(|text| S::decimal(text)).collect(), state.collect())
}

fn narrow<S: Real>(x: DoubleDouble) -> S {
    S::from_f64(x.hi()) + S::from_f64(x.lo())
}

/// Equations that are known when this is compiled: no virtual call, and the compiler may inline.
pub struct Known<E> {
    /// The equations.
    pub equations: E,
    /// Their parameters.
    pub parameters: Vec<f64>,
    /// Working space of the Taylor coefficients.
    pub work: Vec<f64>,
}

impl<E: System<f64>> RightHandSide for Known<E> {
    #[inline]
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        let n = self.equations.coordinates();
        let ((q, v), (q_dot, v_dot)) = (y.split_at(n), dydt.split_at_mut(n));
        self.equations.derivative(&self.parameters, q, v, q_dot, v_dot);
        Ok(())
    }

    #[inline]
    fn taylor(&mut self, _t: f64, order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
        let room = self.equations.taylor_work(order);
        if self.work.len() < room {
            self.work.resize(room, 0.0);
        }
        self.equations.taylor(&self.parameters, order, x, &mut self.work);
        Some(Ok(()))
    }
}

/// Ends only, at rtol = atol = `tolerance`.
pub fn options(method: Method, tolerance: f64) -> Options {
    Options {
        method,
        rtol: tolerance,
        atol: AbsoluteTolerance::Uniform(tolerance),
        output: Output::Ends,
        ..Options::default()
    }
}

/// Each so that reading it gives the same number.
pub fn numbers(values: &[f64]) -> String {
    let words: Vec<String> = values.iter().map(f64::to_string).collect();
    words.join(" ")
}

/// Answers lines until there are no more, or one is not understood.
pub fn serve(mut answer: impl FnMut(&str) -> Option<String>) -> ExitCode {
    for line in std::io::stdin().lock().lines() {
        let Some(answered) = line.ok().and_then(|line| answer(&line)) else { return ExitCode::from(2) };
        let mut out = std::io::stdout().lock();
        if writeln!(out, "{answered}").and_then(|()| out.flush()).is_err() {
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
