//! Planned functions of a functional mock-up unit: those of Kane's equations, with the outputs and
//! events of a scene.

use crate::plan::{Arguments, ModulePlan, Planner, Returns, SceneOutputs, Solution, numbered_values};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Jacobian, SolvedAccelerations, Unsolved, parameter_jacobian, proved_jacobian};
use tripos_derive::scene::{Scene, SceneEvent, SceneOutput};
use tripos_derive::{Equations, Model};

/// Names of the functions of the equations that the C sources of a functional mock-up unit call.
const FMU_FUNCTION_NAMES: [&str; 7] =
    ["derivative", "jacobian", "parameter_jacobian", "divisors", "conditions", "constraints", "constraint_slopes"];

/// Kane's equations solved for the accelerations, with the outputs and events of a scene, for a functional mock-up
/// unit.
pub struct FmuFunctions {
    /// Accelerations in closed form, with their derivatives with respect to the state and the parameters.
    solution: Solution,
    /// Outputs that are not states, and event functions, as terms.
    shown: SceneOutputs,
    /// Derivatives of the outputs with respect to the coordinates, the generalized speeds and the parameters, a row
    /// for each output. `None` if they would be too long.
    output_slopes: Option<Jacobian>,
}

impl FmuFunctions {
    /// Solves the equations for the accelerations, and differentiates the accelerations and the outputs.
    ///
    /// # Errors
    /// Returns [`Unsolved`] if the accelerations are not determined in closed form, or if a result is not proved.
    pub fn new(model: &Model, scene: &Scene, arena: &mut Arena, equations: &Equations) -> Result<Self, Unsolved> {
        let by_state = SolvedAccelerations::new(arena, equations)?;
        let mut simplifier = Simplifier::default();
        let solved = &by_state.accelerations;
        let by_parameters = parameter_jacobian(arena, &mut simplifier, equations, solved, &model.p())?;
        let mut shown = SceneOutputs::new(model, scene, arena, equations, Some(solved));
        let is_state = |o: &SceneOutput| model.q().contains(&o.value) || model.u().contains(&o.value);
        shown.outputs.retain(|output| !is_state(output));
        let values: Vec<Expr> = shown.outputs.iter().map(|o| o.value).collect();
        let along = [equations.coordinates.clone(), equations.variables.clone(), model.p()].concat();
        let output_slopes = proved_jacobian(arena, &mut simplifier, &shown.steps, &values, &along)?;
        let solution = Solution { by_state, by_parameters };
        Ok(Self { solution, shown, output_slopes })
    }

    /// Returns the scene's outputs that are not coordinates or generalized speeds.
    pub fn outputs(&self) -> &[SceneOutput] {
        &self.shown.outputs
    }

    /// Returns the scene's events whose functions contain no reactions.
    pub fn events(&self) -> &[SceneEvent] {
        &self.shown.events
    }

    /// Returns the names of the scene's outputs and events that the unit lacks, because they need
    /// reactions.
    pub fn outputs_needing_reactions(&self) -> Vec<String> {
        self.shown.left_out.iter().map(|(name, _)| name.clone()).collect()
    }

    /// True if all directional derivatives are available: those of the outputs, and those of the state derivative
    /// with respect to the state (in `plan`) and the parameters.
    pub fn has_directional_derivatives(&self, plan: &ModulePlan) -> bool {
        self.output_slopes.is_some() && self.solution.by_parameters.is_some() && plan.has("jacobian")
    }

    /// Plans the functions that the C sources of a functional mock-up unit call.
    pub fn plan(&self, planner: &Planner<'_>) -> ModulePlan {
        let mut plan = ModulePlan::new(planner, Some(&self.solution));
        plan.functions.retain(|function| FMU_FUNCTION_NAMES.contains(&function.name));
        plan.functions.extend(self.shown.functions(planner));
        let columns = planner.equations.coordinates.len() + planner.equations.variables.len() + planner.model.p().len();
        plan.functions.extend(self.output_slopes.as_ref().filter(|_| !self.shown.outputs.is_empty()).map(|slopes| {
            let entries = slopes.entries.iter().flatten().map(|entry| ("slope".to_owned(), *entry));
            let about = "Slopes of the outputs along q, u and the parameters.";
            let (returns, entries) = (Returns::Table { columns }, numbered_values("slope", entries));
            planner.plan_function_in_steps("output_jacobian", about, Arguments::State, returns, &slopes.steps, &entries)
        }));
        plan
    }
}
