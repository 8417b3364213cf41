//! Backward sweep through the steps of a run, and across the changes of contacts between its parts.

use super::crossings::Crossings;
use super::held_contacts::{HeldOf, Motion};
use super::numbers::{Number, moved};
use super::products::Tapes;
use super::recorded_steps::{Part, Stepped};
use crate::error::Error;
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::Wide;
use crate::studies::sensitivity::equations::Equations;
use crate::studies::sensitivity::graze::near;
use crate::studies::sensitivity::history::Ending;
use crate::studies::sensitivity::shown_quantities::Quantities;
use tripos_sim::adjoint::{Adjoint, Course, Unswept, segments};
use tripos_sim::{Options, RightHandSide};

/// Quantity at the end of a run whose gradient is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Instant at which an event ends the run.
    End,
    /// Shown quantity at the end, by its index in [`Quantities::names`].
    Shown(usize),
}

/// Tapes, quantities and numbers that a backward sweep uses.
pub struct Through<'a> {
    pub tapes: &'a Tapes,
    pub quantities: &'a Quantities,
    pub numbers: &'a [Number],
    /// Equations that compute with slopes; `None` for scenes without contacts.
    pub equations: Option<&'a Equations>,
}

/// Derivatives of a target with respect to the integrated state at the start of a run and by each parameter.
pub struct Swept {
    /// Derivatives of the target with respect to the state at the start, after contacts have changed there.
    state: Vec<f64>,
    /// Derivatives of the target by each parameter, then by each restitution and each coefficient of friction of the
    /// contacts.
    parameters: Vec<f64>,
    /// Largest number of states that the sweep kept at once.
    pub states: usize,
    /// Derivatives of the state at the start by each number, or the reason why there are none.
    starts: Vec<Result<Vec<f64>, String>>,
    /// Instant and reason of the end of the derivatives with respect to all numbers; `None` if they reach the start.
    pub ended: Option<Ending>,
    /// True if possibly only some numbers have derivatives, so that each must be checked.
    pub asks: bool,
}

impl Swept {
    /// Derivative of the target with respect to the number with the index `at`, and the size of the terms of its sum.
    /// Both are NaN if there is no derivative.
    pub fn by(&self, at: usize, number: &Number) -> (f64, f64) {
        let (Ok(seed), Ok(start), None) = (&number.seed, &self.starts[at], &self.ended) else {
            return (f64::NAN, f64::NAN);
        };
        let slopes = start.iter().chain(&seed.parameters).chain(&seed.restitutions).chain(&seed.frictions);
        // A slope of zero adds nothing, even if the other factor is not finite.
        let terms = self.state.iter().chain(&self.parameters).zip(slopes).filter(|(_, slope)| **slope != 0.0);
        let terms = terms.map(|(share, slope)| share * slope);
        terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()))
    }

    /// Reason why there is no derivative with respect to the number with the index `at`; `None` if no reason is known.
    pub fn missing(&self, at: usize) -> Option<String> {
        self.starts[at].as_ref().err().cloned().or_else(|| self.ended.as_ref().map(Ending::to_string))
    }
}

/// Sweeps a target backwards through the parts of a run.
///
/// If an event ended a part, the last step of the part is repeated with its actual length, by the method itself.
///
/// # Errors
/// [`Error::Interrupted`] if the observer ends the work; [`Error::Stopped`] if a value does not exist.
pub fn sweep(
    problem: &Problem<'_>,
    through: &Through<'_>,
    target: Target,
    options: &Options,
    run: &Stepped,
) -> Result<Swept, Error> {
    let options = problem.options(options);
    let contacts = through.equations.map(|equations| (problem.contacts(), equations));
    let crossings = contacts.as_ref().map(|(contacts, equations)| Crossings {
        problem,
        contacts,
        wide: Wide::new(contacts, problem.code.extended(), near(&options)),
        equations,
        corners: &options.corners,
    });
    let moved = moved(problem);
    let mut swept = Swept::new(through.numbers, crossings.as_ref(), run);
    swept.asks |= run.is_near;
    for (at, part) in run.parts.iter().enumerate().rev() {
        let held = contacts.as_ref().map(|(contacts, _)| HeldOf { contacts, kept: part.kept() });
        let mut motion = Motion::new(problem, through.tapes, held)?;
        let span = (part.t, problem.scene.span.1);
        let course = Course { span, y0: &part.y, ends: &part.ends, options: &options, moved: &moved };
        let adjoint = Adjoint::new(course, &mut motion, &segments(part.ends.len())).map_err(stopped)?;
        if at + 1 == run.parts.len() {
            let end = RunEnd { t: run.solution.t_end, y: &adjoint.end, event: run.event() };
            (swept.state, swept.parameters) = weights(problem, through.quantities, target, &end, &mut motion)?;
        }
        let by_part = adjoint.pull(&mut motion, &swept.state).map_err(stopped)?;
        swept.add(by_part, at);
        if let (Some(crossings), true) = (&crossings, at > 0) {
            match crossings.back(part, (&mut swept.state, &mut swept.parameters)) {
                Ok(asks) => swept.asks |= asks,
                Err(ending) => swept.ended = Some(ending),
            }
        }
        if swept.ended.is_some() {
            break;
        }
    }
    Ok(swept)
}

