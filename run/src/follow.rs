//! Observers of long work, which see its progress and can end it.
//!
//! Invariant: an observer changes no number. A run that was ended early has the same steps as a complete run.

use crate::error::Error;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use tripos_sim::{Options, Poll, Solution, Stop};

/// Observer that may end long work between two steps; none by default.
#[derive(Clone, Default)]
pub struct Follow(Option<Follower>);

#[derive(Clone)]
struct Follower {
    poll: Poll,
    asked: Arc<dyn Fn() -> bool + Send + Sync>,
}

impl Follow {
    /// Creates an observer. `poll` gets the time of each accepted step and decides if the run goes on. `asked` returns
    /// true if all work is to end.
    pub fn new(poll: Poll, asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Follower { poll, asked: Arc::new(asked) }))
    }

    /// True if the work is to end.
    #[must_use]
    pub fn asked(&self) -> bool {
        self.0.as_ref().is_some_and(|follower| (follower.asked)())
    }

    /// Breaks a loop if the work is to end.
    pub fn go_on(&self) -> ControlFlow<()> {
        if self.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Options for a run that is observed.
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

/// Returns a run that was not interrupted.
///
/// # Errors
/// [`Error::Interrupted`] if it was.
pub fn uninterrupted(solution: Solution) -> Result<Solution, Error> {
    if solution.stop == Stop::Interrupted { Err(Error::Interrupted) } else { Ok(solution) }
}

/// Display for the progress of work in many parts. By default every method does nothing.
pub trait Progress {
    /// Sets the number of parts.
    fn set_length(&self, _parts: u64) {}
    /// Adds a number of finished parts.
    fn inc(&self, _parts: u64) {}
    /// Names the present part.
    fn set_message(&self, _what: &str) {}
}

/// No display.
impl Progress for () {}
