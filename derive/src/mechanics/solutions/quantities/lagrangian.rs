//! Derivatives of the Lagrangian L in Lagrange's equations d/dt ∂L/∂q̇ − ∂L/∂q = Q. No constraint
//! is substituted in L.

use super::Quantities;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::mechanics::quantity::{EnergyQuantity, QuantityKind};

impl Quantities<'_> {
    /// Lagrangian L = T − V as a term in q and q̇, J, with no constraint substituted. Returns the reason, as text, if
    /// it cannot be derived.
    fn lagrangian(&mut self) -> Result<Expr, String> {
        let constrained = self.energy(EnergyQuantity::Lagrangian)?;
        Ok(self.before_constraints(&QuantityKind::Energy(EnergyQuantity::Lagrangian), constrained))
    }

    /// Partial derivative of a term with respect to a symbol. All other symbols are held constant.
    fn lagrangian_derivative(&mut self, e: Expr, along: Expr) -> Expr {
        Differential::partial(along).apply(&mut self.derivations.kinematics.arena, e)
    }

    /// Generalized momentum ∂L/∂q̇ of the coordinate with the index `at`, as a term in q and q̇. Returns the reason,
    /// as text, if L cannot be derived.
    pub(super) fn momentum(&mut self, at: usize) -> Result<Expr, String> {
        let lagrangian = self.lagrangian()?;
        Ok(self.lagrangian_derivative(lagrangian, self.model.coordinates[at].rate))
    }

    /// Partial derivative ∂L/∂q with respect to the coordinate with the index `at`. The rates q̇ are held constant.
    /// Returns the reason, as text, if L cannot be derived.
    pub(super) fn lagrangian_slope(&mut self, at: usize) -> Result<Expr, String> {
        let lagrangian = self.lagrangian()?;
        Ok(self.lagrangian_derivative(lagrangian, self.model.coordinates[at].symbol))
    }

    /// Rate d/dt ∂L/∂q̇ of a generalized momentum along the motion, as a term in q, q̇ and q̈. `at` is the index of
    /// the coordinate. Returns the reason, as text, if L cannot be derived.
    pub(super) fn momentum_rate(&mut self, at: usize) -> Result<Expr, String> {
        let momentum = self.momentum(at)?;
        let (model, time) = (self.model, self.model.time());
        let mut moving: Vec<(Expr, Expr)> = Vec::new();
        for (at, c) in model.coordinates.iter().enumerate() {
            if time == Some(at) {
                moving.push((c.symbol, Expr::ONE));
            } else {
                moving.extend([(c.symbol, c.rate), (c.rate, c.second_rate)]);
            }
        }
        Ok(Differential::along(&moving).apply(&mut self.derivations.kinematics.arena, momentum))
    }

    /// Partial derivative ∂/∂t ∂L/∂q̇ of a generalized momentum with respect to time alone. `at` is the index of the
    /// coordinate. It is zero unless L contains time. Returns the reason, as text, if L cannot be derived.
    pub(super) fn partial_time_derivative_of_momentum(&mut self, at: usize) -> Result<Expr, String> {
        let momentum = self.momentum(at)?;
        let Some(time) = self.model.time() else { return Ok(Expr::ZERO) };
        Ok(self.lagrangian_derivative(momentum, self.model.coordinates[time].symbol))
    }
}
