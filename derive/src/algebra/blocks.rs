//! Linear systems solved block by block, dividing by nothing but the determinant of each block.
//!
//! Elimination divides by pivots that may vanish where the system is regular: a rotation matrix has
//! determinant 1 and entries that vanish everywhere in turn. A small block is therefore solved by its
//! cofactors, and its determinant simplified before it divides. Apart from `elimination`, which is for systems whose
//! pivots are known not to vanish, and shares what it computes.

use super::linear::{Singular, solve};
use super::rank::rank;
use super::simplify::Simplifier;
use super::{Arena, Expr};

/// The largest block that is solved by cofactors; larger ones are eliminated.
const LARGEST: usize = 4;

/// Solves A x = b, A square; returns x and what was divided by.
///
/// # Errors
/// [`Singular`] if A is singular identically.
pub fn solve_blocks(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Expr],
) -> Result<(Vec<Expr>, Vec<Expr>), Singular> {
    if let Some(found) = rank(arena, a)
        && let Some(row) = found.dependent
    {
        return Err(Singular { rank: found.rank, row });
    }
    let mut x = vec![Expr::ZERO; a.len()];
    let mut divisors = Vec::new();
    for (rows, columns) in blocks(a) {
        let block: Vec<Vec<Expr>> = rows.iter().map(|r| columns.iter().map(|c| a[*r][*c]).collect()).collect();
        let right: Vec<Expr> = rows.iter().map(|r| b[*r]).collect();
        let (solution, by) = if rows.len() <= LARGEST && rows.len() == columns.len() {
            by_cofactors(arena, simplifier, &block, &right)
        } else {
            let right: Vec<Vec<Expr>> = right.into_iter().map(|e| vec![e]).collect();
            let (solution, pivots) = solve(arena, simplifier, &block, &right)?;
            (solution.into_iter().map(|row| row[0]).collect(), pivots)
        };
        for (column, value) in columns.iter().zip(solution) {
            x[*column] = value;
        }
        divisors.extend(by);
    }
    Ok((x, divisors))
}

/// The connected blocks of a matrix: rows and columns that share entries which are not 0.
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

/// x = adj(A) b / det A.
fn by_cofactors(arena: &mut Arena, simplifier: &mut Simplifier, a: &[Vec<Expr>], b: &[Expr]) -> (Vec<Expr>, Vec<Expr>) {
    let n = a.len();
    let all: Vec<usize> = (0..n).collect();
    let determinant = minor(arena, simplifier, a, &all, &all);
    let mut x = Vec::with_capacity(n);
    for column in 0..n {
        let mut terms = Vec::with_capacity(n);
        for (row, right) in b.iter().enumerate() {
            let rows: Vec<usize> = all.iter().copied().filter(|r| *r != row).collect();
            let columns: Vec<usize> = all.iter().copied().filter(|c| *c != column).collect();
            let cofactor = minor(arena, simplifier, a, &rows, &columns);
            let signed = if (row + column) % 2 == 0 { cofactor } else { arena.neg(cofactor) };
            // Each quotient for itself: a cofactor often cancels the determinant where their sum hides it.
            let factor = arena.div(signed, determinant).expect("the rank is full, so the determinant is not 0");
            let factor = simplifier.simplify(arena, factor);
            terms.push(arena.mul(factor, *right));
        }
        let sum = arena.sum(&terms);
        x.push(simplifier.simplify(arena, sum));
    }
    (x, vec![determinant])
}

/// The determinant of the chosen rows and columns, by expansion along the first row.
fn minor(arena: &mut Arena, simplifier: &mut Simplifier, a: &[Vec<Expr>], rows: &[usize], columns: &[usize]) -> Expr {
    let Some((first, rest)) = rows.split_first() else { return Expr::ONE };
    let mut terms = Vec::new();
    for (at, column) in columns.iter().enumerate() {
        let entry = a[*first][*column];
        if entry == Expr::ZERO {
            continue;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|c| c != column).collect();
        let below = minor(arena, simplifier, a, rest, &others);
        let product = arena.mul(entry, below);
        terms.push(if at % 2 == 0 { product } else { arena.neg(product) });
    }
    let sum = arena.sum(&terms);
    simplifier.simplify(arena, sum)
}
