//! Repair of a wrong formula by solving for the right value of one of its parts.
//!
//! If a formula, or its reciprocal, is linear in one part, the right value of this part follows from the derived value.
//! The value is a repair if it is simple enough for a printed formula: a missing term, a sum of parameters for a symbol
//! or a number, another product for a term.

use super::printed_formula::{FormulaPlace, PrintedFormula};
use super::{LONGEST, MistakeKind, Repair, RepairTools};
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::Kinematics;

/// Largest number of sums of a formula in which a missing term is sought.
const MOST_SUMS: usize = 12;
/// Largest number of terms of a formula whose right values are solved for.
const MOST_TERMS: usize = 16;
/// Largest number of nodes of a formula whose terms are solved for.
const MOST_NODES: usize = 150;
/// Number of tried changes that solving for one part counts as.
const COST: usize = 1_000;
/// Largest number of characters that are shown of a sum in which a term is missing.
const LONGEST_SUM: usize = 60;
/// Largest number of terms in a sum that replaces a symbol or a number.
const MOST_ADDED: usize = 3;

/// Kind of a part whose right value is solved for.
#[derive(Clone, Copy, PartialEq)]
enum PartKind {
    /// A sum in which a term may be missing.
    Sum,
    /// A parameter at all its occurrences, or an abbreviation as a whole.
    Whole,
    /// A single term of a sum, whose right value is solved for.
    Term,
}

/// Part of a formula whose right value is solved for.
struct FormulaPart {
    /// Formula or abbreviation that contains the part.
    place: FormulaPlace,
    kind: PartKind,
    /// Part as printed; for a missing term, the sum that lacks it.
    part: Expr,
    /// Formula of the place, in which the part is replaced with an unknown symbol.
    changed: Expr,
}

/// Finds a repair by the right value of one part. Missing terms are tried first, then parameters and abbreviations,
/// then terms. Returns `None` if no part has a simple right value.
pub fn repair_by_solved_part(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    derived: Expr,
) -> Option<Repair> {
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let symbol = fresh_symbol(main, "place");
    let name = main.symbol_name(symbol).unwrap_or_default().to_owned();
    let places = formula.places();
    let inner = formula.arena.symbol(&name);
    let is_long = formula.arena.reachable(&[formula.root]).len() > MOST_NODES;
    for kind in [PartKind::Sum, PartKind::Whole, PartKind::Term] {
        if is_long && kind == PartKind::Term {
            return None;
        }
        let mut best: Option<Repair> = None;
        for place in &places {
            for spot in solvable_parts(tools, formula, *place, kind, inner) {
                let Some(left) = tools.left.checked_sub(COST) else { return best };
                *tools.left = left;
                let Some(found) = solve_part(tools, formula, &spot, symbol, derived) else { continue };
                if best.as_ref().is_none_or(|best| found.words.len() < best.words.len()) {
                    best = Some(found);
                }
            }
        }
        if best.is_some() {
            return best;
        }
    }
    None
}

/// Parts of a kind in the formula at `place`. In each result, `symbol` replaces the part.
fn solvable_parts(
    tools: &RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    place: FormulaPlace,
    kind: PartKind,
    symbol: Expr,
) -> Vec<FormulaPart> {
    let arena = &mut formula.arena;
    let parts = arena.reachable(&[place.formula]);
    let mut list = Vec::new();
    let mut replace = |arena: &mut Arena, part: Expr, by: Expr, shown: Expr| {
        let mut put = Substitution::new(&[(part, by)]);
        let changed = put.apply(arena, place.formula);
        if put.undefined.is_none() {
            list.push(FormulaPart { place, kind, part: shown, changed });
        }
    };
    match kind {
        PartKind::Sum => {
            for sum in parts
                .into_iter()
                .rev()
                .filter(|e| matches!(arena.node(*e), Node::Sum(..)))
                .take(MOST_SUMS)
                .collect::<Vec<_>>()
            {
                replace(arena, sum, symbol, sum);
            }
        }
        PartKind::Whole => {
            if place.at.is_some() {
                replace(arena, place.formula, symbol, place.formula);
            }
            let model = tools.quantities.model;
            for p in parts {
                if arena.symbol_name(p).is_some_and(|name| model.parameters.iter().any(|q| q.name == name)) {
                    replace(arena, p, symbol, p);
                }
            }
        }
        PartKind::Term => {
            let mut count = 0;
            for sum in parts.into_iter().rev() {
                let Node::Sum(_, terms) = arena.node(sum).clone() else { continue };
                for (term, k) in terms.iter().filter(|_| terms.len() > 1) {
                    count += 1;
                    if count > MOST_TERMS {
                        return list;
                    }
                    let own = arena.scale(*term, k);
                    let rest = arena.sub(sum, own);
                    let changed = arena.add(rest, symbol);
                    replace(arena, sum, changed, own);
                }
            }
        }
    }
    list
}

