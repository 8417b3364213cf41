//! Run of a scene, for the scripts that dialects write beside the equations.

use crate::scene_files::scene_files;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{Scene, load_bound};

/// Run of the first scene of a model.
#[derive(Clone, Debug)]
pub struct SceneRun {
    /// Name of the scene's file without its ending.
    pub name: String,
    /// Values of the parameters, in the order of the model.
    pub parameters: Vec<f64>,
    /// Values of the coordinates at the start.
    pub q: Vec<f64>,
    /// Values of the generalized speeds at the start.
    pub u: Vec<f64>,
    /// First and last instant, s.
    pub span: (f64, f64),
    /// Relative tolerance of a step.
    pub rtol: f64,
}

impl SceneRun {
    /// Run of the first scene beside a model file. `None` if there is no scene, if the scene has impacts or gives
    /// formulas to inputs, which no script can follow, or if it has errors, which every command on the scene reports.
    #[must_use]
    pub fn first(model: &Model) -> Option<Self> {
        let place = scene_files(&model.source.path).into_iter().next()?;
        let mut bound = model.clone();
        let scene = load_bound(&Source::read(&place).ok()?, &mut bound).ok()?;
        Self::of(&scene, &bound)
    }

    /// Run of a scene with the model that it was read with; `None` as for [`Self::first`].
    #[must_use]
    pub fn of(scene: &Scene, bound: &Model) -> Option<Self> {
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
