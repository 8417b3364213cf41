//! Speed charted against accuracy: every formulation, solve and method at many tolerances, measured against a reference.

pub mod figure;
pub mod files;
pub mod session;
pub mod words;

use crate::catalogue::{By, Code, code};
use crate::failure::Failure;
use crate::invariants::Watch;
use crate::problem::Problem;
use crate::reference::Reference;
use crate::run::refused;
use indicatif::ProgressBar;
use tripos_derive::Model;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::work_precision::{Spread, error, interleaved, options};
use tripos_sim::{Method, Options, Output};

/// How much is measured.
pub struct Plan {
    /// The tolerances, loosest first.
    pub tolerances: Vec<f64>,
    /// Runs of each kind.
    pub repeats: usize,
    /// Steps after which a run is given up.
    pub step_limit: u64,
    /// Whether tolerances finer than one that used up the steps are left out.
    pub quick: bool,
    /// A run that takes longer than this, s, is not repeated.
    pub patience: f64,
}

impl Plan {
    /// Everything, or what takes less than two minutes.
    pub fn new(quick: bool) -> Self {
        let powers: Vec<i32> = if quick { vec![3, 5, 7, 9, 11, 13] } else { (2..=14).collect() };
        Self {
            tolerances: powers.into_iter().map(|n| 10_f64.powi(-n)).collect(),
            repeats: if quick { 3 } else { 7 },
            step_limit: if quick { 100_000 } else { 1_000_000 },
            quick,
            patience: if quick { 0.1 } else { 1.0 },
        }
    }
}

/// Equations and how their accelerations are found.
pub struct Case {
    /// Which equations.
    pub by: By,
    /// Ready to run, in the scene's distance if it has one.
    pub code: Code,
    /// How accelerations are found.
    pub solve: Solve,
}

impl Case {
    /// Whether a method can run it: without a Jacobian there is no implicit method, and Taylor coefficients are known of
    /// eliminated accelerations only.
    pub fn has(&self, method: Method) -> bool {
        let system = self.code.system();
        let series = self.solve == Solve::Eliminated && system.has_taylor();
        (!method.needs_jacobian() || system.has_accelerations()) && (!method.needs_series() || series)
    }
}

/// One point of a chart.
pub struct Measurement {
    /// The name of the equations.
    pub formulation: String,
    /// How accelerations were found.
    pub solve: Solve,
    /// The method.
    pub method: Method,
    /// The tolerance.
    pub tolerance: f64,
    /// Times of repeated runs.
    pub seconds: Spread,
    /// Against the reference; none if the run did not arrive.
    pub error: Option<f64>,
    /// Accepted steps.
    pub steps: u64,
    /// Calls of the right-hand side.
    pub evaluations: u64,
    /// Why the run ended.
    pub stop: String,
    /// The largest change of each first integral.
    pub drifts: Vec<f64>,
}

/// Every formulation that the model has with each way to find its accelerations; printed equations, if wanted, as they
/// stand.
///
/// # Errors
/// [`Failure`] if nothing can be run.
pub fn cases(model: &Model, scene: &Scene, printed: bool) -> Result<Vec<Case>, Failure> {
    let mut list = Vec::new();
    let mut why = None;
    let mut names: Vec<By> = tripos_derive::Formulation::ALL.map(By::from).to_vec();
    if printed {
        names.extend(crate::catalogue::printed(model)?);
    }
    for by in names {
        for solve in Solve::ALL {
            match code(model, &by, scene.integration.distance) {
                Ok(code) if solve == Solve::Numeric || code.system().has_accelerations() => {
                    list.push(Case { by: by.clone(), code, solve });
                }
                Ok(_) => {}
                Err(failure) => why = Some(failure),
            }
        }
    }
    match why {
        Some(failure) if list.is_empty() => Err(failure),
        _ => Ok(list),
    }
}

/// The methods that have a place in a chart.
fn methods(case: &Case) -> impl Iterator<Item = Method> {
    Method::ALL.into_iter().filter(|method| case.has(*method))
}

