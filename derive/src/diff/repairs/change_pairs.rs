//! Search for two changes that together make a wrong printed formula right.
//!
//! A trial of all pairs would cost the square of the number of changes. But two changes in different terms of a sum add
//! their effects, and two changes in different factors of a product multiply them. The value that the second change
//! must give is therefore known, and the change is looked up in a sorted list. The first change is then made, and the
//! second is sought and proved as the only remaining mistake ([`super::prove_repair`]).

use super::formula_change::{FormulaChange, formula_changes};
use super::mistake_kind::MistakeKind;
use super::printed_formula::{FormulaPlace, PrintedFormula};
use super::sample_points::{POINTS, SMALL};
use super::{
    LONGEST, MOST_NODES, MOST_PROOFS, Repair, RepairTools, prove_repair, repair_candidates, repair_pools, repair_states,
};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::print_text;

/// Largest number of changes of one formula that are combined in pairs.
const MOST_SINGLES: usize = 20_000;
/// Largest number of pairs that agree in numbers; if there are more, the likeliest are chosen.
const MOST_PAIRS: usize = 200;

/// Change of one place, with the numerical values of the whole formula after the change.
struct SingleChange {
    place: FormulaPlace,
    change: FormulaChange,
    values: [f64; POINTS],
}

/// Rule by which the effects of two changes on the value of a formula combine.
#[derive(Clone, Copy)]
enum PairCombination {
    /// The changes are in different terms of a sum.
    Sum,
    /// The changes are in different factors of a product.
    Product,
}

impl PairCombination {
    /// Value that the formula must have with the second change alone, so that both changes together make it right.
    /// `first` is the value with the first change alone, `printed` the value without changes, and `right` the value of
    /// the right formula.
    fn value_of_second_change(self, first: f64, printed: f64, right: f64) -> f64 {
        match self {
            Self::Sum => right - first + printed,
            Self::Product => right * printed / first,
        }
    }
}

/// Finds the likeliest two changes at different places that together make a formula equal to the derived value. Returns
/// `None` if there is no such pair, if its texts are long, or if the formula is too large.
pub fn find_change_pair(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    derived: crate::algebra::Expr,
) -> Option<[Repair; 2]> {
    let places = formula.places();
    let nodes: Vec<_> = places.iter().map(|place| place.formula).collect();
    if *tools.left == 0 || formula.arena.reachable(&nodes).len() > MOST_NODES {
        return None;
    }
    let (singles, printed, right) = single_changes(tools, formula, &places, derived)?;
    for first in first_changes_of_pairs(&singles, printed, right).into_iter().take(MOST_PROOFS) {
        let SingleChange { place, change, .. } = &singles[first];
        let (own, mut rest) =
            (first_repair_of_pair(formula, *place, change), formula.with_changed_place(*place, change.whole));
        let (Some(own), places) = (own, rest.places()) else { continue };
        let close = repair_candidates(tools, &mut rest, &places, derived)?;
        for candidate in close.into_iter().take(MOST_PROOFS) {
            if let Some(second) = prove_repair(tools, &mut rest, candidate, derived) {
                // The caller knows only the arena of the whole formula.
                let changed = Transfer::new(&rest.arena).transfer_term(&mut formula.arena, second.changed);
                return Some([own, Repair { changed, ..second }]);
            }
        }
    }
    None
}

/// All changes of one place with their values, sorted by the value at the first state. The second and third result are
/// the values of the printed formula and of the right formula. Returns `None` if no numerical states are found.
fn single_changes(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    places: &[FormulaPlace],
    derived: crate::algebra::Expr,
) -> Option<(Vec<SingleChange>, [f64; POINTS], [f64; POINTS])> {
    let mut arena = std::mem::take(&mut formula.arena);
    let pools = repair_pools(tools, formula, &mut arena, places, derived);
    let Some(mut points) = repair_states(tools, formula, &arena, &pools, derived) else {
        formula.arena = arena;
        return None;
    };
    let printed = points.values(&arena, formula.root);
    let mut list = Vec::new();
    for (place, pool) in places.iter().zip(&pools) {
        formula_changes(&mut arena, pool, place.formula, tools.left, &mut |arena, change| {
            let whole = formula.whole_formula_with_change(arena, *place, change.whole);
            let values = whole.and_then(|whole| points.values(arena, whole));
            if let Some(values) = values.filter(|values| list.len() < MOST_SINGLES && values[0].is_finite()) {
                list.push(SingleChange { place: *place, change, values });
            }
        });
    }
    formula.arena = arena;
    list.sort_by(|a, b| a.values[0].total_cmp(&b.values[0]));
    Some((list, printed?, points.right_values()))
}

/// Indices of the first changes of pairs that agree in numbers, the likeliest pairs first.
fn first_changes_of_pairs(singles: &[SingleChange], printed: [f64; POINTS], right: [f64; POINTS]) -> Vec<usize> {
    let mut pairs: Vec<(MistakeKind, MistakeKind, usize)> = Vec::new();
    for law in [PairCombination::Sum, PairCombination::Product] {
        for (at, first) in singles.iter().enumerate() {
            let sought: [f64; POINTS] =
                std::array::from_fn(|k| law.value_of_second_change(first.values[k], printed[k], right[k]));
            let allowed: [f64; POINTS] = std::array::from_fn(|k| {
                SMALL
                    * [first.values[k], printed[k], right[k], sought[k]].map(f64::abs).into_iter().fold(1e-3, f64::max)
            });
            let start = singles.partition_point(|single| single.values[0] < sought[0] - allowed[0]);
            for (other, second) in singles.iter().enumerate().skip(start) {
                if second.values[0] > sought[0] + allowed[0] || pairs.len() >= MOST_PAIRS {
                    break;
                }
                let fits = (0..POINTS).all(|k| (second.values[k] - sought[k]).abs() <= allowed[k]);
                if fits && other != at {
                    let (a, b) = (first.change.slip, second.change.slip);
                    pairs.push((a.max(b), a.min(b), at));
                }
            }
        }
    }
    pairs.sort_by_key(|(worse, better, _)| (*worse, *better));
    let mut list = Vec::new();
    for (.., at) in pairs {
        if !list.contains(&at) {
            list.push(at);
        }
    }
    list
}

/// Creates the repair that describes the first change of a pair; `None` if its text is long.
fn first_repair_of_pair(formula: &PrintedFormula, place: FormulaPlace, change: &FormulaChange) -> Option<Repair> {
    let [before, after] = [change.before, change.after].map(|e| print_text(&formula.arena, e));
    if before.len() > LONGEST || after.len() > LONGEST {
        return None;
    }
    let words = formula.mistake_text_with_place(place, &change.words(&before, &after));
    Some(Repair { words, parts: None, slip: change.slip, place: place.at, changed: change.whole })
}
