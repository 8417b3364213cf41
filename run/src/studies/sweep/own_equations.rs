//! Reduced equations of a scene for the points of a sweep.
//!
//! Invariant: the values of a point alone decide by which reduced equations it runs. So a sweep divided into
//! shards gives the same rows.

use crate::code::Code;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::preparation::reduced_equations::{ReducedScene, reduced_code, scene_with_reduced_events};
use crate::preparation::reduced_start::ReducedStart;
use crate::trust::watched_functions::WatchedFunctions;
use std::sync::{Arc, Mutex, PoisonError};
use tripos_derive::mechanics::{EquationsOrigin, SingularDistance};
use tripos_derive::reduce::{Reduction, ReductionBasis};
use tripos_derive::scene::Scene;

/// Reduced equations of the scenes of a sweep. They differ only if the starts of points lie nearest to different
/// singular surfaces, or if points have other numbers in place of folded parameters.
pub struct OwnEquations<'a> {
    /// Mechanism of the scene, the same for all points.
    model: &'a Mechanism,
    /// Derived model from which all reductions are made.
    basis: ReductionBasis,
    /// Reductions that points have needed until now.
    known: Mutex<Vec<Arc<SharedReduction>>>,
}

/// Reduced equations that many points of a sweep share, ready to run.
pub struct SharedReduction {
    /// Derived equations of the reduced system, with their proof.
    reduction: Arc<Reduction>,
    /// Functions that compute the start of the equations from the start of a point.
    start: ReducedStart,
    /// Reduced equations, compiled or interpreted.
    pub code: Code,
    /// Events and domain conditions that each run watches.
    pub balance: WatchedFunctions,
    /// Choice of a frame with which the equations were derived.
    frame: FrameChoice,
    /// Distance from a singular surface that the scenes of the points state; `None` if they state none.
    stated_distance: Option<SingularDistance>,
}

/// Choice of the frame of reduced equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FrameChoice {
    /// Moving frame if it saves work; otherwise the inertial frame.
    MayMove,
    /// Inertial frame only.
    Inertial,
}

/// Scene of a point in the variables of its reduced equations.
pub struct OwnPoint {
    /// Equations of the point.
    pub shared: Arc<SharedReduction>,
    /// Scene of the point in the variables of the equations.
    reduced: ReducedScene,
}

impl<'a> OwnEquations<'a> {
    /// Prepares reduced equations for scenes of a model, from the derivation `basis` of this model.
    pub fn new(model: &'a Mechanism, basis: ReductionBasis) -> Self {
        Self { model, basis, known: Mutex::default() }
    }

    /// Writes the scene of a point in the variables of its reduced equations. The equations are derived if no
    /// earlier point needed the same ones. A start that cannot be moved to the section of a moving frame gets
    /// equations without a frame.
    ///
    /// # Errors
    /// [`Error`] if the scene has no reduced equations, or if their variables have no value at the start.
    pub fn point(&self, scene: &Scene) -> Result<OwnPoint, Error> {
        match self.point_with(scene, FrameChoice::MayMove) {
            Err(Error::Stopped(_)) => self.point_with(scene, FrameChoice::Inertial),
            point => point,
        }
    }

    /// Writes the scene of a point in the variables of reduced equations with this choice of a frame.
    fn point_with(&self, scene: &Scene, frame: FrameChoice) -> Result<OwnPoint, Error> {
        let shared = self.shared_reduction(scene, frame)?;
        let reduced = ReducedScene::from_start(Arc::clone(&shared.reduction), &shared.start, self.model, scene)?;
        Ok(OwnPoint { shared, reduced })
    }

    /// Finds or derives the reduced equations of a scene with this choice of a frame.
    fn shared_reduction(&self, scene: &Scene, frame: FrameChoice) -> Result<Arc<SharedReduction>, Error> {
        // Other threads wait here for a derivation, since they often need the same equations.
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.iter().find(|shared| shared.frame == frame && self.is_shared_by(shared, scene)) {
            return Ok(Arc::clone(found));
        }
        let reduction = match frame {
            FrameChoice::MayMove => self.basis.reduce(scene),
            FrameChoice::Inertial => self.basis.reduce_without_frame(scene),
        };
        let reduction = reduction.map_err(|error| self.model.diagnose(&error))?;
        let code = reduced_code(&reduction, self.model, scene)?;
        let watched = scene_with_reduced_events(&reduction, self.model, scene);
        let shared = Arc::new(SharedReduction {
            start: ReducedStart::new(&reduction, self.model, &scene.exact)?,
            balance: WatchedFunctions::new(self.model, &reduction.model, &watched, &EquationsOrigin::Reduced)?,
            frame,
            stated_distance: scene.integration.distance,
            reduction: Arc::new(reduction),
            code,
        });
        known.push(Arc::clone(&shared));
        Ok(shared)
    }

    /// True if the reduced equations of a scene are these: its start chooses the same singular surface, and its
    /// parameters have the numbers that the equations contain.
    fn is_shared_by(&self, shared: &SharedReduction, scene: &Scene) -> bool {
        let reduction = &shared.reduction;
        let place = |name: &str| self.model.parameters.iter().position(|p| p.name == name);
        let mut folded = reduction.folded.iter();
        shared.stated_distance == scene.integration.distance
            && reduction.surface.holds_for_start(&scene.q)
            && folded
                .all(|(name, value)| place(name).is_some_and(|at| scene.exact.rational[at].as_ref() == Some(value)))
    }
}

impl OwnPoint {
    /// Origin of the equations, always [`EquationsOrigin::Reduced`].
    pub fn by(&self) -> &EquationsOrigin {
        &self.reduced.by
    }

    /// Reason why the reduced equations are no gain over full equations; `None` if they are a gain.
    ///
    /// # Errors
    /// [`Error`] if Kane's equations cannot be derived for the model.
    pub fn reason_against_reduction(&self, model: &Mechanism) -> Result<Option<String>, Error> {
        self.reduced.reason_against_reduction(model)
    }

    /// Makes the problem of the point. `shown` is the scene of the point as a file would state it.
    ///
    /// # Errors
    /// [`Error::Request`] if the scene has contacts.
    pub fn problem<'s>(&'s self, model: &'s Mechanism, shown: &'s Scene) -> Result<Problem<'s>, Error> {
        Problem::reduced(model, &self.reduced, shown, &self.shared.code)
    }
}
