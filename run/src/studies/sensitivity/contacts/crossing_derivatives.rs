//! Jumps of derivatives ("slopes") at instants at which velocities jump, or contacts open, close, stick
//! or slip.
//!
//! At an instant t(p), the state goes from y⁻(t, p) to y⁺ = R(y⁻, p), and its rates go from f⁻ to
//! f⁺. Slopes at a fixed instant go from s⁻ to s⁺ = R_y (s⁻ + f⁻ dt/dp) + R_p − f⁺ dt/dp. The
//! instant has the derivative dt/dp = −(g_y s⁻ + g_p)/(g_y f⁻). Here g is the function that is zero
//! at the instant: a gap, a force, a friction margin or a slip velocity ([`super::contact_zeros`]).
//! This map is linear in s⁻ and p. Forward runs apply it to slopes, and a backward sweep applies its
//! transpose.
//!
//! R is differentiated with fixed sets of pushing, sticking and slipping contacts. In three cases the
//! derivative does not exist, and the reason is given:
//! - the varied number changes these sets;
//! - contacts that change together would change at different instants;
//! - contacts close without a velocity.
//!
//! Sources: M. A. Aizerman & F. R. Gantmakher, "On the stability of periodic motions", *Journal of
//! Applied Mathematics and Mechanics* 22 (1958), 1065–1078; P. C. Müller, "Calculation of Lyapunov
//! exponents for dynamic systems with discontinuities", *Chaos, Solitons & Fractals* 5 (1995),
//! 1671–1681.

use super::contact_zeros::ContactZeros;
use super::held_contact_forces::{HeldContactForces, NOTHING, RatesAlong, VariedNumber};
use super::held_directions::HeldDirections;
use super::impact_strikes::{Strike, StrikeLaw, strikes, vector_over_gap_rows};
use super::motion_before_crossing::MotionBeforeCrossing;
use super::precise_contacts::{
    ActingContacts, ContactForceDerivative, ForceFreeMotion, ParameterStateDirection, PreciseContacts, SMALL,
};
use crate::preparation::impacts::{ContactCrossing, HeldContacts, NONE};
use nalgebra::DVector;
use tripos_sim::{ContactMode, Failure};

/// Function that computes the rates (q̇, v̇) at an instant and a state while the given contacts are
/// held closed.
pub type HeldRates<'c> = dyn Fn(&HeldContacts, f64, &[f64]) -> Result<Vec<f64>, Failure> + 'c;

/// Change of contacts at one instant, prepared to compute its derivatives in any direction.
pub struct CrossingDerivatives<'c> {
    /// Contacts of the scene, computed to 32 digits.
    wide: &'c PreciseContacts<'c>,
    /// Instant, states and contacts of the change.
    crossing: &'c ContactCrossing<'c>,
    /// Function that computes the derivative of the rates without contact forces.
    rates_along: &'c RatesAlong<'c>,
    /// Functions of contacts, such as gaps, that are zero at the instant.
    zeros: ContactZeros<'c>,
    /// Impacts at the instant, split into strikes (steps of impulses), in their order.
    strikes: Vec<Strike>,
    /// Rates of the state after the change, with the forces of held contacts.
    rates: Vec<f64>,
    /// Forces of the contacts that are held closed after the change; `None` if no contact is held.
    forces: Option<HeldContactForces>,
}

/// Slopes (derivatives by one varied number) just after a change of contacts.
pub struct SlopesAfterCrossing {
    /// Derivative of the instant of the change, s per unit of the varied number.
    pub later: f64,
    /// Slopes of the state just after the change.
    pub slopes: Vec<f64>,
    /// Derivatives of the impulses of each strike (a step of the impact), in their order.
    changes: Vec<ContactForceDerivative>,
    /// Slopes of the state before each strike (a step of the impact), in their order.
    before: Vec<Vec<f64>>,
}

