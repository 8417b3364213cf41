//! Integration of many trajectories of the same equations in the lanes of vector registers, and on all
//! cores.
//!
//! Each lane of a register integrates a trajectory, by DOP853 or by Taylor's method, with the steps
//! that [`crate::integrate`] would take, up to rounding. It has its own time, step size, error and
//! acceptance. A lane whose trajectory ends takes the next trajectory at once. The accepted steps of a
//! lane are examined by the watcher of its trajectory, for events and divisors.
//!
//! Invariant: the outcome of a trajectory has the same bits whatever the other trajectories are, in any
//! order, in any number of lanes and on any number of cores. Absent on purpose: output during the run,
//! corners in time, constraints.

mod dop853_in_lanes;
mod lane_method;
mod lane_queue;
mod lane_run;
mod taylor_in_lanes;
#[cfg(feature = "threads")]
mod threads;
mod trajectory_watcher;

#[cfg(feature = "threads")]
pub use threads::integrate_on_all_cores;
pub use trajectory_watcher::{WatchOfTrajectory, WatchedTrajectory};

use tripos_traits::{AbsoluteTolerance, InLanes, Lanes, Method, Rates, Series};

use crate::driver::step_control::StepControl;
use crate::error::SimError;
use crate::events::EventRecord;
use crate::methods::run_options::{self, Options, OutputOption};
use crate::methods::taylor::taylor_order;
use crate::solution::Stop;
use lane_queue::BatchWork;

/// Trajectory that is to be integrated: its parameters and its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trajectory<'a> {
    /// Values of the parameters, in the order of the model file.
    pub parameters: &'a [f64],
    /// State (q, v) at the start of the span.
    pub start: &'a [f64],
}

/// Settings of a batch: method, span and tolerances with which all its trajectories are integrated.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchPlan {
    /// Method of integration: [`Method::Dop853`] or [`Method::Taylor`].
    pub method: Method,
    /// Order of Taylor's method, from 2 to 60; `None` derives it from the tolerances, as in
    /// [`Options::order`].
    pub order: Option<usize>,
    /// Start and end time of all trajectories, s; the end may be before the start.
    pub span: (f64, f64),
    /// Relative tolerance of the error of a step, as in [`Options::rtol`].
    pub rtol: f64,
    /// Absolute tolerance of the error of a step, in the units of the state, as in [`Options::atol`].
    pub atol: AbsoluteTolerance,
    /// Largest size of a step, s. `None` allows the whole span for DOP853 and a tenth of it for Taylor's
    /// method.
    pub max_step: Option<f64>,
    /// Largest number of attempted steps of a single trajectory.
    pub step_limit: u64,
}

impl BatchPlan {
    /// Options of a run that integrates a single trajectory with the settings of this plan.
    #[must_use]
    pub fn options(&self) -> Options {
        Options {
            method: self.method,
            order: self.order,
            rtol: self.rtol,
            atol: self.atol.clone(),
            max_step: self.max_step,
            step_limit: self.step_limit,
            output: OutputOption::Ends,
            ..Options::default()
        }
    }
}

/// Result of a single trajectory of a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchOutcome {
    /// Time at which the trajectory ends, s.
    pub t_end: f64,
    /// State at the end of the trajectory, at time `t_end`.
    pub y_end: Vec<f64>,
    /// Reason why the trajectory ended, such as its span or an event.
    pub stop: Stop,
    /// Number of accepted steps of the trajectory.
    pub steps: u64,
    /// Number of rejected steps of the trajectory.
    pub rejected: u64,
    /// Number of evaluations of the equations for this trajectory. A step without a finite result counts in
    /// full, since the other lanes continue to its end.
    pub evaluations: u64,
    /// Events of the trajectory up to its end, in the order in which they happened.
    pub events: Vec<EventRecord>,
}

/// Equations of motion that are evaluated in `N` lanes at once.
#[derive(Clone, Copy)]
pub struct Equations<'a, const N: usize> {
    /// Function that gives the rates of the state (q, v) in N lanes.
    pub rates: &'a (dyn Rates<Lanes<N>> + Sync),
    /// Function that gives Taylor coefficients of the motion; `None` if the equations have none in `N`
    /// lanes.
    pub series: Option<&'a (dyn Series<Lanes<N>> + Sync)>,
}

/// Integrates all trajectories on this thread, in the number of lanes that the processor handles best.
/// The outcomes are in the order of the trajectories. A trajectory that fails ends with its reason; the
/// others continue.
///
/// # Errors
/// [`SimError`] if the plan is invalid, as for [`crate::integrate`], or if the method does not exist in
/// lanes; [`SimError::Trajectory`] for parameters or a start of the wrong length, or not finite.
pub fn integrate_batch(
    equations: InLanes<'_>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
) -> Result<Vec<BatchOutcome>, SimError> {
    integrate_watched(equations, plan, trajectories, None)
}

