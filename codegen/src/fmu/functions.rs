//! Functions of a mock-up unit: those of the equations, with the outputs and events of a scene.

use crate::plan::{Arguments, Function, ModulePlan, Planner, Returns, Solution, Value};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Jacobian, Solved, Unsolved, parameter_jacobian, slopes};
use tripos_derive::scene::{ENERGIES, Scene, SceneEvent, SceneOutput};
use tripos_derive::{Equations, Model};

/// Functions of the equations that a unit calls.
const CALLED: [&str; 7] =
    ["derivative", "jacobian", "parameter_jacobian", "divisors", "conditions", "constraints", "constraint_slopes"];

/// Solved equations with the outputs and events of a scene.
pub struct FmuFunctions {
    solution: Solution,
    /// Steps that compute the unknowns, q̇ and the energies, in the order of computation.
    steps: Vec<Definition>,
    /// Outputs that are no states.
    pub outputs: Vec<SceneOutput>,
    /// Slopes of the outputs along the state, then the parameters; `None` if they would be too long.
    output_slopes: Option<Jacobian>,
    /// Events of the scene that need no reactions.
    pub events: Vec<SceneEvent>,
    /// Names of outputs and events that were left out, because they need reactions.
    pub left_out: Vec<String>,
}

impl FmuFunctions {
    /// Solves the equations, and differentiates them and the outputs.
    ///
    /// # Errors
    /// [`Unsolved`] if the accelerations are not determined in closed form, or if a result is not proved.
    pub fn new(model: &Model, scene: &Scene, arena: &mut Arena, equations: &Equations) -> Result<Self, Unsolved> {
        let by_state = Solved::new(arena, equations)?;
        let mut simplifier = Simplifier::default();
        let solved = &by_state.accelerations;
        let by_parameters = parameter_jacobian(arena, &mut simplifier, equations, solved, &model.p())?;
        let mut steps = solved.steps.clone();
        let rates = model.q_dot().into_iter().zip(equations.coordinate_rates.clone());
        steps.extend(rates.map(|(symbol, value)| Definition { symbol, value }));
        let total = arena.add(equations.kinetic_energy, equations.potential_energy);
        let energies = [equations.kinetic_energy, equations.potential_energy, total];
        for (name, value) in ENERGIES.iter().zip(energies) {
            // A quantity of the model with the name of an energy is meant itself.
            let symbol = arena.find_symbol(name).filter(|symbol| !model.p().contains(symbol));
            steps.extend(symbol.map(|symbol| Definition { symbol, value }));
        }
        let needs_reaction = |e: Expr| model.reactions.iter().any(|r| arena.mentions(e, r.symbol));
        let is_state = |o: &&SceneOutput| model.q().contains(&o.value) || model.u().contains(&o.value);
        let (lost, outputs): (Vec<_>, Vec<_>) =
            scene.outputs.iter().filter(|o| !is_state(o)).cloned().partition(|o| needs_reaction(o.value));
        let (lost_events, events): (Vec<_>, Vec<_>) =
            scene.events.iter().cloned().partition(|event| needs_reaction(event.function));
        let left_out = lost.into_iter().map(|o| o.name).chain(lost_events.into_iter().map(|e| e.name)).collect();
        let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
        let along = [equations.coordinates.clone(), equations.variables.clone(), model.p()].concat();
        let output_slopes = slopes(arena, &mut simplifier, &steps, &values, &along)?;
        let solution = Solution { by_state, by_parameters };
        Ok(Self { solution, steps, outputs, output_slopes, events, left_out })
    }

    /// True if the slopes of all outputs, and of the derivative along the parameters, are known.
    pub fn has_slopes(&self) -> bool {
        self.output_slopes.is_some() && self.solution.by_parameters.is_some()
    }

    /// Plans the functions that a unit calls.
    pub fn plan(&self, planner: &Planner<'_>) -> ModulePlan {
        let mut plan = ModulePlan::new(planner, Some(&self.solution));
        plan.functions.retain(|function| CALLED.contains(&function.name));
        let own = |name: &'static str, about: &str, returns: Returns, steps: &[Definition], values: &[Value]| {
            (!values.is_empty()).then(|| planner.stepwise(name, about, Arguments::State, returns, steps, values))
        };
        let outputs: Vec<Value> = numbered("output", self.outputs.iter().map(|o| (o.name.clone(), o.value)));
        let events: Vec<Value> = numbered("event", self.events.iter().map(|e| (e.name.clone(), e.function)));
        let columns = planner.equations.coordinates.len() + planner.equations.variables.len() + planner.model.p().len();
        let further: [Option<Function>; 3] = [
            own("outputs", "Outputs of the scene.", Returns::Vector, &self.steps, &outputs),
            own("events", "Functions of the scene that are zero at its events.", Returns::Vector, &self.steps, &events),
            self.output_slopes.as_ref().and_then(|slopes| {
                let entries = slopes.entries.iter().flatten().map(|entry| ("slope".to_owned(), *entry));
                let about = "Slopes of the outputs along q, u and the parameters.";
                own("output_jacobian", about, Returns::Table { columns }, &slopes.steps, &numbered("slope", entries))
            }),
        ];
        plan.functions.extend(further.into_iter().flatten());
        plan
    }
}

/// Values with numbered variables, from names for people and terms.
fn numbered(stem: &str, list: impl Iterator<Item = (String, Expr)>) -> Vec<Value> {
    list.enumerate().map(|(at, (name, value))| (format!("{stem}{}", at + 1), name, value)).collect()
}
