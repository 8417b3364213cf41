//! Inputs that are set from outside a run and held between instants: recorded signals, and controllers that sample the state.
//!
//! The run is made in windows, one from each instant to the next. An input is a parameter of the equations in each of them, so that no
//! step and no stage of one sees two values of it: a window ends exactly at its instant, and the next begins there. Nothing in it is of
//! a method or of a kind of code, and the same controller gives the same bits.
//!
//! The errors are told by a second run that is made in finer steps and asks a controller of its own, made anew: its decisions follow from
//! its own states, so that what they amplify is in what the two differ by.
//! K. J. Åström & B. Wittenmark, *Computer-Controlled Systems*, 3rd edition (1997), § 2.3 (zero-order hold).

mod windows;

use crate::code::{Form, Ready, by_or_first, code};
use crate::digits::other_side;
use crate::error::Error;
use crate::how::options;
use crate::mechanism::Mechanism;
use crate::problem::Problem;
use crate::shown::state_names;
use crate::watched::Balance;
use tripos_derive::diagnostic::nearest;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{QUADRATURE, Scene};
use tripos_sim::{EventRecord, Stop};
use windows::{Loop, finer};

/// What a controller sees at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// The instant, s.
    pub t: f64,
    /// The place of the instant among all, from 0.
    pub index: usize,
    /// The names of coordinates, then of generalized speeds.
    pub names: &'a [String],
    /// Their values, in SI units.
    pub state: &'a [f64],
}

impl Sample<'_> {
    /// The value of a coordinate or a generalized speed; nothing if there is none of this name.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        self.names.iter().position(|known| known == name).map(|at| self.state[at])
    }
}

/// A recorded signal: from each instant on, an input has the value of the same place.
#[derive(Clone, Copy, Debug)]
pub struct Held<'a> {
    /// The name of the input.
    pub input: &'a str,
    /// Instants, s, each after the one before it. Before the first the input has the value of the scene.
    pub instants: &'a [f64],
    /// As many values, in the SI unit of the input.
    pub values: &'a [f64],
}

/// The values of inputs from an instant on.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// The instant, s.
    pub t: f64,
    /// A value for each input, in the order of [`SampledRun::inputs`].
    pub values: Vec<f64>,
    /// What is shown of the state there, in the order of [`SampledRun::names`].
    pub state: Vec<f64>,
    /// The estimated error of each of these, in its unit; nothing where the second run did not get there.
    pub errors: Option<Vec<f64>>,
}

/// What came out of a run whose inputs were set from outside.
#[derive(Clone, Debug)]
pub struct SampledRun {
    /// Which equations ran.
    pub by: By,
    /// What ran them.
    pub code: Form,
    /// The inputs that were set.
    pub inputs: Vec<String>,
    /// What is shown of a state: coordinates, then generalized speeds.
    pub names: Vec<String>,
    /// Instants of the samples, s.
    pub t: Vec<f64>,
    /// What is shown at each of them.
    pub states: Vec<Vec<f64>>,
    /// What was decided, in order.
    pub decisions: Vec<Decision>,
    /// Events and conditions of the domain that the run met, in order.
    pub events: Vec<EventRecord>,
    /// The end of the run, s.
    pub t_end: f64,
    /// What is shown there.
    pub end: Vec<f64>,
    /// The estimated error of each value at the end, in its unit; nothing where the second run did not get there.
    pub errors_at_end: Option<Vec<f64>>,
    /// Accepted and rejected steps.
    pub steps: (u64, u64),
    /// Why it ended.
    pub stop: Stop,
    /// What a reader must know before trusting the numbers.
    pub warnings: Vec<String>,
}

impl SampledRun {
    /// The values of what is shown under this name, at each sample.
    ///
    /// # Errors
    /// [`Error::Request`] if nothing of this name is shown.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Error> {
        let at = self.names.iter().position(|shown| shown == name).ok_or_else(|| {
            let help = nearest(name, self.names.iter().map(String::as_str));
            Error::request(format!("the run shows no `{name}`"), help)
        })?;
        Ok(self.states.iter().map(|values| values[at]).collect())
    }
}

