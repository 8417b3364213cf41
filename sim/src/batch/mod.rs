//! Many trajectories of one set of equations, side by side in vector registers, and on all cores.
//!
//! Each lane of the registers integrates a trajectory of its own, by DOP853 or by Taylor's method, with the steps that
//! [`crate::integrate`] would take, up to rounding: own time, step size, error, acceptance. A lane that is done takes
//! the next trajectory at once. The accepted steps of a lane are handed to the watcher of its trajectory, which looks
//! at events and divisors.
//!
//! Invariant: the outcome of a trajectory has the same bits whatever the others are, in whichever order, in how many
//! lanes and on how many cores. Absent on purpose: output on the way, corners in time, constraints.

mod dop853;
mod method;
mod queue;
mod taylor;
#[cfg(feature = "threads")]
mod threads;
mod watching;

#[cfg(feature = "threads")]
pub use threads::integrate_on_all_cores;
pub use watching::{Watched, Watching};

use tripos_traits::{AbsoluteTolerance, InLanes, Lanes, Method, Rates, Series};

use crate::driver::pace::Pace;
use crate::error::SimError;
use crate::events::EventRecord;
use crate::methods::options::{self, Options, Output};
use crate::methods::taylor::order_for;
use crate::solution::Stop;
use queue::Work;

/// One trajectory to be integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trajectory<'a> {
    /// Parameters in the order of the model file.
    pub parameters: &'a [f64],
    /// The state [q; v] at the start of the span.
    pub start: &'a [f64],
}

/// Settings by which all trajectories of a batch are integrated.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// [`Method::Dop853`] or [`Method::Taylor`].
    pub method: Method,
    /// The order of Taylor's method, as in [`Options::order`].
    pub order: Option<usize>,
    /// Start and end of the run, in s; the end may come first.
    pub span: (f64, f64),
    /// Relative tolerance, as in [`Options::rtol`].
    pub rtol: f64,
    /// Absolute tolerance, as in [`Options::atol`].
    pub atol: AbsoluteTolerance,
    /// Longest step, in s; the span unless given.
    pub max_step: Option<f64>,
    /// Largest number of attempted steps of one trajectory.
    pub step_limit: u64,
}

impl Plan {
    /// Options of a run of one of the trajectories by itself.
    #[must_use]
    pub fn options(&self) -> Options {
        Options {
            method: self.method,
            order: self.order,
            rtol: self.rtol,
            atol: self.atol.clone(),
            max_step: self.max_step,
            step_limit: self.step_limit,
            output: Output::Ends,
            ..Options::default()
        }
    }
}

/// Result of one trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Last time of the solution, in s.
    pub t_end: f64,
    /// State at `t_end`.
    pub y_end: Vec<f64>,
    /// Reason of the end of the run.
    pub stop: Stop,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations made for this trajectory. A step without a finite result counts in full: the other
    /// lanes go on to its end.
    pub evaluations: u64,
    /// Records of its events up to the end, in order of time.
    pub events: Vec<EventRecord>,
}

/// Equations in `N` lanes.
#[derive(Clone, Copy)]
pub struct Equations<'a, const N: usize> {
    /// Their rates.
    pub rates: &'a (dyn Rates<Lanes<N>> + Sync),
    /// Their Taylor coefficients, if there are any in so many lanes.
    pub series: Option<&'a (dyn Series<Lanes<N>> + Sync)>,
}

/// Integrates all trajectories on this thread, in as many lanes as the processor computes best in. Outcomes are in the
/// order of the trajectories. A trajectory that fails ends with its reason; the others go on.
///
/// # Errors
/// [`SimError`] if the question makes no sense, as for [`crate::integrate`], or the method is not had in lanes;
/// [`SimError::Trajectory`] for parameters or a start of the wrong length, or not finite.
pub fn integrate(
    equations: InLanes<'_>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<Vec<Outcome>, SimError> {
    integrate_watched(equations, plan, trajectories, None)
}

/// Integrates as [`integrate`] does, with a watcher of the events and the divisors of each trajectory.
///
/// # Errors
/// As for [`integrate`].
pub fn integrate_watched(
    equations: InLanes<'_>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
    watching: Option<&Watching<'_>>,
) -> Result<Vec<Outcome>, SimError> {
    match eight(equations, plan) {
        Some(equations) => integrate_in(equations, plan, trajectories, watching),
        None => integrate_in(four(equations), plan, trajectories, watching),
    }
}

