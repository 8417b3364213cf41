//! Changes of a formula at one place, tried as repairs of a misprint.

use super::mistake_kind::MistakeKind;
use super::replacement_pool::ReplacementPool;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashSet;

/// Largest number of changes of one formula that are tried.
const MOST: usize = 40_000;
/// Largest number of equal terms (or factors), such as w1 in w1 + w1, of which a single one may be wrong.
const MOST_EQUAL: i64 = 4;
/// Largest number of terms of a sum in which groups may have lost a square.
const MOST_GROUPED: usize = 6;
/// Fractions (numerator, denominator) by which terms are multiplied to repair a wrong sign or
/// number.
const NUMBERS: [(i64, i64); 12] =
    [(-1, 1), (2, 1), (1, 2), (3, 1), (1, 3), (4, 1), (1, 4), (3, 2), (2, 3), (3, 4), (4, 3), (-1, 2)];

/// Formula in which one part is changed, with the part before and after the change.
#[derive(Clone, Copy, Debug)]
pub struct FormulaChange {
    /// Kind of the mistake that the change repairs.
    pub slip: MistakeKind,
    /// Changed part of the formula, as printed.
    pub before: Expr,
    /// New value of the part; 0 if the part is removed.
    pub after: Expr,
    /// Whole formula, in which the part is changed.
    pub whole: Expr,
    /// True if every occurrence of the part is changed, false if a single occurrence is.
    pub throughout: bool,
}

impl FormulaChange {
    /// Describes the change in words. `before` and `after` are the texts of the part before and after the change.
    pub fn words(&self, before: &str, after: &str) -> String {
        match (self.after, self.throughout) {
            (Expr::ZERO, _) => format!("the term {before} should not be there"),
            (_, true) => format!("{before} should be {after} throughout"),
            (_, false) => format!("{before} should be {after}"),
        }
    }
}

/// Replacement for a part of a formula, with the kind of mistake that it would repair.
struct PartReplacement {
    slip: MistakeKind,
    part: Expr,
}

/// Passes every change of the formula `root` at one place to `tell`, each change once, until `left` changes have been
/// tried.
pub fn formula_changes(
    arena: &mut Arena,
    pool: &ReplacementPool,
    root: Expr,
    left: &mut usize,
    tell: &mut dyn FnMut(&mut Arena, FormulaChange),
) {
    let mut known: FxHashSet<Expr> = std::iter::once(root).collect();
    let mut tell = |arena: &mut Arena, change: FormulaChange| {
        if *left > 0 && known.len() < MOST && known.insert(change.whole) {
            *left -= 1;
            tell(arena, change);
        }
    };
    let parts = arena.reachable(&[root]);
    if !matches!(arena.node(root), Node::Sum(..)) {
        for PartReplacement { slip, part } in term_replacements(arena, pool, root) {
            tell(arena, FormulaChange { slip, before: root, after: part, whole: part, throughout: false });
        }
    }
    for sum in parts.iter().copied() {
        let Node::Sum(constant, terms) = arena.node(sum).clone() else { continue };
        let parents: Vec<Expr> = parts.iter().copied().filter(|p| arena.operands(*p).any(|e| e == sum)).collect();
        let constant = arena.number(constant);
        let list: Vec<Expr> = terms.iter().map(|(term, k)| arena.scale(*term, k)).chain([constant]).collect();
        for term in list.into_iter().filter(|e| *e != Expr::ZERO) {
            for PartReplacement { slip, part } in term_replacements(arena, pool, term) {
                let rest = arena.sub(sum, term);
                let changed = arena.add(rest, part);
                // An extra term inside a formula is reported with the sum that contains it.
                let is_inner = slip == MistakeKind::ExtraTerm && sum != root;
                let place = if is_inner { (sum, changed) } else { (term, part) };
                let (before, after) = change_with_enclosing_function(arena, &parents, (sum, changed), place);
                let mut add = |arena: &mut Arena, whole: Option<Expr>| {
                    if let Some(whole) = whole {
                        tell(arena, FormulaChange { slip, before, after, whole, throughout: false });
                    }
                };
                let whole = formula_with_replacement(arena, root, sum, changed);
                add(arena, whole);
                for parent in parents.iter().filter(|_| parents.len() > 1) {
                    let one = formula_with_replacement(arena, *parent, sum, changed);
                    let whole = one.and_then(|one| formula_with_replacement(arena, root, *parent, one));
                    add(arena, whole);
                }
            }
        }
    }
    for sum in parts.iter().copied() {
        for (before, after) in groups_with_lost_square(arena, sum) {
            let rest = arena.sub(sum, before);
            let changed = arena.add(rest, after);
            if let Some(whole) = formula_with_replacement(arena, root, sum, changed) {
                tell(arena, FormulaChange { slip: MistakeKind::Power, before, after, whole, throughout: false });
            }
        }
    }
    for part in parts {
        let Some(list) = replacements_at_all_occurrences(arena, pool, part) else { continue };
        for PartReplacement { slip, part: after } in list {
            if let Some(whole) = formula_with_replacement(arena, root, part, after) {
                tell(arena, FormulaChange { slip, before: part, after, whole, throughout: true });
            }
        }
    }
}

