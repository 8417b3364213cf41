//! The disk by generated code and this project's DOP853: a worker of `benches/peers/run.py`, which documents the lines it
//! reads and answers.
//!
//! `peer lagrange` and `peer kane` know their equations when they are compiled; `peer eliminated-lagrange` and
//! `peer eliminated-kane` go through [`Eliminated`] and a virtual call, as a program does that learns at run time which model
//! to run. States are put and answered as q and q̇.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::process::ExitCode;
use std::time::Instant;

use tripos::disk::{kane, lagrange};
use tripos_sim::{
    AbsoluteTolerance, Eliminated, Failure, Lent, Method, Options, Output, RightHandSide, Solution, Stop, integrate,
};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

/// Coordinates; as many rates follow them in a state.
const N: usize = 5;
/// End of the run, in s.
const SPAN: f64 = 10.0;
/// M, R and g.
const PARAMETERS: [&str; 3] = ["1", "1", "9.81"];
/// q, of which the first three are in degrees, and q̇.
const START: [&str; 2 * N] = ["10", "2", "45", "5", "1", "0.01", "-0.1", "0.02", "0.4", "0.1"];

/// The scene's start and parameters, rounded once to `S`.
fn question<S: Real>() -> (Vec<S>, Vec<S>) {
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

/// Equations with their state in terms of q and q̇, whatever their own speeds are.
struct Equations<'a, S> {
    system: &'a dyn System<S>,
    parameters: Vec<S>,
}

impl<S: Real> Equations<'_, S> {
    /// [q; v] from [q; q̇]: the speeds of Lagrange's equations are the q̇, and every formulation knows the generalized
    /// speeds of the model file.
    fn state(&self, y: &[S]) -> Vec<S> {
        let p = &self.parameters;
        let (q, q_dot) = y.split_at(N);
        let (mut u, mut v) = ([S::int(0); N], [S::int(0); N]);
        System::<S>::generalized_speeds(&lagrange::Lagrange, p, q, q_dot, &mut u);
        self.system.motion_variables(p, q, &u, &mut v);
        [q, &v].concat()
    }

    /// [q; q̇] from [q; v].
    fn rates(&self, y: &[S]) -> Vec<S> {
        let (q, v) = y.split_at(N);
        let mut q_dot = [S::int(0); N];
        self.system.coordinate_rates(&self.parameters, q, v, &mut q_dot);
        [q, &q_dot].concat()
    }
}

/// Equations that are known when this is compiled: no virtual call, and the compiler may inline.
struct Known<E> {
    equations: E,
    parameters: Vec<f64>,
}

impl<E: System<f64>> RightHandSide for Known<E> {
    #[inline]
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        let ((q, v), (q_dot, v_dot)) = (y.split_at(N), dydt.split_at_mut(N));
        self.equations.derivative(&self.parameters, q, v, q_dot, v_dot);
        Ok(())
    }
}

/// From the start to the end of the span at rtol = atol = `tolerance`.
fn run<S: Real, R: RightHandSide<S>>(rhs: &mut R, y0: &[S], tolerance: f64) -> Solution<S> {
    let options = Options {
        method: Method::Dop853,
        rtol: tolerance,
        atol: AbsoluteTolerance::Uniform(tolerance),
        output: Output::Ends,
        ..Options::default()
    };
    integrate(Lent(rhs), (0.0, SPAN), y0, &options, &mut []).expect("the question makes sense")
}

fn answer_run<R: RightHandSide>(
    rhs: &mut R,
    equations: &Equations<'_, f64>,
    y0: &[f64],
    words: &[&str],
) -> Option<String> {
    let [tolerance, repeats] = words else { return None };
    let (tolerance, repeats): (f64, u32) = (tolerance.parse().ok()?, repeats.parse().ok()?);
    let mut solution = None;
    let begin = Instant::now();
    for _ in 0..repeats {
        solution = Some(run(rhs, black_box(y0), tolerance));
    }
    let seconds = begin.elapsed().as_secs_f64() / f64::from(repeats);
    let solution = solution?;
    let attempts = solution.steps + solution.rejected;
    let end = numbers(&equations.rates(&solution.y_end));
    Some(format!("{seconds:e} {attempts} {} {end}", solution.evaluations))
}

