//! Integration of batches of trajectories on all cores.

use super::lane_queue::BatchWork;
use super::{
    BatchOutcome, BatchOutcomes, BatchPlan, Equations, Trajectory, check_batch, equations_in_eight_lanes,
    equations_in_four_lanes,
};
use crate::error::SimError;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use tripos_traits::InLanes;

/// Integrates all trajectories on the threads of the current pool of `rayon`. The outcomes have the same bits as those
/// of [`super::integrate_batch`], for any number of threads.
///
/// `progress` is called with the number of trajectories that have ended. The thread that ends a trajectory calls it, so
/// that the numbers may arrive out of order.
///
/// # Errors
/// [`SimError`] if the plan is invalid; [`SimError::Trajectory`] for parameters or a start of the wrong length, or not
/// finite.
pub fn integrate_on_all_cores(
    equations: InLanes<'_>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<BatchOutcome>, SimError> {
    match equations_in_eight_lanes(equations, plan) {
        Some(equations) => run_on_all_threads(equations, plan, trajectories, progress),
        None => run_on_all_threads(equations_in_four_lanes(equations), plan, trajectories, progress),
    }
}

/// Integrates all trajectories in `N` lanes on all threads of the current pool of `rayon`.
fn run_on_all_threads<const N: usize>(
    equations: Equations<'_, N>,
    plan: &BatchPlan,
    trajectories: &[Trajectory<'_>],
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<BatchOutcome>, SimError> {
    let (pace, way) = check_batch(equations, plan, trajectories)?;
    let outcomes = Mutex::new(BatchOutcomes::new(trajectories.len()));
    let (taken, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    // All threads take trajectories from one queue, so that no thread has much work left when the others are done.
    let worker = || {
        let mut list = Vec::new();
        let mut next = || Some(taken.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < trajectories.len());
        let work = BatchWork { trajectories, pace: &pace, limit: plan.step_limit, watching: None };
        way.run(&work, &mut next, &mut |index, outcome| {
            list.push((index, outcome));
            progress(done.fetch_add(1, Ordering::Relaxed) + 1);
        });
        let mut outcomes = outcomes.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        for (index, outcome) in list {
            outcomes.store_outcome(index, outcome);
        }
    };
    rayon::scope(|scope| {
        for _ in 0..rayon::current_num_threads() {
            scope.spawn(|_| worker());
        }
    });
    Ok(outcomes.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).all_outcomes())
}
