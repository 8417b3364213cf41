//! Lanes of a thread, which integrate trajectories, and the queue from which they take the next
//! trajectory.

use std::collections::VecDeque;

use tripos_traits::Lanes;

use super::lane_method::LaneMethod;
use super::lane_run::{LaneRun, LaneVerdict, judge_lane_run};
use super::trajectory_watcher::{Ending, TrajectoryWatcher, WatchOfTrajectory};
use super::{BatchOutcome, Trajectory};
use crate::driver::step_control::StepControl;
use crate::solution::Stop;

/// Trajectory that waits for a lane, with its initial rows from [`LaneMethod::initial_rows`].
struct WaitingTrajectory<'w> {
    /// Trajectory that waits, with its step control and its counts of steps and evaluations.
    run: LaneRun<'w>,
    /// Initial rows: the state, its derivative, and further Taylor coefficients if the method has them.
    begun: Vec<f64>,
}

/// Data that all threads of a batch share: the trajectories and the settings of the integration.
pub(super) struct BatchWork<'a, 'w> {
    /// Trajectories of the batch.
    pub(super) trajectories: &'a [Trajectory<'a>],
    /// Step control with which each trajectory begins.
    pub(super) pace: &'a StepControl,
    /// Largest number of attempted steps of a trajectory.
    pub(super) limit: u64,
    /// Function that gives the events and divisors to watch in a trajectory; `None` watches nothing.
    pub(super) watching: Option<&'a WatchOfTrajectory<'w>>,
}

/// State of a thread that integrates trajectories in N lanes.
struct QueueWorker<'a, 'w, M, const N: usize> {
    /// Method that takes a step in all lanes at once.
    method: M,
    /// Trajectories of the batch and the settings of their integration.
    work: &'a BatchWork<'a, 'w>,
    /// Trajectory in each lane; `None` for an empty lane.
    lanes: [Option<LaneRun<'w>>; N],
    /// Trajectories that wait for a lane.
    ready: VecDeque<WaitingTrajectory<'w>>,
    /// Function that returns the index of the next trajectory; `None` if there are no more.
    next: &'a mut dyn FnMut() -> Option<usize>,
    /// Function that is called with the index and the outcome of each trajectory that ends.
    done: &'a mut dyn FnMut(usize, BatchOutcome),
}

/// Integrates trajectories with a method in lanes, until `next` returns `None` in place of the index of
/// a trajectory. `done` is called with each index and outcome.
pub(super) fn run<'a, const N: usize>(
    method: impl LaneMethod<N>,
    work: &'a BatchWork<'a, '_>,
    next: &'a mut dyn FnMut() -> Option<usize>,
    done: &'a mut dyn FnMut(usize, BatchOutcome),
) {
    let (lanes, ready) = (std::array::from_fn(|_| None), VecDeque::new());
    let mut worker = QueueWorker { method, work, lanes, ready, next, done };
    while worker.fill() {
        worker.step();
    }
}

impl<M: LaneMethod<N>, const N: usize> QueueWorker<'_, '_, M, N> {
    /// Loads the next trajectories into the empty lanes. Returns true if a lane has a trajectory afterwards.
    fn fill(&mut self) -> bool {
        for l in 0..N {
            while self.lanes[l].is_none() {
                // If no trajectory of the last batch taken from the queue can start, more trajectories are taken.
                while self.ready.is_empty() && self.prepare() {}
                let Some(WaitingTrajectory { run, begun }) = self.ready.pop_front() else { break };
                if let Some(stop) = run.step_limit_reached(self.work.limit) {
                    let ending = Ending { t: run.t, y: begun[..self.method.states()].to_vec(), stop };
                    self.report_outcome(run, ending);
                    continue;
                }
                self.method.load(l, self.work.trajectories[run.index].parameters, &begun);
                self.lanes[l] = Some(run);
            }
        }
        self.lanes.iter().any(Option::is_some)
    }

    /// Takes up to N trajectories from the queue, and chooses the first step of each of them. Returns false if the
    /// queue was empty.
    fn prepare(&mut self) -> bool {
        let taken: Vec<usize> = std::iter::from_fn(|| (self.next)()).take(N).collect();
        let Some(&first) = taken.first() else { return false };
        // Lanes that are not needed repeat the first trajectory.
        let of = |l: usize| self.work.trajectories[taken.get(l).copied().unwrap_or(first)];
        let gather = |length: usize, get: &dyn Fn(usize, usize) -> f64| -> Vec<Lanes<N>> {
            (0..length).map(|i| Lanes(std::array::from_fn(|l| get(l, i)))).collect()
        };
        let n = self.method.states();
        let parameters = gather(self.method.parameters(), &|l, i| of(l).parameters[i]);
        let y = gather(n, &|l, i| of(l).start[i]);
        let begun = self.method.initial_rows(&parameters, &y);
        let slope = &begun[n..2 * n];
        let mut paces: Vec<StepControl> = taken.iter().map(|_| self.work.pace.clone()).collect();
        let mut sizes = [None; N];
        let is_finite = |values: &[f64]| values.iter().all(|x| x.is_finite());
        for (l, pace) in paces.iter_mut().enumerate() {
            // Without a finite derivative at the start there is no first step.
            let slope = Some(values_of_lane(slope, l)).filter(|slope| is_finite(slope));
            sizes[l] = slope.and_then(|slope| pace.first_size(of(l).start, &slope, None));
        }
        let mut beyond = y.clone();
        if sizes.iter().any(Option::is_some) {
            let probe = gather(n, &|l, i| y[i].0[l] + sizes[l].unwrap_or(0.0) * slope[i].0[l]);
            self.method.rates(&parameters, &probe, &mut beyond);
        }
        for (l, (index, mut pace)) in taken.into_iter().zip(paces).enumerate() {
            if let Some(size) = sizes[l] {
                let beyond = Some(values_of_lane(&beyond, l)).filter(|beyond| is_finite(beyond));
                pace.correct_first_size(
                    self.work.trajectories[index].start,
                    &values_of_lane(slope, l),
                    size,
                    beyond.as_ref(),
                );
            }
            self.enqueue(index, pace, values_of_lane(&begun, l));
        }
        true
    }

