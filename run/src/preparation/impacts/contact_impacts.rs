//! Impacts of contacts that are closed together at one instant, and the contacts that are held
//! closed afterwards.

use super::contact_change::ContactChange;
use super::held_contact_motion::{HeldContactEquations, ROUNDED};
use super::held_contacts::{HeldContacts, NONE};
use super::missed_changes::NEARLY;
use super::scene_contacts::ImpulseResponse;
use super::{ContactRun, NOTHING};
use nalgebra::DVector;
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_sim::{ContactMode, Failure, ImpactRecord, SimError};

/// Instant ("meeting") at which contacts are closed and an impact or a change of held contacts is due,
/// with its cause.
pub struct ImpactInstant<'m> {
    /// Time of the instant, s.
    pub t: f64,
    /// Indices of all contacts that are closed at this instant.
    pub closed: &'m [usize],
    /// Contacts that were held closed until this instant, each with its mode.
    pub kept: &'m HeldContacts,
    /// Change of a contact that caused the impact or the new held contacts; `None` at the start of the
    /// run.
    pub contact_change: Option<ContactChange>,
}

impl ImpactInstant<'_> {
    /// Index of the contact that opens at this instant; `None` if no contact opens.
    fn opening_contact(&self) -> Option<usize> {
        match self.contact_change {
            Some(ContactChange::Opens(contact)) => Some(contact),
            _ => None,
        }
    }
}

/// Closed contacts at an instant, after the impact if there was one, with the reference speeds that
/// decide which velocities count as zero.
pub struct ContactInstantAfterImpact<'m> {
    /// Instant, with the closed contacts and the cause.
    pub meeting: &'m ImpactInstant<'m>,
    /// Change of each gap and slip velocity by the impacts, for all contacts; `None` without an impact.
    pub changes: Option<&'m DVector<f64>>,
    /// Reference speed of each gap and slip velocity: a velocity far below it counts as zero.
    pub scale: &'m DVector<f64>,
    /// Size below which accelerations remove a gap or slip velocity within the shortest flight, for each
    /// gap and slip direction of all contacts.
    pub slowest: &'m DVector<f64>,
    /// Accelerations along the gap and slip directions of all contacts just before this instant.
    pub before: &'m DVector<f64>,
    /// True if the forces of slipping contacts were about to grow without bound before this instant.
    pub is_jamming: bool,
}

impl ContactInstantAfterImpact<'_> {
    /// True if an impact changed a gap or slip velocity of one contact. `rows` are the indices of the
    /// gap and slip velocities of this contact.
    pub fn is_hit(&self, rows: &[usize]) -> bool {
        self.changes.is_some_and(|changes| rows.iter().any(|row| changes[*row] != 0.0))
    }
}

/// Contacts that are held closed after an impact, and contacts whose next flight would be too short to
/// resolve.
struct SettledContacts {
    /// Contacts that are held closed, each with its mode.
    kept: HeldContacts,
    /// Indices of the contacts whose next flight would be too short to resolve.
    short: Vec<usize>,
    /// Contacts whose next flight would be too short and that no force holds closed, each with the mode
    /// that it would have.
    more: HeldContacts,
}

/// Largest number of impacts that may follow one another at one instant. More impacts are an error.
const MOST: usize = 1_000;

/// State after an instant at which contacts were closed and velocities may have jumped, and the
/// contacts that are held closed from then on.
#[derive(Clone, Debug)]
pub struct StateAfterImpact {
    /// State (q, v) after all impacts of the instant.
    pub y: Vec<f64>,
    /// Record of the impact; `None` if there was no impact.
    pub record: Option<ImpactRecord>,
    /// Contacts that are held closed from this instant on, each with its mode.
    pub kept: HeldContacts,
    /// Indices of the contacts that were closed at the instant.
    pub closed: Vec<usize>,
    /// Indices of the contacts that took part in each impact of the instant, one list for each impact.
    /// An impact that closes a contact again causes a further impact at the same instant. Empty if there
    /// was no impact.
    pub hits: Vec<Vec<usize>>,
    /// Contacts whose remaining small velocities were removed by impulses after the impacts, each with
    /// its mode during these impulses.
    pub rested: HeldContacts,
}

