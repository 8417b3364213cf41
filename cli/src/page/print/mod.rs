//! Sections of the page about the publication in the model's folder: errata, verdict, and effect on the motion.

mod entry_name;
pub(super) mod errata;
pub(super) mod printed_motion;
pub(super) mod verdict;
