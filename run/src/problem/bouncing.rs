//! Runs of scenes with contacts.

use super::{Power, Problem};
use crate::error::Error;
use crate::impacts::{Bouncing, Contacts, LEAST};
use tripos_derive::Formulation;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{QUADRATURE, Scene};
use tripos_sim::{Event, Options, SimError, Solution};

impl Problem<'_> {
    /// The run by parts, from impact to impact.
    pub(super) fn bouncing(
        &self,
        (span, y0): ((f64, f64), &[f64]),
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Solution, SimError> {
        let in_rates = self.by.formulation().is_some_and(Formulation::is_in_rates);
        let of = (self.system(), self.scene.parameters.as_slice());
        let contacts = Contacts::new(self.model, &self.scene.impacts, of, in_rates);
        let least = LEAST * span.0.abs().max(span.1.abs());
        let equations = || self.right_hand_side();
        let bouncing = Bouncing { contacts: &contacts, equations: &equations, least };
        bouncing.solve((span, y0), options, events, power)
    }
}

/// Refuses to run a scene with contacts as it cannot be run.
///
/// # Errors
/// [`Error::Request`] where contacts are no part of how the scene is to be run, and what to do instead.
pub(super) fn check(scene: &Scene, by: &By) -> Result<(), Error> {
    let how = &scene.integration;
    let (what, help) = if scene.impacts.is_empty() {
        return Ok(());
    } else if by.printed_id().is_some() {
        ("printed equations have no impacts", "run derived ones, such as --by kane")
    } else if how.method == QUADRATURE {
        ("no motion by quadrature with impacts: what it integrates is smooth", "give a stepping method, such as dop853")
    } else if by.is_reduced() {
        ("what a scene's own equations hold constant changes in impacts", "run the whole equations: name no others")
    } else if how.project.is_some() {
        ("impacts take energy: no projection onto that of the start", "leave `project` out")
    } else if how.distance.is_some() {
        ("impacts are not computed in a coordinate's distance", "leave `distance` out")
    } else if scene.span.1 < scene.span.0 {
        ("an impact cannot be undone, and this run goes back in time", "end the span after its start")
    } else {
        return Ok(());
    };
    Err(Error::request(what, help))
}
