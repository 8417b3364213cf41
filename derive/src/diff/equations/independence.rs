//! Proof in numbers that a row is no combination of other rows: at one permitted state it is independent of them.

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::value::evaluate::Tape;
use crate::algebra::value::field::Generator;
use crate::algebra::{Arena, Expr};
use crate::diff::repairs::drawn;

/// Largest part of a row that rounding may leave where a row is a combination of the others.
const ROUNDED_OFF: f64 = 1e-6;
/// Number of states that are drawn until rows have values at one.
const DRAWN: usize = 200;

/// True if the last row is independent of the others at a permitted state, by far more than rounding makes.
pub fn is_independent(arena: &mut Arena, comparer: &mut Comparer, rows: &[Vec<Expr>]) -> bool {
    let entries = rows.concat();
    let mut outputs: Vec<Expr> = entries.into_iter().map(|e| comparer.permitted().put(arena, e)).collect();
    let conditions = outputs.len();
    outputs.extend(comparer.permitted().free_conditions());
    let free: Vec<Expr> = arena.reachable(&outputs).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect();
    let Ok(tape) = Tape::new(arena, &free, &outputs) else { return false };
    let mut generator = Generator(1 + free.len() as u64);
    let width = rows[0].len();
    for _ in 0..DRAWN {
        let inputs: Vec<f64> = free.iter().map(|symbol| drawn(&mut generator, arena, *symbol)).collect();
        let values = tape.evaluate(&inputs);
        let is_permitted = values[conditions..].iter().all(|x| *x > 0.0);
        if values[..conditions].iter().all(|x| x.is_finite())
            && is_permitted
            && let Some(left) = remainder(values[..conditions].chunks(width))
        {
            return left > ROUNDED_OFF;
        }
    }
    false
}

/// Part of the last row that is left beside the space of the rows before it, relative to the row. Each row is made
/// perpendicular to those before it, twice, so that little rounding is left. `None` if the rows before it are nearly
/// dependent.
fn remainder<'a>(rows: impl Iterator<Item = &'a [f64]>) -> Option<f64> {
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
