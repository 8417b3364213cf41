//! Functions of contacts that are zero at the instant of a change of contacts, and the derivatives
//! of this instant.

use super::grazing_contacts;
use super::held_contact_forces::{HeldContactForces, NOTHING, RatesAlong, VariedNumber};
use super::precise_contacts::{ParameterStateDirection, PreciseContacts, SMALL};
use crate::preparation::impacts::{ContactChange, ContactCrossing};
use tripos_sim::ContactMode;

/// Kind of function of the state that is zero at the instant at which a contact changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ContactFunction {
    /// Gap of a contact, which closes.
    Gap,
    /// Normal force of a contact, which opens.
    Force,
    /// Friction limit of a sticking contact minus the size of its tangential force.
    Margin,
    /// Slip velocity of a contact, whose slip ends or reverses.
    Slip,
}

/// Function of a contact that crosses zero at an instant, with its rate there.
#[derive(Clone, Copy, Debug)]
struct ContactZero {
    /// Kind of the function, such as a gap or a slip velocity.
    what: ContactFunction,
    /// Index of the contact in the scene, from 0.
    contact: usize,
    /// Time derivative of the function at its zero, in its unit per s.
    rate: f64,
}

/// Derivative of an instant by a varied number, and the size of the derivative's terms.
#[derive(Clone, Copy)]
struct InstantDerivative {
    /// Derivative of the instant, s per unit of the varied number.
    by: f64,
    /// Sum of the sizes of the derivative's terms, in the unit of the derivative.
    size: f64,
}

/// Motion just before a change of contacts, with its rates and contact forces.
pub struct MotionBeforeCrossing<'c> {
    /// Contacts of the scene in 32 digits.
    pub wide: &'c PreciseContacts<'c>,
    /// Instant, states and contacts of the change.
    pub crossing: &'c ContactCrossing<'c>,
    /// Function for the derivative of the rates without contact forces.
    pub rates_along: &'c RatesAlong<'c>,
    /// Rates (q̇, v̇) before the change, with the forces of held contacts.
    pub rates: Vec<f64>,
    /// Forces of the contacts held closed before the change; `None` if no contact was held.
    pub forces: Option<HeldContactForces>,
}

/// Functions of contacts that are zero at a change of contacts, and contacts that are touched
/// without an impact.
pub struct ContactZeros<'c> {
    /// Motion just before the change.
    pub coming: MotionBeforeCrossing<'c>,
    /// Function whose zero causes the change. `None` at the start of a run, and if contacts are only
    /// touched.
    first: Option<ContactZero>,
    /// Other functions that are zero at the same instant by coincidence. A varied number must move all
    /// these zeros alike.
    others: Vec<ContactZero>,
    /// Indices of the contacts that are touched without a closing velocity.
    touched: Vec<usize>,
}

impl<'c> ContactZeros<'c> {
    /// Finds the functions of contacts that are zero at a change of contacts.
    ///
    /// # Errors
    /// Text that says why there is no derivative by any number.
    pub fn new(coming: MotionBeforeCrossing<'c>) -> Result<Self, String> {
        let (list, touched) = find_contact_zeros(&coming)?;
        let mut list = list.into_iter();
        let first = list.next();
        Ok(Self { coming, first, others: list.collect(), touched })
    }

    /// True if several contacts change at the instant, or a contact is only touched. Each varied number
    /// must then be checked.
    pub fn needs_checks(&self) -> bool {
        !self.others.is_empty() || !self.touched.is_empty()
    }

    /// Derivative of the instant of the change by the varied number; 0 at the start of a run. `state`
    /// holds the derivatives of the state.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub fn crossing_time_derivative(&self, varied: &VariedNumber<'_>, state: &[f64]) -> Result<f64, String> {
        self.first.as_ref().map_or(Ok(0.0), |zero| Ok(self.coming.instant_derivative(zero, varied, state)?.by))
    }

    /// Checks that the varied number moves all zeros of the instant alike, and does not change a gap
    /// that is only touched.
    ///
    /// # Errors
    /// Text that names the contacts and the number if there is no derivative.
    pub fn check_common_instant(&self, varied: &VariedNumber<'_>, state: &[f64]) -> Result<(), String> {
        let (wide, y) = (self.coming.wide, self.coming.crossing.before);
        self.touched
            .iter()
            .try_for_each(|contact| grazing_contacts::check_grazing_gap(wide, *contact, y, varied, state))?;
        let Some(first) = self.first.as_ref().filter(|_| !self.others.is_empty()) else { return Ok(()) };
        let a = self.coming.instant_derivative(first, varied, state)?;
        for other in &self.others {
            let b = self.coming.instant_derivative(other, varied, state)?;
            if (a.by - b.by).abs() > SMALL * a.size.max(b.size) {
                let what = match first.what {
                    ContactFunction::Gap => "close",
                    ContactFunction::Force => "open",
                    ContactFunction::Margin | ContactFunction::Slip => "slip or stick",
                };
                return Err(format!(
                    "the contacts `{}` and `{}` {what} at one instant, which `{}` moves apart",
                    self.coming.name(first.contact),
                    self.coming.name(other.contact),
                    varied.name
                ));
            }
        }
        Ok(())
    }
}

