//! Follows a steady motion over a grid of two varied numbers.

use super::SteadyProblem;
use super::continuation::{Continuation, continue_prepared};
use crate::{Error, Mechanism};
use tripos_derive::scene::StateWithUnknowns;

/// Steady motion over two varied numbers. It is followed along the first number for each value of the
/// second number.
#[derive(Clone, Debug)]
pub struct ContinuationMap {
    /// Values of the second number, each with the motion along the first number, or the reason why no
    /// motion is found.
    pub rows: Vec<(f64, Result<Continuation, Error>)>,
}

/// Follows a steady motion over values of a first number of the state file, for each value of a
/// second number. `asked` reads the state file with values of both numbers.
///
/// # Errors
/// `Error` if no value of the second number has a steady motion at the first value of the first number.
pub fn continuation_map(
    model: &Mechanism,
    asked: &mut dyn FnMut(f64, f64) -> Result<StateWithUnknowns, Error>,
    first: &[f64],
    second: &[f64],
) -> Result<ContinuationMap, Error> {
    let mut rows = Vec::with_capacity(second.len());
    let (Some(start), Some(row)) = (first.first(), second.first()) else { return Ok(ContinuationMap { rows }) };
    let mut question = SteadyProblem::new(model, &asked(*start, *row)?, &[])?;
    let mut refused = None;
    for value in second {
        let course = continue_prepared(model, &mut question, &mut |at| asked(at, *value), first);
        if let Err(error) = &course {
            refused.get_or_insert_with(|| error.clone());
        }
        rows.push((*value, course));
    }
    match refused {
        Some(error) if rows.iter().all(|(_, course)| course.is_err()) => Err(error),
        _ => Ok(ContinuationMap { rows }),
    }
}
