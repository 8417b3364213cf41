//! The disk by generated code and this project's methods: a worker of `benches/peers/run.py`, which documents the lines
//! it reads and answers.
//!
//! `peer EQUATIONS METHOD` integrates by one of [`METHODS`], which `peer methods` lists. `lagrange` and `kane` know
//! their equations when they are compiled; `eliminated-lagrange` and `eliminated-kane` go through [`Eliminated`] and a
//! virtual call, as a program does that learns at run time which model to run. `lagrange lanes-dop853` and `lagrange
//! lanes-taylor` run batches in lanes. States are put and answered as q and q̇.

mod disk;

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use disk::{Known, N, SPAN, numbers, numbers_of, of_batch, options, read, read_starts, serve};
use tripos_models::disk::{kane, lagrange};
use tripos_sim::batch::{self, BatchPlan, Trajectory};
use tripos_sim::{EliminatedDynamics, LentRightHandSide, Method, Options, RightHandSide, Solution, Stop, integrate};
use tripos_traits::{Derivative, DoubleDouble, InLanes, Real, System};

/// The methods that runs can be made by, in the order of the rows of the results.
const METHODS: &[Method] = &[Method::Dop853, Method::Taylor];
/// The scene that all are asked for.
const SCENE: &str = "report-10s";
/// Prefix of a method's name that asks for batches in lanes.
const LANES: &str = "lanes-";

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

/// The parameters and the start of the scene.
fn question<S: Real>() -> Result<(Vec<S>, Vec<S>), String> {
    numbers_of(&read(SCENE)?.1)
}

/// From the start to the end of the span at rtol = atol = `tolerance`.
fn run<S: Real, R: RightHandSide<S>>(rhs: &mut R, y0: &[S], method: Method, tolerance: f64) -> Solution<S> {
    integrate(LentRightHandSide(rhs), (0.0, SPAN), y0, &options(method, tolerance), &mut [])
        .expect("the question makes sense")
}

/// One run from each of these starts, q and q̇ in turn: the steps tried in all, and the ends.
fn one_by_one<R: RightHandSide>(worker: &mut Worker<'_, R>, starts: &[f64], tolerance: f64) -> (u64, Vec<Vec<f64>>) {
    let mut steps = 0;
    let ends = starts.chunks_exact(2 * N).map(|start| {
        let solution = run(&mut worker.rhs, &worker.equations.state(start), worker.method, tolerance);
        steps += solution.steps + solution.rejected;
        worker.equations.rates(&solution.y_end)
    });
    let ends = ends.collect();
    (steps, ends)
}

/// The same in lanes, by Lagrange's equations.
fn side_by_side(
    equations: &Equations<'_, f64>,
    method: Method,
    starts: &[f64],
    tolerance: f64,
) -> (u64, Vec<Vec<f64>>) {
    let starts: Vec<Vec<f64>> = starts.chunks_exact(2 * N).map(|start| equations.state(start)).collect();
    let parameters = &equations.parameters;
    let trajectories: Vec<Trajectory<'_>> = starts.iter().map(|start| Trajectory { parameters, start }).collect();
    let step_limit = Options::default().step_limit;
    let (rtol, atol) = (tolerance, tolerance.into());
    let plan = BatchPlan { method, order: None, span: (0.0, SPAN), rtol, atol, max_step: None, step_limit };
    let in_lanes = InLanes::of(&Derivative(lagrange::Lagrange)).with_series(&Derivative(lagrange::Lagrange));
    let outcomes = batch::integrate_batch(in_lanes, &plan, &trajectories).expect("the question makes sense");
    let steps = outcomes.iter().map(|outcome| outcome.steps + outcome.rejected).sum();
    (steps, outcomes.iter().map(|outcome| equations.rates(&outcome.y_end)).collect())
}

/// The end state computed with 32 digits from the start as it is written, not as an `f64` rounds it; or from the k-th
/// of a file of starts.
fn reference(method: Method, tolerance: f64, of_file: Option<(usize, &str)>) -> Option<Vec<f64>> {
    let (parameters, mut start) = question::<DoubleDouble>().ok()?;
    if let Some((k, path)) = of_file {
        let starts = read_starts(path)?;
        start = starts.get(2 * N * k..2 * N * (k + 1))?.iter().map(|x| DoubleDouble::from(*x)).collect();
    }
    let equations = Equations { system: &lagrange::Lagrange, parameters };
    let mut rhs = EliminatedDynamics::new(equations.system, &equations.parameters)?;
    let solution = run(&mut rhs, &equations.state(&start), method, tolerance);
    let end = equations.rates(&solution.y_end).iter().map(|y| y.to_f64()).collect();
    (solution.stop == Stop::End).then_some(end)
}

