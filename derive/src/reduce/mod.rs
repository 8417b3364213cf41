//! The least system that gives what a scene wants to see: equations of motion on the level set of its momenta, without
//! what the outputs do not depend on.
//!
//! Every step is exact. Momenta of commuting symmetries take speeds out (`level`); what nothing depends on by meaning is
//! left out and stands as a constant where a formula mentions it (`slice`); variables that a symmetry moves together become
//! differences (`relative`); what follows from the rest is computed when it is asked for. The result is a model and equations as any
//! others, with the momenta among the parameters, so that all that runs, charts and emits equations takes it.
//!
//! Absent on purpose: numbers of the start. A reduction holds for every start on every level set, but for the distance from
//! a singular surface, whose side the start decides.

mod constants;
mod dependence;
mod ground;
mod hoist;
mod ledger;
mod level;
mod one_degree;
mod pack;
mod pivots;
mod proof;
mod relative;
mod slice;
mod surface;

pub use ground::Ground;
pub use one_degree::Slope;
pub use proof::Proof;

use crate::algebra::elimination::Definition;
use crate::algebra::{Arena, Expr, Rational, print};
use crate::mechanics::{Derivation, DeriveError, has_inertia_at};
use crate::model::{Model, Unit, text_hash};
use crate::scene::Scene;
use proof::Whole;
use slice::Flow;
use std::cmp::Reverse;

/// Something that stands among the variables or parameters of a reduced system, and its value at the start.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in the reduced system.
    pub name: String,
    /// Its symbol there.
    pub symbol: Expr,
    /// What it is, in words.
    pub about: String,
    /// Its unit.
    pub unit: Unit,
    /// Its value in parameters, coordinates and speeds of the whole model.
    pub of_start: Expr,
}

/// What a scene asks for, as the reduced system gives it.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name in the scene.
    pub name: String,
    /// Its value in parameters, constants, time and states of the reduced system.
    pub value: Expr,
}

/// What was left out of a system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// What is not there.
    pub what: String,
    /// Why it need not be.
    pub why: String,
    /// How that is known.
    pub proof: String,
}

/// A scene's own equations.
#[derive(Clone)]
pub struct Reduction {
    /// The variables and parameters of the reduced system, the momenta among the latter; its store holds all terms.
    pub model: Model,
    /// Its equations, with the same store.
    pub derivation: Derivation,
    /// What is integrated and depends on nothing else than these.
    pub states: Vec<Quantity>,
    /// What is integrated along with them, since the outputs need it; no state depends on it.
    pub quadratures: Vec<Quantity>,
    /// What stays as it is at the start.
    pub constants: Vec<Quantity>,
    /// Those of the constants that stand for products of parameters and other constants.
    pub products: Vec<Definition>,
    /// What the scene wants to see.
    pub outputs: Vec<Output>,
    /// The functions of the scene's events, in its order.
    pub events: Vec<Expr>,
    /// Parameters that stand as numbers.
    pub folded: Vec<(String, Rational)>,
    /// What was left out.
    pub omitted: Vec<Omission>,
    /// What the reduction divides by: where one of these is zero, it says nothing.
    pub divisors: Vec<Expr>,
    /// Whether the energy is a function of what is kept; otherwise the energies of the equations are 0.
    pub has_energy: bool,
    /// For quadrature, if there is one degree of freedom.
    pub slope: Option<Slope>,
    /// The time since the start, in outputs that are linear in it.
    pub time: Expr,
    /// That it gives what the whole model gives: nothing else is returned.
    pub proof: Proof,
}

impl Reduction {
    /// A hash of everything that the reduced equations depend on: the model's text, what the scene asks for, the numbers that it
    /// fixes, and what was chosen to hold and to measure from.
    #[must_use]
    pub fn key(&self) -> String {
        let arena = self.terms();
        let mut text = self.model.text_hash();
        let quantities = self.states.iter().chain(&self.quadratures).chain(&self.constants);
        let names = quantities.map(|q| format!("{} = {}", q.name, print::text(arena, q.of_start)));
        let outputs = self.outputs.iter().map(|o| format!("{}: {}", o.name, print::whole_text(arena, o.value)));
        let folded = self.folded.iter().map(|(name, value)| format!("{name} = {}", value.to_big()));
        for line in names.chain(outputs).chain(folded) {
            text.push('\n');
            text.push_str(&line);
        }
        text_hash(&text)
    }

