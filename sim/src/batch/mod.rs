//! Many trajectories of one set of equations, side by side in vector registers, and on all cores.
//!
//! Each lane of the registers integrates a trajectory of its own, by DOP853 or by Taylor's method, with the steps that
//! [`crate::integrate`] would take, up to rounding: own time, step size, error, acceptance. A lane that is done takes
//! the next trajectory at once. The accepted steps of a lane are handed to the watcher of its trajectory, which looks
//! at events and divisors.
//!
//! Invariant: the outcome of a trajectory has the same bits whatever the other trajectories are, in any order, in any
//! number of lanes and on any number of cores. Absent on purpose: output during the run, corners in time, constraints.

mod dop853;
mod method;
mod queue;
mod taylor;
#[cfg(feature = "threads")]
mod threads;
mod watcher;

#[cfg(feature = "threads")]
pub use threads::integrate_on_all_cores;
pub use watcher::{Watched, Watching};

use tripos_traits::{AbsoluteTolerance, InLanes, Lanes, Method, Rates, Series};

use crate::driver::pace::Pace;
use crate::error::SimError;
use crate::events::EventRecord;
use crate::methods::options::{self, Options, Output};
use crate::methods::taylor::order_for;
use crate::solution::Stop;
use queue::Work;

/// A trajectory to be integrated: parameters and start.
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
    /// Method of integration: [`Method::Dop853`] or [`Method::Taylor`].
    pub method: Method,
    /// Order of Taylor's method, as in [`Options::order`].
    pub order: Option<usize>,
    /// Start and end of the run, s; the end may be before the start.
    pub span: (f64, f64),
    /// Relative tolerance, as in [`Options::rtol`].
    pub rtol: f64,
    /// Absolute tolerance, as in [`Options::atol`].
    pub atol: AbsoluteTolerance,
    /// Longest step, s; `None` allows the whole span.
    pub max_step: Option<f64>,
    /// Largest number of attempted steps of one trajectory.
    pub step_limit: u64,
}

impl Plan {
    /// Options of a run of one trajectory alone.
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
    /// Last time of the solution, s.
    pub t_end: f64,
    /// State at `t_end`.
    pub y_end: Vec<f64>,
    /// Reason why the trajectory ended.
    pub stop: Stop,
    /// Number of accepted steps.
    pub steps: u64,
    /// Number of rejected steps.
    pub rejected: u64,
    /// Number of evaluations of the equations for this trajectory. A step without a finite result counts in full: the
    /// other lanes go on to its end.
    pub evaluations: u64,
    /// Records of the trajectory's events up to its end, in order of time.
    pub events: Vec<EventRecord>,
}

/// Equations of motion in `N` lanes.
#[derive(Clone, Copy)]
pub struct Equations<'a, const N: usize> {
    /// Rates of the state.
    pub rates: &'a (dyn Rates<Lanes<N>> + Sync),
    /// Taylor coefficients of the motion; `None` if the equations have none in `N` lanes.
    pub series: Option<&'a (dyn Series<Lanes<N>> + Sync)>,
}

/// Integrates all trajectories on this thread, in as many lanes as the processor computes best in. Outcomes are in the
/// order of the trajectories. A trajectory that fails ends with its reason; the others go on.
///
/// # Errors
/// [`SimError`] if the plan makes no sense, as for [`crate::integrate`], or if the method does not exist in lanes;
/// [`SimError::Trajectory`] for parameters or a start of the wrong length, or not finite.
pub fn integrate(
    equations: InLanes<'_>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<Vec<Outcome>, SimError> {
    integrate_watched(equations, plan, trajectories, None)
}

/// Integrates all trajectories as [`integrate`] does, with a watcher of the events and the divisors of each.
///
/// # Errors
/// [`SimError`], as for [`integrate`].
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

/// Equations in eight lanes; `None` if the processor computes better in four, or the equations and the method do not
/// exist in eight.
fn eight<'a>(equations: InLanes<'a>, plan: &Plan) -> Option<Equations<'a, 8>> {
    let rates = equations.widest().filter(|_| plan.method == Method::Dop853)?;
    Some(Equations { rates, series: None })
}

/// Integrates all trajectories on this thread in `N` lanes; outcomes have the same bits as those of
/// [`integrate_watched`].
///
/// # Errors
/// [`SimError`], as for [`integrate`].
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

/// A method of integration, with the functions of the equations that it needs.
#[derive(Clone, Copy)]
enum LaneMethod<'a, const N: usize> {
    Dop853(&'a (dyn Rates<Lanes<N>> + Sync)),
    Taylor(taylor::Equations<'a, N>, usize),
}

impl<'a, const N: usize> LaneMethod<'a, N> {
    fn new(Equations { rates, series }: Equations<'a, N>, plan: &Plan) -> Result<Self, SimError> {
        match (plan.method, series) {
            (Method::Dop853, _) => Ok(Self::Dop853(rates)),
            (Method::Taylor, Some(series)) => {
                Ok(Self::Taylor(taylor::Equations { rates, series }, order_for(&plan.options())))
            }
            (method, _) => Err(SimError::NoLanes { method: method.name() }),
        }
    }

    /// Integrates the trajectories whose positions `next` hands out, and hands the outcome of each to `done`.
    fn run(self, work: &Work<'_, '_>, next: &mut dyn FnMut() -> Option<usize>, done: &mut dyn FnMut(usize, Outcome)) {
        match self {
            Self::Dop853(rates) => queue::run(dop853::Dop853::new(rates), work, next, done),
            Self::Taylor(equations, order) => queue::run(taylor::Taylor::new(equations, order), work, next, done),
        }
    }
}

/// Outcomes of trajectories, by the position of the trajectory.
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

/// Refuses plans that cannot be run. Returns the method, and the step control with which every trajectory begins.
fn check<'a, const N: usize>(
    equations: Equations<'a, N>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<(Pace, LaneMethod<'a, N>), SimError> {
    let way = LaneMethod::new(equations, plan)?;
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
