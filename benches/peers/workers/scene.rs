//! The disk by the equations of its scenes: a worker of `benches/peers/run.py`, which documents the lines it reads and
//! answers.
//!
//! `scene SCENE METHOD` runs `report-10s`, whose ten outputs it answers as q and q̇, or `lean`, whose two are q2 and
//! u1. A method is one of [`METHODS`], by stepping, with `-energy` behind its name if the energy is to be kept after
//! each step, or [`QUADRATURE`], for which no tolerance matters.
//!
//! A run is all that follows from the scene's start: the constants of the motion, which are taken from it in twice the
//! precision of a double, as `tripos simulate` does; the motion, in doubles; and the outputs at its end. Which
//! constants there are, and what they are at the start, the reduction of the scene says; it is made once, before any
//! run.

mod disk;
mod start;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use disk::{Known, N, SPAN, numbers, numbers_of, of_batch, options, read, read_starts, serve};
use start::Beginning;
use tripos_models::disk::kane;
use tripos_models::disk::scenes::{lean, report_10s};
use tripos_sim::projection::Invariants;
use tripos_sim::{LentRightHandSide, Method, Solution, Stop, integrate, integrate_projected, quadrature};
use tripos_traits::{CompiledScene, DoubleDouble, System};

/// The methods that step.
const METHODS: &[Method] = &[Method::Dop853, Method::Taylor];
/// The end of a method's name if the energy is kept.
const PROJECTED: &str = "-energy";
/// The motion as integrals.
const QUADRATURE: &str = "quadrature";

/// The motion from its start.
#[derive(Clone, Copy)]
enum Integration {
    Steps(Method),
    Projected(Method),
    Quadrature,
}

impl Integration {
    fn named(name: &str) -> Option<Self> {
        let method = |name| METHODS.iter().copied().find(|method| method.name() == name);
        match name.strip_suffix(PROJECTED) {
            Some(name) => method(name).map(Self::Projected),
            None if name == QUADRATURE => Some(Self::Quadrature),
            None => method(name).map(Self::Steps),
        }
    }
}

/// State of the worker that answers lines.
struct Worker<E> {
    rhs: Known<E>,
    beginning: Beginning,
    /// p, then q and q̇, as the scene's file states them.
    start: Vec<DoubleDouble>,
    /// The same, rounded to doubles.
    question: Vec<f64>,
    how: Integration,
}

impl<E: System<f64> + Copy> Worker<E> {
    /// One run, and its outputs.
    fn once(&mut self, start: &[DoubleDouble], tolerance: f64) -> Option<(Solution, Vec<f64>)> {
        let (parameters, y0) = self.beginning.at(start);
        let (equations, n, span) = (self.rhs.equations, self.rhs.equations.lengths().coordinates, (0.0, SPAN));
        self.rhs.parameters.clone_from(&parameters);
        let with = |method| options(method, tolerance);
        let solution = match self.how {
            Integration::Steps(method) => {
                integrate(LentRightHandSide(&mut self.rhs), span, &y0, &with(method), &mut []).ok()?
            }
            Integration::Projected(method) => {
                let energy = |_: f64, y: &[f64], values: &mut [f64], gradient: &mut [f64]| {
                    values[0] = equations.energy_gradient(&parameters, &y[..n], &y[n..], gradient);
                };
                let mut energy = Invariants { count: 1, function: Box::new(energy) };
                integrate_projected(LentRightHandSide(&mut self.rhs), span, &y0, &with(method), &mut [], &mut energy)
                    .ok()?
            }
            Integration::Quadrature => {
                quadrature::run_by_quadrature(&equations, &parameters, span, &y0, &with(Method::Dop853), &mut [])
                    .ok()?
            }
        };
        let mut outputs = vec![0.0; equations.output_count()];
        let (q, v) = solution.y_end.split_at(n);
        equations.outputs(&parameters, SPAN, q, v, &mut outputs);
        (solution.stop == Stop::End).then_some((solution, outputs))
    }

