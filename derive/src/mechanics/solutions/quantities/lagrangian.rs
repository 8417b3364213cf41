//! Operators of Lagrange's equations d/dt ∂L/∂q̇ − ∂L/∂q = Q, on L with no constraint put in.

use super::Quantities;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::mechanics::quantity::{Energy, QuantityKind};

impl Quantities<'_> {
    /// Lagrangian in q and q̇.
    fn lagrangian(&mut self) -> Result<Expr, String> {
        let constrained = self.energy(Energy::Lagrangian)?;
        Ok(self.before_constraints(&QuantityKind::Energy(Energy::Lagrangian), constrained))
    }

    /// Slope of a term along a symbol, with all others held.
    fn slope(&mut self, e: Expr, along: Expr) -> Expr {
        Differential::partial(along).apply(&mut self.derivations.kinematics.arena, e)
    }

    /// Generalized momentum ∂L/∂q̇ of a coordinate.
    pub(super) fn momentum(&mut self, at: usize) -> Result<Expr, String> {
        let lagrangian = self.lagrangian()?;
        Ok(self.slope(lagrangian, self.model.coordinates[at].rate))
    }

    /// Slope ∂L/∂q along a coordinate.
    pub(super) fn lagrangian_slope(&mut self, at: usize) -> Result<Expr, String> {
        let lagrangian = self.lagrangian()?;
        Ok(self.slope(lagrangian, self.model.coordinates[at].symbol))
    }

    /// Rate d/dt ∂L/∂q̇ along the motion, in q, q̇ and q̈.
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

    /// Slope ∂/∂t ∂L/∂q̇, zero unless the time itself stands in L.
    pub(super) fn held_momentum_rate(&mut self, at: usize) -> Result<Expr, String> {
        let momentum = self.momentum(at)?;
        let Some(time) = self.model.time() else { return Ok(Expr::ZERO) };
        Ok(self.slope(momentum, self.model.coordinates[time].symbol))
    }
}
