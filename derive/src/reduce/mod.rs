//! The least system that gives the outputs of a scene: equations of motion on the level set of its momenta, without
//! variables on which no output depends.
//!
//! Every step is exact. Momenta of commuting symmetries take speeds out (`level`). A variable on which nothing depends
//! by meaning is left out and replaced by a constant where a formula mentions it (`slice`). Variables that a symmetry
//! moves together become differences (`relative`). Quantities that follow from the rest are computed when they are
//! requested. The result is a model and equations as any others, with the momenta among the parameters, so that every
//! program that runs, charts and emits equations accepts it.
//!
//! Absent on purpose: numbers of the start. A reduction holds for every start on every level set, except the distance
//! from a singular surface, whose side the start decides.

mod basis;
mod frames;
mod levels;
mod result;
mod slices;

pub use basis::ground::Ground;
pub use basis::prose::{Piece, Prose};
pub use result::proof::Proof;
pub use result::reduction::{Omission, Output, Quantity, Reduction, Turned};
pub use slices::one_degree::Slope;

use crate::mechanics::{DeriveError, has_inertia_at};
use crate::model::Model;
use crate::scene::Scene;
use basis::work::Work;
use frames::framing::Choice;
use result::proof::Whole;
use slices::outputs::Wanted;
use slices::slice::Flow;
use std::cmp::Reverse;

/// Derives the reduced system of a scene of this model.
///
/// # Errors
/// [`DeriveError`] if the model's own equations cannot be derived, or an output needs a reaction that they do not
/// determine; [`DeriveError::ReductionNotProved`] if even the system without momenta cannot be proved to give the
/// scene's outputs.
pub fn reduce(model: &Model, scene: &Scene) -> Result<Reduction, DeriveError> {
    Ground::new(model)?.reduce(scene)
}

impl Ground {
    /// The reduced system of a scene of the model that this was made from.
    ///
    /// # Errors
    /// As [`reduce`].
    pub fn reduce(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.reduce_with(scene, true)
    }

    /// The reduced system of a scene in no moving frame: its variables are functions of the model's.
    ///
    /// # Errors
    /// As [`reduce`].
    pub fn reduce_without_frame(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.reduce_with(scene, false)
    }

    fn reduce_with(&self, scene: &Scene, may_turn: bool) -> Result<Reduction, DeriveError> {
        self.has_motion_of_its_own()?;
        let mut ground = self.clone();
        has_inertia_at(&self.arena, &self.kane, &self.model, &scene.exact.rational)?;
        ground.fold(scene);
        let wanted = ground.wanted(scene)?;
        let mut best: Option<(Weight, Vec<usize>)> = None;
        let choices = ground.choices();
        // With one choice there is nothing to compare. Choices that hold most momenta come first: they are most often
        // the best, and work is bounded.
        let mut compared = if choices.len() > 1 { choices.clone() } else { Vec::new() };
        compared.sort_by_key(|momenta| Reverse(momenta.len()));
        let mut work = Work::default();
        for momenta in compared {
            if work.is_done() {
                break;
            }
            let mut trial = ground.clone();
            let weight = trial.weight_on(&momenta, &wanted);
            work.add(&trial, &ground);
            if let Some(weight) = weight
                && best.as_ref().is_none_or(|(least, _)| weight < *least)
            {
                best = Some((weight, momenta));
            }
        }
        let momenta = best.map(|(_, momenta)| momenta).unwrap_or_default();
        let mut framed = ground.clone();
        let framing = if may_turn { framed.framing(&wanted, &choices, &momenta, &mut work) } else { None };
        // Without a frame nothing of the search for one stays, so that equations are written as they were.
        match framing {
            Some(_) => ground = framed,
            None => ground.kept_by_domain = framed.kept_by_domain,
        }
        let whole = Whole { kane: ground.kane.clone(), wanted };
        let plain = |momenta| Choice { momenta, ..Choice::default() };
        // What is not proved is not used. Without a frame, and without momenta, there is less to prove.
        let tried = framing.into_iter().chain([plain(momenta), plain(Vec::new())]);
        let mut found = Err(String::new());
        for choice in tried {
            found = ground.clone().on_level(&choice, &whole, scene);
            if found.is_ok() {
                break;
            }
        }
        found.map_err(|what| DeriveError::ReductionNotProved { what })
    }

    /// Cost of the equations on the level set of these momenta; `None` if they are not determined.
    fn weight_on(&mut self, momenta: &[usize], wanted: &Wanted) -> Option<Weight> {
        let wanted = self.relative(momenta, wanted.clone());
        let level = self.level(momenta, None)?;
        let (core, integrated, operations) = Flow::new(self, &level, &wanted)?.weight(self);
        // Of equal ones the choice that holds most: then the energy, too, is a function of what is kept.
        Some((core, integrated, operations, Reverse(momenta.len())))
    }

    /// The system of a scene that holds no momenta: its only divisors are those of the model's own equations.
    ///
    /// # Errors
    /// As [`reduce`].
    pub fn reduce_without_momenta(&self, scene: &Scene) -> Result<Reduction, DeriveError> {
        self.has_motion_of_its_own()?;
        let mut ground = self.clone();
        ground.fold(scene);
        let wanted = ground.wanted(scene)?;
        let whole = Whole { kane: ground.kane.clone(), wanted };
        ground.on_level(&Choice::default(), &whole, scene).map_err(|what| DeriveError::ReductionNotProved { what })
    }

    fn has_motion_of_its_own(&self) -> Result<(), DeriveError> {
        match self.model.loops.first() {
            Some(one) => Err(DeriveError::LoopsReduced { name: one.name.clone() }),
            None if self.model.speeds.is_empty() => Err(DeriveError::NothingMoves),
            None => Ok(()),
        }
    }

    /// The reduced system on the level set of these momenta, in this frame.
    fn on_level(mut self, choice: &Choice, whole: &Whole, scene: &Scene) -> Result<Reduction, String> {
        let momenta = &choice.momenta;
        let wanted = self.differences(choice, &whole.wanted);
        let wanted = self.framed_by(choice, wanted).ok_or("that the frame is determined")?;
        // The equations are written anew in the distance from the singular surface of this choice; those in a frame
        // stay unchanged.
        let mut trial = self.clone();
        let place = if self.frame.is_some() { None } else { Some(()) };
        let place =
            place.and_then(|()| trial.level(momenta, None)).and_then(|level| trial.surface(&level, &wanted, scene));
        let (surface, wanted) = match place {
            Some(place) => {
                let (surface, wanted) = self.measure_from(place, &wanted);
                (Some(surface), wanted)
            }
            None => (None, wanted),
        };
        let level = self.level(momenta, surface.as_ref()).ok_or("that the momenta determine speeds")?;
        let flow = Flow::new(&mut self, &level, &wanted).ok_or("that the accelerations are determined")?;
        result::pack::pack(self, whole, &level, flow, scene)
    }
}

/// Criteria by which choices of momenta are compared: numbers of states, of integrated variables, of operations and of
/// held momenta.
type Weight = (usize, usize, usize, Reverse<usize>);
