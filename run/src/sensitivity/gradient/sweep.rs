//! A run with its steps, and one sweep backwards through them.

use super::numbers::{Number, moved};
use super::products::{Products, Tapes};
use crate::error::{Error, refused};
use crate::power::accounted;
use crate::problem::Problem;
use crate::sensitivity::shown::Quantities;
use tripos_sim::adjoint::{Adjoint, Course, Unswept, segments};
use tripos_sim::{Accompanied, Event, Lent, Options, RightHandSide, Solution, Stop, integrate};

/// A run, and where each of its steps ends.
pub struct Stepped {
    pub solution: Solution,
    pub ends: Vec<f64>,
}

impl Stepped {
    /// The run of a problem from the integrated state `y0` as [`Problem::solve`] makes it, which is told where steps end when it is asked after each whether others take over.
    ///
    /// # Errors
    /// [`Error::Request`] if the question makes no sense.
    pub fn new(problem: &Problem<'_>, y0: &[f64], options: &Options, events: &mut [Event<'_>]) -> Result<Self, Error> {
        let refuse = |error| refused(problem.scene, &error);
        let mut rhs = problem.right_hand_side().map_err(refuse)?;
        let mut power = accounted(problem)?;
        let mut ends = Vec::new();
        let mut note = |t: f64, y: Option<&[f64]>| {
            ends.extend(y.map(|_| t));
            false
        };
        let mut with = Accompanied {
            rhs: rhs.as_mut(),
            power: power.as_mut().map(|power| power.as_mut() as _),
            over: Some(&mut note),
            avoided: None,
        };
        let lent = Lent(&mut with as &mut dyn RightHandSide<f64>);
        let options = problem.options(options);
        let solution = integrate(lent, problem.scene.span, y0, &options, events).map_err(refuse)?;
        // The last step is told of nobody: it ends the run, at its end or, by an event, inside.
        let last = ends.last().unwrap_or(&problem.scene.span.0);
        if last.total_cmp(&solution.t_end).is_ne() {
            ends.push(solution.t_end);
        }
        Ok(Self { solution, ends })
    }

    /// The place of the event that ended the run.
    pub fn event(&self) -> Option<usize> {
        let is_event = matches!(self.solution.stop, Stop::Event { .. } | Stop::LeftDomain { .. });
        let last = self.solution.events.iter().rfind(|event| event.terminal);
        last.filter(|_| is_event).map(|event| event.event)
    }
}

/// What a gradient is of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// The instant at which an event ends the run.
    End,
    /// One of [`Quantities::names`] at the end.
    Shown(usize),
}

/// The derivatives of a target by the integrated state at the start and by each parameter, and how many states were kept for them.
pub struct Swept {
    pub state: Vec<f64>,
    pub parameters: Vec<f64>,
    pub states: usize,
}

impl Swept {
    /// The derivative by a number, and the size of what it is the sum of; not numbers where there is none.
    pub fn by(&self, number: &Number) -> (f64, f64) {
        let Ok(seed) = &number.seed else { return (f64::NAN, f64::NAN) };
        let shares = [(&self.state, &seed.state), (&self.parameters, &seed.parameters)];
        // What a number does not change counts for nothing, whatever its share would be.
        let terms = shares.iter().flat_map(|(shares, slopes)| shares.iter().zip(*slopes));
        let terms = terms.filter(|(_, slope)| **slope != 0.0).map(|(share, slope)| share * slope);
        terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()))
    }
}

/// Sweeps a target backwards through the steps of a run from the integrated state `y0`.
///
/// Where an event ended the run the last step is made as long as it went, by the method itself.
///
/// # Errors
/// [`Error::Interrupted`] if whoever follows ends it; [`Error::Stopped`] where a value does not exist.
pub fn sweep(
    problem: &Problem<'_>,
    (tapes, quantities): (&Tapes, &Quantities),
    target: Target,
    (y0, options, run): (&[f64], &Options, &Stepped),
) -> Result<Swept, Error> {
    let mut rhs = Products::new(problem, tapes)?;
    let options = problem.options(options);
    let moved = moved(problem);
    let course = Course { span: problem.scene.span, y0, ends: &run.ends, options: &options, moved: &moved };
    let adjoint = Adjoint::new(course, &mut rhs, &segments(run.ends.len())).map_err(stopped)?;
    let t = run.solution.t_end;
    let at = (t, adjoint.end.as_slice());
    let weights = weights(problem, quantities, (target, run.event()), at, &mut rhs)?;
    let swept = adjoint.pull(&mut rhs, &weights.state).map_err(stopped)?;
    let parameters = swept.parameters.iter().zip(&weights.parameters).map(|(by_run, by_end)| by_run + by_end);
    Ok(Swept { state: swept.state, parameters: parameters.collect(), states: swept.states })
}

fn stopped(why: Unswept) -> Error {
    match why {
        Unswept::Interrupted => Error::Interrupted,
        why => Error::Stopped(why.to_string()),
    }
}

/// The derivatives of a target by the state at the end and by parameters directly.
struct Weights {
    state: Vec<f64>,
    parameters: Vec<f64>,
}

/// Those of a target at the end of a run: total ones where an event g = 0 ends it, as its instant moves by dt = −(g_y dy + g_p dp)/(g_y f).
fn weights(
    problem: &Problem<'_>,
    quantities: &Quantities,
    (target, event): (Target, Option<usize>),
    (t, y): (f64, &[f64]),
    rhs: &mut Products<'_>,
) -> Result<Weights, Error> {
    let place = quantities.place(problem, t, y)?;
    let count = problem.scene.parameters.len();
    let still = (vec![0.0; count], vec![0.0; y.len()]);
    let flow = match event {
        Some(_) => {
            let mut rates = vec![0.0; y.len()];
            rhs.rhs(t, y, &mut rates).map_err(|failure| stopped(failure.into()))?;
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
    Ok(Weights {
        state: (0..y.len()).map(|i| along(&still.0, &unit(y.len(), i))).collect(),
        parameters: (0..count).map(|j| along(&unit(count, j), &still.1)).collect(),
    })
}
