//! Detection of two printed lists of numbers that are exchanged.
//!
//! The test exchanges the rates q̇ with the speeds u of equal index in a set of numbers. If this removes all
//! contradictions between numbers of the publication, the lists are swapped. This counts as one mistake, not as one for
//! each number.

use super::finding::Judgement;
use super::printed_numbers::{judge_printed_number, printed_number_entries};
use crate::model::Model;
use crate::publication::{EntryKind, Publication};
use std::collections::BTreeSet;

/// Pair of lists of one set of numbers, each printed in the place of the other.
pub struct SwappedLists {
    /// Ids of the entries of all numbers in both lists.
    pub entries: Vec<String>,
    /// Description of the mistake, with the names of the numbers.
    pub words: String,
}

/// Largest number of printed numbers for which swapped lists are sought.
const MOST_NUMBERS: usize = 200;

/// Finds exchanged lists of rates and speeds, at most one pair of lists for each set of numbers.
pub fn swapped_lists(model: &Model, publication: &Publication) -> Vec<SwappedLists> {
    if printed_number_entries(publication).count() > MOST_NUMBERS
        || count_contradictions_in_lists(model, publication) == 0
    {
        return Vec::new();
    }
    let sets: BTreeSet<&str> = printed_number_entries(publication).map(|(_, initial)| initial.set.as_str()).collect();
    sets.into_iter().filter_map(|set| swapped_lists_in_set(model, publication, set)).collect()
}

/// Number of printed numbers that are contradicted by other printed numbers.
fn count_contradictions_in_lists(model: &Model, publication: &Publication) -> usize {
    printed_number_entries(publication)
        .filter(|(e, _)| judge_printed_number(model, publication, e).finding.judgement == Judgement::Different)
        .count()
}

/// Exchanged lists of rates and speeds in a set of numbers. `None` unless the exchange removes every contradiction.
fn swapped_lists_in_set(model: &Model, publication: &Publication, set: &str) -> Option<SwappedLists> {
    let place = |symbol| {
        publication
            .entries
            .iter()
            .position(|entry| matches!(&entry.kind, EntryKind::Initial(i) if i.set == set && i.quantity == symbol))
    };
    let pairs: Vec<(usize, usize)> = model
        .coordinates
        .iter()
        .zip(&model.speeds)
        .filter_map(|(c, s)| Some((place(c.rate)?, place(s.symbol)?)))
        .collect();
    let mut turned = publication.clone();
    for (rate, speed) in &pairs {
        let of = |at: usize| match &publication.entries[at].kind {
            EntryKind::Initial(initial) => Some((initial.value, initial.decimals, initial.text.clone())),
            _ => None,
        };
        for (to, from) in [(*rate, *speed), (*speed, *rate)] {
            if let (EntryKind::Initial(own), Some((value, decimals, text))) = (&mut turned.entries[to].kind, of(from)) {
                (own.value, own.decimals, own.text) = (value, decimals, text);
            }
        }
    }
    if pairs.len() < 2 || count_contradictions_in_lists(model, &turned) > 0 {
        return None;
    }
    // Rates and speeds with equal numbers are right in either list.
    let moved = |(rate, speed): &&(usize, usize)| {
        let value = |at: usize| match &publication.entries[at].kind {
            EntryKind::Initial(initial) => Some(initial.value),
            _ => None,
        };
        value(*rate) != value(*speed)
    };
    let names = |list: Vec<usize>| {
        let name = |at: usize| match &publication.entries[at].kind {
            EntryKind::Initial(initial) => initial.name.clone(),
            _ => String::new(),
        };
        list.into_iter().map(name).collect::<Vec<_>>().join(", ")
    };
    let (rates, speeds): (Vec<usize>, Vec<usize>) = pairs.iter().filter(moved).copied().unzip();
    let words = format!("the values of {} and those of {} are exchanged", names(rates), names(speeds));
    let entries = pairs.iter().flat_map(|(a, b)| [*a, *b]).map(|at| publication.entries[at].id.clone()).collect();
    Some(SwappedLists { entries, words })
}
