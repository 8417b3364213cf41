//! Runs whose inputs are set from outside at given instants and held constant between them. A
//! controller or recorded signals set them.
//!
//! The run is made in windows, from each instant to the next. In each window, an input is a parameter
//! of the equations. A window ends exactly at its instant, and the next window begins there. So no
//! step and no stage of a method uses two values of an input. This holds for every method and every
//! kind of code. The same controller gives the same bits in every run.
//!
//! A second run estimates the errors. It takes finer steps and uses a new controller. This controller
//! decides from the states of the second run. So the difference of the two runs contains the errors
//! that the decisions amplify.
//!
//! Source: K. J. Åström & B. Wittenmark, *Computer-Controlled Systems*, 3rd edition (1997), § 2.3
//! (zero-order hold).

mod control_loop;

use super::shown_quantities::ShownQuantities;
use crate::code::{CodeForm, CodePreparation, runnable_code};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::trust::correct_digits::parameters_one_rounding_away;
use crate::trust::watched_functions::WatchedFunctions;
use control_loop::{ControlLoop, finer_loop_options};
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{Integrator, Scene};
use tripos_sim::{EventRecord, Stop};

/// Shown quantities of a run at one instant, as passed to a controller.
#[derive(Clone, Copy, Debug)]
pub struct ControllerSample<'a> {
    /// Instant at which the controller sets the inputs, s.
    pub t: f64,
    /// Index of the instant among all instants at which inputs are set, from 0.
    pub index: usize,
    /// Names of the coordinates, the generalized speeds, and the further outputs of the scene, in this
    /// order.
    pub names: &'a [String],
    /// Values of the quantities in `names`, in the same order, in SI units. Accelerations and reactions
    /// are those just before the instant, with the inputs that the controller is about to replace.
    pub values: &'a [f64],
}

impl ControllerSample<'_> {
    /// Value of a coordinate, a generalized speed or an output at the instant, in its SI unit. `None` if
    /// no shown quantity has this name.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        self.names.iter().position(|known| known == name).map(|at| self.values[at])
    }
}

/// Recorded signal of an input, held constant between instants. From each instant on, the input has
/// the value with the same index.
#[derive(Clone, Copy, Debug)]
pub struct HeldSignal<'a> {
    /// Name of the input of the model that the signal sets.
    pub input: &'a str,
    /// Instants at which the value changes, s, in increasing order. Before the first instant, the
    /// input has the scene's value.
    pub instants: &'a [f64],
    /// Values of the input in its SI unit, one for each instant, valid from that instant on.
    pub values: &'a [f64],
}

/// Values of the inputs from an instant on. Also the shown quantities at that instant, with their
/// estimated errors.
#[derive(Clone, Debug, PartialEq)]
pub struct InputDecision {
    /// Instant from which the inputs have these values, s.
    pub t: f64,
    /// Values of the inputs, in the order of [`SampledRun::inputs`].
    pub inputs: Vec<f64>,
    /// Values of the shown quantities at the instant, in the order of [`SampledRun::names`]. They belong
    /// to the inputs that were valid until then.
    pub values: Vec<f64>,
    /// Estimated error of each value in `values`, in its unit. `None` if the second run, which estimates
    /// the errors, did not reach the instant.
    pub errors: Option<Vec<f64>>,
}

/// Result of a run whose inputs were set from outside, by a controller or by recorded signals.
#[derive(Clone, Debug)]
pub struct SampledRun {
    /// Equations of motion that were integrated: a formulation of the model.
    pub by: EquationsOrigin,
    /// Form of the code that was used, such as compiled or interpreted.
    pub code: CodeForm,
    /// Names of the inputs that were set from outside.
    pub inputs: Vec<String>,
    /// Names of the coordinates, the generalized speeds, and the further outputs of the scene, in this
    /// order.
    pub names: Vec<String>,
    /// Instants of the samples, s.
    pub t: Vec<f64>,
    /// Values of the shown quantities at each sample, in the order of `names`.
    pub states: Vec<Vec<f64>>,
    /// Values of the inputs at each instant at which they were set, in the order of time.
    pub decisions: Vec<InputDecision>,
    /// Events and crossings of domain conditions in the run, in order.
    pub events: Vec<EventRecord>,
    /// Instant at which the run ends, s.
    pub t_end: f64,
    /// Values of the shown quantities at the end of the run, in the order of `names`.
    pub end: Vec<f64>,
    /// Estimated error of each value in `end`, in its unit. `None` if the second run, which estimates the
    /// errors, did not end in the same way.
    pub errors_at_end: Option<Vec<f64>>,
    /// Number of correct digits of each value in `end`, relative to its largest size in the run. `None`
    /// if `errors_at_end` is `None`.
    pub digits_at_end: Option<Vec<f64>>,
    /// Number of accepted steps, followed by the number of rejected steps.
    pub steps: (u64, u64),
    /// Reason why the run ended, such as the end of the span or an event.
    pub stop: Stop,
    /// Warnings about the numbers of the run, one text for each.
    pub warnings: Vec<String>,
}

