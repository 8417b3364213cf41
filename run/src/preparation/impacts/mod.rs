//! Runs of scenes with contacts: bodies meet, bounce, stay together and part again.
//!
//! A run consists of parts. Each part ends at the root of a gap that closes, or of a force that no longer pushes. The
//! next part begins at that instant with the velocities that the law of impact leaves: no step crosses a jump. The
//! effect of an impact follows from all contacts that are closed at its instant together ([`tripos_sim::Closed`]).
//! Closed contacts that would be pushed together are held ([`held_motion`]). A contact with friction is held along its
//! gap, and along its slip while it sticks ([`friction_modes`]). Another part begins where it begins or ceases to slip.
//!
//! Bounces that become ever shorter have no end in numbers. So the contact is held if its next flight would be shorter
//! than [`LEAST`] of the time scale, or no higher than the rounding of its gap.
//!
//! The work of impacts is part of the work of the run, so that T + V less the work is constant across them.

mod carrier;
mod changes;
mod contact_change;
mod contact_events;
mod contacts;
mod friction_modes;
mod held_contacts;
mod held_motion;
mod meeting;
mod missed_changes;
mod short_bounces;

pub use carrier::{Approach, Carrier, Crossing, Doubles, Equations};
pub use contact_change::ContactChange;
pub use contacts::{Contacts, Operators, Response};
pub use held_contacts::{HeldContacts, NONE};
pub use held_motion::Held;
pub use meeting::After;
pub use short_bounces::notes_on_short_bounces;

use super::initial::InitialState;
use super::passage::{joined, rest};
use contact_events::passed_on;
use meeting::Meeting;
use tripos_derive::plain::significant;
use tripos_sim::{
    Accompanied, Event, EventRecord, Failure, ImpactRecord, Kind, Lent, Options, RightHandSide, SimError, Solution,
    Stop, integrate,
};
use tripos_traits::{Method, Real};

/// Function that gives the power at an instant and a state, W.
type Power<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Duration of the shortest flight, 2⁻³⁸, relative to the time scale, which is the later of the ends of the span.
/// Instants are known to some 2⁻⁵⁰ of the time scale.
pub const LEAST: f64 = 1.0 / 274_877_906_944.0;
/// Duration of a flight, relative to the rest of the span, below which the run begins with a shorter step. The
/// height of a flight is then above the rounding of the solution inside the step.
const SHORT: f64 = 1e-3;
/// Ratio to its reference value up to which a velocity or an acceleration along a contact counts as zero.
const NOTHING: f64 = 1e-10;
/// Time after the opening of a gap within which a minimum counts as rounding, over the larger of the instant and 1 s.
const OPENED: f64 = 1e-3;
/// Overlap up to which a gap does not count as negative, relative to the size of the gap's terms.
const OVERLAP: f64 = 1e-8;

/// A run with contacts under way.
pub struct Bouncing<'a> {
    pub contacts: &'a Contacts<'a>,
    pub equations: &'a Equations<'a>,
    /// Duration of the shortest flight, s.
    pub least: f64,
}

