//! The lanes of one thread, and the queue they take trajectories from.

use std::collections::VecDeque;

use tripos_traits::{Lanes, Rates};

use super::method::{Attempt, Method};
use super::{Outcome, Trajectory};
use crate::dop853::END;
use crate::pace::{Pace, Verdict};
use crate::solution::Stop;
use crate::stepper::Trial;

/// A trajectory in a lane.
struct Run {
    index: usize,
    pace: Pace,
    t: f64,
    steps: u64,
    rejected: u64,
    evaluations: u64,
}

impl Run {
    fn ended(&self, y_end: Vec<f64>, stop: Stop) -> Outcome {
        Outcome {
            t_end: self.t,
            y_end,
            stop,
            steps: self.steps,
            rejected: self.rejected,
            evaluations: self.evaluations + self.pace.evaluations,
        }
    }

    /// The reason not to try another step, if there is one.
    fn limited(&self, limit: u64) -> Option<Stop> {
        (self.steps + self.rejected >= limit).then_some(Stop::StepLimit { limit })
    }
}

/// A trajectory whose first step is chosen.
struct Ready {
    run: Run,
    y: Vec<f64>,
    slope: Vec<f64>,
}

/// What one thread works with.
struct Worker<'a, const N: usize> {
    method: Method<'a, N>,
    trajectories: &'a [Trajectory<'a>],
    /// The step control with which every trajectory begins.
    pace: &'a Pace,
    limit: u64,
    lanes: [Option<Run>; N],
    ready: VecDeque<Ready>,
    next: &'a mut dyn FnMut() -> Option<usize>,
    done: &'a mut dyn FnMut(usize, Outcome),
}

/// Integrates the trajectories whose positions `next` hands out, until there are no more, and hands each outcome to
/// `done`.
pub(super) fn run<'a, const N: usize>(
    equations: &'a (dyn Rates<Lanes<N>> + Sync),
    pace: &'a Pace,
    limit: u64,
    trajectories: &'a [Trajectory<'a>],
    next: &'a mut dyn FnMut() -> Option<usize>,
    done: &'a mut dyn FnMut(usize, Outcome),
) {
    let (lanes, ready) = (std::array::from_fn(|_| None), VecDeque::new());
    let mut worker = Worker { method: Method::new(equations), trajectories, pace, limit, lanes, ready, next, done };
    while worker.fill() {
        worker.step();
    }
}

