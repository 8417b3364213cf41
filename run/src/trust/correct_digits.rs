//! Estimates how many digits of a run are correct, by a second run of the same motion.
//!
//! The second run takes other steps ([`tripos_sim::second_runs`]). Its start and its parameters differ
//! by one rounding. So the difference of the two runs contains the errors of the steps, of rounding,
//! and of numbers that doubles cannot represent. The motion has amplified each of these errors.
//!
//! During the run, the error of a value is measured relative to the largest size s of this value
//! along the run, because a curve through zero has no digits of its own there. s is at least the
//! absolute tolerance divided by the relative tolerance. By these tolerances, a smaller size does not
//! matter. At the end of the run, the number itself is wanted. There the error is measured relative to
//! |value| + s, with s at most 1 in its SI unit.

use super::watched_functions::{WatchedFunctions, watched_events};
use crate::error::Error;
use crate::preparation::problem::Problem;
use rustc_hash::FxHashMap;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{Integrator, Scene};
use tripos_sim::{
    Effect, Event, EventRecord, Kind, Options, OutputOption, SecondRun, Solution, Stop, TaylorSeries, second_runs,
};
use tripos_traits::{DoubleDouble, Real, Scalar, larger, largest};

/// Greatest number of instants at which a run and its second run are compared.
const INSTANTS: usize = 400;
/// Number of parts into which the compared instants are divided. The error of an instant includes the
/// differences of the two runs over one such part before it.
const NEAR: usize = 40;
/// Least number of earlier instants whose differences are included in the error of an instant.
const NEAREST: usize = 2;
/// Number of correct digits below which a run gets an objection.
pub const FEW: f64 = 3.0;
/// Least relative error of every value: eight rounding errors.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Size, in SI units, below which a value does not matter if the run has no tolerances. It is the
/// absolute default tolerance divided by the relative one.
const SMALL: f64 = 1e-3;
/// Distance between the end instants of two stopped runs up to which they count as the same end,
/// relative to the duration of the run.
const ONE_END: f64 = 1e-3;
/// Factor from the difference of two motions by quadrature to the error of each motion. Both motions
/// share all errors except those of the start.
const QUADRATURE_PART: f64 = 4.0;

/// Estimated errors and numbers of correct digits of the values that a run shows.
#[derive(Clone, Debug)]
pub struct CorrectDigits {
    /// Compared instants, s, in the order of the run. The last one is the end of the run if errors
    /// were estimated to the end.
    pub t: Vec<f64>,
    /// Estimated error of each shown value at each instant of `t`, in the unit of the value: one
    /// list for each instant.
    pub errors: Vec<Vec<f64>>,
    /// Number of correct digits of each shown value at each instant of `t`: −log₁₀ of its error relative
    /// to its largest size in the run. One list for each instant.
    pub digits: Vec<Vec<f64>>,
    /// Number of correct digits of each shown value at the last compared instant: −log₁₀ of its error
    /// relative to the value itself.
    last: Vec<f64>,
    /// Estimated error of the instant of each event of the run, s. `None` for an event that does not
    /// happen in the second run.
    pub events: Vec<Option<f64>>,
    /// Text that describes the second run, such as its method and tolerances.
    pub by: String,
    /// Instant at which the assessed run ends, s.
    pub t_end: f64,
    /// End of the second run: its instant and its reason.
    pub(crate) second: SecondEnd,
}

/// End of a second run, which was made to estimate the errors of a first run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SecondEnd {
    /// Instant at which the second run ended, s.
    pub t: f64,
    /// Reason why the second run ended.
    pub stop: Stop,
    /// True if the second run was more accurate than the first.
    pub is_finer: bool,
}

/// Shown value and instant at which a run has the fewest correct digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FewestDigits {
    /// Index of the instant among the compared instants.
    pub instant: usize,
    /// Index of the value among the shown values.
    pub value: usize,
    /// Number of correct digits of the value at the instant.
    pub digits: f64,
}