impl Swept {
    /// Begins a sweep of a run with the derivatives of its start by each number.
    fn new(numbers: &[Number], crossings: Option<&Crossings<'_>>, run: &Stepped) -> Self {
        let mut asks = false;
        let begins = crossings.zip(run.parts.first().and_then(Part::crossing));
        let start = |number: &Number| {
            let seed = number.seed.as_ref().map_err(Clone::clone)?;
            let Some((crossings, crossing)) = &begins else { return Ok(seed.state.clone()) };
            let known = crossings.at(crossing, |crossed| {
                asks |= crossed.shares();
                crossed.across(&seed.varied(), &seed.state)
            });
            known.map(|(_, state)| state).map_err(|ending| ending.to_string())
        };
        let starts = numbers.iter().map(start).collect();
        Self { state: Vec::new(), parameters: Vec::new(), states: 0, starts, ended: None, asks }
    }

    /// Adds the gradient of a part of the run; `before` is the number of parts before it.
    fn add(&mut self, part: tripos_sim::adjoint::Gradient, before: usize) {
        self.state = part.state;
        self.states = self.states.max(part.states + before);
        let count = self.parameters.len().max(part.parameters.len());
        self.parameters.resize(count, 0.0);
        self.parameters.iter_mut().zip(&part.parameters).for_each(|(sum, share)| *sum += share);
    }
}

/// Error for a sweep that did not come to its end.
fn stopped(why: Unswept) -> Error {
    match why {
        Unswept::Interrupted => Error::Interrupted,
        why => Error::Stopped(why.to_string()),
    }
}

/// End of a run.
struct RunEnd<'a> {
    /// Instant of the end, s.
    t: f64,
    /// Integrated state at the end.
    y: &'a [f64],
    /// Index of the event that ended the run; `None` if no event did.
    event: Option<usize>,
}

/// Derivatives of a target with respect to the state at the end of a run, and directly by parameters. They are total
/// ones if an event g = 0 ends the run, as its instant moves by dt = −(g_y dy + g_p dp)/(g_y f).
fn weights(
    problem: &Problem<'_>,
    quantities: &Quantities,
    target: Target,
    end: &RunEnd<'_>,
    motion: &mut Motion<'_>,
) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let RunEnd { t, y, event } = *end;
    let place = quantities.place(problem, t, y)?;
    let count = problem.scene.parameters.len();
    let still = (vec![0.0; count], vec![0.0; y.len()]);
    let flow = match event {
        Some(_) => {
            let mut rates = vec![0.0; y.len()];
            motion.rhs(t, y, &mut rates).map_err(|failure| stopped(failure.into()))?;
            Some(quantities.slopes(&place, &still.0, &rates))
        }
        None => None,
    };
    let along = |parameters: &[f64], state: &[f64]| {
        let slopes = quantities.slopes(&place, parameters, state);
        let later = match (event, &flow) {
            (Some(event), Some(flow)) => -slopes.watched[event] / flow.watched[event],
            _ => 0.0,
        };
        match target {
            Target::End => later,
            Target::Shown(at) => slopes.shown[at] + flow.as_ref().map_or(0.0, |flow| flow.shown[at] * later),
        }
    };
    let unit = |length: usize, at: usize| (0..length).map(|i| f64::from(u8::from(i == at))).collect::<Vec<_>>();
    let state = (0..y.len()).map(|i| along(&still.0, &unit(y.len(), i))).collect();
    Ok((state, (0..count).map(|j| along(&unit(count, j), &still.1)).collect()))
}
