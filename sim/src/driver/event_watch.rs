//! Watch of the events of a run: examines each step, records its events, and finds the first event that ends the run.

use std::ops::{Deref, DerefMut};
use tripos_traits::{Direction, Enclosure, Real};

use crate::dense_output::DenseStep;
use crate::error::Failure;
use crate::events::event_findings::Finding;
use crate::events::event_memory::EventMemory;
use crate::events::interval_isolation::Ranges;
use crate::events::probe::Probe;
use crate::events::search::search;
use crate::events::{Effect, Event, EventRecord, Kind};
use crate::solution::Stop;
use crate::step_polynomial::StepPolynomial;
use crate::warning::Warning;

/// Events of a run, either owned or borrowed from the caller.
pub(crate) enum Events<'w, 'e> {
    /// Events that the run owns.
    Own(Vec<Event<'e>>),
    /// Events that the caller lends to the run.
    Lent(&'w mut [Event<'e>]),
}

impl<'e> Deref for Events<'_, 'e> {
    type Target = [Event<'e>];
    fn deref(&self) -> &[Event<'e>] {
        match self {
            Self::Own(events) => events,
            Self::Lent(events) => events,
        }
    }
}

impl DerefMut for Events<'_, '_> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Own(events) => events,
            Self::Lent(events) => events,
        }
    }
}

/// Watch of the events of a run, with the state of each event's search and the records so far.
pub(crate) struct EventWatch<'w, 'e> {
    /// Events of the run that are watched.
    events: Events<'w, 'e>,
    /// State of the search for each event at the end of the last step.
    memories: Vec<EventMemory>,
    /// Working space for a state of the run, rounded to `f64`.
    y: Vec<f64>,
    /// Largest absolute value of each component of the state so far, in its unit.
    magnitudes: Vec<f64>,
    /// Dense output of the current step as polynomials, for events that are evaluated on ranges.
    polynomial: StepPolynomial,
    /// Working space for ranges of the state over a part of the step.
    stretch: Vec<Enclosure>,
    /// Events that have happened so far, in the order of the run.
    pub(crate) records: Vec<EventRecord>,
}

impl<'w, 'e> EventWatch<'w, 'e> {
    /// Creates a watch of these events for a state of `n` components.
    pub(crate) fn new(events: Events<'w, 'e>, n: usize) -> Self {
        let ranges = || events.iter().filter_map(|event| event.ranges.as_ref());
        let wanted = |i: &usize| ranges().any(|r| r.components.as_ref().is_none_or(|list| list.contains(i)));
        let polynomial = StepPolynomial::new((0..n).filter(wanted).collect(), n);
        Self {
            events,
            memories: Vec::new(),
            y: vec![0.0; n],
            magnitudes: vec![0.0; n],
            polynomial,
            stretch: Vec::new(),
            records: Vec::new(),
        }
    }

    /// Evaluates the event functions at the start (t, y) of the run. Returns the reason to stop if a function is not a
    /// number there, or if the start is outside an event's domain; `None` if the run can start.
    pub(crate) fn start<S: Real>(&mut self, t: f64, y: &[S]) -> Option<Stop> {
        for (rounded, y) in self.y.iter_mut().zip(y) {
            *rounded = y.to_f64();
        }
        self.note_magnitudes();
        for event in self.events.iter_mut() {
            let value = (event.function)(t, &self.y);
            if value.is_nan() {
                return Some(Stop::Failed(event_not_a_number(&event.name, t)));
            }
            let domain = event.effect == Effect::Domain;
            if domain && value < 0.0 {
                return Some(Stop::StartsOutside { name: event.name.clone() });
            }
            let side_at_zero = i8::from(domain);
            self.memories.push(EventMemory { value, sign: 0, side: 0, begun: false, side_at_zero, zero_at: None });
        }
        None
    }