impl CorrectDigits {
    /// True if errors were estimated to the end of the run.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.last_assessed_instant() == Some(self.t_end)
    }

    /// Last instant at which errors were estimated, s; `None` if there is none.
    #[must_use]
    pub fn last_assessed_instant(&self) -> Option<f64> {
        self.t.last().copied()
    }

    /// Number of correct digits of each shown value at the end of the run. `None` if errors were not
    /// estimated to the end.
    #[must_use]
    pub fn digits_at_end(&self) -> Option<&[f64]> {
        self.is_complete().then_some(self.last.as_slice())
    }

    /// Smallest number of correct digits among all shown values at the end of the run. `None` if errors
    /// were not estimated to the end, or no values are shown.
    #[must_use]
    pub fn digits_at_end_least(&self) -> Option<f64> {
        self.digits_at_end()?.iter().copied().reduce(f64::min)
    }

    /// Estimated error of each shown value at the end of the run, in its unit. `None` if errors were not
    /// estimated to the end.
    #[must_use]
    pub fn errors_at_end(&self) -> Option<&[f64]> {
        self.errors.last().filter(|_| self.is_complete()).map(Vec::as_slice)
    }

    /// Finds the shown value with the fewest correct digits at the compared instant with the index
    /// `instant`. Returns the index of the value and its number of digits. `None` if no values are shown.
    #[must_use]
    pub fn fewest_digits(&self, instant: usize) -> Option<(usize, f64)> {
        self.digits[instant].iter().copied().enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Finds the fewest correct digits among all shown values and all compared instants, and the first
    /// place if several are equal. `None` if errors were estimated at no instant.
    #[must_use]
    pub fn fewest_of_all(&self) -> Option<FewestDigits> {
        let at = |instant| self.fewest_digits(instant).map(|(value, digits)| FewestDigits { instant, value, digits });
        (0..self.t.len()).filter_map(at).min_by(|a, b| a.digits.total_cmp(&b.digits))
    }

    /// Finds the first instant at which a value has fewer than three correct digits. Returns the indices
    /// (instant, value). `None` if all values have at least three digits.
    #[must_use]
    pub fn first_with_few(&self) -> Option<(usize, usize)> {
        let few = |at: usize| self.fewest_digits(at).filter(|(_, digits)| *digits < FEW).map(|(which, _)| (at, which));
        let at_end =
            || Some((self.t.len().checked_sub(1)?, self.digits_at_end()?.iter().position(|digits| *digits < FEW)?));
        (0..self.t.len()).find_map(few).or_else(at_end)
    }

    /// Text that names the part of the run for which no errors are estimated. `None` if errors are
    /// estimated to its end.
    pub(super) fn part_without_digits(&self) -> Option<String> {
        match self.last_assessed_instant() {
            _ if self.is_complete() => None,
            Some(t) => Some(format!("beyond t = {} s", with_reliable_digits(t, None))),
            None => Some("at any instant".to_owned()),
        }
    }

    /// True if the second run could not go on and stopped before the end of the first, although it is
    /// more accurate. A second run that reaches its step limit does not count.
    pub(super) fn second_run_stopped_early(&self) -> bool {
        let SecondEnd { t, stop, is_finer } = &self.second;
        let start = self.t.first().copied().unwrap_or(*t);
        let is_one_end = (self.t_end - t).abs() <= ONE_END * (self.t_end - start).abs();
        // A coarser run may fail by its own errors.
        *is_finer && stop.is_failure() && !matches!(stop, Stop::StepLimit { .. }) && !is_one_end
    }
}

/// Note that errors are not estimated to the end of a run, because the second run cost too much or
/// failed by its own error. `None` if errors are estimated to the end.
#[must_use]
pub fn unassessed_digits_note(digits: &CorrectDigits) -> Option<String> {
    let beyond = digits.part_without_digits().filter(|_| !digits.second_run_stopped_early())?;
    let why = match digits.second.stop {
        Stop::StepLimit { .. } => "had cost as much as this one there",
        _ => "could not go on there",
    };
    Some(format!("digits are not assessed {beyond}: a second run ({}) {why}", digits.by))
}

/// Function that computes the values that a run shows, from a problem, an instant, s, and an
/// integrated state. It fails if a value cannot be computed.
pub type Values<'a> = dyn Fn(&Problem<'_>, f64, &[f64]) -> Result<Vec<f64>, Error> + 'a;

