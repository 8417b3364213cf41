//! Events: instants at which a function of time and state passes through zero.
//!
//! An event is located on the dense output, so that watching does not change a single step.
//! These conventions hold in both directions of time:
//! - *Crossing*: the function changes sign. "Rising" means from negative to positive *as the run
//!   proceeds*, also when it proceeds backward in time.
//! - *Touch*: the function reaches zero within rounding and returns to the side it came from. A touch is
//!   recorded for any direction of the event, and never ends a run.
//! - *At the start*: the function is zero within rounding at the start. That is recorded, and is no crossing.
//!   The event happens when the function next changes sign.
//! - A function that reaches zero and stays there crosses zero at the instant of arrival.
//! - A function value that is not a number ends the run with the code `event-not-a-number`, at the
//!   last step before it, unless a terminal event comes first. Infinite values are fine.
//!
//! "Within rounding" is measured: the change of the function when each component of the state and
//! the time move by their rounding error.
//!
//! A function that changes sign through infinity does not cross zero: that is recorded as a *pole*. A pole ends the run
//! if it leaves a domain.
//!
//! If an event has ranges ([`Event::with_ranges`]), no crossing is missed and none is counted twice. The step is
//! divided until each part has a range without 0, or a slope of one sign. So both crossings of a pair are found,
//! however close they are, down to 2⁻⁴⁰ of the step, or 8 ε of the time if that is longer. Below this resolution, or
//! where rounding alone makes the function vanish, a change of sign counts as one crossing. A return to the same side
//! is then a touch if |g| comes down to zero within rounding; it may be two crossings that rounding hides. If |g| does
//! not, it is recorded as [`Kind::Undecided`]. So is a function that 4096 ranges of one step do not decide, once a
//! step. An undecided place never ends a run, but the run warns if it might have ended there.
//!
//! Without ranges the function is sampled at every eighth of a step. This holds for a closure alone, and in runs by
//! quadrature, whose steps are no polynomials in time. If the polynomial through the samples has extrema between them,
//! the function is sampled there too. A minimum of |g| that might reach zero is sought. So most pairs of crossings, or
//! touches, between samples are found. Three crossings within a sixteenth of a step can be missed, and so can a
//! function with a much shorter wavelength than the solution; `max_step` helps there.

pub(crate) mod corners;
pub(crate) mod guard;
pub(crate) mod isolate;
pub(crate) mod root;
pub(crate) mod samples;
pub(crate) mod search;
pub(crate) mod walk;

use std::fmt;
use tripos_traits::{Direction, Enclosure};

/// Effect of an event's crossing on the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Effect {
    /// The crossing is recorded, and the run goes on.
    Record,
    /// The crossing ends the run with [`crate::Stop::Event`].
    Terminal,
    /// The equations hold only where the function is positive: a crossing ends the run with
    /// [`crate::Stop::LeftDomain`]. A start at which it is negative ends the run with [`crate::Stop::StartsOutside`],
    /// before any step. A start at exactly zero is watched from the next instant on.
    Domain,
}

/// Event function g(t, y) of the time, s, and the state.
pub type EventFunction<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Event function g over a part of a step: the range of its values and of its slopes by one variable, from those of
/// time and state by the same variable.
pub type RangeFunction<'a> = Box<dyn FnMut(Enclosure, &[Enclosure]) -> Enclosure + 'a>;

/// An event function in ranges, with the components of the state that it needs.
pub struct InRanges<'a> {
    /// Event function over ranges of time and state.
    pub function: RangeFunction<'a>,
    /// Components of the state that the function depends on: it gets only their ranges. With `None` it gets all ranges.
    pub components: Option<Vec<usize>>,
}

/// A function of time and state, and the meaning of its zeros.
pub struct Event<'a> {
    /// Name by which the event is reported.
    pub name: String,
    /// Event function g(t, y). It is called at many points of a step, out of order, and should be smooth where it is
    /// zero.
    pub function: EventFunction<'a>,
    /// Event function in ranges; `None` lets the function be sampled.
    pub ranges: Option<InRanges<'a>>,
    /// Direction of the crossings that count.
    pub direction: Direction,
    /// Effect of these crossings on the run.
    pub effect: Effect,
}

impl<'a> Event<'a> {
    /// Makes an event that is recorded at each crossing of `function` in `direction`.
    pub fn recorded(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        let function = Box::new(function);
        Self { name: name.into(), function, ranges: None, direction, effect: Effect::Record }
    }

    /// Makes an event that ends the run at the first crossing of `function` in `direction`.
    pub fn terminal(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        Self { effect: Effect::Terminal, ..Self::recorded(name, direction, function) }
    }

    /// Makes a condition of validity: the run ends where `function` ceases to be positive.
    pub fn domain(name: impl Into<String>, function: impl FnMut(f64, &[f64]) -> f64 + 'a) -> Self {
        Self { effect: Effect::Domain, ..Self::recorded(name, Direction::Falling, function) }
    }

    /// Adds the event's function in ranges, so that no crossing is missed.
    ///
    /// ```
    /// use tripos_sim::{Direction, Event, Options, integrate};
    /// use tripos_traits::Scalar;
    ///
    /// // One text for numbers and for ranges: 15 zeros of sin 5t in one step of 10 s.
    /// fn wave<S: Scalar>(t: S) -> S {
    ///     (S::int(5) * t).sin_cos().0
    /// }
    /// let event = Event::recorded("zero", Direction::Either, |t, _: &[f64]| wave(t)).with_ranges(|t, _| wave(t));
    /// let options = Options { max_step: Some(10.0), initial_step: Some(10.0), ..Options::default() };
    /// let clock = |_: f64, _: &[f64], rate: &mut [f64]| { rate[0] = 1.0; Ok(()) };
    /// let solution = integrate(clock, (0.1, 10.0), &[0.0], &options, &mut [event])?;
    /// assert_eq!((solution.steps, solution.events.len()), (1, 15));
    /// # Ok::<(), tripos_sim::SimError>(())
    /// ```
    #[must_use]
    pub fn with_ranges(self, ranges: impl FnMut(Enclosure, &[Enclosure]) -> Enclosure + 'a) -> Self {
        Self { ranges: Some(InRanges { function: Box::new(ranges), components: None }), ..self }
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

/// Behaviour of an event function at the time of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The function went from negative to positive.
    Rising,
    /// The function went from positive to negative.
    Falling,
    /// The function reached zero and returned to the side it came from.
    Touch,
    /// The function was zero when the run began.
    AtStart,
    /// The function changed sign through infinity.
    Pole,
    /// The function comes so close to zero, or varies so fast, that it is not decided whether it crosses there. The
    /// limit is rounding, or the allowed number of ranges.
    Undecided,
}

/// Record of an event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRecord {
    /// Position of the event in the list of the run's events.
    pub event: usize,
    /// Name of the event.
    pub name: String,
    /// Time of the event, s: exact to the rounding of the step's times.
    pub t: f64,
    /// State at the time of the event, from the dense output.
    pub y: Vec<f64>,
    /// Behaviour of the event function at that time.
    pub kind: Kind,
    /// True if the event ended the run.
    pub terminal: bool,
}
