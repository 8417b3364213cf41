//! Reduction of a scene's equations to the smallest system that gives its outputs. The equations
//! hold on the level set of the scene's momenta. Variables on which no output depends are left out.
//!
//! Every step is exact. Momenta of commuting symmetries remove speeds (`momentum_level`). A
//! variable on which no needed term depends by meaning is left out, and a constant replaces it in
//! formulas (`slice`). Variables that a symmetry moves together become differences (`differences`).
//! Quantities that can be computed from the states are computed on request.
//!
//! The result is an ordinary model with equations, and the momenta are among its parameters. So
//! every program that runs, plots and emits equations accepts it. A reduction contains no start
//! values: it holds for every start on every level set. The exception is the distance from a
//! singular surface, because the start decides its side.

mod basis;
mod frames;
mod levels;
mod result;
mod slices;

pub use basis::prose::{Piece, Prose};
pub use basis::reduction_basis::ReductionBasis;
pub use result::reduction::{MovingFrame, Omission, ReducedOutput, ReducedQuantity, Reduction};
pub use result::reduction_proof::{Reconstruction, ReductionProof};
pub use result::surface_choice::SurfaceChoice;
pub use slices::potential_difference::PotentialDifference;

use crate::mechanics::{DeriveError, check_inertia_at};
use crate::model::Model;
use crate::scene::Scene;
use basis::search_work::SearchWork;
use frames::frame_search::FrameAndMomenta;
use result::reduction_proof::WholeModel;
use slices::slice::Slice;
use slices::wanted_outputs::WantedOutputs;
use std::cmp::Reverse;

/// Derives the reduced equations of a scene of a model.
///
/// # Errors
/// [`DeriveError`] in three cases. The model's own equations cannot be derived. The model has loops
/// or no speeds. An output needs a reaction that the equations do not determine.
///
/// [`DeriveError::ReductionNotProved`] if no choice of momenta is proved to give the scene's
/// outputs, not even the equations without constant momenta.
pub fn reduce(model: &Model, scene: &Scene) -> Result<Reduction, DeriveError> {
    ReductionBasis::new(model)?.reduce(scene)
}

/// Choice of the frames in which a reduction may write its equations.
#[derive(Clone, Copy)]
enum FrameChoice {
    /// Moving frame if it saves work; otherwise the inertial frame.
    MayMove,
    /// Inertial frame only, without a search for a moving frame.
    Inertial,
}

impl ReductionBasis {
    /// Derives the reduced equations of a scene of the model from which this basis was made.
    ///
    /// # Errors
    /// [`DeriveError`], for the same reasons as [`reduce`].
    pub fn reduce(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.reduce_with(scene, FrameChoice::MayMove)
    }

    /// Derives the reduced equations of a scene without a moving frame. Their variables are functions
    /// of the model's variables.
    ///
    /// # Errors
    /// [`DeriveError`], for the same reasons as [`reduce`].
    pub fn reduce_without_frame(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.reduce_with(scene, FrameChoice::Inertial)
    }

    /// Derives the reduced equations with the best choice of constant momenta and, if allowed, of a
    /// moving frame. Returns them only if they are proved.
    fn reduce_with(&self, scene: &Scene, frame: FrameChoice) -> Result<Reduction, DeriveError> {
        self.check_is_reducible()?;
        let mut basis = self.clone();
        check_inertia_at(&self.arena, &self.kane, &self.model, &scene.exact.rational)?;
        basis.fix_parameters_of_basis(scene);
        let wanted = basis.wanted(scene)?;
        let mut best: Option<(ReductionCost, Vec<usize>)> = None;
        let choices = basis.commuting_momenta_of_basis();
        // A single choice needs no comparison. Choices with more constant momenta are tried first:
        // they are best in most cases, and the work is limited.
        let mut compared = if choices.len() > 1 { choices.clone() } else { Vec::new() };
        compared.sort_by_key(|momenta| Reverse(momenta.len()));
        let mut work = SearchWork::default();
        for momenta in compared {
            if work.is_search_work_used_up() {
                break;
            }
            let mut trial = basis.clone();
            let weight = trial.reduction_cost(&momenta, &wanted);
            work.add(&trial, &basis);
            if let Some(weight) = weight
                && best.as_ref().is_none_or(|(least, _)| weight < *least)
            {
                best = Some((weight, momenta));
            }
        }
        let momenta = best.map(|(_, momenta)| momenta).unwrap_or_default();
        let mut framed = basis.clone();
        let framing = match frame {
            FrameChoice::MayMove => framed.find_frame(&wanted, &choices, &momenta, &mut work),
            FrameChoice::Inertial => None,
        };
        // Without a frame, the terms that the search created are dropped. So the equations are
        // written as if there had been no search.
        match framing {
            Some(_) => basis = framed,
            None => basis.kept_by_domain = framed.kept_by_domain,
        }
        let whole = WholeModel { kane: basis.kane.clone(), wanted };
        let plain = |momenta| FrameAndMomenta { momenta, ..FrameAndMomenta::default() };
        // If a choice is not proved, the next one is tried. Without a frame, and then without
        // momenta, there is less to prove.
        let tried = framing.into_iter().chain([plain(momenta), plain(Vec::new())]);
        let mut found = Err(String::new());
        for choice in tried {
            found = basis.clone().reduce_on_level(&choice, &whole, scene);
            if found.is_ok() {
                break;
            }
        }
        found.map_err(|what| DeriveError::ReductionNotProved { what })
    }

