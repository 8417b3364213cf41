//! Limit of the work of a search for the best choice.

use super::reduction_basis::ReductionBasis;

/// Most terms that trials may make before no further choice is tried. The scenes of the library make at most 23 109
/// terms. For a floating chain of four links all trials make 65 968 terms and take three times as long as one trial.
const MOST_WORK: usize = 24_000;

/// Work of the trials for a scene, as the number of terms that they made: the same on every machine.
#[derive(Default)]
pub struct Work(usize);

impl Work {
    /// Adds the number of terms that a trial made beyond those of its basis.
    pub fn add(&mut self, trial: &ReductionBasis, basis: &ReductionBasis) {
        self.0 += trial.arena.len().saturating_sub(basis.arena.len());
    }

    /// True if the work is used up and no further choice is tried.
    pub fn is_done(&self) -> bool {
        self.0 > MOST_WORK
    }
}
