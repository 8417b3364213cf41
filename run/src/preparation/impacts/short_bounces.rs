//! Notes to the user about contacts that a run holds closed because their bounces became too short.

use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::ImpactContact;
use tripos_sim::Solution;

/// Writes a note to the user for each set of contacts that are held closed because their bounces
/// became too short. The note names the contacts and the instant, s, from which they are held.
pub fn notes_on_short_bounces(impacts: &[ImpactContact], solution: &Solution) -> Vec<String> {
    let mut notes = Vec::new();
    let mut known: Vec<&[usize]> = Vec::new();
    for record in solution.impacts.iter().filter(|record| !record.held.is_empty()) {
        if known.contains(&record.held.as_slice()) {
            continue;
        }
        known.push(&record.held);
        let names: Vec<String> = record.held.iter().map(|at| format!("`{}`", impacts[*at].name)).collect();
        let note = format!(
            "bounces of {} become shorter without end: from t = {} s on, where the next could not be told from rounding, the contact is held as long \
             as it is pushed together",
            names.join(", "),
            with_reliable_digits(record.t, None)
        );
        notes.push(note);
    }
    notes
}
