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
pub(crate) mod divisor_guard;
pub(crate) mod event_findings;
pub(crate) mod event_memory;
pub(crate) mod interval_isolation;
pub(crate) mod probe;
pub(crate) mod root_and_minimum;
pub(crate) mod sample_walk;
pub(crate) mod samples;
pub(crate) mod search;

use std::fmt;
use tripos_traits::{Direction, Enclosure};

/// Effect of an event on the run when its function crosses zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Effect {
    /// The crossing is recorded, and the run goes on.
    Record,
    /// The crossing ends the run with [`crate::Stop::Event`].
    Terminal,
    /// The equations hold only while the event function is positive: a crossing ends the run with
    /// [`crate::Stop::LeftDomain`].
    ///
    /// A negative value at the start ends the run with [`crate::Stop::StartsOutside`], before any step. If the value is
    /// exactly zero at the start, the run begins and the function is watched from the next instant on.
    Domain,
}

/// Event function g(t, y) of the time t, s, and the state y. Its zeros are the events.
pub type EventFunction<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Event function g in interval arithmetic. The arguments are the ranges of the time, s, and of each component of the
/// state, each with its slope by the fraction of the step. The result is the range of g and of its slope.
pub type RangeFunction<'a> = Box<dyn FnMut(Enclosure, &[Enclosure]) -> Enclosure + 'a>;

/// Event function in interval arithmetic, with the components of the state that it depends on.
pub struct InRanges<'a> {
    /// Event function g, evaluated on ranges of time and state by interval arithmetic.
    pub function: RangeFunction<'a>,
    /// Indices of the components of the state on which the function depends; the ranges of other components are not
    /// computed. `None` means all components.
    pub components: Option<Vec<usize>>,
}

/// Event of a run: a function of time and state, and the meaning of its zeros.
pub struct Event<'a> {
    /// Name of the event in results and messages.
    pub name: String,
    /// Event function g(t, y). It is called at many points of a step, out of order, and should be smooth
    /// near its zeros.
    pub function: EventFunction<'a>,
    /// Event function in interval arithmetic, with which no crossing is missed. `None`: the function is sampled
    /// instead.
    pub ranges: Option<InRanges<'a>>,
    /// Direction of the crossings that count: rising, falling or either.
    pub direction: Direction,
    /// Effect of a counted crossing on the run.
    pub effect: Effect,
}

impl<'a> Event<'a> {
    /// Creates an event that is recorded at each crossing of zero by `function` in `direction`, and does
    /// not end the run.
    pub fn recorded(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        let function = Box::new(function);
        Self { name: name.into(), function, ranges: None, direction, effect: Effect::Record }
    }

    /// Creates an event that ends the run at the first crossing of zero by `function` in `direction`.
    pub fn terminal(
        name: impl Into<String>,
        direction: Direction,
        function: impl FnMut(f64, &[f64]) -> f64 + 'a,
    ) -> Self {
        Self { effect: Effect::Terminal, ..Self::recorded(name, direction, function) }
    }

    /// Creates a domain event: the equations hold while `function` is positive, and the run ends when it becomes
    /// negative.
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

/// Kind of a recorded event: the behaviour of the event function at its zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The event function went from negative to positive as the run proceeded.
    Rising,
    /// The event function went from positive to negative as the run proceeded.
    Falling,
    /// The event function reached zero within rounding, and returned to the side from which it came.
    Touch,
    /// The event function was zero within rounding when the run began.
    AtStart,
    /// The event function changed its sign through infinity.
    Pole,
    /// The event function comes so close to zero, or varies so fast, that the search cannot decide about a crossing.
    /// The limit is rounding, or the allowed number of ranges.
    Undecided,
}

/// Record of an event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct EventRecord {
    /// Index of the event in the list of the run's events, from 0.
    pub event: usize,
    /// Name of the event that happened.
    pub name: String,
    /// Time of the event, s, exact to the rounding of the step's times.
    pub t: f64,
    /// State at the time of the event, from the dense output.
    pub y: Vec<f64>,
    /// Kind of the event: the behaviour of its function at this time.
    pub kind: Kind,
    /// True if the event ended the run.
    pub terminal: bool,
}