/// Measures everything against the reference, which is at the end of the scene's span.
///
/// # Errors
/// [`Failure`] if the scene cannot be run at all.
pub fn measure(
    model: &Model,
    scene: &Scene,
    cases: &[Case],
    plan: &Plan,
    watch: &Watch,
    reference: &Reference,
    bar: &ProgressBar,
) -> Result<Vec<Measurement>, Failure> {
    let problems: Vec<Problem<'_>> = cases
        .iter()
        .map(|case| Problem::new(model, scene, &case.by, &case.code, Some(case.solve)))
        .collect::<Result<_, _>>()?;
    let starts: Vec<Vec<f64>> = problems.iter().map(Problem::start).collect::<Result<_, _>>()?;
    let length = scene.span.1 - scene.span.0;
    let per_case: usize = cases.iter().map(|case| methods(case).count()).sum();
    bar.set_length((per_case * plan.tolerances.len() * (1 + plan.repeats)) as u64);
    let mut list = Vec::new();
    let mut again: Vec<(usize, usize, Options)> = Vec::new();
    for (at, (problem, y0)) in problems.iter().zip(&starts).enumerate() {
        for method in methods(&cases[at]) {
            for &tolerance in &plan.tolerances {
                bar.set_message(format!("{} {} {}", problem.by.name, problem.solve.name(), method.name()));
                let how = options(method, tolerance, length, plan.step_limit);
                let measurement = first(problem, y0, &how, tolerance, watch, reference)?;
                if measurement.seconds.median <= plan.patience {
                    again.push((at, list.len(), how));
                } else {
                    bar.inc(plan.repeats as u64);
                }
                // Finer ones would use up the steps too.
                let exhausted = plan.quick && measurement.stop == "step-limit";
                list.push(measurement);
                bar.inc(1);
                if exhausted {
                    break;
                }
            }
        }
    }
    bar.set_message("timing, all in turn");
    let mut jobs: Vec<Box<dyn FnMut() + '_>> = again
        .iter()
        .map(|(at, _, how)| -> Box<dyn FnMut() + '_> {
            let (problem, y0) = (&problems[*at], &starts[*at]);
            Box::new(move || drop(problem.integrate(y0, how, &mut [])))
        })
        .collect();
    let times = interleaved(&mut jobs, plan.repeats, || bar.inc(1));
    drop(jobs);
    for ((_, place, _), times) in again.iter().zip(times) {
        list[*place].seconds = Spread::of(&times).unwrap_or(list[*place].seconds);
    }
    Ok(list)
}

/// Steps of a run up to which its first integrals are watched at each.
const MOST_WATCHED: u64 = 200_000;

/// The first run of a kind: its error and drifts, and a first time.
fn first(
    problem: &Problem<'_>,
    y0: &[f64],
    how: &Options,
    tolerance: f64,
    watch: &Watch,
    reference: &Reference,
) -> Result<Measurement, Failure> {
    let start = std::time::Instant::now();
    let bare = problem.integrate(y0, how, &mut []).map_err(|error| refused(problem.scene, &error))?;
    let seconds = start.elapsed().as_secs_f64();
    let watched = Options { output: Output::Steps { refine: 1 }, ..how.clone() };
    let again = (bare.steps <= MOST_WATCHED).then(|| problem.integrate(y0, &watched, &mut []));
    let drifts = again.and_then(Result::ok).map_or_else(Vec::new, |solution| watch.changes(problem, &solution));
    let arrived = bare.stop.code() == "end";
    Ok(Measurement {
        formulation: problem.by.name.clone(),
        solve: problem.solve,
        method: how.method,
        tolerance,
        seconds: Spread { least: seconds, median: seconds, most: seconds, runs: 1 },
        error: arrived.then(|| error(&problem.precise_state(bare.t_end, &bare.y_end), reference.end()).max(reference.uncertainty)),
        steps: bare.steps,
        evaluations: bare.evaluations,
        stop: bare.stop.code(),
        drifts,
    })
}