impl StateAfterImpact {
    /// Makes the result for a state at which no contact is closed: the state is unchanged, and no
    /// contact is held.
    pub fn unchanged(y: &[f64]) -> Self {
        let none = HeldContacts::default;
        Self { y: y.to_vec(), record: None, kept: none(), closed: Vec::new(), hits: Vec::new(), rested: none() }
    }
}

/// Impacts at one instant: their total effect, and the contacts that took part.
struct ImpactResult {
    /// State after the impacts, with the total impulses and energies.
    blow: ImpulseEffect,
    /// Indices of the contacts that took part, one list for each impact of the instant, as in
    /// [`StateAfterImpact::hits`].
    hits: Vec<Vec<usize>>,
    /// Reference speed of each gap and slip velocity. It is the sum of the absolute terms of this
    /// velocity before the impact and of its absolute changes by the impulses.
    scale: DVector<f64>,
    /// Change of each gap and slip velocity of all contacts by all impulses.
    changes: DVector<f64>,
}

/// Impulses along all contacts at one instant, and their effect on state and energy.
struct ImpulseEffect {
    /// State (q, v) after the impulses.
    y: Vec<f64>,
    /// Impulse along each gap and slip direction of all contacts, N s if the gap is in m.
    impulses: DVector<f64>,
    /// Energy lost in the impact, J.
    loss: f64,
    /// Work that moving obstacles do in the impact, J.
    work: f64,
}