impl<'c> CrossingDerivatives<'c> {
    /// Prepares a change of contacts for derivatives. `flow` computes the rates of the state while
    /// contacts are held.
    ///
    /// # Errors
    /// Text that says why the motion has no derivative by any number.
    pub fn new(
        wide: &'c PreciseContacts<'c>,
        crossing: &'c ContactCrossing<'c>,
        rates_along: &'c RatesAlong<'c>,
        flow: &HeldRates<'_>,
    ) -> Result<Self, String> {
        let said = |failure: Failure| failure.message;
        let (t, y, kept) = (crossing.t, &crossing.after.y, &crossing.after.kept);
        let forces = |kept: &HeldContacts, y: &[f64]| -> Result<Option<HeldContactForces>, Failure> {
            if kept.is_empty() {
                return Ok(None);
            }
            HeldContactForces::new(wide.contacts, kept, y, flow(&NONE, t, y)?).map(Some)
        };
        let coming = MotionBeforeCrossing {
            wide,
            crossing,
            rates_along,
            rates: flow(crossing.kept, t, crossing.before).map_err(said)?,
            forces: forces(crossing.kept, crossing.before).map_err(said)?,
        };
        Ok(Self {
            wide,
            crossing,
            rates_along,
            zeros: ContactZeros::new(coming)?,
            strikes: strikes(wide.contacts, crossing).map_err(said)?,
            rates: flow(kept, t, y).map_err(said)?,
            forces: forces(kept, y).map_err(said)?,
        })
    }

    /// Computes the derivative of the instant of a change of contacts, and the slopes of the state after
    /// it. `state` are the slopes before it. Checks that the varied number does not change the sets of
    /// pushing, sticking and slipping contacts.
    ///
    /// # Errors
    /// Text that says why the derivative by the varied number does not exist.
    pub fn slopes_after_crossing(&self, varied: &VariedNumber<'_>, state: &[f64]) -> Result<(f64, Vec<f64>), String> {
        self.check_start_gaps(varied, state)?;
        self.zeros.check_common_instant(varied, state)?;
        let across = self.unchecked_slopes_after_crossing(varied, state)?;
        self.check_impact_modes(varied, &across)?;
        self.check_held_contacts(varied, &across.slopes)?;
        Ok((across.later, across.slopes))
    }

    /// True if several contacts hold the same motion. Derivatives then exist only by numbers that move
    /// these contacts alike.
    pub fn has_shared_motion(&self) -> bool {
        let before = &self.zeros.coming.forces;
        before.iter().chain(&self.forces).any(HeldContactForces::are_shared)
    }

    /// True if the derivatives by some numbers may not exist, so that each number must be checked.
    pub fn needs_checks(&self) -> bool {
        let is_open = |strike: &Strike| {
            let compliance =
                &strike.operators.of_u * strike.operators.inertia.solve(&strike.operators.of_u.transpose());
            let shared = strike.grip.system(&compliance).undetermined_forces();
            let is_one = strike.undecided.is_empty() && strike.resting.is_empty() && strike.others.is_empty();
            !is_one || shared.contains(&true)
        };
        self.zeros.needs_checks()
            || self.has_shared_motion()
            || self.strikes.iter().any(is_open)
            || !self.contacts_without_force().is_empty()
            || !self.contacts_at_friction_limit().is_empty()
            || !self.contacts_slipping_from_rest().is_empty()
    }

    /// Computes the slopes after a change of contacts from the slopes before it. Does not check that the
    /// sets of pushing, sticking and slipping contacts stay the same.
    ///
    /// # Errors
    /// Text that says which value does not exist.
    pub fn unchecked_slopes_after_crossing(
        &self,
        varied: &VariedNumber<'_>,
        state: &[f64],
    ) -> Result<SlopesAfterCrossing, String> {
        let later = self.zeros.crossing_time_derivative(varied, state)?;
        let mut slopes: Vec<f64> = state.iter().zip(&self.zeros.coming.rates).map(|(s, f)| s + f * later).collect();
        let (mut changes, mut before): (Vec<ContactForceDerivative>, _) = (Vec::new(), Vec::new());
        for strike in &self.strikes {
            let change = self.strike_derivative(strike, &strike.grip, varied, &slopes, changes.last())?;
            before.push(slopes.clone());
            let first = slopes.len() - change.variables.len();
            slopes[first..].iter_mut().zip(change.variables.iter()).for_each(|(s, more)| *s += more);
            changes.push(change);
        }
        slopes.iter_mut().zip(&self.rates).for_each(|(s, f)| *s -= f * later);
        Ok(SlopesAfterCrossing { later, slopes, changes, before })
    }

