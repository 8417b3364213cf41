//! Parts of a run that are computed in the rates of all coordinates, and notes to the user about these
//! parts.

use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};

/// Part of a run that is computed in the rates of all coordinates, because the chosen speeds do not
/// determine the motion there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RatesInterval {
    /// Instant at which the part begins, s.
    pub from: f64,
    /// Instant at which the part ends, s; `None` if it lasts to the end of the run.
    pub to: Option<f64>,
    /// True if the constraints were nearly dependent in this part, as in a singular pose of the
    /// mechanism.
    pub is_singular: bool,
    /// Factor by which the tolerances were multiplied in this part, at least 1.
    pub coarser: f64,
}

/// Writes notes to the user about the parts of a run in the rates of all coordinates, the most
/// important note first. `speeds` are the names of the chosen speeds. `by` is the origin of the
/// equations in these speeds.
pub fn notes_on_rates_intervals(changes: &[RatesInterval], speeds: &[String], by: &EquationsOrigin) -> Vec<String> {
    /// Greatest number of parts that the first note lists.
    const MOST: usize = 3;
    let list = speeds.join(", ");
    let do_not = if speeds.len() == 1 { "does not" } else { "do not" };
    let part = |change: &RatesInterval| match change.to {
        Some(to) => {
            format!("t = {} s until {} s", with_reliable_digits(change.from, None), with_reliable_digits(to, None))
        }
        None => format!("t = {} s on", with_reliable_digits(change.from, None)),
    };
    let parts: Vec<String> = changes.iter().take(MOST).map(part).collect();
    let more = changes.len().checked_sub(MOST).filter(|more| *more > 0);
    let mut notes = vec![format!(
        "speeds changed: beside places where {list} {do_not} determine the motion, or hardly, all rates are run, by Lagrange's equations with \
         multipliers, instead of {}: from {}{}",
        by.title(),
        parts.join(", from "),
        more.map_or_else(String::new, |more| format!(", and {more} times more"))
    )];
    let singular: Vec<&RatesInterval> = changes.iter().filter(|change| change.is_singular).collect();
    if let Some(first) = singular.first() {
        notes.push(format!(
            "the mechanism goes through singular poses, or next to them, {}after t = {} s: its constraints depend on one another \
             there, and other motions may branch off; this one goes on smoothly",
            if singular.len() > 1 { format!("{} times, first ", singular.len()) } else { String::new() },
            with_reliable_digits(first.from, None)
        ));
    }
    if let Some(coarse) =
        changes.iter().filter(|change| change.coarser > 1.0).max_by(|a, b| a.coarser.total_cmp(&b.coarser))
    {
        notes.push(format!(
            "rounding errors exceed the tolerances next to singular poses: there, tolerances are up to {} times as coarse, first from t = {} s",
            with_significant_digits(coarse.coarser, 2),
            with_reliable_digits(coarse.from, None)
        ));
    }
    notes
}
