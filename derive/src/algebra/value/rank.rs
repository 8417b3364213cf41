//! Rank of a matrix for general values of its symbols, by elimination modulo random primes at
//! random points. The module also solves linear systems modulo a prime.
//!
//! The rank at a random point is never above the true rank. It is below the true rank only with the
//! probability of a false zero. Nothing is eliminated symbolically.

use super::field::Field;
use super::residues::{ResidueSampler, residues};
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashSet;

/// Rank of a matrix, with the first row that depends on earlier rows.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Rank {
    /// Rank: the number of independent rows.
    pub rank: usize,
    /// Index of the first row that depends on the rows before it; `None` if all rows are
    /// independent.
    pub dependent: Option<usize>,
}

/// Rank of a matrix of terms, given by rows, for general values of the symbols.
///
/// The matrix is evaluated at up to four random points, and the largest rank is returned. It is
/// never above the true rank. It is below the true rank only if a non-zero minor is 0 at all points
/// by chance. `None` if no point could be evaluated.
#[must_use]
pub fn rank(arena: &Arena, matrix: &[Vec<Expr>]) -> Option<Rank> {
    let mut best: Option<Rank> = None;
    for (field, rows) in residue_matrices(arena, matrix) {
        let (basis, dependent) = eliminate_residues(field, rows);
        best = best.max(Some(Rank { rank: basis.len(), dependent }));
        // No point can show a rank above full rank, so the search ends.
        if dependent.is_none() {
            break;
        }
    }
    best
}

/// Largest set of independent rows of a matrix: their row indices, and the pivot column of each.
/// The set contains each row that does not depend on earlier rows. `None` if no point could be
/// evaluated.
#[must_use]
pub fn pivot_rows_and_columns(arena: &Arena, matrix: &[Vec<Expr>]) -> Option<(Vec<usize>, Vec<usize>)> {
    let mut best: Option<Vec<(usize, usize)>> = None;
    for (field, rows) in residue_matrices(arena, matrix) {
        let (basis, _) = eliminate_residues(field, rows);
        if best.as_ref().is_none_or(|known| known.len() < basis.len()) {
            best = Some(basis);
        }
    }
    best.map(|basis| basis.into_iter().unzip())
}

/// Row indices of a largest set of independent rows: of each row that does not depend on earlier
/// rows. `None` if no point could be evaluated.
#[must_use]
pub fn independent_rows(arena: &Arena, matrix: &[Vec<Expr>]) -> Option<Vec<usize>> {
    pivot_rows_and_columns(arena, matrix).map(|(rows, _)| rows)
}

/// True if `row` is a linear combination of the independent `rows` with coefficients that do not
/// depend on the symbols `moving`. The row then depends on them in every configuration. False
/// otherwise, or if no random point could be evaluated.
#[must_use]
pub(crate) fn keeps_rank_everywhere(arena: &Arena, rows: &[Vec<Expr>], row: &[Expr], moving: &FxHashSet<Expr>) -> bool {
    let all: Vec<Expr> = rows.iter().flatten().chain(row).copied().collect();
    let mut sampler = ResidueSampler::new(arena, all);
    for _ in 0..DRAWS {
        let (field, seed) = (sampler.field(), sampler.seed());
        let places = [sampler.seed(), sampler.seed()];
        let shares = places.map(|place| {
            let values = sampler.at(field, seed, &[(moving, place)])?;
            Some(row_combination(field, &values, rows.len(), row.len()))
        });
        if let [Some(here), Some(there)] = shares {
            return here.is_some() && here == there;
        }
    }
    false
}

/// Largest number of random prime fields that are tried in the search for a point at which all
/// entries of a matrix have values.
const DRAWS: usize = 40;

/// Coefficients of the linear combination of the first `count` rows that equals the next row,
/// modulo a prime. `values` holds all rows, each of length `width`, one after the other. `None` if
/// the next row is no such combination, or if the first rows are dependent.
fn row_combination(field: Field, values: &[u64], count: usize, width: usize) -> Option<Vec<u64>> {
    let mut basis = Basis::new(field);
    // Each row is extended by its own unit vector. So the remainder of the last row shows which
    // multiple of each row was subtracted.
    let tagged = |at: usize| {
        let own = (0..count).map(|other| u64::from(other == at));
        values[at * width..(at + 1) * width].iter().copied().chain(own).collect::<Vec<u64>>()
    };
    for at in 0..count {
        basis.add_row(tagged(at))?;
    }
    let left = basis.reduce(tagged(count));
    left[..width].iter().all(|x| *x == 0).then(|| left[width..].to_vec())
}

/// Residues of a matrix at four random points, each modulo another prime, as (field, rows). Each
/// point is computed only when the iterator reaches it.
pub(crate) fn residue_matrices<'a>(
    arena: &'a Arena,
    matrix: &'a [Vec<Expr>],
) -> impl Iterator<Item = (Field, Vec<Vec<u64>>)> + 'a {
    let rows = |values: Vec<u64>| {
        let mut values = values.into_iter();
        matrix.iter().map(|row| values.by_ref().take(row.len()).collect()).collect()
    };
    residues(arena, matrix.concat(), 4).map(move |(field, values)| (field, rows(values)))
}

/// Basis of a row space modulo a prime: independent rows, each with 0 in the pivot columns of the
/// rows before it.
pub(crate) struct Basis {
    /// Prime field of the entries of the rows.
    field: Field,
    /// Rows of the basis, as pairs (pivot column, row with the entry 1 in that column).
    rows: Vec<(usize, Vec<u64>)>,
}

impl Basis {
    /// Creates an empty basis over a prime field.
    pub fn new(field: Field) -> Self {
        Self { field, rows: Vec::new() }
    }

