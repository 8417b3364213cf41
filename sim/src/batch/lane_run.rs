//! Trajectory that is integrated in a lane: its step control, its counts, and the decision to accept or reject each
//! step.

use super::BatchOutcome;
use super::lane_method::Attempt;
use super::trajectory_watcher::{Ending, TrajectoryWatcher};
use crate::driver::step_control::{StepControl, Verdict};
use crate::solution::Stop;
use crate::stepper::TrialStep;

/// Trajectory that is being integrated in a lane, or waits for a lane.
pub(super) struct LaneRun<'w> {
    /// Index of the trajectory in the batch.
    pub(super) index: usize,
    /// Step control of the trajectory: the size of its current step.
    pub(super) pace: StepControl,
    /// Current time of the trajectory, s.
    pub(super) t: f64,
    /// Number of accepted steps of the trajectory so far.
    pub(super) steps: u64,
    /// Number of rejected steps of the trajectory so far.
    pub(super) rejected: u64,
    /// Number of evaluations of the equations for this trajectory so far.
    pub(super) evaluations: u64,
    /// True if the next step of the trajectory is not chosen yet.
    pub(super) is_fresh: bool,
    /// Watcher of events and divisors; `None` if nothing is watched.
    pub(super) watcher: Option<TrajectoryWatcher<'w>>,
}

impl LaneRun<'_> {
    /// Makes the outcome of the trajectory from its end and its counts.
    pub(super) fn outcome(self, Ending { t, y, stop }: Ending) -> BatchOutcome {
        BatchOutcome {
            t_end: t,
            y_end: y,
            stop,
            steps: self.steps,
            rejected: self.rejected,
            evaluations: self.evaluations + self.pace.evaluations,
            events: self.watcher.map_or_else(Vec::new, TrajectoryWatcher::records),
        }
    }

    /// Reason to stop if the number of attempted steps has reached `limit`; else `None`.
    pub(super) fn step_limit_reached(&self, limit: u64) -> Option<Stop> {
        (self.steps + self.rejected >= limit).then_some(Stop::StepLimit { limit })
    }

    /// Chooses the size of the next step. `proposed` is the size that the method proposes, s; `None` if it
    /// proposes none.
    pub(super) fn begin(&mut self, proposed: Option<f64>) {
        if let Some(size) = proposed {
            self.pace.propose_step_size(size);
        }
        self.pace.begin_step(self.t, self.steps);
        self.is_fresh = false;
    }

    /// Moves the trajectory to the end of its step if the step is accepted. The error is the reason to stop, at the end
    /// of an accepted step or at the start of a step that is given up.
    pub(super) fn move_to_step_end(&mut self, judged: LaneVerdict) -> Result<(), Stop> {
        match judged {
            LaneVerdict::Again => Ok(()),
            LaneVerdict::GivenUp(stop) => Err(stop),
            LaneVerdict::Accepted { last } => {
                let TrialStep { t_new, .. } = self.pace.trial;
                if let Some(watcher) = &mut self.watcher {
                    watcher.accept(t_new - self.t);
                }
                (self.t, self.is_fresh) = (t_new, true);
                if last { Err(Stop::End) } else { Ok(()) }
            }
        }
    }
}

/// Decision on a step that was tried in a lane: accept it, try a smaller step, or end the trajectory.
pub(super) enum LaneVerdict {
    /// The step is accepted; `last` is true if it reached the end of the span.
    Accepted { last: bool },
    /// The step is rejected and must be tried again with a smaller size.
    Again,
    /// The trajectory ends at the start of the step, for this reason. The component of [`Stop::NotFinite`] is set
    /// later.
    GivenUp(Stop),
}

/// Decides on the step that was tried in the lane with index `l`, and counts the step.
pub(super) fn judge_lane_run<const N: usize>(
    run: &mut LaneRun<'_>,
    l: usize,
    attempt: &Attempt<N>,
    tolerance: f64,
) -> LaneVerdict {
    let TrialStep { h, .. } = run.pace.trial;
    let passed = attempt.finite[l] && attempt.error[l] <= tolerance;
    run.evaluations += attempt.evaluations[l];
    let trouble = !attempt.finite[l] || passed && !attempt.finite_end[l];
    match run.pace.judge_step(run.t, (!trouble).then_some(attempt.error[l])) {
        Verdict::Accepted { last } => {
            run.steps += 1;
            LaneVerdict::Accepted { last }
        }
        Verdict::Again => {
            run.rejected += 1;
            LaneVerdict::Again
        }
        Verdict::GiveUp => {
            run.rejected += 1;
            let nowhere = Stop::NotFinite { component: 0 };
            LaneVerdict::GivenUp(if trouble { nowhere } else { Stop::StepTooSmall { step: h.abs() } })
        }
    }
}
