//! Reduced equations of a scene on the page: their description, their run, and outputs for a comparison with the whole
//! model.

use crate::page::ReducedEquationsContent;
use crate::terminal::failure::Failure;
use tripos::trust::compared_quantities::ComparedQuantities;
use tripos::{
    InvariantValues, Mechanism, Problem, ReducedScene, Run, WatchedInvariants, run_problem, set_whole_model_energies,
};
use tripos_codegen::plan::scene_costs;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// Reduced equations of a scene with their run, for the page.
pub struct ReducedRun {
    /// Description of the reduced equations, with the number of operations of an evaluation.
    pub needs: ReducedEquationsContent,
    /// Run of the scene that integrates its reduced equations.
    pub run: Run,
    /// Watched quantities along the run. `None` if the reduced equations lack states that these quantities need.
    pub course: Option<InvariantValues>,
}

impl ReducedRun {
    /// Derives the reduced equations of a scene and runs them.
    ///
    /// # Errors
    /// [`Failure`] if the scene has no reduced equations, or if they cannot be run.
    pub fn new(model: &Mechanism, scene: &Scene, watch: &WatchedInvariants) -> Result<Self, Failure> {
        let mut reduced = ReducedScene::new(model, scene)?;
        // Reduced equations are already solved for the accelerations, so that a numeric solve is not needed.
        reduced.scene.integration.solve = Some(AccelerationSolution::Eliminated);
        let code = reduced.code(model)?;
        let watch = (!scene.states_outputs).then_some(watch);
        let mut run = run_problem(&Problem::reduced(model, &reduced, scene, &code)?, watch)?;
        set_whole_model_energies(model, scene, &mut run)?;
        let course = watch.map(|watch| run.course(watch, scene, &code)).transpose()?;
        let costs = scene_costs(model, &reduced.reduction).map_err(|error| model.diagnose(&error))?;
        Ok(Self { needs: ReducedEquationsContent { reduced, costs }, run, course })
    }
}

/// Returns a state as numbers in double-double precision.
pub fn page_state_in_double_double(state: &[f64]) -> Vec<DoubleDouble> {
    state.iter().copied().map(DoubleDouble::from_f64).collect()
}

/// Returns the values of a scene's outputs along a run, with a list for each sample. A value is NaN if the states do
/// not determine the output.
pub fn page_run_outputs(compared: &ComparedQuantities, run: &Run) -> Vec<Vec<f64>> {
    if run.by.is_reduced() {
        return run.states.clone();
    }
    run.states
        .iter()
        .map(|state| {
            compared.quantities_of_state(&page_state_in_double_double(state)).iter().map(|x| x.to_f64()).collect()
        })
        .collect()
}
