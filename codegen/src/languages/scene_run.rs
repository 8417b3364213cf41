//! Start values and settings of a scene's run, for the simulation scripts written with the
//! equations.

use crate::model_folders::scenes_in_model_folder;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{Scene, load_scene_with_inputs};

/// Start values and settings of a scene's run, for a simulation script.
#[derive(Clone, Debug)]
pub struct SceneRun {
    /// Name of the scene's file without its extension.
    pub name: String,
    /// Values of the parameters, in the order of the model and in their units.
    pub parameters: Vec<f64>,
    /// Generalized coordinates at the start, in the order of the model and in their units.
    pub q: Vec<f64>,
    /// Generalized speeds at the start, in the order of the model and in their units.
    pub u: Vec<f64>,
    /// First and last time of the run, s.
    pub span: (f64, f64),
    /// Relative tolerance for the error of an integration step, without unit.
    pub rtol: f64,
}

impl SceneRun {
    /// Reads the run of the first scene of a model file. `None` if there is no scene or it has errors. `None` also
    /// for a scene that scripts cannot follow: one with impacts, terminal events or formulas for inputs.
    #[must_use]
    pub fn first_scene_run(model: &Model) -> Option<Self> {
        let place = scenes_in_model_folder(&model.source.path).into_iter().next()?;
        let mut bound = model.clone();
        let scene = load_scene_with_inputs(&Source::read(&place).ok()?, &mut bound).ok()?;
        Self::plain_scene_run(&scene, &bound)
    }

    /// Returns the run of a scene; `bound` is the model with which the scene was read. `None` for a scene that
    /// scripts cannot follow: one with impacts, terminal events or formulas for inputs.
    #[must_use]
    pub fn plain_scene_run(scene: &Scene, bound: &Model) -> Option<Self> {
        let ends_early = scene.events.iter().any(|event| event.terminal);
        let is_plain = bound.bindings.is_empty() && scene.impacts.is_empty() && !ends_early;
        is_plain.then(|| Self {
            name: scene.source.path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default(),
            parameters: scene.parameters.clone(),
            q: scene.q.clone(),
            u: scene.u.clone(),
            span: scene.span,
            rtol: scene.integration.rtol,
        })
    }
}
