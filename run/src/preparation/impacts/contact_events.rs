//! Events that end a part of a run with contacts: a gap closes, a normal force falls to zero, a
//! tangential force exceeds its friction limit, or a slip ends.

use super::ContactRun;
use super::contact_change::ContactChange;
use super::held_contact_motion::HeldContactEquations;
use super::held_contacts::HeldContacts;
use tripos_sim::{ContactMode, Direction, Effect, Event, InRanges, SimError};
use tripos_traits::{Enclosure, Scalar};

/// Smallest absolute determinant at which the linear system for contact forces counts as regular,
/// relative to its value without slip. A smaller determinant is a rounding error.
const TOLD: f64 = 1e-9;

impl ContactRun<'_> {
    /// Lists the events to watch from the state `y` on, while the contacts `kept` are held closed. Each
    /// event comes with the change of a contact that it reports. `anew` makes the equations of motion
    /// with contact forces. It is called once for each event that watches a force.
    ///
    /// # Errors
    /// `SimError` if `anew` cannot make the equations.
    pub(super) fn watched_contact_events<'e>(
        &'e self,
        kept: &'e HeldContacts,
        y: &[f64],
        anew: &dyn Fn() -> Result<HeldContactEquations<'e>, SimError>,
    ) -> Result<Vec<(ContactChange, Event<'e>)>, SimError> {
        let mut list = Vec::new();
        for contact in 0..self.contacts.impacts.len() {
            let Some(mode) = kept.mode(contact) else {
                list.push((ContactChange::Closes(contact), self.gap_closing_event(contact)));
                continue;
            };
            let mut forces = anew()?;
            let opens = move |t: f64, y: &[f64]| forces.normal_force(contact, t, y);
            list.push(self.falling_event(ContactChange::Opens(contact), opens));
            match mode {
                ContactMode::Sticks => {
                    let mut forces = anew()?;
                    let margin = move |t: f64, y: &[f64]| forces.friction_margin(contact, t, y);
                    list.push(self.falling_event(ContactChange::Slips(contact), margin));
                }
                ContactMode::Slips(way) if self.contacts.is_rough(contact) => {
                    list.extend(self.slip_end_event(contact, way));
                }
                ContactMode::Slips(_) | ContactMode::Pushes | ContactMode::Opens => {}
            }
        }
        let forces = anew()?;
        if let (Some((first, _)), true) = (kept.slipping().next(), forces.contact_force_determinant(y).abs() > TOLD) {
            let (jams, event) =
                self.falling_event(ContactChange::Jams(first), move |_, y: &[f64]| forces.contact_force_determinant(y));
            list.push((jams, Event { direction: Direction::Either, ..event }));
        }
        Ok(list)
    }

    /// Makes the events that record the minima of open gaps, one for each contact that is not held
    /// closed. Such an event does not stop the run.
    pub(super) fn gap_minimum_events(&self, kept: &HeldContacts) -> Vec<(ContactChange, Event<'_>)> {
        let contacts = self.contacts;
        let free = (0..contacts.impacts.len()).filter(|contact| kept.mode(*contact).is_none());
        let event = |contact: usize| {
            let row = contacts.rows[contact][0];
            let contact_change = ContactChange::Nears(contact);
            let rate = move |_: f64, y: &[f64]| contacts.rates(y).values[row];
            (contact_change, Event::recorded(contact_change.name(contacts.impacts), Direction::Rising, rate))
        };
        free.map(event).collect()
    }

    /// Makes the event that stops the run when the gap of a contact closes. Enclosures (intervals that
    /// contain the gap over a whole step) ensure that no closing inside a step is missed.
    fn gap_closing_event(&self, contact: usize) -> Event<'_> {
        let contacts = self.contacts;
        let p = contacts.parameters;
        let n = contacts.system.lengths().coordinates;
        let (numbers, ranges) = &contacts.gaps[contact];
        let used = ranges.used_inputs().into_iter().filter_map(|at| at.checked_sub(p.len())).collect();
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

    /// Makes the event for the end of a contact's slip. `way` is the sign of the slip velocity. `None`
    /// if the contact has no friction.
    fn slip_end_event(&self, contact: usize, way: f64) -> Option<(ContactChange, Event<'_>)> {
        let p = self.contacts.parameters;
        let (numbers, ranges) = self.contacts.slips[contact].as_ref()?;
        let used = ranges.used_inputs().into_iter().filter_map(|at| at.checked_sub(p.len())).collect();
        let wide: Vec<Enclosure> = p.iter().map(|p| Enclosure::from_f64(*p)).collect();
        let (mut scratch, mut wide_scratch) = (Vec::new(), Vec::new());
        let function = move |_: f64, y: &[f64]| {
            let mut out = [0.0];
            numbers.evaluate_into(&[p, y].concat(), &mut scratch, &mut out);
            way * out[0]
        };
        let in_ranges = move |_: Enclosure, y: &[Enclosure]| {
            let mut out = [Enclosure::from_f64(0.0)];
            let inputs: Vec<Enclosure> = wide.iter().chain(y).copied().collect();
            ranges.evaluate_into(&inputs, &mut wide_scratch, &mut out);
            Enclosure::from_f64(way) * out[0]
        };
        let (contact_change, event) = self.falling_event(ContactChange::Sticks(contact), function);
        let ranges = Some(InRanges { function: Box::new(in_ranges), components: Some(used) });
        Some((contact_change, Event { ranges, ..event }))
    }

    /// Makes the event that ends a part of a run when a function falls below zero. Returns it with the
    /// change of a contact that it reports.
    fn falling_event<'e>(
        &self,
        contact_change: ContactChange,
        function: impl FnMut(f64, &[f64]) -> f64 + 'e,
    ) -> (ContactChange, Event<'e>) {
        let name = contact_change.name(self.contacts.impacts);
        (contact_change, Event::terminal(name, Direction::Falling, function))
    }
}

/// Makes an event for one part of a run that borrows the function of the caller's event `event`. The
/// caller can use its event again in the next part.
pub fn lend_event<'e>(event: &'e mut Event<'_>) -> Event<'e> {
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
