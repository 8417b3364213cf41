//! Right-hand side that can multiply its transposed Jacobians by a vector. The adjoint of a run needs the products for
//! gradients.

use crate::error::Failure;
use crate::right_hand_side::RightHandSide;

/// Two vectors to which transposed products Jᵀ w are added: (f_yᵀ w, f_pᵀ w). The first has an entry
/// for each component of the state, the second an entry for each parameter.
pub type ProductSums<'a> = (&'a mut [f64], &'a mut [f64]);

/// Right-hand side f(t, y, p) that can multiply its transposed Jacobians f_yᵀ and f_pᵀ by a vector. The
/// adjoint of a run, which gives gradients by the parameters p, needs them.
pub trait TransposedRightHandSide: RightHandSide<f64> {
    /// Number of parameters p of the right-hand side f(t, y, p).
    fn parameter_count(&self) -> usize;

    /// Adds f_yᵀ w to the first and f_pᵀ w to the second vector of `to`. The Jacobians are taken at (t, y);
    /// w are `weights`, one for each component of f.
    ///
    /// # Errors
    /// [`Failure`] if the Jacobians have no value at (t, y).
    fn add_transposed_product(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure>;

    /// Adds φ_yᵀ w to the first and φ_pᵀ w to the second vector of `to`. The Jacobians of the constraints
    /// φ(t, y, p) are taken at (t, y); w are `weights`, one for each constraint.
    ///
    /// # Errors
    /// [`Failure`] if the Jacobians have no value at (t, y).
    fn add_transposed_constraint_product(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        let _ = (t, y, weights, to);
        Ok(())
    }
}
