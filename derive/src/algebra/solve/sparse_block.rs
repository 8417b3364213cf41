//! A large sparse block of a linear system, solved with few operations.
//!
//! Rows and columns with few entries are eliminated first. What remains is small and full. It is solved by
//! determinants, so that it divides by nothing that vanishes where the block is regular.
//!
//! Sources: H. M. Markowitz, Management Science 3 (1957) 255–269 (order of pivots); P. S. Laplace (1772) (expansion of
//! a determinant along several rows).

use super::linear::Singular;
use super::minors::Minors;
use super::pivot_values::PivotValues;
use super::system_labels::BlockLabels;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};

/// Largest number of rows that are solved by determinants.
const LARGEST_FULL: usize = 6;

/// Block of a linear system during elimination.
pub struct SparseBlock<'a> {
    /// Rows of the matrix, each with its right-hand side as the last entry.
    rows: Vec<Vec<Expr>>,
    /// Pivots taken so far, as (row, column).
    order: Vec<(usize, usize)>,
    /// Names for long entries.
    labels: &'a BlockLabels<'a>,
    /// Point at which pivots are not small; `None` if no values are known.
    point: Option<&'a PivotValues>,
}

impl<'a> SparseBlock<'a> {
    /// Creates the block of the system A x = b, with A given by rows.
    pub fn new(a: &[Vec<Expr>], b: &[Expr], labels: &'a BlockLabels<'a>, point: Option<&'a PivotValues>) -> Self {
        let rows = a.iter().zip(b).map(|(row, right)| [row.as_slice(), &[*right]].concat()).collect();
        Self { rows, order: Vec::new(), labels, point }
    }

    /// Solves the block. Returns the unknowns and the divisors.
    ///
    /// # Errors
    /// [`Singular`] if the matrix is singular for all values of its symbols.
    pub fn solve(mut self, arena: &mut Arena, simplifier: &mut Simplifier) -> Result<(Vec<Expr>, Vec<Expr>), Singular> {
        let n = self.rows.len();
        let mut divisors = Vec::new();
        while let Some((row, column)) = self.next_pivot(arena) {
            if !range_excludes_zero(arena, self.rows[row][column]) {
                divisors.push(self.rows[row][column]);
            }
            self.eliminate(arena, simplifier, row, column);
        }
        let (rows, columns) = (self.rows_left(), self.columns_left());
        if rows.len() > LARGEST_FULL {
            return Err(Singular { rank: self.order.len(), row: rows[0] });
        }
        let mut x = vec![Expr::ZERO; n];
        if !rows.is_empty() {
            let columns: Vec<usize> = columns.into_iter().chain([n]).collect();
            let part: Vec<Vec<Expr>> =
                rows.iter().map(|r| columns.iter().map(|c| self.rows[*r][*c]).collect()).collect();
            let mut full = Minors::new(&part, Some((self.labels, &rows)));
            let determinant = full.determinant_without(arena, simplifier, part.len());
            if zero_test(arena, determinant) == ZeroTest::Zero {
                return Err(Singular { rank: self.order.len(), row: rows[0] });
            }
            for (at, column) in columns[..part.len()].iter().enumerate() {
                let numerator = full.determinant_without(arena, simplifier, at);
                let signed = if (part.len() - 1 - at).is_multiple_of(2) { numerator } else { arena.neg(numerator) };
                let quotient = arena.div(signed, determinant).expect("the determinant is not zero");
                x[*column] = self.labels.name_unknown(arena, *column, quotient);
            }
            divisors.push(determinant);
        }
        for (row, column) in self.order.iter().rev() {
            let mut terms = vec![self.rows[*row][n]];
            for (other, entry) in self.rows[*row][..n].iter().enumerate() {
                if other != *column && *entry != Expr::ZERO {
                    let share = arena.mul(*entry, x[other]);
                    terms.push(arena.neg(share));
                }
            }
            let sum = arena.sum(&terms);
            let value = arena.div(sum, self.rows[*row][*column]).expect("a pivot is not zero");
            let value = simplifier.simplify(arena, value);
            x[*column] = self.labels.name_unknown(arena, *column, value);
        }
        Ok((x, divisors))
    }

