//! Work-precision charts, which show the duration of runs against their error. Every formulation and
//! integrator is measured at many tolerances. A reference in higher precision gives the errors.

pub mod scene_chart;

use super::chart_case::{ChartCase, PreparedCase};
use super::method_at_tolerance::MethodAtTolerance;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::observer::Progress;
use crate::preparation::problem::Problem;
use crate::trust::compared_quantities::ComparedQuantities;
use crate::trust::reference_solution::ReferenceSolution;
use crate::trust::watched_invariants::WatchedInvariants;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::work_precision::{TimeStatistics, timed_in_turn, work_precision_error};
use tripos_sim::{Options, OutputOption, Stop};
use tripos_traits::larger;

/// Extent of the measurements of a work-precision chart.
pub struct ChartPlan {
    /// Tolerances of the runs, relative and absolute, without unit. The largest comes first.
    pub tolerances: Vec<f64>,
    /// Number of timed runs of each measured point, in addition to the first run.
    pub repeats: usize,
    /// Number of steps after which a run is stopped.
    pub step_limit: u64,
    /// True if an integrator is not run at finer tolerances after a run has used up the step limit.
    pub quick: bool,
    /// Duration of a run, s, above which the run is not repeated.
    pub patience: f64,
}

impl ChartPlan {
    /// Makes the plan of a full chart: tolerances 1e-2 to 1e-14, seven repeats, and up to a million
    /// steps.
    #[must_use]
    pub fn full() -> Self {
        Self { tolerances: chart_tolerances(2..=14), repeats: 7, step_limit: 1_000_000, quick: false, patience: 1.0 }
    }

    /// Makes the plan of a quick chart, which takes less than two minutes: every second tolerance, and three
    /// repeats.
    #[must_use]
    pub fn quick() -> Self {
        let tolerances = chart_tolerances((3..=13).step_by(2));
        Self { tolerances, repeats: 3, step_limit: 100_000, quick: true, patience: 0.1 }
    }
}

/// Makes the tolerances 10⁻ⁿ for the given powers n.
fn chart_tolerances(powers: impl Iterator<Item = i32>) -> Vec<f64> {
    powers.map(|n| 10_f64.powi(-n)).collect()
}

/// Measured point of a work-precision chart: one case, run by one integrator at one tolerance.
pub struct Measurement {
    /// Origin of the equations of motion that ran: a formulation, a publication or the scene's
    /// reduction.
    pub by: EquationsOrigin,
    /// Method that found the accelerations; without meaning for quadrature.
    pub solve: AccelerationSolution,
    /// Integrator and tolerance of the run.
    pub way: MethodAtTolerance,
    /// Statistics of the durations of the repeated runs, s.
    pub seconds: TimeStatistics,
    /// Largest error of a compared quantity at the end, |found − reference| / (1 + |reference|). It is at
    /// least the uncertainty of the reference. `None` if the run did not reach the end.
    pub error: Option<f64>,
    /// Number of accepted steps in the run.
    pub steps: u64,
    /// Number of evaluations of the right-hand side in the run.
    pub evaluations: u64,
    /// Reason why the run ended, such as the end of the span or a failure.
    pub stop: Stop,
    /// Largest change of each first integral over the run, in its unit; empty if the first integrals
    /// were not computed.
    pub drifts: Vec<f64>,
}

/// Standard by which the runs of a chart are judged: reference solution, compared quantities and first
/// integrals.
pub struct ChartReference<'a> {
    /// Reference solution, which gives the errors of the runs.
    pub reference: &'a ReferenceSolution,
    /// Quantities in which runs are compared with the reference: outputs of the scene, or all states.
    pub compared: &'a ComparedQuantities,
    /// First integrals of the motion, whose changes over a run are measured.
    pub watch: &'a WatchedInvariants,
}

/// Measured points of a work-precision chart, and the cases that could not be measured.
#[derive(Default)]
pub struct ChartMeasurements {
    /// Measured points in the order of the cases. The points of one case are in the order of integrators
    /// and tolerances.
    pub list: Vec<Measurement>,
    /// Cases that could not be measured: a sentence for each, with the reason.
    pub left_out: Vec<String>,
}