/// Kind of the mistake in a part that is printed with a wrong value. It is the kind that belongs to the factor between
/// both values, or a wrong symbol if the factor belongs to no kind.
fn mistake_kind_of_solved_part(tools: &mut RepairTools<'_, '_>, printed: Expr, right: Expr) -> MistakeKind {
    let Kinematics { arena, simplifier, .. } = &mut tools.quantities.derivations.kinematics;
    let ratio = arena.div(printed, right).map(|ratio| simplifier.simplify(arena, ratio));
    ratio.and_then(|ratio| MistakeKind::of_factor(arena, ratio)).unwrap_or(MistakeKind::Symbol)
}

/// Creates the repair by the right value of a part, if it is proved equal to the derived value. Returns `None` if the
/// value cannot be solved for, is not simple, or has a long text.
fn solve_part(
    tools: &mut RepairTools<'_, '_>,
    formula: &mut PrintedFormula,
    spot: &FormulaPart,
    symbol: Expr,
    derived: Expr,
) -> Option<Repair> {
    let place = spot.place;
    let mut arena = std::mem::take(&mut formula.arena);
    let whole = formula.whole_formula_with_change(&mut arena, place, spot.changed);
    formula.arena = arena;
    let whole = formula.write_out_abbreviations(whole?)?;
    let part = formula.write_out_abbreviations(spot.part)?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let mut transfer = Transfer::new(&formula.arena);
    let (whole, part) = (transfer.transfer_term(main, whole), transfer.transfer_term(main, part));
    let added = solve_missing_term(tools, whole, part, symbol, derived)?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let sum = main.add(part, added);
    let right = tools.quantities.derivations.kinematics.simplifier.simplify(main, sum);
    let parameters = tools.quantities.model.p();
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let shown = match spot.kind {
        PartKind::Sum => {
            (is_plain_solved_term(main, &parameters, added) && !solved_term_has_sum(main, added)).then_some(added)?
        }
        PartKind::Whole => (solved_part_is_constant(main, &parameters, right)
            && is_short_solved_sum(main, &parameters, right))
        .then_some(right)?,
        PartKind::Term => {
            let ratio = main.div(right, part)?;
            let ratio = tools.quantities.derivations.kinematics.simplifier.simplify(main, ratio);
            let main = &tools.quantities.derivations.kinematics.arena;
            let is_near =
                solved_part_is_constant(main, &parameters, ratio) && is_short_solved_sum(main, &parameters, ratio);
            (is_near || is_plain_solved_term(main, &parameters, right)).then_some(right)?
        }
    };
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let corrected = Substitution::new(&[(symbol, sum)]).apply(main, whole);
    let corrected = (tools.rewriting)(tools.quantities, corrected).ok()?;
    let main = &mut tools.quantities.derivations.kinematics.arena;
    if !tools.comparer.compare(main, corrected, derived).is_equal() {
        return None;
    }
    let kind = mistake_kind_of_solved_part(tools, part, right);
    let main = &mut tools.quantities.derivations.kinematics.arena;
    let (words, before) = (print_text(main, shown), print_text(&formula.arena, spot.part));
    if words.len() > LONGEST || (spot.kind != PartKind::Sum && before.len() > LONGEST) {
        return None;
    }
    let right_in_place = Transfer::new(main).transfer_term(&mut formula.arena, right);
    let inner = formula.arena.symbol(main.symbol_name(symbol).unwrap_or_default());
    let changed = Substitution::new(&[(inner, right_in_place)]).apply(&mut formula.arena, spot.changed);
    let is_throughout = spot.kind == PartKind::Whole && spot.part != place.formula;
    let throughout = if is_throughout { " throughout" } else { "" };
    let (words, slip) = match (spot.kind, formula.name(place)) {
        (PartKind::Sum, _) if spot.part == place.formula => {
            (format!("the term {words} is missing"), MistakeKind::LostTerm)
        }
        (PartKind::Sum, _) => {
            (format!("in {}, the term {words} is missing", solved_part_text(&before)), MistakeKind::LostTerm)
        }
        (PartKind::Whole, Some(name)) if !is_throughout => {
            let words = format!("{before} should be {words}");
            return Some(Repair::at(place, format!("in {name}, {words}"), (part, right), kind, changed));
        }
        (PartKind::Whole, _) => (format!("{before} should be {words}{throughout}"), kind),
        (PartKind::Term, _) => (format!("the term {before} should be {words}"), kind),
    };
    let words = formula.mistake_text_with_place(place, &words);
    let parts = (spot.kind != PartKind::Sum || place.at.is_some()).then_some((part, right));
    Some(Repair { words, parts, slip, place: place.at, changed })
}

