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
//! A function that changes sign through infinity does not cross zero: that is recorded as a *pole*, and ends the run
//! where it leaves a domain.
//!
//! Where an event brings ranges ([`Event::with_ranges`]), no crossing is missed and none is counted twice. The step is
//! divided until each part has a range without 0, or a slope of one sign, so that both crossings of a pair are found
//! however close they are, down to 2⁻⁴⁰ of the step, or 8 ε of the time where that is longer, and down to where
//! rounding alone makes the function vanish. There a change of sign counts as one crossing; a return to the same side
//! is a touch where |g| comes down to zero within rounding, which may be two crossings that rounding hides, and is
//! recorded as [`Kind::Undecided`] where it does not. A function that 4096 ranges of one step do not tell is undecided
//! there, too: once a step. It never ends a run, but a run that it might have ended warns.
//!
//! Without ranges, as with a closure alone, and in runs by quadrature, whose steps are no polynomials in time, the
//! function is sampled at every eighth of a step. Where the polynomial through the samples has extrema between them, it
//! is sampled there too, and a minimum of |g| that might reach zero is sought. Two crossings, or a touch, between
//! samples are therefore mostly found. Three crossings within a sixteenth of a step can be missed, and so can a
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

/// Effect of a crossing on the run.
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

/// g over a stretch of the step: the range of its values and of its slopes, from those of time and state by one and the
/// same variable.
pub type RangeFunction<'a> = Box<dyn FnMut(Enclosure, &[Enclosure]) -> Enclosure + 'a>;

/// An event function in ranges.
pub struct InRanges<'a> {
    /// The function.
    pub function: RangeFunction<'a>,
    /// The components of the state that it depends on; it is given no others. All unless they are named.
    pub components: Option<Vec<usize>>,
}

/// A function of time and state, and the meaning of its zeros.
pub struct Event<'a> {
    /// The name by which it is reported.
    pub name: String,
    /// The function. Called at many points of a step, out of order; it should be smooth where it is
    /// zero.
    pub function: EventFunction<'a>,
    /// Its ranges, if they can be had; without them the function is sampled.
    pub ranges: Option<InRanges<'a>>,
    /// Direction of the crossings that count.
    pub direction: Direction,
    /// Effect of these crossings on the run.
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
        Self { name: name.into(), function, ranges: None, direction, effect: Effect::Record }
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

    /// The event with its function in ranges, so that no crossing is missed.
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
    /// It went from negative to positive.
    Rising,
    /// It went from positive to negative.
    Falling,
    /// It reached zero and returned to the side it came from.
    Touch,
    /// It was zero when the run began.
    AtStart,
    /// It changed sign through infinity.
    Pole,
    /// It comes so close to zero, or varies so fast, that neither rounding nor the work allowed tells whether it
    /// crosses there.
    Undecided,
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
    /// Behaviour of the function at that time.
    pub kind: Kind,
    /// True if the event ended the run.
    pub terminal: bool,
}
