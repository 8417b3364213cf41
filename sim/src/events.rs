//! Events: instants at which a function of time and state passes through zero.
//!
//! An event is located on the dense output, so that watching does not change a single step.
//! Conventions, the same in both directions of time:
//! - *Crossing*: the function changes sign. "Rising" means from negative to positive *as the run
//!   proceeds*, also when it proceeds backward in time.
//! - *Touch*: it reaches zero within rounding and returns to the side it came from. A touch is
//!   recorded whatever the event's direction, and never ends a run.
//! - *At the start*: it is zero within rounding at the start. That is recorded, and is no crossing.
//!   The event happens when the function next changes sign.
//! - Reaching zero and staying there counts as a crossing, at the instant of arrival.
//! - A function value that is not a number ends the run with the code `event-not-a-number`, at the
//!   last step before it, unless a terminal event comes first. Infinite values are fine.
//!
//! "Within rounding" is measured: the change of the function when each component of the state and
//! the time move by their rounding error.
//!
//! Resolution: the function is sampled at every eighth of a step. Where the polynomial through the samples
//! has extrema between them, it is sampled there too, and a minimum of |g| that might reach zero is sought.
//! Two crossings, or a touch, between samples are therefore found. What can be missed is three crossings
//! within a sixteenth of a step, or a function with a much shorter wavelength than the solution; `max_step`
//! helps there.

use std::fmt;
use tripos_traits::Direction;

/// What a crossing does to the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Effect {
    /// It is recorded, and the run goes on.
    Record,
    /// It ends the run, [`crate::Stop::Event`].
    Terminal,
    /// The equations hold only where the function is positive: crossing ends the run,
    /// [`crate::Stop::LeftDomain`]. A start at which it is negative ends it with [`crate::Stop::StartsOutside`], before
    /// any step. A start at exactly zero is watched from the next instant on.
    Domain,
}

/// g(t, y): a function of time in s and of the state.
pub type EventFunction<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// A function of time and state, and what its zeros mean.
pub struct Event<'a> {
    /// The name by which it is reported.
    pub name: String,
    /// The function. Called at many points of a step, out of order; it should be smooth where it is
    /// zero.
    pub function: EventFunction<'a>,
    /// Which crossings count.
    pub direction: Direction,
    /// What they do.
    pub effect: Effect,
}

impl<'a> Event<'a> {
    /// An event that is recorded at each crossing of `function` in `direction`.
    pub fn recorded(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        let function = Box::new(function);
        Self { name: name.into(), function, direction, effect: Effect::Record }
    }

    /// An event that ends the run at the first crossing of `function` in `direction`.
    pub fn terminal(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        Self { effect: Effect::Terminal, ..Self::recorded(name, direction, function) }
    }

    /// A condition of validity: the run ends where `function` ceases to be positive.
    pub fn domain(name: impl Into<String>, function: impl FnMut(f64, &[f64]) -> f64 + 'a) -> Self {
        Self { effect: Effect::Domain, ..Self::recorded(name, Direction::Falling, function) }
    }
}

impl fmt::Debug for Event<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Event")
            .field("name", &self.name)
            .field("direction", &self.direction)
            .field("effect", &self.effect)
            .finish_non_exhaustive()
    }
}

/// What a function did at the time of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// It went from negative to positive.
    Rising,
    /// It went from positive to negative.
    Falling,
    /// It reached zero and returned to the side it came from.
    Touch,
    /// It was zero when the run began.
    AtStart,
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRecord {
    /// Position of the event in the list that was watched.
    pub event: usize,
    /// Its name.
    pub name: String,
    /// Time, in s: exact to the rounding of the step's times.
    pub t: f64,
    /// State at that time, from the dense output.
    pub y: Vec<f64>,
    /// What happened.
    pub kind: Kind,
    /// Whether it ended the run.
    pub terminal: bool,
}
