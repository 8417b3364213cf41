//! Sections of the page on the publication beside the model: errata, verdict, effect on the motion.

pub(super) mod errata;
pub(super) mod motion;
pub(super) mod verdict;
