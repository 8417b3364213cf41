//! Derivation of one formulation: a worker of `benches/peers/run.py`, which documents the lines it reads and answers.
//!
//! Called as `derivation FORMULATION FOLDER`. A problem is a folder in that one, with `model.toml` and `states`, whose
//! states may have more values at the end. Other lines: `read REPEATS` is the time to read and check the model file,
//! `formulate REPEATS` the time to read it and to derive, `code REPEATS` the time to derive all formulations from the
//! file and to emit their code. `together` counts M and f as one function. `start PROBLEM` answers the number of
//! parameters, then the parameters, q and q' at the start of `scene.toml`, with its loops closed.

use std::io::{BufRead, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use tripos_codegen::Extras;
use tripos_codegen::emit::emit_rust_module;
use tripos_codegen::plan::{FormulationPlan, Jacobian, Language, Planner, Sharing, derivative};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivation, SolvedAccelerations};
use tripos_derive::{Formulation, Model, derive, scene};

/// Request and result of the last `derive`.
struct Problem {
    model: Model,
    derivation: Derivation,
    parameters: Vec<f64>,
    state: Vec<f64>,
}

/// Seconds for each of so many calls, and the last answer.
fn timed<T>(repeats: u32, mut work: impl FnMut() -> Option<T>) -> Option<(f64, T)> {
    let (mut seconds, mut last) = (0.0, None);
    for _ in 0..repeats {
        let begin = Instant::now();
        let answer = work();
        seconds += begin.elapsed().as_secs_f64();
        last = Some(answer?);
    }
    Some((seconds / f64::from(repeats), last?))
}

/// Functions that compute the linear system of the accelerations.
#[derive(Clone, Copy, PartialEq, Eq)]
enum System {
    /// Matrix and forcing by one function each.
    Apart,
    /// Both by one function, if there is one.
    AtOnce,
}

impl Problem {
    fn new(folder: &Path, formulation: Formulation, repeats: u32) -> Option<(f64, Self)> {
        let model = Model::read(&folder.join("model.toml")).ok()?;
        let states = std::fs::read_to_string(folder.join("states")).ok()?;
        let mut lines = states.lines().map(numbers);
        let (parameters, state) = (lines.next()??, lines.next()??);
        let (seconds, derivation) = timed(repeats, || derive(&model, formulation).ok())?;
        Some((seconds, Self { model, derivation, parameters, state }))
    }

    /// Operations and functions of `mass_matrix` and of `forcing`, or of both at once if there is a function for that.
    /// A pair of sine and cosine is two functions, and counts in either.
    fn counts(&self, system: System) -> Option<Vec<f64>> {
        let Derivation { mut arena, equations } = derive(&self.model, self.derivation.equations.formulation).ok()?;
        // As they are emitted: with what grows as steps.
        let equations = equations.with_definitions(&mut arena);
        let planner = Planner::new(&self.model, &arena, &equations, &Language::NONE, Sharing::Shared);
        let plan = FormulationPlan::new(&planner, None, Jacobian::LeftOut, None);
        let shared =
            plan.machine.iter().filter(|function| system == System::AtOnce && function.name == "linear_system");
        let apart = plan.equations.iter().take(2);
        let functions = shared.chain(apart).collect::<Vec<_>>();
        let taken = if functions.len() > 2 { &functions[..1] } else { &functions[..] };
        let counts = taken.iter().map(|f| [f.cost.operations as f64, (2 * f.cost.sincos + f.cost.functions) as f64]);
        Some(counts.fold(vec![0.0, 0.0], |sum, count| vec![sum[0] + count[0], sum[1] + count[1]]))
    }

    /// The number of parameters, the parameters, and the coordinates with their rates at the start of the folder's
    /// scene.
    fn start(folder: &Path, formulation: Formulation) -> Option<Vec<f64>> {
        let mut model = Model::read(&folder.join("model.toml")).ok()?;
        let text = std::fs::read_to_string(folder.join("scene.toml")).ok()?;
        let scene = scene::load(&Source::from_text("scene.toml", &text), &mut model).ok()?;
        let Derivation { arena, equations: e } = derive(&model, formulation).ok()?;
        let inputs = [model.p(), e.coordinates.clone(), e.variables.clone()].concat();
        let rates = Tape::new(&arena, &inputs, &e.coordinate_rates).ok()?;
        let q_dot = rates.evaluate(&[scene.parameters.clone(), scene.q.clone(), scene.u].concat());
        Some([vec![scene.parameters.len() as f64], scene.parameters, scene.q, q_dot].concat())
    }

    /// Derives and solves for the accelerations: seconds of one, operations and functions.
    fn accelerations(folder: &Path, formulation: Formulation, repeats: u32) -> Option<(Vec<f64>, Self)> {
        let (_, problem) = Self::new(folder, formulation, 1)?;
        let (seconds, cost) = timed(repeats, || {
            let Derivation { mut arena, equations } = derive(&problem.model, formulation).ok()?;
            let equations = equations.with_definitions(&mut arena);
            let solved = SolvedAccelerations::new(&mut arena, &equations).ok()?;
            let planner = Planner::new(&problem.model, &arena, &equations, &Language::NONE, Sharing::Shared);
            // With the rates of the coordinates, which are the speeds.
            Some(derivative(&planner, &solved.accelerations.steps).cost)
        })?;
        Some((vec![seconds, cost.operations as f64, (2 * cost.sincos + cost.functions) as f64], problem))
    }

