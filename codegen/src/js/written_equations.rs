//! Equations in written form, with their arena and their solution. JavaScript functions are planned from them.

use super::LANGUAGE;
use crate::plan::{Planner, Sharing};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::mechanics::{Derivation, DeriveError, Unsolved, accelerations};
use tripos_derive::{Equations, Formulation, Model, derive};

/// Equations of a model with all data from which their functions are planned.
pub struct WrittenEquations {
    /// Arena with the terms of the equations and of the elimination.
    pub arena: Arena,
    /// Equations in the form in which they are written as code: symbols replace named terms.
    pub equations: Equations,
    /// Elimination that gives the accelerations in closed form. `None` if the linear system is solved numerically.
    pub solved: Option<Elimination>,
}

impl WrittenEquations {
    /// Solves derived equations for the accelerations. If the accelerations are not determined, the linear system
    /// remains for a numeric solution.
    ///
    /// # Errors
    /// Returns [`DeriveError::Unsolved`] if the accelerations were found but are not proved.
    pub fn solve_for_accelerations(derivation: Derivation) -> Result<Self, DeriveError> {
        let mut written = Self::keep_linear_system(derivation);
        let solved = accelerations(&mut written.arena, &mut Simplifier::default(), &written.equations);
        written.solved = match solved {
            Ok(solved) => Some(solved),
            Err(Unsolved::Singular(_)) => None,
            Err(why) => return Err(DeriveError::Unsolved(why)),
        };
        Ok(written)
    }

    /// Creates written equations without a solution: their linear system remains for a numeric solution.
    #[must_use]
    pub fn keep_linear_system(Derivation { mut arena, equations }: Derivation) -> Self {
        let equations = equations.with_definitions(&mut arena);
        Self { arena, equations, solved: None }
    }

    /// Derives the Newton–Euler equations, which give a model's reactions. `None` if no given term contains a
    /// reaction, or if the model does not support Newton–Euler.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the derivation fails for another reason.
    pub fn reaction_equations(
        model: &Model,
        mut terms: impl Iterator<Item = Expr>,
    ) -> Result<Option<Self>, Diagnostics> {
        let asks = |e| model.reactions.iter().any(|reaction| model.arena.mentions(e, reaction.symbol));
        if !terms.any(asks) {
            return Ok(None);
        }
        match derive(model, Formulation::NewtonEuler) {
            Ok(derivation) => Ok(Some(Self::keep_linear_system(derivation))),
            Err(error) if error.is_unsupported() => Ok(None),
            Err(error) => Err(model.diagnose(&error)),
        }
    }

    /// Returns a planner of JavaScript functions for these equations. Derived equations share
    /// common subexpressions; printed equations are computed as they stand.
    #[must_use]
    pub fn planner<'a>(&'a self, model: &'a Model) -> Planner<'a> {
        let is_printed = self.equations.by.printed_id().is_some();
        let sharing = if is_printed { Sharing::AsStated } else { Sharing::Shared };
        Planner::new(model, &self.arena, &self.equations, &LANGUAGE, sharing)
    }
}