/// Term that makes a formula right if it is added to `part`. In `whole`, the unknown `symbol`
/// replaces the part.
/// Returns `None` if neither the formula nor its reciprocal is linear in the symbol.
fn solve_missing_term(
    tools: &mut RepairTools<'_, '_>,
    whole: Expr,
    part: Expr,
    symbol: Expr,
    derived: Expr,
) -> Option<Expr> {
    let arena = &mut tools.quantities.derivations.kinematics.arena;
    let inverse = arena.div(Expr::ONE, whole);
    let inverse_derived = arena.div(Expr::ONE, derived);
    let pairs = [Some((whole, derived)), inverse.zip(inverse_derived)];
    for (with_place, right) in pairs.into_iter().flatten() {
        let arena = &mut tools.quantities.derivations.kinematics.arena;
        let slope = Differential::partial(symbol).apply(arena, with_place);
        if slope == Expr::ZERO || arena.mentions(slope, symbol) {
            continue;
        }
        let now = Substitution::new(&[(symbol, part)]).apply(arena, with_place);
        let slope = (tools.rewriting)(tools.quantities, slope).ok()?;
        let now = (tools.rewriting)(tools.quantities, now).ok()?;
        let Kinematics { arena, simplifier, .. } = &mut tools.quantities.derivations.kinematics;
        let difference = arena.sub(right, now);
        let term = arena.div(difference, slope)?;
        return Some(simplifier.simplify(arena, term));
    }
    None
}

/// First 60 characters of a long text, with an ellipsis; a shorter text is returned whole.
fn solved_part_text(text: &str) -> String {
    if text.chars().count() <= LONGEST_SUM {
        return text.to_owned();
    }
    format!("{}…", text.chars().take(LONGEST_SUM).collect::<String>())
}

/// True if a term contains no symbols except the given parameters.
fn solved_part_is_constant(arena: &Arena, parameters: &[Expr], e: Expr) -> bool {
    arena.reachable(&[e]).into_iter().all(|part| arena.symbol_name(part).is_none() || parameters.contains(&part))
}

/// True if a term is a plain term, or a sum of at most three plain terms. Also true for a product with at most one such
/// sum as a factor.
fn is_short_solved_sum(arena: &Arena, parameters: &[Expr], e: Expr) -> bool {
    match arena.node(e) {
        Node::Sum(constant, terms) => {
            terms.len() + usize::from(!constant.is_zero()) <= MOST_ADDED
                && terms.iter().all(|(term, _)| is_plain_solved_term(arena, parameters, *term))
        }
        Node::Product(factors) => {
            factors.iter().filter(|(base, _)| matches!(arena.node(*base), Node::Sum(..))).count() < 2
                && factors.iter().all(|(base, _)| is_short_solved_sum(arena, parameters, *base))
        }
        _ => is_plain_solved_term(arena, parameters, e),
    }
}

/// True if a product has a sum as a factor or divisor.
fn solved_term_has_sum(arena: &Arena, e: Expr) -> bool {
    match arena.node(e) {
        Node::Sum(_, terms) => terms.len() == 1 && solved_term_has_sum(arena, terms[0].0),
        Node::Product(factors) => factors.iter().any(|(base, _)| matches!(arena.node(*base), Node::Sum(..))),
        _ => false,
    }
}

/// True if a term is a number times integer powers of symbols, sines and cosines, and only parameters are in divisors.
fn is_plain_solved_term(arena: &Arena, parameters: &[Expr], term: Expr) -> bool {
    match arena.node(term) {
        Node::Sum(constant, terms) => {
            constant.is_zero() && terms.len() == 1 && is_plain_solved_term(arena, parameters, terms[0].0)
        }
        Node::Product(factors) => factors.iter().all(|(base, n)| match arena.node(*base) {
            Node::Sum(..) => *n < 0 && solved_part_is_constant(arena, parameters, *base),
            _ => *n > 0 || parameters.contains(base),
        }),
        Node::Symbol(_) | Node::Apply(..) | Node::Number(_) | Node::Pi => true,
        Node::Named(..) => false,
    }
}
