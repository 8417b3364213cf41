//! Terms of M(q) q̈ + C(q, q̇) q̇ + g(q) = τ, from T and V with no constraint substituted.
//!
//! C is not unique, but C q̇ is: h_i = Σ_jk (∂M_ij/∂q_k − ½ ∂M_jk/∂q_i) q̇_j q̇_k. The choice by Christoffel symbols
//! is C_ij = ½ Σ_k (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i) q̇_k. It makes Ṁ − 2 C skew-symmetric (M. W. Spong, S.
//! Hutchinson & M. Vidyasagar, *Robot Modeling and Control* (2006), §7.3 and §7.5.1).

use super::Quantities;
use crate::algebra::term::calculus::Differential;
use crate::algebra::{Expr, Rational};
use crate::mechanics::formulations::formulation::Formulation;
use crate::model::TIME;

impl Quantities<'_> {
    /// Entry M_ij = ∂²T/∂q̇_i ∂q̇_j of the mass matrix.
    ///
    /// # Errors
    /// Returns the reason, as text, why there is no such matrix: motions are prescribed as functions of time, or
    /// Lagrange's method failed.
    fn mass(&mut self, i: usize, j: usize) -> Result<Expr, String> {
        if self.model.coordinates.iter().any(|c| c.name == TIME) {
            return Err("with motions given as functions of time, T is not a quadratic form in the rates".to_owned());
        }
        let t = self.equations(Formulation::Lagrange)?.kinetic_energy;
        let model = self.model;
        let arena = &mut self.derivations.kinematics.arena;
        let momentum = Differential::partial(model.coordinates[i].rate).apply(arena, t);
        Ok(Differential::partial(model.coordinates[j].rate).apply(arena, momentum))
    }

    /// Time derivative of the mass matrix entry M_ij along the motion, Σ_k ∂M_ij/∂q_k q̇_k. Returns the reason, as
    /// text, if there is no such matrix.
    pub(super) fn mass_rate(&mut self, i: usize, j: usize) -> Result<Expr, String> {
        let mass = self.mass(i, j)?;
        let rates: Vec<_> = self.model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        Ok(Differential::along(&rates).apply(&mut self.derivations.kinematics.arena, mass))
    }

    /// Entry C_ij of the matrix in the velocity terms C q̇, which is chosen by Christoffel symbols. Returns the
    /// reason, as text, if there is no such matrix.
    pub(super) fn christoffel(&mut self, i: usize, j: usize) -> Result<Expr, String> {
        let mut terms = vec![self.mass_rate(i, j)?];
        for k in 0..self.model.coordinates.len() {
            let (along_j, along_i) = (self.mass(i, k)?, self.mass(j, k)?);
            let model = self.model;
            let arena = &mut self.derivations.kinematics.arena;
            let first = Differential::partial(model.coordinates[j].symbol).apply(arena, along_j);
            let second = Differential::partial(model.coordinates[i].symbol).apply(arena, along_i);
            let difference = arena.sub(first, second);
            terms.push(arena.mul(difference, model.coordinates[k].rate));
        }
        let arena = &mut self.derivations.kinematics.arena;
        let twice = arena.sum(&terms);
        Ok(arena.scale(twice, &Rational::fraction(1, 2).expect("not zero")))
    }

    /// Entry h_i of the velocity terms C q̇, quadratic in the rates. Returns the reason, as text, if there is no mass
    /// matrix.
    pub(super) fn velocity_terms(&mut self, i: usize) -> Result<Expr, String> {
        let mut terms = Vec::new();
        for j in 0..self.model.coordinates.len() {
            let entry = self.christoffel(i, j)?;
            let rate = self.model.coordinates[j].rate;
            terms.push(self.derivations.kinematics.arena.mul(entry, rate));
        }
        Ok(self.derivations.kinematics.arena.sum(&terms))
    }

    /// Derivative g_i = ∂V/∂q_i of the potential energy with respect to a coordinate. Returns the reason, as text, if
    /// Lagrange's method failed.
    pub(super) fn potential_slope(&mut self, i: usize) -> Result<Expr, String> {
        let v = self.equations(Formulation::Lagrange)?.potential_energy;
        let mut partial = Differential::partial(self.model.coordinates[i].symbol);
        Ok(partial.apply(&mut self.derivations.kinematics.arena, v))
    }
}