/// Finds the functions that are zero at a change of contacts, with the cause of the change first.
/// The second list has the contacts that are touched without a closing velocity.
///
/// # Errors
/// Text that says why there is no derivative by any number.
fn find_contact_zeros(of: &MotionBeforeCrossing<'_>) -> Result<(Vec<ContactZero>, Vec<usize>), String> {
    let ContactCrossing { contact_change, kept, after, .. } = of.crossing;
    let Some(contact_change) = *contact_change else { return Ok((Vec::new(), Vec::new())) };
    let contact = contact_change.contact();
    let mut touched = Vec::new();
    let mut list = match contact_change {
        ContactChange::Closes(_) | ContactChange::Nears(_) => {
            let is_new = |other: &usize| kept.mode(*other).is_none() && *other != contact;
            let mut list = Vec::new();
            for at in std::iter::once(contact).chain(after.closed.iter().copied().filter(is_new)) {
                match of.gap_behaviour(at) {
                    GapBehaviour::Opens if at != contact => {}
                    GapBehaviour::Opens | GapBehaviour::Touches => touched.push(at),
                    GapBehaviour::Closes(rate) => {
                        list.push(ContactZero { what: ContactFunction::Gap, contact: at, rate });
                    }
                }
            }
            list
        }
        ContactChange::Opens(_) => vec![of.crossing_zero(ContactFunction::Force, contact)?],
        ContactChange::Slips(_) => vec![of.crossing_zero(ContactFunction::Margin, contact)?],
        ContactChange::Sticks(_) | ContactChange::Reverses(_) => {
            vec![of.crossing_zero(ContactFunction::Slip, contact)?]
        }
        ContactChange::Jams(_) => {
            return Err(format!("the force of the contact `{}` is not determined", of.name(contact)));
        }
    };
    if after.hits.is_empty() {
        for (other, mode) in kept.iter().filter(|(other, _)| *other != contact) {
            if let Some(what) = of.changing_function(other, mode) {
                list.push(of.crossing_zero(what, other)?);
            }
        }
    }
    Ok((list, touched))
}

/// Behaviour of a contact's gap at the instant at which it is zero.
enum GapBehaviour {
    /// The gap increases from zero.
    Opens,
    /// The gap is at its minimum, up to the error of the run.
    Touches,
    /// The gap closes with this negative rate, in its unit per s.
    Closes(f64),
}

impl MotionBeforeCrossing<'_> {
    /// Name of a contact, by its index.
    fn name(&self, contact: usize) -> &str {
        &self.wide.contacts.impacts[contact].name
    }

    /// Index of the gap direction of a contact among the directions of all contacts.
    fn normal(&self, contact: usize) -> usize {
        self.wide.contacts.rows[contact][0]
    }

    /// Kind of function whose zero makes a held contact change its mode. `None` if the contact does not
    /// change, or changes only because other contacts do.
    fn changing_function(&self, contact: usize, mode: ContactMode) -> Option<ContactFunction> {
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

    /// Finds the behaviour of a contact's gap that is zero: it opens, touches or closes.
    fn gap_behaviour(&self, contact: usize) -> GapBehaviour {
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

    /// Makes the zero of a contact's function at the change, with the rate at which the function
    /// crosses zero.
    ///
    /// # Errors
    /// Text that says why the function has no crossing, or its force is not determined.
    fn crossing_zero(&self, what: ContactFunction, contact: usize) -> Result<ContactZero, String> {
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

    /// Derivative of a contact's function by the varied number, and the size of its terms. `state`
    /// holds the derivatives of the state.
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

    /// Derivative of the instant at which a function is zero by the varied number, and the size of its
    /// terms.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    fn instant_derivative(
        &self,
        zero: &ContactZero,
        varied: &VariedNumber<'_>,
        state: &[f64],
    ) -> Result<InstantDerivative, String> {
        let (change, size) = self.function_derivative(zero.what, zero.contact, varied, state)?;
        Ok(InstantDerivative { by: -change / zero.rate, size: size / zero.rate.abs() })
    }
}

/// Sum of terms, and the sum of their absolute values.
fn sum_and_size(terms: impl Iterator<Item = f64>) -> (f64, f64) {
    terms.fold((0.0, 0.0), |(sum, size), term: f64| (sum + term, size + term.abs()))
}