    /// The store of all terms.
    #[must_use]
    pub fn terms(&self) -> &Arena {
        &self.derivation.arena
    }
}

/// Derives the reduced system of a scene of this model.
///
/// # Errors
/// [`DeriveError`] if the model's own equations cannot be derived, or an output needs a reaction that they do not determine;
/// [`DeriveError::ReductionNotProved`] if even the system without momenta cannot be proved to give what the scene wants.
pub fn reduce(model: &Model, scene: &Scene) -> Result<Reduction, DeriveError> {
    Ground::new(model)?.reduce(scene)
}

/// The same without momenta: nothing is divided by but what the model's own equations divide by.
///
/// # Errors
/// As [`reduce`].
pub fn reduce_without_momenta(model: &Model, scene: &Scene) -> Result<Reduction, DeriveError> {
    let mut ground = Ground::new(model)?;
    ground.fold(scene);
    let wanted = ground.wanted(scene)?;
    let whole = Whole { kane: ground.kane.clone(), wanted };
    ground.on_level(&[], &whole, scene).map_err(|what| DeriveError::ReductionNotProved { what })
}

impl Ground {
    /// The reduced system of a scene of the model that this was made from.
    ///
    /// # Errors
    /// As [`reduce`].
    pub fn reduce(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        let mut ground = self.clone();
        has_inertia_at(&self.arena, &self.kane, &self.model, &scene.exact.rational)?;
        ground.fold(scene);
        let wanted = ground.wanted(scene)?;
        let mut best: Option<(Weight, Vec<usize>)> = None;
        let choices = ground.choices();
        // With one choice there is nothing to compare.
        let compared = if choices.len() > 1 { choices } else { Vec::new() };
        for momenta in compared {
            let mut trial = ground.clone();
            let wanted = trial.relative(&momenta, wanted.clone());
            let Some(level) = trial.level(&momenta, None) else { continue };
            let Some(flow) = Flow::new(&mut trial, &level, &wanted) else { continue };
            let (core, integrated, operations) = flow.weight(&trial);
            // Of equal ones the choice that holds most: then the energy, too, is a function of what is kept.
            let weight = (core, integrated, operations, Reverse(momenta.len()));
            if best.as_ref().is_none_or(|(least, _)| weight < *least) {
                best = Some((weight, momenta));
            }
        }
        let momenta = best.map(|(_, momenta)| momenta).unwrap_or_default();
        let whole = Whole { kane: ground.kane.clone(), wanted };
        let found = ground.clone().on_level(&momenta, &whole, scene);
        // What is not proved is not used. Without momenta there is less to prove.
        let found = if momenta.is_empty() { found } else { found.or_else(|_| ground.on_level(&[], &whole, scene)) };
        found.map_err(|what| DeriveError::ReductionNotProved { what })
    }

    /// The reduced system on the level set of these momenta.
    fn on_level(mut self, momenta: &[usize], whole: &Whole, scene: &Scene) -> Result<Reduction, String> {
        // The equations are written anew in the distance from where this choice is singular.
        let wanted = self.relative(momenta, whole.wanted.clone());
        let mut trial = self.clone();
        let place = trial.level(momenta, None).and_then(|level| trial.surface(&level, &wanted, scene));
        let (surface, wanted) = match place {
            Some(place) => {
                let (surface, wanted) = self.measure_from(place, &wanted);
                (Some(surface), wanted)
            }
            None => (None, wanted),
        };
        let level = self.level(momenta, surface.as_ref()).ok_or("that the momenta determine speeds")?;
        let flow = Flow::new(&mut self, &level, &wanted).ok_or("that the accelerations are determined")?;
        pack::pack(self, whole, &level, flow, scene)
    }
}

/// By what choices of momenta are compared: states, all that is integrated, operations, momenta held.
type Weight = (usize, usize, usize, Reverse<usize>);
