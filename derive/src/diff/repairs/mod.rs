//! Smallest change that makes a wrong printed formula right.
//!
//! Changes of one place are tried: a sign, a number, another symbol of the same unit, a lost dot, sine for cosine, a
//! power, a factor, a term. Numbers at random states reject nearly all of them ([`points`]). A change that is left is
//! proved equal to the derived value, as verdicts are. So a repair is never a guess, though another change may be right
//! as well: the smallest one is reported.

mod book;
mod change;
mod formula;
mod pairs;
mod points;
mod pool;
mod spots;

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Quantities;
use crate::model::Unit;
pub use book::Book;
pub use change::Slip;
use change::{Change, changes};
pub use formula::Formula;
use formula::Place;
pub use pairs::pair;
use points::Points;
use pool::Pool;
use spots::solved_spot;

/// Most changes that are tried for all formulas of one publication together.
pub const MOST_CHANGES: usize = 500_000;
/// Most changes that are proved after numbers did not reject them.
const MOST_PROOFS: usize = 6;
/// Most nodes of a formula of which changes are tried.
const MOST_NODES: usize = 400;
/// Longest text of the changed part, before or after, in bytes.
const LONGEST: usize = 100;

/// Rewriting of printed terms in the variables of the derived value, with derived quantities in the place of their
/// names. The error is the reason why a term has no value.
pub type Rewriting<'a> = dyn FnMut(&mut Quantities<'_>, Expr) -> Result<Expr, String> + 'a;

/// Tools of the search for repairs.
pub struct Tools<'t, 'q> {
    /// Derived quantities, with the arena of the derivations.
    pub quantities: &'t mut Quantities<'q>,
    /// Comparer, which proves repairs.
    pub comparer: &'t mut Comparer,
    /// Rewriting of printed terms.
    pub rewriting: &'t mut Rewriting<'t>,
    /// Number of changes that may still be tried; it goes down.
    pub left: &'t mut usize,
}

/// Smallest change of a printed formula that makes it right.
pub struct Repair {
    /// Description of the change, such as "3*u1*u3 should be 2*u1*u3".
    pub words: String,
    /// Wrong part and right part; `None` for a term that is missing.
    pub parts: Option<(Expr, Expr)>,
    /// Kind of the mistake.
    pub slip: Slip,
    /// Index, in the formula's list, of the abbreviation in which the mistake is; `None` for the formula itself.
    place: Option<usize>,
    /// Right formula at this place, in the arena of the formula.
    changed: Expr,
}

impl Repair {
    /// Repair of a part at a place.
    fn at(place: Place, words: String, parts: (Expr, Expr), slip: Slip, changed: Expr) -> Self {
        Self { words, parts: Some(parts), slip, place: place.at, changed }
    }
}

/// Changes among which a repair is sought.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// Slips of one place: another sign, number, symbol, function, power, factor or term.
    Slips,
    /// Slips, then any simple value of one place.
    Values,
}

/// Smallest change of a formula, as it is printed, that makes it the derived value. `None` if no change of one place
/// does, or if its words are long.
pub fn repair(tools: &mut Tools<'_, '_>, formula: &mut Formula, derived: Expr, search: Search) -> Option<Repair> {
    let places = formula.places();
    let nodes: Vec<Expr> = places.iter().map(|place| place.formula).collect();
    if *tools.left == 0 || formula.arena.reachable(&nodes).len() > MOST_NODES {
        return None;
    }
    let close = close_changes(tools, formula, &places, derived)?;
    for candidate in close.into_iter().take(MOST_PROOFS) {
        if let Some(found) = proved(tools, formula, candidate, derived) {
            return Some(found);
        }
    }
    if search == Search::Values { solved_spot(tools, formula, derived) } else { None }
}

/// Changes of abbreviations, one each at most, of which every one makes a formula the derived value: mistakes that may
/// be meant instead of one in the formula itself.
fn repairs_of_abbreviations(tools: &mut Tools<'_, '_>, formula: &mut Formula, derived: Expr) -> Vec<Repair> {
    let places: Vec<Place> = formula.places().into_iter().filter(|place| place.at.is_some()).collect();
    let nodes: Vec<Expr> = places.iter().map(|place| place.formula).collect();
    if places.is_empty() || *tools.left == 0 || formula.arena.reachable(&nodes).len() > MOST_NODES {
        return Vec::new();
    }
    let mut list: Vec<Repair> = Vec::new();
    for candidate in close_changes(tools, formula, &places, derived).into_iter().flatten().take(MOST_PROOFS) {
        if list.iter().all(|known| known.place != candidate.place.at) {
            list.extend(proved(tools, formula, candidate, derived));
        }
    }
    list
}

/// A change that numbers do not reject.
#[derive(Clone, Copy)]
struct Candidate {
    /// Formula or abbreviation that is changed.
    place: Place,
    change: Change,
    /// The changed formula, in which symbols stand for the other abbreviations.
    whole: Expr,
}

