//! Shared code of the workers for the disk: the question, equations that are known when a worker is compiled, and the
//! lines that `benches/peers/run.py` documents.
//!
//! Invariant: the numbers of the question are those of a scene's file, as it writes them.

use std::io::{BufRead, Write};
use std::path::Path;
use std::process::ExitCode;

use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{self, InitialMotion, Scene};
use tripos_sim::{Failure, Method, Options, OutputOption, RightHandSide};
use tripos_traits::{DoubleDouble, Real, System};

/// Coordinates; as many rates follow them in a state.
pub const N: usize = tripos_models::disk::COORDINATES.len();
/// End of the run, in s.
pub const SPAN: f64 = 10.0;

/// A scene of the disk with its model, from the files of this workspace.
///
/// # Errors
/// What is wrong, in words, if they cannot be read, or the scene runs to another instant than the workers do.
pub fn read(name: &str) -> Result<(Model, Scene), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/disk");
    let scene = Source::read(&folder.join(format!("scenes/{name}.toml"))).map_err(|error| error.to_string())?;
    let mut model = Model::read(&folder.join("model.toml")).map_err(|error| error.to_string())?;
    let scene = scene::load(&scene, &mut model).map_err(|error| error.to_string())?;
    if scene.span.0.abs() > 0.0 || (scene.span.1 - SPAN).abs() > 0.0 {
        return Err(format!("{name} no longer runs from 0 to {SPAN} s, as the workers do"));
    }
    Ok((model, scene))
}

/// The parameters of a scene, and its start as q and q̇, rounded once to `S`.
///
/// # Errors
/// What is wrong, in words, if the scene states generalized speeds.
pub fn numbers_of<S: Real>(scene: &Scene) -> Result<(Vec<S>, Vec<S>), String> {
    let InitialMotion::Rates(rates) = &scene.exact.motion else { return Err("a scene here states q̇".to_owned()) };
    let list = |numbers: &[DoubleDouble]| numbers.iter().map(narrow).collect::<Vec<S>>();
    Ok((list(&scene.exact.parameters), [list(&scene.exact.q), list(rates)].concat()))
}

fn narrow<S: Real>(x: &DoubleDouble) -> S {
    S::from_f64(x.hi()) + S::from_f64(x.lo())
}

/// Runs of a batch whose ends are answered, evenly spaced.
const SAMPLE: usize = 16;

/// Starts of runs in a file, as doubles one after the other: q and q̇ of each in turn.
pub fn read_starts(path: &str) -> Option<Vec<f64>> {
    let bytes = std::fs::read(path).ok()?;
    Some(bytes.chunks_exact(8).map(|eight| f64::from_ne_bytes(eight.try_into().expect("eight bytes"))).collect())
}

/// The answer to `batch`: seconds and steps, then the ends of a sample.
pub fn of_batch(seconds: f64, steps: u64, ends: &[Vec<f64>]) -> Vec<f64> {
    let sample = (0..SAMPLE).flat_map(|k| ends[k * ends.len() / SAMPLE].iter().copied());
    [seconds, steps as f64].into_iter().chain(sample).collect()
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
        let n = self.equations.lengths().coordinates;
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
    Options { method, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) }
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