    /// Number of rows of the basis: the rank so far.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Basis of the null space: independent vectors x of the given length, with row · x = 0 for
    /// each row of this basis.
    pub fn null_space(&self, length: usize) -> Vec<Vec<u64>> {
        let f = self.field;
        // First, each row gets 0 in the pivot columns of all other rows.
        let mut rows = self.rows.clone();
        for at in 0..rows.len() {
            let (column, row) = rows[at].clone();
            for (_, other) in rows.iter_mut().enumerate().filter(|(k, _)| *k != at).map(|(_, entry)| entry) {
                let factor = other[column];
                for (entry, x) in other.iter_mut().zip(&row) {
                    *entry = f.sub(*entry, f.mul(factor, *x));
                }
            }
        }
        let is_pivot = |column: &usize| rows.iter().any(|(pivot, _)| pivot == column);
        let vector = |open: usize| {
            let mut vector = vec![0; length];
            vector[open] = 1;
            for (pivot, row) in &rows {
                vector[*pivot] = f.sub(0, row[open]);
            }
            vector
        };
        (0..length).filter(|column| !is_pivot(column)).map(vector).collect()
    }

    /// Remainder of a row after multiples of the basis rows are subtracted. Its entries in the
    /// pivot columns of the basis are 0.
    fn reduce(&self, mut row: Vec<u64>) -> Vec<u64> {
        let f = self.field;
        for (column, known) in &self.rows {
            let factor = row[*column];
            if factor == 0 {
                continue;
            }
            for (entry, x) in row.iter_mut().zip(known) {
                *entry = f.sub(*entry, f.mul(factor, *x));
            }
        }
        row
    }

    /// Adds a row to the basis if it is independent of the basis, and returns its pivot column.
    /// `None` if the row is dependent; the basis then stays unchanged.
    pub fn add_row(&mut self, row: Vec<u64>) -> Option<usize> {
        let f = self.field;
        let mut row = self.reduce(row);
        let column = row.iter().position(|x| *x != 0)?;
        let inverse = f.inverse(row[column]).unwrap_or(1);
        for x in &mut row {
            *x = f.mul(*x, inverse);
        }
        self.rows.push((column, row));
        Some(column)
    }
}

/// Eliminates a matrix over the field `f`. Returns the independent rows as pairs (row index, pivot
/// column), and the index of the first row that depends on earlier rows. This index is `None` if
/// all rows are independent.
fn eliminate_residues(f: Field, rows: Vec<Vec<u64>>) -> (Vec<(usize, usize)>, Option<usize>) {
    let (mut basis, mut independent, mut dependent) = (Basis::new(f), Vec::new(), None);
    for (at, row) in rows.into_iter().enumerate() {
        match basis.add_row(row) {
            Some(column) => independent.push((at, column)),
            None => dependent = dependent.or(Some(at)),
        }
    }
    (independent, dependent)
}

/// Brings a matrix over the field `f` to reduced echelon form and removes its zero rows. Returns
/// the pivot columns, which are the first independent columns.
pub(crate) fn reduced_echelon_form(f: Field, rows: &mut Vec<Vec<u64>>) -> Vec<usize> {
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let at = pivots.len();
        let Some(found) = (at..rows.len()).find(|row| rows[*row][column] != 0) else { continue };
        rows.swap(at, found);
        let inverse = f.inverse(rows[at][column]).unwrap_or(1);
        rows[at].iter_mut().for_each(|x| *x = f.mul(*x, inverse));
        let pivot = std::mem::take(&mut rows[at]);
        for row in rows.iter_mut().filter(|row| !row.is_empty()) {
            let factor = row[column];
            if factor != 0 {
                row.iter_mut().zip(&pivot).skip(column).for_each(|(x, p)| *x = f.sub(*x, f.mul(factor, *p)));
            }
        }
        rows[at] = pivot;
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    pivots
}

/// Unique solution x of a linear system over the field `f`. Each row of the matrix is an equation:
/// its last entry is the right-hand side, the others are coefficients of x. `None` if there is no
/// solution, or more than one.
#[must_use]
pub(crate) fn unique_solution(f: Field, mut rows: Vec<Vec<u64>>) -> Option<Vec<u64>> {
    let unknowns = rows.first()?.len() - 1;
    let pivots = reduced_echelon_form(f, &mut rows);
    pivots.iter().copied().eq(0..unknowns).then(|| rows.iter().map(|row| row[unknowns]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::value::field::Generator;

    #[test]
    fn rank_sees_dependence_that_no_entry_shows() {
        let mut arena = Arena::new();
        let mut matrix = |texts: [[&str; 2]; 2]| {
            let rows = texts.map(|row| row.map(|t| parse_free(&mut arena, t).unwrap()).to_vec()).to_vec();
            rank(&arena, &rows).unwrap()
        };
        assert_eq!(matrix([["m", "m"], ["m", "m"]]), Rank { rank: 1, dependent: Some(1) });
        let hidden = [["sin(q)", "1"], ["1 - cos(q)^2", "sin(q)"]];
        assert_eq!(matrix(hidden), Rank { rank: 1, dependent: Some(1) });
        assert_eq!(matrix([["0", "1"], ["m", "0"]]), Rank { rank: 2, dependent: None });
    }

    #[test]
    fn systems_are_solved_where_they_have_one_solution() {
        let f = Field::random(&mut Generator(6));
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![1, 2, 8], vec![2, 3, 13]]), Some(vec![2, 3]));
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![1, 2, 8], vec![2, 3, 14]]), None);
        assert_eq!(unique_solution(f, vec![vec![1, 1, 5], vec![2, 2, 10], vec![3, 3, 15]]), None);
    }
}
