//! Many trajectories of one set of equations, side by side in vector registers, and on all cores.
//!
//! Each lane of the registers integrates a trajectory of its own, by DOP853 with the steps that
//! [`crate::integrate`] would take, up to rounding: own time, step size, error, acceptance. A lane that is done
//! takes the next trajectory at once.
//!
//! Invariant: the outcome of a trajectory has the same bits whatever the others are, in whichever order, in how many
//! lanes and on how many cores. Absent on purpose: events and output on the way. What is to watch a batch will be
//! handed the accepted step of one lane, as [`crate::events`] are.

mod method;
mod queue;
#[cfg(feature = "threads")]
mod threads;

#[cfg(feature = "threads")]
pub use threads::integrate_on_all_cores;

use tripos_traits::{AbsoluteTolerance, InLanes, Lanes, Method, Rates};

use crate::error::SimError;
use crate::options::{self, Options, Output};
use crate::pace::Pace;
use crate::solution::Stop;

/// One trajectory to be integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trajectory<'a> {
    /// Parameters in the order of the model file.
    pub parameters: &'a [f64],
    /// The state [q; v] at the start of the span.
    pub start: &'a [f64],
}

/// How all trajectories of a batch are integrated; the method is `dop853`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
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
    /// What a run of one of the trajectories by itself would be asked.
    #[must_use]
    pub fn options(&self) -> Options {
        Options {
            method: Method::Dop853,
            rtol: self.rtol,
            atol: self.atol.clone(),
            max_step: self.max_step,
            step_limit: self.step_limit,
            output: Output::Ends,
            ..Options::default()
        }
    }
}

/// How one trajectory ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Last time of the solution, in s.
    pub t_end: f64,
    /// State at `t_end`.
    pub y_end: Vec<f64>,
    /// Why the run ended.
    pub stop: Stop,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the equations made for this trajectory. A step without a finite result counts in full: the other
    /// lanes go on to its end.
    pub evaluations: u64,
}

/// Integrates all trajectories on this thread, in as many lanes as the processor computes best in. Outcomes are in the
/// order of the trajectories. A trajectory that fails ends with its reason; the others go on.
///
/// # Errors
/// [`SimError`] if the question makes no sense, as for [`crate::integrate`]; [`SimError::Trajectory`] for parameters or
/// a start of the wrong length, or not finite.
pub fn integrate(
    equations: InLanes<'_>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<Vec<Outcome>, SimError> {
    match equations.widest() {
        Some(eight) => integrate_in(eight, plan, trajectories),
        None => integrate_in(equations.four, plan, trajectories),
    }
}

/// Integrates all trajectories on this thread in `N` lanes; outcomes are those of [`integrate`], to the bit.
///
/// # Errors
/// [`SimError`] if the question makes no sense; [`SimError::Trajectory`] for parameters or a start of the wrong length,
/// or not finite.
pub fn integrate_in<const N: usize>(
    equations: &(dyn Rates<Lanes<N>> + Sync),
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<Vec<Outcome>, SimError> {
    let pace = check(equations, plan, trajectories)?;
    let mut outcomes = Outcomes::new(trajectories.len());
    let mut waiting = 0..trajectories.len();
    queue::run(equations, &pace, plan.step_limit, trajectories, &mut || waiting.next(), &mut |index, outcome| {
        outcomes.put(index, outcome);
    });
    Ok(outcomes.all())
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

/// Refuses what cannot be run; returns the control of the steps with which every trajectory begins.
fn check<const N: usize>(
    equations: &(dyn Rates<Lanes<N>> + Sync),
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
) -> Result<Pace, SimError> {
    let lengths = equations.lengths();
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
    Ok(pace)
}
