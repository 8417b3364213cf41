//! Watcher of a trajectory in a batch: it examines each accepted step for events and for zeros of divisors.
//!
//! The watcher gets the accepted step of its lane as `f64` numbers, and decides as [`crate::integrate`] does.
//! Invariant: the watcher changes no step.

use super::lane_method::{LaneMethod, LaneStep};
use crate::dense_output::{DenseStep, Interpolant};
use crate::driver::event_watch::{EventWatch, Events};
use crate::driver::run::run_end_inside_step;
use crate::events::divisor_guard::DivisorGuard;
use crate::events::{Event, EventRecord};
use crate::right_hand_side::{LentRightHandSide, RightHandSide};
use crate::solution::Stop;

/// Equations and events that are watched in a trajectory of a batch.
pub struct WatchedTrajectory<'w> {
    /// Equations in `f64`, whose divisors are watched. Apart from the divisors, only f is evaluated, near a zero of a
    /// divisor.
    pub equations: Box<dyn RightHandSide<f64> + 'w>,
    /// Events of the trajectory; they are recorded, or end the trajectory, as in [`crate::integrate`].
    pub events: Vec<Event<'w>>,
}

/// Function that gives the equations and events to watch in the trajectory with a given index. It is called at the
/// start of the trajectory.
pub type WatchOfTrajectory<'w> = dyn Fn(usize) -> WatchedTrajectory<'w> + 'w;

/// End of a trajectory, inside a step or at its end.
pub(super) struct Ending {
    /// Time at which the trajectory ends, s.
    pub(super) t: f64,
    /// State at the end of the trajectory.
    pub(super) y: Vec<f64>,
    /// Reason why the trajectory ended.
    pub(super) stop: Stop,
}

/// Watcher of a trajectory, with the data that it keeps from step to step.
pub(super) struct TrajectoryWatcher<'w> {
    /// Equations of the trajectory in `f64`, whose divisors are watched.
    equations: Box<dyn RightHandSide<f64> + 'w>,
    /// Guard that finds zeros of the divisors inside a step.
    guard: DivisorGuard<f64>,
    /// Watch that finds the events of the trajectory inside a step.
    watch: EventWatch<'w, 'w>,
    /// States at the start and at the end of the step that is examined.
    ends: [Vec<f64>; 2],
    /// True if a divisor of the equations may have been zero inside the step that is examined.
    suspects: bool,
}

impl<'w> TrajectoryWatcher<'w> {
    /// Creates the watcher at the start (t, y) of a trajectory. The error is the reason why the trajectory
    /// cannot start.
    pub(super) fn new(
        WatchedTrajectory { mut equations, events }: WatchedTrajectory<'w>,
        t: f64,
        y: &[f64],
    ) -> Result<Self, Stop> {
        let mut watch = EventWatch::new(Events::Own(events), y.len());
        if let Some(stop) = watch.start(t, y) {
            return Err(stop);
        }
        let guard = DivisorGuard::new(&mut LentRightHandSide(equations.as_mut()), t, y);
        Ok(Self { equations, guard, watch, ends: [y.to_vec(), y.to_vec()], suspects: false })
    }

    /// Examines the ends of an accepted step of a lane over `span`, s. Returns true if
    /// [`TrajectoryWatcher::watch_step_inside`] must examine the inside of the step, too.
    pub(super) fn watch_step_ends<M: LaneMethod<N>, const N: usize>(
        &mut self,
        method: &M,
        lane: usize,
        span: (f64, f64),
    ) -> bool {
        method.ends(lane, &mut self.ends);
        if !self.guard.is_empty() {
            let step = LaneStep { method, lane, span, ends: &self.ends };
            self.suspects = self.guard.suspects_divisor_zero(&mut LentRightHandSide(self.equations.as_mut()), &step);
        }
        self.suspects || !self.watch.is_empty()
    }

    /// Finds the end of the trajectory inside the step over `span`, s, that
    /// [`TrajectoryWatcher::watch_step_ends`] has examined. `None` if the trajectory continues.
    pub(super) fn watch_step_inside<M: LaneMethod<N>, const N: usize>(
        &mut self,
        method: &M,
        lane: usize,
        span: (f64, f64),
    ) -> Option<Ending> {
        let step = LaneStep { method, lane, span, ends: &self.ends };
        let rhs = &mut LentRightHandSide(self.equations.as_mut());
        match run_end_inside_step(&step, rhs, &mut self.watch, self.suspects.then_some(&mut self.guard)) {
            Ok(None) => None,
            Ok(Some((theta, stop))) => {
                let t = step.time_at(theta);
                self.watch.forget_records_beyond(t, span);
                Some(Ending { t, y: step.sample(theta, t), stop })
            }
            Err(stop) => Some(Ending { t: span.0, y: self.ends[0].clone(), stop }),
        }
    }

    /// Moves to the next step, after an accepted step of this signed length, s.
    pub(super) fn accept(&mut self, length: f64) {
        self.guard.accept(length);
    }

    /// Returns the records of the trajectory's events.
    pub(super) fn records(self) -> Vec<EventRecord> {
        self.watch.records
    }
}
