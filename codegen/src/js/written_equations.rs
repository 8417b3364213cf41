//! Equations in the form in which they are planned: written down, with their store of terms and their solution.

use super::LANGUAGE;
use crate::plan::{Planner, Sharing};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::mechanics::{Derivation, DeriveError, Unsolved, accelerations};
use tripos_derive::{Equations, Formulation, Model, derive};

/// Equations with all data from which their functions are planned.
pub struct Written {
    /// Store of the terms of the equations and the elimination.
    pub arena: Arena,
    /// Equations in written form.
    pub equations: Equations,
    /// Elimination that gives the accelerations; `None` if the linear system is solved in numbers.
    pub solved: Option<Elimination>,
}

impl Written {
    /// Derived equations, solved for their accelerations if these are determined.
    ///
    /// # Errors
    /// [`DeriveError::Unsolved`] if the accelerations were found but are not proved.
    pub fn solved(derivation: Derivation) -> Result<Self, DeriveError> {
        let mut written = Self::unsolved(derivation);
        let solved = accelerations(&mut written.arena, &mut Simplifier::default(), &written.equations);
        written.solved = match solved {
            Ok(solved) => Some(solved),
            Err(Unsolved::Singular(_)) => None,
            Err(why) => return Err(DeriveError::Unsolved(why)),
        };
        Ok(written)
    }

    /// Equations whose linear system is solved in numbers.
    #[must_use]
    pub fn unsolved(Derivation { mut arena, equations }: Derivation) -> Self {
        let equations = equations.written(&mut arena);
        Self { arena, equations, solved: None }
    }

    /// Equations that give the reactions of a model. `None` if no term contains a reaction, or if the model does not
    /// support Newton–Euler.
    ///
    /// # Errors
    /// [`Diagnostics`] if the model cannot be derived.
    pub fn balance(model: &Model, mut terms: impl Iterator<Item = Expr>) -> Result<Option<Self>, Diagnostics> {
        let asks = |e| model.reactions.iter().any(|reaction| model.arena.mentions(e, reaction.symbol));
        if !terms.any(asks) {
            return Ok(None);
        }
        match derive(model, Formulation::NewtonEuler) {
            Ok(derivation) => Ok(Some(Self::unsolved(derivation))),
            Err(error) if error.is_unsupported() => Ok(None),
            Err(error) => Err(model.diagnose(&error)),
        }
    }

    /// Planner of the functions in JavaScript. Solved equations share operations; printed equations keep their own
    /// cancellations.
    #[must_use]
    pub fn planner<'a>(&'a self, model: &'a Model) -> Planner<'a> {
        let is_printed = self.equations.by.printed_id().is_some();
        let sharing = if is_printed { Sharing::AsStated } else { Sharing::Shared };
        Planner::new(model, &self.arena, &self.equations, &LANGUAGE, sharing)
    }
}
