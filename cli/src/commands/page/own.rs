//! A scene's own equations on the page: what they are, their run, and what runs of whole equations show beside it.

use crate::failure::Failure;
use crate::page::Needs;
use tripos::trust::comparison::Compared;
use tripos::{Course, Mechanism, Problem, Reduced, Run, Watch, run_problem, whole_energies};
use tripos_codegen::plan::costs;
use tripos_derive::scene::{Scene, Solve};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// A scene's own equations, and their run.
pub struct Own {
    /// Reduced equations of the scene, and the cost of a call.
    pub needs: Needs,
    /// Run by these equations.
    pub run: Run,
    /// Watched quantities along the run, if it shows every state.
    pub course: Option<Course>,
}

impl Own {
    /// Derives and runs them.
    ///
    /// # Errors
    /// [`Failure`] if the scene has no equations of its own, or they cannot be run.
    pub fn new(model: &Mechanism, scene: &Scene, watch: &Watch) -> Result<Self, Failure> {
        let mut reduced = Reduced::new(model, scene)?;
        // They are solved: nothing is left to a numeric solve.
        reduced.scene.integration.solve = Some(Solve::Eliminated);
        let code = reduced.code(model)?;
        let watch = (!scene.states_outputs).then_some(watch);
        let mut run = run_problem(&Problem::reduced(model, &reduced, scene, &code)?, watch)?;
        whole_energies(model, scene, &mut run)?;
        let course = watch.map(|watch| run.course(watch, scene, &code)).transpose()?;
        let costs = costs(model, &reduced.reduction).map_err(|error| model.diagnose(&error))?;
        Ok(Self { needs: Needs { reduced, costs }, run, course })
    }
}

/// A state in twice its precision.
pub fn wide(state: &[f64]) -> Vec<DoubleDouble> {
    state.iter().copied().map(DoubleDouble::from_f64).collect()
}

/// Values of a scene's outputs along a run, sample by sample; NaN if whole states do not give an output.
pub fn shown(compared: &Compared, run: &Run) -> Vec<Vec<f64>> {
    if run.by.is_reduced() {
        return run.states.clone();
    }
    run.states.iter().map(|state| compared.of_state(&wide(state)).iter().map(|x| x.to_f64()).collect()).collect()
}