impl SampledRun {
    /// Reasons not to trust the run to its end, one text for each. Empty if the run can be trusted.
    #[must_use]
    pub fn objections(&self) -> Vec<String> {
        let failure = self.stop.is_failure().then(|| self.ending());
        failure.into_iter().chain(self.warnings.iter().cloned()).collect()
    }

    /// True if the run can be trusted to its end: there are no objections, and errors were estimated
    /// to the end.
    #[must_use]
    pub fn is_trusted(&self) -> bool {
        self.objections().is_empty() && self.errors_at_end.is_some()
    }

    /// Sentence that says when and why the run ended.
    #[must_use]
    pub fn ending(&self) -> String {
        let t = with_reliable_digits(self.t_end, None);
        format!("ended at t = {t} s: {}", self.stop.described(&self.names))
    }

    /// Returns the values of the shown quantity `name` at all samples, in the order of time.
    ///
    /// # Errors
    /// [`Error::Request`] if the run shows no quantity of this name.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Error> {
        let at = self.names.iter().position(|shown| shown == name).ok_or_else(|| {
            let help = nearest_name_advice(name, self.names.iter().map(String::as_str));
            Error::request(format!("the run shows no `{name}`"), help)
        })?;
        Ok(self.states.iter().map(|values| values[at]).collect())
    }
}

/// Runs a scene with recorded signals for some of its inputs, and estimates the errors by a second
/// run. `by` names the equations; `None` takes the first formulation of the model.
///
/// # Errors
/// Errors of [`simulate_sampled`]. [`Error::Request`] if a signal does not have as many values as
/// instants.
pub fn simulate_recorded_signals(
    mechanism: &Mechanism,
    scene: &Scene,
    signals: &[HeldSignal<'_>],
    by: Option<&EquationsName>,
) -> Result<SampledRun, Error> {
    for HeldSignal { input, instants, values } in signals {
        if instants.len() != values.len() {
            let what = format!("`{input}` has {} instants and {} values", instants.len(), values.len());
            return Err(Error::request(what, "give as many values as instants"));
        }
        // The instants of all signals together can be in order although those of a single signal
        // are not.
        check_sampled_instants(scene, instants)?;
    }
    let inputs: Vec<&str> = signals.iter().map(|signal| signal.input).collect();
    let places = input_parameter_indices(mechanism, &inputs)?;
    let mut all: Vec<f64> = signals.iter().flat_map(|signal| signal.instants.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let value = |signal: &HeldSignal<'_>, place: &usize, t: f64| {
        let behind = signal.instants.partition_point(|instant| *instant <= t);
        behind.checked_sub(1).map_or(scene.parameters[*place], |at| signal.values[at])
    };
    let decide = || {
        |sample: &ControllerSample<'_>| {
            signals.iter().zip(&places).map(|(signal, at)| value(signal, at, sample.t)).collect()
        }
    };
    simulate_sampled(mechanism, scene, &inputs, &all, decide, by)
}

/// Runs a scene whose inputs are set by a controller at the given instants, s, and held constant until
/// the next instant. The controller is not called at an instant at the end of the span.
///
/// `controller` makes a controller, which returns a value for each of `inputs`, in its SI unit. Two
/// runs are made, each with a new controller. Their difference gives the estimated errors. `by` names
/// the equations; `None` takes the first formulation of the model.
///
/// # Errors
/// [`Error::Request`] in these cases:
/// - an input is unknown or has a formula;
/// - the instants are not in order, or are outside the span;
/// - the controller returns a wrong number of values, or a value that is not finite;
/// - the run goes backwards in time, uses quadrature or projection, or has impacts.
///
/// Otherwise the errors of [`simulate`](crate::simulate()).
pub fn simulate_sampled<C: FnMut(&ControllerSample<'_>) -> Vec<f64>>(
    mechanism: &Mechanism,
    scene: &Scene,
    inputs: &[&str],
    instants: &[f64],
    controller: impl Fn() -> C,
    by: Option<&EquationsName>,
) -> Result<SampledRun, Error> {
    let places = input_parameter_indices(mechanism, inputs)?;
    check_sampled_instants(scene, instants)?;
    check_integration(scene)?;
    let by = find_equations_or_first(mechanism, by)?;
    let code = runnable_code(mechanism, &by, scene.integration.distance, CodePreparation::preparation_for_runs(scene))?;
    let problem = Problem::new(mechanism, scene, &by, &code, None)?;
    let balance = WatchedFunctions::new(mechanism, mechanism, scene, &by)?;
    let shown = ShownQuantities::new(mechanism, scene)?;
    let loop_ = ControlLoop { problem: &problem, balance: &balance, places: &places, inputs, instants, shown: &shown };
    let start = problem.start()?;
    let options = integration_options(scene);
    let first = loop_.run(scene, &start, &options, &mut controller())?;
    let beside = Scene { parameters: parameters_one_rounding_away(scene), ..scene.clone() };
    let nearby: Vec<f64> = start.iter().map(|y| y * (1.0 + f64::EPSILON)).collect();
    let second = match first.stop {
        Stop::Interrupted => None,
        _ => Some(loop_.run(&beside, &nearby, &finer_loop_options(&options), &mut controller())?),
    };
    Ok(loop_.sampled_run(first, second.as_ref(), code.form()))
}

