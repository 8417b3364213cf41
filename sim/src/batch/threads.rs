//! Integration of batches of trajectories on all cores.

use super::queue::Work;
use super::{Equations, Outcome, Outcomes, Plan, Trajectory, check, eight, four};
use crate::error::SimError;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use tripos_traits::InLanes;

/// Integrates all trajectories on the threads of the current pool of `rayon`. The outcomes have the
/// same bits as those of [`super::integrate`], for any number of threads.
///
/// `progress` is called with the number of trajectories that have ended, by the thread that ends a
/// trajectory, so possibly not in order.
///
/// # Errors
/// [`SimError`] if the plan is invalid; [`SimError::Trajectory`] for parameters or a start of the wrong
/// length, or not finite.
pub fn integrate_on_all_cores(
    equations: InLanes<'_>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<Outcome>, SimError> {
    match eight(equations, plan) {
        Some(equations) => on_all_cores(equations, plan, trajectories, progress),
        None => on_all_cores(four(equations), plan, trajectories, progress),
    }
}

/// Integrates all trajectories in `N` lanes on all threads of the current pool of `rayon`.
fn on_all_cores<const N: usize>(
    equations: Equations<'_, N>,
    plan: &Plan,
    trajectories: &[Trajectory<'_>],
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<Outcome>, SimError> {
    let (pace, way) = check(equations, plan, trajectories)?;
    let outcomes = Mutex::new(Outcomes::new(trajectories.len()));
    let (taken, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    // All threads take from one queue, so that no thread has much work left when the others are done.
    let worker = || {
        let mut list = Vec::new();
        let mut next = || Some(taken.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < trajectories.len());
        let work = Work { trajectories, pace: &pace, limit: plan.step_limit, watching: None };
        way.run(&work, &mut next, &mut |index, outcome| {
            list.push((index, outcome));
            progress(done.fetch_add(1, Ordering::Relaxed) + 1);
        });
        let mut outcomes = outcomes.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        for (index, outcome) in list {
            outcomes.put(index, outcome);
        }
    };
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads() {
            scope.spawn(|_| worker());
        }
    });
    Ok(outcomes.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).all())
}
