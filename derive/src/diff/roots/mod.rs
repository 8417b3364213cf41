//! Root mistakes: a search, by proof, for wrong entries that repeat other wrong entries or follow
//! from them.
//!
//! An entry is traced to earlier entries in three cases. First, it has an equal wrong value.
//! Second, exactly the printed value follows when printed values replace the derived ones in its
//! formula ([`chain`], [`rows`], [`solutions`]). Third, another component of the same vector has an
//! equal mistake ([`shared_mistake`]). Each claim of dependence is proved as an identity of terms.
//! An entry without a proof within a counted budget is a root of its own. Invariant: every entry
//! judged "different" is in exactly one group, the group of its first source. Equal differences
//! alone do not link two entries: two separate slips may give equal differences.

mod chain;
mod coriolis;
mod derived_values;
mod exact;
mod numbers;
mod root;
mod rows;
mod search;
mod shared_mistake;
mod solutions;

pub use root::{Follower, Link, Root};

use super::equations::claim::{Claim, Table};
use super::formulas::finding::{Finding, Judgement};
use super::formulas::swapped_lists::Swapped;
use crate::algebra::meaning::permitted::Permitted;
use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Quantities;
use crate::model::TIME;
use crate::publication::Publication;
use search::{Reason, Search};

/// Longest description of a mistake in a title, in characters.
const LONGEST: usize = 200;

/// Finds the root mistakes that cause the wrong entries, in the order of the publication file.
/// `findings` and `claims` (statements as data) have one item for each entry. `tables` are the
/// printed systems matched with derived rows.
pub fn find(
    quantities: &mut Quantities<'_>,
    permitted: &Permitted,
    findings: &[Finding],
    claims: &[Claim],
    tables: &[Table],
    swapped: &[Swapped],
    publication: &Publication,
) -> Vec<Root> {
    let wrong: Vec<usize> = (0..findings.len()).filter(|at| findings[*at].judgement == Judgement::Different).collect();
    let stated: Vec<&Claim> = wrong.iter().map(|at| &claims[*at]).collect();
    let mut search = Search::new(quantities, permitted, &stated, tables);
    let mut reasons: Vec<Option<Reason>> = (0..wrong.len()).map(|at| search.explain(at)).collect();
    let shared = search.shared;
    let ids: Vec<&str> = wrong.iter().map(|at| findings[*at].id.as_str()).collect();
    let swapped = numbers::link(&stated, &ids, &mut reasons, swapped);
    let different: Vec<&Finding> = wrong.iter().map(|at| &findings[*at]).collect();
    let rates: Vec<Expr> = quantities.model.coordinates.iter().filter(|c| c.name != TIME).map(|c| c.rate).collect();
    coriolis::link(&mut quantities.derivations.kinematics.arena, &rates, &stated, &different, &mut reasons);
    let arena = &quantities.derivations.kinematics.arena;
    alike(arena, publication, &different, &mut reasons);
    let words = |at: usize| match (&shared[at], stated[at]) {
        (Some(words), _) => words.clone(),
        (None, Claim::Number { .. }) => {
            let lists = swapped.iter().find(|(first, _)| *first == at);
            lists.map_or_else(|| "it contradicts other printed numbers".to_owned(), |(_, words)| words.clone())
        }
        _ => mistake(arena, &findings[wrong[at]]),
    };
    grouped(&wrong, &reasons, words)
}

/// Smallest number of nodes of a term for which equal mistakes in two entries count as one mistake.
const FEWEST_PARTS: usize = 5;

/// Traces an entry that has no reason yet to an earlier entry in which the same term has the same
/// mistake.
fn alike(arena: &Arena, publication: &Publication, wrong: &[&Finding], reasons: &mut [Option<Reason>]) {
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
            reasons[at] = Some(Reason::new(Link::Repeated, sources));
            continue;
        }
        let Some(change) = wrong[at].change else { continue };
        // A term that has an abbreviation, such as s12 for sin(q1 + q2), is written once.
        let is_named = publication.abbreviations.iter().any(|(_, value)| *value == change.0);
        if arena.reachable(&[change.0]).len() < FEWEST_PARTS && !(is_named && arena.symbol_name(change.0).is_none()) {
            continue;
        }
        if let Some(source) = (0..at).find(|source| wrong[*source].change == Some(change)) {
            reasons[at] = Some(Reason::new(Link::Repeated, vec![source]));
        }
    }
}

/// Description of the mistake in an entry that is a root, in words.
fn mistake(arena: &Arena, finding: &Finding) -> String {
    if let Some(wrong) = finding.wrong.as_ref().filter(|words| words.chars().count() <= LONGEST) {
        return wrong.clone();
    }
    // The factor of a whole row does not describe the row's mistake.
    if let Some(factor) = finding.factor.filter(|_| finding.places.is_empty()) {
        return format!("it is off by the factor {}", text(arena, factor));
    }
    let difference = finding.difference.map(|e| text(arena, e)).filter(|words| words.len() <= LONGEST);
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
fn grouped(wrong: &[usize], reasons: &[Option<Reason>], words: impl Fn(usize) -> String) -> Vec<Root> {
    let mut roots: Vec<Root> = Vec::new();
    // List of each entry's roots, the root of its own group first. The sources of an entry come
    // before it.
    let mut of: Vec<Vec<usize>> = Vec::new();
    for (at, reason) in reasons.iter().enumerate() {
        let Some(reason) = reason else {
            of.push(vec![roots.len()]);
            roots.push(Root { finding: wrong[at], mistake: words(at), followers: Vec::new() });
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
        roots[own[0]].followers.push(Follower { finding: wrong[at], link: reason.link, from, also });
        of.push(own);
    }
    roots
}