impl ContactRun<'_> {
    /// Handles the contacts that are closed at the instant `meeting`, in the state `y`. Computes the
    /// impact, if a gap would close further, and finds the contacts that stay closed. The inner
    /// `Failure` says why the run cannot go on.
    ///
    /// # Errors
    /// `SimError` if the equations of motion cannot be made.
    pub(super) fn handle_closed_contacts(
        &self,
        y: &[f64],
        meeting: &ImpactInstant<'_>,
    ) -> Result<Result<StateAfterImpact, Failure>, SimError> {
        let mut free = HeldContactEquations { rhs: (self.equations)()?, contacts: self.contacts, kept: &NONE };
        let mut held = HeldContactEquations { rhs: (self.equations)()?, contacts: self.contacts, kept: meeting.kept };
        Ok(self.handle_closed_contacts_with(&mut free, &mut held, y, meeting))
    }

    /// Handles the contacts that are closed at the instant `meeting`, in the state `y`. `free` are the
    /// equations without contact forces. `held` are the equations with the forces of the contacts that
    /// were held closed until then.
    ///
    /// # Errors
    /// `Failure` if impulses or forces are undecided or not finite, or an impact would create energy.
    fn handle_closed_contacts_with(
        &self,
        free: &mut HeldContactEquations<'_>,
        held: &mut HeldContactEquations<'_>,
        y: &[f64],
        meeting: &ImpactInstant<'_>,
    ) -> Result<StateAfterImpact, Failure> {
        let t = meeting.t;
        // Accelerations remove a slower velocity within the shortest flight.
        let slowest = free.motion_without_contact_forces(t, y)?.sizes * self.least;
        let ImpactResult { mut blow, hits, scale, changes } = self.compute_impacts(y, meeting, &slowest)?;
        let is_hit = !hits.is_empty();
        let (mut is_impact, mut rested) = (is_hit, HeldContacts::default());
        let scale = scale.zip_map(&self.reference_speeds(&blow.y)?, f64::max);
        let before = self.accelerations_before_meeting(held, t, y)?;
        let slips = meeting.opening_contact().is_some() && meeting.kept.slipping().next().is_some();
        let is_jamming = slips && held.contact_force_determinant(y).abs() < NEARLY;
        let changes = is_hit.then_some(&changes);
        let met = ContactInstantAfterImpact {
            meeting,
            changes,
            scale: &scale,
            slowest: &slowest,
            before: &before,
            is_jamming,
        };
        let SettledContacts { mut kept, short, more } = self.resting_contacts_after_impact(free, &blow.y, &met)?;
        let mut all = kept.clone();
        more.iter().for_each(|(at, mode)| all.push(at, mode));
        if let Some((last, slips)) = self.bring_to_rest(&blow.y, &all, &met)? {
            is_impact |= slips || !short.is_empty();
            blow = ImpulseEffect {
                y: last.y,
                impulses: blow.impulses + last.impulses,
                loss: blow.loss + last.loss,
                work: blow.work + last.work,
            };
            kept = self.resting_contacts_after_impact(free, &blow.y, &met)?.kept;
            rested = all;
        }
        let kept = self.keep_pushing_contacts(free, t, &blow.y, kept)?;
        let normal = |contact: &usize| (*contact, blow.impulses[self.contacts.rows[*contact][0]]);
        let impulses = meeting.closed.iter().map(normal).filter(|(_, impulse)| *impulse != 0.0).collect();
        let record = ImpactRecord { t, impulses, before: y.to_vec(), loss: blow.loss, work: blow.work, held: short };
        let (record, closed) = (is_impact.then_some(record), meeting.closed.to_vec());
        Ok(StateAfterImpact { y: blow.y, record, kept, closed, hits, rested })
    }

    /// Removes from `kept` the contacts whose forces would pull just after the instant `t`, s.
    ///
    /// An event finds an opening as a normal force that falls to zero, and misses a force that is zero
    /// already. That happens when two contacts open at one instant. So the forces are computed at two
    /// instants shortly later. A contact opens now if its force is negative there and still falls.
    ///
    /// # Errors
    /// `Failure` if the forces at `t` cannot be computed.
    fn keep_pushing_contacts(
        &self,
        free: &mut HeldContactEquations<'_>,
        t: f64,
        y: &[f64],
        mut kept: HeldContacts,
    ) -> Result<HeldContacts, Failure> {
        while !kept.is_empty() {
            let now = free.motion_without_contact_forces(t, y)?;
            let forces = free.forces_of(&now, &kept)?;
            let mut shortly = |times: f64| {
                let (ahead, later) = self.state_shortly_ahead(t, y, &now, &forces, times);
                free.motion_without_contact_forces(ahead, &later).and_then(|then| free.forces_of(&then, &kept))
            };
            // If the forces have no value shortly later, the run itself will report it.
            let (Ok(soon), Ok(later)) = (shortly(1.0), shortly(2.0)) else { break };
            let row = |contact: usize| self.contacts.rows[contact][0];
            let least = |at: usize| ROUNDED * forces.amax().max(now.reference_contact_force(row(at)));
            let pulls = |at: &usize| soon[row(*at)] < -least(*at) && later[row(*at)] < 1.5 * soon[row(*at)];
            let pulling = kept.which.iter().copied().filter(pulls);
            let Some(opens) = pulling.min_by(|a, b| soon[row(*a)].total_cmp(&soon[row(*b)])) else { break };
            kept.remove(opens);
        }
        Ok(kept)
    }

    /// Makes the failure for an impact at `t` s that would create energy. `gained` is this energy, J.
    fn energy_gain_failure(&self, t: f64, meeting: &ImpactInstant<'_>, gained: f64) -> Failure {
        let has_friction = meeting.closed.iter().any(|at| self.contacts.friction(*at).is_some());
        let why = if has_friction {
            "by Newton's law, contacts with friction and restitution can create energy; take law = \"poisson\", or give these contacts a restitution of 0"
        } else {
            "contacts that do not slip and give back what closes them can do that, by Newton's law; \
             give them a restitution of 0, or leave `no_slip` out"
        };
        let (t, gained) = (with_reliable_digits(t, None), with_significant_digits(gained, 3));
        Failure { code: "impact", message: format!("the impact at t = {t} s would create energy, {gained} J: {why}") }
    }

    /// Computes the impacts of the contacts that are closed at the instant `meeting`, in the state `y`.
    /// All impulses are zero if no gap closes. `slowest` are the velocities that accelerations remove
    /// within the shortest flight.
    ///
    /// Newton's law of impact reverses velocities, so a contact that already opens takes no part. If an
    /// impact closes such a contact, another impact follows at the same instant.
    ///
    /// # Errors
    /// `Failure` if the impulses are undecided or would create energy, or if impacts follow without end.
    fn compute_impacts(
        &self,
        y: &[f64],
        meeting: &ImpactInstant<'_>,
        slowest: &DVector<f64>,
    ) -> Result<ImpactResult, Failure> {
        let t = meeting.t;
        let rates = self.contacts.rates(y);
        let response = self.contacts.response(y, &rates)?;
        let mut scale = self.reference_speeds(y)?;
        let normal = |contact: &usize| self.contacts.rows[*contact][0];
        let name = |contact: &usize| format!("`{}`", self.contacts.impacts[*contact].name);
        let closed = meeting.closed;
        if let Some(fixed) = closed.iter().find(|at| response.compliance[(normal(at), normal(at))] <= 0.0) {
            let message = format!(
                "the contact {} is closed at t = {} s, and no permitted motion changes the gap there",
                name(fixed),
                with_reliable_digits(t, None)
            );
            return Err(Failure { code: "impact", message });
        }
        // The gap velocity of a contact that was held closed is rounding and starts no impact. If
        // everything comes to rest, the reference speed is as small as this rounding.
        let (mut all, mut hits) = (DVector::zeros(self.contacts.count), Vec::<Vec<usize>>::new());
        while meeting.opening_contact().is_none() {
            let now = &response.velocities + &response.compliance * &all;
            let is_new = |at: &usize| !hits.is_empty() || meeting.kept.mode(*at).is_none();
            // The gap velocity of a contact that was held closed is rounding, also if no other motion gives a
            // reference speed.
            let held = |at: &usize| if meeting.kept.mode(*at).is_some() { slowest[normal(at)] } else { 0.0 };
            let closes = |at: &usize| now[normal(at)] < -(NOTHING * scale[normal(at)]).max(held(at));
            if !closed.iter().any(|at| is_new(at) && closes(at)) {
                break;
            }
            if hits.len() == MOST {
                return Err(self.endless_impacts_failure(t, closed));
            }
            let opens = |at: &usize| now[normal(at)] > NOTHING * scale[normal(at)];
            let takes_part = |at: &usize| self.contacts.is_poisson() || !opens(at);
            let hit: Vec<usize> = closed.iter().copied().filter(takes_part).collect();
            let impulses = self.contacts.impulses(&response, &now, &hit);
            let impulses =
                impulses.map_err(|why| self.undecided_modes_failure(t, &hit, "no impulses part what closes", &why))?;
            // Impulses that cancel one another leave rounding errors of their own size.
            scale += response.compliance.abs() * impulses.abs();
            all += impulses;
            hits.push(hit);
        }
        let least = least_impact_energy_gain(&response, &all, &scale);
        let changes = &response.compliance * &all;
        let blow = apply_impulses(y, &response, all);
        if blow.loss < -least {
            Err(self.energy_gain_failure(t, meeting, -blow.loss))
        } else {
            Ok(ImpactResult { blow, hits, scale, changes })
        }
    }

    /// Makes the failure for impacts of the closed contacts that follow one another at `t` s without end.
    fn endless_impacts_failure(&self, t: f64, closed: &[usize]) -> Failure {
        let names: Vec<String> = closed.iter().map(|at| format!("`{}`", self.contacts.impacts[*at].name)).collect();
        let message = format!(
            "more than {MOST} impacts follow one another at t = {} s, of contacts that are closed there: {}; give one of them a restitution of 0, or take law = \"poisson\"",
            with_reliable_digits(t, None),
            names.join(", ")
        );
        Failure { code: "impact", message }
    }

    /// Finds the closed contacts that rest after an impact, in the state `y`: they have no gap velocity
    /// and stay pushed together. Also finds the contacts whose next flight would be too short to resolve.
    ///
    /// # Errors
    /// `Failure` if the contact forces are undecided or not determined.
    fn resting_contacts_after_impact(
        &self,
        free: &mut HeldContactEquations<'_>,
        y: &[f64],
        met: &ContactInstantAfterImpact<'_>,
    ) -> Result<SettledContacts, Failure> {
        let (meeting, scale, t) = (met.meeting, met.scale, met.meeting.t);
        let now = free.motion_without_contact_forces(t, y)?;
        let normal = |contact: &usize| self.contacts.rows[*contact][0];
        let velocity = |contact: &usize| now.response.velocities[normal(contact)];
        let is_still = |at: &usize| {
            let rests = !met.is_hit(&self.contacts.rows[*at]) && meeting.kept.mode(*at).is_some();
            rests || velocity(at).abs() <= NOTHING * scale[normal(at)]
        };
        // Largest gap velocity at which the next flight is too short to resolve.
        let slow = |at: &usize, accelerations: &DVector<f64>| {
            self.contacts.shortest_flight_velocity(*at, y, accelerations[normal(at)], self.least)
        };
        let is_slow = |at: &usize| velocity(at).abs() <= slow(at, &now.accelerations);
        let stays = |at: &usize| meeting.opening_contact() != Some(*at);
        let (rest, moving): (Vec<usize>, Vec<usize>) =
            meeting.closed.iter().copied().filter(stays).partition(|at| is_still(at) || is_slow(at));
        let (modes, forces) = self.find_friction_modes(free, y, &now, &rest, met)?;
        let accelerations = &now.accelerations + &now.response.compliance * &forces;
        // Friction may press the contact as much as its own force does. Then the force grows without bound,
        // and the contact does not open.
        let closes = |at: &usize| accelerations[normal(at)] < -NOTHING.sqrt() * now.accelerations.amax();
        if let Some(contact) = meeting.opening_contact().filter(|at| met.is_jamming && closes(at)) {
            return Err(self.jammed_contact_failure(contact, t));
        }
        let nothing = |at: &usize| NOTHING * now.accelerations.amax().max(now.sizes[normal(at)]);
        // A contact that neither pushes nor opens is also held closed, if it has no slip velocity.
        let lies = |at: &usize| self.contacts.rows[*at].len() == 1 && accelerations[normal(at)] <= nothing(at);
        let mut kept = HeldContacts::default();
        for (at, mode) in rest.iter().zip(modes) {
            let stays = if self.contacts.friction(*at).is_some() {
                mode.is_held()
            } else {
                forces[normal(at)] > 0.0 || lies(at)
            };
            if stays {
                kept.push(*at, if mode.is_held() { mode } else { ContactMode::Pushes });
            }
        }
        let bounces = |at: &&usize| !is_still(at) && velocity(at) > 0.0 && meeting.opening_contact().is_none();
        let falls = |at: &usize| velocity(at) > 0.0 && accelerations[normal(at)] < 0.0;
        let is_short = |at: &usize| falls(at) && velocity(at) <= slow(at, &accelerations);
        let short: Vec<usize> =
            kept.which.iter().filter(bounces).copied().chain(moving.into_iter().filter(is_short)).collect();
        let mut more = HeldContacts::default();
        for at in short.iter().filter(|at| kept.mode(**at).is_none()) {
            let slips = self.slip_sign(*at, &now.response.velocities, met);
            more.push(*at, slips.map_or_else(|| self.contacts.mode_without_slip(*at), ContactMode::Slips));
        }
        Ok(SettledContacts { kept, short, more })
    }

    /// Computes the impulses that remove the remaining velocities of the contacts `kept`, in the state
    /// `y`. The flag is true if a contact without slip was slipping. `None` if these velocities are zero
    /// already.
    ///
    /// # Errors
    /// `Failure` if the impulses are not finite.
    fn bring_to_rest(
        &self,
        y: &[f64],
        kept: &HeldContacts,
        met: &ContactInstantAfterImpact<'_>,
    ) -> Result<Option<(ImpulseEffect, bool)>, Failure> {
        let response = self.contacts.response(y, &self.contacts.rates(y))?;
        if kept.rows(self.contacts).iter().all(|row| response.velocities[*row] == 0.0) {
            return Ok(None);
        }
        let (closed, rows) = self.contacts.closed_contact_system(&response, &kept.which);
        let left = response.velocities.select_rows(&rows);
        let held_before = |at: usize| !met.is_hit(&self.contacts.rows[at]) && met.meeting.kept.mode(at).is_some();
        let mut slips = kept
            .iter()
            .filter(|(at, mode)| *mode == ContactMode::Pushes && !held_before(*at))
            .flat_map(|(at, _)| self.contacts.rows[at][1..].iter());
        let slipping = slips.any(|row| response.velocities[*row].abs() > NOTHING * met.scale[*row]);
        let some = closed.forces_in_contact_modes(&left, &kept.modes).ok_or_else(|| Failure {
            code: "not-finite",
            message: "the impulses that bring contacts to rest are not finite".to_owned(),
        })?;
        Ok(Some((apply_impulses(y, &response, self.contacts.spread_over_contact_rows(&some, &rows)), slipping)))
    }

    /// Computes the reference speed of each gap and slip velocity in the state `y`: the sum of its
    /// absolute parts, one for each motion variable and one for moving obstacles.
    ///
    /// # Errors
    /// `Failure` if a permitted motion has no inertia.
    fn reference_speeds(&self, y: &[f64]) -> Result<DVector<f64>, Failure> {
        let rates = self.contacts.rates(y);
        let driven = self.contacts.response(y, &rates)?.driven;
        let n = self.contacts.system.lengths().coordinates;
        let of_row = |row: usize, _| {
            let parts = (n..y.len()).map(|at| (rates.slopes[(row, at)] * y[at]).abs()).sum::<f64>();
            parts + driven[row].abs()
        };
        Ok(DVector::from_fn(self.contacts.count, of_row))
    }
}

