//! Modes of closed contacts with friction: which contacts stick, slip or open.

use super::ContactRun;
use super::NOTHING;
use super::contact_change::ContactChange;
use super::contact_impacts::ContactInstantAfterImpact;
use super::held_contact_motion::{ContactFreeMotion, HeldContactEquations};
use nalgebra::DVector;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_sim::{ContactMode, ContactSolution, Failure, UndecidedContacts};

/// Time after which several possible combinations of contact modes (sticking or slipping) are
/// compared. It is a multiple of the duration of the shortest flight.
const AHEAD: f64 = 16384.0;

impl ContactRun<'_> {
    /// Computes the accelerations along the gap and slip directions of all contacts just before an
    /// impact or a change of a contact. They include the forces of the contacts that were held closed.
    /// All are zero if none of these contacts has friction.
    ///
    /// # Errors
    /// `Failure` if the equations or the contact forces have no value.
    pub(super) fn accelerations_before_meeting(
        &self,
        held: &mut HeldContactEquations<'_>,
        t: f64,
        y: &[f64],
    ) -> Result<DVector<f64>, Failure> {
        if held.kept.which.iter().all(|at| self.contacts.friction(*at).is_none()) {
            return Ok(DVector::zeros(self.contacts.count));
        }
        let free = held.motion_without_contact_forces(t, y)?;
        let forces = held.forces(&free)?;
        Ok(free.accelerations + free.response.compliance * forces)
    }

    /// Sign of the slip velocity of a closed contact just after an impact or a change of a contact.
    /// `None` if the contact does not slip or has no friction. `velocities` are the gap and slip
    /// velocities of all contacts.
    pub(super) fn slip_sign(
        &self,
        contact: usize,
        velocities: &DVector<f64>,
        met: &ContactInstantAfterImpact<'_>,
    ) -> Option<f64> {
        self.contacts.friction(contact)?;
        let row = self.contacts.rows[contact][1];
        let velocity = velocities[row];
        let rests = !met.is_hit(&self.contacts.rows[contact])
            && (met.meeting.contact_change == Some(ContactChange::Sticks(contact))
                || met.meeting.kept.mode(contact) == Some(ContactMode::Sticks)
                // A contact counts as sticking too if its slip ended at the same instant by rounding.
                || velocity.abs() <= met.before[row].abs() * self.least);
        let is_still = rests || velocity.abs() <= (NOTHING * met.scale[row]).max(met.slowest[row]);
        (!is_still).then(|| velocity.signum())
    }

    /// Finds the modes of the closed contacts `rest`, which have no gap velocity. Also returns the
    /// contact forces along the gap and slip directions of all contacts. If several combinations of
    /// modes are possible, takes one that is still possible shortly later.
    ///
    /// # Errors
    /// [`Failure`] if Coulomb's law allows no mode, or modes with different motions.
    pub(super) fn find_friction_modes(
        &self,
        free: &mut HeldContactEquations<'_>,
        y: &[f64],
        now: &ContactFreeMotion,
        rest: &[usize],
        met: &ContactInstantAfterImpact<'_>,
    ) -> Result<(Vec<ContactMode>, DVector<f64>), Failure> {
        let t = met.meeting.t;
        let slips: Vec<Option<f64>> =
            rest.iter().map(|at| self.slip_sign(*at, &now.response.velocities, met)).collect();
        let (system, rows) = self.contacts.closed_contact_system(&now.response, rest);
        let found = system.contact_modes(&now.accelerations.select_rows(&rows), &slips);
        let what = "no forces keep apart what is closed";
        let mut found = found.map_err(|why| self.undecided_modes_failure(t, rest, what, &why))?;
        // A contact whose force has reached its friction limit no longer sticks.
        let begins = |found: &ContactSolution| {
            let mut modes = rest.iter().zip(&found.modes);
            !modes.any(|(at, mode)| {
                met.meeting.contact_change == Some(ContactChange::Slips(*at)) && *mode == ContactMode::Sticks
            })
        };
        if found.iter().any(begins) {
            found.retain(begins);
        }
        let at = if found.len() > 1 {
            let (ahead, later) = self.state_shortly_ahead(
                t,
                y,
                now,
                &self.contacts.spread_over_contact_rows(&found[0].forces, &rows),
                1.0,
            );
            free.motion_without_contact_forces(ahead, &later)
                .map_or(0, |then| self.lasting_mode_combination(&then, rest, &slips, &found))
        } else {
            0
        };
        let one = found.swap_remove(at);
        Ok((one.modes, self.contacts.spread_over_contact_rows(&one.forces, &rows)))
    }

    /// Extrapolates the state shortly after the instant `t`, to first order, under the given contact
    /// forces. Returns the later instant, s, and the state then. `times` multiplies the interval between
    /// the two instants.
    pub(super) fn state_shortly_ahead(
        &self,
        t: f64,
        y: &[f64],
        now: &ContactFreeMotion,
        forces: &DVector<f64>,
        times: f64,
    ) -> (f64, Vec<f64>) {
        let changes = &now.response.changes * forces;
        let mut rates = now.rates.clone();
        let first = rates.len() - changes.len();
        rates[first..].iter_mut().zip(changes.iter()).for_each(|(rate, change)| *rate += change);
        let ahead = self.least * AHEAD * times;
        (t + ahead, y.iter().zip(&rates).map(|(y, rate)| y + ahead * rate).collect())
    }

    /// Finds the first combination of modes in `found` that still satisfies the laws of contact shortly
    /// later, under the accelerations in `then`. Returns its index. It is 0, the combination with the
    /// least freedom, if no combination does. `slips` has the sign of slip of each contact in `rest`, or
    /// `None`.
    fn lasting_mode_combination(
        &self,
        then: &ContactFreeMotion,
        rest: &[usize],
        slips: &[Option<f64>],
        found: &[ContactSolution],
    ) -> usize {
        let (system, rows) = self.contacts.closed_contact_system(&then.response, rest);
        let accelerations = then.accelerations.select_rows(&rows);
        found
            .iter()
            .position(|found| system.contact_modes_are_possible(&accelerations, slips, &found.modes))
            .unwrap_or(0)
    }

    /// Makes the failure for closed contacts whose modes or impulses are undecided at `t` s. `what`
    /// begins the message if no contact has friction.
    pub(super) fn undecided_modes_failure(
        &self,
        t: f64,
        contacts: &[usize],
        what: &str,
        why: &UndecidedContacts,
    ) -> Failure {
        let name = |at: &usize| format!("`{}`", self.contacts.impacts[*at].name);
        let names = contacts.iter().map(name).collect::<Vec<_>>().join(", ");
        let help = "Painlevé's paradox of rigid bodies; a smaller coefficient of friction avoids this paradox";
        let does = |modes: &[ContactMode]| {
            let each = contacts.iter().zip(modes).map(|(at, mode)| format!("{} {mode}", name(at)));
            each.collect::<Vec<_>>().join(" and ")
        };
        let t = with_reliable_digits(t, None);
        let (code, message) = match why {
            UndecidedContacts::Nothing if contacts.iter().all(|at| self.contacts.friction(*at).is_none()) => {
                ("impact", format!("{what} at t = {t} s: {names}"))
            }
            UndecidedContacts::Nothing => {
                let none = "neither sticking, nor slipping, nor opening agrees with Coulomb's law";
                ("friction", format!("{none} at t = {t} s for what is closed there: {names}. That is {help}"))
            }
            UndecidedContacts::Several([one, other]) => {
                let several = "Coulomb's law allows more than one motion";
                let ways = format!("{}, or {}", does(one), does(other));
                ("friction", format!("{several} from t = {t} s on: {ways}. That is {help}"))
            }
        };
        Failure { code, message }
    }
}
