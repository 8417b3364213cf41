//! Driver of a run: step sizes, samples, events, work and warnings of an integration. Also chooses a second run that
//! measures the error of the first.

pub(crate) mod event_watch;
pub(crate) mod integrate;
pub(crate) mod recorder;
pub(crate) mod run;
pub(crate) mod second_run;
pub(crate) mod step_control;
pub(crate) mod step_warnings;
pub(crate) mod work;