    /// Name of a contact, by its index.
    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    /// Index of the gap direction of a contact among the directions of all contacts.
    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Derivative of the impulses of a strike (a step of an impact), if `grip` gives the held directions
    /// and the friction. `slopes` are the slopes of the state before the strike. `last` is the
    /// derivative of the strike before.
    ///
    /// # Errors
    /// Text that says why the derivative is not finite.
    fn strike_derivative(
        &self,
        strike: &Strike,
        grip: &HeldDirections,
        varied: &VariedNumber<'_>,
        slopes: &[f64],
        last: Option<&ContactForceDerivative>,
    ) -> Result<ContactForceDerivative, String> {
        let Strike { y, operators, law, impulses, .. } = strike;
        let acting = ActingContacts { y, operators, impulses, grip };
        let contacts = self.wide.contacts;
        let velocities = contacts.rates(y).values;
        let e = vector_over_gap_rows(contacts, |at| contacts.impacts[at].restitution);
        let turns = vector_over_gap_rows(contacts, |at| contacts.newton_restitution(at, &velocities));
        let by_e = vector_over_gap_rows(contacts, |at| varied.restitutions[at]);
        // An opening contact has no restitution, whatever its coefficient.
        let by_turns = vector_over_gap_rows(contacts, |at| {
            if velocities[self.normal(at)] < 0.0 { varied.restitutions[at] } else { 0.0 }
        });
        let nothing = DVector::zeros(contacts.count);
        let before = last.map_or_else(|| nothing.clone(), |change| change.impulses.clone());
        let (parts, by, given) = match law {
            StrikeLaw::Turn => {
                (turns.add_scalar(1.0), by_turns, grip.friction_by_coefficients(varied.frictions, impulses))
            }
            StrikeLaw::Stop { given: None } => {
                (nothing.add_scalar(1.0), nothing, grip.friction_by_coefficients(varied.frictions, impulses))
            }
            StrikeLaw::Stop { given: Some(given) } => {
                let friction = grip.friction_by_coefficients(varied.frictions, &(impulses + given))
                    + grip.friction_of_normal_forces(&before);
                (nothing.add_scalar(1.0), nothing, friction)
            }
            // The impulses are e Λ, where Λ are the impulses of the strike before.
            StrikeLaw::Return(of) => (nothing.clone(), nothing, e.component_mul(&before) + by_e.component_mul(of)),
        };
        let direction = ParameterStateDirection { parameters: varied.parameters, state: slopes };
        let without = ForceFreeMotion::Move { parts: parts.as_slice(), by: by.as_slice() };
        self.wide.contact_force_derivative(&acting, &without, direction, &given).map_err(|failure| failure.message)
    }

    /// Text saying that a small change of the varied number decides if a contact pushes or opens.
    fn undecided_contact_message(&self, contact: usize, varied: &VariedNumber<'_>) -> String {
        format!(
            "whether the contact `{}` pushes or opens there depends on a small change of `{}`",
            self.name(contact),
            varied.name
        )
    }

    /// Checks the contacts that are closed at the start of a run. The varied number must not change their
    /// gaps, which would open a contact or make bodies overlap.
    ///
    /// # Errors
    /// Text that names the contact and the number.
    fn check_start_gaps(&self, varied: &VariedNumber<'_>, state: &[f64]) -> Result<(), String> {
        if self.crossing.contact_change.is_some() {
            return Ok(());
        }
        let after = self.crossing.after;
        let is_struck = |at: &&usize| self.strikes.iter().any(|strike| strike.grip.rows.contains(&self.normal(**at)));
        let hit = after.hits.iter().flatten().filter(is_struck);
        let direction = ParameterStateDirection { parameters: varied.parameters, state };
        for contact in after.kept.which.iter().chain(hit) {
            let (change, size) = self.wide.gap_derivative(*contact, self.crossing.before, direction);
            if change.abs() > SMALL * size {
                return Err(format!(
                    "the contact `{}` is closed at the start, and `{}` opens it",
                    self.name(*contact),
                    varied.name
                ));
            }
        }
        Ok(())
    }

    /// Checks that the varied number changes neither the set of contacts that take part in an impact, nor
    /// their modes.
    ///
    /// # Errors
    /// Text that says why the derivative does not exist.
    fn check_impact_modes(&self, varied: &VariedNumber<'_>, across: &SlopesAfterCrossing) -> Result<(), String> {
        let largest = across.changes.iter().map(|change| change.size).fold(0.0, f64::max);
        for (at, (strike, change)) in self.strikes.iter().zip(&across.changes).enumerate() {
            if change.is_apart {
                return Err(crate::studies::sensitivity::contacts::precise_contacts::APART.to_owned());
            }
            let inertia = &strike.operators.inertia;
            let direction = ParameterStateDirection { parameters: varied.parameters, state: &across.before[at] };
            for contact in &strike.resting {
                let (moved, size) = self.wide.velocity_derivative(self.normal(*contact), &strike.y, direction);
                if moved.abs() > SMALL * size {
                    let name = self.name(*contact);
                    return Err(format!(
                        "the contact `{name}` is hit at rest, and a small change of `{}` decides about its impact",
                        varied.name
                    ));
                }
            }
            for contact in &strike.undecided {
                let row = strike.operators.of_u.row(self.normal(*contact));
                let g = (row * inertia.solve(&row.transpose()))[0];
                if change.impulses[self.normal(*contact)].abs() * g.sqrt() > SMALL * change.size {
                    return Err(self.undecided_contact_message(*contact, varied));
                }
            }
            for grip in &strike.others {
                let last = at.checked_sub(1).map(|before| &across.changes[before]);
                let other = self.strike_derivative(strike, grip, varied, &across.before[at], last)?;
                let apart = inertia.l().transpose() * (&other.speeds - &change.speeds);
                if apart.norm() > SMALL * largest.max(other.size) {
                    return Err(format!(
                        "a small change of `{}` decides if contacts stick or slip in the impact",
                        varied.name
                    ));
                }
            }
        }
        Ok(())
    }