fn four(equations: InLanes<'_>) -> Equations<'_, 4> {
    Equations { rates: equations.four, series: equations.series }
}

/// Eight lanes where the processor computes best in them, and the equations are had in them for this method.
fn eight<'a>(equations: InLanes<'a>, plan: &Plan) -> Option<Equations<'a, 8>> {
    let rates = equations.widest().filter(|_| plan.method == Method::Dop853)?;
    Some(Equations { rates, series: None })
}

/// Integrates all trajectories on this thread in `N` lanes; outcomes are those of [`integrate_watched`], to the bit.
///
/// # Errors
/// As for [`integrate`].
pub fn integrate_in<const N: usize>(
    equations: Equations<'_, N>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
    watching: Option<&Watching<'_>>,
) -> Result<Vec<Outcome>, SimError> {
    let (pace, way) = check(equations, plan, trajectories)?;
    let mut outcomes = Outcomes::new(trajectories.len());
    let mut waiting = 0..trajectories.len();
    let work = Work { trajectories, pace: &pace, limit: plan.step_limit, watching };
    way.run(&work, &mut || waiting.next(), &mut |index, outcome| outcomes.put(index, outcome));
    Ok(outcomes.all())
}

/// A method with the functions of the equations that it needs.
#[derive(Clone, Copy)]
enum Way<'a, const N: usize> {
    Dop853(&'a (dyn Rates<Lanes<N>> + Sync)),
    Taylor(taylor::Equations<'a, N>, usize),
}

impl<'a, const N: usize> Way<'a, N> {
    fn new(Equations { rates, series }: Equations<'a, N>, plan: &Plan) -> Result<Self, SimError> {
        match (plan.method, series) {
            (Method::Dop853, _) => Ok(Self::Dop853(rates)),
            (Method::Taylor, Some(series)) => {
                Ok(Self::Taylor(taylor::Equations { rates, series }, order_for(&plan.options())))
            }
            (method, _) => Err(SimError::NoLanes { method: method.name() }),
        }
    }

    /// Integrates the trajectories whose positions `next` hands out, and hands each outcome to `done`.
    fn run(self, work: &Work<'_, '_>, next: &mut dyn FnMut() -> Option<usize>, done: &mut dyn FnMut(usize, Outcome)) {
        match self {
            Self::Dop853(rates) => queue::run(dop853::Dop853::new(rates), work, next, done),
            Self::Taylor(equations, order) => queue::run(taylor::Taylor::new(equations, order), work, next, done),
        }
    }
}

/// Outcomes by the position of their trajectory.
struct Outcomes(Vec<Option<Outcome>>);

impl Outcomes {
    fn new(n: usize) -> Self {
        Self(vec![None; n])
    }

    fn put(&mut self, index: usize, outcome: Outcome) {
        self.0[index] = Some(outcome);
    }

    fn all(self) -> Vec<Outcome> {
        self.0
            .into_iter()
            .map(|outcome| outcome.expect("every trajectory was taken from the queue and ended"))
            .collect()
    }
}

/// Refuses plans that cannot be run. Returns the control of the steps with which every trajectory begins, and the
/// method.
fn check<'a, const N: usize>(
    equations: Equations<'a, N>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<(Pace, Way<'a, N>), SimError> {
    let way = Way::new(equations, plan)?;
    let lengths = equations.rates.lengths();
    let (options, n) = (plan.options(), lengths.state());
    options::check::<f64>(plan.span, &[], &options)?;
    let (pace, _) = Pace::new::<f64>(plan.span, n, &options)?;
    for (index, trajectory) in trajectories.iter().enumerate() {
        let parts = [
            ("parameters", "parameter", "", lengths.parameters, trajectory.parameters),
            ("the initial state", "component", " of the initial state", n, trajectory.start),
        ];
        for (what, one, of_what, expected, values) in parts {
            let of = |error| SimError::Trajectory { index, error: Box::new(error) };
            if values.len() != expected {
                return Err(of(SimError::Length { what, expected, found: values.len() }));
            }
            if let Some(i) = values.iter().position(|x| !x.is_finite()) {
                return Err(of(SimError::NotFinite { what: format!("{one} {i}{of_what}") }));
            }
        }
    }
    Ok((pace, way))
}
