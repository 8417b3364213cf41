//! Run of a method from its start to its end: step sizes, samples, errors, and the choice of a second run.

pub(crate) mod doubt;
pub(crate) mod integrate;
pub(crate) mod pace;
pub(crate) mod recorder;
pub(crate) mod run;
pub(crate) mod second;
pub(crate) mod watch;
pub(crate) mod work;
