//! Elimination of rows in chosen columns, with the simplest pivots first. Unlike in the module
//! `elimination`, rows may be fewer than columns or dependent, and the divisors are part of the
//! result.

use crate::algebra::form::simplify::{Simplifier, operation_count};
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};

/// Independent rows of a linear system in echelon form. The row with the pivot (r, c) reads x_c + Σ
/// entry · x_j = right. No column j belongs to an earlier pivot.
pub struct SolvedRows {
    /// Positions (row, column) of the pivots, in the order of elimination.
    pub pivots: Vec<(usize, usize)>,
    /// Matrix rows after elimination, each divided by its pivot.
    pub rows: Vec<Vec<Expr>>,
    /// Right-hand sides of the rows: an inner list for each row, with an entry for each right-hand
    /// side.
    pub right: Vec<Vec<Expr>>,
    /// Pivots by which the rows were divided, as terms. The system is not solved where a pivot is
    /// zero.
    pub divisors: Vec<Expr>,
}

/// Eliminates in the given columns by Gauss's method with the simplest pivots first. Simplest are
/// numbers, then terms without states, then terms that are never zero, then the shortest terms. The
/// elimination ends when each row has a pivot or is zero in the given columns.
pub fn solve_rows(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    mut rows: Vec<Vec<Expr>>,
    mut right: Vec<Vec<Expr>>,
    states: &[Expr],
    columns: &[usize],
) -> SolvedRows {
    let (mut pivots, mut divisors): (Vec<(usize, usize)>, Vec<Expr>) = (Vec::new(), Vec::new());
    while let Some((row, column)) = simplest_pivot_of_rows(arena, &rows, &pivots, states, columns) {
        let pivot = rows[row][column];
        divisors.push(pivot);
        for entry in rows[row].iter_mut().chain(&mut right[row]) {
            let quotient = arena.div(*entry, pivot).expect("a pivot is not zero");
            *entry = simplifier.simplify(arena, quotient);
        }
        pivots.push((row, column));
        let (pivot_row, pivot_right) = (rows[row].clone(), right[row].clone());
        for at in (0..rows.len()).filter(|at| pivots.iter().all(|(r, _)| r != at)) {
            let factor = rows[at][column];
            if factor == Expr::ZERO {
                continue;
            }
            let targets = rows[at].iter_mut().chain(&mut right[at]);
            for (target, p) in targets.zip(pivot_row.iter().chain(&pivot_right)) {
                let product = arena.mul(factor, *p);
                let difference = arena.sub(*target, product);
                *target = simplifier.simplify(arena, difference);
            }
        }
    }
    SolvedRows { pivots, rows, right, divisors }
}

impl SolvedRows {
    /// Value of the unknown x_c of pivot number `k`: right − Σ entry · x_j, with the values `x` of
    /// the other unknowns. `side` is the index of the right-hand side.
    pub fn value_of_pivot_unknown(&self, arena: &mut Arena, k: usize, side: usize, x: &[Expr]) -> Expr {
        let (row, column) = self.pivots[k];
        let others = (0..x.len()).filter(|at| *at != column && self.rows[row][*at] != Expr::ZERO);
        let terms: Vec<Expr> = others.map(|at| arena.mul(self.rows[row][at], x[at])).collect();
        let moved = arena.sum(&terms);
        arena.sub(self.right[row][side], moved)
    }
}

/// Row and column of the next pivot: the simplest entry in the given columns, without rows and
/// columns of earlier pivots. `None` if all remaining entries are zero.
fn simplest_pivot_of_rows(
    arena: &Arena,
    rows: &[Vec<Expr>],
    pivots: &[(usize, usize)],
    states: &[Expr],
    columns: &[usize],
) -> Option<(usize, usize)> {
    let class = |e: Expr| match e {
        e if arena.as_number(e).is_some() => 0,
        e if !states.iter().any(|s| arena.mentions(e, *s)) => 1,
        e if range_excludes_zero(arena, e) => 2,
        _ => 3,
    };
    let free =
        |at: usize, column: usize| columns.contains(&column) && pivots.iter().all(|(r, c)| *r != at && *c != column);
    let mut places: Vec<_> = rows
        .iter()
        .enumerate()
        .flat_map(|(at, row)| row.iter().enumerate().map(move |(column, e)| (at, column, *e)))
        .filter(|(at, column, e)| *e != Expr::ZERO && free(*at, *column))
        .map(|(at, column, e)| ((class(e), operation_count(arena, e)), at, column, e))
        .collect();
    places.sort_by_key(|(order, at, column, _)| (*order, *at, *column));
    places.into_iter().find(|(.., e)| zero_test(arena, *e) == ZeroTest::NonZero).map(|(_, at, column, _)| (at, column))
}
