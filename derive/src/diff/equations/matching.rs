//! Search for the derived row, or the combination of derived rows, that a printed row was meant to be.
//!
//! A row that is right with any factor is matched with it. Of other rows the match with fewest wrong entries wins,
//! where plain factors count less than involved ones: 1, a number, a monomial of parameters, another term of
//! parameters. A factor that depends on the state makes a whole row right, or is no match: a wrong row would be
//! compared with a multiple that nobody meant. The search runs modulo random primes and proves nothing.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve;
use crate::algebra::value::rank::in_fields;
use crate::algebra::{Arena, Expr, Function, Node};

/// Match of a printed row that the search found.
pub enum Found {
    /// One derived row. The factor is the ratio of the entries in a column, or 1 without a column.
    Row {
        /// Index of the derived row.
        at: usize,
        /// Column whose printed entry over its derived entry is the factor; `None` for the factor 1.
        column: Option<usize>,
    },
    /// Sum of multiples of derived rows, with a constant multiplier for each, in all entries but one.
    Combination(Vec<Expr>),
}

/// Cost of a wrong entry; costs of factors are relative to it.
const WRONG: usize = 100;
/// Most rows of a system of which combinations are tried.
const MOST_ROWS: usize = 4;

/// A derived row with a factor, and how well it agrees with a printed row.
#[derive(Clone, Copy)]
struct Candidate {
    at: usize,
    column: Option<usize>,
    /// Number of entries that disagree.
    wrong: usize,
    /// Number of entries that agree and are not zero.
    right: usize,
}

/// Best match of a printed row. Row number `index` is preferred where nothing else decides. `parameters` are the
/// symbols that do not depend on the state.
pub fn best_match(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    parameters: &[Expr],
    printed: &[Expr],
    derived: &[Vec<Expr>],
    index: usize,
) -> Found {
    let own = index.min(derived.len() - 1);
    let list = candidates(arena, printed, derived, own);
    if let Some(whole) = list.iter().find(|c| c.wrong == 0) {
        return Found::Row { at: whole.at, column: whole.column };
    }
    let mut best = (usize::MAX, Found::Row { at: own, column: None });
    for c in list {
        let least = WRONG * c.wrong + usize::from(c.at != own);
        if least >= best.0 {
            continue;
        }
        let factor = match c.column {
            None => Some(0),
            Some(column) => {
                let ratio = arena.div(printed[column], derived[c.at][column]);
                let ratio = ratio.map(|e| simplifier.simplify(arena, e));
                ratio.and_then(|ratio| cost_of_factor(arena, parameters, ratio))
            }
        };
        if let Some(cost) = factor.map(|factor| least + factor).filter(|cost| *cost < best.0) {
            best = (cost, Found::Row { at: c.at, column: c.column });
        }
    }
    if best.0 >= 2 * WRONG
        && let Some((cost, multipliers)) = nearly_combined(arena, simplifier, parameters, printed, derived)
        && cost < best.0
    {
        return Found::Combination(multipliers);
    }
    best.1
}

/// Derived row of which a printed row is a multiple in all entries, and a column whose quotient is the factor. `None`
/// if there is no such row.
#[must_use]
pub fn explained(arena: &Arena, printed: &[Expr], derived: &[Vec<Expr>], index: usize) -> Option<(usize, usize)> {
    let own = index.min(derived.len() - 1);
    candidates(arena, printed, derived, own).into_iter().find_map(|c| Some((c.at, c.column.filter(|_| c.wrong == 0)?)))
}

