//! Search, by proof, for root mistakes: wrong entries that cause other wrong entries.
//!
//! An entry is traced to earlier entries in three cases. First, it has an equal wrong value. Second, exactly the
//! printed value follows when printed values replace the derived values in its formula ([`consequences_of_values`],
//! [`row_changes`], [`solved_systems`]). Third, another component of the same vector has an equal mistake
//! ([`shared_mistake`]). Each dependence is proved as an identity of terms. An entry for which no proof is found within
//! the limit on comparisons is a root of its own. Invariant: every entry judged "different" is in exactly one group,
//! the group of its first source. Equal differences alone do not link two entries: two separate slips may give equal
//! differences.

mod consequences_of_values;
mod contradicting_numbers;
mod coriolis;
mod derived_values;
mod exact_comparison;
mod root;
mod row_changes;
mod shared_mistake;
mod solved_systems;
mod source_search;

pub use root::{DependenceKind, DependentEntry, RootMistake};

use super::equations::claim::Claim;
use super::equations::matched_system::MatchedSystem;
use super::formulas::finding::{Finding, Judgement};
use super::formulas::swapped_lists::SwappedLists;
use crate::algebra::meaning::permitted_states::PermittedStates;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Quantities;
use crate::model::TIME;
use crate::publication::Publication;
use source_search::{DependenceReason, SourceSearch};

/// Longest description of a mistake in a title, in characters.
const LONGEST: usize = 200;

/// Finds the root mistakes that cause the wrong entries, in the order of the publication file. `findings` and `claims`
/// (statements as data) have one item for each entry. `tables` are the printed systems matched with derived rows.
pub fn find_root_mistakes(
    quantities: &mut Quantities<'_>,
    permitted: &PermittedStates,
    findings: &[Finding],
    claims: &[Claim],
    tables: &[MatchedSystem],
    swapped: &[SwappedLists],
    publication: &Publication,
) -> Vec<RootMistake> {
    let wrong: Vec<usize> = (0..findings.len()).filter(|at| findings[*at].judgement == Judgement::Different).collect();
    let stated: Vec<&Claim> = wrong.iter().map(|at| &claims[*at]).collect();
    let mut search = SourceSearch::new(quantities, permitted, &stated, tables);
    let mut reasons: Vec<Option<DependenceReason>> = (0..wrong.len()).map(|at| search.find_source(at)).collect();
    let shared = search.shared;
    let ids: Vec<&str> = wrong.iter().map(|at| findings[*at].id.as_str()).collect();
    let swapped = contradicting_numbers::link_contradicting_numbers(&stated, &ids, &mut reasons, swapped);
    let different: Vec<&Finding> = wrong.iter().map(|at| &findings[*at]).collect();
    let rates: Vec<Expr> = quantities.model.coordinates.iter().filter(|c| c.name != TIME).map(|c| c.rate).collect();
    coriolis::link_coriolis_entries(
        &mut quantities.derivations.kinematics.arena,
        &rates,
        &stated,
        &different,
        &mut reasons,
    );
    let arena = &quantities.derivations.kinematics.arena;
    link_equal_mistakes(arena, publication, &different, &mut reasons);
    let words = |at: usize| match (&shared[at], stated[at]) {
        (Some(words), _) => words.clone(),
        (None, Claim::Number { .. }) => {
            let lists = swapped.iter().find(|(first, _)| *first == at);
            lists.map_or_else(|| "it contradicts other printed numbers".to_owned(), |(_, words)| words.clone())
        }
        _ => root_mistake_description(arena, &findings[wrong[at]]),
    };
    group_by_root(&wrong, &reasons, words)
}

/// Smallest number of nodes of a term from which on equal mistakes in two entries count as one mistake.
const FEWEST_PARTS: usize = 5;

/// Traces an entry without a reason to an earlier entry in which the same term has the same mistake.
fn link_equal_mistakes(
    arena: &Arena,
    publication: &Publication,
    wrong: &[&Finding],
    reasons: &mut [Option<DependenceReason>],
) {
    for at in 0..wrong.len() {
        if reasons[at].is_some() {
            continue;
        }
        // The formula of an abbreviation is printed once, even if several entries use the
        // abbreviation.
        let own = &wrong[at].abbreviations;
        let first = |name: &String| (0..at).find(|source| wrong[*source].abbreviations.iter().eq([name]));
        let same = match own.as_slice() {
            [_] => (0..at)
                .find(|source| wrong[*source].abbreviations == *own && wrong[*source].change == wrong[at].change)
                .map(|source| vec![source]),
            _ => own.iter().map(first).collect::<Option<Vec<usize>>>().filter(|sources| !sources.is_empty()),
        };
        if let Some(sources) = same {
            reasons[at] = Some(DependenceReason::new(DependenceKind::Repeated, sources));
            continue;
        }
        let Some(change) = wrong[at].change else { continue };
        // A term that has an abbreviation, such as s12 for sin(q1 + q2), is printed only once.
        let is_named = publication.abbreviations.iter().any(|(_, value)| *value == change.0);
        if arena.reachable(&[change.0]).len() < FEWEST_PARTS && !(is_named && arena.symbol_name(change.0).is_none()) {
            continue;
        }
        if let Some(source) = (0..at).find(|source| wrong[*source].change == Some(change)) {
            reasons[at] = Some(DependenceReason::new(DependenceKind::Repeated, vec![source]));
        }
    }
}

/// Description of the mistake in an entry that is a root, in words.
fn root_mistake_description(arena: &Arena, finding: &Finding) -> String {
    if let Some(wrong) = finding.wrong.as_ref().filter(|words| words.chars().count() <= LONGEST) {
        return wrong.clone();
    }
    // A factor of the whole row does not describe the mistake in it.
    if let Some(factor) = finding.factor.filter(|_| finding.places.is_empty()) {
        return format!("it is off by the factor {}", print_text(arena, factor));
    }
    let difference = finding.difference.map(|e| print_text(arena, e)).filter(|words| words.len() <= LONGEST);
    match (difference, finding.remarks.first()) {
        (Some(difference), _) => format!("printed − derived = {difference}"),
        (None, Some(remark)) if finding.difference.is_none() => remark.clone(),
        _ => match finding.slip {
            Some(slip) => format!("{} is wrong", slip.words()),
            None => "it differs in several terms".to_owned(),
        },
    }
}

/// Groups every wrong entry with the root of its first source. Indices in `reasons` are positions
/// in `wrong`.
fn group_by_root(
    wrong: &[usize],
    reasons: &[Option<DependenceReason>],
    words: impl Fn(usize) -> String,
) -> Vec<RootMistake> {
    let mut roots: Vec<RootMistake> = Vec::new();
    // Roots of each entry, with the root of its own group first. All sources of an entry precede it in the list.
    let mut of: Vec<Vec<usize>> = Vec::new();
    for (at, reason) in reasons.iter().enumerate() {
        let Some(reason) = reason else {
            of.push(vec![roots.len()]);
            roots.push(RootMistake { finding: wrong[at], mistake: words(at), followers: Vec::new() });
            continue;
        };
        let mut own: Vec<usize> = Vec::new();
        for root in reason.hangs_on.iter().flat_map(|source| of[*source].clone()) {
            if !own.contains(&root) {
                own.push(root);
            }
        }
        let also = own[1..].iter().map(|root| roots[*root].finding).collect();
        let from = reason.from.iter().map(|source| wrong[*source]).collect();
        roots[own[0]].followers.push(DependentEntry { finding: wrong[at], link: reason.link, from, also });
        of.push(own);
    }
    roots
}
