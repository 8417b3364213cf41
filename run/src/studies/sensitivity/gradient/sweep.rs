//! One backward sweep through the steps of a run, and across the changes of contacts between its parts.

use super::crossings::Crossings;
use super::held::Motion;
use super::numbers::{Number, moved};
use super::products::Tapes;
use super::stepped::{Part, Stepped};
use crate::error::Error;
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::Wide;
use crate::studies::sensitivity::equations::Equations;
use crate::studies::sensitivity::graze::near;
use crate::studies::sensitivity::shown::Quantities;
use crate::studies::sensitivity::way::Ending;
use tripos_sim::adjoint::{Adjoint, Course, Unswept, segments};
use tripos_sim::{Options, RightHandSide};

/// Quantity whose gradient is taken.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// The instant at which an event ends the run.
    End,
    /// One of [`Quantities::names`] at the end.
    Shown(usize),
}

/// Tapes, quantities and numbers that a sweep uses.
pub struct Through<'a> {
    pub tapes: &'a Tapes,
    pub quantities: &'a Quantities,
    pub numbers: &'a [Number],
    /// Equations with slopes, for scenes with contacts.
    pub equations: Option<&'a Equations>,
}

/// Derivatives of a target by the integrated state at the start and by each parameter, and the number of states kept
/// for them.
pub struct Swept {
    /// Derivatives by the state after the changes at the start.
    state: Vec<f64>,
    /// Derivatives by each parameter, then by each restitution and each coefficient of friction of the contacts.
    parameters: Vec<f64>,
    pub states: usize,
    /// Derivatives of the state at the start by each number, or the reason why there are none.
    starts: Vec<Result<Vec<f64>, String>>,
    /// Place on the way at which derivatives by all numbers end; `None` if there is none.
    pub ended: Option<Ending>,
    /// True if only some numbers may have derivatives, so that they must be checked one by one.
    pub asks: bool,
}

impl Swept {
    /// Derivative by the number of this index, and the size of the terms of its sum. Both are NaN where there is none.
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

    /// Reason why there is no derivative by the number of this index; `None` if none is known.
    pub fn missing(&self, at: usize) -> Option<String> {
        self.starts[at].as_ref().err().cloned().or_else(|| self.ended.as_ref().map(Ending::to_string))
    }
}

/// Sweeps a target backwards through the parts of a run.
///
/// Where an event ended a part, its last step is repeated with its actual length, by the method itself.
///
/// # Errors
/// [`Error::Interrupted`] if whoever follows ends it; [`Error::Stopped`] where a value does not exist.
pub fn sweep(
    problem: &Problem<'_>,
    through: &Through<'_>,
    target: Target,
    (options, run): (&Options, &Stepped),
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
        let held = contacts.as_ref().map(|(contacts, _)| (contacts, part.kept()));
        let mut motion = Motion::new(problem, through.tapes, held)?;
        let span = (part.t, problem.scene.span.1);
        let course = Course { span, y0: &part.y, ends: &part.ends, options: &options, moved: &moved };
        let adjoint = Adjoint::new(course, &mut motion, &segments(part.ends.len())).map_err(stopped)?;
        if at + 1 == run.parts.len() {
            let end = (run.solution.t_end, adjoint.end.as_slice());
            let what = (target, run.event());
            (swept.state, swept.parameters) = weights(problem, through.quantities, what, end, &mut motion)?;
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
    /// Begins a sweep of a run: derivatives of its start by each number.
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

    /// Adds the gradient of a part before which there are `before` others.
    fn add(&mut self, part: tripos_sim::adjoint::Gradient, before: usize) {
        self.state = part.state;
        self.states = self.states.max(part.states + before);
        let count = self.parameters.len().max(part.parameters.len());
        self.parameters.resize(count, 0.0);
        self.parameters.iter_mut().zip(&part.parameters).for_each(|(sum, share)| *sum += share);
    }
}

fn stopped(why: Unswept) -> Error {
    match why {
        Unswept::Interrupted => Error::Interrupted,
        why => Error::Stopped(why.to_string()),
    }
}

/// Derivatives of a target by the state at the end of a run, and directly by parameters. They are total ones where an
/// event g = 0 ends it, as its instant moves by dt = −(g_y dy + g_p dp)/(g_y f).
fn weights(
    problem: &Problem<'_>,
    quantities: &Quantities,
    (target, event): (Target, Option<usize>),
    (t, y): (f64, &[f64]),
    motion: &mut Motion<'_>,
) -> Result<(Vec<f64>, Vec<f64>), Error> {
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
