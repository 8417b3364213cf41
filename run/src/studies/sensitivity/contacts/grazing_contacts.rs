//! Contacts that are touched without an impact, where derivatives may end.
//!
//! The gap of such a contact falls to zero and grows again. A neighbouring motion has an impact, or
//! passes without contact. On the side without contact, the derivatives are those of the flight. On
//! the other side they grow as the inverse of the impact velocity. So a number that changes the gap at
//! its minimum has no derivatives from then on. Nor has a number that changes the velocity of the gap
//! there. The derivatives by all other numbers go on.

use super::held_contact_forces::VariedNumber;
use super::precise_contacts::{ParameterStateDirection, PreciseContacts, SMALL};
use tripos_sim::Options;

/// Largest minimum of a gap that counts as zero, in units of the run's relative tolerance times the
/// size of the gap's terms.
const TOLD: f64 = 8.0;
/// Least relative tolerance that is assumed for the minima of gaps, because of rounding.
const ROUNDING: f64 = 1e-13;

/// Gap below which a contact counts as touched, relative to the size of the gap's terms. It is the error
/// that a run with these options may have.
pub fn grazing_gap_limit(options: &Options) -> f64 {
    TOLD * options.rtol.max(ROUNDING)
}

/// Checks the gap of a contact that is zero at its minimum, in the state `y`. The varied number must
/// change neither this gap nor its velocity. `state` are the derivatives of the state by this number.
///
/// # Errors
/// Text that says why the derivative by the varied number does not exist.
pub fn check_grazing_gap(
    wide: &PreciseContacts<'_>,
    contact: usize,
    y: &[f64],
    varied: &VariedNumber<'_>,
    state: &[f64],
) -> Result<(), String> {
    let direction = ParameterStateDirection { parameters: varied.parameters, state };
    let row = wide.contacts.rows[contact][0];
    let changes = [wide.gap_derivative(contact, y, direction), wide.velocity_derivative(row, y, direction)];
    // A change that is NaN counts as a change.
    if changes.iter().all(|(change, size)| change.abs() <= SMALL * size) {
        return Ok(());
    }
    Err(format!(
        "the contact `{}` is touched without a closing velocity, and a small change of `{}` decides about an impact",
        wide.contacts.impacts[contact].name, varied.name
    ))
}
