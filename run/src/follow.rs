//! Who follows long work: told how far it is, asked whether to go on.
//!
//! Invariant: following changes no number. A run that was ended early has the steps that it would have had.

use crate::error::Error;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use tripos_sim::{Options, Poll, Solution, Stop};

/// Whoever may end long work between two steps; by default nobody.
#[derive(Clone, Default)]
pub struct Follow(Option<Follower>);

#[derive(Clone)]
struct Follower {
    poll: Poll,
    asked: Arc<dyn Fn() -> bool + Send + Sync>,
}

impl Follow {
    /// `poll` is told the time that each accepted step has reached, and answers whether to go on; `asked` whether the
    /// whole work is to end.
    pub fn new(poll: Poll, asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Follower { poll, asked: Arc::new(asked) }))
    }

    /// Whether the work is to end.
    #[must_use]
    pub fn asked(&self) -> bool {
        self.0.as_ref().is_some_and(|follower| (follower.asked)())
    }

    /// Whether a loop goes on: until the work is asked to end.
    pub fn go_on(&self) -> ControlFlow<()> {
        if self.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// The options for a run that is followed.
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

/// A run that nobody ended early.
///
/// # Errors
/// [`Error::Interrupted`] otherwise.
pub fn uninterrupted(solution: Solution) -> Result<Solution, Error> {
    if solution.stop == Stop::Interrupted { Err(Error::Interrupted) } else { Ok(solution) }
}

/// How far work of many parts has come, for who shows it; every method does nothing unless it is stated.
pub trait Progress {
    /// How many parts there are.
    fn set_length(&self, _parts: u64) {}
    /// So many more are done.
    fn inc(&self, _parts: u64) {}
    /// What is being done.
    fn set_message(&self, _what: &str) {}
}

/// Nobody looks.
impl Progress for () {}
