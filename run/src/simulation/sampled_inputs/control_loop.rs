//! Windows of a run whose inputs are set from outside, and error estimates by a second run. A window
//! lasts from one instant at which inputs are set to the next.

use super::{ControllerSample, InputDecision, SampledRun};
use crate::code::CodeForm;
use crate::error::Error;
use crate::preparation::problem::Problem;
use crate::simulation::shown_quantities::ShownQuantities;
use crate::trust::constraint_residuals::{broken_constraint_objection, opened_loop_objections};
use crate::trust::correct_digits::{FEW, digits_left, value_sizes_for_digits};
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::Scene;
use tripos_sim::{EventRecord, Method, Options, OutputOption, Solution, Stop};
use tripos_traits::{AbsoluteTolerance, DoubleDouble, Scalar};

/// Ratio of the tolerances of the second run, which estimates the errors, to those of the first run.
const FINER: f64 = 0.1;
/// Relative and absolute tolerance of the second run, which estimates the errors, if the first run has
/// steps of equal length.
const EQUAL: f64 = 1e-12;
/// Longest step of the second run, which estimates the errors, relative to the length of a window.
/// The first run may take each window in a single step.
const PART_OF_WINDOW: f64 = 0.4;

/// Makes the options of the second run, which estimates the errors. They are finer than the options
/// `first` of the first run.
pub fn finer_loop_options(first: &Options) -> Options {
    let step_limit = first.step_limit.saturating_mul(10);
    if first.step.is_some() {
        let tolerances = Options::tolerances(EQUAL, EQUAL);
        return Options { method: Method::Dop853, step_limit, output: OutputOption::Ends, ..tolerances };
    }
    let atol = match &first.atol {
        AbsoluteTolerance::Uniform(atol) => AbsoluteTolerance::Uniform(FINER * atol),
        AbsoluteTolerance::Each(list) => AbsoluteTolerance::Each(list.iter().map(|atol| FINER * atol).collect()),
    };
    Options { rtol: FINER * first.rtol, atol, step_limit, output: OutputOption::Ends, ..first.clone() }
}

/// Closed loop of a mechanism and its controller: the problem, its inputs, and the instants at which
/// the controller sets them.
pub struct ControlLoop<'a> {
    /// Problem of the whole run, with its scene and equations.
    pub problem: &'a Problem<'a>,
    /// Compiled functions that the run watches: conditions of the domain and events.
    pub balance: &'a WatchedFunctions,
    /// Indices of the inputs that the controller sets, among the parameters.
    pub places: &'a [usize],
    /// Names of the inputs that the controller sets.
    pub inputs: &'a [&'a str],
    /// Instants at which the controller sets the inputs, s.
    pub instants: &'a [f64],
    /// Quantities that the scene shows. The controller receives them too.
    pub shown: &'a ShownQuantities,
}

/// Result of a run through all its windows, before errors are estimated.
pub struct WindowedRun {
    /// Instants of the samples, s.
    t: Vec<f64>,
    /// Values of the shown quantities at each sample.
    states: Vec<Vec<f64>>,
    /// Values of the inputs at each instant at which they were set.
    decisions: Vec<InputDecision>,
    /// Events and crossings of domain conditions.
    events: Vec<EventRecord>,
    /// Instant at which the run ended, s.
    t_end: f64,
    /// Values of the shown quantities at the end.
    end: Vec<f64>,
    /// Number of accepted steps in all windows so far.
    steps: u64,
    /// Number of rejected steps in all windows so far.
    rejected: u64,
    /// Reason why the run ended.
    pub stop: Stop,
    /// Warnings about the numbers of the run.
    warnings: Vec<String>,
}

