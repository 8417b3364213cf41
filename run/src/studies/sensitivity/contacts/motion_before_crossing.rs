//! Motion just before a change of contacts: functions of contacts that become zero at the change, and
//! the derivatives of its instant.

use super::held_contact_forces::{HeldContactForces, NOTHING, RatesAlong, VariedNumber};
use super::precise_contacts::{ParameterStateDirection, PreciseContacts, SMALL};
use crate::preparation::impacts::ContactCrossing;
use tripos_sim::ContactMode;

/// Kind of function of the state that becomes zero at the instant at which a contact changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::studies::sensitivity) enum ContactFunction {
    /// Gap of a contact; the contact closes at its zero.
    Gap,
    /// Normal force of a contact; the contact opens at its zero.
    Force,
    /// Friction limit of a sticking contact minus the size of its tangential force; the contact slips at
    /// its zero.
    Margin,
    /// Slip velocity of a contact; the slip ends or reverses at its zero.
    Slip,
}

/// Function of a contact that crosses zero at an instant, with its rate there.
#[derive(Clone, Copy, Debug)]
pub(in crate::studies::sensitivity) struct ContactZero {
    /// Kind of the function, such as a gap or a slip velocity.
    pub(in crate::studies::sensitivity) what: ContactFunction,
    /// Index of the contact in the scene, from 0.
    pub(in crate::studies::sensitivity) contact: usize,
    /// Time derivative of the function at its zero, in its unit per s.
    pub(in crate::studies::sensitivity) rate: f64,
}

/// Derivative of an instant by a varied number, and the sum of the sizes of its terms.
#[derive(Clone, Copy)]
pub(in crate::studies::sensitivity) struct InstantDerivative {
    /// Derivative of the instant, s per unit of the varied number.
    pub(in crate::studies::sensitivity) by: f64,
    /// Sum of the sizes of the derivative's terms, in the unit of the derivative.
    pub(in crate::studies::sensitivity) size: f64,
}

/// Behaviour of a contact's gap at an instant at which the gap is zero.
pub(in crate::studies::sensitivity) enum GapBehaviour {
    /// The gap increases from zero.
    Opens,
    /// The gap has its minimum there, up to the error of the run.
    Touches,
    /// The gap closes with this negative rate, in its unit per s.
    Closes(f64),
}

/// Motion just before a change of contacts, with its rates and contact forces.
pub struct MotionBeforeCrossing<'c> {
    /// Contacts of the scene, computed to 32 digits.
    pub wide: &'c PreciseContacts<'c>,
    /// Instant, states and contacts of the change.
    pub crossing: &'c ContactCrossing<'c>,
    /// Function that computes the derivative of the rates without contact forces.
    pub rates_along: &'c RatesAlong<'c>,
    /// Rates (q̇, v̇) before the change, with the forces of held contacts.
    pub rates: Vec<f64>,
    /// Forces of the contacts held closed before the change; `None` if no contact was held.
    pub forces: Option<HeldContactForces>,
}