    fn run(&mut self, tolerance: f64, repeats: u32) -> Option<Vec<f64>> {
        let start = self.start.clone();
        let mut last = None;
        let begin = Instant::now();
        for _ in 0..repeats {
            last = Some(self.once(black_box(&start), tolerance)?);
        }
        let seconds = begin.elapsed().as_secs_f64() / f64::from(repeats);
        let (solution, outputs) = last?;
        let counts = [solution.steps + solution.rejected, solution.evaluations].map(|n| n as f64);
        Some([[seconds].as_slice(), &counts, &self.rates(outputs)].concat())
    }

    /// One run from each of these starts, q and q̇ of each in turn, from its own constants to its own outputs.
    fn batch(&mut self, count: usize, tolerance: f64, path: &str) -> Option<Vec<f64>> {
        let starts = read_starts(path)?;
        let parameters = self.start.len() - 2 * N;
        let mut start = self.start.clone();
        let (mut steps, mut ends) = (0, Vec::with_capacity(count));
        let begin = Instant::now();
        for values in starts.get(..2 * N * count)?.chunks_exact(2 * N) {
            for (to, from) in start[parameters..].iter_mut().zip(values) {
                *to = DoubleDouble::from(*from);
            }
            let (solution, outputs) = self.once(black_box(&start), tolerance)?;
            steps += solution.steps + solution.rejected;
            ends.push(self.rates(outputs));
        }
        Some(of_batch(begin.elapsed().as_secs_f64(), steps, &ends))
    }

    /// q and q̇ where the outputs are q and u; otherwise the outputs.
    fn rates(&self, mut outputs: Vec<f64>) -> Vec<f64> {
        if outputs.len() == 2 * N {
            let (q, u) = outputs.split_at_mut(N);
            let mut q_dot = [0.0; N];
            System::<f64>::coordinate_rates(&kane::Kane, &self.question, q, u, &mut q_dot);
            u.copy_from_slice(&q_dot);
        }
        outputs
    }

    /// Answers one line; `None` if it is not understood.
    fn answer(&mut self, line: &str) -> Option<String> {
        // A path may have spaces, and comes last.
        let words: Vec<&str> = line.trim().splitn(4, ' ').collect();
        let answer = match words.as_slice() {
            ["start"] => self.question.clone(),
            ["prepare", _] => vec![0.0],
            ["run", tolerance, repeats] => self.run(tolerance.parse().ok()?, repeats.parse().ok()?)?,
            ["batch", count, tolerance, path] => self.batch(count.parse().ok()?, tolerance.parse().ok()?, path)?,
            _ => return None,
        };
        Some(numbers(&answer))
    }
}

/// Serves the equations of a generated module: these, with this key and these parameters.
fn answers<E: System<f64> + Copy>(equations: E, scene: &CompiledScene, names: &[&str], how: Integration) -> ExitCode {
    let worker = || {
        let (model, stated) = read(scene.name)?;
        let beginning = Beginning::new(&model, &stated, scene.key, names)?;
        let (parameters, state) = numbers_of::<DoubleDouble>(&stated)?;
        let rounded = numbers_of::<f64>(&stated)?;
        let rhs = Known { equations, parameters: Vec::new(), work: Vec::new() };
        let question = [rounded.0, rounded.1].concat();
        Ok::<_, String>(Worker { rhs, beginning, start: [parameters, state].concat(), question, how })
    };
    match worker() {
        Ok(mut worker) => serve(|line| worker.answer(line)),
        Err(error) => {
            eprintln!("{}: {error}", scene.name);
            ExitCode::from(2)
        }
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, how] = arguments.as_slice() else { return usage() };
    let Some(how) = Integration::named(how) else { return usage() };
    match scene.as_str() {
        "report-10s" => answers(report_10s::Reduced, &report_10s::SCENE, &report_10s::PARAMETERS, how),
        "lean" => answers(lean::Reduced, &lean::SCENE, &lean::PARAMETERS, how),
        _ => usage(),
    }
}

fn usage() -> ExitCode {
    eprintln!("usage: scene report-10s | lean METHOD, METHOD-energy or quadrature");
    ExitCode::from(2)
}