/// Changes that numbers do not reject, the likeliest first. `None` if there are no numbers.
fn close_changes(
    tools: &mut Tools<'_, '_>,
    formula: &mut Formula,
    places: &[Place],
    derived: Expr,
) -> Option<Vec<Candidate>> {
    // Changes are built in an arena of their own: they must not change the order of terms in the main one.
    let mut arena = std::mem::take(&mut formula.arena);
    let pools = pools(tools, formula, &mut arena, places, derived);
    let Some(mut points) = states(tools, formula, &arena, &pools, derived) else {
        formula.arena = arena;
        return None;
    };
    let mut close: Vec<Candidate> = Vec::new();
    for (place, pool) in places.iter().zip(&pools) {
        changes(&mut arena, pool, place.formula, tools.left, &mut |arena, change| {
            let whole = formula.whole(arena, *place, change.whole);
            if let Some(whole) = whole.filter(|whole| points.agree(arena, *whole)) {
                close.push(Candidate { place: *place, change, whole });
            }
        });
    }
    formula.arena = arena;
    close.sort_by_key(|candidate| candidate.change.slip);
    close.dedup_by_key(|candidate| candidate.whole);
    Some(close)
}

/// Symbols and factors that changes of each place may bring in.
fn pools(
    tools: &mut Tools<'_, '_>,
    formula: &Formula,
    arena: &mut Arena,
    places: &[Place],
    derived: Expr,
) -> Vec<Pool> {
    let units = units(tools, formula, arena);
    let pool = |place: &Place| {
        // An abbreviation uses those that are declared before it.
        let known = place.at.unwrap_or(formula.parts.len());
        let units: Vec<(Expr, Unit)> =
            units.iter().filter(|(at, ..)| *at < known).map(|(_, symbol, unit)| (*symbol, unit.clone())).collect();
        Pool::new(tools.quantities, arena, place.formula, derived, &units)
    };
    places.iter().map(pool).collect()
}

/// Index, symbol and unit of each abbreviation of a formula that has a unit.
fn units(tools: &mut Tools<'_, '_>, formula: &Formula, arena: &mut Arena) -> Vec<(usize, Expr, Unit)> {
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
        let whole = Transfer::new(arena).term(main, whole);
        if let Ok(Some(unit)) = tools.quantities.model.checked_unit_of(main, whole) {
            list.push((at, part.symbol, unit));
        }
    }
    list
}

/// States at which changes of a formula, whose terms are in `arena`, are evaluated; `None` if there are none.
fn states(
    tools: &mut Tools<'_, '_>,
    formula: &Formula,
    arena: &Arena,
    pools: &[Pool],
    derived: Expr,
) -> Option<Points> {
    let mut symbols: Vec<Expr> = pools.iter().flat_map(|pool| pool.symbols().iter().copied()).collect();
    symbols.retain(|symbol| formula.parts.iter().all(|part| part.symbol != *symbol));
    symbols.sort_unstable();
    symbols.dedup();
    let mut points = Points::new(tools.quantities, tools.comparer, arena, &symbols, derived, tools.rewriting)?;
    for part in &formula.parts {
        points.define(arena, part.symbol, part.formula);
    }
    Some(points)
}

/// Repair by a change of which numbers are right, if it is proved and its words are short.
fn proved(tools: &mut Tools<'_, '_>, formula: &mut Formula, candidate: Candidate, derived: Expr) -> Option<Repair> {
    let Candidate { place, change, whole } = candidate;
    let [before, after] = [change.before, change.after].map(|e| text(&formula.arena, e));
    if before.len() > LONGEST || after.len() > LONGEST {
        return None;
    }
    let whole = formula.written_out(whole)?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let whole = Transfer::new(&formula.arena).term(main, whole);
    let whole = (tools.rewriting)(tools.quantities, whole).ok()?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    if !tools.comparer.compare(main, whole, derived).is_equal() {
        return None;
    }
    let [wrong, right] = [formula.written_out(change.before)?, formula.written_out(change.after)?];
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let mut transfer = Transfer::new(&formula.arena);
    let parts = (transfer.term(main, wrong), transfer.term(main, right));
    let words = change.words(&before, &after);
    let words = formula.within(place, &words);
    Some(Repair::at(place, words, parts, change.slip, change.whole))
}

/// True if a formula, with abbreviations written out, is the derived value.
fn is_right(tools: &mut Tools<'_, '_>, formula: &mut Formula, derived: Expr) -> bool {
    let Some(whole) = formula.written_out(formula.root) else { return false };
    let main: &mut Arena = &mut tools.quantities.derivations.kinematics.arena;
    let whole = Transfer::new(&formula.arena).term(main, whole);
    let Ok(whole) = (tools.rewriting)(tools.quantities, whole) else { return false };
    let main = &mut tools.quantities.derivations.kinematics.arena;
    tools.comparer.compare(main, whole, derived).is_equal()
}