/// Groups of terms of a sum, each before and after it is squared. The square of a bracket may be lost in print; the
/// terms of the bracket are then terms of the sum around it. A numerical factor of the group may stand outside of the
/// bracket or inside.
fn groups_with_lost_square(arena: &mut Arena, sum: Expr) -> Vec<(Expr, Expr)> {
    let Node::Sum(constant, terms) = arena.node(sum).clone() else { return Vec::new() };
    let constant = arena.number(constant);
    let mut list: Vec<Expr> = terms.iter().map(|(term, k)| arena.scale(*term, k)).collect();
    list.extend(Some(constant).filter(|constant| *constant != Expr::ZERO));
    if list.len() > MOST_GROUPED {
        return Vec::new();
    }
    // Each bit of a choice stands for a term. The square of the whole sum is a change of a factor.
    let whole = (1_u32 << list.len()) - 1;
    let choices = (1..whole).filter(|choice| choice.count_ones() > 1);
    let mut groups = Vec::new();
    for choice in choices {
        let chosen: Vec<Expr> = (0..list.len()).filter(|at| choice >> at & 1 == 1).map(|at| list[at]).collect();
        let group = arena.sum(&chosen);
        let (content, bare) = arena.split_content(group);
        let square = arena.square(bare);
        let inside = content.mul(&content);
        let inverted = Some(content.neg()).filter(|k| !k.is_negative());
        for factor in inverted.into_iter().chain([content, inside]) {
            groups.push((group, arena.scale(square, &factor)));
        }
    }
    groups
}

/// Replacements for a symbol, a sine or a cosine that apply to all its occurrences; `None` for
/// other terms.
fn replacements_at_all_occurrences(
    arena: &mut Arena,
    pool: &ReplacementPool,
    part: Expr,
) -> Option<Vec<PartReplacement>> {
    match *arena.node(part) {
        Node::Symbol(_) => Some(
            pool.replacements_for_symbol(part)
                .iter()
                .map(|other| PartReplacement { slip: MistakeKind::Symbol, part: *other })
                .collect(),
        ),
        Node::Apply(f, argument) => Some(
            exchange_sine_and_cosine(arena, f, argument)
                .into_iter()
                .map(|part| PartReplacement { slip: MistakeKind::Function, part })
                .collect(),
        ),
        _ => None,
    }
}

/// Formula `root` in which `before` is replaced with `after`; `None` if a divisor becomes 0.
pub fn formula_with_replacement(arena: &mut Arena, root: Expr, before: Expr, after: Expr) -> Option<Expr> {
    let mut put = Substitution::new(&[(before, after)]);
    let whole = put.apply(arena, root);
    put.undefined.is_none().then_some(whole)
}

/// Changed part as reported, before and after the change. If the sum is the only argument of a function, the function
/// is included.
fn change_with_enclosing_function(
    arena: &mut Arena,
    parents: &[Expr],
    sum: (Expr, Expr),
    term: (Expr, Expr),
) -> (Expr, Expr) {
    match parents {
        [parent] => match *arena.node(*parent) {
            Node::Apply(f, _) => (*parent, arena.apply(f, sum.1)),
            _ => term,
        },
        _ => term,
    }
}

/// Replacements for a term of a sum, or for a whole formula that is not a sum.
fn term_replacements(arena: &mut Arena, pool: &ReplacementPool, term: Expr) -> Vec<PartReplacement> {
    let mut list = Vec::new();
    for (n, d) in NUMBERS {
        let Some(k) = Rational::fraction(n, d) else { continue };
        let slip = if (n, d) == (-1, 1) { MistakeKind::Sign } else { MistakeKind::Number };
        list.push(PartReplacement { slip, part: arena.scale(term, &k) });
    }
    let (content, bare) = arena.split_content(term);
    for PartReplacement { slip, part } in factor_replacements(arena, pool, bare) {
        list.push(PartReplacement { slip, part: arena.scale(part, &content) });
    }
    // Of several equal terms, such as w1 in w1 + w1, one may be wrong.
    if content.to_i64().is_some_and(|n| (2..=MOST_EQUAL).contains(&n.abs())) {
        let one = if content.is_negative() { Rational::MINUS_ONE } else { Rational::ONE };
        let others = arena.scale(bare, &content.add(&one.neg()));
        for PartReplacement { part, .. } in
            factor_replacements(arena, pool, bare).into_iter().filter(|v| v.slip == MistakeKind::Symbol)
        {
            let part = arena.scale(part, &one);
            list.push(PartReplacement { slip: MistakeKind::Symbol, part: arena.add(others, part) });
        }
    }
    for factor in pool.factors() {
        list.push(PartReplacement { slip: MistakeKind::LostFactor, part: arena.mul(term, *factor) });
        if let Some(part) = arena.div(term, *factor) {
            list.push(PartReplacement { slip: MistakeKind::LostFactor, part });
        }
    }
    list.push(PartReplacement { slip: MistakeKind::ExtraTerm, part: Expr::ZERO });
    list
}

