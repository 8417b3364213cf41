//! Runs of a problem whose scene has contacts, and the refusal of equations that do not allow
//! contacts.

use super::{Power, Problem};
use crate::error::Error;
use crate::preparation::impacts::{
    ContactRun, DoubleCarrier, HeldContactEquations, HeldContacts, LEAST, NumberCarrier, SceneContacts,
};
use crate::preparation::initial_state::InitialState;
use tripos_derive::mechanics::{EquationsOrigin, MotionVariables};
use tripos_derive::scene::{Integrator, Scene};
use tripos_sim::{Event, Failure, Options, RightHandSide, SimError, Solution};
use tripos_traits::Real;

impl Problem<'_> {
    /// Prepares the contacts of the scene in the coordinates and motion variables of the equations.
    #[must_use]
    pub(crate) fn contacts(&self) -> SceneContacts<'_> {
        let variables = self.by.formulation().map_or(MotionVariables::Speeds, |by| by.method().variables);
        SceneContacts::new(self.model, &self.scene.impacts, self.system(), &self.scene.parameters, variables)
    }

    /// Runs a scene with contacts in double precision, in parts from impact to impact.
    ///
    /// # Errors
    /// `SimError` if the options or the start do not fit the equations.
    pub(super) fn run_with_contacts(
        &self,
        start: InitialState<'_>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Solution, SimError> {
        let contacts = self.contacts();
        let equations = || self.right_hand_side();
        let doubles = DoubleCarrier { contacts: &contacts, equations: &equations };
        self.run_with_contacts_in(&contacts, &doubles, start, options, events, power)
    }

    /// Runs a scene with contacts in parts from impact to impact. `carrier` integrates the parts in its
    /// number type `S`.
    ///
    /// # Errors
    /// [`SimError`] if the options or the start do not fit the equations.
    pub(crate) fn run_with_contacts_in<S: Real>(
        &self,
        contacts: &SceneContacts<'_>,
        carrier: &dyn NumberCarrier<S>,
        start: InitialState<'_, S>,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Solution<S>, SimError> {
        let span = start.span;
        let least = LEAST * span.0.abs().max(span.1.abs());
        let equations = || self.right_hand_side();
        let bouncing = ContactRun { contacts, equations: &equations, least };
        bouncing.run_with_impacts(carrier, start, options, events, power)
    }

    /// Computes the rate of the integrated state, dy/dt, while the contacts in `kept` remain closed.
    ///
    /// # Errors
    /// [`Failure`] if the equations or the contact forces have no value at this state.
    pub(crate) fn rates_with_contacts(
        &self,
        contacts: &SceneContacts<'_>,
        kept: &HeldContacts,
        t: f64,
        y: &[f64],
    ) -> Result<Vec<f64>, Failure> {
        let unknown = |error: SimError| Failure { code: "not-finite", message: error.to_string() };
        let mut rhs = HeldContactEquations { rhs: self.right_hand_side().map_err(unknown)?, contacts, kept };
        let mut rates = vec![0.0; y.len()];
        rhs.rhs(t, y, &mut rates)?;
        Ok(rates)
    }
}

/// Checks that the equations and the way of integration allow contacts, if the scene has any.
///
/// # Errors
/// [`Error::Request`] with advice if the scene has contacts and they are not allowed.
pub(super) fn check_contacts_allowed(scene: &Scene, by: &EquationsOrigin) -> Result<(), Error> {
    let how = &scene.integration;
    let (what, help) = if scene.impacts.is_empty() {
        return Ok(());
    } else if by.printed_id().is_some() {
        ("printed equations have no impacts", "run derived ones, such as --by kane")
    } else if how.method == Integrator::Quadrature {
        ("no motion by quadrature with impacts: what it integrates is smooth", "give a stepping method, such as dop853")
    } else if by.is_reduced() {
        ("what a scene's reduced equations hold constant changes in impacts", "run the full equations: name no others")
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
