//! Observers of long work, which see its progress and can end it.
//!
//! Invariant: an observer changes no number. A run that was ended early has the same steps as a complete run.

use crate::error::Error;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use tripos_sim::{Options, Poll, Solution, Stop};

/// Observer that may end long work between two steps. The default observes nothing.
#[derive(Clone, Default)]
pub struct Follow(Option<Follower>);

/// Functions that an observer calls during long work.
#[derive(Clone)]
struct Follower {
    /// Function that gets the time of each accepted step and decides if the run goes on.
    poll: Poll,
    /// Function that returns true if all work is to end.
    is_interrupted: Arc<dyn Fn() -> bool + Send + Sync>,
}

impl Follow {
    /// Creates an observer. `poll` gets the time of each accepted step, s, and decides if the run goes on.
    /// `is_interrupted` returns true if all work is to end.
    pub fn new(poll: Poll, is_interrupted: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Follower { poll, is_interrupted: Arc::new(is_interrupted) }))
    }

    /// True if the observer asks to end the work.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.0.as_ref().is_some_and(|follower| (follower.is_interrupted)())
    }

    /// Result that breaks a loop if the observer asks to end the work.
    pub fn go_on(&self) -> ControlFlow<()> {
        if self.is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Adds the observer to the options of a run.
    #[must_use]
    pub fn options(&self, options: &Options) -> Options {
        Options { poll: self.0.as_ref().map(|follower| follower.poll.clone()), ..options.clone() }
    }
}

impl fmt::Debug for Follow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Follow(somebody)" } else { "Follow(nobody)" })
    }
}

/// Returns the solution of a run that was not interrupted.
///
/// # Errors
/// [`Error::Interrupted`] if the run was interrupted.
pub fn uninterrupted(solution: Solution) -> Result<Solution, Error> {
    if solution.stop == Stop::Interrupted { Err(Error::Interrupted) } else { Ok(solution) }
}

/// Display for the progress of work in many parts. By default every method does nothing.
pub trait Progress {
    /// Sets the number of parts of the work.
    fn set_length(&self, _parts: u64) {}
    /// Adds a number of finished parts.
    fn inc(&self, _parts: u64) {}
    /// Shows the name of the part that is being done.
    fn set_message(&self, _what: &str) {}
}

/// A progress display that shows nothing.
impl Progress for () {}
