//! Event records of contacts with friction that begin to stick, slip, reverse or open.

use super::happening::Happening;
use super::kept::Kept;
use super::{Bouncing, values};
use tripos_sim::{EventRecord, Kind, Mode, Solution};
use tripos_traits::Real;

impl Bouncing<'_> {
    /// Events at the start of a run, at `t` s in the state `y`: one for each held contact, and one for each held contact that slips or sticks.
    pub(super) fn at_start(&self, base: usize, kept: &Kept, t: f64, y: &[f64]) -> Vec<EventRecord> {
        let closed = kept.which.iter().map(|at| Happening::Closes(*at));
        let rough = kept.iter().filter_map(|(at, mode)| begun(at, None, Some(mode)));
        closed.chain(rough).map(|happening| self.record(base, happening, t, y, Kind::AtStart)).collect()
    }

    /// Replaces the events of contacts with friction that ended a part of a run by events for the modes that begin at
    /// that instant.
    pub(super) fn tell<S: Real>(&self, whole: &mut Solution<S>, base: usize, before: &Kept, after: &Kept) {
        let count = self.contacts.impacts.len();
        let is_rough = |event: &EventRecord| {
            let happening = event.event.checked_sub(base).and_then(|event| Happening::of_event(event, count));
            let changes = happening.filter(|happening| !matches!(happening, Happening::Closes(_)));
            event.terminal && changes.is_some_and(|happening| self.contacts.friction(happening.contact()).is_some())
        };
        whole.events.retain(|event| !is_rough(event));
        let y = values(&whole.y_end);
        for contact in (0..count).filter(|at| self.contacts.friction(*at).is_some()) {
            if let Some(happening) = begun(contact, before.mode(contact), after.mode(contact)) {
                whole.events.push(self.record(base, happening, whole.t_end, &y, Kind::Falling));
            }
        }
    }

    /// Makes the event record of a change of a contact.
    fn record(&self, base: usize, happening: Happening, t: f64, y: &[f64], kind: Kind) -> EventRecord {
        let event = base + happening.event(self.contacts.impacts.len());
        let name = happening.name(self.contacts.impacts);
        EventRecord { event, name, t, y: y.to_vec(), kind, terminal: false }
    }
}

/// Change of a contact with friction between its modes before and after; `None` if nothing new begins. A mode is `None`
/// while the contact is not held.
fn begun(contact: usize, before: Option<Mode>, after: Option<Mode>) -> Option<Happening> {
    match (before, after) {
        (Some(_), None) => Some(Happening::Opens(contact)),
        (Some(Mode::Slips(one)), Some(Mode::Slips(other))) => {
            (one * other < 0.0).then_some(Happening::Reverses(contact))
        }
        (_, Some(Mode::Slips(_))) => Some(Happening::Slips(contact)),
        (Some(Mode::Sticks), Some(Mode::Sticks)) => None,
        (_, Some(Mode::Sticks)) => Some(Happening::Sticks(contact)),
        _ => None,
    }
}
