//! Functions of a mock-up unit: those of the equations, with the outputs and events of a scene.

use crate::plan::{Arguments, ModulePlan, Planner, Returns, Shown, Solution, numbered};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Jacobian, Solved, Unsolved, parameter_jacobian, slopes};
use tripos_derive::scene::{Scene, SceneEvent, SceneOutput};
use tripos_derive::{Equations, Model};

/// Functions of the equations that a unit calls.
const CALLED: [&str; 7] =
    ["derivative", "jacobian", "parameter_jacobian", "divisors", "conditions", "constraints", "constraint_slopes"];

/// Solved equations with the outputs and events of a scene.
pub struct FmuFunctions {
    solution: Solution,
    /// Outputs that are not states, and event functions.
    shown: Shown,
    /// Slopes of the outputs along the state, then the parameters; `None` if they would be too long.
    output_slopes: Option<Jacobian>,
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
        let mut shown = Shown::new(model, scene, arena, equations, Some(solved));
        let is_state = |o: &SceneOutput| model.q().contains(&o.value) || model.u().contains(&o.value);
        shown.outputs.retain(|output| !is_state(output));
        let values: Vec<Expr> = shown.outputs.iter().map(|o| o.value).collect();
        let along = [equations.coordinates.clone(), equations.variables.clone(), model.p()].concat();
        let output_slopes = slopes(arena, &mut simplifier, &shown.steps, &values, &along)?;
        let solution = Solution { by_state, by_parameters };
        Ok(Self { solution, shown, output_slopes })
    }

    /// Outputs that are no states.
    pub fn outputs(&self) -> &[SceneOutput] {
        &self.shown.outputs
    }

    /// Events of the scene that need no reactions.
    pub fn events(&self) -> &[SceneEvent] {
        &self.shown.events
    }

    /// Names of outputs and events that were left out, because they need reactions.
    pub fn left_out(&self) -> Vec<String> {
        self.shown.left_out.iter().map(|(name, _)| name.clone()).collect()
    }

    /// True if the plan computes the slopes of the derivative, and the slopes of all outputs, and of the derivative
    /// along the parameters, are known.
    pub fn has_slopes(&self, plan: &ModulePlan) -> bool {
        self.output_slopes.is_some() && self.solution.by_parameters.is_some() && plan.has("jacobian")
    }

    /// Plans the functions that a unit calls.
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
