//! Event records of contacts with friction that begin to stick, slip, reverse their slip or open.

use super::contact_change::ContactChange;
use super::held_contacts::HeldContacts;
use super::{ContactRun, round_to_doubles};
use tripos_sim::{ContactMode, EventRecord, Kind, Solution};
use tripos_traits::Real;

impl ContactRun<'_> {
    /// Makes the event records at the start of a run, at `t` s in the state `y`. Each held contact gives
    /// one record. A held contact with friction gives a second record, which tells if it slips or
    /// sticks. `base` is the number of events that belong to no contact.
    pub(super) fn contact_change_records_at_start(
        &self,
        base: usize,
        kept: &HeldContacts,
        t: f64,
        y: &[f64],
    ) -> Vec<EventRecord> {
        let closed = kept.which.iter().map(|at| ContactChange::Closes(*at));
        let rough = kept.iter().filter_map(|(at, mode)| recorded_friction_change(at, None, Some(mode)));
        closed
            .chain(rough)
            .map(|contact_change| self.contact_change_record(base, contact_change, t, y, Kind::AtStart))
            .collect()
    }

    /// Replaces the event records of contacts with friction at the end of the run `whole`. The old
    /// records ended a part of the run. The new records tell which modes, such as sticking, begin then.
    /// `base` is the number of events that belong to no contact.
    pub(super) fn replace_friction_events<S: Real>(
        &self,
        whole: &mut Solution<S>,
        base: usize,
        before: &HeldContacts,
        after: &HeldContacts,
    ) {
        let count = self.contacts.impacts.len();
        let is_rough = |event: &EventRecord| {
            let contact_change =
                event.event.checked_sub(base).and_then(|event| ContactChange::from_event_number(event, count));
            let changes = contact_change.filter(|contact_change| !matches!(contact_change, ContactChange::Closes(_)));
            event.terminal
                && changes.is_some_and(|contact_change| self.contacts.friction(contact_change.contact()).is_some())
        };
        whole.events.retain(|event| !is_rough(event));
        let y = round_to_doubles(&whole.y_end);
        for contact in (0..count).filter(|at| self.contacts.friction(*at).is_some()) {
            if let Some(contact_change) = recorded_friction_change(contact, before.mode(contact), after.mode(contact)) {
                whole.events.push(self.contact_change_record(base, contact_change, whole.t_end, &y, Kind::Falling));
            }
        }
    }

    /// Makes the event record of a contact's change at `t` s in the state `y`. `base` is the number of
    /// events that belong to no contact.
    fn contact_change_record(
        &self,
        base: usize,
        contact_change: ContactChange,
        t: f64,
        y: &[f64],
        kind: Kind,
    ) -> EventRecord {
        let event = base + contact_change.event_number(self.contacts.impacts.len());
        let name = contact_change.name(self.contacts.impacts);
        EventRecord { event, name, t, y: y.to_vec(), kind, terminal: false }
    }
}

/// Compares the modes of a contact with friction before and after an instant, and returns the change
/// of the contact that begins then. `None` if the mode stays the same. A mode of `None` means that
/// the contact is not held closed.
fn recorded_friction_change(
    contact: usize,
    before: Option<ContactMode>,
    after: Option<ContactMode>,
) -> Option<ContactChange> {
    match (before, after) {
        (Some(_), None) => Some(ContactChange::Opens(contact)),
        (Some(ContactMode::Slips(one)), Some(ContactMode::Slips(other))) => {
            (one * other < 0.0).then_some(ContactChange::Reverses(contact))
        }
        (_, Some(ContactMode::Slips(_))) => Some(ContactChange::Slips(contact)),
        (Some(ContactMode::Sticks), Some(ContactMode::Sticks)) => None,
        (_, Some(ContactMode::Sticks)) => Some(ContactChange::Sticks(contact)),
        _ => None,
    }
}
