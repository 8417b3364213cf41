//! Verdict on a published derivation, in sentences for the abstract of the page.

use crate::page::markup::html::{escape, listed};
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::diff::{Consequences, Difference};

/// Largest number of systems that a sentence names.
const NAMED: usize = 4;

/// Largest number of root mistakes that a sentence names: those with the most entries.
const MISTAKES: usize = 3;

/// Sentences as HTML, each with the id of the section that has its evidence. They give the number of wrong entries, the
/// mistakes that cause them, and their effect on the motion.
pub fn abstract_of_verdict(difference: &Difference) -> Vec<(&'static str, String)> {
    let counted = std::iter::once(("errata", entries(difference)));
    let mistakes = mistakes(difference).map(|said| ("mistakes", said));
    counted.chain(mistakes).chain(systems(difference).map(|said| ("effects", said))).collect()
}

/// Sentence on the number of root mistakes, and on those that cause most wrong entries. `None` if there is at most one
/// mistake, and it causes no other.
fn mistakes(difference: &Difference) -> Option<String> {
    let Difference { roots, findings, .. } = difference;
    let mut most: Vec<_> = roots.iter().filter(|root| root.entries() > 1).collect();
    most.sort_by_key(|root| std::cmp::Reverse(root.entries()));
    let named: Vec<String> = most
        .iter()
        .take(MISTAKES)
        .map(|root| format!("{} of <code>{}</code>", root.entries(), escape(&findings[root.finding].id)))
        .collect();
    let come = if named.is_empty() { String::new() } else { format!(": {} come", listed(&named)) };
    match roots.len() {
        0 | 1 if named.is_empty() => None,
        1 => Some(format!("One root mistake is behind them{come}.")),
        n => Some(format!("{n} root mistakes are behind them{come}.")),
    }
}

fn entries(difference: &Difference) -> String {
    let all = difference.findings.len();
    let said = |word: &str, what: &str| Some(difference.count(word)).filter(|n| *n > 0).map(|n| format!("{n} {what}"));
    let list: Vec<String> = [
        said("different", "wrong"),
        said("undecided", "undecided"),
        said("scaled", "right up to a factor"),
        said("equal", "as derived"),
        said("stated", "only stated"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let printed = if all == 1 { "printed entry" } else { "printed entries" };
    format!("Of {all} {printed}: {}.", listed(&list))
}

/// Sentence on the accelerations and the energy of the printed systems; `None` if there is no system.
fn systems(difference: &Difference) -> Option<String> {
    let list = &difference.consequences;
    let of = |is: &dyn Fn(&Consequences) -> bool| list.iter().filter(|system| is(system)).collect::<Vec<_>>();
    let wrong = of(&|system| matches!(system.accelerations, Verdict::Different(_)));
    let breaks = |system: &Consequences| {
        system.rates.iter().any(|rate| rate.integral.is_energy() && matches!(rate.verdict, Verdict::Different(_)))
    };
    let broken = of(&breaks).len();
    let moves = match (wrong.len(), list.len()) {
        (_, 0) => return None,
        (0, all) if of(&|system| system.accelerations.is_equal()).len() == all => {
            format!("Every printed system, of {all}, gives the derived accelerations")
        }
        (0, all) => format!("No printed system, of {all}, is proved to be wrong"),
        (n, all) if n == all => format!("No printed system, of {all}, gives the derived accelerations"),
        (n, all) => {
            let named = wrong.iter().take(NAMED).map(|system| format!("<code>{}</code>", escape(&system.system)));
            let more = (n > NAMED).then(|| format!("{} more", n - NAMED));
            let names: Vec<String> = named.chain(more).collect();
            format!("Of {all} printed systems these do not give the derived accelerations: {}", listed(&names))
        }
    };
    let energy = match broken {
        0 => String::new(),
        1 => "; one does not conserve the energy".to_owned(),
        n => format!("; {n} do not conserve the energy"),
    };
    Some(format!("{moves}{energy}."))
}
