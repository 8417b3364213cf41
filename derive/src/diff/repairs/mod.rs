//! Smallest change that makes a wrong printed formula right.
//!
//! Changes of one place are tried: a sign, a number, another symbol of the same unit, a lost dot, sine for cosine, a
//! power, a factor, a term. Numbers at random states reject nearly all of them ([`points`]). A change that is left is
//! proved equal to the derived value, as verdicts are. So a repair is never a guess, though another change may be right
//! as well: the smallest one is reported.

mod change;
mod missing;
mod points;
mod pool;

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Quantities;
pub use change::Slip;
use change::changes;
use points::Points;
use pool::Pool;

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

/// Smallest change of a printed formula that makes it right.
pub struct Repair {
    /// Description of the change, such as "3*u1*u3 should be 2*u1*u3".
    pub words: String,
    /// Wrong part and right part; `None` for a term that is missing.
    pub parts: Option<(Expr, Expr)>,
    /// Kind of the mistake.
    pub slip: Slip,
}

/// Smallest change of `printed`, as it is printed, that makes it the derived value. `None` if no change of one place
/// does, or if its words are long. `left` is the number of changes that may still be tried; it goes down.
pub fn repair(
    quantities: &mut Quantities<'_>,
    comparer: &mut Comparer,
    printed: Expr,
    derived: Expr,
    rewriting: &mut Rewriting<'_>,
    left: &mut usize,
) -> Option<Repair> {
    let main = &quantities.derivations.kinematics.arena;
    if *left == 0 || main.reachable(&[printed]).len() > MOST_NODES {
        return None;
    }
    // Changes are built in an arena of their own: they must not change the order of terms in the main one.
    let mut arena = Arena::new();
    let root = Transfer::new(main).term(&mut arena, printed);
    let pool = Pool::new(quantities, &mut arena, root, derived);
    let mut points = Points::new(quantities, comparer, &arena, pool.symbols(), derived, rewriting)?;
    let mut close: Vec<change::Change> = Vec::new();
    changes(&mut arena, &pool, root, left, &mut |arena, change| {
        if points.agree(arena, change.whole) {
            close.push(change);
        }
    });
    close.sort_by_key(|change| change.slip);
    close.dedup_by_key(|change| change.whole);
    for change in close.into_iter().take(MOST_PROOFS) {
        let [before, after] = [change.before, change.after].map(|e| text(&arena, e));
        if before.len() > LONGEST || after.len() > LONGEST {
            continue;
        }
        let main = &mut quantities.derivations.kinematics.arena;
        let whole = Transfer::new(&arena).term(main, change.whole);
        let Ok(whole) = rewriting(quantities, whole) else { continue };
        let main = &mut quantities.derivations.kinematics.arena;
        if comparer.compare(main, whole, derived).is_equal() {
            let mut transfer = Transfer::new(&arena);
            let parts = (transfer.term(main, change.before), transfer.term(main, change.after));
            return Some(Repair { words: change.words(&before, &after), parts: Some(parts), slip: change.slip });
        }
    }
    let words = missing::missing_term(quantities, comparer, printed, derived, rewriting)?;
    Some(Repair { words, parts: None, slip: Slip::LostTerm })
}