    /// q'' from M and f at the first state.
    fn solved(&self) -> Option<Vec<f64>> {
        let Derivation { arena, equations: e } = &self.derivation;
        let (p, n, speeds) = (&self.parameters, e.coordinates.len(), e.variables.len());
        let (q, q_dot) = (&self.state[..n], &self.state[n..2 * n]);
        let tape = |inputs: &[_], outputs: &[_]| Tape::new(arena, inputs, outputs).ok();
        let lagrange = e.formulation == Formulation::Lagrange;
        let own = [self.model.p(), e.coordinates.clone(), e.variables.clone()].concat();
        // The variables v from q', which is linear in v: the rates at v = 0 and at each unit of v. Where constraints
        // leave fewer speeds than coordinates, the normal equations have the solution.
        let rates = tape(&own, &e.coordinate_rates)?;
        let at = |v: &[f64]| rates.evaluate(&[p, q, v].concat());
        let zero = at(&vec![0.0; speeds]);
        let unit = |j: usize| (0..speeds).map(|i| f64::from(u8::from(i == j))).collect::<Vec<_>>();
        let columns: Vec<Vec<f64>> = (0..speeds).map(|j| at(&unit(j))).collect();
        let linear = |i: usize, j: usize| columns[j][i] - zero[i];
        let product = |j: usize, of: &dyn Fn(usize) -> f64| (0..n).map(|i| linear(i, j) * of(i)).sum::<f64>();
        let v = match (lagrange, speeds < n) {
            (true, _) => q_dot.to_vec(),
            (_, false) => gauss(n, linear, |i| q_dot[i] - zero[i]),
            (_, true) => gauss(speeds, |i, j| product(i, &|k| linear(k, j)), |i| product(i, &|k| q_dot[k] - zero[k])),
        };
        let size = e.forcing.len();
        let inputs = [p, q, &v].concat();
        let matrix = tape(&own, &e.matrix.concat())?.evaluate(&inputs);
        let forcing = tape(&own, &e.forcing)?.evaluate(&inputs);
        let v_dot = gauss(size, |i, j| matrix[i * size + j], |i| forcing[i])[..speeds].to_vec();
        if lagrange {
            return Some(v_dot);
        }
        // q'' = d(q')/dt by differences of fourth order along q + t q', v + t v'; the check asks for no more.
        let h = 2e-3 / q_dot.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        let ahead = |t: f64| {
            let moved = |x: &[f64], rate: &[f64]| x.iter().zip(rate).map(|(x, r)| x + t * r).collect::<Vec<_>>();
            rates.evaluate(&[p.clone(), moved(q, q_dot), moved(&v, &v_dot)].concat())
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| ahead(k * h));
        Some((0..n).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h)).collect())
    }
}

/// The solution of a linear system by elimination with row pivots.
fn gauss(n: usize, entry: impl Fn(usize, usize) -> f64, right: impl Fn(usize) -> f64) -> Vec<f64> {
    let row = |i: usize| (0..n).map(|j| entry(i, j)).chain([right(i)]).collect::<Vec<_>>();
    let mut rows: Vec<Vec<f64>> = (0..n).map(row).collect();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap_or(k);
        rows.swap(k, pivot);
        let top = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / top[k];
            row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| rows[i][j] * x[j]).sum();
        x[i] = (rows[i][n] - known) / rows[i][i];
    }
    x
}

fn numbers(line: &str) -> Option<Vec<f64>> {
    line.split_whitespace().map(|word| word.parse().ok()).collect()
}

/// Answers one line; `None` if it is not understood or cannot be done.
fn answer(
    formulation: Formulation,
    folder: &Path,
    last: &mut Option<(PathBuf, Problem)>,
    line: &str,
) -> Option<String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let answer = match (words.as_slice(), &last) {
        (["derive", name, repeats], _) => {
            let path = folder.join(name);
            let (seconds, problem) = Problem::new(&path, formulation, repeats.parse().ok()?)?;
            *last = Some((path, problem));
            vec![seconds]
        }
        (["accelerations", name, repeats], _) => {
            let path = folder.join(name);
            let (answer, problem) = Problem::accelerations(&path, formulation, repeats.parse().ok()?)?;
            *last = Some((path, problem));
            answer
        }
        (["read", repeats], Some((path, _))) => {
            vec![timed(repeats.parse().ok()?, || Model::read(&path.join("model.toml")).ok())?.0]
        }
        (["formulate", repeats], Some((path, _))) => {
            let model = || Model::read(&path.join("model.toml")).ok();
            vec![timed(repeats.parse().ok()?, || derive(&model()?, formulation).ok())?.0]
        }
        (["start", name], _) => Problem::start(&folder.join(name), formulation)?,
        (["code", repeats], Some((path, _))) => {
            vec![
                timed(repeats.parse().ok()?, || {
                    emit_rust_module(&path.join("model.toml"), "module", &[], Extras::ALL).ok()
                })?
                .0,
            ]
        }
        (["count"], Some((_, problem))) => problem.counts(System::Apart)?,
        (["together"], Some((_, problem))) => problem.counts(System::AtOnce)?,
        (["solve"], Some((_, problem))) => problem.solved()?,
        _ => return None,
    };
    Some(answer.iter().map(f64::to_string).collect::<Vec<_>>().join(" "))
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, folder] = arguments.as_slice() else {
        eprintln!("usage: derivation FORMULATION FOLDER");
        return ExitCode::from(2);
    };
    let Some(formulation) = Formulation::ALL.into_iter().find(|f| f.name() == name) else {
        eprintln!("there is no formulation `{name}`");
        return ExitCode::from(2);
    };
    let mut last = None;
    for line in std::io::stdin().lock().lines() {
        let answered = line.ok().and_then(|line| answer(formulation, Path::new(folder), &mut last, &line));
        let Some(answered) = answered else { return ExitCode::from(2) };
        let mut out = std::io::stdout().lock();
        if writeln!(out, "{answered}").and_then(|()| out.flush()).is_err() {
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
