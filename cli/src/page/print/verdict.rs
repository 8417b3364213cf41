//! Verdict on a published derivation as sentences for the abstract of the page.

use crate::page::print::entry_name::entry_name;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::diff::{Consequences, Difference};

/// Returns sentences as HTML, each with the id of the section that contains its evidence. The sentences give the number
/// of wrong entries, the root mistakes, and the effect on the motion.
pub fn abstract_of_verdict(difference: &Difference) -> Vec<(&'static str, String)> {
    let counted = std::iter::once(("errata", verdict_on_wrong_entries(difference)));
    let mistakes = verdict_on_root_mistakes(difference).map(|said| ("mistakes", said));
    counted.chain(mistakes).chain(verdict_on_printed_systems(difference).map(|said| ("effects", said))).collect()
}

/// Returns a sentence about the number of root mistakes, and about the mistake that causes the most wrong entries.
/// `None` if there is no mistake, or if the only mistake causes no other wrong entry.
fn verdict_on_root_mistakes(difference: &Difference) -> Option<String> {
    let Difference { roots, findings, .. } = difference;
    // If several mistakes cause the same largest number of entries, the first is named.
    let largest = roots.iter().rev().max_by_key(|root| root.entries()).filter(|root| root.entries() > 1);
    let named = largest.map(|root| (entry_name(&findings[root.finding].id), root.entries()));
    match (roots.len(), named) {
        (0, _) | (1, None) => None,
        (1, Some((name, n))) => Some(format!("One mistake, in {name}, causes all {n}.")),
        (all, None) => Some(format!("{all} mistakes cause them.")),
        (all, Some((name, n))) => Some(format!("{all} mistakes cause them; the largest, in {name}, causes {n}.")),
    }
}

/// Returns a sentence about the numbers of wrong and undecided entries.
fn verdict_on_wrong_entries(difference: &Difference) -> String {
    let all = difference.findings.len();
    let (wrong, open) = (difference.count("different"), difference.count("undecided"));
    let entries = if all == 1 { "printed entry" } else { "printed entries" };
    let are = |n: usize| if n == 1 { "is" } else { "are" };
    let wrong = match wrong {
        0 => format!("none of {all} {entries} is wrong"),
        n => format!("{n} of {all} {entries} {} wrong", are(n)),
    };
    let open = if open == 0 { String::new() } else { format!(", and {open} {} undecided", are(open)) };
    format!("{wrong}{open}.")
}

/// Returns a sentence about the accelerations and the energy by the printed systems. `None` if no system is printed.
fn verdict_on_printed_systems(difference: &Difference) -> Option<String> {
    let list = &difference.consequences;
    let of = |is: &dyn Fn(&Consequences) -> bool| list.iter().filter(|system| is(system)).count();
    let wrong = of(&|system| matches!(system.accelerations, Verdict::Different(_)));
    let right = of(&|system| system.accelerations.is_equal());
    let breaks = |system: &Consequences| {
        system.rates.iter().any(|rate| rate.integral.is_energy() && matches!(rate.verdict, Verdict::Different(_)))
    };
    let moves = match (wrong, right, list.len()) {
        (.., 0) => return None,
        (0, 1, 1) => "The printed system gives the right accelerations".to_owned(),
        (1, _, 1) => "The printed system gives wrong accelerations".to_owned(),
        (_, right, all) if right == all => format!("All {all} printed systems give the right accelerations"),
        (wrong, _, all) if wrong == all => format!("All {all} printed systems give wrong accelerations"),
        (wrong, right, all) => {
            let open = all - wrong - right;
            let open = if open == 0 { String::new() } else { format!(", {open} undecided ones") };
            let give = |n: usize| if n == 1 { "gives" } else { "give" };
            let (one, other) = (give(right), give(wrong));
            format!("Of {all} printed systems, {right} {one} right and {wrong} {other} wrong accelerations{open}")
        }
    };
    let energy = match of(&breaks) {
        0 => String::new(),
        1 if list.len() == 1 => ", and does not conserve energy".to_owned(),
        1 => ", and one does not conserve energy".to_owned(),
        n => format!(", and {n} do not conserve energy"),
    };
    Some(format!("{moves}{energy}."))
}