impl Bouncing<'_> {
    /// Integrates from a start over its span, which goes forward in time, in the numbers of a carrier. Passes from one
    /// part of the run to the next at each change of a contact.
    ///
    /// # Errors
    /// [`SimError`] if the run cannot begin: an empty span, or an option out of range.
    pub fn solve<S: Real>(
        &self,
        carrier: &dyn Carrier<S>,
        start: InitialState<'_, S>,
        options: &Options,
        events: &mut [Event<'_>],
        mut power: Option<Power<'_>>,
    ) -> Result<Solution<S>, SimError> {
        let InitialState { span, y: y0 } = start;
        let base = events.len();
        let before = values(y0);
        let after = match self.begin(span.0, &before)? {
            Ok(after) => after,
            Err(failure) => return Ok(Solution::unbegun(span.0, y0, Stop::Failed(failure))),
        };
        let begins = Crossing { t: span.0, contact_change: None, before: &before, kept: &NONE, after: &after };
        let mut y = carrier.across(&begins, y0);
        let (mut kept, mut changes) = (after.kept, 0);
        let mut whole = self.part(carrier, InitialState { span, y: &y }, &kept, options, events, power.as_mut())?;
        whole.events.splice(..0, self.at_start(base, &kept, span.0, &after.y));
        // The first sample shows the state after the impact: its work need not be added.
        whole.impacts.extend(after.record);
        while let Some(contact_change) = self.contact_change(&whole, base) {
            let before = values(&whole.y_end);
            let next = self.next(contact_change, whole.t_end, &before, &kept)?;
            if let Ok(after) = &next {
                self.tell(&mut whole, base, &kept, &after.kept);
            }
            whole.events.iter_mut().for_each(|event| event.terminal = false);
            match next {
                Ok(after) => {
                    let crossing = Crossing {
                        t: whole.t_end,
                        contact_change: Some(contact_change),
                        before: &before,
                        kept: &kept,
                        after: &after,
                    };
                    y = carrier.across(&crossing, &whole.y_end);
                    kept = after.kept;
                    changes += 1;
                    jumped(&mut whole, &y);
                    if let Some(record) = after.record {
                        count(&mut whole, record);
                    }
                }
                Err(failure) => {
                    whole.stop = Stop::Failed(failure);
                    break;
                }
            }
            if whole.t_end >= span.1 {
                whole.stop = Stop::End;
                break;
            }
            let mut how = rest(options, &whole, span);
            how.step_limit = how.step_limit.saturating_sub(changes);
            let from = InitialState { span: (whole.t_end, span.1), y: &y };
            let part = self.part(carrier, from, &kept, &how, events, power.as_mut())?;
            whole = joined(whole, part, options);
        }
        if let Stop::StepLimit { limit } = &mut whole.stop {
            *limit = options.step_limit;
        }
        Ok(whole)
    }

    /// Handles the start of a run: refuses bodies that overlap. Bodies that touch may hit, be held or part.
    fn begin(&self, t: f64, y: &[f64]) -> Result<Result<After, Failure>, SimError> {
        let rates = self.contacts.rates(y);
        let mut closed = Vec::new();
        for contact in 0..self.contacts.impacts.len() {
            let (gap, least) =
                (self.contacts.gap(contact, y), self.contacts.closing_gap(contact, y, &rates, self.least));
            if gap.is_nan() || gap < -least {
                let name = &self.contacts.impacts[contact].name;
                let message = format!(
                    "the gap of the contact `{name}` is {} at the start, and bodies do not overlap",
                    significant(gap, 4)
                );
                return Ok(Err(Failure { code: "overlap", message }));
            }
            if gap <= least {
                closed.push(contact);
            }
        }
        if closed.is_empty() {
            return Ok(Ok(After::unchanged(y)));
        }
        self.meet(y, &Meeting { t, closed: &closed, kept: &NONE, contact_change: None })
    }

    /// Finds the state and the held contacts after the end of a part of the run.
    fn next(
        &self,
        contact_change: ContactChange,
        t: f64,
        y: &[f64],
        kept: &HeldContacts,
    ) -> Result<Result<After, Failure>, SimError> {
        if let ContactChange::Jams(contact) = contact_change {
            return Ok(Err(self.jams(contact, t)));
        }
        let rates = self.contacts.rates(y);
        let is_closed = |at: &usize| {
            let closes = contact_change == ContactChange::Closes(*at);
            closes
                || kept.mode(*at).is_some()
                || self.contacts.gap(*at, y) <= self.contacts.closing_gap(*at, y, &rates, self.least)
        };
        let closed: Vec<usize> = (0..self.contacts.impacts.len()).filter(is_closed).collect();
        self.meet(y, &Meeting { t, closed: &closed, kept, contact_change: Some(contact_change) })
    }

    /// Integrates a part of the run in which the contacts `kept` are held.
    fn part<S: Real>(
        &self,
        carrier: &dyn Carrier<S>,
        start: InitialState<'_, S>,
        kept: &HeldContacts,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<&mut Power<'_>>,
    ) -> Result<Solution<S>, SimError> {
        let InitialState { span, y } = start;
        let base = events.len();
        let anew = || Ok::<_, SimError>(Held { rhs: (self.equations)()?, contacts: self.contacts, kept });
        let mut list = self.watched(kept, &values(y), &anew)?;
        if carrier.near().is_some() {
            list.extend(self.approaches(kept));
        }
        let (may, of_contacts): (Vec<_>, Vec<_>) = list.into_iter().unzip();
        let mut watched: Vec<Event<'_>> = events.iter_mut().map(passed_on).chain(of_contacts).collect();
        let mut options = options.clone();
        if !kept.is_empty() && (options.method == Method::Taylor || options.method.needs_jacobian()) {
            options.method = Method::Dop853;
        }
        let (mut rhs, mut forces) = (carrier.equations(kept)?, anew()?);
        let own = forces.rhs.constraint_count();
        let moves = !kept.is_empty();
        let mut worked = power.map(|power| {
            move |t: f64, y: &[S]| {
                let y = values(y);
                power(t, &y) + if moves { forces.power(t, &y) } else { 0.0 }
            }
        });
        let mut stepped = |t: f64, y: Option<&[S]>| {
            if y.is_some() {
                carrier.stepped(t);
            }
            false
        };
        let mut with = Accompanied {
            rhs: rhs.as_mut(),
            power: worked.as_mut().map(|power| power as &mut dyn FnMut(f64, &[S]) -> f64),
            over: Some(&mut stepped),
            yields: None,
        };
        // Long steps on a smooth solution would hide a flight that is far shorter: of any method in the rounding of the
        // solution inside the step, of Taylor's method between the places at which it is looked at.
        if options.step.is_none() {
            let flight = self.first_flight(&mut anew()?, span.0, &values(y));
            let first = flight.and_then(|flight| match options.method {
                Method::Taylor => Some(flight),
                // The flight ends inside the second step.
                _ => (flight < SHORT * (span.1 - span.0)).then_some(0.7 * flight),
            });
            options.initial_step = options.initial_step.into_iter().chain(first).reduce(f64::min);
        }
        let mut part = integrate(Lent(&mut with as &mut dyn RightHandSide<S>), span, y, &options, &mut watched)?;
        drop(watched);
        for event in &mut part.events {
            if let Some(contact_change) = event.event.checked_sub(base).map(|at| may[at]) {
                event.event = base + contact_change.event(self.contacts.impacts.len());
            }
        }
        self.tell_approaches(carrier, &mut part, base, span.0, &values(y));
        self.tidy(&mut part, base, own, &mut anew()?);
        Ok(part)
    }

    /// Reports minima of gaps that are close to zero to the carrier, and removes the events of all minima from a part
    /// of a run. The part began at `begun`, s, in the state `y`. `base` is the number of events that belong to no
    /// contact.
    fn tell_approaches<S: Real>(
        &self,
        carrier: &dyn Carrier<S>,
        part: &mut Solution<S>,
        base: usize,
        begun: f64,
        y: &[f64],
    ) {
        let Some(near) = carrier.near() else { return };
        let count = self.contacts.impacts.len();
        let nears = |event: &EventRecord| match ContactChange::of_event(event.event.checked_sub(base)?, count) {
            Some(ContactChange::Nears(contact)) => Some(contact),
            _ => None,
        };
        for event in part.events.iter().filter(|event| event.kind == Kind::Rising) {
            let Some(contact) = nears(event) else { continue };
            let states = part.y.iter().map(|y| values(y)).chain([event.y.clone()]);
            let size = states.map(|y| self.contacts.made_of(contact, &y)).fold(0.0, f64::max);
            // A gap that has just opened grows from zero.
            let opens = self.contacts.gap(contact, y) <= near * size;
            let has_opened = opens && event.t - begun <= OPENED * event.t.abs().max(1.0);
            if !has_opened && self.contacts.gap(contact, &event.y) <= near * size {
                carrier.nears(&Approach { contact, t: event.t, y: event.y.clone() });
            }
        }
        part.events.retain(|event| nears(event).is_none());
    }

    /// Duration of the shortest flight, from opening to closing, of the contacts that open at the start of a part of
    /// the run, s. `None` if no contact opens.
    fn first_flight(&self, motion: &mut Held<'_>, t: f64, y: &[f64]) -> Option<f64> {
        let mut slopes = vec![0.0; y.len()];
        // The run itself reports equations that fail at its start.
        motion.rhs(t, y, &mut slopes).ok()?;
        let (contacts, rates) = (self.contacts, self.contacts.rates(y));
        let flight = |contact: usize| {
            let row = contacts.rows[contact][0];
            let velocity = rates.values[row];
            let acceleration: f64 = rates.slopes.row(row).iter().zip(&slopes).map(|(slope, x)| slope * x).sum();
            let parts = contacts.gap(contact, y) <= contacts.closing_gap(contact, y, &rates, self.least);
            (parts && velocity > 0.0 && acceleration < 0.0).then(|| -2.0 * velocity / acceleration)
        };
        let free = (0..contacts.impacts.len()).filter(|contact| motion.kept.mode(*contact).is_none());
        free.filter_map(flight).reduce(f64::min)
    }

    /// Removes the events and projections of the contacts from a part of a run. The part fails if its state could not
    /// be kept on the held contacts. `base` is the number of events that belong to no contact, `own` the number of
    /// constraints that belong to none.
    fn tidy<S: Real>(&self, part: &mut Solution<S>, base: usize, own: usize, forces: &mut Held<'_>) {
        let kept = forces.kept;
        // A function that starts on a contact begins at 0, and a force that grows without bound does not cross 0.
        part.events.retain(|event| event.event < base || !matches!(event.kind, Kind::AtStart | Kind::Pole));
        let failure = if part.stop.is_failure() {
            self.jammed(part, forces)
        } else {
            self.overlapping(part, kept).or_else(|| self.unseen(part, forces))
        };
        if let Some(failure) = failure {
            part.stop = Stop::Failed(failure);
        }
        if let Some(mut report) = part.projection.take() {
            if !kept.is_empty() && report.singular + report.not_converged > 0 && !part.stop.is_failure() {
                let message = "the state could not be kept on the contacts that are held".to_owned();
                part.stop = Stop::Failed(Failure { code: "contact", message });
            }
            report.removed.truncate(own);
            report.largest.truncate(own);
            part.projection = (own > 0).then_some(report);
        }
    }

    /// Change of a contact that ended the latest part of a run; `None` if the part ended for another reason. `base` is
    /// the number of events that belong to no contact.
    fn contact_change<S>(&self, whole: &Solution<S>, base: usize) -> Option<ContactChange> {
        let Stop::Event { .. } = whole.stop else { return None };
        // The first event of an instant counts: other events come before contacts.
        let first = whole.events.iter().find(|event| event.terminal)?;
        ContactChange::of_event(first.event.checked_sub(base)?, self.contacts.impacts.len())
    }
}

/// Rounds a state to doubles.
fn values<S: Real>(y: &[S]) -> Vec<f64> {
    y.iter().map(|y| y.to_f64()).collect()
}

/// Adds an impact at the end of a run to its impacts and its work. The sample at that instant shows the state after the
/// impact.
fn count<S>(whole: &mut Solution<S>, record: ImpactRecord) {
    let gained = record.work - record.loss;
    whole.impacts.push(record);
    if whole.work.is_empty() {
        return;
    }
    whole.work_end += gained;
    if whole.t.last().is_some_and(|t| t.total_cmp(&whole.t_end).is_eq())
        && let Some(last) = whole.work.last_mut()
    {
        *last += gained;
    }
}

/// Sets the end of a run, and the sample at its end if there is one, to the state after velocities jumped.
fn jumped<S: Real>(whole: &mut Solution<S>, y: &[S]) {
    if whole.t.last().is_some_and(|t| t.total_cmp(&whole.t_end).is_eq())
        && let Some(last) = whole.y.last_mut()
    {
        last.copy_from_slice(y);
    }
    whole.y_end.copy_from_slice(y);
}
