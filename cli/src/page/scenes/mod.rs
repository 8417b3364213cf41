//! Sections of the page on scenes: runs, outcomes, reduced equations, singular places, advice.

pub(super) mod advice;
pub(super) mod motion_section;
pub(super) mod outcome;
pub(super) mod reduced_equations;
pub(super) mod runs;
pub(super) mod scene;
pub(super) mod singular_matrices;
pub(super) mod standing;
