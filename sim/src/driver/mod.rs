//! Driver of a run: step sizes, samples, events, work and warnings of an integration, and the choice of
//! a second run that measures its error.

pub(crate) mod doubt;
pub(crate) mod integrate;
pub(crate) mod pace;
pub(crate) mod recorder;
pub(crate) mod run;
pub(crate) mod second;
pub(crate) mod watch;
pub(crate) mod work;
