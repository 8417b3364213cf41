//! Limit on the work of the search for the best reduction of a scene, counted in terms.

use super::reduction_basis::ReductionBasis;

/// Largest number of terms that trials may make before no further choice is tried. The scenes of
/// the library make at most 23 109 terms. For a floating chain of four links, all trials make 65
/// 968 terms and take three times as long as a single trial.
const MOST_WORK: usize = 24_000;

/// Number of terms that the trials for a scene have made. It measures work equally on every
/// machine.
#[derive(Default)]
pub struct SearchWork(usize);

impl SearchWork {
    /// Adds the number of terms that a trial made, in addition to those of its basis.
    pub fn add(&mut self, trial: &ReductionBasis, basis: &ReductionBasis) {
        self.0 += trial.arena.len().saturating_sub(basis.arena.len());
    }

    /// True if the limit is exceeded, so that no further choice is tried.
    pub fn is_search_work_used_up(&self) -> bool {
        self.0 > MOST_WORK
    }
}