/// Seconds for one call of the right-hand side, each call waiting for the one before, as in a run.
fn answer_rates<R: RightHandSide>(rhs: &mut R, y0: &[f64], words: &[&str]) -> Option<String> {
    let [repeats] = words else { return None };
    let repeats: u32 = repeats.parse().ok()?;
    let y0: [f64; 2 * N] = y0.try_into().ok()?;
    let (mut f, mut carried) = ([0.0; 2 * N], 0.0);
    let begin = Instant::now();
    for _ in 0..repeats {
        let y = y0.map(|y| y + 1e-300 * carried);
        rhs.rhs(0.0, &y, &mut f).ok()?;
        carried = f[6] + f[8] + f[9];
    }
    Some(format!("{:e} {carried}", begin.elapsed().as_secs_f64() / f64::from(repeats)))
}

/// The end state computed with 32 digits from the start as it is written, not as an `f64` rounds it; or, with the
/// argument `rounded`, from the start that all workers take.
fn answer_reference(words: &[&str]) -> Option<String> {
    let (parameters, start) = match words {
        [_] => question::<DoubleDouble>(),
        [_, "rounded"] => {
            let (parameters, start) = question::<f64>();
            let widen = |values: Vec<f64>| values.into_iter().map(DoubleDouble::from).collect();
            (widen(parameters), widen(start))
        }
        _ => return None,
    };
    let tolerance: f64 = words[0].parse().ok()?;
    let equations = Equations { system: &lagrange::Lagrange, parameters };
    let mut rhs = Eliminated::new(equations.system, &equations.parameters)?;
    let solution = run(&mut rhs, &equations.state(&start), tolerance);
    let end: Vec<f64> = equations.rates(&solution.y_end).iter().map(|y| y.to_f64()).collect();
    (solution.stop == Stop::End).then(|| numbers(&end))
}

/// Each so that reading it gives the same number.
fn numbers(values: &[f64]) -> String {
    let words: Vec<String> = values.iter().map(f64::to_string).collect();
    words.join(" ")
}

/// Answers one line; `None` if it is not understood.
fn answer<R: RightHandSide>(rhs: &mut R, equations: &Equations<'_, f64>, line: &str) -> Option<String> {
    let (parameters, start) = question::<f64>();
    let y0 = equations.state(&start);
    let words: Vec<&str> = line.split_whitespace().collect();
    match words.split_first()? {
        (&"start", []) => Some(numbers(&[parameters, start].concat())),
        (&"prepare", [_]) => Some("0".to_owned()),
        (&"run", rest) => answer_run(rhs, equations, &y0, rest),
        (&"rates", rest) => answer_rates(rhs, &y0, rest),
        (&"reference", rest) => answer_reference(rest),
        _ => None,
    }
}

fn serve<R: RightHandSide>(mut rhs: R, equations: &Equations<'_, f64>) -> ExitCode {
    for line in std::io::stdin().lock().lines() {
        let answered = line.ok().and_then(|line| answer(&mut rhs, equations, &line));
        let Some(answered) = answered else { return ExitCode::from(2) };
        let mut out = std::io::stdout().lock();
        if writeln!(out, "{answered}").and_then(|()| out.flush()).is_err() {
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn main() -> ExitCode {
    let which = std::env::args().nth(1).unwrap_or_default();
    let (values, _) = question::<f64>();
    let system: &dyn System<f64> = if which.ends_with("kane") { &kane::Kane } else { &lagrange::Lagrange };
    let parameters = black_box(values.clone());
    let equations = Equations { system, parameters: values };
    match which.as_str() {
        "lagrange" => serve(Known { equations: lagrange::Lagrange, parameters }, &equations),
        "kane" => serve(Known { equations: kane::Kane, parameters }, &equations),
        "eliminated-lagrange" | "eliminated-kane" => {
            let rhs = Eliminated::new(system, &equations.parameters).expect("these equations were solved for");
            serve(rhs, &equations)
        }
        _ => {
            eprintln!("usage: peer lagrange | kane | eliminated-lagrange | eliminated-kane");
            ExitCode::from(2)
        }
    }
}
