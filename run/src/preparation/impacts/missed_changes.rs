//! Checks of a finished part of a run for changes of contacts that its events missed.

use super::held_contact_motion::HeldContactEquations;
use super::held_contacts::HeldContacts;
use super::{ContactRun, OVERLAP, round_to_doubles};
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_sim::{ContactMode, Failure, Solution, Stop};
use tripos_traits::Real;

/// Determinant of the linear system for contact forces below which the forces count as growing without
/// bound. It is relative to the determinant without slip.
pub const NEARLY: f64 = 1e-3;

impl ContactRun<'_> {
    /// Checks the gaps of all contacts that are not held, at the end of a part of a run. Returns a
    /// failure if such a gap is negative, because its events missed the closing. `None` if no gap is.
    pub(super) fn missed_closing<S: Real>(&self, part: &Solution<S>, kept: &HeldContacts) -> Option<Failure> {
        let y_end = round_to_doubles(&part.y_end);
        let rates = self.contacts.rates(&y_end);
        let gap = |contact: usize| self.contacts.gap(contact, &y_end);
        let least = |contact: usize| {
            let sizes =
                part.y.iter().chain([&part.y_end]).map(|y| self.contacts.gap_term_size(contact, &round_to_doubles(y)));
            let velocity = rates.values[self.contacts.rows[contact][0]].abs();
            OVERLAP * sizes.fold(0.0, f64::max) + velocity * self.least
        };
        let free = (0..self.contacts.impacts.len()).filter(|contact| kept.mode(*contact).is_none());
        // A gap that opened at the start of the part may have begun with a rounding error.
        let begun =
            |contact: usize| part.y.first().map_or(0.0, |y| self.contacts.gap(contact, &round_to_doubles(y)).min(0.0));
        let is_below = |contact: &usize| gap(*contact) < (2.0 * begun(*contact)).min(-least(*contact));
        let below = free.into_iter().find(|contact| gap(*contact) < 0.0 && is_below(contact))?;
        let message = format!(
            "the gap of the contact `{}` is {}: a step jumped over the instant of closing; give a shorter `max_step`",
            self.contacts.impacts[below].name,
            with_significant_digits(gap(below), 4)
        );
        Some(Failure { code: "contact", message })
    }

    /// Checks the modes of the held contacts with friction at the end of a part of a run. Returns a
    /// failure if a contact has left its mode, because the events missed the change. Also returns a
    /// failure if the contact forces cannot be computed. `None` if all modes are kept.
    pub(super) fn missed_friction_change<S: Real>(
        &self,
        part: &Solution<S>,
        forces: &mut HeldContactEquations<'_>,
    ) -> Option<Failure> {
        let kept = forces.kept;
        if kept.which.iter().all(|at| self.contacts.friction(*at).is_none()) {
            return None;
        }
        let (t, y) = (part.t_end, round_to_doubles(&part.y_end));
        // Modes cannot be checked where the forces cannot be computed.
        let (free, along) =
            match forces.motion_without_contact_forces(t, &y).and_then(|free| Ok((forces.forces(&free)?, free))) {
                Ok((along, free)) => (free, along),
                Err(failure) => return Some(failure),
            };
        let accelerations = &free.accelerations + &free.response.compliance * &along;
        let rows = |contact: usize| (self.contacts.rows[contact][0], self.contacts.rows[contact][1]);
        // A slip velocity up to `least` counts as zero. `least` is a small fraction of the largest slip
        // velocity in this part, or of the slip velocity that all the kinetic energy could give.
        let energy = self.contacts.kinetic_energy(&y);
        let largest = |row: usize| {
            let most = (2.0 * energy * free.response.compliance[(row, row)]).max(0.0).sqrt();
            part.y.iter().map(|y| self.contacts.rates(&round_to_doubles(y)).values[row].abs()).fold(most, f64::max)
        };
        let rough = kept.iter().filter(|(at, _)| self.contacts.friction(*at).is_some());
        let what = rough.filter_map(|(contact, mode)| {
            let ((normal, slip), mu) = (rows(contact), self.contacts.friction(contact)?);
            let (pushes, bears) = (along[normal], mu * along[normal]);
            let nothing = OVERLAP * along.amax().max(free.reference_contact_force(normal));
            let what = match mode {
                _ if pushes < -nothing => "opens",
                ContactMode::Sticks if along[slip].abs() > bears + nothing => "slips",
                ContactMode::Slips(way) if self.contacts.is_rough(contact) => {
                    let least = OVERLAP * largest(slip) + accelerations[slip].abs() * self.least;
                    if way * free.response.velocities[slip] >= -least {
                        return None;
                    }
                    "slips the other way"
                }
                _ => return None,
            };
            Some((contact, what))
        });
        let (contact, what) = what.into_iter().next()?;
        let name = &self.contacts.impacts[contact].name;
        let message =
            format!("a step jumped over the instant at which the contact `{name}` {what}: give a shorter `max_step`");
        Some(Failure { code: "contact", message })
    }

    /// Finds if a part of a run stopped early because the forces of slipping contacts grow without
    /// bound, and returns this failure. `None` if the part stopped for another reason.
    pub(super) fn missed_jamming<S: Real>(
        &self,
        part: &Solution<S>,
        forces: &HeldContactEquations<'_>,
    ) -> Option<Failure> {
        let ends = matches!(part.stop, Stop::StepTooSmall { .. } | Stop::NotFinite { .. } | Stop::NotConverged { .. });
        let (first, _) = forces.kept.slipping().next().filter(|_| ends)?;
        let determinant = forces.contact_force_determinant(&round_to_doubles(&part.y_end));
        (determinant.abs() < NEARLY).then(|| self.jammed_contact_failure(first, part.t_end))
    }

    /// Makes the failure for a slipping contact whose forces are no longer determined from `t` s on
    /// (Painlevé's paradox).
    pub(super) fn jammed_contact_failure(&self, contact: usize, t: f64) -> Failure {
        let (name, t) = (&self.contacts.impacts[contact].name, with_reliable_digits(t, None));
        let message = format!(
            "from t = {t} s on, the force of the slipping contact `{name}` is not determined: its friction presses as much as the force itself. \
             That is Painlevé's paradox of rigid bodies; a smaller coefficient of friction avoids this paradox"
        );
        Failure { code: "friction", message }
    }
}
