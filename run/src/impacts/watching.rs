//! The events at which parts of a run end: gaps that close, and forces that no longer push.

use super::Bouncing;
use super::held::Held;
use tripos_sim::{Direction, Effect, Event, InRanges};
use tripos_traits::{Enclosure, Scalar};

impl Bouncing<'_> {
    /// The event that a gap closes.
    pub(super) fn closing(&self, contact: usize) -> Event<'_> {
        let contacts = self.contacts;
        let p = contacts.parameters;
        let n = contacts.system.lengths().coordinates;
        let (numbers, ranges) = &contacts.gaps[contact];
        let used = ranges.used().into_iter().filter_map(|at| at.checked_sub(p.len())).collect();
        let wide: Vec<Enclosure> = p.iter().map(|p| Enclosure::from_f64(*p)).collect();
        let (mut scratch, mut wide_scratch) = (Vec::new(), Vec::new());
        let function = move |_: f64, y: &[f64]| {
            let mut out = [0.0];
            numbers.evaluate_into(&[p, &y[..n]].concat(), &mut scratch, &mut out);
            out[0]
        };
        let in_ranges = move |_: Enclosure, y: &[Enclosure]| {
            let mut out = [Enclosure::from_f64(0.0)];
            let inputs: Vec<Enclosure> = wide.iter().chain(&y[..n]).copied().collect();
            ranges.evaluate_into(&inputs, &mut wide_scratch, &mut out);
            out[0]
        };
        Event {
            name: contacts.impacts[contact].name.clone(),
            function: Box::new(function),
            ranges: Some(InRanges { function: Box::new(in_ranges), components: Some(used) }),
            direction: Direction::Falling,
            effect: Effect::Terminal,
        }
    }

    /// The event that the force of a held contact no longer pushes.
    pub(super) fn opening<'e>(&self, contact: usize, mut forces: Held<'e>) -> Event<'e> {
        Event {
            name: opens(&self.contacts.impacts[contact].name),
            function: Box::new(move |t, y| forces.normal(contact, t, y)),
            ranges: None,
            direction: Direction::Falling,
            effect: Effect::Terminal,
        }
    }
}

/// The name of the event that a contact opens.
fn opens(name: &str) -> String {
    format!("{name} opens")
}

/// An event of others, for one part of a run.
pub fn passed_on<'e>(event: &'e mut Event<'_>) -> Event<'e> {
    let function = &mut event.function;
    let ranges = event.ranges.as_mut().map(|ranges| {
        let own = &mut ranges.function;
        InRanges { function: Box::new(move |t, y: &[Enclosure]| own(t, y)), components: ranges.components.clone() }
    });
    Event {
        name: event.name.clone(),
        function: Box::new(move |t, y: &[f64]| function(t, y)),
        ranges,
        direction: event.direction,
        effect: event.effect,
    }
}
