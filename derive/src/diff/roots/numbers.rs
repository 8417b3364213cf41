//! Printed numbers that contradict one another. In each set of them at least one is wrong, and nothing tells which.

use super::root::Link;
use super::search::Reason;
use crate::diff::equations::claim::Claim;

/// Links every wrong number to the first number that it contradicts, directly or through others.
pub fn link(stated: &[&Claim], ids: &[&str], reasons: &mut [Option<Reason>]) {
    let mut first: Vec<usize> = (0..stated.len()).collect();
    let against = |at: usize| -> Vec<usize> {
        let Claim::Number { against } = stated[at] else { return Vec::new() };
        (0..ids.len()).filter(|other| against.iter().any(|id| id == ids[*other])).collect()
    };
    for at in 0..stated.len() {
        for other in against(at) {
            let (a, b) = (first[at], first[other]);
            let least = a.min(b);
            first.iter_mut().filter(|f| **f == a || **f == b).for_each(|f| *f = least);
        }
    }
    for at in 0..stated.len() {
        if matches!(stated[at], Claim::Number { .. }) && first[at] != at {
            reasons[at] = Some(Reason { link: Link::Contradicts, from: against(at), hangs_on: vec![first[at]] });
        }
    }
}
