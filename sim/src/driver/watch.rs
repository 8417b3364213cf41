//! Watch of a run's events, step by step, in order of time.

use std::ops::{Deref, DerefMut};
use tripos_traits::{Direction, Enclosure, Real};

use crate::error::Failure;
use crate::events::isolate::Ranges;
use crate::events::samples::Probe;
use crate::events::search::search;
use crate::events::walk::{Finding, Memory};
use crate::events::{Effect, Event, EventRecord, Kind};
use crate::polynomial::Polynomial;
use crate::solution::Stop;
use crate::stepper::DenseStep;
use crate::warning::Warning;

/// Events of a run: owned by it, or borrowed.
pub(crate) enum Events<'w, 'e> {
    Own(Vec<Event<'e>>),
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

/// Events of a run, with their memories and their records so far.
pub(crate) struct Watch<'w, 'e> {
    events: Events<'w, 'e>,
    memories: Vec<Memory>,
    y: Vec<f64>,
    /// Largest size of each component of the state so far.
    magnitudes: Vec<f64>,
    /// Solution inside the current step as a polynomial; `stretch` is the space for ranges of the state.
    polynomial: Polynomial,
    stretch: Vec<Enclosure>,
    pub(crate) records: Vec<EventRecord>,
}

impl<'w, 'e> Watch<'w, 'e> {
    /// Creates a watch of these events for a state of `n` components.
    pub(crate) fn new(events: Events<'w, 'e>, n: usize) -> Self {
        let ranges = || events.iter().filter_map(|event| event.ranges.as_ref());
        let wanted = |i: &usize| ranges().any(|r| r.components.as_ref().is_none_or(|list| list.contains(i)));
        let polynomial = Polynomial::new((0..n).filter(wanted).collect(), n);
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

    /// Evaluates the events at the start; returns the reason to stop if the run cannot start.
    pub(crate) fn start<S: Real>(&mut self, t: f64, y: &[S]) -> Option<Stop> {
        for (rounded, y) in self.y.iter_mut().zip(y) {
            *rounded = y.to_f64();
        }
        self.note_magnitudes();
        for event in self.events.iter_mut() {
            let value = (event.function)(t, &self.y);
            if value.is_nan() {
                return Some(Stop::Failed(not_a_number(&event.name, t)));
            }
            let domain = event.effect == Effect::Domain;
            if domain && value < 0.0 {
                return Some(Stop::StartsOutside { name: event.name.clone() });
            }
            let side_at_zero = i8::from(domain);
            self.memories.push(Memory { value, sign: 0, side: 0, begun: false, side_at_zero, zero_at: None });
        }
        None
    }

    /// Examines an accepted step, and records its events up to its end, or up to the first event that ends the run.
    /// That event is returned as its fraction of the step and the reason to stop.
    pub(crate) fn look(&mut self, step: &dyn DenseStep) -> Result<Option<(f64, Stop)>, Failure> {
        if self.is_empty() {
            return Ok(None);
        }
        step.interpolate(1.0, &mut self.y);
        self.note_magnitudes();
        let wanted = self.events.iter().any(|event| event.ranges.is_some());
        let has_ranges = wanted && self.polynomial.take(step);
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
        found.retain(|(i, f)| matters(&self.events[*i], f.kind));
        found.sort_by(|(i, f), (j, g)| f.theta.total_cmp(&g.theta).then(i.cmp(j)));
        let end = found.iter().find(|(i, f)| ends_run(&self.events[*i], *f)).copied();
        if let Some((theta, i)) = nowhere
            && end.is_none_or(|(_, f)| theta <= f.theta)
        {
            return Err(not_a_number(&self.events[i].name, step.time_at(theta)));
        }
        for (i, f) in found {
            if end.is_none_or(|(_, last)| f.theta <= last.theta) {
                self.record(step, i, f);
            }
        }
        Ok(end.map(|(i, f)| (f.theta, stop_for(&self.events[i]))))
    }

    /// Removes the records of a step over `span`, s, that lie beyond the instant `t`.
    pub(crate) fn forget_beyond(&mut self, t: f64, span: (f64, f64)) {
        let (start, end) = span;
        self.records.retain(|record| (record.t - t) * (end - start).signum() <= 0.0);
    }

    /// True if the run has no events.
    pub(crate) fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    fn note_magnitudes(&mut self) {
        for (magnitude, y) in self.magnitudes.iter_mut().zip(&self.y) {
            *magnitude = magnitude.max(y.abs());
        }
    }

    /// Warnings about events that might have ended the run, but were not decided.
    pub(crate) fn warnings(&self) -> impl Iterator<Item = Warning> {
        self.events.iter().enumerate().filter(|(_, event)| event.effect != Effect::Record).filter_map(|(i, event)| {
            let mut places = self.records.iter().filter(|r| r.event == i && r.kind == Kind::Undecided);
            let first = places.next()?;
            Some(Warning::EventUndecided { name: event.name.clone(), t: first.t, more: places.count() })
        })
    }

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
            terminal: ends_run(&self.events[event], found),
        });
    }
}

/// True if the event counts this kind of zero.
fn matters(event: &Event<'_>, kind: Kind) -> bool {
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

fn ends_run(event: &Event<'_>, found: Finding) -> bool {
    match found.kind {
        Kind::Rising | Kind::Falling => event.effect != Effect::Record,
        // The function was positive and is negative, though it went through infinity.
        Kind::Pole => event.effect == Effect::Domain && found.side < 0,
        Kind::Touch | Kind::AtStart | Kind::Undecided => false,
    }
}

fn stop_for(event: &Event<'_>) -> Stop {
    let name = event.name.clone();
    match event.effect {
        Effect::Domain => Stop::LeftDomain { name },
        Effect::Record | Effect::Terminal => Stop::Event { name },
    }
}

fn not_a_number(name: &str, t: f64) -> Failure {
    Failure { code: "event-not-a-number", message: format!("event function `{name}` is not a number at t = {t} s") }
}
