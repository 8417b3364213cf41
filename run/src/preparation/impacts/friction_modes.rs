//! Modes of contacts with friction: which contacts stick and which slip.

use super::Bouncing;
use super::NOTHING;
use super::contact_change::ContactChange;
use super::held_motion::{Free, Held};
use super::meeting::SettledMeeting;
use nalgebra::DVector;
use tripos_derive::plain::within;
use tripos_sim::{ContactSolution, Failure, Mode, Undecided};

/// Time ahead, in durations of the shortest flight, at which modes that are all possible at an instant are compared.
const AHEAD: f64 = 16384.0;

impl Bouncing<'_> {
    /// Accelerations along all rows just before a meeting, with the forces of the contacts held until then; zeros if
    /// none of these has friction.
    pub(super) fn approach(&self, held: &mut Held<'_>, t: f64, y: &[f64]) -> Result<DVector<f64>, Failure> {
        if held.kept.which.iter().all(|at| self.contacts.friction(*at).is_none()) {
            return Ok(DVector::zeros(self.contacts.count));
        }
        let free = held.free(t, y)?;
        let forces = held.forces(&free)?;
        Ok(free.accelerations + free.response.compliance * forces)
    }

    /// Sign of the velocity at which a contact with friction slips; `None` if it does not slip.
    pub(super) fn slips(&self, contact: usize, velocities: &DVector<f64>, met: &SettledMeeting<'_>) -> Option<f64> {
        self.contacts.friction(contact)?;
        let row = self.contacts.rows[contact][1];
        let velocity = velocities[row];
        let rests = !met.is_hit(&self.contacts.rows[contact])
            && (met.meeting.contact_change == Some(ContactChange::Sticks(contact))
                || met.meeting.kept.mode(contact) == Some(Mode::Sticks)
                // Contacts that came to rest at this instant as well.
                || velocity.abs() <= met.before[row].abs() * self.least);
        let is_still = rests || velocity.abs() <= (NOTHING * met.scale[row]).max(met.slowest[row]);
        (!is_still).then(|| velocity.signum())
    }

    /// Finds the modes of contacts that are closed and at rest along their gaps, and their forces along all rows.
    ///
    /// # Errors
    /// [`Failure`] where Coulomb's law allows no mode, or more than one.
    pub(super) fn modes(
        &self,
        free: &mut Held<'_>,
        y: &[f64],
        now: &Free,
        rest: &[usize],
        met: &SettledMeeting<'_>,
    ) -> Result<(Vec<Mode>, DVector<f64>), Failure> {
        let t = met.meeting.t;
        let slips: Vec<Option<f64>> = rest.iter().map(|at| self.slips(*at, &now.response.velocities, met)).collect();
        let (system, rows) = self.contacts.closed(&now.response, rest);
        let found = system.ways(&now.accelerations.select_rows(&rows), &slips);
        let what = "no forces keep apart what is closed";
        let mut found = found.map_err(|why| self.undecided(t, rest, what, &why))?;
        // A contact whose force has reached its friction limit no longer sticks.
        let begins = |found: &ContactSolution| {
            let mut modes = rest.iter().zip(&found.modes);
            !modes.any(|(at, mode)| {
                met.meeting.contact_change == Some(ContactChange::Slips(*at)) && *mode == Mode::Sticks
            })
        };
        if found.iter().any(begins) {
            found.retain(begins);
        }
        let at = if found.len() > 1 {
            let (ahead, later) = self.ahead(t, y, now, &self.contacts.spread(&found[0].forces, &rows), 1.0);
            free.free(ahead, &later).map_or(0, |then| self.lasting(&then, rest, &slips, &found))
        } else {
            0
        };
        let one = found.swap_remove(at);
        Ok((one.modes, self.contacts.spread(&one.forces, &rows)))
    }

    /// Instant shortly after another, by this many times the shortest interval that can be told from rounding, and the
    /// state there under forces along all rows, to first order.
    pub(super) fn ahead(&self, t: f64, y: &[f64], now: &Free, forces: &DVector<f64>, times: f64) -> (f64, Vec<f64>) {
        let changes = &now.response.changes * forces;
        let mut rates = now.rates.clone();
        let first = rates.len() - changes.len();
        rates[first..].iter_mut().zip(changes.iter()).for_each(|(rate, change)| *rate += change);
        let ahead = self.least * AHEAD * times;
        (t + ahead, y.iter().zip(&rates).map(|(y, rate)| y + ahead * rate).collect())
    }

    /// Index of the first combination of modes that still satisfies the laws of contact shortly after the instant,
    /// under the accelerations `then`. Zero, the firmest combination, if none does. `slips` has a sign for each contact
    /// of `rest` that slips.
    fn lasting(&self, then: &Free, rest: &[usize], slips: &[Option<f64>], found: &[ContactSolution]) -> usize {
        let (system, rows) = self.contacts.closed(&then.response, rest);
        let accelerations = then.accelerations.select_rows(&rows);
        found.iter().position(|found| system.allows(&accelerations, slips, &found.modes)).unwrap_or(0)
    }

    /// Failure that reports closed contacts whose modes are undecided. `what` is the message where no contact has
    /// friction.
    pub(super) fn undecided(&self, t: f64, contacts: &[usize], what: &str, why: &Undecided) -> Failure {
        let name = |at: &usize| format!("`{}`", self.contacts.impacts[*at].name);
        let names = contacts.iter().map(name).collect::<Vec<_>>().join(", ");
        let help = "Painlevé's paradox of rigid bodies; a smaller coefficient of friction avoids this paradox";
        let does = |modes: &[Mode]| {
            let each = contacts.iter().zip(modes).map(|(at, mode)| format!("{} {mode}", name(at)));
            each.collect::<Vec<_>>().join(" and ")
        };
        let t = within(t, None);
        let (code, message) = match why {
            Undecided::Nothing if contacts.iter().all(|at| self.contacts.friction(*at).is_none()) => {
                ("impact", format!("{what} at t = {t} s: {names}"))
            }
            Undecided::Nothing => {
                let none = "neither sticking, nor slipping, nor opening agrees with Coulomb's law";
                ("friction", format!("{none} at t = {t} s for what is closed there: {names}. That is {help}"))
            }
            Undecided::Several([one, other]) => {
                let several = "Coulomb's law allows more than one motion";
                let ways = format!("{}, or {}", does(one), does(other));
                ("friction", format!("{several} from t = {t} s on: {ways}. That is {help}"))
            }
        };
        Failure { code, message }
    }
}