    /// Indices of the rows without a pivot.
    fn rows_left(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|r| !self.order.iter().any(|(row, _)| row == r)).collect()
    }

    /// Indices of the columns without a pivot.
    fn columns_left(&self) -> Vec<usize> {
        (0..self.rows.len()).filter(|c| !self.order.iter().any(|(_, column)| column == c)).collect()
    }

    /// Row and column of the next pivot: the entry that creates the fewest entries, and the shortest of these. While
    /// the rest is small, only entries that are proved never to be zero are pivots. `None` if no entry is left.
    fn next_pivot(&self, arena: &Arena) -> Option<(usize, usize)> {
        let (rows, columns) = (self.rows_left(), self.columns_left());
        let count_row = |r: usize| columns.iter().filter(|c| self.rows[r][**c] != Expr::ZERO).count();
        let count_column = |c: usize| rows.iter().filter(|r| self.rows[**r][c] != Expr::ZERO).count();
        let by_row: Vec<usize> = rows.iter().map(|r| count_row(*r)).collect();
        let by_column: Vec<usize> = columns.iter().map(|c| count_column(*c)).collect();
        let large = self.point.map(|point| point.large_entries(arena, &self.rows, &columns));
        let is_small = rows.len() <= LARGEST_FULL;
        let mut candidates = Vec::new();
        for (r, in_row) in rows.iter().zip(&by_row) {
            for (c, in_column) in columns.iter().zip(&by_column) {
                let entry = self.rows[*r][*c];
                if entry != Expr::ZERO {
                    let fill = (in_row - 1) * (in_column - 1);
                    candidates.push((fill, arena.reachable(&[entry]).len(), *r, *c));
                }
            }
        }
        candidates.sort_unstable();
        let is_pivot = |(_, _, r, c): &&(usize, usize, usize, usize)| {
            let entry = self.rows[*r][*c];
            range_excludes_zero(arena, entry)
                || !is_small
                    && large.as_ref().is_none_or(|large| large[*r][*c])
                    && zero_test(arena, entry) == ZeroTest::NonZero
        };
        candidates.iter().find(is_pivot).map(|(_, _, r, c)| (*r, *c))
    }

    /// Eliminates the unknown `column` from all rows without a pivot, by the row `row`.
    fn eliminate(&mut self, arena: &mut Arena, simplifier: &mut Simplifier, row: usize, column: usize) {
        self.order.push((row, column));
        let pivot_row = self.rows[row].clone();
        for other in self.rows_left() {
            let factor = self.rows[other][column];
            if factor == Expr::ZERO {
                continue;
            }
            let factor = arena.div(factor, pivot_row[column]).expect("a pivot is not zero");
            let factor = simplifier.simplify(arena, factor);
            let factor = self.labels.name_minor(arena, factor, &[other]);
            for (at, p) in pivot_row.iter().enumerate().filter(|(_, p)| **p != Expr::ZERO) {
                if at == column {
                    self.rows[other][at] = Expr::ZERO;
                    continue;
                }
                let share = arena.mul(factor, *p);
                let difference = arena.sub(self.rows[other][at], share);
                let difference = simplifier.simplify(arena, difference);
                self.rows[other][at] = self.labels.name_minor(arena, difference, &[other]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::system_labels::SystemLabels;
    use super::*;

    /// The unknowns of blocks with five to twelve rows fulfil every equation, as a zero test proves.
    #[test]
    fn sparse_blocks_are_solved() {
        for n in 5..=12_usize {
            let (mut arena, mut simplifier) = (Arena::new(), Simplifier::default());
            let mut a = vec![vec![Expr::ZERO; n]; n];
            for (r, row) in a.iter_mut().enumerate() {
                for (c, entry) in row.iter_mut().enumerate() {
                    if r == c || (r * 5 + c * 3) % 7 == 0 || c + 1 == n {
                        *entry = arena.symbol(&format!("a{r}_{c}"));
                    }
                }
            }
            let b: Vec<Expr> = (0..n).map(|r| arena.symbol(&format!("b{r}"))).collect();
            let names = |letter: &str| (0..n).map(|at| format!("{letter}{at}")).collect();
            let labels = SystemLabels { rows: names("row"), unknowns: names("x"), symbols: Vec::new() };
            let all: Vec<usize> = (0..n).collect();
            let labels = labels.of_block(&arena, &a, &all, &all).unwrap();
            let (x, divisors) = SparseBlock::new(&a, &b, &labels, None).solve(&mut arena, &mut simplifier).unwrap();
            assert!(!divisors.is_empty());
            for (row, right) in a.iter().zip(&b) {
                let mut terms: Vec<Expr> = row.iter().zip(&x).map(|(entry, x)| arena.mul(*entry, *x)).collect();
                terms.push(arena.neg(*right));
                let excess = arena.sum(&terms);
                assert_eq!(zero_test(&arena, excess), ZeroTest::Zero, "{n} rows");
            }
        }
    }

    /// A block whose rows depend on one another is refused, not divided by zero.
    #[test]
    fn singular_blocks_are_refused() {
        let (mut arena, mut simplifier) = (Arena::new(), Simplifier::default());
        let row: Vec<Expr> = (0..5).map(|c| arena.symbol(&format!("a{c}"))).collect();
        let (a, b) = (vec![row; 5], vec![Expr::ONE; 5]);
        let names = |letter: &str| (0..5).map(|at| format!("{letter}{at}")).collect();
        let labels = SystemLabels { rows: names("row"), unknowns: names("x"), symbols: Vec::new() };
        let all: Vec<usize> = (0..5).collect();
        let labels = labels.of_block(&arena, &a, &all, &all).unwrap();
        assert!(SparseBlock::new(&a, &b, &labels, None).solve(&mut arena, &mut simplifier).is_err());
    }
}