    /// Indices of the contacts that are held closed after the change with a normal force of zero.
    fn contacts_without_force(&self) -> Vec<usize> {
        let Some(forces) = &self.forces else { return Vec::new() };
        forces.held_contacts().map(|(at, _)| at).filter(|at| forces.is_force_zero(self.normal(*at))).collect()
    }

    /// Indices of the contacts that stick after the change, with a force at their friction limit.
    fn contacts_at_friction_limit(&self) -> Vec<usize> {
        let Some(forces) = &self.forces else { return Vec::new() };
        let sticks = forces.held_contacts().filter(|(_, mode)| *mode == ContactMode::Sticks).map(|(at, _)| at);
        sticks.filter(|at| forces.is_at_limit(self.wide.contacts, *at)).collect()
    }

    /// Indices of the contacts with a slip velocity of zero that begin to slip at the start of the run.
    fn contacts_slipping_from_rest(&self) -> Vec<usize> {
        let Some(forces) = self.forces.as_ref().filter(|_| self.crossing.contact_change.is_none()) else {
            return Vec::new();
        };
        let (contacts, y) = (self.wide.contacts, &self.crossing.after.y);
        let rates = contacts.rates(y);
        let is_still = |at: &usize| {
            let row = contacts.rows[*at][1];
            let size: f64 = rates.slopes.row(row).iter().zip(y).map(|(slope, y)| (slope * y).abs()).sum();
            contacts.is_rough(*at) && rates.values[row].abs() <= NOTHING * size
        };
        let slips = forces.held_contacts().filter(|(_, mode)| matches!(mode, ContactMode::Slips(_))).map(|(at, _)| at);
        slips.filter(is_still).collect()
    }

    /// Checks that the varied number does not change the set of held contacts, nor their modes.
    ///
    /// It must give no force to a contact that is held without force. It must not make a contact slip
    /// that sticks at its friction limit. It must not move a contact that begins to slip from rest.
    ///
    /// # Errors
    /// Text that says why the derivative does not exist.
    fn check_held_contacts(&self, varied: &VariedNumber<'_>, slopes: &[f64]) -> Result<(), String> {
        let Some(forces) = &self.forces else { return Ok(()) };
        let contacts = self.wide.contacts;
        for contact in self.contacts_slipping_from_rest() {
            let direction = ParameterStateDirection { parameters: varied.parameters, state: slopes };
            let (change, size) =
                self.wide.velocity_derivative(contacts.rows[contact][1], &self.crossing.after.y, direction);
            if change.abs() > SMALL * size {
                let name = self.name(contact);
                return Err(format!(
                    "the contact `{name}` begins to slip from rest, at an instant that `{}` changes",
                    varied.name
                ));
            }
        }
        let (lying, at_limit) = (self.contacts_without_force(), self.contacts_at_friction_limit());
        if lying.is_empty() && at_limit.is_empty() {
            return Ok(());
        }
        let change = forces.force_derivative(self.wide, self.rates_along, varied, slopes)?.require_common_motion()?;
        let presses = |at: &&usize| {
            let row = self.normal(**at);
            change.impulses[row].abs() * forces.compliance_root(row) > SMALL * change.size
        };
        if let Some(at) = lying.iter().find(presses) {
            return Err(self.undecided_contact_message(*at, varied));
        }
        let slips = |at: &&usize| {
            let (margin, size) = forces.friction_margin_derivative(contacts, **at, &change, varied);
            margin.abs() > SMALL * size
        };
        at_limit.iter().find(slips).map_or(Ok(()), |at| {
            Err(format!(
                "whether the contact `{}` sticks or slips there depends on a small change of `{}`",
                self.name(*at),
                varied.name
            ))
        })
    }
}