/// Estimates the number of correct digits of a run by a second run. The run started from the
/// integrated state `y0`. `None` if the run took no step, has no state, or was interrupted.
///
/// # Errors
/// [`Error`] if the second run is refused although the first was not, or if a value cannot be
/// computed.
pub fn estimate_digits(
    problem: &Problem<'_>,
    y0: &[f64],
    options: &Options,
    solution: &Solution,
    values: &Values<'_>,
    balance: &WatchedFunctions,
) -> Result<Option<CorrectDigits>, Error> {
    if solution.steps == 0 || solution.stop == Stop::Interrupted || y0.is_empty() {
        return Ok(None);
    }
    let scene = second_run_scene(problem.scene, solution.t_end);
    let beside = problem.with_scene(&scene);
    let mut watched: Vec<Event<'_>> =
        if solution.events.is_empty() { Vec::new() } else { watched_events(&beside, balance) };
    for event in &mut watched {
        event.effect = Effect::Record;
    }
    let start: Vec<f64> = y0.iter().map(|y| y * (1.0 + f64::EPSILON)).collect();
    let samples = run_samples(solution);
    let times: Vec<f64> = samples.iter().map(|(t, _)| *t).collect();
    let mut best: Option<(Solution, SecondRun)> = None;
    for second in second_run_choices(problem, options, solution) {
        let how = Options { output: OutputOption::At(times.clone()), ..second.options.clone() };
        let run = beside.solve(&start, &how, &mut watched, None)?;
        if run.stop == Stop::Interrupted {
            return Ok(None);
        }
        if best.as_ref().is_none_or(|(other, _)| run.t.len() > other.t.len()) {
            best = Some((run, second));
        }
        if best.as_ref().is_some_and(|(run, _)| run.t.len() == times.len()) {
            break;
        }
    }
    let Some((run, SecondRun { part, words, is_finer, .. })) = best else { return Ok(None) };
    let first: Vec<Vec<f64>> = samples.iter().map(|(t, y)| values(problem, *t, y)).collect::<Result<_, _>>()?;
    let second: Vec<Vec<f64>> =
        run.t.iter().zip(&run.y).map(|(t, y)| values(&beside, *t, y)).collect::<Result<_, _>>()?;
    let sizes = value_sizes_for_digits(problem.scene, &first);
    let (mut errors, mut digits, mut last) = (Vec::new(), Vec::new(), Vec::new());
    let mut apart: Vec<Vec<f64>> = first.iter().zip(&second).map(|(a, b)| value_differences(a, b)).collect();
    leave_out_jumps(&mut apart, &times, solution, &run, problem.scene.span);
    for (instant, a) in first.iter().take(apart.len()).enumerate() {
        let near = differences_up_to_instant(&apart, instant);
        let own = |at: usize| a[at].abs() + sizes[at].min(1.0);
        let error = |at: usize| {
            // An earlier instant without a value does not change the error of this instant.
            let others = near.iter().map(|apart| apart[at]).filter(|apart| !apart.is_nan());
            let largest = others.fold(apart[instant][at], larger);
            part * largest + ROUNDING * own(at)
        };
        errors.push((0..a.len()).map(error).collect::<Vec<_>>());
        digits.push((0..a.len()).map(|at| digits_left(error(at) / sizes[at])).collect::<Vec<_>>());
        last = (0..a.len()).map(|at| digits_left(error(at) / own(at))).collect();
    }
    let events = errors_of_events(&solution.events, &run.events, part);
    let second = SecondEnd { t: run.t_end, stop: run.stop, is_finer };
    Ok(Some(CorrectDigits { t: run.t, errors, digits, last, events, by: words, t_end: solution.t_end, second }))
}

/// Absolute differences of two lists of values, in the order of the lists.
fn value_differences(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).collect()
}

/// Longest time between two instants that count as the same impact in two runs, relative to the
/// duration of the run.
const ONE_IMPACT: f64 = 1e-3;

/// Replaces the differences of two runs at samples between the instants of the same impact in both
/// runs. At such a sample only one run has jumped, so the difference is the jump. The uncertainty of
/// the impact's instant is given separately. The sample gets the differences of the sample before it.
fn leave_out_jumps(apart: &mut [Vec<f64>], times: &[f64], first: &Solution, second: &Solution, span: (f64, f64)) {
    let between: Vec<(f64, f64)> = first
        .impacts
        .iter()
        .zip(&second.impacts)
        .map(|(own, other)| (own.t.min(other.t), own.t.max(other.t)))
        .filter(|(from, to)| to - from <= ONE_IMPACT * (span.1 - span.0))
        .collect();
    let mut next = 0;
    for (at, t) in times.iter().enumerate().take(apart.len()) {
        while between.get(next).is_some_and(|(_, to)| to < t) {
            next += 1;
        }
        if at > 0 && between.get(next).is_some_and(|(from, _)| from <= t) {
            let (before, from) = apart.split_at_mut(at);
            from[0].clone_from(&before[at - 1]);
        }
    }
}

/// Differences of two runs at the instant with the index `instant`, and at the compared instants
/// shortly before it.
///
/// Two motions that oscillate about each other meet now and then, although their errors are as large
/// as elsewhere. So the earlier differences count too.
fn differences_up_to_instant(apart: &[Vec<f64>], instant: usize) -> &[Vec<f64>] {
    let near = (apart.len() / NEAR).max(NEAREST);
    &apart[instant.saturating_sub(near)..=instant]
}