impl<const N: usize> Worker<'_, N> {
    /// Gives lanes without a trajectory the next ones; says whether there is anything left to do.
    fn fill(&mut self) -> bool {
        for l in 0..N {
            while self.lanes[l].is_none() {
                // None of those that are taken need have a first step.
                while self.ready.is_empty() && self.prepare() {}
                let Some(Ready { mut run, y, slope }) = self.ready.pop_front() else { break };
                if let Some(stop) = run.limited(self.limit) {
                    (self.done)(run.index, run.ended(y, stop));
                    continue;
                }
                self.method.load(l, self.trajectories[run.index].parameters, &y, &slope);
                run.pace.begin(run.t, 0);
                self.lanes[l] = Some(run);
            }
        }
        self.lanes.iter().any(Option::is_some)
    }

    /// Takes up to N trajectories from the queue and chooses their first steps, all at once; says whether there were
    /// any.
    fn prepare(&mut self) -> bool {
        let taken: Vec<usize> = std::iter::from_fn(|| (self.next)()).take(N).collect();
        let Some(&first) = taken.first() else { return false };
        // Lanes that are not needed repeat the first trajectory.
        let of = |l: usize| self.trajectories[taken.get(l).copied().unwrap_or(first)];
        let gather = |length: usize, get: &dyn Fn(usize, usize) -> f64| -> Vec<Lanes<N>> {
            (0..length).map(|i| Lanes(std::array::from_fn(|l| get(l, i)))).collect()
        };
        let n = self.method.y.len();
        let parameters = gather(self.method.parameters.len(), &|l, i| of(l).parameters[i]);
        let y = gather(n, &|l, i| of(l).start[i]);
        let mut slope = y.clone();
        self.method.rates(&parameters, &y, &mut slope);
        let slopes: Vec<Vec<f64>> = (0..taken.len()).map(|l| lane(&slope, l)).collect();
        let mut paces: Vec<Pace> = taken.iter().map(|_| self.pace.clone()).collect();
        let mut sizes = [0.0; N];
        for (l, pace) in paces.iter_mut().enumerate() {
            sizes[l] = pace.first_size(of(l).start, &slopes[l], None).unwrap_or(0.0);
        }
        let probe = gather(n, &|l, i| y[i].0[l] + sizes[l] * slope[i].0[l]);
        let mut beyond = y;
        self.method.rates(&parameters, &probe, &mut beyond);
        for (l, (index, pace)) in taken.into_iter().zip(paces).enumerate() {
            let t = pace.t0;
            let (y, slope) = (self.trajectories[index].start, &slopes[l]);
            let mut run = Run { index, pace, t, steps: 0, rejected: 0, evaluations: 1 };
            if let Some(component) = slope.iter().position(|x| !x.is_finite()) {
                (self.done)(index, run.ended(y.to_vec(), Stop::NotFinite { component }));
                continue;
            }
            let finite = |values: &[f64]| values.iter().all(|x| x.is_finite());
            let beyond = Some(lane(&beyond, l)).filter(|beyond| finite(beyond));
            run.pace.correct_first_size(y, slope, sizes[l], beyond.as_ref());
            self.ready.push_back(Ready { run, y: y.to_vec(), slope: slope.clone() });
        }
        true
    }

    /// Tries a step in every lane, and ends the trajectories that have a reason to.
    fn step(&mut self) {
        let mut h = [0.0; N];
        for (h, run) in h.iter_mut().zip(&self.lanes) {
            *h = run.as_ref().map_or(0.0, |run| run.pace.trial.exact::<f64>(run.t));
        }
        let Some(test) = &self.pace.test else { return };
        let attempt = self.method.attempt(h, test);
        let mut accepted = [false; N];
        let mut stops: [Option<Stop>; N] = std::array::from_fn(|_| None);
        for (l, run) in self.lanes.iter_mut().enumerate() {
            let Some(run) = run else { continue };
            (accepted[l], stops[l]) = judge(run, l, &attempt, test.tolerance);
            if let Some(Stop::NotFinite { component }) = &mut stops[l] {
                *component = self.method.first_not_finite(l, h, test);
            }
        }
        self.method.accept(accepted);
        for (l, (lane, stop)) in self.lanes.iter_mut().zip(stops).enumerate() {
            let Some(run) = lane else { continue };
            if let Some(stop) = stop.or_else(|| run.limited(self.limit)) {
                (self.done)(run.index, run.ended(self.method.state(l), stop));
                *lane = None;
            }
        }
    }
}

/// The values of one lane.
fn lane<const N: usize>(values: &[Lanes<N>], l: usize) -> Vec<f64> {
    values.iter().map(|x| x.0[l]).collect()
}

/// What becomes of the step that a lane tried: whether it is accepted, and why the run ends there if it does. The
/// component of one that is not finite is left open.
fn judge<const N: usize>(run: &mut Run, l: usize, attempt: &Attempt<N>, tolerance: f64) -> (bool, Option<Stop>) {
    let Trial { h, t_new } = run.pace.trial;
    let passed = attempt.finite[l] && attempt.error[l] <= tolerance;
    run.evaluations += END as u64 - u64::from(!passed);
    let trouble = !attempt.finite[l] || passed && !attempt.finite_end[l];
    match run.pace.judge(run.t, (!trouble).then_some(attempt.error[l])) {
        Verdict::Accepted { last } => {
            run.steps += 1;
            run.t = t_new;
            if !last {
                run.pace.begin(run.t, run.steps);
            }
            (true, last.then_some(Stop::End))
        }
        Verdict::Again => {
            run.rejected += 1;
            (false, None)
        }
        Verdict::GiveUp => {
            run.rejected += 1;
            let stop = if trouble { Stop::NotFinite { component: 0 } } else { Stop::StepTooSmall { step: h.abs() } };
            (false, Some(stop))
        }
    }
}
