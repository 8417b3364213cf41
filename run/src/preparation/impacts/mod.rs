//! Runs of scenes with contacts: bodies meet, bounce, stay in contact and separate again.
//!
//! A run consists of parts. Each part ends at an event: a gap closes, or a normal force falls to
//! zero. The next part begins at that instant with the velocities from the law of impact, so no step
//! crosses a jump. All contacts that are closed at one instant are solved together
//! (`tripos_sim::ClosedContacts`). Closed contacts that would be pushed together are held closed by
//! forces ([`held_contact_motion`]). A contact with friction is also held along its slip direction while it
//! sticks ([`friction_modes`]). A new part begins when the contact starts or stops slipping.
//!
//! Ever shorter bounces would never end. So a contact is held closed if its next flight would be too
//! short or too low. The shortest flight is the fraction [`LEAST`] of the time scale of the run. The
//! lowest flight is the rounding error of the gap.
//!
//! The energy that impacts take is part of the work of the run. So the energy T + V less this work is
//! constant across impacts.

mod contact_change;
mod contact_change_records;
mod contact_events;
mod contact_impacts;
mod friction_modes;
mod held_contact_motion;
mod held_contacts;
mod missed_changes;
mod number_carrier;
mod scene_contacts;
mod short_bounces;

pub use contact_change::ContactChange;
pub use contact_impacts::StateAfterImpact;
pub use held_contact_motion::HeldContactEquations;
pub use held_contacts::{HeldContacts, NONE};
pub use number_carrier::{ContactCrossing, DoubleCarrier, Equations, GapMinimum, NumberCarrier};
pub use scene_contacts::{ContactOperators, ImpulseResponse, SceneContacts};
pub use short_bounces::notes_on_short_bounces;

use super::initial_state::InitialState;
use super::speed_changes::{join_part_solutions, options_for_next_part};
use contact_events::lend_event;
use contact_impacts::ImpactInstant;
use tripos_derive::plain_text::with_significant_digits;
use tripos_sim::{
    AccompaniedRightHandSide, Event, EventRecord, Failure, ImpactRecord, Kind, LentRightHandSide, Options,
    RightHandSide, SimError, Solution, Stop, integrate,
};
use tripos_traits::{Method, Real};

/// Function that computes the power of the loads, W, at an instant, s, in a state (q, v).
type Power<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Duration of the shortest flight between two impacts, 2⁻³⁸, as a fraction of the time scale. The
/// time scale is the larger absolute end of the span. Instants are known to about 2⁻⁵⁰ of it.
pub const LEAST: f64 = 1.0 / 274_877_906_944.0;
/// Duration of a flight below which a part of the run begins with a shorter step, as a fraction of
/// the rest of the span. With this step, the height of the flight exceeds rounding inside the step.
const SHORT: f64 = 1e-3;
/// Fraction of its reference value up to which a velocity or an acceleration along a contact counts
/// as zero.
const NOTHING: f64 = 1e-10;
/// Interval after the opening of a gap in which a minimum of this gap counts as rounding. It is a
/// fraction of the instant in s, or of 1 s if that is larger.
const OPENED: f64 = 1e-3;
/// Overlap of two bodies that a run tolerates, relative to the size of the gap's terms.
const OVERLAP: f64 = 1e-8;

/// Integration of a scene with contacts, in parts from impact to impact.
pub struct ContactRun<'a> {
    /// Contacts of the scene, prepared for the integrated variables.
    pub contacts: &'a SceneContacts<'a>,
    /// Function that makes the equations of motion without contact forces.
    pub equations: &'a Equations<'a>,
    /// Duration of the shortest flight, s.
    pub least: f64,
}

