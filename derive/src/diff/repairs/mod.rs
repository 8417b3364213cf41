//! Search for the smallest change that makes a wrong printed formula right.
//!
//! Changes of one place are tried: a sign, a number, another symbol of the same unit, a lost dot, sine for cosine, a
//! power, a factor, a term. Numbers at random states reject nearly all changes ([`sample_points`]). A change that
//! numbers do not reject is proved equal to the derived value, by the same algebra as verdicts. A repair is therefore
//! never a guess. If several changes are right, the smallest is reported.

mod abbreviation_mistakes;
mod change_pairs;
mod formula_change;
mod mistake_kind;
mod printed_formula;
mod replacement_pool;
mod sample_points;
mod solved_parts;

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Quantities;
use crate::model::Unit;
pub use abbreviation_mistakes::AbbreviationMistakes;
pub use change_pairs::find_change_pair;
use formula_change::{FormulaChange, formula_changes};
pub use mistake_kind::MistakeKind;
use printed_formula::FormulaPlace;
pub use printed_formula::PrintedFormula;
use replacement_pool::ReplacementPool;
use sample_points::SamplePoints;
use solved_parts::repair_by_solved_part;

/// Largest number of changes that are tried for all formulas of one publication together.
pub const MOST_CHANGES: usize = 500_000;
/// Largest number of changes of one formula for which a proof is tried after the numerical test has passed.
const MOST_PROOFS: usize = 6;
/// Largest number of nodes of a formula for which changes are tried.
const MOST_NODES: usize = 400;
/// Longest text, in bytes, of a changed part that a repair may report.
const LONGEST: usize = 100;

/// Function that rewrites printed terms in the variables of the derived value, and replaces the names of derived
/// quantities with their values. The error is the reason why a term has no value.
pub type Rewriting<'a> = dyn FnMut(&mut Quantities<'_>, Expr) -> Result<Expr, String> + 'a;

/// Tools for the search for repairs of one formula.
pub struct RepairTools<'t, 'q> {
    /// Derived quantities, with the arena of the derivations.
    pub quantities: &'t mut Quantities<'q>,
    /// Comparer that proves a repaired formula equal to the derived value.
    pub comparer: &'t mut Comparer,
    /// Function that rewrites printed terms in the variables of the derived value.
    pub rewriting: &'t mut Rewriting<'t>,
    /// Number of changes that may still be tried; each tried change decreases it.
    pub left: &'t mut usize,
}

/// Smallest change of a printed formula that makes it right.
pub struct Repair {
    /// Description of the change, such as "3*u1*u3 should be 2*u1*u3".
    pub words: String,
    /// Wrong part and right part, in the arena of the derivations; `None` for a missing term.
    pub parts: Option<(Expr, Expr)>,
    /// Kind of the mistake that the change repairs.
    pub slip: MistakeKind,
    /// Index, in the formula's list, of the abbreviation that has the mistake; `None` if the formula itself has it.
    place: Option<usize>,
    /// Right formula of the abbreviation, or of the formula itself, in the formula's arena.
    changed: Expr,
}

impl Repair {
    /// Creates the repair at `place`. `parts` are the wrong and the right part, and `changed` is the right formula of
    /// the place.
    fn at(place: FormulaPlace, words: String, parts: (Expr, Expr), slip: MistakeKind, changed: Expr) -> Self {
        Self { words, parts: Some(parts), slip, place: place.at, changed }
    }
}

/// Kinds of changes that are tried in a search for repairs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum RepairSearch {
    /// Slips at one place: a wrong sign, number, symbol, function, power, factor or term.
    Slips,
    /// Slips first, then any simple value of a part that makes the formula right.
    Values,
}

