//! Linear systems solved block by block, with divisions by the determinants of blocks only.
//!
//! Elimination divides by pivots that may vanish where the system is regular. A rotation matrix,
//! for example, has determinant 1, but each of its entries vanishes in some pose. A small block is
//! therefore solved by its cofactors, and its determinant is simplified before it divides. In a
//! larger block, entries that are never zero serve as pivots first; the rest is solved like a small
//! block.
//! The module `elimination` is separate: it is for systems whose pivots are known not to vanish,
//! and it shares subexpressions.

use super::linear::{Singular, solve_linear_near};
use super::minors::Minors;
use super::pivot_values::PivotValues;
use super::sparse_block::SparseBlock;
use super::system_labels::{BlockLabels, SystemLabels};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr};
use petgraph::algo::{maximum_matching, tarjan_scc};
use petgraph::graph::{DiGraph, UnGraph};

/// Largest number of rows of a block that is solved by cofactors without elimination.
const LARGEST: usize = 4;
/// Largest number of rows that may remain after elimination in a larger block and are then solved
/// by cofactors.
const LARGEST_LEFT: usize = 6;

/// Solves A x = b with a square matrix A, block by block. Returns x and the divisors; most divisors
/// are determinants of blocks.
///
/// If `labels` are given, long terms of long blocks get names: entries of A and b, minors, and the unknowns, before
/// later blocks use them. Each unknown then has a length that does not grow with the number of blocks.
///
/// # Errors
/// [`Singular`] if A is singular for all values of its symbols.
pub fn solve_blocks(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Expr],
    point: Option<&PivotValues>,
    labels: Option<&SystemLabels>,
) -> Result<(Vec<Expr>, Vec<Expr>), Singular> {
    if let Some(found) = rank(arena, a)
        && let Some(row) = found.dependent
    {
        return Err(Singular { rank: found.rank, row });
    }
    let mut x = vec![Expr::ZERO; a.len()];
    let mut divisors = Vec::new();
    for (rows, columns) in blocks(a).into_iter().flat_map(|block| block_triangular_parts(a, block.0, block.1)) {
        let mut block: Vec<Vec<Expr>> = rows.iter().map(|r| columns.iter().map(|c| a[*r][*c]).collect()).collect();
        let mut right: Vec<Expr> =
            rows.iter().map(|r| right_side(arena, simplifier, &a[*r], b[*r], &x, &columns)).collect();
        let names = labels.and_then(|labels| labels.of_block(arena, &block, &rows, &columns));
        if let Some(names) = &names {
            names.name_entries(arena, simplifier, &mut block, &mut right);
        }
        let names = names.as_ref();
        let (solution, by) = if rows.len() <= LARGEST && rows.len() == columns.len() {
            solve_block_by_cofactors(arena, simplifier, &block, &right, names)
        } else if let Some(names) = names.filter(|names| names.of_whole_unknowns()) {
            SparseBlock::new(&block, &right, names, point).solve(arena, simplifier)?
        } else {
            solve_large_block(arena, simplifier, &block, &right, point, names)?
        };
        let solution = match names {
            Some(names) => names.name_unknowns(arena, simplifier, &solution),
            None => solution,
        };
        for (column, value) in columns.iter().zip(solution) {
            x[*column] = value;
        }
        divisors.extend(by);
    }
    Ok((x, divisors))
}

