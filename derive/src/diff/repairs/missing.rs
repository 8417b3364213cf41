//! A term that is missing in one sum of a printed formula.

use super::{LONGEST, Rewriting};
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::{Kinematics, Quantities};

/// Most sums of a formula in which a missing term is sought.
const MOST_SUMS: usize = 12;
/// Number of characters that are shown of the sum in which a term is missing.
const LONGEST_SUM: usize = 60;

/// Description, in words, of the single term that is missing in one sum within a formula. `None` if there is none, or
/// if the words are long.
pub fn missing_term(
    quantities: &mut Quantities<'_>,
    comparer: &mut Comparer,
    printed: Expr,
    derived: Expr,
    rewriting: &mut Rewriting<'_>,
) -> Option<String> {
    let parameters = quantities.model.p();
    let arena = &quantities.derivations.kinematics.arena;
    let parts = arena.reachable(&[printed]);
    let sums: Vec<Expr> = parts.into_iter().filter(|e| matches!(arena.node(*e), Node::Sum(..))).collect();
    let whole = rewriting(quantities, printed).ok()?;
    let mut best: Option<String> = None;
    for sum in sums.into_iter().rev().take(MOST_SUMS) {
        let arena = &mut quantities.derivations.kinematics.arena;
        let place = fresh_symbol(arena, "place");
        let with_place = Substitution::new(&[(sum, place)]).apply(arena, printed);
        let slope = Differential::partial(place).apply(arena, with_place);
        if slope == Expr::ZERO || arena.mentions(slope, place) {
            continue;
        }
        let Ok(slope) = rewriting(quantities, slope) else { continue };
        let Kinematics { arena, simplifier, .. } = &mut quantities.derivations.kinematics;
        let difference = arena.sub(derived, whole);
        let Some(term) = arena.div(difference, slope) else { continue };
        let term = simplifier.simplify(arena, term);
        let words = text(arena, term);
        if !is_plain(arena, &parameters, term) || words.len() > LONGEST {
            continue;
        }
        let added = arena.mul(slope, term);
        let corrected = arena.add(whole, added);
        if !comparer.compare(arena, corrected, derived).is_equal() {
            continue;
        }
        let arena = &quantities.derivations.kinematics.arena;
        let found = if sum == printed {
            format!("the term {words} is missing")
        } else {
            format!("in {}, the term {words} is missing", beginning(&text(arena, sum)))
        };
        if best.as_ref().is_none_or(|best| found.len() < best.len()) {
            best = Some(found);
        }
    }
    best
}

/// Beginning of a long text, with an ellipsis; a short text as it is.
fn beginning(text: &str) -> String {
    if text.chars().count() <= LONGEST_SUM {
        return text.to_owned();
    }
    format!("{}…", text.chars().take(LONGEST_SUM).collect::<String>())
}

/// True if a term is a number times whole powers of symbols, sines and cosines; only parameters may divide.
fn is_plain(arena: &Arena, parameters: &[Expr], term: Expr) -> bool {
    match arena.node(term) {
        Node::Sum(constant, terms) => constant.is_zero() && terms.len() == 1 && is_plain(arena, parameters, terms[0].0),
        Node::Product(factors) => factors
            .iter()
            .all(|(base, n)| (*n > 0 || parameters.contains(base)) && !matches!(arena.node(*base), Node::Sum(..))),
        Node::Symbol(_) | Node::Apply(..) | Node::Number(_) | Node::Pi => true,
        Node::Named(..) => false,
    }
}