/// Applies impulses along the gap and slip directions of all contacts to the state `y`. Returns the
/// new state, the lost energy, and the work of moving obstacles.
fn apply_impulses(y: &[f64], response: &ImpulseResponse, impulses: DVector<f64>) -> ImpulseEffect {
    let mut after = y.to_vec();
    let changes = &response.changes * &impulses;
    let first = after.len() - changes.len();
    for (v, change) in after[first..].iter_mut().zip(changes.iter()) {
        *v += change;
    }
    // Theorem of Thomson and Tait: the work of an impulse is the impulse times the mean of the
    // velocities before and after.
    let velocities = &response.velocities * 2.0 + &response.compliance * &impulses;
    let loss = -0.5 * impulses.dot(&velocities);
    let work = -impulses.dot(&response.driven);
    ImpulseEffect { y: after, impulses, loss, work }
}

/// Computes the least energy gain, J, that counts as a real gain of an impact and not as rounding.
///
/// It is the sum over all impulses: the impulse times a small fraction of the velocities before and
/// after. Their sizes are added because an elastic impact reverses velocities and gains nothing.
fn least_impact_energy_gain(response: &ImpulseResponse, impulses: &DVector<f64>, scale: &DVector<f64>) -> f64 {
    let (before, after) = (&response.velocities, &response.velocities + &response.compliance * impulses);
    let of = |row: usize| NOTHING.sqrt() * (before[row].abs() + after[row].abs()) + NOTHING * scale[row];
    (0..impulses.len()).map(|row| impulses[row].abs() * of(row)).sum()
}
