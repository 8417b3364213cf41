//! Limit of the work that is spent on trials before the best choice so far is taken.

use super::ground::Ground;

/// Terms made by trials above which no further choice is tried. The scenes of the library make 23 109 at most; for a
/// floating chain of four links all trials make 65 968 and take three times as long as one.
const MOST_WORK: usize = 24_000;

/// Work of the trials for a scene, in terms that they made: the same on every machine.
#[derive(Default)]
pub struct Work(usize);

impl Work {
    /// Counts the terms that a trial made beyond those of its ground.
    pub fn add(&mut self, trial: &Ground, ground: &Ground) {
        self.0 += trial.arena.len().saturating_sub(ground.arena.len());
    }

    /// True if no further choice is to be tried.
    pub fn is_done(&self) -> bool {
        self.0 > MOST_WORK
    }
}
