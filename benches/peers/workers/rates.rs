//! Times right-hand sides of modules that `tripos emit` wrote: a worker of `benches/peers/run.py`, which documents the
//! lines it reads and answers, and makes the crate `emitted` that this is compiled with: modules, and `choose!` among
//! them by name.
//!
//! `rates PROBLEM KIND STATES`, where KIND says how many states a call takes, as one of [`KINDS`], which `rates kinds`
//! lists. States are (q, q̇), since Lagrange's equations have these.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::process::ExitCode;
use std::time::Instant;

use tripos_traits::{Lanes, Scalar, System};

/// Kinds of scalars of a call, each an arm of `served`.
const KINDS: [&str; 3] = ["one", "4 lanes", "8 lanes"];

/// States of a pass.
const STATES: usize = 128;

/// A scalar that holds one state's number, or those of several states side by side.
trait Packed: Scalar {
    /// Number of states in one scalar.
    const WIDTH: usize;
    /// From so many numbers.
    fn pack(numbers: &[f64]) -> Self;
    /// The number of one of the states.
    fn number(&self, at: usize) -> f64;
}

impl Packed for f64 {
    const WIDTH: usize = 1;
    fn pack(numbers: &[f64]) -> Self {
        numbers[0]
    }
    fn number(&self, _at: usize) -> f64 {
        *self
    }
}

impl<const W: usize> Packed for Lanes<W> {
    const WIDTH: usize = W;
    fn pack(numbers: &[f64]) -> Self {
        Lanes(std::array::from_fn(|at| numbers[at]))
    }
    fn number(&self, at: usize) -> f64 {
        self.0[at]
    }
}

/// Equations with N coordinates, the state being D = 2 N numbers, and the states they are asked at.
struct Bench<E, S, const N: usize, const D: usize> {
    equations: E,
    parameters: Vec<S>,
    states: Vec<[S; D]>,
    rates: Vec<[S; D]>,
}

impl<E: System<S>, S: Packed, const N: usize, const D: usize> Bench<E, S, N, D> {
    /// From a file with the parameters in the first line and a state in each of the others.
    fn new(equations: E, text: &str) -> Option<Self> {
        let numbers = |line: &str| line.split_whitespace().map(|word| word.parse().ok()).collect::<Option<Vec<f64>>>();
        let mut lines = text.lines().map(numbers);
        let parameters = lines.next()??.iter().map(|x| S::from_f64(*x)).collect();
        let rows: Vec<[f64; D]> = lines.map(|row| row?.try_into().ok()).take(STATES).collect::<Option<_>>()?;
        let packed =
            |rows: &[[f64; D]]| std::array::from_fn(|i| S::pack(&rows.iter().map(|row| row[i]).collect::<Vec<_>>()));
        let states: Vec<[S; D]> = rows.chunks_exact(S::WIDTH).map(packed).collect();
        let rates = states.clone();
        (rows.len() == STATES).then_some(Self { equations, parameters, states, rates })
    }

    /// (q̇, q̈) by a call that the compiler does not see into from outside, as an integrator's is that serves any
    /// equations.
    #[inline(never)]
    fn rates(equations: &E, p: &[S], y: &[S; D], out: &mut [S; D]) {
        let ((q, v), (q_dot, v_dot)) = (y.split_at(N), out.split_at_mut(N));
        equations.derivative(p, q, v, q_dot, v_dot);
    }

    /// Seconds for a state, by calls that do not wait for one another.
    fn throughput(&mut self, passes: u32) -> Vec<f64> {
        let begin = Instant::now();
        for _ in 0..passes {
            for (y, out) in self.states.iter().zip(&mut self.rates) {
                Self::rates(&self.equations, &self.parameters, y, out);
            }
        }
        let seconds = begin.elapsed().as_secs_f64();
        black_box(&self.rates);
        vec![seconds / f64::from(passes) / STATES as f64]
    }

    /// The same by calls that each wait for the one before, as in a run.
    fn chained(&mut self, passes: u32) -> Vec<f64> {
        let (mut carried, mut out) = (S::int(0), self.rates[0]);
        let tiny = S::from_f64(1e-300);
        let begin = Instant::now();
        for _ in 0..passes {
            for y in &self.states {
                let y = y.map(|y| y + tiny * carried);
                Self::rates(&self.equations, &self.parameters, &y, &mut out);
                carried = out[N + 1] + out[D - 2] + out[D - 1];
            }
        }
        let seconds = begin.elapsed().as_secs_f64();
        vec![seconds / f64::from(passes) / STATES as f64, black_box(carried).number(0)]
    }

    /// The derivatives at the first states, one after the other.
    fn values(&mut self, count: usize) -> Vec<f64> {
        for (y, out) in self.states.iter().zip(&mut self.rates) {
            Self::rates(&self.equations, &self.parameters, y, out);
        }
        let of = |at: usize| self.rates[at / S::WIDTH].map(|x| x.number(at % S::WIDTH));
        (0..count.min(STATES)).flat_map(of).collect()
    }

    fn answer(&mut self, line: &str) -> Option<String> {
        let (what, number) = line.trim().split_once(' ')?;
        let answer = match what {
            "throughput" => self.throughput(number.parse().ok()?),
            "chained" => self.chained(number.parse().ok()?),
            "values" => self.values(number.parse().ok()?),
            _ => return None,
        };
        Some(answer.iter().map(f64::to_string).collect::<Vec<_>>().join(" "))
    }

    fn serve(mut self) -> ExitCode {
        for line in std::io::stdin().lock().lines() {
            let Some(answer) = line.ok().and_then(|line| self.answer(&line)) else { return ExitCode::from(2) };
            let mut out = std::io::stdout().lock();
            if writeln!(out, "{answer}").and_then(|()| out.flush()).is_err() {
                return ExitCode::FAILURE;
            }
        }
        ExitCode::SUCCESS
    }
}

/// Serves the equations of one module, whatever scalars a KIND means.
macro_rules! served {
    ($module:ident, $kind:expr, $text:expr) => {{
        const N: usize = emitted::$module::COORDINATES.len();
        let equations = emitted::$module::lagrange::Lagrange;
        match $kind {
            "one" => Bench::<_, f64, N, { 2 * N }>::new(equations, $text).map(Bench::serve),
            "4 lanes" => Bench::<_, Lanes<4>, N, { 2 * N }>::new(equations, $text).map(Bench::serve),
            "8 lanes" => Bench::<_, Lanes<8>, N, { 2 * N }>::new(equations, $text).map(Bench::serve),
            _ => None,
        }
    }};
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments == ["kinds"] {
        println!("{}", KINDS.join("\n"));
        return ExitCode::SUCCESS;
    }
    let served = match arguments.as_slice() {
        [problem, kind, path] => std::fs::read_to_string(path)
            .ok()
            .and_then(|text| emitted::choose!(problem.as_str(), served, kind.as_str(), &text)),
        _ => None,
    };
    served.unwrap_or_else(|| {
        eprintln!("usage: rates PROBLEM KIND STATES");
        ExitCode::from(2)
    })
}
