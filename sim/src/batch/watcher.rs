//! Watcher of a trajectory's steps: of its events, and of the divisors of its equations.
//!
//! The watcher is handed the accepted step of its lane, as plain doubles, and decides as [`crate::integrate`] does.
//! Invariant: the watcher changes no step.

use super::method::{LaneStep, Method};
use crate::driver::run::end_inside;
use crate::driver::watch::{Events, Watch};
use crate::events::guard::Guard;
use crate::events::{Event, EventRecord};
use crate::rhs::{Lent, RightHandSide};
use crate::solution::Stop;
use crate::stepper::{DenseStep, Interpolant};

/// Equations and events that are watched in one trajectory of a batch.
pub struct Watched<'w> {
    /// Equations in plain doubles. Only their divisors are evaluated during the run.
    pub equations: Box<dyn RightHandSide<f64> + 'w>,
    /// Events of the trajectory; they are recorded, or end it, as in [`crate::integrate`].
    pub events: Vec<Event<'w>>,
}

/// Function that makes the [`Watched`] of the trajectory at a position, at the start of the trajectory.
pub type Watching<'w> = dyn Fn(usize) -> Watched<'w> + 'w;

/// End of a trajectory, inside a step or at its end, with the reason.
pub(super) struct Ending {
    pub(super) t: f64,
    pub(super) y: Vec<f64>,
    pub(super) stop: Stop,
}

/// Watcher of a trajectory: its [`Watched`], with the memory from step to step.
pub(super) struct Watcher<'w> {
    equations: Box<dyn RightHandSide<f64> + 'w>,
    guard: Guard<f64>,
    watch: Watch<'w, 'w>,
    /// States at the ends of the step that is examined.
    ends: [Vec<f64>; 2],
    suspects: bool,
}

impl<'w> Watcher<'w> {
    /// Creates the watcher at the start of a trajectory. An error is the reason not to start.
    pub(super) fn new(Watched { mut equations, events }: Watched<'w>, t: f64, y: &[f64]) -> Result<Self, Stop> {
        let mut watch = Watch::new(Events::Own(events), y.len());
        if let Some(stop) = watch.start(t, y) {
            return Err(stop);
        }
        let guard = Guard::new(&mut Lent(equations.as_mut()), t, y);
        Ok(Self { equations, guard, watch, ends: [y.to_vec(), y.to_vec()], suspects: false })
    }

    /// Examines the ends of an accepted step over `span`, s; true if the inside has to be examined by
    /// [`Watcher::ending`].
    pub(super) fn look<M: Method<N>, const N: usize>(&mut self, method: &M, lane: usize, span: (f64, f64)) -> bool {
        method.ends(lane, &mut self.ends);
        if !self.guard.is_empty() {
            let step = LaneStep { method, lane, span, ends: &self.ends };
            self.suspects = self.guard.suspects(&mut Lent(self.equations.as_mut()), &step);
        }
        self.suspects || !self.watch.is_empty()
    }

    /// Finds the end of the trajectory inside the step that [`Watcher::look`] has examined; `None` if it goes on.
    pub(super) fn ending<M: Method<N>, const N: usize>(
        &mut self,
        method: &M,
        lane: usize,
        span: (f64, f64),
    ) -> Option<Ending> {
        let step = LaneStep { method, lane, span, ends: &self.ends };
        let rhs = &mut Lent(self.equations.as_mut());
        match end_inside(&step, rhs, &mut self.watch, self.suspects.then_some(&mut self.guard)) {
            Ok(None) => None,
            Ok(Some((theta, stop))) => {
                let t = step.time_at(theta);
                self.watch.forget_beyond(t, span);
                Some(Ending { t, y: step.sample(theta, t), stop })
            }
            Err(stop) => Some(Ending { t: span.0, y: self.ends[0].clone(), stop }),
        }
    }

    /// Goes on to the next step after a step of this length, s.
    pub(super) fn accept(&mut self, length: f64) {
        self.guard.accept(length);
    }

    /// Records of the trajectory's events.
    pub(super) fn records(self) -> Vec<EventRecord> {
        self.watch.records
    }
}