/// State of the worker that answers lines.
struct Worker<'a, R> {
    rhs: R,
    equations: Equations<'a, f64>,
    method: Method,
    /// True if batches are run in lanes.
    lanes: bool,
}

impl<R: RightHandSide> Worker<'_, R> {
    fn run(&mut self, tolerance: f64, repeats: u32) -> Option<Vec<f64>> {
        let y0 = self.equations.state(&question::<f64>().ok()?.1);
        let mut solution = None;
        let begin = Instant::now();
        for _ in 0..repeats {
            solution = Some(run(&mut self.rhs, black_box(&y0), self.method, tolerance));
        }
        let seconds = begin.elapsed().as_secs_f64() / f64::from(repeats);
        let solution = solution?;
        let counts = [solution.steps + solution.rejected, solution.evaluations].map(|n| n as f64);
        Some([[seconds].as_slice(), &counts, &self.equations.rates(&solution.y_end)].concat())
    }

    fn batch(&mut self, count: usize, tolerance: f64, path: &str) -> Option<Vec<f64>> {
        let starts = read_starts(path)?;
        let starts = starts.get(..2 * N * count)?;
        let begin = Instant::now();
        let (steps, ends) = if self.lanes {
            side_by_side(&self.equations, self.method, starts, tolerance)
        } else {
            one_by_one(self, starts, tolerance)
        };
        Some(of_batch(begin.elapsed().as_secs_f64(), steps, &ends))
    }

    /// Answers one line; `None` if it is not understood.
    fn answer(&mut self, line: &str) -> Option<String> {
        // A path may have spaces, and comes last.
        let words: Vec<&str> = line.trim().splitn(4, ' ').collect();
        let answer = match words.as_slice() {
            ["start"] => {
                let (parameters, start) = question::<f64>().ok()?;
                [parameters, start].concat()
            }
            ["prepare", _] => vec![0.0],
            ["run", tolerance, repeats] => self.run(tolerance.parse().ok()?, repeats.parse().ok()?)?,
            ["batch", count, tolerance, path] => self.batch(count.parse().ok()?, tolerance.parse().ok()?, path)?,
            ["reference", tolerance] => reference(self.method, tolerance.parse().ok()?, None)?,
            ["reference", tolerance, k, path] => {
                reference(self.method, tolerance.parse().ok()?, Some((k.parse().ok()?, path)))?
            }
            _ => return None,
        };
        Some(numbers(&answer))
    }
}

fn answers<R: RightHandSide>(mut worker: Worker<'_, R>) -> ExitCode {
    serve(|line| worker.answer(line))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (which, method) = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["methods"] => {
            for method in METHODS {
                println!("{}", method.name());
            }
            return ExitCode::SUCCESS;
        }
        [which, name] => {
            let name = name.strip_prefix(LANES).unwrap_or(name);
            (which.to_string(), METHODS.iter().find(|method| method.name() == name))
        }
        _ => (String::new(), None),
    };
    let lanes = arguments.get(1).is_some_and(|word| word.starts_with(LANES));
    let values = match question::<f64>() {
        Ok((values, _)) => values,
        Err(error) => {
            eprintln!("{SCENE}: {error}");
            return ExitCode::from(2);
        }
    };
    let work = Vec::new();
    let system: &dyn System<f64> = if which.ends_with("kane") { &kane::Kane } else { &lagrange::Lagrange };
    let parameters = black_box(values.clone());
    let equations = Equations { system, parameters: values.clone() };
    match (which.as_str(), method.copied()) {
        ("lagrange", Some(method)) => {
            let rhs = Known { equations: lagrange::Lagrange, parameters, work };
            answers(Worker { rhs, equations, method, lanes })
        }
        ("kane", Some(method)) => {
            let rhs = Known { equations: kane::Kane, parameters, work };
            answers(Worker { rhs, equations, method, lanes: false })
        }
        ("eliminated-lagrange" | "eliminated-kane", Some(method)) => {
            let rhs = EliminatedDynamics::new(system, &values).expect("these equations were solved for");
            answers(Worker { rhs, equations, method, lanes: false })
        }
        _ => {
            eprintln!(
                "usage: peer lagrange | kane | eliminated-lagrange | eliminated-kane METHOD, peer lagrange lanes-METHOD, or peer methods"
            );
            ExitCode::from(2)
        }
    }
}
