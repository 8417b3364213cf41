//! Sections of the page on the publication beside the model: errata, verdict, effect on the motion.

mod entry;
pub(super) mod errata;
pub(super) mod motion;
pub(super) mod verdict;
