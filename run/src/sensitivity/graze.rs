//! Contacts that are just touched.
//!
//! Where a gap comes down to nothing and grows again, a motion beside meets it, or does not: on one side of the touch slopes are those of a flight, on the other they grow as the inverse of the
//! velocity of the impact, beyond bounds. So there is no derivative by what changes the gap there, nor, as the gap is flat there in time, by what changes its velocity; by all else slopes go on.

use super::contacts::{Direction, SMALL, Wide};
use super::forces::Varied;
use tripos_sim::Options;

/// How small a gap must be at its least, in units of the relative tolerance of a run, not to be told from one that closes.
const TOLD: f64 = 8.0;
/// The least relative tolerance by which that is judged: rounding.
const ROUNDING: f64 = 1e-13;

/// How small a gap must be at its least to count as touched, as a part of what it is made of: what a run leaves open.
pub fn near(options: &Options) -> f64 {
    TOLD * options.rtol.max(ROUNDING)
}

/// Why there is no derivative by what is varied where the gap of a contact is at its least, and nothing.
///
/// # Errors
/// The reason, if there is one.
pub fn check(wide: &Wide<'_>, (contact, y): (usize, &[f64]), varied: &Varied<'_>, state: &[f64]) -> Result<(), String> {
    let direction = Direction { parameters: varied.parameters, state };
    let row = wide.contacts.rows[contact][0];
    let changes = [wide.gap(contact, y, direction), wide.velocity(row, y, direction)];
    // What is not a number changes nobody knows how.
    if changes.iter().all(|(change, size)| change.abs() <= SMALL * size) {
        return Ok(());
    }
    Err(format!(
        "the contact `{}` is touched there without a velocity that closes it, and whether it is met changes with `{}`",
        wide.contacts.impacts[contact].name, varied.name
    ))
}
