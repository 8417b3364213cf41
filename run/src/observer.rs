//! Observers of long computations. An observer sees the progress of a computation, and may end it early.
//!
//! Invariant: an observer changes no number. A run that is ended early has taken the same steps as a complete
//! run up to the same instant.

use crate::error::Error;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use tripos_sim::{Options, Poll, Solution, Stop};

/// Observer of a long computation. It may end the computation between two steps. The default does nothing.
#[derive(Clone, Default)]
pub struct Observer(Option<ObserverFunctions>);

/// Two functions of the user that a long computation calls.
#[derive(Clone)]
struct ObserverFunctions {
    /// Function that receives the time of each accepted step, s, and decides if the run goes on.
    poll: Poll,
    /// Function that returns true if the whole computation must end.
    is_interrupted: Arc<dyn Fn() -> bool + Send + Sync>,
}

impl Observer {
    /// Makes an observer. `poll` receives the time of each accepted step, s, and decides if the run goes on.
    /// `is_interrupted` returns true if the whole computation must end.
    pub fn new(poll: Poll, is_interrupted: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(ObserverFunctions { poll, is_interrupted: Arc::new(is_interrupted) }))
    }

    /// True if the user asks for the end of the whole computation. Always false for the default observer.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.0.as_ref().is_some_and(|follower| (follower.is_interrupted)())
    }

    /// Returns `Break` if the user asks for the end of the whole computation, and otherwise `Continue`.
    pub fn continue_or_break(&self) -> ControlFlow<()> {
        if self.is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Returns a copy of integration options with the observer's function for accepted steps.
    #[must_use]
    pub fn observed_options(&self, options: &Options) -> Options {
        Options { poll: self.0.as_ref().map(|follower| follower.poll.clone()), ..options.clone() }
    }
}

impl fmt::Debug for Observer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Follow(somebody)" } else { "Follow(nobody)" })
    }
}

/// Returns the solution of a run unchanged, unless the observer interrupted the run.
///
/// # Errors
/// [`Error::Interrupted`] if the observer interrupted the run.
pub fn require_uninterrupted(solution: Solution) -> Result<Solution, Error> {
    if solution.stop == Stop::Interrupted { Err(Error::Interrupted) } else { Ok(solution) }
}

/// Display of the progress of a computation that has many parts. By default, every method does nothing.
pub trait Progress {
    /// Sets the total number of parts of the computation.
    fn set_length(&self, _parts: u64) {}
    /// Adds to the number of finished parts.
    fn add_finished_parts(&self, _parts: u64) {}
    /// Shows the name of the part that is being computed.
    fn set_message(&self, _what: &str) {}
}

/// Progress display that shows nothing.
impl Progress for () {}
