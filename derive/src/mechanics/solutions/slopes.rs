//! Slopes of what equations compute: of q̇ and v̇ along the parameters of a model, and of outputs.

use super::certificate::certify_slopes;
use super::jacobian::{Jacobian, slopes_along};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::elimination::Elimination;
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr};
use crate::mechanics::equations::Equations;
use crate::mechanics::unsolved::Unproved;

/// Slopes ∂(q̇, v̇)/∂p along the parameters p, exactly, by the chain rule over the steps of an elimination, and proved.
/// `None` if they would be too long.
///
/// # Errors
/// [`Unproved::Jacobian`] with the first row that is not the derivative of q̇ or v̇.
pub fn parameter_jacobian(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
    solved: &Elimination,
    parameters: &[Expr],
) -> Result<Option<Jacobian>, Unproved> {
    let n = equations.variables.len();
    let rates = [&equations.coordinate_rates, &equations.unknowns[..n]].concat();
    slopes(arena, simplifier, &solved.steps, &rates, parameters)
}

/// Slopes of values that steps compute, exactly and proved, with a row for each value and a column for each of the
/// symbols `along`. `None` if they would be too long.
///
/// # Errors
/// [`Unproved::Jacobian`] with the first value whose slopes are not its derivatives.
pub fn slopes(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    steps: &[Definition],
    values: &[Expr],
    along: &[Expr],
) -> Result<Option<Jacobian>, Unproved> {
    let slopes = slopes_along(arena, simplifier, steps, values, along);
    if let Some(slopes) = &slopes {
        certify_slopes(arena, steps, values, slopes, along)?;
    }
    Ok(slopes)
}
