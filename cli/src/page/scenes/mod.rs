//! Sections of the page on scenes: runs, outcomes, reduced equations, singular places, advice.

pub(super) mod advice;
pub(super) mod moving;
pub(super) mod needs;
pub(super) mod outcome;
pub(super) mod runs;
pub(super) mod scene;
pub(super) mod singular;
pub(super) mod standing;
