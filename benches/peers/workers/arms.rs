//! Times forward and inverse dynamics of arms by modules that `tripos emit` wrote: a worker of `benches/peers/run.py`,
//! which documents the lines it reads and answers, and makes the crate `arms_emitted` that this is compiled with.
//!
//! `arms PROBLEM STATES`: parameters in the first line of the file, then lines of q, u and u̇.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::process::ExitCode;
use std::time::Instant;

/// An arm of N joints: coordinates, speeds and accelerations of each state.
struct Bench<P, const N: usize> {
    parameters: P,
    states: Vec<[[f64; N]; 3]>,
    forward: fn(&P, &[f64; N], &[f64; N]) -> [f64; N],
    inverse: fn(&P, &[f64; N], &[f64; N], &[f64; N]) -> [f64; N],
}

impl<P, const N: usize> Bench<P, N> {
    /// Mean time for a state, s, of calls whose arguments and results are hidden from the optimizer.
    fn timed(&self, passes: u32, call: impl Fn(&[[f64; N]; 3]) -> [f64; N]) -> f64 {
        let begin = Instant::now();
        for _ in 0..passes {
            for state in &self.states {
                black_box(call(black_box(state)));
            }
        }
        begin.elapsed().as_secs_f64() / f64::from(passes) / self.states.len() as f64
    }

    fn answer(&self, line: &str) -> Option<Vec<f64>> {
        let (what, number) = line.trim().split_once(' ')?;
        let (forward, inverse) = (black_box(self.forward), black_box(self.inverse));
        let of_forward = |[q, u, _]: &[[f64; N]; 3]| forward(&self.parameters, q, u);
        let of_inverse = |[q, u, a]: &[[f64; N]; 3]| inverse(&self.parameters, q, u, a);
        match what {
            "forward" => Some(vec![self.timed(number.parse().ok()?, of_forward)]),
            "inverse" => Some(vec![self.timed(number.parse().ok()?, of_inverse)]),
            "values" => {
                let some = self.states.iter().take(number.parse().ok()?);
                Some(some.flat_map(|state| [of_forward(state), of_inverse(state)].concat()).collect())
            }
            _ => None,
        }
    }

    fn serve(self) -> ExitCode {
        for line in std::io::stdin().lock().lines() {
            let Some(answer) = line.ok().and_then(|line| self.answer(&line)) else { return ExitCode::from(2) };
            let words: Vec<String> = answer.iter().map(f64::to_string).collect();
            let mut out = std::io::stdout().lock();
            if writeln!(out, "{}", words.join(" ")).and_then(|()| out.flush()).is_err() {
                return ExitCode::FAILURE;
            }
        }
        ExitCode::SUCCESS
    }
}

/// The numbers of each line.
fn rows(text: &str) -> Option<Vec<Vec<f64>>> {
    text.lines().map(|line| line.split_whitespace().map(|word| word.parse().ok()).collect()).collect()
}

/// q, u and u̇ of a line.
fn state<const N: usize>(row: &[f64]) -> Option<[[f64; N]; 3]> {
    let parts: Vec<[f64; N]> = row.chunks_exact(N).map(|part| part.try_into().ok()).collect::<Option<_>>()?;
    parts.try_into().ok()
}

/// Serves the equations of one module by Kane's method.
macro_rules! served {
    ($module:ident, $rows:expr) => {{
        use emitted::$module::{Parameters, kane};
        let states = $rows[1..].iter().map(|row| state(row)).collect::<Option<Vec<_>>>();
        let (forward, inverse) = (kane::accelerations::<f64>, kane::inverse_dynamics::<f64>);
        let parameters = Parameters::from_slice(&$rows[0]);
        states.map(|states| Bench { parameters, states, forward, inverse }.serve())
    }};
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let served = match arguments.as_slice() {
        [problem, path] => std::fs::read_to_string(path)
            .ok()
            .and_then(|text| rows(&text))
            .and_then(|rows| emitted::choose!(problem.as_str(), served, rows)),
        _ => None,
    };
    served.unwrap_or_else(|| {
        eprintln!("usage: arms PROBLEM STATES");
        ExitCode::from(2)
    })
}
