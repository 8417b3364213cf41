//! Derivatives of the shown quantities at the end of a run, derivatives of the instants of its events,
//! and estimated errors of the derivatives at the end.

use super::corners::corners;
use super::equations_with_slopes::{RunWithSlopes, SeededStart};
use super::{SensitivityInputs, short_sensitivity_run_options};
use crate::error::Error;
use crate::integration_options::integration_options;
use crate::preparation::impacts::HeldContacts;
use crate::trust::correct_digits::parameters_one_rounding_away;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use tripos_derive::scene::Scene;
use tripos_sim::{EventRecord, Kind, Options, OutputOption, Stop, TaylorSeries, second_runs};
use tripos_traits::{Scalar, Tangent, larger};

/// Derivatives at the end of a run by each varied number.
pub struct EndDerivatives {
    /// Derivatives of the shown quantities, a list for each varied number. If an event ends the run, they
    /// include the shift of this end.
    pub shown: Vec<Vec<f64>>,
    /// Derivative of the instant of the end by each varied number, s per unit. They are 0 unless an event
    /// ends the run.
    pub t: Vec<f64>,
}

/// Computes the derivatives of shown quantities at the end of a run, and of the instant of the end,
/// by each varied number.
///
/// # Errors
/// [`Error::Request`] if the number of parameters does not fit the equations. `Error::Stopped` if
/// contact forces have no value at the end.
pub fn end_derivatives(parts: &SensitivityInputs<'_>, carried: &RunWithSlopes) -> Result<EndDerivatives, Error> {
    let solution = &carried.solution;
    let event = match solution.stop {
        Stop::Event { .. } | Stop::LeftDomain { .. } => solution.events.iter().rfind(|event| event.terminal),
        _ => None,
    };
    let place = parts.quantities.prepare_state(parts.problem, solution.t_end, &solution.y_end)?;
    let still = vec![0.0; parts.problem.scene.parameters.len()];
    let rates = event
        .map(|_| {
            rates_at_end(parts, carried.history.held_contacts_after(solution.t_end), solution.t_end, &solution.y_end)
        })
        .transpose()?;
    let flow = rates.map(|rates| parts.quantities.quantity_derivatives(&place, &still, &rates));
    let (mut shown, mut t) = (Vec::new(), Vec::new());
    for (seed, state) in parts.seeds.iter().zip(&carried.end) {
        let slopes = parts.quantities.quantity_derivatives(&place, &seed.parameters, state);
        let later = match (event, &flow) {
            // g(y(t, p), p) = 0 for all p.
            (Some(event), Some(flow)) => -slopes.watched[event.event] / flow.watched[event.event],
            _ => 0.0,
        };
        let total = |at: usize, x: &f64| flow.as_ref().map_or(*x, |flow| x + flow.shown[at] * later);
        shown.push(slopes.shown.iter().enumerate().map(|(at, x)| total(at, x)).collect());
        t.push(later);
    }
    Ok(EndDerivatives { shown, t })
}

/// Computes the rates of the state, dy/dt, while the contacts `kept` are held closed.
///
/// # Errors
/// `Error::Stopped` if the contact forces have no value.
fn rates_at_end(parts: &SensitivityInputs<'_>, kept: &HeldContacts, t: f64, y: &[f64]) -> Result<Vec<f64>, Error> {
    if !kept.is_empty() {
        let rates = parts.problem.rates_with_contacts(&parts.problem.contacts(), kept, t, y);
        return rates.map_err(|failure| Error::Stopped(failure.message));
    }
    let system = parts.problem.system();
    let (q, v) = y.split_at(system.lengths().coordinates);
    let (mut q_dot, mut v_dot) = (vec![0.0; q.len()], vec![0.0; v.len()]);
    system.derivative(&parts.problem.scene.parameters, q, v, &mut q_dot, &mut v_dot);
    Ok([q_dot, v_dot].concat())
}

/// Computes the derivatives of the instants of a run's events by each varied number, s per unit. `t_end`
/// are the derivatives of the end. `None` for an event whose function does not cross zero.
///
/// # Errors
/// `Error` if the rates, the contact forces or the reactions at an event have no value.
pub fn event_time_derivatives(
    parts: &SensitivityInputs<'_>,
    carried: &RunWithSlopes,
    t_end: &[f64],
) -> Result<Vec<Option<Vec<f64>>>, Error> {
    carried.solution.events.iter().map(|event| event_time_derivative(parts, carried, t_end, event)).collect()
}

