//! Functions of contacts that become zero at a change of contacts, such as a gap, and the derivatives
//! of the instant of the change.

use super::grazing_contacts;
use super::held_contact_forces::VariedNumber;
use super::motion_before_crossing::{ContactFunction, ContactZero, GapBehaviour, MotionBeforeCrossing};
use super::precise_contacts::SMALL;
use crate::preparation::impacts::{ContactChange, ContactCrossing};

/// Functions of contacts that are zero at the instant of a change of contacts, and the contacts that
/// are touched without an impact.
pub struct ContactZeros<'c> {
    /// Motion just before the change.
    pub coming: MotionBeforeCrossing<'c>,
    /// Function whose zero causes the change. `None` at the start of a run, or if contacts are only
    /// touched.
    first: Option<ContactZero>,
    /// Other functions that are zero at the same instant by coincidence. Derivatives exist only by
    /// numbers that move all these zeros alike.
    others: Vec<ContactZero>,
    /// Indices of the contacts that are touched without a closing velocity of the gap.
    touched: Vec<usize>,
}

impl<'c> ContactZeros<'c> {
    /// Finds the functions of contacts that are zero at a change of contacts.
    ///
    /// # Errors
    /// Text that says why the motion has no derivative by any number.
    pub fn new(coming: MotionBeforeCrossing<'c>) -> Result<Self, String> {
        let (list, touched) = find_contact_zeros(&coming)?;
        let mut list = list.into_iter();
        let first = list.next();
        Ok(Self { coming, first, others: list.collect(), touched })
    }

    /// True if several contacts change at the instant, or if a contact is only touched. The derivative by
    /// each varied number must then be checked.
    pub fn needs_checks(&self) -> bool {
        !self.others.is_empty() || !self.touched.is_empty()
    }

    /// Derivative of the instant of the change by the varied number, s per unit; 0 at the start of a run.
    /// `state` are the derivatives of the state by this number.
    ///
    /// # Errors
    /// Text that says why the derivative has no value.
    pub fn crossing_time_derivative(&self, varied: &VariedNumber<'_>, state: &[f64]) -> Result<f64, String> {
        self.first.as_ref().map_or(Ok(0.0), |zero| Ok(self.coming.instant_derivative(zero, varied, state)?.by))
    }

    /// Checks that the varied number moves all zeros at the instant alike, and does not change a gap that
    /// is only touched. `state` are the derivatives of the state by this number.
    ///
    /// # Errors
    /// Text that names the contacts and the number, if the derivative by this number does not exist.
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

/// Finds the functions that are zero at a change of contacts, with the cause of the change first. The
/// second list has the indices of the contacts that are touched without a closing velocity.
///
/// # Errors
/// Text that says why the motion has no derivative by any number.
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