impl ControlLoop<'_> {
    /// Runs through all windows from the integrated state `start`, with the options `how`. The inputs
    /// come from the controller, and all other parameters from the scene.
    ///
    /// # Errors
    /// `Error` if a window cannot be run, or if the controller returns unsuitable values.
    pub fn run(
        &self,
        scene: &Scene,
        start: &[f64],
        how: &Options,
        controller: &mut dyn FnMut(&ControllerSample<'_>) -> Vec<f64>,
    ) -> Result<WindowedRun, Error> {
        let (from, to) = scene.span;
        let mut way = WindowedRun {
            t: Vec::new(),
            states: Vec::new(),
            decisions: Vec::new(),
            events: Vec::new(),
            t_end: from,
            end: Vec::new(),
            steps: 0,
            rejected: 0,
            stop: Stop::End,
            warnings: Vec::new(),
        };
        let mut now = scene.clone();
        let mut y = start.to_vec();
        let mut ahead = self.instants.iter().copied().filter(|t| *t < to).enumerate().peekable();
        let mut t = from;
        loop {
            if let Some((index, t)) = ahead.next_if(|(_, instant)| *instant <= t) {
                let values = self.shown.of(&self.problem.with_scene(&now), t, &y)?;
                let sample = ControllerSample { t, index, names: &self.shown.names, values: &values };
                let inputs = self.call_controller(controller, &sample)?;
                for (at, value) in self.places.iter().zip(&inputs) {
                    now.parameters[*at] = *value;
                    now.exact.parameters[*at] = DoubleDouble::from_f64(*value);
                }
                way.decisions.push(InputDecision { t, inputs, values, errors: None });
            }
            let end = ahead.peek().map_or(to, |(_, instant)| *instant);
            now.span = (t, end);
            let problem = self.problem.with_scene(&now);
            let solution = self.run_window(&problem, &y, how, way.steps + way.rejected)?;
            way.add_window(self.shown, &problem, &solution)?;
            if solution.stop != Stop::End || end >= to {
                way.end = self.shown.of(&problem, solution.t_end, &solution.y_end)?;
                return Ok(way);
            }
            (t, y) = (end, solution.y_end);
        }
    }

    /// Runs one window from the integrated state `y`, with the options `how` of the whole run. `steps`
    /// is the number of accepted and rejected steps so far. It counts towards the step limit.
    ///
    /// # Errors
    /// `Error` if the window cannot be run.
    fn run_window(&self, problem: &Problem<'_>, y: &[f64], how: &Options, steps: u64) -> Result<Solution, Error> {
        let (from, to) = problem.scene.span;
        let output = match &how.output {
            OutputOption::At(times) => {
                let is_first = from <= self.problem.scene.span.0;
                let inside = |t: &&f64| (**t > from || is_first) && **t <= to;
                OutputOption::At(times.iter().filter(inside).copied().collect())
            }
            other => other.clone(),
        };
        let step_limit = how.step_limit.saturating_sub(steps);
        let mut options = Options { output, step_limit, ..how.clone() };
        // The second run keeps no samples.
        if how.output == OutputOption::Ends && how.step.is_none() {
            let longest = PART_OF_WINDOW * (to - from);
            options.max_step = Some(how.max_step.map_or(longest, |max| max.min(longest)));
        }
        let mut watched = watched_events(problem, self.balance);
        let mut solution = problem.solve(y, &options, &mut watched, None)?;
        if let Stop::StepLimit { limit } = &mut solution.stop {
            *limit = how.step_limit;
        }
        Ok(solution)
    }

    /// Calls the controller with a sample, and checks the values that it returns.
    ///
    /// # Errors
    /// `Error::Request` if the number of values is wrong, or if a value is not finite.
    fn call_controller(
        &self,
        controller: &mut dyn FnMut(&ControllerSample<'_>) -> Vec<f64>,
        sample: &ControllerSample<'_>,
    ) -> Result<Vec<f64>, Error> {
        let (values, t) = (controller(sample), sample.t);
        if values.len() != self.inputs.len() {
            let what = format!("the controller gave {} values at t = {t} s", values.len());
            return Err(Error::request(what, format!("give one for each of {}", self.inputs.join(", "))));
        }
        if let Some((value, input)) = values.iter().zip(self.inputs).find(|(value, _)| !value.is_finite()) {
            let what = format!("the value of `{input}` at t = {t} s is {value}");
            return Err(Error::request(what, "give a finite number"));
        }
        Ok(values)
    }

    /// Makes the result of a run. The estimated errors are its differences from the second run. Without
    /// a second run, they are `None`.
    pub fn sampled_run(&self, first: WindowedRun, second: Option<&WindowedRun>, form: CodeForm) -> SampledRun {
        let names = &self.shown.names;
        let mut decisions = first.decisions;
        let mut errors_at_end = None;
        if let Some(second) = second {
            for (own, other) in decisions.iter_mut().zip(&second.decisions) {
                own.errors = Some(control_loop_errors(&own.values, &other.values));
            }
            // An event that ends both runs has a different instant in each run. The error of interest is the
            // error of the state at the event.
            let as_far = decisions.len() == second.decisions.len();
            let both_ended = as_far && first.stop == second.stop && !first.stop.is_failure();
            errors_at_end = both_ended.then(|| control_loop_errors(&first.end, &second.end));
        }
        let mut warnings = first.warnings;
        if let (Some(second), None) = (second, &errors_at_end) {
            warnings.push(format!(
                "the errors at the end are not known: this run ended at t = {} s ({}), the second one at t = {} s ({})",
                first.t_end, first.stop, second.t_end, second.stop
            ));
        }
        let errors = decisions.iter().filter_map(|decision| Some((decision.t, decision.errors.as_deref()?)));
        let errors = errors.chain(errors_at_end.as_deref().map(|errors| (first.t_end, errors)));
        let sizes = value_sizes_for_digits(self.problem.scene, &first.states);
        warnings.extend(few_digits_warning(names, &sizes, errors));
        let digits = |errors: &Vec<f64>| errors.iter().zip(&sizes).map(|(e, size)| digits_left(e / size)).collect();
        let digits_at_end = errors_at_end.as_ref().map(digits);
        let samples = first.t.iter().zip(&first.states).chain([(&first.t_end, &first.end)]);
        warnings.extend(missing_value_warning(names, samples));
        SampledRun {
            by: self.problem.by.clone(),
            code: form,
            inputs: self.inputs.iter().map(|name| (*name).to_owned()).collect(),
            names: names.clone(),
            t: first.t,
            states: first.states,
            decisions,
            events: first.events,
            t_end: first.t_end,
            end: first.end,
            errors_at_end,
            digits_at_end,
            steps: (first.steps, first.rejected),
            stop: first.stop,
            warnings,
        }
    }
}

/// Least relative error of every value: eight rounding errors.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Estimated error of each value, in its unit: the difference from the value of a second run, plus
/// rounding.
fn control_loop_errors(own: &[f64], other: &[f64]) -> Vec<f64> {
    own.iter().zip(other).map(|(a, b)| (a - b).abs() + ROUNDING * a.abs()).collect()
}

/// Warning that a value has fewer than three correct digits, relative to its largest size in the run.
/// It names the first such instant. `None` if all values have enough digits. A value that the
/// controller brings to zero needs no digits of its own.
fn few_digits_warning<'a>(
    names: &[String],
    sizes: &[f64],
    errors: impl Iterator<Item = (f64, &'a [f64])>,
) -> Option<String> {
    let is_large = |error: f64, size: f64| error > size * 10_f64.powf(-FEW);
    let mut large = errors.filter_map(|(t, errors)| {
        let which = errors.iter().zip(sizes).position(|(error, size)| is_large(*error, *size))?;
        Some((t, which, errors[which]))
    });
    let (t, which, error) = large.next()?;
    Some(format!(
        "fewer than three digits are right from t = {} s on, where `{}` may be off by {}: this is the difference from another run, whose controller decided from its own states",
        with_significant_digits(t, 4),
        names[which],
        with_significant_digits(error, 2),
    ))
}

/// Warning that names the first shown quantity without a finite value, and its instant. `None` if all
/// values are finite.
fn missing_value_warning<'a>(
    names: &[String],
    mut samples: impl Iterator<Item = (&'a f64, &'a Vec<f64>)>,
) -> Option<String> {
    let (t, which) = samples.find_map(|(t, values)| Some((t, values.iter().position(|value| !value.is_finite())?)))?;
    Some(format!("`{}` has no value at t = {} s", names[which], with_significant_digits(*t, 4)))
}

impl WindowedRun {
    /// Adds the solution of a window to the result of the run.
    ///
    /// # Errors
    /// `Error::Request` if the number of parameters does not fit the equations.
    fn add_window(&mut self, shown: &ShownQuantities, problem: &Problem<'_>, solution: &Solution) -> Result<(), Error> {
        // A window begins at the end of the window before, whose sample is already known.
        let known = self.t.last().copied();
        let new = solution.t.iter().zip(&solution.y).filter(|(t, _)| Some(**t) != known);
        for (t, y) in new {
            self.t.push(*t);
            self.states.push(shown.of(problem, *t, y)?);
        }
        self.events.extend(solution.events.iter().cloned());
        self.t_end = solution.t_end;
        self.steps += solution.steps;
        self.rejected += solution.rejected;
        self.stop = solution.stop.clone();
        let said = solution.warnings.iter().map(ToString::to_string);
        let said =
            said.chain(opened_loop_objections(problem, solution)).chain(broken_constraint_objection(problem, solution));
        for warning in said.collect::<Vec<_>>() {
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
        Ok(())
    }
}