/// Computes the derivative of the instant of one event by each varied number, s per unit. `None` if its
/// function does not cross zero, or if the state there is not known.
fn event_time_derivative(
    parts: &SensitivityInputs<'_>,
    carried: &RunWithSlopes,
    t_end: &[f64],
    event: &EventRecord,
) -> Result<Option<Vec<f64>>, Error> {
    if event.terminal {
        return Ok(Some(t_end.to_vec()));
    }
    if !matches!(event.kind, Kind::Rising | Kind::Falling) {
        return Ok(None);
    }
    if event.event >= parts.quantities.watched_function_count() {
        return Ok(carried.history.instant_derivatives(event.t).map(<[f64]>::to_vec));
    }
    let Some((y, slopes)) = state_between_samples(parts, carried, event.t)? else { return Ok(None) };
    let place = parts.quantities.prepare_state(parts.problem, event.t, &y)?;
    let still = vec![0.0; parts.problem.scene.parameters.len()];
    let rates = rates_at_end(parts, carried.history.held_contacts_after(event.t), event.t, &y)?;
    let flow = parts.quantities.quantity_derivatives(&place, &still, &rates).watched[event.event];
    let later = parts.seeds.iter().zip(&slopes).map(|(seed, state)| {
        let along = parts.quantities.quantity_derivatives(&place, &seed.parameters, state).watched[event.event];
        -along / flow
    });
    // If the function of an event only touches zero, its instant has no derivative.
    Ok((flow.abs() > 0.0).then(|| later.collect()))
}

/// State (q, v) between two samples, and its derivatives, a list for each varied number.
type StateWithSlopes = (Vec<f64>, Vec<Vec<f64>>);

/// Computes the state and its derivatives at the instant `t`, s, by a short run from the last sample
/// before it. `None` if this run does not reach the instant.
fn state_between_samples(
    parts: &SensitivityInputs<'_>,
    carried: &RunWithSlopes,
    t: f64,
) -> Result<Option<StateWithSlopes>, Error> {
    let (solution, span) = (&carried.solution, parts.problem.scene.span);
    let toward = (span.1 - span.0).signum();
    let Some(sample) = solution.t.iter().rposition(|sample| (t - sample) * toward >= 0.0) else {
        return Ok(None);
    };
    let slopes: Vec<Vec<f64>> = carried.at.iter().map(|list| list[sample].clone()).collect();
    let y = &solution.y[sample];
    if t - solution.t[sample] == 0.0 {
        return Ok(Some((y.clone(), slopes)));
    }
    let from = SeededStart { span: (solution.t[sample], t), y, seeds: parts.seeds, slopes: &slopes };
    let run = parts.equations.run(parts.problem, &from, &short_sensitivity_run_options(parts), &mut [])?;
    Ok((run.solution.stop == Stop::End).then_some((run.solution.y_end, run.end)))
}

/// Least relative error of every derivative: eight rounding errors.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Estimated errors of the derivatives at the end, a list for each varied number, and a text about the
/// second run. Both are `None` if no errors could be estimated.
type Assessed = (Option<Vec<Vec<f64>>>, Option<String>);

