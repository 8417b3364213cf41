//! Contacts that are touched without an impact, where derivatives may end.
//!
//! A gap falls to zero and grows again. A neighbouring motion has an impact, or passes without
//! contact. On the side without contact, derivatives are those of the flight. On the other side
//! they grow as the inverse of the impact velocity. So a number that changes the gap at its minimum
//! has no derivative from then on. At the minimum the gap is flat in time, so a number that changes
//! its velocity has no derivative either. Derivatives by all other numbers go on.

use super::held_contact_forces::VariedNumber;
use super::precise_contacts::{ParameterStateDirection, PreciseContacts, SMALL};
use tripos_sim::Options;

/// Largest minimum of a gap that counts as zero, in units of the run's relative tolerance times the
/// size of the gap's terms.
const TOLD: f64 = 8.0;
/// Least relative tolerance that is assumed when minima of gaps are judged, because of rounding.
const ROUNDING: f64 = 1e-13;

/// Gap below which a contact counts as touched, relative to the size of the gap's terms. It is the
/// error of the run.
pub fn grazing_gap_limit(options: &Options) -> f64 {
    TOLD * options.rtol.max(ROUNDING)
}

/// Checks that the varied number changes neither the gap of a contact nor its velocity, at a
/// minimum of zero in the state `y`. `state` holds the derivatives of the state.
///
/// # Errors
/// Text that says why there is no derivative by the varied number.
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
