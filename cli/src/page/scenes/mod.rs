//! Sections of the page about scenes: runs, outcomes, claims, reduced equations, singular places, and recommended runs.

pub(super) mod advice;
pub(super) mod claims;
pub(super) mod motion_section;
pub(super) mod outcome;
pub(super) mod reduced_equations;
pub(super) mod runs;
pub(super) mod scene;
pub(super) mod singular_matrices;
pub(super) mod standing;