/// Estimates the errors of the instants of a run's events, s, by comparison with another run.
///
/// The first event of a kind is compared with the first event of this kind in the other run, and so
/// on. `None` if the other run has no such event. A repeated event gets the largest error of its
/// neighbours too, because two runs that oscillate about each other may meet at one event.
fn errors_of_events(list: &[EventRecord], others: &[EventRecord], part: f64) -> Vec<Option<f64>> {
    let mut errors = vec![None; list.len()];
    for (own, its) in records_by_event(list).iter().zip(records_by_event(others)) {
        let same_kind = |kind: Kind| its.iter().map(move |at| &others[*at]).filter(move |other| other.kind == kind);
        let mut met: FxHashMap<Kind, _> = FxHashMap::default();
        let mut counterpart =
            |event: &EventRecord| met.entry(event.kind).or_insert_with(|| same_kind(event.kind)).next();
        let apart: Vec<Option<f64>> =
            own.iter().map(|at| Some((list[*at].t - counterpart(&list[*at])?.t).abs())).collect();
        for (place, at) in own.iter().enumerate() {
            let near = &apart[place.saturating_sub(NEAREST)..(place + NEAREST + 1).min(apart.len())];
            let largest = near.iter().flatten().copied().fold(0.0, larger);
            errors[*at] = apart[place].map(|_| part * largest + ROUNDING * list[*at].t.abs());
        }
    }
    errors
}

/// Groups the records of events by event: for each watched event, the indices of its records in
/// `list`, in order.
fn records_by_event(list: &[EventRecord]) -> Vec<Vec<usize>> {
    let mut places = Vec::new();
    for (at, record) in list.iter().enumerate() {
        if places.len() <= record.event {
            places.resize(record.event + 1, Vec::new());
        }
        places[record.event].push(at);
    }
    places
}

/// Number of correct digits at a relative error: −log₁₀ of the error. It is 0 if the error is 1 or
/// more, or not a number.
pub(crate) fn digits_left(relative: f64) -> f64 {
    if relative < 1.0 { -relative.log10() } else { 0.0 }
}

/// Possible settings of the second run, in the order of preference.
fn second_run_choices(problem: &Problem<'_>, options: &Options, solution: &Solution) -> Vec<SecondRun> {
    if problem.scene.integration.method == Integrator::Quadrature {
        let words = "quadrature from numbers one rounding away".to_owned();
        return vec![SecondRun { options: options.clone(), part: QUADRATURE_PART, is_finer: false, words }];
    }
    let series = if problem.has_short_series() { TaylorSeries::Cheap } else { TaylorSeries::Costly };
    second_runs(options, solution, problem.scene.span, series)
}

/// Samples (t, y) spread evenly over a run, at most [`INSTANTS`], followed by the end of the run.
fn run_samples(solution: &Solution) -> Vec<(f64, &Vec<f64>)> {
    let every = solution.y.len().div_ceil(INSTANTS).max(1);
    let mut list: Vec<_> = solution.t.iter().copied().zip(&solution.y).step_by(every).collect();
    if list.last().is_none_or(|(t, _)| t.total_cmp(&solution.t_end).is_ne()) {
        list.push((solution.t_end, &solution.y_end));
    }
    list
}

/// Time by which the second run goes beyond the end of the first, as a fraction of the duration of the
/// first. An event at the end of the first run may happen later in the second run.
const BEYOND: f64 = 0.02;

/// Makes the scene for the second run, from the start of the first run to slightly beyond its end. A
/// parameter that doubles cannot represent becomes the neighbouring double on the other side of its
/// exact number.
fn second_run_scene(scene: &Scene, t_end: f64) -> Scene {
    let (start, end) = scene.span;
    let beyond = t_end + BEYOND * (t_end - start);
    let is_inside = (end - beyond) * (end - start) > 0.0;
    Scene {
        parameters: parameters_one_rounding_away(scene),
        span: (start, if is_inside { beyond } else { end }),
        ..scene.clone()
    }
}

/// Parameters of a scene, moved by one rounding error. A parameter that doubles cannot represent
/// becomes the neighbouring double on the other side of its exact number. The other parameters are
/// unchanged.
pub fn parameters_one_rounding_away(scene: &Scene) -> Vec<f64> {
    let other = |(x, exact): (&f64, &DoubleDouble)| {
        let rest = (*exact - DoubleDouble::from_f64(*x)).to_f64();
        if rest > 0.0 {
            x.next_up()
        } else if rest < 0.0 {
            x.next_down()
        } else {
            *x
        }
    };
    scene.parameters.iter().zip(&scene.exact.parameters).map(other).collect()
}

/// Largest size of each shown value along a run, in its unit. It is at least the size below which a
/// value does not matter.
pub(crate) fn value_sizes_for_digits(scene: &Scene, values: &[Vec<f64>]) -> Vec<f64> {
    let how = &scene.integration;
    let adaptive = how.step.is_none() && how.method != Integrator::Quadrature;
    let matters = match (adaptive, how.rtol > 0.0) {
        (true, true) => (how.atol.smallest() / how.rtol).clamp(f64::MIN_POSITIVE, 1.0),
        (true, false) => 1.0,
        (false, _) => SMALL,
    };
    let count = values.first().map_or(0, Vec::len);
    let of = |at: usize| largest(values.iter().map(|list| list[at])).max(matters);
    (0..count).map(of).map(|size| larger(size, f64::MIN_POSITIVE)).collect()
}
