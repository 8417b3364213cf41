//! Jacobian of q̇ and v̇ along the parameters of a model.

use super::certificate::certify_parameter_jacobian;
use super::jacobian::{Jacobian, slopes_along};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::elimination::Elimination;
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
    let slopes = slopes_along(arena, simplifier, equations, solved, parameters);
    if let Some(slopes) = &slopes {
        certify_parameter_jacobian(arena, equations, solved, slopes, parameters)?;
    }
    Ok(slopes)
}