/// Every derived row with the factor 1 and with each ratio of a printed to a derived entry, the row `own` first.
fn candidates(arena: &Arena, printed: &[Expr], derived: &[Vec<Expr>], own: usize) -> Vec<Candidate> {
    let mut all = derived.to_vec();
    all.push(printed.to_vec());
    let points: Vec<_> = in_fields(arena, &all).collect();
    if points.is_empty() {
        return Vec::new();
    }
    let count = derived.len();
    let order = std::iter::once(own).chain((0..count).filter(|at| *at != own));
    let mut list = Vec::new();
    for at in order {
        // Matrix entries come before the right-hand side: if two factors are equally good, the matrix entry gives the
        // factor.
        for column in std::iter::once(None).chain((0..printed.len()).map(Some)) {
            if let Some(j) = column {
                let both = points.iter().all(|(_, rows)| rows[count][j] != 0 && rows[at][j] != 0);
                if !both || is_one_sided(arena, printed[j]) || is_one_sided(arena, derived[at][j]) {
                    continue;
                }
            }
            let agrees = |k: usize| {
                points.iter().all(|(f, rows)| {
                    let (p, d) = (&rows[count], &rows[at]);
                    match column {
                        // p_k : d_k = p_j : d_j at every point.
                        Some(j) => f.mul(p[k], d[j]) == f.mul(p[j], d[k]),
                        None => p[k] == d[k],
                    }
                })
            };
            let (right, wrong): (Vec<usize>, Vec<usize>) = (0..printed.len()).partition(|k| agrees(*k));
            let right = right.into_iter().filter(|k| printed[*k] != Expr::ZERO).count();
            list.push(Candidate { at, column, wrong: wrong.len(), right });
        }
    }
    // A row of zeros agrees with nothing.
    list.retain(|c| c.right > 0 || c.column.is_none() && c.wrong > 0);
    list
}

/// Cost of a factor other than 1; `None` for one that depends on the state.
fn cost_of_factor(arena: &Arena, parameters: &[Expr], factor: Expr) -> Option<usize> {
    let parts = arena.reachable(&[factor]);
    if parts.iter().any(|e| arena.symbol_name(*e).is_some() && !parameters.contains(e)) {
        return None;
    }
    let is_number = arena.as_number(factor).is_some();
    let is_sum =
        |e: &Expr| matches!(arena.node(*e), Node::Sum(constant, terms) if terms.len() > 1 || !constant.is_zero());
    Some(match (is_number, parts.iter().any(is_sum)) {
        (true, _) => WRONG / 5,
        (_, false) => 2 * WRONG / 5,
        (_, true) => 6 * WRONG / 5,
    })
}

/// Constant multipliers of the derived rows whose combination agrees with a printed row in all entries but one, with
/// their cost. `None` if there are none.
fn nearly_combined(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    parameters: &[Expr],
    printed: &[Expr],
    derived: &[Vec<Expr>],
) -> Option<(usize, Vec<Expr>)> {
    let n = derived.len();
    if !(2..=MOST_ROWS).contains(&n) || printed.len() != n + 1 {
        return None;
    }
    let mut best: Option<(usize, Vec<Expr>)> = None;
    for left_out in 0..printed.len() {
        let columns: Vec<usize> = (0..printed.len()).filter(|column| *column != left_out).collect();
        let a: Vec<Vec<Expr>> = columns.iter().map(|c| derived.iter().map(|row| row[*c]).collect()).collect();
        let b: Vec<Vec<Expr>> = columns.iter().map(|c| vec![printed[*c]]).collect();
        let Ok((values, _)) = solve(arena, simplifier, &a, &b) else { continue };
        let multipliers: Vec<Expr> = values.iter().map(|value| simplifier.simplify(arena, value[0])).collect();
        let costs = multipliers.iter().filter(|m| **m != Expr::ZERO).map(|m| match *m {
            Expr::ONE | Expr::MINUS_ONE => Some(WRONG / 10),
            m => cost_of_factor(arena, parameters, m),
        });
        let Some(costs) = costs.collect::<Option<Vec<usize>>>() else { continue };
        let cost = WRONG + costs.iter().sum::<usize>();
        if costs.len() > 1 && best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, multipliers));
        }
    }
    best
}

/// True if a term contains |x| or sign x. Such a term may vanish on one side of a surface, where a row with the term as
/// factor states nothing.
fn is_one_sided(arena: &Arena, e: Expr) -> bool {
    arena.reachable(&[e]).iter().any(|p| matches!(arena.node(*p), Node::Apply(Function::Abs | Function::Sign, _)))
}
