//! How much is tried before the best choice so far is taken.

use super::ground::Ground;

/// Terms that trials make above which nothing more is tried. The scenes of the library make 23 109 at most; of a floating chain of four links all trials
/// make 65 968 and take three times as long as one.
const MOST_WORK: usize = 24_000;

/// How much was tried for a scene, in terms that trials made: the same on every machine.
#[derive(Default)]
pub struct Work(usize);

impl Work {
    /// Counts what a trial made of a ground.
    pub fn add(&mut self, trial: &Ground, ground: &Ground) {
        self.0 += trial.arena.len().saturating_sub(ground.arena.len());
    }

    /// Whether nothing more is tried.
    pub fn is_done(&self) -> bool {
        self.0 > MOST_WORK
    }
}
