//! Contacts that are touched without closing, and the derivatives that end there.
//!
//! A gap comes down to zero and grows again; a neighboring motion closes the contact, or does not. On one side of the
//! touch, slopes are those of a flight. On the other side they grow without bound, as the inverse of the impact
//! velocity. So there is no derivative with respect to a number that changes the gap at its minimum. The gap is flat in
//! time there, so a number that changes its velocity has no derivative either. Derivatives with respect to all other
//! numbers go on.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::Varied;
use tripos_sim::Options;

/// Largest minimum of a gap that counts as zero, in units of the relative tolerance of a run and the size of the gap's
/// terms.
const TOLD: f64 = 8.0;
/// Least relative tolerance by which minima of gaps are judged, because of rounding.
const ROUNDING: f64 = 1e-13;

/// Gap below which a contact counts as touched, relative to the size of the gap's terms: the error of a run.
pub fn near(options: &Options) -> f64 {
    TOLD * options.rtol.max(ROUNDING)
}

/// Checks that the varied number does not change the gap of a contact, or its velocity, at a minimum of zero.
///
/// # Errors
/// Text that says why there is no derivative with respect to the varied number.
pub fn check(wide: &Wide<'_>, contact: usize, y: &[f64], varied: &Varied<'_>, state: &[f64]) -> Result<(), String> {
    let direction = Direction { parameters: varied.parameters, state };
    let row = wide.contacts.rows[contact][0];
    let changes = [wide.gap(contact, y, direction), wide.velocity(row, y, direction)];
    // A change that is NaN counts as a change.
    if changes.iter().all(|(change, size)| change.abs() <= SMALL * size) {
        return Ok(());
    }
    Err(format!(
        "the contact `{}` is touched without a closing velocity, and a small change of `{}` decides about an impact",
        wide.contacts.impacts[contact].name, varied.name
    ))
}