/// Replacements for a part that is not a sum: changes of the part itself, of its factors and of its
/// arguments.
fn factor_replacements(arena: &mut Arena, pool: &ReplacementPool, part: Expr) -> Vec<PartReplacement> {
    match arena.node(part).clone() {
        Node::Product(factors) => {
            let mut list = Vec::new();
            for (base, n) in factors {
                let Ok(power) = arena.pow(base, n) else { continue };
                let Some(rest) = arena.div(part, power) else { continue };
                list.push(PartReplacement { slip: MistakeKind::ExtraFactor, part: rest });
                for other in [n + 1, n - 1, -n, 2 * n].into_iter().filter(|other| *other != 0 && *other != n) {
                    if let Ok(power) = arena.pow(base, other) {
                        list.push(PartReplacement { slip: MistakeKind::Power, part: arena.mul(rest, power) });
                    }
                }
                if matches!(arena.node(base), Node::Sum(..)) {
                    continue;
                }
                for PartReplacement { slip, part } in factor_replacements(arena, pool, base) {
                    if let Ok(power) = arena.pow(part, n) {
                        list.push(PartReplacement { slip, part: arena.mul(rest, power) });
                    }
                    // Of several equal factors, such as w1 in w1 w1, one may be wrong.
                    if (2..=MOST_EQUAL).contains(&i64::from(n))
                        && matches!(slip, MistakeKind::Symbol | MistakeKind::Function)
                        && let Ok(others) = arena.pow(base, n - 1)
                    {
                        let power = arena.mul(others, part);
                        list.push(PartReplacement { slip, part: arena.mul(rest, power) });
                    }
                }
            }
            list
        }
        Node::Symbol(_) => {
            let mut list: Vec<PartReplacement> = pool
                .replacements_for_symbol(part)
                .iter()
                .map(|other| PartReplacement { slip: MistakeKind::Symbol, part: *other })
                .collect();
            list.push(PartReplacement { slip: MistakeKind::Power, part: arena.square(part) });
            // An author may print θ for sin θ.
            list.extend(
                [arena.sin(part), arena.cos(part)].map(|part| PartReplacement { slip: MistakeKind::Function, part }),
            );
            list
        }
        Node::Apply(f, argument) => {
            let mut list: Vec<PartReplacement> = exchange_sine_and_cosine(arena, f, argument)
                .into_iter()
                .map(|part| PartReplacement { slip: MistakeKind::Function, part })
                .collect();
            // The argument may be that of another sine in the right formula.
            let others =
                pool.factors().iter().filter(|other| matches!(arena.node(**other), Node::Apply(g, _) if *g == f));
            list.extend(others.map(|other| PartReplacement { slip: MistakeKind::Function, part: *other }));
            for (n, d) in [(2, 1), (1, 2), (-1, 1)] {
                let Some(k) = Rational::fraction(n, d) else { continue };
                let scaled = arena.scale(argument, &k);
                list.push(PartReplacement { slip: MistakeKind::Function, part: arena.apply(f, scaled) });
            }
            list.push(PartReplacement { slip: MistakeKind::Function, part: argument });
            if !matches!(arena.node(argument), Node::Sum(..)) {
                let (content, bare) = arena.split_content(argument);
                for PartReplacement { slip, part } in factor_replacements(arena, pool, bare) {
                    let scaled = arena.scale(part, &content);
                    list.push(PartReplacement { slip, part: arena.apply(f, scaled) });
                }
            }
            list.push(PartReplacement { slip: MistakeKind::Power, part: arena.square(part) });
            list
        }
        _ => Vec::new(),
    }
}

/// Cosine for a sine and sine for a cosine, with the same argument; `None` for other functions.
fn exchange_sine_and_cosine(arena: &mut Arena, f: Function, argument: Expr) -> Option<Expr> {
    match f {
        Function::Sin => Some(arena.cos(argument)),
        Function::Cos => Some(arena.sin(argument)),
        _ => None,
    }
}