/// Measures all cases over the scene's span: duration, error at the end, and drift of first integrals. If
/// the observer interrupts it, returns the measurements up to then.
///
/// # Errors
/// [`Error`] if a case cannot be prepared or run, except by quadrature.
pub fn measure_cases(
    model: &Mechanism,
    scene: &Scene,
    cases: &[ChartCase],
    plan: &ChartPlan,
    truth: &ChartReference<'_>,
    bar: &dyn Progress,
) -> Result<ChartMeasurements, Error> {
    let prepared = cases.iter().map(|case| case.prepare(model, scene)).collect::<Result<Vec<_>, _>>()?;
    let problems: Vec<Problem<'_>> = prepared.iter().map(PreparedCase::problem).collect::<Result<_, _>>()?;
    let starts: Vec<Vec<f64>> = problems.iter().map(Problem::start).collect::<Result<_, _>>()?;
    let length = scene.span.1 - scene.span.0;
    let ways: Vec<Vec<MethodAtTolerance>> =
        cases.iter().map(|case| case.integrators_and_tolerances(&plan.tolerances)).collect();
    bar.set_length((ways.iter().map(Vec::len).sum::<usize>() * (1 + plan.repeats)) as u64);
    let ChartMeasurements { mut list, mut left_out } = ChartMeasurements::default();
    let mut repeats: Vec<RepeatedRun> = Vec::new();
    for (at, (problem, y0)) in problems.iter().zip(&starts).enumerate() {
        let mut exhausted = None;
        for way in &ways[at] {
            // Finer tolerances would use up the step limit too.
            if exhausted == Some(way.name()) {
                continue;
            }
            bar.set_message(&format!("{} {} {}", problem.by.name(), way.solve(problem.solve), way.name()));
            let how = way.options(length, plan.step_limit);
            bar.add_finished_parts(1);
            let outcome = first_measurement(problem, y0, *way, &how, truth);
            if model.follow.is_interrupted() {
                // The interrupted run is not measured.
                return Ok(ChartMeasurements { list, left_out });
            }
            let measurement = match outcome {
                Ok(measurement) => measurement,
                // If quadrature fails, steps still integrate the motion.
                Err(failure) if *way == MethodAtTolerance::Quadrature => {
                    left_out.push(format!("{} by {}: {}", problem.by.name(), way.name(), failure.first_line()));
                    continue;
                }
                Err(failure) => return Err(failure),
            };
            if measurement.seconds.median <= plan.patience {
                repeats.push(RepeatedRun { case: at, measurement: list.len(), way: *way, how });
            } else {
                bar.add_finished_parts(plan.repeats as u64);
            }
            exhausted = (plan.quick && matches!(measurement.stop, Stop::StepLimit { .. })).then(|| way.name());
            list.push(measurement);
        }
    }
    bar.set_message("timing, all in turn");
    let mut jobs: Vec<Box<dyn FnMut() + '_>> = repeats
        .iter()
        .map(|RepeatedRun { case, way, how, .. }| -> Box<dyn FnMut() + '_> {
            let (problem, y0) = (&problems[*case], &starts[*case]);
            Box::new(move || drop(way.run(problem, problem.scene.span, y0, how)))
        })
        .collect();
    let times = timed_in_turn(&mut jobs, plan.repeats, || {
        bar.add_finished_parts(1);
        model.follow.continue_or_break()
    });
    drop(jobs);
    for (repeat, times) in repeats.iter().zip(times) {
        let seconds = &mut list[repeat.measurement].seconds;
        *seconds = TimeStatistics::of_times(&times).unwrap_or(*seconds);
    }
    Ok(ChartMeasurements { list, left_out })
}

/// Run of a case that is repeated to measure its duration more accurately.
struct RepeatedRun {
    /// Index of the case, from 0.
    case: usize,
    /// Index of the measured point to which the durations belong.
    measurement: usize,
    /// Integrator and tolerance of the run.
    way: MethodAtTolerance,
    /// Integration options of the run.
    how: Options,
}

/// Greatest number of steps of a run for which the first integrals are computed at each step.
const MOST_WATCHED: u64 = 200_000;

/// Makes the first run of a case with one integrator and tolerance. Measures the error, the changes of
/// the first integrals, and one duration.
///
/// # Errors
/// `Error` if the run cannot be made.
fn first_measurement(
    problem: &Problem<'_>,
    y0: &[f64],
    way: MethodAtTolerance,
    how: &Options,
    truth: &ChartReference<'_>,
) -> Result<Measurement, Error> {
    let ChartReference { reference, compared, watch } = truth;
    let start = std::time::Instant::now();
    let bare = way.run(problem, problem.scene.span, y0, how)?;
    let seconds = start.elapsed().as_secs_f64();
    let watched = Options { output: OutputOption::Steps { refine: 1 }, ..how.clone() };
    // First integrals are functions of all states, which a scene may not show.
    let shows_all = !(problem.by.is_reduced() && problem.shown.states_outputs);
    let is_watched = shows_all && bare.steps <= MOST_WATCHED;
    let again = is_watched.then(|| way.run(problem, problem.scene.span, y0, &watched));
    let drifts = again.transpose()?.map_or_else(Vec::new, |solution| watch.changes(problem, &solution));
    let arrived = bare.stop == Stop::End;
    let off = || {
        let right = compared.comparable_quantities(compared.quantities_of_state(reference.end()));
        larger(
            work_precision_error(&compared.quantities_of_run(problem, bare.t_end, &bare.y_end), &right),
            reference.uncertainty,
        )
    };
    Ok(Measurement {
        by: problem.by.clone(),
        solve: problem.solve,
        way,
        seconds: TimeStatistics { least: seconds, median: seconds, most: seconds, runs: 1 },
        error: arrived.then(off),
        steps: bare.steps,
        evaluations: bare.evaluations,
        stop: bare.stop,
        drifts,
    })
}
