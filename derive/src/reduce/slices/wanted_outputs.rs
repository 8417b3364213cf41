//! Outputs, conditions and events of a scene, as terms in the variables of a reduction.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::mechanics::{DeriveError, rates_to_speeds};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::scene::Scene;

/// Values that a scene shows or monitors, and which reduced equations must give: outputs,
/// conditions and events.
#[derive(Clone, Debug)]
pub struct WantedOutputs {
    /// Outputs of the scene, as pairs of name and value.
    pub outputs: Vec<(String, Expr)>,
    /// Functions of the model's domain conditions; they must be positive inside the domain.
    pub conditions: Vec<Expr>,
    /// Functions of the scene's events, in the order of the scene.
    pub events: Vec<Expr>,
}

impl WantedOutputs {
    /// Applies the function `rewrite` to each wanted value. Returns the rewritten values.
    pub fn map(&self, mut rewrite: impl FnMut(Expr) -> Expr) -> Self {
        Self {
            outputs: self.outputs.iter().map(|(name, e)| (name.clone(), rewrite(*e))).collect(),
            conditions: self.conditions.iter().map(|e| rewrite(*e)).collect(),
            events: self.events.iter().map(|e| rewrite(*e)).collect(),
        }
    }

    /// All wanted values, each with a description for messages.
    pub fn outputs_with_descriptions(&self) -> Vec<(String, Expr)> {
        let outputs = self.outputs.iter().map(|(name, e)| (format!("the output {name}"), *e));
        let conditions = self.conditions.iter().map(|e| ("a condition of the domain".to_owned(), *e));
        let events = self.events.iter().map(|e| ("an event".to_owned(), *e));
        outputs.chain(conditions).chain(events).collect()
    }

    /// All wanted values in this order: outputs, conditions, events.
    pub(in crate::reduce) fn values(&self) -> Vec<Expr> {
        let outputs = self.outputs.iter().map(|(_, e)| *e);
        outputs.chain(self.conditions.iter().copied()).chain(self.events.iter().copied()).collect()
    }
}

impl ReductionBasis {
    /// Collects the values that a scene shows or monitors, as terms in q and u. Reactions in them
    /// are replaced by their values.
    ///
    /// # Errors
    /// `DeriveError` if a reaction is wanted and the model's equations do not determine it.
    pub(in crate::reduce) fn wanted(&mut self, scene: &Scene) -> Result<WantedOutputs, DeriveError> {
        let mut rewrite = self.wanted_name_substitution(scene)?;
        let mut output = |basis: &mut Self, e: Expr| {
            let e = rewrite.apply(&mut basis.arena, e);
            let e = rates_to_speeds(&basis.model).apply(&mut basis.arena, e);
            basis.simplifier.simplify(&mut basis.arena, e)
        };
        let outputs = scene.outputs.iter().map(|o| (o.name.clone(), output(self, o.value))).collect();
        let conditions: Vec<Expr> = self.model.domain.iter().map(|c| c.positive).collect();
        let events: Vec<Expr> = scene.events.iter().map(|e| e.function).collect();
        let conditions = conditions.into_iter().map(|e| output(self, e)).collect();
        let events = events.into_iter().map(|e| output(self, e)).collect();
        Ok(WantedOutputs { outputs, conditions, events })
    }

    /// Substitution for the names that scenes may use besides q and u: parameters with numbers,
    /// energies, reactions.
    ///
    /// # Errors
    /// `DeriveError` if a reaction is wanted and the model's equations do not determine it.
    fn wanted_name_substitution(&mut self, scene: &Scene) -> Result<Substitution, DeriveError> {
        let mut pairs = Vec::new();
        for (name, value) in &self.folded {
            if let Some(p) = self.model.parameters.iter().find(|p| p.name == *name) {
                pairs.push((p.symbol, self.arena.number(value.clone())));
            }
        }
        let (kinetic, potential) = (self.kane.kinetic_energy, self.kane.potential_energy);
        let total = self.arena.add(kinetic, potential);
        let energies = [("kinetic_energy", kinetic), ("potential_energy", potential), ("total_energy", total)];
        pairs.extend(energies.into_iter().filter_map(|(name, e)| Some((self.arena.find_symbol(name)?, e))));
        let mentioned = |e: Expr| self.model.reactions.iter().any(|r| self.arena.mentions(e, r.symbol));
        let conditions = self.model.domain.iter().map(|c| c.positive);
        let values = scene.outputs.iter().map(|o| o.value).chain(scene.events.iter().map(|e| e.function));
        if values.chain(conditions).any(mentioned) {
            pairs.extend(self.reactions()?);
        }
        Ok(Substitution::new(&pairs))
    }

    /// Values of the reactions, as pairs (symbol, term in q, u and u̇).
    ///
    /// # Errors
    /// `DeriveError` if the model's equations do not determine the reactions.
    fn reactions(&mut self) -> Result<Vec<(Expr, Expr)>, DeriveError> {
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        Ok(self.balance.clone()?.solved_reactions(&mut self.arena, &mut self.simplifier, &states))
    }
}