    /// Adds a trajectory to the list of those that wait for a lane, or ends it at once if it cannot start. `begun` are
    /// its initial rows.
    fn enqueue(&mut self, index: usize, pace: StepControl, begun: Vec<f64>) {
        let (t, n) = (pace.t0, self.method.states());
        let mut run = LaneRun { index, pace, t, steps: 0, rejected: 0, evaluations: 1, is_fresh: true, watcher: None };
        let watched = self.work.watching.map(|watching| watching(index));
        let outside = match watched.map(|watched| TrajectoryWatcher::new(watched, t, &begun[..n])).transpose() {
            Ok(watcher) => {
                run.watcher = watcher;
                None
            }
            Err(stop) => Some(stop),
        };
        let no_slope = begun[n..2 * n].iter().position(|x| !x.is_finite());
        let stop = outside.or(no_slope.map(|component| Stop::NotFinite { component }));
        match stop {
            Some(stop) => self.report_outcome(run, Ending { t, y: begun[..n].to_vec(), stop }),
            None => self.ready.push_back(WaitingTrajectory { run, begun }),
        }
    }

    /// Reports the outcome of a trajectory that has ended.
    fn report_outcome(&mut self, run: LaneRun<'_>, ending: Ending) {
        (self.done)(run.index, run.outcome(ending));
    }

    /// Tries a step in each lane, and ends the trajectories that have a reason to stop.
    fn step(&mut self) {
        let Some(test) = &self.work.pace.test else { return };
        let proposals = self.method.proposals(test);
        let mut h = [0.0; N];
        for (l, run) in self.lanes.iter_mut().enumerate() {
            let Some(run) = run else { continue };
            if run.is_fresh {
                run.begin(proposals.map(|sizes| sizes[l]));
            }
            h[l] = run.pace.trial.exact_step_length::<f64>(run.t);
        }
        let attempt = self.method.attempt(h, test);
        let mut judged: [LaneVerdict; N] = std::array::from_fn(|_| LaneVerdict::Accepted { last: false });
        for (l, run) in self.lanes.iter_mut().enumerate() {
            let Some(run) = run else { continue };
            judged[l] = judge_lane_run(run, l, &attempt, test.tolerance);
            if let LaneVerdict::GivenUp(Stop::NotFinite { component }) = &mut judged[l] {
                *component = self.method.first_not_finite(l, h, test);
            }
        }
        let mut endings = self.endings_inside_steps(h, &judged);
        // An empty lane may compute anything: if all lanes with a trajectory accept, no lane has to be restored.
        self.method.accept(std::array::from_fn(|l| matches!(judged[l], LaneVerdict::Accepted { .. })));
        for (l, (judged, ending)) in judged.into_iter().zip(&mut endings).enumerate() {
            let Some(run) = &mut self.lanes[l] else { continue };
            let stop = run.move_to_step_end(judged).err().or_else(|| run.step_limit_reached(self.work.limit));
            let at_end = stop.map(|stop| Ending { t: run.t, y: self.method.state(l), stop });
            if let Some(ending) = ending.take().or(at_end)
                && let Some(run) = self.lanes[l].take()
            {
                self.report_outcome(run, ending);
            }
        }
    }

    /// Searches the accepted steps of signed sizes `h`, s, for events and zeros of divisors that end a trajectory.
    /// Returns the end of the trajectory in each lane; `None` if it continues.
    fn endings_inside_steps(&mut self, h: [f64; N], judged: &[LaneVerdict; N]) -> [Option<Ending>; N] {
        let mut looks = [false; N];
        for (l, run) in self.lanes.iter_mut().enumerate() {
            if let (Some(LaneRun { watcher: Some(watcher), t, pace, .. }), LaneVerdict::Accepted { .. }) =
                (run, &judged[l])
            {
                looks[l] = watcher.watch_step_ends(&self.method, l, (*t, pace.trial.t_new));
            }
        }
        if looks.contains(&true) {
            self.method.prepare_inside(h);
        }
        std::array::from_fn(|l| {
            let run = self.lanes[l].as_mut().filter(|_| looks[l])?;
            run.evaluations += M::INSIDE;
            run.watcher.as_mut()?.watch_step_inside(&self.method, l, (run.t, run.pace.trial.t_new))
        })
    }
}

/// Extracts the numbers of the lane with index `l`, one number from each vector of the list.
fn values_of_lane<const N: usize>(values: &[Lanes<N>], l: usize) -> Vec<f64> {
    values.iter().map(|x| x.0[l]).collect()
}
