//! Values of a matrix's entries at one point, by which an elimination avoids small pivots.

use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};

/// Part of the largest entry of its row below which an entry is no pivot, as in sparse elimination with threshold
/// pivoting (I. S. Duff, A. M. Erisman & J. K. Reid, Direct Methods for Sparse Matrices, 2017, §5.2).
const THRESHOLD: f64 = 0.1;

/// Point at which entries are evaluated: symbols with their values.
#[derive(Clone, Debug)]
pub struct PivotValues {
    /// Symbols of the entries.
    symbols: Vec<Expr>,
    /// Values of the symbols.
    values: Vec<f64>,
}

impl PivotValues {
    /// Creates a point from symbols with their values.
    #[must_use]
    pub fn new(known: impl IntoIterator<Item = (Expr, f64)>) -> Self {
        let (symbols, values) = known.into_iter().unzip();
        Self { symbols, values }
    }

    /// True for each entry of a matrix, given by rows, that is large enough beside the entries of its row in the given
    /// columns. True for all entries if a value is not known or not finite.
    #[must_use]
    pub fn large_entries(&self, arena: &Arena, rows: &[Vec<Expr>], columns: &[usize]) -> Vec<Vec<bool>> {
        let all = || rows.iter().map(|row| vec![true; row.len()]).collect();
        let flat: Vec<Expr> = rows.iter().flat_map(|row| columns.iter().map(|column| row[*column])).collect();
        let Ok(tape) = Tape::new(arena, &self.symbols, &flat) else { return all() };
        let values = tape.evaluate(&self.values);
        if values.iter().any(|value| !value.is_finite()) {
            return all();
        }
        let mut large: Vec<Vec<bool>> = rows.iter().map(|row| vec![false; row.len()]).collect();
        for (row, sizes) in large.iter_mut().zip(values.chunks(columns.len().max(1))) {
            let most = sizes.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            for (column, value) in columns.iter().zip(sizes) {
                row[*column] = value.abs() >= THRESHOLD * most && most > 0.0;
            }
        }
        large
    }
}
