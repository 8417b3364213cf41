//! Search for the derived row, or the combination of derived rows, that the author of a printed row meant.
//!
//! A printed row that is right up to a factor is matched with its derived row. For other rows, the match with the
//! fewest wrong entries wins. Simple factors cost less than complicated factors; the order is 1, a number, a monomial
//! of parameters, another term of parameters. A factor that depends on the state is accepted only if it makes the whole
//! row right: no author means a wrong row with such a factor. The search runs modulo random primes and proves nothing.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::value::rank::residue_matrices;
use crate::algebra::{Arena, Expr, Function, Node};

/// Match of a printed row that the search proposes; it is not proved yet.
pub enum RowMatch {
    /// Multiple of one derived row. The factor is the ratio printed ÷ derived of the entries in
    /// `column`.
    Row {
        /// Index of the derived row that matches the printed row.
        at: usize,
        /// Column whose ratio printed ÷ derived is the factor; `None` for the factor 1.
        column: Option<usize>,
    },
    /// Sum of derived rows, with one constant multiplier for each. It agrees with the printed row
    /// in all entries except one.
    Combination(Vec<Expr>),
}

/// Cost of one wrong entry; the costs of factors are fractions of it.
const WRONG: usize = 100;
/// Largest number of rows of a system whose combinations are tried.
const MOST_ROWS: usize = 4;

/// Multiple of a derived row, with a count of the entries in which it agrees with a printed row.
#[derive(Clone, Copy)]
struct MatchCandidate {
    /// Index of the derived row of this candidate.
    at: usize,
    /// Column whose ratio printed ÷ derived is the factor; `None` for the factor 1.
    column: Option<usize>,
    /// Number of entries that disagree with the printed row.
    wrong: usize,
    /// Number of entries that agree with the printed row and are not zero.
    right: usize,
}

/// Best match of a printed row with the rows of a derived system. If several derived rows match equally well, row
/// `index` is preferred. `parameters` are the symbols that do not depend on the state.
pub fn best_row_match(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    parameters: &[Expr],
    printed: &[Expr],
    derived: &[Vec<Expr>],
    index: usize,
) -> RowMatch {
    let own = index.min(derived.len() - 1);
    let list = match_candidates(arena, printed, derived, own);
    if let Some(whole) = list.iter().find(|c| c.wrong == 0) {
        return RowMatch::Row { at: whole.at, column: whole.column };
    }
    let mut best = (usize::MAX, RowMatch::Row { at: own, column: None });
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
                ratio.and_then(|ratio| cost_of_row_factor(arena, parameters, ratio))
            }
        };
        if let Some(cost) = factor.map(|factor| least + factor).filter(|cost| *cost < best.0) {
            best = (cost, RowMatch::Row { at: c.at, column: c.column });
        }
    }
    if best.0 >= 2 * WRONG
        && let Some((cost, multipliers)) = row_matching_combination(arena, simplifier, parameters, printed, derived)
        && cost < best.0
    {
        return RowMatch::Combination(multipliers);
    }
    best.1
}

/// Derived row of which the printed row is an exact multiple: its index, and the index of a column whose ratio gives
/// the factor. Returns `None` if no derived row is such a multiple, or if only the factor 1 is found, which needs no
/// column.
#[must_use]
pub fn matching_row_with_factor(
    arena: &Arena,
    printed: &[Expr],
    derived: &[Vec<Expr>],
    index: usize,
) -> Option<(usize, usize)> {
    let own = index.min(derived.len() - 1);
    match_candidates(arena, printed, derived, own)
        .into_iter()
        .find_map(|c| Some((c.at, c.column.filter(|_| c.wrong == 0)?)))
}

/// Candidates for a match: each derived row with the factor 1 and with each ratio printed ÷ derived. The derived row
/// `own` comes first.
fn match_candidates(arena: &Arena, printed: &[Expr], derived: &[Vec<Expr>], own: usize) -> Vec<MatchCandidate> {
    let mut all = derived.to_vec();
    all.push(printed.to_vec());
    let points: Vec<_> = residue_matrices(arena, &all).collect();
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
                if !both || is_unfit_row_factor(arena, printed[j]) || is_unfit_row_factor(arena, derived[at][j]) {
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
            list.push(MatchCandidate { at, column, wrong: wrong.len(), right });
        }
    }
    // A row of zeros agrees with nothing.
    list.retain(|c| c.right > 0 || c.column.is_none() && c.wrong > 0);
    list
}

/// Cost of a factor other than 1; `None` if the factor depends on the state.
fn cost_of_row_factor(arena: &Arena, parameters: &[Expr], factor: Expr) -> Option<usize> {
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

/// Constant multipliers with which the derived rows add up to a printed row in all entries except one, and the cost of
/// this match. Returns `None` if there are no such multipliers, or if the system has more than four rows.
fn row_matching_combination(
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
        let Ok((values, _)) = solve_linear(arena, simplifier, &a, &b) else { continue };
        let multipliers: Vec<Expr> = values.iter().map(|value| simplifier.simplify(arena, value[0])).collect();
        let costs = multipliers.iter().filter(|m| **m != Expr::ZERO).map(|m| match *m {
            Expr::ONE | Expr::MINUS_ONE => Some(WRONG / 10),
            m => cost_of_row_factor(arena, parameters, m),
        });
        let Some(costs) = costs.collect::<Option<Vec<usize>>>() else { continue };
        let cost = WRONG + costs.iter().sum::<usize>();
        if costs.len() > 1 && best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, multipliers));
        }
    }
    best
}

/// True if a term contains |x| or sign x. Such a factor can be zero in a whole region of states, and a row multiplied
/// by zero states nothing there.
fn is_unfit_row_factor(arena: &Arena, e: Expr) -> bool {
    arena.reachable(&[e]).iter().any(|p| matches!(arena.node(*p), Node::Apply(Function::Abs | Function::Sign, _)))
}