/// Indices of the named inputs among the parameters of a mechanism.
///
/// # Errors
/// [`Error::Request`] if an input is unknown, has a formula, or is named twice.
fn input_parameter_indices(mechanism: &Mechanism, inputs: &[&str]) -> Result<Vec<usize>, Error> {
    let mut places = Vec::new();
    for name in inputs {
        let known = mechanism.inputs.iter().map(|input| input.name.as_str());
        let Some(input) = mechanism.inputs.iter().find(|input| input.name == *name) else {
            return Err(Error::request(format!("the model has no input `{name}`"), nearest_name_advice(name, known)));
        };
        let at = mechanism.parameters.iter().position(|p| p.is_input && p.name == input.name);
        let Some(at) = at.filter(|_| input.is_parameter) else {
            let what = format!("the input `{name}` is a formula here");
            return Err(Error::request(
                what,
                "leave its formula out of the model and of the scene, or give it a number",
            ));
        };
        if places.contains(&at) {
            return Err(Error::request(format!("the input `{name}` is set twice"), "name each input once"));
        }
        places.push(at);
    }
    Ok(places)
}

/// Least distance of two instants at which inputs are set, in units of the rounding error of the
/// later instant. Closer instants leave no room for a step.
const ROUNDINGS: f64 = 64.0;

/// Checks the instants at which inputs are set. They must be inside the span, in order and not too
/// close to one another, and the run must go forwards in time.
///
/// # Errors
/// `Error::Request` if a check fails.
fn check_sampled_instants(scene: &Scene, instants: &[f64]) -> Result<(), Error> {
    let (from, to) = scene.span;
    if to < from {
        let help = "end the span after its start";
        return Err(Error::request("inputs need a run forwards in time, and this run goes backwards", help));
    }
    if let Some(t) = instants.iter().find(|t| !(from..=to).contains(*t)) {
        let what = format!("the instant {t} s is outside the run, from {from} s to {to} s");
        return Err(Error::request(what, "leave it out, or lengthen the span"));
    }
    let near = |pair: &&[f64]| pair[1] - pair[0] <= ROUNDINGS * f64::EPSILON * pair[1].abs().max(pair[0].abs());
    let first = instants.first().filter(|t| **t > from).map(|_| from);
    let last = instants.last().filter(|t| **t < to).map(|_| to);
    let ends: Vec<f64> = first.into_iter().chain(instants.iter().copied()).chain(last).collect();
    if let Some(pair) = ends.windows(2).find(near) {
        let what = if pair[1] > pair[0] {
            format!("the instants {} s and {} s are too near to each other for a step", pair[0], pair[1])
        } else {
            format!("the instants do not increase: {} s comes before {} s", pair[0], pair[1])
        };
        return Err(Error::request(what, "give each instant after the one before it"));
    }
    Ok(())
}

/// Checks that a scene can have inputs from outside. It must not use quadrature or projection, and must
/// have no impacts.
///
/// # Errors
/// `Error::Request` if the scene uses quadrature or projection, or has impacts.
fn check_integration(scene: &Scene) -> Result<(), Error> {
    let how = &scene.integration;
    if how.method == Integrator::Quadrature || how.project.is_some() {
        let what = "inputs change the energy: quadrature and projection are not possible";
        return Err(Error::request(what, "give a stepping method, without `project`"));
    }
    if !scene.impacts.is_empty() {
        let help = "run the scene by `simulate`, or leave its impacts out";
        return Err(Error::request("a scene with impacts cannot have inputs from outside", help));
    }
    Ok(())
}
