//! Reduced equations of a scene on the page: their description, their run, and outputs for
//! comparison with the whole model.

use crate::failure::Failure;
use crate::page::Needs;
use tripos::trust::comparison::Compared;
use tripos::{Course, Mechanism, Problem, Reduced, Run, Watch, run_problem, whole_energies};
use tripos_codegen::plan::costs;
use tripos_derive::scene::{Scene, Solve};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// Reduced equations of a scene with their run, for the page.
pub struct Own {
    /// Reduced equations of the scene, with the numbers of operations of a call.
    pub needs: Needs,
    /// Run of the scene that integrates its reduced equations.
    pub run: Run,
    /// Watched quantities along the run; `None` if the reduced equations lack the states that these
    /// quantities need.
    pub course: Option<Course>,
}

impl Own {
    /// Derives the reduced equations of a scene and runs them.
    ///
    /// # Errors
    /// [`Failure`] if the scene has no reduced equations, or if they cannot be run.
    pub fn new(model: &Mechanism, scene: &Scene, watch: &Watch) -> Result<Self, Failure> {
        let mut reduced = Reduced::new(model, scene)?;
        // Reduced equations are already solved for the accelerations, so a numeric solve is not
        // needed.
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

/// Returns a state as numbers in double-double precision.
pub fn wide(state: &[f64]) -> Vec<DoubleDouble> {
    state.iter().copied().map(DoubleDouble::from_f64).collect()
}

/// Returns the values of a scene's outputs along a run, a list for each sample. A value is NaN if
/// the states do not determine the output.
pub fn shown(compared: &Compared, run: &Run) -> Vec<Vec<f64>> {
    if run.by.is_reduced() {
        return run.states.clone();
    }
    run.states.iter().map(|state| compared.of_state(&wide(state)).iter().map(|x| x.to_f64()).collect()).collect()
}
