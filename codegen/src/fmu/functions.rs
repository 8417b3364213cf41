//! Planned functions of a functional mock-up unit: those of Kane's equations, with the outputs and
//! events of a scene.

use crate::plan::{Arguments, ModulePlan, Planner, Returns, Shown, Solution, numbered};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Jacobian, Solved, Unsolved, parameter_jacobian, slopes};
use tripos_derive::scene::{Scene, SceneEvent, SceneOutput};
use tripos_derive::{Equations, Model};

/// Names of the functions of the equations that the C sources of a functional mock-up unit call.
const CALLED: [&str; 7] =
    ["derivative", "jacobian", "parameter_jacobian", "divisors", "conditions", "constraints", "constraint_slopes"];

/// Equations solved for the accelerations, with the outputs and events of a scene, for a functional
/// mock-up unit.
pub struct FmuFunctions {
    /// Accelerations in closed form, with their derivatives by the state and by the parameters.
    solution: Solution,
    /// Outputs that are not states, and event functions, as terms.
    shown: Shown,
    /// Derivatives of the outputs by the coordinates, the generalized speeds and the parameters:
    /// one row per output. `None` if they would be too long.
    output_slopes: Option<Jacobian>,
}

impl FmuFunctions {
    /// Solves the equations for the accelerations, and differentiates these and the outputs.
    ///
    /// # Errors
    /// [`Unsolved`] if the accelerations are not determined in closed form, or if a result is not
    /// proved.
    pub fn new(model: &Model, scene: &Scene, arena: &mut Arena, equations: &Equations) -> Result<Self, Unsolved> {
        let by_state = Solved::new(arena, equations)?;
        let mut simplifier = Simplifier::default();
        let solved = &by_state.accelerations;
        let by_parameters = parameter_jacobian(arena, &mut simplifier, equations, solved, &model.p())?;
        let mut shown = Shown::new(model, scene, arena, equations, Some(solved));
        let is_state = |o: &SceneOutput| model.q().contains(&o.value) || model.u().contains(&o.value);
        shown.outputs.retain(|output| !is_state(output));
        let values: Vec<Expr> = shown.outputs.iter().map(|o| o.value).collect();
        let along = [equations.coordinates.clone(), equations.variables.clone(), model.p()].concat();
        let output_slopes = slopes(arena, &mut simplifier, &shown.steps, &values, &along)?;
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
    pub fn left_out(&self) -> Vec<String> {
        self.shown.left_out.iter().map(|(name, _)| name.clone()).collect()
    }

    /// True if all directional derivatives are available: those of the state derivative by the
    /// state (in `plan`) and by the parameters, and those of the outputs.
    pub fn has_slopes(&self, plan: &ModulePlan) -> bool {
        self.output_slopes.is_some() && self.solution.by_parameters.is_some() && plan.has("jacobian")
    }

    /// Plans the functions that the C sources of a functional mock-up unit call.
    pub fn plan(&self, planner: &Planner<'_>) -> ModulePlan {
        let mut plan = ModulePlan::new(planner, Some(&self.solution));
        plan.functions.retain(|function| CALLED.contains(&function.name));
        plan.functions.extend(self.shown.functions(planner));
        let columns = planner.equations.coordinates.len() + planner.equations.variables.len() + planner.model.p().len();
        plan.functions.extend(self.output_slopes.as_ref().filter(|_| !self.shown.outputs.is_empty()).map(|slopes| {
            let entries = slopes.entries.iter().flatten().map(|entry| ("slope".to_owned(), *entry));
            let about = "Slopes of the outputs along q, u and the parameters.";
            let (returns, entries) = (Returns::Table { columns }, numbered("slope", entries));
            planner.stepwise("output_jacobian", about, Arguments::State, returns, &slopes.steps, &entries)
        }));
        plan
    }
}
