//! Groups of printed numbers that contradict one another.
//!
//! In each group at least one number is wrong, but the publication does not show which. If two lists are exchanged, all
//! contradictions of their numbers are one mistake.

use super::root::DependenceKind;
use super::source_search::DependenceReason;
use crate::diff::equations::claim::Claim;
use crate::diff::formulas::swapped_lists::SwappedLists;

/// Traces every wrong number to the first number that it contradicts: directly, through other numbers, or by swapped
/// lists. Returns descriptions of the swapped lists, each with the index of the first number that the swap makes wrong.
pub fn link_contradicting_numbers(
    stated: &[&Claim],
    ids: &[&str],
    reasons: &mut [Option<DependenceReason>],
    swapped: &[SwappedLists],
) -> Vec<(usize, String)> {
    let mut first: Vec<usize> = (0..stated.len()).collect();
    let against = |at: usize| -> Vec<usize> {
        let Claim::Number { against } = stated[at] else { return Vec::new() };
        (0..ids.len()).filter(|other| against.iter().any(|id| id == ids[*other])).collect()
    };
    let mut join = |at: usize, other: usize| {
        let (a, b) = (first[at], first[other]);
        let least = a.min(b);
        first.iter_mut().filter(|f| **f == a || **f == b).for_each(|f| *f = least);
    };
    for at in 0..stated.len() {
        for other in against(at) {
            join(at, other);
        }
    }
    let mut described = Vec::new();
    for lists in swapped {
        let is_number = |at: &usize| matches!(stated[*at], Claim::Number { .. });
        let mut of = (0..ids.len()).filter(is_number).filter(|at| lists.entries.iter().any(|id| id == ids[*at]));
        let Some(least) = of.next() else { continue };
        for at in of {
            join(least, at);
        }
        described.push((least, lists.words.clone()));
    }
    for at in 0..stated.len() {
        if matches!(stated[at], Claim::Number { .. }) && first[at] != at {
            reasons[at] = Some(DependenceReason {
                link: DependenceKind::Contradicts,
                from: against(at),
                hangs_on: vec![first[at]],
            });
        }
    }
    described.into_iter().map(|(least, words)| (first[least], words)).collect()
}