/// Estimates the errors of the derivatives at the end by a second run with other steps. Its start and
/// parameters differ by one rounding. `None` if no second run comes to the same end. `starts` are the
/// derivatives of the start's state, a list for each varied number.
///
/// Differences shortly before the end are included, because two motions that oscillate about each
/// other agree now and then.
///
/// # Errors
/// [`Error`] if the second run is refused although the first was not.
pub fn end_derivative_errors(
    parts: &SensitivityInputs<'_>,
    carried: &RunWithSlopes,
    own: &EndDerivatives,
    starts: &[Vec<f64>],
) -> Result<Assessed, Error> {
    let (problem, first) = (parts.problem, &carried.solution);
    if first.steps == 0 || first.stop.is_failure() {
        return Ok((None, None));
    }
    let how = integration_options(problem.scene);
    let is_cheap = problem.has_short_series() && parts.equations.has_series();
    let series = if is_cheap { TaylorSeries::Cheap } else { TaylorSeries::Costly };
    let scene = Scene { parameters: parameters_one_rounding_away(problem.scene), ..problem.scene.clone() };
    let beside = problem.with_scene(&scene);
    let balance = WatchedFunctions::new(problem.mechanism, problem.model, &scene, problem.by)?;
    let y: Vec<f64> = problem.start()?.iter().map(|y| y * (1.0 + f64::EPSILON)).collect();
    let before = samples_for_end_derivatives(parts, carried);
    let times: Vec<f64> = before.iter().map(|at| first.t[*at]).collect();
    for second in second_runs(&how, first, problem.scene.span, series) {
        let how = Options { output: OutputOption::At(times.clone()), ..second.options.clone() };
        let from = SeededStart { span: problem.scene.span, y: &y, seeds: parts.seeds, slopes: starts };
        let mut watched = watched_events(&beside, &balance);
        let run = parts.equations.run(&beside, &from, &how, &mut watched)?;
        if run.solution.stop.code() != first.stop.code() || run.solution.t.len() < times.len() {
            continue;
        }
        let its = SensitivityInputs { problem: &beside, ..*parts };
        let theirs = end_derivatives(&its, &run)?.shown;
        // A second run may nearly touch a contact although the first does not. It then has no derivatives,
        // and says nothing about errors.
        let pairs = || own.shown.iter().flatten().zip(theirs.iter().flatten());
        if pairs().any(|(own, other)| other.is_nan() && !own.is_nan()) {
            continue;
        }
        let mut apart = end_derivative_differences(&own.shown, &theirs);
        for (sample, at) in before.iter().enumerate() {
            let of = |parts: &SensitivityInputs<'_>, carried: &RunWithSlopes, sample: usize| {
                derivatives_at_sample(parts, carried, sample)
            };
            let near = end_derivative_differences(&of(parts, carried, *at)?, &of(&its, &run, sample)?);
            for (sum, near) in apart.iter_mut().flatten().zip(near.into_iter().flatten()) {
                *sum = larger(*sum, near);
            }
        }
        for (error, value) in apart.iter_mut().flatten().zip(own.shown.iter().flatten()) {
            *error = second.part * *error + ROUNDING * value.abs();
        }
        return Ok((Some(apart), Some(second.words)));
    }
    Ok((None, None))
}

/// Interval before and after a jump of derivatives in which samples are not compared. It is a fraction
/// of the instant in s, or of 1 s if that is larger.
const BESIDE: f64 = 1e-6;

/// Indices of at most two samples shortly before the end of a run, for comparison with a second run.
/// Samples next to a jump of derivatives are avoided, because the second run may jump at another
/// instant.
fn samples_for_end_derivatives(parts: &SensitivityInputs<'_>, carried: &RunWithSlopes) -> Vec<usize> {
    let (t, t_end) = (&carried.solution.t, carried.solution.t_end);
    let p: Vec<Tangent<1>> = parts.problem.scene.parameters.iter().map(|p| Tangent::from_f64(*p)).collect();
    let jumps = corners(parts.problem, &p).into_iter().filter(|corner| corner.jumps).map(|corner| corner.at);
    let jumps: Vec<f64> = jumps.chain(carried.history.instants.iter().map(|instant| instant.t)).collect();
    let is_beside = |t: f64| jumps.iter().any(|jump| (t - jump).abs() <= BESIDE * t.abs().max(1.0));
    let up_to = |part: usize| (0..=t.len() * part / 40).rev().find(|at| t.get(*at).is_some_and(|t| !is_beside(*t)));
    let mut list: Vec<usize> = [38, 39].into_iter().filter_map(up_to).collect();
    list.dedup();
    list.retain(|at| t[*at].total_cmp(&t_end).is_ne());
    list
}

/// Derivatives of the shown quantities at a sample of a run, a list for each varied number.
///
/// # Errors
/// `Error::Request` if the number of parameters does not fit the equations.
fn derivatives_at_sample(
    parts: &SensitivityInputs<'_>,
    carried: &RunWithSlopes,
    sample: usize,
) -> Result<Vec<Vec<f64>>, Error> {
    let solution = &carried.solution;
    let place = parts.quantities.prepare_state(parts.problem, solution.t[sample], &solution.y[sample])?;
    let slopes = parts.seeds.iter().zip(&carried.at);
    Ok(slopes
        .map(|(seed, at)| parts.quantities.quantity_derivatives(&place, &seed.parameters, &at[sample]).shown)
        .collect())
}

/// Absolute differences of two tables of derivatives of equal shape, entry by entry.
fn end_derivative_differences(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let of = |a: &Vec<f64>, b: &Vec<f64>| a.iter().zip(b).map(|(a, b)| (a - b).abs()).collect();
    a.iter().zip(b).map(|(a, b)| of(a, b)).collect()
}