/// Integrates all trajectories like [`integrate_batch`]. `watching` gives the events and divisors to watch in each
/// trajectory; `None` watches nothing.
///
/// # Errors
/// [`SimError`] in the cases in which [`integrate_batch`] returns it.
pub fn integrate_watched(
    equations: InLanes<'_>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
    watching: Option<&WatchOfTrajectory<'_>>,
) -> Result<Vec<BatchOutcome>, SimError> {
    match equations_in_eight_lanes(equations, plan) {
        Some(equations) => integrate_in_lanes(equations, plan, trajectories, watching),
        None => integrate_in_lanes(equations_in_four_lanes(equations), plan, trajectories, watching),
    }
}

/// Selects the functions of the equations that are evaluated in four lanes.
fn equations_in_four_lanes(equations: InLanes<'_>) -> Equations<'_, 4> {
    Equations { rates: equations.four, series: equations.series }
}

/// Selects the functions of the equations that are evaluated in eight lanes. `None` if the processor handles four lanes
/// better, or if the equations or the method do not exist in eight.
fn equations_in_eight_lanes<'a>(equations: InLanes<'a>, plan: &BatchPlan) -> Option<Equations<'a, 8>> {
    let rates = equations.widest().filter(|_| plan.method == Method::Dop853)?;
    Some(Equations { rates, series: None })
}

/// Integrates all trajectories on this thread in `N` lanes. The outcomes have the same bits as those of
/// [`integrate_watched`].
///
/// # Errors
/// [`SimError`] in the cases in which [`integrate_batch`] returns it.
pub fn integrate_in_lanes<const N: usize>(
    equations: Equations<'_, N>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
    watching: Option<&WatchOfTrajectory<'_>>,
) -> Result<Vec<BatchOutcome>, SimError> {
    let (pace, way) = check_batch(equations, plan, trajectories)?;
    let mut outcomes = BatchOutcomes::new(trajectories.len());
    let mut waiting = 0..trajectories.len();
    let work = BatchWork { trajectories, pace: &pace, limit: plan.step_limit, watching };
    way.run(&work, &mut || waiting.next(), &mut |index, outcome| outcomes.store_outcome(index, outcome));
    Ok(outcomes.all_outcomes())
}

/// Method of integration in lanes, with the functions of the equations that it needs.
#[derive(Clone, Copy)]
enum BatchMethod<'a, const N: usize> {
    /// The method DOP853, with the rates of the equations in lanes.
    Dop853(&'a (dyn Rates<Lanes<N>> + Sync)),
    /// Taylor's method, with the equations in lanes and the order of the polynomials.
    Taylor(taylor_in_lanes::Equations<'a, N>, usize),
}

impl<'a, const N: usize> BatchMethod<'a, N> {
    /// Selects the method of the plan. Error if these equations do not support the method in lanes.
    fn new(Equations { rates, series }: Equations<'a, N>, plan: &BatchPlan) -> Result<Self, SimError> {
        match (plan.method, series) {
            (Method::Dop853, _) => Ok(Self::Dop853(rates)),
            (Method::Taylor, Some(series)) => {
                Ok(Self::Taylor(taylor_in_lanes::Equations { rates, series }, taylor_order(&plan.options())))
            }
            (method, _) => Err(SimError::NoLanes { method: method.name() }),
        }
    }

    /// Integrates trajectories until `next` returns `None` instead of the index of a trajectory. `done` is called with
    /// each index and its outcome.
    fn run(
        self,
        work: &BatchWork<'_, '_>,
        next: &mut dyn FnMut() -> Option<usize>,
        done: &mut dyn FnMut(usize, BatchOutcome),
    ) {
        match self {
            Self::Dop853(rates) => lane_queue::run(dop853_in_lanes::Dop853::new(rates), work, next, done),
            Self::Taylor(equations, order) => {
                lane_queue::run(taylor_in_lanes::Taylor::new(equations, order), work, next, done);
            }
        }
    }
}

/// Outcomes of a batch, in the order of the trajectories; `None` for a trajectory that has not ended.
struct BatchOutcomes(Vec<Option<BatchOutcome>>);

impl BatchOutcomes {
    /// Creates the list for a batch of `n` trajectories, none of which has ended.
    fn new(n: usize) -> Self {
        Self(vec![None; n])
    }

    /// Stores the outcome of the trajectory with this index.
    fn store_outcome(&mut self, index: usize, outcome: BatchOutcome) {
        self.0[index] = Some(outcome);
    }

    /// Returns the outcomes of all trajectories. Panics if a trajectory has not ended.
    fn all_outcomes(self) -> Vec<BatchOutcome> {
        self.0
            .into_iter()
            .map(|outcome| outcome.expect("every trajectory was taken from the queue and ended"))
            .collect()
    }
}

/// Refuses a plan or trajectories that cannot be run. Returns the step control with which each trajectory begins, and
/// the method of integration.
fn check_batch<'a, const N: usize>(
    equations: Equations<'a, N>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
) -> Result<(StepControl, BatchMethod<'a, N>), SimError> {
    let way = BatchMethod::new(equations, plan)?;
    let lengths = equations.rates.lengths();
    let (options, n) = (plan.options(), lengths.state());
    run_options::check_options::<f64>(plan.span, &[], &options)?;
    let (pace, _) = StepControl::new::<f64>(plan.span, n, &options)?;
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
