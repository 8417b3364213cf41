//! Given motions, for which forces are sought, and tables of their samples.

pub(super) mod motion;
#[cfg(feature = "files")]
pub(super) mod samples;