/// Solves a block with more than four rows. Entries that are never zero are pivots first; the rest
/// is solved by cofactors if it is small enough. Returns the solution and the divisors, or
/// [`Singular`].
fn solve_large_block(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Expr],
    point: Option<&PivotValues>,
    labels: Option<&BlockLabels<'_>>,
) -> Result<(Vec<Expr>, Vec<Expr>), Singular> {
    let n = a.len();
    let mut rows: Vec<Vec<Expr>> = a.iter().zip(b).map(|(row, right)| [row.as_slice(), &[*right]].concat()).collect();
    let mut order: Vec<(usize, usize)> = Vec::new();
    while let Some((row, column)) = never_zero_block_pivot(arena, &rows, &order, n) {
        order.push((row, column));
        let pivot = rows[row][column];
        let named = |arena: &mut Arena, row: usize, entries: &mut [Expr]| {
            if let Some(labels) = labels {
                entries[..n].iter_mut().for_each(|entry| *entry = labels.name_minor(arena, *entry, &[row]));
            }
        };
        for entry in &mut rows[row] {
            let quotient = arena.div(*entry, pivot).expect("a pivot is not zero");
            *entry = simplifier.simplify(arena, quotient);
        }
        named(arena, row, &mut rows[row]);
        let pivot_row = rows[row].clone();
        for (other, target) in rows.iter_mut().enumerate().filter(|(other, _)| *other != row) {
            let factor = target[column];
            if factor == Expr::ZERO {
                continue;
            }
            for (entry, &p) in target.iter_mut().zip(&pivot_row) {
                let product = arena.mul(factor, p);
                let difference = arena.sub(*entry, product);
                *entry = simplifier.simplify(arena, difference);
            }
            named(arena, other, target);
        }
    }
    let left = |taken: &dyn Fn(&(usize, usize)) -> usize| -> Vec<usize> {
        (0..n).filter(|at| !order.iter().any(|pair| taken(pair) == *at)).collect()
    };
    let (rows_left, columns_left) = (left(&|(row, _)| *row), left(&|(_, column)| *column));
    let block: Vec<Vec<Expr>> = rows_left.iter().map(|r| columns_left.iter().map(|c| rows[*r][*c]).collect()).collect();
    let right: Vec<Expr> = rows_left.iter().map(|r| rows[*r][n]).collect();
    let (solution, divisors) = if rows_left.len() <= LARGEST_LEFT {
        solve_block_by_cofactors(arena, simplifier, &block, &right, None)
    } else {
        let right: Vec<Vec<Expr>> = right.into_iter().map(|e| vec![e]).collect();
        let (solution, pivots) = solve_linear_near(arena, simplifier, &block, &right, point)?;
        (solution.into_iter().map(|row| row[0]).collect(), pivots)
    };
    let mut x = vec![Expr::ZERO; n];
    for (column, value) in columns_left.iter().zip(&solution) {
        x[*column] = *value;
    }
    for (row, column) in order {
        let mut terms = vec![rows[row][n]];
        for (other, value) in columns_left.iter().zip(&solution) {
            let share = arena.mul(rows[row][*other], *value);
            terms.push(arena.neg(share));
        }
        let sum = arena.sum(&terms);
        x[column] = simplifier.simplify(arena, sum);
    }
    Ok((x, divisors))
}

/// Row and column of the next pivot: the shortest entry that is proved never to be zero. Rows and
/// columns that have a pivot already are left out. `None` if there is no such entry.
fn never_zero_block_pivot(
    arena: &Arena,
    rows: &[Vec<Expr>],
    order: &[(usize, usize)],
    n: usize,
) -> Option<(usize, usize)> {
    let mut best: Option<(usize, usize, usize)> = None;
    for (r, row) in rows.iter().enumerate().filter(|(r, _)| !order.iter().any(|(row, _)| row == r)) {
        for (c, &entry) in row[..n].iter().enumerate() {
            if entry == Expr::ZERO || order.iter().any(|(_, column)| *column == c) {
                continue;
            }
            let cost = if arena.as_number(entry).is_some() { 0 } else { arena.reachable(&[entry]).len() };
            if best.is_none_or(|(least, ..)| cost < least) && range_excludes_zero(arena, entry) {
                best = Some((cost, r, c));
            }
        }
    }
    best.map(|(_, r, c)| (r, c))
}

/// Connected blocks of a square matrix, as pairs (row indices, column indices). No non-zero entry
/// lies in the rows of one block and the columns of another.
fn blocks(a: &[Vec<Expr>]) -> Vec<(Vec<usize>, Vec<usize>)> {
    let n = a.len();
    let (mut row_seen, mut result) = (vec![false; n], Vec::new());
    for first in 0..n {
        if row_seen[first] {
            continue;
        }
        let (mut rows, mut columns, mut waiting) = (Vec::new(), Vec::new(), vec![first]);
        row_seen[first] = true;
        while let Some(row) = waiting.pop() {
            rows.push(row);
            for column in (0..n).filter(|c| a[row][*c] != Expr::ZERO) {
                if columns.contains(&column) {
                    continue;
                }
                columns.push(column);
                for other in (0..n).filter(|r| a[*r][column] != Expr::ZERO) {
                    if !row_seen[other] {
                        row_seen[other] = true;
                        waiting.push(other);
                    }
                }
            }
        }
        rows.sort_unstable();
        columns.sort_unstable();
        result.push((rows, columns));
    }
    result
}

