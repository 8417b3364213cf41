//! Planned functions for those outputs and events of a scene that depend only on the state.

use super::equation_functions::definitions_of_other_variables;
use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::Planner;
use rustc_hash::FxHashSet;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::scene::{ENERGIES, Scene, SceneEvent, SceneOutput};
use tripos_derive::{Equations, Model};

/// Reason for the lack of a function for an output or event of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MissingOutputReason {
    /// The formula contains a reaction, for which there is no closed form.
    Reaction,
    /// The formula contains an acceleration, and the accelerations have no closed form.
    Acceleration,
}

/// Outputs and events of a scene, with the intermediate terms that compute them from the state.
#[derive(Clone, Debug)]
pub struct SceneOutputs {
    /// Definitions in the order of computation: accelerations, then q̇ or u (the one that is not integrated), then
    /// energies.
    pub steps: Vec<Definition>,
    /// Outputs of the scene that the state determines.
    pub outputs: Vec<SceneOutput>,
    /// Events of the scene whose functions the state determines.
    pub events: Vec<SceneEvent>,
    /// Outputs and events without a function, each as (name, reason).
    pub left_out: Vec<(String, MissingOutputReason)>,
}

impl SceneOutputs {
    /// Selects the outputs and events that the state determines. `solved` gives the accelerations; it is `None` if
    /// they have no closed form.
    #[must_use]
    pub fn new(
        model: &Model,
        scene: &Scene,
        arena: &mut Arena,
        equations: &Equations,
        solved: Option<&Elimination>,
    ) -> Self {
        let steps = scene_output_definitions(model, arena, equations, solved);
        let rates: Vec<Expr> = equations.unknowns.iter().take(equations.variables.len()).copied().collect();
        let hidden = |value: Expr| {
            // The steps may lead to an acceleration that the formula itself does not contain.
            let read = needed_steps(arena, &steps, &[value]);
            let terms: Vec<Expr> = read.iter().map(|step| step.value).chain([value]).collect();
            let mentions = |symbol: Expr| terms.iter().any(|term| arena.mentions(*term, symbol));
            if model.reactions.iter().any(|reaction| mentions(reaction.symbol)) {
                Some(MissingOutputReason::Reaction)
            } else if solved.is_none() && rates.iter().any(|rate| mentions(*rate)) {
                Some(MissingOutputReason::Acceleration)
            } else {
                None
            }
        };
        let mut left_out = Vec::new();
        let mut kept = |name: &str, value: Expr| {
            let why = hidden(value);
            left_out.extend(why.map(|why| (name.to_owned(), why)));
            why.is_none()
        };
        let outputs = scene.outputs.iter().filter(|output| kept(&output.name, output.value)).cloned().collect();
        let events = scene.events.iter().filter(|event| kept(&event.name, event.function)).cloned().collect();
        Self { steps, outputs, events, left_out }
    }

    /// Plans the functions `outputs` and `events`. A function without entries is left out.
    #[must_use]
    pub fn functions(&self, planner: &Planner<'_>) -> Vec<Function> {
        let outputs = numbered_values("output", self.outputs.iter().map(|o| (o.name.clone(), o.value)));
        let events = numbered_values("event", self.events.iter().map(|e| (e.name.clone(), e.function)));
        let own = |name: &'static str, about: &str, values: &[Value]| {
            let plan =
                || planner.plan_function_in_steps(name, about, Arguments::State, Returns::Vector, &self.steps, values);
            (!values.is_empty()).then(plan)
        };
        let about_events = "Functions of the scene that are zero at its events.";
        let list = [own("outputs", "Outputs of the scene.", &outputs), own("events", about_events, &events)];
        list.into_iter().flatten().collect()
    }

    /// Returns the names of the entries that the functions `outputs` and `events` return, each list
    /// with its title for a header.
    #[must_use]
    pub fn names(&self) -> [(&'static str, Vec<String>); 2] {
        let outputs = self.outputs.iter().map(|output| output.name.clone()).collect();
        [("Outputs", outputs), ("Events", self.events.iter().map(|event| event.name.clone()).collect())]
    }
}

/// Returns definitions of the accelerations v̇, of q̇ or u (the one that is not integrated), of the rates of u, and
/// of the energies.
fn scene_output_definitions(
    model: &Model,
    arena: &mut Arena,
    equations: &Equations,
    solved: Option<&Elimination>,
) -> Vec<Definition> {
    let mut steps = solved.map_or_else(Vec::new, |solved| solved.steps.clone());
    let known: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    steps.extend(equations.definitions.iter().filter(|step| !known.contains(&step.symbol)));
    steps.extend(definitions_of_other_variables(model, equations));
    if equations.formulation.is_in_rates() {
        // The elimination may have computed the rate of a speed already.
        let rates = model.speeds.iter().map(|speed| speed.rate).zip(&equations.generalized_speed_rates);
        let rates = rates.filter(|(symbol, _)| !known.contains(symbol));
        steps.extend(rates.map(|(symbol, value)| Definition { symbol, value: *value }));
    }
    let total = arena.add(equations.kinetic_energy, equations.potential_energy);
    let energies = [equations.kinetic_energy, equations.potential_energy, total];
    for (name, value) in ENERGIES.iter().zip(energies) {
        // If the model has a parameter with the name of an energy, the name means that parameter.
        let symbol = arena.find_symbol(name).filter(|symbol| !model.p().contains(symbol));
        steps.extend(symbol.map(|symbol| Definition { symbol, value }));
    }
    steps
}

/// Returns values to be computed. Their variables are `stem` with the numbers 1, 2 and so on.
pub fn numbered_values(stem: &str, list: impl Iterator<Item = (String, Expr)>) -> Vec<Value> {
    list.enumerate().map(|(at, (name, value))| (format!("{stem}{}", at + 1), name, value)).collect()
}
