//! Numerical proof that a row is no linear combination of other rows.
//!
//! The row is independent of the others at one permitted state. A permitted state satisfies the
//! model's constraints and its domain.

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::{Arena, Expr};

/// Largest relative remainder that rounding may leave of a row that is a combination of other rows.
const ROUNDED_OFF: f64 = 1e-6;

/// True if the last row is linearly independent of the other rows at a state that the model's constraints permit. The
/// remainder of the row must exceed rounding by far; false proves nothing.
pub fn is_last_row_independent(arena: &mut Arena, comparer: &mut Comparer, rows: &[Vec<Expr>]) -> bool {
    let Some(mut samples) = comparer.permitted().samples(arena, &rows.concat()) else { return false };
    let width = rows[0].len();
    samples.find_map(|values| remainder_of_independent_row(values.chunks(width))).is_some_and(|left| left > ROUNDED_OFF)
}

/// Norm of the last row's component perpendicular to all rows before it, relative to the norm of the last row.
/// Gram–Schmidt runs twice for each row, to keep rounding small. Returns `None` if the earlier rows are nearly
/// dependent.
fn remainder_of_independent_row<'a>(rows: impl Iterator<Item = &'a [f64]>) -> Option<f64> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut left = 1.0;
    for row in rows {
        if left <= ROUNDED_OFF {
            return None;
        }
        let size = norm(row);
        let mut row: Vec<f64> = row.iter().map(|x| x / size).collect();
        for _ in 0..2 {
            for unit in &basis {
                let share: f64 = row.iter().zip(unit).map(|(a, b)| a * b).sum();
                row.iter_mut().zip(unit).for_each(|(a, b)| *a -= share * b);
            }
        }
        left = norm(&row);
        basis.push(row.iter().map(|x| x / left).collect());
    }
    Some(left)
}

fn norm(row: &[f64]) -> f64 {
    row.iter().map(|x| x * x).sum::<f64>().sqrt()
}