impl ContactRun<'_> {
    /// Integrates from a start over its span, forward in time, in the number type `S` of the carrier.
    /// Each change of a contact begins a new part of the run. If a run cannot continue, its solution
    /// ends there and gives the reason in `stop`.
    ///
    /// # Errors
    /// [`SimError`] if the run cannot begin: an empty span, or an option out of range.
    pub fn run_with_impacts<S: Real>(
        &self,
        carrier: &dyn NumberCarrier<S>,
        start: InitialState<'_, S>,
        options: &Options,
        events: &mut [Event<'_>],
        mut power: Option<Power<'_>>,
    ) -> Result<Solution<S>, SimError> {
        let InitialState { span, y: y0 } = start;
        let base = events.len();
        let before = round_to_doubles(y0);
        let after = match self.handle_initial_contacts(span.0, &before)? {
            Ok(after) => after,
            Err(failure) => return Ok(Solution::ended_at_start(span.0, y0, Stop::Failed(failure))),
        };
        let begins = ContactCrossing { t: span.0, contact_change: None, before: &before, kept: &NONE, after: &after };
        let mut y = carrier.state_after_crossing(&begins, y0);
        let (mut kept, mut changes) = (after.kept, 0);
        let mut whole =
            self.integrate_part(carrier, InitialState { span, y: &y }, &kept, options, events, power.as_mut())?;
        whole.events.splice(..0, self.contact_change_records_at_start(base, &kept, span.0, &after.y));
        // The first sample shows the state after the impact: its work need not be added.
        whole.impacts.extend(after.record);
        while let Some(contact_change) = self.terminal_contact_change(&whole, base) {
            let before = round_to_doubles(&whole.y_end);
            let next = self.handle_contact_change(contact_change, whole.t_end, &before, &kept)?;
            if let Ok(after) = &next {
                self.replace_friction_events(&mut whole, base, &kept, &after.kept);
            }
            whole.events.iter_mut().for_each(|event| event.terminal = false);
            match next {
                Ok(after) => {
                    let crossing = ContactCrossing {
                        t: whole.t_end,
                        contact_change: Some(contact_change),
                        before: &before,
                        kept: &kept,
                        after: &after,
                    };
                    y = carrier.state_after_crossing(&crossing, &whole.y_end);
                    kept = after.kept;
                    changes += 1;
                    set_run_state_after_jump(&mut whole, &y);
                    if let Some(record) = after.record {
                        add_impact_to_run(&mut whole, record);
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
            let mut how = options_for_next_part(options, &whole, span);
            how.step_limit = how.step_limit.saturating_sub(changes);
            let from = InitialState { span: (whole.t_end, span.1), y: &y };
            let part = self.integrate_part(carrier, from, &kept, &how, events, power.as_mut())?;
            whole = join_part_solutions(whole, part, options);
        }
        if let Stop::StepLimit { limit } = &mut whole.stop {
            *limit = options.step_limit;
        }
        Ok(whole)
    }

    /// Handles the contacts at the start of a run, at `t` s in the state `y`. Touching bodies may have an
    /// impact, stay together or separate. The inner `Failure` says that bodies overlap, or why the run
    /// cannot go on.
    ///
    /// # Errors
    /// `SimError` if the equations of motion cannot be made.
    fn handle_initial_contacts(&self, t: f64, y: &[f64]) -> Result<Result<StateAfterImpact, Failure>, SimError> {
        let rates = self.contacts.rates(y);
        let mut closed = Vec::new();
        for contact in 0..self.contacts.impacts.len() {
            let (gap, least) =
                (self.contacts.gap(contact, y), self.contacts.closing_gap(contact, y, &rates, self.least));
            if gap.is_nan() || gap < -least {
                let name = &self.contacts.impacts[contact].name;
                let message = format!(
                    "the gap of the contact `{name}` is {} at the start, and bodies do not overlap",
                    with_significant_digits(gap, 4)
                );
                return Ok(Err(Failure { code: "overlap", message }));
            }
            if gap <= least {
                closed.push(contact);
            }
        }
        if closed.is_empty() {
            return Ok(Ok(StateAfterImpact::unchanged(y)));
        }
        self.handle_closed_contacts(y, &ImpactInstant { t, closed: &closed, kept: &NONE, contact_change: None })
    }

    /// Finds the state and the held contacts after the change of a contact that ended a part of the run,
    /// at `t` s in the state `y`. The inner `Failure` says why the run cannot go on.
    ///
    /// # Errors
    /// `SimError` if the equations of motion cannot be made.
    fn handle_contact_change(
        &self,
        contact_change: ContactChange,
        t: f64,
        y: &[f64],
        kept: &HeldContacts,
    ) -> Result<Result<StateAfterImpact, Failure>, SimError> {
        if let ContactChange::Jams(contact) = contact_change {
            return Ok(Err(self.jammed_contact_failure(contact, t)));
        }
        let rates = self.contacts.rates(y);
        let is_closed = |at: &usize| {
            let closes = contact_change == ContactChange::Closes(*at);
            closes
                || kept.mode(*at).is_some()
                || self.contacts.gap(*at, y) <= self.contacts.closing_gap(*at, y, &rates, self.least)
        };
        let closed: Vec<usize> = (0..self.contacts.impacts.len()).filter(is_closed).collect();
        self.handle_closed_contacts(
            y,
            &ImpactInstant { t, closed: &closed, kept, contact_change: Some(contact_change) },
        )
    }

    /// Integrates a part of the run from a start, while the contacts `kept` are held closed, up to the
    /// next change of a contact.
    ///
    /// # Errors
    /// `SimError` if the options or the start do not fit the equations.
    fn integrate_part<S: Real>(
        &self,
        carrier: &dyn NumberCarrier<S>,
        start: InitialState<'_, S>,
        kept: &HeldContacts,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<&mut Power<'_>>,
    ) -> Result<Solution<S>, SimError> {
        let InitialState { span, y } = start;
        let base = events.len();
        let anew =
            || Ok::<_, SimError>(HeldContactEquations { rhs: (self.equations)()?, contacts: self.contacts, kept });
        let mut list = self.watched_contact_events(kept, &round_to_doubles(y), &anew)?;
        if carrier.reported_gap_limit().is_some() {
            list.extend(self.gap_minimum_events(kept));
        }
        let (may, of_contacts): (Vec<_>, Vec<_>) = list.into_iter().unzip();
        let mut watched: Vec<Event<'_>> = events.iter_mut().map(lend_event).chain(of_contacts).collect();
        let mut options = options.clone();
        if !kept.is_empty() && (options.method == Method::Taylor || options.method.needs_jacobian()) {
            options.method = Method::Dop853;
        }
        let (mut rhs, mut forces) = (carrier.equations(kept)?, anew()?);
        let own = forces.rhs.constraint_count();
        let moves = !kept.is_empty();
        let mut worked = power.map(|power| {
            move |t: f64, y: &[S]| {
                let y = round_to_doubles(y);
                power(t, &y) + if moves { forces.contact_force_power(t, &y) } else { 0.0 }
            }
        });
        let mut stepped = |t: f64, y: Option<&[S]>| {
            if y.is_some() {
                carrier.record_step_end(t);
            }
            false
        };
        let mut with = AccompaniedRightHandSide {
            rhs: rhs.as_mut(),
            power: worked.as_mut().map(|power| power as &mut dyn FnMut(f64, &[S]) -> f64),
            over: Some(&mut stepped),
            yields: None,
        };
        // Long steps on a smooth solution would hide a flight that is far shorter. Most methods lose it in
        // the rounding of the solution inside the step. Taylor's method loses it between the instants at
        // which events are evaluated.
        if options.step.is_none() {
            let flight = self.first_flight(&mut anew()?, span.0, &round_to_doubles(y));
            let first = flight.and_then(|flight| match options.method {
                Method::Taylor => Some(flight),
                // The flight ends inside the second step.
                _ => (flight < SHORT * (span.1 - span.0)).then_some(0.7 * flight),
            });
            options.initial_step = options.initial_step.into_iter().chain(first).reduce(f64::min);
        }
        let mut part =
            integrate(LentRightHandSide(&mut with as &mut dyn RightHandSide<S>), span, y, &options, &mut watched)?;
        drop(watched);
        for event in &mut part.events {
            if let Some(contact_change) = event.event.checked_sub(base).map(|at| may[at]) {
                event.event = base + contact_change.event_number(self.contacts.impacts.len());
            }
        }
        self.report_gap_minima(carrier, &mut part, base, span.0, &round_to_doubles(y));
        self.remove_contact_events_and_check(&mut part, base, own, &mut anew()?);
        Ok(part)
    }

    /// Reports to the carrier the minima of gaps that are close to zero. Then removes the events of all
    /// minima from a part of a run. The part began at `begun`, s, in the state `y`. `base` is the
    /// number of events that belong to no contact.
    fn report_gap_minima<S: Real>(
        &self,
        carrier: &dyn NumberCarrier<S>,
        part: &mut Solution<S>,
        base: usize,
        begun: f64,
        y: &[f64],
    ) {
        let Some(near) = carrier.reported_gap_limit() else { return };
        let count = self.contacts.impacts.len();
        let nears = |event: &EventRecord| match ContactChange::from_event_number(event.event.checked_sub(base)?, count)
        {
            Some(ContactChange::Nears(contact)) => Some(contact),
            _ => None,
        };
        for event in part.events.iter().filter(|event| event.kind == Kind::Rising) {
            let Some(contact) = nears(event) else { continue };
            let states = part.y.iter().map(|y| round_to_doubles(y)).chain([event.y.clone()]);
            let size = states.map(|y| self.contacts.gap_term_size(contact, &y)).fold(0.0, f64::max);
            // A gap that has just opened grows from zero.
            let opens = self.contacts.gap(contact, y) <= near * size;
            let has_opened = opens && event.t - begun <= OPENED * event.t.abs().max(1.0);
            if !has_opened && self.contacts.gap(contact, &event.y) <= near * size {
                carrier.record_gap_minimum(&GapMinimum { contact, t: event.t, y: event.y.clone() });
            }
        }
        part.events.retain(|event| nears(event).is_none());
    }

    /// Duration, s, of the shortest flight of the contacts that open at the start `t` of a part of the
    /// run. A flight lasts from opening to closing. `None` if no contact opens, or the equations have
    /// no value at `t`.
    fn first_flight(&self, motion: &mut HeldContactEquations<'_>, t: f64, y: &[f64]) -> Option<f64> {
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

    /// Removes from a part of a run the contacts' events at the start and at poles, and the corrections
    /// onto the held contacts. The part fails if its events missed a change of a contact, or if its
    /// states could not be kept on the held contacts. `base` is the number of events, and `own` the
    /// number of constraints, that belong to no contact.
    fn remove_contact_events_and_check<S: Real>(
        &self,
        part: &mut Solution<S>,
        base: usize,
        own: usize,
        forces: &mut HeldContactEquations<'_>,
    ) {
        let kept = forces.kept;
        // A contact function that is zero at the start is no event of the user. A force that grows without
        // bound is none either.
        part.events.retain(|event| event.event < base || !matches!(event.kind, Kind::AtStart | Kind::Pole));
        let failure = if part.stop.is_failure() {
            self.missed_jamming(part, forces)
        } else {
            self.missed_closing(part, kept).or_else(|| self.missed_friction_change(part, forces))
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

    /// Finds the change of a contact that ended the latest part of a run. `None` if the part ended for
    /// another reason. `base` is the number of events that belong to no contact.
    fn terminal_contact_change<S>(&self, whole: &Solution<S>, base: usize) -> Option<ContactChange> {
        let Stop::Event { .. } = whole.stop else { return None };
        // The first event of an instant decides, and the user's events are listed before those of contacts.
        let first = whole.events.iter().find(|event| event.terminal)?;
        ContactChange::from_event_number(first.event.checked_sub(base)?, self.contacts.impacts.len())
    }
}

/// Rounds a state to doubles. Derivatives that accompany its numbers are dropped.
fn round_to_doubles<S: Real>(y: &[S]) -> Vec<f64> {
    y.iter().map(|y| y.to_f64()).collect()
}

/// Adds the record of an impact at the end of the run `whole` to its impacts, and the energy of the
/// impact to its work.
fn add_impact_to_run<S>(whole: &mut Solution<S>, record: ImpactRecord) {
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

/// Replaces the state at the end of the run `whole`, and its sample there if it has one, by the
/// state `y` after a jump.
fn set_run_state_after_jump<S: Real>(whole: &mut Solution<S>, y: &[S]) {
    if whole.t.last().is_some_and(|t| t.total_cmp(&whole.t_end).is_eq())
        && let Some(last) = whole.y.last_mut()
    {
        last.copy_from_slice(y);
    }
    whole.y_end.copy_from_slice(y);
}