/// Splits a large connected block into blocks that are solved in sequence: each uses the unknowns
/// of earlier blocks. Returns pairs (row indices, column indices).
///
/// Each row is matched with an unknown. The blocks are the strongly connected components of the
/// graph of rows. A. L. Dulmage & N. S. Mendelsohn, Canadian Journal of Mathematics 10 (1958)
/// 517-534.
fn block_triangular_parts(a: &[Vec<Expr>], rows: Vec<usize>, columns: Vec<usize>) -> Vec<(Vec<usize>, Vec<usize>)> {
    if rows.len() <= LARGEST || rows.len() != columns.len() {
        return vec![(rows, columns)];
    }
    let n = rows.len();
    let is_there = |row: usize, column: usize| a[rows[row]][columns[column]] != Expr::ZERO;
    let mut pairs = UnGraph::<(), ()>::with_capacity(2 * n, n * n);
    let nodes: Vec<_> = (0..2 * n).map(|_| pairs.add_node(())).collect();
    for (row, column) in (0..n).flat_map(|row| (0..n).map(move |column| (row, column))) {
        if is_there(row, column) {
            pairs.add_edge(nodes[row], nodes[n + column], ());
        }
    }
    let matching = maximum_matching(&pairs);
    let own: Option<Vec<usize>> = (0..n).map(|row| Some(matching.mate(nodes[row])?.index() - n)).collect();
    // A matrix of full rank has a matching of all rows.
    let Some(own) = own else { return vec![(rows, columns)] };
    let mut needs = DiGraph::<(), ()>::with_capacity(n, n * n);
    let nodes: Vec<_> = (0..n).map(|_| needs.add_node(())).collect();
    for (row, other) in (0..n).flat_map(|row| (0..n).map(move |other| (row, other))) {
        if row != other && is_there(row, own[other]) {
            needs.add_edge(nodes[row], nodes[other], ());
        }
    }
    // The algorithm lists a component after all components that it depends on.
    let parts = tarjan_scc(&needs).into_iter().map(|part| {
        let mut part_rows: Vec<usize> = part.iter().map(|node| rows[node.index()]).collect();
        let mut part_columns: Vec<usize> = part.iter().map(|node| columns[own[node.index()]]).collect();
        part_rows.sort_unstable();
        part_columns.sort_unstable();
        (part_rows, part_columns)
    });
    parts.collect()
}

/// Right-hand side of a row of A x = b for the unknowns in `columns`. The values `x` of all other
/// unknowns are inserted and moved to this side.
fn right_side(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    row: &[Expr],
    right: Expr,
    x: &[Expr],
    columns: &[usize],
) -> Expr {
    let known = row.iter().zip(x).enumerate().filter(|(at, (entry, _))| **entry != Expr::ZERO && !columns.contains(at));
    let known: Vec<(Expr, Expr)> = known.map(|(_, (entry, value))| (*entry, *value)).collect();
    if known.is_empty() {
        return right;
    }
    let mut terms = vec![right];
    for (entry, value) in known {
        let share = arena.mul(entry, value);
        terms.push(arena.neg(share));
    }
    let sum = arena.sum(&terms);
    simplifier.simplify(arena, sum)
}

/// Solves A x = b by cofactors, x = adj(A) b / det A. Returns x, and the determinant as the only
/// divisor.
fn solve_block_by_cofactors(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Expr],
    labels: Option<&BlockLabels<'_>>,
) -> (Vec<Expr>, Vec<Expr>) {
    let n = a.len();
    let all: Vec<usize> = (0..n).collect();
    let mut minors = Minors::new(a, labels.map(|labels| (labels, all.as_slice())));
    let determinant = minors.minor(arena, simplifier, &all, &all);
    let mut x = Vec::with_capacity(n);
    for column in 0..n {
        let mut terms = Vec::with_capacity(n);
        for (row, right) in b.iter().enumerate() {
            let rows: Vec<usize> = all.iter().copied().filter(|r| *r != row).collect();
            let columns: Vec<usize> = all.iter().copied().filter(|c| *c != column).collect();
            let cofactor = minors.minor(arena, simplifier, &rows, &columns);
            let signed = if (row + column) % 2 == 0 { cofactor } else { arena.neg(cofactor) };
            // Each quotient is simplified by itself: a cofactor often cancels with the determinant,
            // which their sum would hide.
            let factor = arena.div(signed, determinant).expect("the rank is full, so the determinant is not 0");
            let factor = simplifier.simplify(arena, factor);
            terms.push(arena.mul(factor, *right));
        }
        let sum = arena.sum(&terms);
        x.push(simplifier.simplify(arena, sum));
    }
    (x, vec![determinant])
}