    /// Examines an accepted step, and records its events up to its end, or up to the first event that ends
    /// the run.
    ///
    /// Returns the fraction of the step at which the run ends, with the reason; `None` if the run goes on.
    /// Error if an event function is not a number inside the step.
    pub(crate) fn watch_step(&mut self, step: &dyn DenseStep) -> Result<Option<(f64, Stop)>, Failure> {
        if self.is_empty() {
            return Ok(None);
        }
        step.interpolate(1.0, &mut self.y);
        self.note_magnitudes();
        let wanted = self.events.iter().any(|event| event.ranges.is_some());
        let has_ranges = wanted && self.polynomial.copy_dense_output(step);
        let mut found: Vec<(usize, Finding)> = Vec::new();
        let mut nowhere: Option<(f64, usize)> = None;
        for (i, (event, memory)) in self.events.iter_mut().zip(&mut self.memories).enumerate() {
            let mut probe =
                Probe { step, function: &mut *event.function, y: &mut self.y, magnitudes: &self.magnitudes };
            let ranges = event.ranges.as_mut().filter(|_| has_ranges).map(|ranges| Ranges {
                polynomial: &mut self.polynomial,
                function: &mut ranges.function,
                y: &mut self.stretch,
            });
            let findings = search(&mut probe, memory, ranges);
            found.extend(findings.found.into_iter().map(|f| (i, f)));
            if let Some(theta) = findings.not_a_number
                && nowhere.is_none_or(|(first, _)| theta < first)
            {
                nowhere = Some((theta, i));
            }
        }
        found.retain(|(i, f)| event_counts(&self.events[*i], f.kind));
        found.sort_by(|(i, f), (j, g)| f.theta.total_cmp(&g.theta).then(i.cmp(j)));
        let end = found.iter().find(|(i, f)| event_ends_run(&self.events[*i], *f)).copied();
        if let Some((theta, i)) = nowhere
            && end.is_none_or(|(_, f)| theta <= f.theta)
        {
            return Err(event_not_a_number(&self.events[i].name, step.time_at(theta)));
        }
        for (i, f) in found {
            if end.is_none_or(|(_, last)| f.theta <= last.theta) {
                self.record(step, i, f);
            }
        }
        Ok(end.map(|(i, f)| (f.theta, stop_for_event(&self.events[i]))))
    }

    /// Removes the records of a step over `span`, s, that lie beyond time `t`, s, in the direction of the
    /// run.
    pub(crate) fn forget_records_beyond(&mut self, t: f64, span: (f64, f64)) {
        let (start, end) = span;
        self.records.retain(|record| (record.t - t) * (end - start).signum() <= 0.0);
    }

    /// True if the run has no events.
    pub(crate) fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    /// Updates the largest absolute values of the components by the state in `self.y`.
    fn note_magnitudes(&mut self) {
        for (magnitude, y) in self.magnitudes.iter_mut().zip(&self.y) {
            *magnitude = magnitude.max(y.abs());
        }
    }

    /// Returns a warning for each event that might have ended the run but whose zeros could not all be decided.
    pub(crate) fn warnings(&self) -> impl Iterator<Item = Warning> {
        self.events.iter().enumerate().filter(|(_, event)| event.effect != Effect::Record).filter_map(|(i, event)| {
            let mut places = self.records.iter().filter(|r| r.event == i && r.kind == Kind::Undecided);
            let first = places.next()?;
            Some(Warning::EventUndecided { name: event.name.clone(), t: first.t, more: places.count() })
        })
    }

    /// Records an event that was found in a step, with its time and state. `event` is the index of the
    /// event.
    fn record(&mut self, step: &dyn DenseStep, event: usize, found: Finding) {
        let Finding { theta, kind, .. } = found;
        let mut y = vec![0.0; self.y.len()];
        step.interpolate(theta, &mut y);
        self.records.push(EventRecord {
            event,
            name: self.events[event].name.clone(),
            t: step.time_at(theta),
            y,
            kind,
            terminal: event_ends_run(&self.events[event], found),
        });
    }
}

/// True if a zero of this kind counts for the event: crossings count in the event's direction, all
/// other kinds always.
fn event_counts(event: &Event<'_>, kind: Kind) -> bool {
    let direction = match event.effect {
        Effect::Domain => Direction::Falling,
        Effect::Record | Effect::Terminal => event.direction,
    };
    match kind {
        Kind::Rising => direction != Direction::Falling,
        Kind::Falling => direction != Direction::Rising,
        Kind::Touch | Kind::AtStart | Kind::Pole | Kind::Undecided => true,
    }
}

/// True if this zero of the event's function ends the run.
fn event_ends_run(event: &Event<'_>, found: Finding) -> bool {
    match found.kind {
        Kind::Rising | Kind::Falling => event.effect != Effect::Record,
        // The function was positive and is negative now, although it went through infinity.
        Kind::Pole => event.effect == Effect::Domain && found.side < 0,
        Kind::Touch | Kind::AtStart | Kind::Undecided => false,
    }
}

/// Reason to stop a run that this event ends.
fn stop_for_event(event: &Event<'_>) -> Stop {
    let name = event.name.clone();
    match event.effect {
        Effect::Domain => Stop::LeftDomain { name },
        Effect::Record | Effect::Terminal => Stop::Event { name },
    }
}

/// Failure of the event function `name` that is not a number at time `t`, s.
fn event_not_a_number(name: &str, t: f64) -> Failure {
    Failure { code: "event-not-a-number", message: format!("event function `{name}` is not a number at t = {t} s") }
}
