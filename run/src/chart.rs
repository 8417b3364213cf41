//! Speed charted against accuracy: every formulation, solve and method at many tolerances, measured against a
//! reference.

pub mod session;

use crate::case::{Case, Prepared, Way};
use crate::compared::Compared;
use crate::error::Error;
use crate::follow::Progress;
use crate::invariants::Watch;
use crate::mechanism::Mechanism;
use crate::problem::Problem;
use crate::reference::Reference;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::work_precision::{Spread, error, interleaved};
use tripos_sim::{Options, Output, Stop};
use tripos_traits::larger;

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
    #[must_use]
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

/// One point of a chart.
pub struct Measurement {
    /// Which equations.
    pub by: By,
    /// How accelerations were found, where they were asked for.
    pub solve: Solve,
    /// By what it was run.
    pub way: Way,
    /// Times of repeated runs.
    pub seconds: Spread,
    /// Against the reference; none if the run did not arrive.
    pub error: Option<f64>,
    /// Accepted steps.
    pub steps: u64,
    /// Calls of the right-hand side.
    pub evaluations: u64,
    /// Why the run ended.
    pub stop: Stop,
    /// The largest change of each first integral.
    pub drifts: Vec<f64>,
}

/// What runs are held against.
pub struct Truth<'a> {
    /// What errors are differences from.
    pub reference: &'a Reference,
    /// In what runs are compared.
    pub compared: &'a Compared,
    /// What is conserved.
    pub watch: &'a Watch,
}

/// Measures everything against the reference, which is at the end of the scene's span; if it is interrupted, what
/// came before. What cannot be measured is added to what is left out, with the reason.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn measure(
    model: &Mechanism,
    scene: &Scene,
    cases: &[Case],
    plan: &Plan,
    truth: &Truth<'_>,
    (bar, left_out): (&dyn Progress, &mut Vec<String>),
) -> Result<Vec<Measurement>, Error> {
    let prepared = cases.iter().map(|case| case.prepare(model, scene)).collect::<Result<Vec<_>, _>>()?;
    let problems: Vec<Problem<'_>> = prepared.iter().map(Prepared::problem).collect::<Result<_, _>>()?;
    let starts: Vec<Vec<f64>> = problems.iter().map(Problem::start).collect::<Result<_, _>>()?;
    let length = scene.span.1 - scene.span.0;
    let ways: Vec<Vec<Way>> = cases.iter().map(|case| case.ways(&plan.tolerances)).collect();
    bar.set_length((ways.iter().map(Vec::len).sum::<usize>() * (1 + plan.repeats)) as u64);
    let mut list: Vec<Measurement> = Vec::new();
    let mut again: Vec<(usize, usize, Way, Options)> = Vec::new();
    for (at, (problem, y0)) in problems.iter().zip(&starts).enumerate() {
        let mut exhausted = None;
        for way in &ways[at] {
            // Finer ones would use up the steps too.
            if exhausted == Some(way.name()) {
                continue;
            }
            bar.set_message(&format!("{} {} {}", problem.by.name(), way.solve(problem.solve), way.name()));
            let how = way.options(length, plan.step_limit);
            bar.inc(1);
            let outcome = first(problem, y0, *way, &how, truth);
            if model.follow.asked() {
                // What was under way is not measured.
                return Ok(list);
            }
            let measurement = match outcome {
                Ok(measurement) => measurement,
                // A motion that quadrature does not give is still integrated.
                Err(failure) if *way == Way::Quadrature => {
                    left_out.push(format!("{} by {}: {}", problem.by.name(), way.name(), failure.first_line()));
                    continue;
                }
                Err(failure) => return Err(failure),
            };
            if measurement.seconds.median <= plan.patience {
                again.push((at, list.len(), *way, how));
            } else {
                bar.inc(plan.repeats as u64);
            }
            exhausted = (plan.quick && matches!(measurement.stop, Stop::StepLimit { .. })).then(|| way.name());
            list.push(measurement);
        }
    }
    bar.set_message("timing, all in turn");
    let mut jobs: Vec<Box<dyn FnMut() + '_>> = again
        .iter()
        .map(|(at, _, way, how)| -> Box<dyn FnMut() + '_> {
            let (problem, y0) = (&problems[*at], &starts[*at]);
            Box::new(move || drop(way.run(problem, problem.scene.span, y0, how)))
        })
        .collect();
    let times = interleaved(&mut jobs, plan.repeats, || {
        bar.inc(1);
        model.follow.go_on()
    });
    drop(jobs);
    for ((_, place, ..), times) in again.iter().zip(times) {
        list[*place].seconds = Spread::of(&times).unwrap_or(list[*place].seconds);
    }
    Ok(list)
}

/// Steps of a run up to which its first integrals are watched at each.
const MOST_WATCHED: u64 = 200_000;

/// The first run of a kind: its error and drifts, and a first time.
fn first(problem: &Problem<'_>, y0: &[f64], way: Way, how: &Options, truth: &Truth<'_>) -> Result<Measurement, Error> {
    let Truth { reference, compared, watch } = truth;
    let start = std::time::Instant::now();
    let bare = way.run(problem, problem.scene.span, y0, how)?;
    let seconds = start.elapsed().as_secs_f64();
    let watched = Options { output: Output::Steps { refine: 1 }, ..how.clone() };
    // First integrals are functions of all states, which a scene may not show.
    let shows_all = !(problem.by.is_reduced() && problem.shown.states_outputs);
    let is_watched = shows_all && bare.steps <= MOST_WATCHED;
    let again = is_watched.then(|| way.run(problem, problem.scene.span, y0, &watched));
    let drifts = again.transpose()?.map_or_else(Vec::new, |solution| watch.changes(problem, &solution));
    let arrived = bare.stop == Stop::End;
    let off = || {
        let right = compared.kept(compared.of_state(reference.end()));
        larger(error(&compared.of_run(problem, bare.t_end, &bare.y_end), &right), reference.uncertainty)
    };
    Ok(Measurement {
        by: problem.by.clone(),
        solve: problem.solve,
        way,
        seconds: Spread { least: seconds, median: seconds, most: seconds, runs: 1 },
        error: arrived.then(off),
        steps: bare.steps,
        evaluations: bare.evaluations,
        stop: bare.stop,
        drifts,
    })
}
