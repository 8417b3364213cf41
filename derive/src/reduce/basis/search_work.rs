//! Limit on the work of the search for the best reduction of a scene, counted in terms.

use super::reduction_basis::ReductionBasis;

/// Largest number of terms that trial reductions of a scene may create. When it is exceeded, no
/// further reduction is tried.
///
/// The scenes of the library create at most 23 109 terms. For a floating chain of four links, all
/// trials create 65 968 terms and take three times as long as a single trial.
const MOST_WORK: usize = 24_000;

/// Number of symbolic terms that trial reductions of a scene have created so far. Terms are counted
/// instead of time, so that the search ends at the same place on every machine.
#[derive(Default)]
pub struct SearchWork(usize);

impl SearchWork {
    /// Adds the number of symbolic terms that the trial reduction `trial` created in addition to
    /// those of `basis`.
    pub fn add(&mut self, trial: &ReductionBasis, basis: &ReductionBasis) {
        self.0 += trial.arena.len().saturating_sub(basis.arena.len());
    }

    /// True if the limit on symbolic terms is exceeded, so that no further reduction is tried.
    pub fn is_search_work_used_up(&self) -> bool {
        self.0 > MOST_WORK
    }
}
