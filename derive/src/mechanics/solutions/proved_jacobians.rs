//! Derivatives with proof: of q̇ and v̇ with respect to the parameters of a model, and of outputs.

use super::certificate::certify_slopes;
use super::jacobian::{Jacobian, jacobian_along_symbols};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::elimination::Elimination;
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr};
use crate::mechanics::equations::Equations;
use crate::mechanics::unsolved::Unproved;

/// Derives and proves the Jacobian ∂(q̇, v̇)/∂p with respect to the parameters p. It is exact, by the chain rule over
/// the solved definitions. `None` if it would be too long.
///
/// # Errors
/// Returns [`Unproved::Jacobian`] with the first row that is not the derivative of q̇ or v̇.
pub fn parameter_jacobian(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
    solved: &Elimination,
    parameters: &[Expr],
) -> Result<Option<Jacobian>, Unproved> {
    let n = equations.variables.len();
    let rates = [&equations.coordinate_rates, &equations.unknowns[..n]].concat();
    proved_jacobian(arena, simplifier, &solved.steps, &rates, parameters)
}

/// Derives and proves the derivatives of `values`, with a row for each value and a column for each of the symbols
/// `along`. The values may contain symbols that `steps` define. `None` if the Jacobian would be too long.
///
/// # Errors
/// Returns [`Unproved::Jacobian`] with the first value whose derivatives are wrong.
pub fn proved_jacobian(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    steps: &[Definition],
    values: &[Expr],
    along: &[Expr],
) -> Result<Option<Jacobian>, Unproved> {
    let slopes = jacobian_along_symbols(arena, simplifier, steps, values, along);
    if let Some(slopes) = &slopes {
        certify_slopes(arena, steps, values, slopes, along)?;
    }
    Ok(slopes)
}
