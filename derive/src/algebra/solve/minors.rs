//! Minors of a matrix: determinants of its submatrices.

use super::system_labels::BlockLabels;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// Minors (determinants of submatrices) of a matrix; each is computed once.
pub struct Minors<'a> {
    /// Matrix whose minors are computed, by rows.
    a: &'a [Vec<Expr>],
    /// Minors computed so far, by their rows and columns.
    known: FxHashMap<(Vec<usize>, Vec<usize>), Expr>,
    /// Names for long minors, with the index in the named block of each row of the matrix. `None` if minors stay
    /// without names.
    labels: Option<(&'a BlockLabels<'a>, &'a [usize])>,
}

impl<'a> Minors<'a> {
    /// Creates the minors of the matrix `a`, given by rows. `labels` names long minors; its list has the index in the
    /// named block of each row.
    pub fn new(a: &'a [Vec<Expr>], labels: Option<(&'a BlockLabels<'a>, &'a [usize])>) -> Self {
        Self { a, known: FxHashMap::default(), labels }
    }

    /// Determinant of the submatrix of the given rows and columns, by expansion along the first row.
    pub fn minor(&mut self, arena: &mut Arena, simplifier: &mut Simplifier, rows: &[usize], columns: &[usize]) -> Expr {
        let Some((first, rest)) = rows.split_first() else { return Expr::ONE };
        if let Some(known) = self.known.get(&(rows.to_vec(), columns.to_vec())) {
            return *known;
        }
        let mut terms = Vec::new();
        for (at, column) in columns.iter().enumerate() {
            let entry = self.a[*first][*column];
            if entry == Expr::ZERO {
                continue;
            }
            let others: Vec<usize> = columns.iter().copied().filter(|c| c != column).collect();
            let below = self.minor(arena, simplifier, rest, &others);
            let product = arena.mul(entry, below);
            terms.push(if at % 2 == 0 { product } else { arena.neg(product) });
        }
        let sum = arena.sum(&terms);
        let determinant = simplifier.simplify(arena, sum);
        let determinant = self.named(arena, determinant, *first);
        self.known.insert((rows.to_vec(), columns.to_vec()), determinant);
        determinant
    }

    /// Determinant of all rows and of all columns except `without`, of a matrix with one column more than rows. The
    /// rows are expanded in two halves, whose minors serve the determinants without every other column too.
    pub fn determinant_without(&mut self, arena: &mut Arena, simplifier: &mut Simplifier, without: usize) -> Expr {
        let n = self.a.len();
        let columns: Vec<usize> = (0..=n).filter(|column| *column != without).collect();
        let rows: Vec<usize> = (0..n).collect();
        let (top, bottom) = rows.split_at(n / 2);
        let mut terms = Vec::new();
        for chosen in 0_usize..1 << n {
            if chosen.count_ones() as usize != top.len() {
                continue;
            }
            let (mut above, mut below, mut swaps) = (Vec::new(), Vec::new(), 0);
            for (place, column) in columns.iter().enumerate() {
                if chosen >> place & 1 == 1 {
                    // The column passes all columns before it that belong to the lower half.
                    swaps += below.len();
                    above.push(*column);
                } else {
                    below.push(*column);
                }
            }
            let first = self.minor(arena, simplifier, top, &above);
            let second = self.minor(arena, simplifier, bottom, &below);
            let product = arena.mul(first, second);
            terms.push(if swaps % 2 == 0 { product } else { arena.neg(product) });
        }
        let sum = arena.sum(&terms);
        let determinant = simplifier.simplify(arena, sum);
        self.named(arena, determinant, 0)
    }

    /// The minor `e` whose first row is `row`, with a name if it is long and minors get names.
    fn named(&self, arena: &mut Arena, e: Expr, row: usize) -> Expr {
        self.labels.map_or(e, |(labels, rows)| labels.name_minor(arena, e, &[rows[row]]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expansion in two halves gives the determinant that the expansion along the first row gives, for every column
    /// left out of matrices of two to six rows.
    #[test]
    fn determinants_by_halves_are_those_by_rows() {
        let (mut arena, mut simplifier) = (Arena::new(), Simplifier::default());
        for n in 2..=6_i64 {
            let entry = |r: i64, c: i64| (r * r * 7 + c * c * c * 5 + r * c * 11 + 3 * r + 2) % 13 - 6;
            let rows: Vec<Vec<Expr>> = (0..n).map(|r| (0..=n).map(|c| arena.integer(entry(r, c))).collect()).collect();
            let all: Vec<usize> = (0..rows.len()).collect();
            let mut minors = Minors::new(&rows, None);
            for without in 0..=rows.len() {
                let columns: Vec<usize> = (0..=rows.len()).filter(|column| *column != without).collect();
                let by_rows = minors.minor(&mut arena, &mut simplifier, &all, &columns);
                let by_halves = minors.determinant_without(&mut arena, &mut simplifier, without);
                assert_eq!(by_halves, by_rows, "{n} rows without column {without}");
                assert_ne!(by_rows, Expr::ZERO, "{n} rows without column {without}: the matrix shows nothing");
            }
        }
    }
}