    /// Cost of the reduced equations with the given momenta constant; `None` if the equations are
    /// not determined.
    fn reduction_cost(&mut self, momenta: &[usize], wanted: &WantedOutputs) -> Option<ReductionCost> {
        let wanted = self.replace_by_differences(momenta, wanted.clone());
        let level = self.equations_on_momentum_level(momenta, None)?;
        let (core, integrated, operations) = Slice::new(self, &level, &wanted)?.slice_cost(self);
        // Among equal costs the choice with more constant momenta is better: then the energy is
        // more often a function of the remaining variables.
        Some((core, integrated, operations, Reverse(momenta.len())))
    }

    /// Derives the reduced equations of a scene without constant momenta. Their only divisors are those
    /// of the model's own equations.
    ///
    /// # Errors
    /// [`DeriveError`], for the same reasons as [`reduce`].
    pub fn reduce_without_momenta(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.check_is_reducible()?;
        let mut basis = self.clone();
        basis.fix_parameters_of_basis(scene);
        let wanted = basis.wanted(scene)?;
        let whole = WholeModel { kane: basis.kane.clone(), wanted };
        basis
            .reduce_on_level(&FrameAndMomenta::default(), &whole, scene)
            .map_err(|what| DeriveError::ReductionNotProved { what })
    }

    /// Checks that the model has speeds and no loops, which reductions need.
    fn check_is_reducible(&self) -> Result<(), DeriveError> {
        match self.model.loops.first() {
            Some(one) => Err(DeriveError::LoopsReduced { name: one.name.clone() }),
            None if self.model.speeds.is_empty() => Err(DeriveError::NothingMoves),
            None => Ok(()),
        }
    }

    /// Derives and proves the reduced equations for a choice of momenta and a frame.
    ///
    /// # Errors
    /// Text of the statement that could not be proved.
    fn reduce_on_level(
        mut self,
        choice: &FrameAndMomenta,
        whole: &WholeModel,
        scene: &Scene,
    ) -> Result<Reduction, String> {
        let momenta = &choice.momenta;
        let wanted = self.differences(choice, &whole.wanted);
        let wanted = self.write_in_frame_choice(choice, wanted).ok_or("that the frame is determined")?;
        // The equations are rewritten in the distance from the singular surface of this choice,
        // unless they are in a moving frame.
        let mut trial = self.clone();
        let level = if self.frame.is_some() { None } else { trial.equations_on_momentum_level(momenta, None) };
        let place = level.map(|level| trial.choose_singular_surface(&level, &wanted, scene)).unwrap_or_default();
        let (surface, wanted) = match place.chosen {
            Some(place) => {
                let (surface, wanted) = self.write_in_distance_from_surface(place, &wanted);
                (Some(surface), wanted)
            }
            None => (None, wanted),
        };
        let level =
            self.equations_on_momentum_level(momenta, surface.as_ref()).ok_or("that the momenta determine speeds")?;
        let flow = Slice::new(&mut self, &level, &wanted).ok_or("that the accelerations are determined")?;
        let reduction = result::pack_reduction::pack_reduction(self, whole, &level, flow, scene)?;
        Ok(Reduction { surface: place, ..reduction })
    }
}

/// Cost of a choice of momenta: numbers of states, of integrated variables and of operations, then
/// the number of constant momenta. Choices are compared in this order; more constant momenta are
/// better.
type ReductionCost = (usize, usize, usize, Reverse<usize>);
