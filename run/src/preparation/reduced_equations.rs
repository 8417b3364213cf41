//! Reduced equations of a scene, ready to run: the smallest system that gives all outputs of the
//! scene.

use super::reduced_start::ReducedStart;
use crate::code::{Code, CodePreparation, compiled_scene_code, interpreted_scene_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use std::sync::Arc;
use tripos_codegen::plan::{Costs, scene_costs};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::reduce::{ReducedQuantity, Reduction, ReductionBasis};
use tripos_derive::scene::{ExactStart, InitialMotion, Scene, SceneEvent};
use tripos_traits::{AbsoluteTolerance, DoubleDouble};

/// Reduced equations of motion of a scene, with the scene in the variables of these equations.
pub struct ReducedScene {
    /// Derived equations of the reduced system, with their proof. Scenes that differ only in their numbers may share
    /// them.
    pub reduction: Arc<Reduction>,
    /// Scene in the variables of the reduced model. The constant momenta are among its parameters.
    pub scene: Scene,
    /// Origin of the equations, always [`EquationsOrigin::Reduced`].
    pub by: EquationsOrigin,
}

impl ReducedScene {
    /// Derives the reduced equations of a scene of a model.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, or does not determine an output of the scene.
    pub fn new(model: &Model, scene: &Scene) -> Result<Self, Error> {
        let basis = ReductionBasis::new(model).map_err(|error| model.diagnose(&error))?;
        Self::from_basis(&basis, model, scene)
    }

    /// Derives the reduced equations of a scene from the prepared basis of its model. If the start
    /// cannot be moved to the section of the moving frame, the equations are derived without a frame.
    ///
    /// # Errors
    /// [`Error`] if the model does not determine an output of the scene.
    pub fn from_basis(basis: &ReductionBasis, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = basis.reduce(scene).map_err(|error| model.diagnose(&error))?;
        let turns = reduction.frame.is_some();
        match Self::from_reduction(reduction, model, scene) {
            // Some starts cannot be moved to the section of the moving frame (the states that the frame
            // represents).
            Err(Error::Stopped(_)) if turns => {
                let plain = basis.reduce_without_frame(scene).map_err(|error| model.diagnose(&error))?;
                Self::from_reduction(plain, model, scene)
            }
            found => found,
        }
    }

    /// Derives the reduced equations of a scene without constant momenta. The equations are singular
    /// only in states where the model's own equations are singular.
    ///
    /// # Errors
    /// [`Error`] if the model does not determine an output of the scene, or if a reduced variable has no
    /// value at the start.
    pub fn without_momenta(basis: &ReductionBasis, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = basis.reduce_without_momenta(scene).map_err(|error| model.diagnose(&error))?;
        Self::from_reduction(reduction, model, scene)
    }

    /// Makes the reduced equations of a scene from a reduction that was derived for another scene. The
    /// scenes may differ only in their numbers: model, outputs, events and names of parameters are the
    /// same.
    ///
    /// # Errors
    /// [`Error::Request`] if a variable depends on a symbol that has no value at the start;
    /// [`Error::Stopped`] if the start cannot be moved to the section of the moving frame.
    pub fn from_reduction(reduction: impl Into<Arc<Reduction>>, model: &Model, scene: &Scene) -> Result<Self, Error> {
        let reduction = reduction.into();
        let start = ReducedStart::new(&reduction, model, &scene.exact)?;
        Self::from_start(reduction, &start, model, scene)
    }

    /// Makes the reduced equations of a scene from a shared reduction and its compiled start. The scenes may differ
    /// only in their numbers.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the start cannot be moved to the section of the moving frame.
    pub(crate) fn from_start(
        reduction: Arc<Reduction>,
        start: &ReducedStart,
        model: &Model,
        scene: &Scene,
    ) -> Result<Self, Error> {
        let [parameters, q, v] = start.evaluate(&scene.exact)?;
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<_>>();
        let own = Scene {
            parameters: doubles(&parameters),
            q: doubles(&q),
            u: doubles(&v),
            exact: ExactStart {
                rational: vec![None; parameters.len()],
                parameters,
                q,
                motion: InitialMotion::Speeds(v),
            },
            ..scene_with_reduced_events(&reduction, model, scene)
        };
        Ok(Self { reduction, scene: own, by: EquationsOrigin::Reduced })
    }

    /// Makes the reduced equations ready to run. They are compiled if the program contains code that
    /// was generated from the same reduction. Otherwise they are interpreted.
    ///
    /// # Errors
    /// [`Error`] if the equations cannot be compiled to tapes.
    pub fn code(&self, mechanism: &Mechanism) -> Result<Code, Error> {
        reduced_code(&self.reduction, mechanism, &self.scene)
    }

    /// Returns the reason why the reduced equations are no gain over the full equations; `None` if they
    /// are a gain. Either impacts change the constants of the motion, or the reduced equations have as
    /// many variables and cost at least as much per evaluation.
    ///
    /// # Errors
    /// [`Error`] if Kane's equations cannot be derived for the model.
    pub fn reason_against_reduction(&self, model: &Model) -> Result<Option<String>, Error> {
        if !self.scene.impacts.is_empty() {
            return Ok(Some("impacts change what reduced equations hold constant".to_owned()));
        }
        let whole = model.coordinates.len() + model.speeds.len();
        if self.reduction.states.len() + self.reduction.quadratures.len() < whole {
            return Ok(None);
        }
        let Costs { full, scene } = scene_costs(model, &self.reduction).map_err(|error| model.diagnose(&error))?;
        Ok((scene.weight() >= full.weight()).then(|| {
            format!(
                "the scene's reduced equations carry all {whole} variables and take {scene} a call, the whole ones {full}"
            )
        }))
    }

    /// Constants of the motion that the reduction uses, each with its value in this scene.
    pub fn constants(&self) -> impl Iterator<Item = (&ReducedQuantity, f64)> {
        let first = self.scene.parameters.len() - self.reduction.constants.len();
        self.reduction.constants.iter().zip(self.scene.parameters[first..].iter().copied())
    }
}

/// Makes the reduced equations of a scene ready to run: compiled if the program contains code that was generated from
/// the same reduction, otherwise interpreted.
///
/// # Errors
/// `Error` if the equations cannot be compiled to tapes.
pub(crate) fn reduced_code(reduction: &Reduction, mechanism: &Mechanism, scene: &Scene) -> Result<Code, Error> {
    match compiled_scene_code(mechanism, reduction, CodePreparation::preparation_for_runs(scene)) {
        Some(code) => Ok(code),
        None => interpreted_scene_code(reduction),
    }
}

/// Returns a scene whose events and tolerances are in the variables of its reduced equations. The parameters and the
/// start are still those of the whole model.
pub(crate) fn scene_with_reduced_events(reduction: &Reduction, model: &Model, scene: &Scene) -> Scene {
    let mut integration = scene.integration.clone();
    integration.distance = None;
    if let AbsoluteTolerance::Each(each) = &integration.atol {
        integration.atol = AbsoluteTolerance::Each(reduced_tolerances(reduction, model, each));
    }
    let events = scene.events.iter().zip(&reduction.events);
    let events = events.map(|(event, function)| SceneEvent { function: *function, ..event.clone() }).collect();
    Scene { integration, ladder: None, events, ..scene.clone() }
}

/// Absolute tolerances of the reduced variables, each in its own unit. A reduced variable is computed
/// from coordinates and speeds of the whole model, and gets the least of their tolerances. `each` are
/// the tolerances of the coordinates and speeds.
fn reduced_tolerances(reduction: &Reduction, model: &Model, each: &[f64]) -> Vec<f64> {
    let arena = reduction.arena();
    let own: Vec<_> = model.q().into_iter().chain(model.u()).collect();
    let equations = &reduction.derivation.equations;
    let all = || reduction.states.iter().chain(&reduction.quadratures);
    let of = |symbol: &Expr| {
        let start = all().find(|q| q.symbol == *symbol).map_or(*symbol, |q| q.of_start);
        let mentioned = own.iter().zip(each).filter(|(e, _)| arena.mentions(start, **e)).map(|(_, x)| *x);
        mentioned.fold(f64::INFINITY, f64::min)
    };
    equations.coordinates.iter().chain(&equations.variables).map(of).collect()
}