/// Finds the smallest change of a printed formula that makes it equal to the derived value. Returns `None` if no change
/// of one place does, if its text is long, or if the formula is too large.
pub fn find_repair(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    derived: Expr,
    search: RepairSearch,
) -> Option<Repair> {
    let places = formula.places();
    let nodes: Vec<Expr> = places.iter().map(|place| place.formula).collect();
    if *tools.left == 0 || formula.arena.reachable(&nodes).len() > MOST_NODES {
        return None;
    }
    let close = repair_candidates(tools, formula, &places, derived)?;
    for candidate in close.into_iter().take(MOST_PROOFS) {
        if let Some(found) = prove_repair(tools, formula, candidate, derived) {
            return Some(found);
        }
    }
    if search == RepairSearch::Values { repair_by_solved_part(tools, formula, derived) } else { None }
}

/// Finds repairs of abbreviations, at most one for each, that alone make a formula equal to the derived value. The
/// author may have made such a mistake instead of one in the formula itself.
fn find_abbreviation_repairs(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    derived: Expr,
) -> Vec<Repair> {
    let places: Vec<FormulaPlace> = formula.places().into_iter().filter(|place| place.at.is_some()).collect();
    let nodes: Vec<Expr> = places.iter().map(|place| place.formula).collect();
    if places.is_empty() || *tools.left == 0 || formula.arena.reachable(&nodes).len() > MOST_NODES {
        return Vec::new();
    }
    let mut list: Vec<Repair> = Vec::new();
    for candidate in repair_candidates(tools, formula, &places, derived).into_iter().flatten().take(MOST_PROOFS) {
        if list.iter().all(|known| known.place != candidate.place.at) {
            list.extend(prove_repair(tools, formula, candidate, derived));
        }
    }
    list
}

/// Changed formula that agrees with the derived value in numbers; it is not proved yet.
#[derive(Clone, Copy)]
struct RepairCandidate {
    /// Place that is changed: the formula itself or an abbreviation.
    place: FormulaPlace,
    change: FormulaChange,
    /// Whole formula after the change; the remaining abbreviations are symbols in it.
    whole: Expr,
}

/// Changes after which the printed and the derived value agree in numbers, with the likeliest kind of mistake first.
/// Returns `None` if no numerical states are found.
fn repair_candidates(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    places: &[FormulaPlace],
    derived: Expr,
) -> Option<Vec<RepairCandidate>> {
    // Changes are built in a separate arena, because they must not change the order of terms in the main arena.
    let mut arena = std::mem::take(&mut formula.arena);
    let pools = repair_pools(tools, formula, &mut arena, places, derived);
    let Some(mut points) = repair_states(tools, formula, &arena, &pools, derived) else {
        formula.arena = arena;
        return None;
    };
    let mut close: Vec<RepairCandidate> = Vec::new();
    for (place, pool) in places.iter().zip(&pools) {
        formula_changes(&mut arena, pool, place.formula, tools.left, &mut |arena, change| {
            let whole = formula.whole_formula_with_change(arena, *place, change.whole);
            if let Some(whole) = whole.filter(|whole| points.agrees_with_right_values(arena, *whole)) {
                close.push(RepairCandidate { place: *place, change, whole });
            }
        });
    }
    formula.arena = arena;
    close.sort_by_key(|candidate| candidate.change.slip);
    close.dedup_by_key(|candidate| candidate.whole);
    Some(close)
}

/// Symbols and factors that a change may insert, one pool for each place.
fn repair_pools(
    tools: &mut RepairTools<'_, '_>,
    formula: &PrintedFormula,
    arena: &mut Arena,
    places: &[FormulaPlace],
    derived: Expr,
) -> Vec<ReplacementPool> {
    let units = units(tools, formula, arena);
    let pool = |place: &FormulaPlace| {
        // An abbreviation uses only abbreviations that are declared before it.
        let known = place.at.unwrap_or(formula.parts.len());
        let units: Vec<(Expr, Unit)> =
            units.iter().filter(|(at, ..)| *at < known).map(|(_, symbol, unit)| (*symbol, unit.clone())).collect();
        ReplacementPool::new(tools.quantities, arena, place.formula, derived, &units)
    };
    places.iter().map(pool).collect()
}