/// Runs a scene with recorded signals for some of its inputs.
///
/// # Errors
/// As [`simulate_sampled`]; [`Error::Request`] for signals without as many values as instants.
pub fn simulate_held(
    mechanism: &Mechanism,
    scene: &Scene,
    signals: &[Held<'_>],
    by: Option<&str>,
) -> Result<SampledRun, Error> {
    for Held { input, instants, values } in signals {
        if instants.len() != values.len() {
            let what = format!("`{input}` has {} instants and {} values", instants.len(), values.len());
            return Err(Error::request(what, "give as many values as instants"));
        }
        // All instants together may be in order where those of one signal are not.
        check_instants(scene, instants)?;
    }
    let inputs: Vec<&str> = signals.iter().map(|signal| signal.input).collect();
    let places = places(mechanism, &inputs)?;
    let mut all: Vec<f64> = signals.iter().flat_map(|signal| signal.instants.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let value = |signal: &Held<'_>, place: &usize, t: f64| {
        let behind = signal.instants.partition_point(|instant| *instant <= t);
        behind.checked_sub(1).map_or(scene.parameters[*place], |at| signal.values[at])
    };
    let decide =
        || |sample: &Sample<'_>| signals.iter().zip(&places).map(|(signal, at)| value(signal, at, sample.t)).collect();
    simulate_sampled(mechanism, scene, (&inputs, &all), decide, by)
}

/// Runs a scene whose inputs of these names are set at these instants by a controller, and held until the next. It is made
/// once for each run, of which there are two, and gives a value for each input, in its SI unit.
///
/// At an instant that is the end of the span nothing is decided.
///
/// # Errors
/// [`Error::Request`] for inputs that are none or that the scene gives formulas, instants that are not in order or outside the span, a
/// decision with another number of values or one that is not finite, a run backwards, by quadrature or projected; otherwise as
/// [`simulate`](crate::simulate()).
pub fn simulate_sampled<C: FnMut(&Sample<'_>) -> Vec<f64>>(
    mechanism: &Mechanism,
    scene: &Scene,
    (inputs, instants): (&[&str], &[f64]),
    controller: impl Fn() -> C,
    by: Option<&str>,
) -> Result<SampledRun, Error> {
    let places = places(mechanism, inputs)?;
    check_instants(scene, instants)?;
    check_integration(scene)?;
    let by = by_or_first(mechanism, by)?;
    let code = code(mechanism, &by, scene.integration.distance, Ready::for_runs(scene)?)?;
    let problem = Problem::new(mechanism, scene, &by, &code, None)?;
    let balance = Balance::new(mechanism, mechanism, scene, &by)?;
    let names = state_names(mechanism);
    let loop_ = Loop { problem: &problem, balance: &balance, places: &places, inputs, instants, names: &names };
    let start = problem.start()?;
    let options = options(scene)?;
    let first = loop_.run(scene, &start, &options, &mut controller())?;
    let beside = Scene { parameters: other_side(scene), ..scene.clone() };
    let nearby: Vec<f64> = start.iter().map(|y| y * (1.0 + f64::EPSILON)).collect();
    let second = match first.stop {
        Stop::Interrupted => None,
        _ => Some(loop_.run(&beside, &nearby, &finer(&options), &mut controller())?),
    };
    Ok(loop_.told(first, second.as_ref(), code.form()))
}

/// The places of inputs among the parameters.
fn places(mechanism: &Mechanism, inputs: &[&str]) -> Result<Vec<usize>, Error> {
    let mut places = Vec::new();
    for name in inputs {
        let known = mechanism.inputs.iter().map(|input| input.name.as_str());
        let Some(input) = mechanism.inputs.iter().find(|input| input.name == *name) else {
            return Err(Error::request(format!("the model has no input `{name}`"), nearest(name, known)));
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

/// Instants nearer to each other than so many roundings leave no room for a step.
const ROUNDINGS: f64 = 64.0;

fn check_instants(scene: &Scene, instants: &[f64]) -> Result<(), Error> {
    let (from, to) = scene.span;
    if to < from {
        let help = "end the span after its start";
        return Err(Error::request("inputs are decided as time goes on, and this run goes back in it", help));
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

fn check_integration(scene: &Scene) -> Result<(), Error> {
    let how = &scene.integration;
    if how.method == QUADRATURE || how.project.is_some() {
        let what = "inputs that are set from outside change the energy: no quadrature and no projection onto it";
        return Err(Error::request(what, "give a stepping method, without `project`"));
    }
    if !scene.impacts.is_empty() {
        let help = "run the scene by `simulate`, or leave its impacts out";
        return Err(Error::request("inputs that are set from outside are not run together with impacts", help));
    }
    Ok(())
}