impl MotionBeforeCrossing<'_> {
    /// Name of a contact, by its index.
    pub(in crate::studies::sensitivity) fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    /// Index of the gap direction of a contact among the directions of all contacts.
    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Kind of function whose zero makes a held contact change its mode. `None` if the contact does not
    /// change its mode, or changes it only because other contacts change.
    pub(in crate::studies::sensitivity) fn changing_function(
        &self,
        contact: usize,
        mode: ContactMode,
    ) -> Option<ContactFunction> {
        let forces = self.forces.as_ref()?;
        match (mode, self.crossing.after.kept.mode(contact)) {
            (_, None) => forces.is_force_zero(self.normal(contact)).then_some(ContactFunction::Force),
            (ContactMode::Sticks, Some(ContactMode::Slips(_))) => {
                forces.is_at_limit(self.wide.contacts, contact).then_some(ContactFunction::Margin)
            }
            (ContactMode::Slips(_), Some(ContactMode::Sticks)) => Some(ContactFunction::Slip),
            (ContactMode::Slips(one), Some(ContactMode::Slips(other))) => {
                (one * other < 0.0).then_some(ContactFunction::Slip)
            }
            _ => None,
        }
    }

    /// Finds if the gap of a contact, which is zero, opens, touches or closes.
    pub(in crate::studies::sensitivity) fn gap_behaviour(&self, contact: usize) -> GapBehaviour {
        let (contacts, y) = (self.wide.contacts, self.crossing.before);
        let slopes = contacts.gap_slopes(y);
        let (rate, scale) = sum_and_size(slopes.row(contact).iter().zip(&self.rates).map(|(slope, rate)| slope * rate));
        if rate > NOTHING * scale {
            return GapBehaviour::Opens;
        }
        let slopes = contacts.rates(y).slopes;
        let (acceleration, _) =
            sum_and_size(slopes.row(self.normal(contact)).iter().zip(&self.rates).map(|(slope, rate)| slope * rate));
        // Depth of penetration that the gap would reach without the impact.
        let depth = if acceleration > 0.0 { 0.5 * rate * rate / acceleration } else { f64::INFINITY };
        if rate >= -NOTHING * scale || depth <= self.wide.near * contacts.gap_term_size(contact, y) {
            return GapBehaviour::Touches;
        }
        GapBehaviour::Closes(rate)
    }

    /// Makes the zero of a contact's function at the change, with the rate at which the function crosses
    /// zero there.
    ///
    /// # Errors
    /// Text that says that the function does not cross zero, or that its force is not determined.
    pub(in crate::studies::sensitivity) fn crossing_zero(
        &self,
        what: ContactFunction,
        contact: usize,
    ) -> Result<ContactZero, String> {
        let still = vec![0.0; self.wide.contacts.parameters.len()];
        let none = vec![0.0; self.wide.contacts.impacts.len()];
        let time = VariedNumber { name: "t", parameters: &still, restitutions: &none, frictions: &none };
        let rows = &self.wide.contacts.rows[contact];
        let shared = |row: &usize| self.forces.as_ref().is_some_and(|forces| forces.is_shared(*row));
        let needed = match what {
            ContactFunction::Force => &rows[..1],
            ContactFunction::Margin => &rows[..2],
            ContactFunction::Gap | ContactFunction::Slip => &[],
        };
        if needed.iter().any(shared) {
            return Err(format!(
                "the contact `{}` and others hold the same motion there, and their shares of the force are not determined",
                self.name(contact)
            ));
        }
        let (rate, size) = self.function_derivative(what, contact, &time, &self.rates)?;
        if rate.abs() <= SMALL * size {
            let what = match what {
                ContactFunction::Force | ContactFunction::Gap => "force of the contact `{}` does not cross zero there",
                ContactFunction::Margin => "force of the contact `{}` only touches the limit of friction there",
                ContactFunction::Slip => "slip of the contact `{}` ends there without a deceleration",
            };
            return Err(format!("the {}", what.replace("{}", self.name(contact))));
        }
        Ok(ContactZero { what, contact, rate })
    }

    /// Derivative of a contact's function by the varied number, and the size of the derivative's terms.
    /// `state` are the derivatives of the state by this number.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    fn function_derivative(
        &self,
        what: ContactFunction,
        contact: usize,
        varied: &VariedNumber<'_>,
        state: &[f64],
    ) -> Result<(f64, f64), String> {
        let direction = ParameterStateDirection { parameters: varied.parameters, state };
        match what {
            ContactFunction::Gap => return Ok(self.wide.gap_derivative(contact, self.crossing.before, direction)),
            ContactFunction::Slip => {
                let row = self.wide.contacts.rows[contact][1];
                return Ok(self.wide.velocity_derivative(row, self.crossing.before, direction));
            }
            ContactFunction::Force | ContactFunction::Margin => {}
        }
        let unknown = || format!("the force of the contact `{}` is not known", self.name(contact));
        let forces = self.forces.as_ref().ok_or_else(unknown)?;
        let change = forces.force_derivative(self.wide, self.rates_along, varied, state)?;
        let row = self.normal(contact);
        Ok(match what {
            ContactFunction::Margin => forces.friction_margin_derivative(self.wide.contacts, contact, &change, varied),
            _ => (change.impulses[row], change.size / forces.compliance_root(row)),
        })
    }

    /// Derivative by the varied number of the instant at which a function is zero, and the size of the
    /// derivative's terms. `state` are the derivatives of the state by this number.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub(in crate::studies::sensitivity) fn instant_derivative(
        &self,
        zero: &ContactZero,
        varied: &VariedNumber<'_>,
        state: &[f64],
    ) -> Result<InstantDerivative, String> {
        let (change, size) = self.function_derivative(zero.what, zero.contact, varied, state)?;
        Ok(InstantDerivative { by: -change / zero.rate, size: size / zero.rate.abs() })
    }
}

/// Computes the sum of terms, and the sum of their absolute values.
fn sum_and_size(terms: impl Iterator<Item = f64>) -> (f64, f64) {
    terms.fold((0.0, 0.0), |(sum, size), term: f64| (sum + term, size + term.abs()))
}