/// Index, symbol and unit of each abbreviation of a formula. Abbreviations without a known unit are left out.
fn units(tools: &mut RepairTools<'_, '_>, formula: &PrintedFormula, arena: &mut Arena) -> Vec<(usize, Expr, Unit)> {
    let mut list = Vec::new();
    let mut written: Vec<(Expr, Expr)> = Vec::new();
    for (at, part) in formula.parts.iter().enumerate() {
        let mut put = Substitution::new(&written);
        let whole = put.apply(arena, part.formula);
        if put.undefined.is_some() {
            continue;
        }
        written.push((part.symbol, whole));
        let main = &mut tools.quantities.derivations.kinematics.arena;
        let whole = Transfer::new(arena).transfer_term(main, whole);
        if let Ok(Some(unit)) = tools.quantities.model.checked_unit_of(main, whole) {
            list.push((at, part.symbol, unit));
        }
    }
    list
}

/// Random states, permitted by the model's constraints, at which changed formulas are evaluated.
/// The terms are in `arena`. Returns `None` if no such states are found.
fn repair_states(
    tools: &mut RepairTools<'_, '_>,
    formula: &PrintedFormula,
    arena: &Arena,
    pools: &[ReplacementPool],
    derived: Expr,
) -> Option<SamplePoints> {
    let mut symbols: Vec<Expr> = pools.iter().flat_map(|pool| pool.symbols().iter().copied()).collect();
    symbols.retain(|symbol| formula.parts.iter().all(|part| part.symbol != *symbol));
    symbols.sort_unstable();
    symbols.dedup();
    let mut points = SamplePoints::new(tools.quantities, tools.comparer, arena, &symbols, derived, tools.rewriting)?;
    for part in &formula.parts {
        points.set_symbol_values(arena, part.symbol, part.formula);
    }
    Some(points)
}

/// Creates the repair by a candidate change, if a proof shows that the changed formula equals the derived value. `None`
/// without a proof, or if the text is long.
fn prove_repair(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    candidate: RepairCandidate,
    derived: Expr,
) -> Option<Repair> {
    let RepairCandidate { place, change, whole } = candidate;
    let [before, after] = [change.before, change.after].map(|e| print_text(&formula.arena, e));
    if before.len() > LONGEST || after.len() > LONGEST {
        return None;
    }
    let whole = formula.write_out_abbreviations(whole)?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let whole = Transfer::new(&formula.arena).transfer_term(main, whole);
    let whole = (tools.rewriting)(tools.quantities, whole).ok()?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    if !tools.comparer.compare(main, whole, derived).is_equal() {
        return None;
    }
    let [wrong, right] =
        [formula.write_out_abbreviations(change.before)?, formula.write_out_abbreviations(change.after)?];
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let mut transfer = Transfer::new(&formula.arena);
    let parts = (transfer.transfer_term(main, wrong), transfer.transfer_term(main, right));
    let words = change.words(&before, &after);
    let words = formula.mistake_text_with_place(place, &words);
    Some(Repair::at(place, words, parts, change.slip, change.whole))
}

/// True if a formula, with its abbreviations written out, is proved equal to the derived value.
fn is_repaired_formula_right(tools: &mut RepairTools<'_, '_>, formula: &mut PrintedFormula, derived: Expr) -> bool {
    let Some(whole) = formula.write_out_abbreviations(formula.root) else { return false };
    let main: &mut Arena = &mut tools.quantities.derivations.kinematics.arena;
    let whole = Transfer::new(&formula.arena).transfer_term(main, whole);
    let Ok(whole) = (tools.rewriting)(tools.quantities, whole) else { return false };
    let main = &mut tools.quantities.derivations.kinematics.arena;
    tools.comparer.compare(main, whole, derived).is_equal()
}
