//! Number types in which a run with contacts is computed: plain doubles, or numbers with derivatives
//! ("slopes").
//!
//! The values alone decide which contacts close, push and open. The slopes accompany the values and
//! decide nothing.

use super::contact_change::ContactChange;
use super::contact_impacts::StateAfterImpact;
use super::held_contact_motion::HeldContactEquations;
use super::held_contacts::HeldContacts;
use super::scene_contacts::SceneContacts;
use tripos_sim::{RightHandSide, SimError};

/// Function that makes the right-hand side of the equations of motion, without contact forces. Each
/// call makes a new right-hand side.
pub type Equations<'a> = dyn Fn() -> Result<Box<dyn RightHandSide<f64> + 'a>, SimError> + 'a;

/// Instant of a run at which velocities jump or the set of held contacts changes, with the states just
/// before and after it.
pub struct ContactCrossing<'c> {
    /// Instant of the crossing, s.
    pub t: f64,
    /// Change of a contact that ended the part of the run before the crossing; `None` at the start of
    /// the run.
    pub contact_change: Option<ContactChange>,
    /// Values of the state (q, v) just before the crossing.
    pub before: &'c [f64],
    /// Contacts that were held closed before the crossing, each with its mode, such as sticking.
    pub kept: &'c HeldContacts,
    /// State just after the crossing. It contains the impact, if there was one, and the contacts that
    /// are held closed from then on.
    pub after: &'c StateAfterImpact,
}

/// Minimum in time of a contact's gap that stays open but comes close to zero.
#[derive(Clone, Debug, PartialEq)]
pub struct GapMinimum {
    /// Index of the contact in the scene, from 0.
    pub contact: usize,
    /// Instant of the minimum, s.
    pub t: f64,
    /// State (q, v) at the minimum of the gap.
    pub y: Vec<f64>,
}

/// Operations that a run with contacts needs for the number type `S` in which it is computed.
pub trait NumberCarrier<S> {
    /// Makes the right-hand side of the equations of motion, with the forces of the held contacts
    /// `kept`.
    ///
    /// # Errors
    /// [`SimError`] if the right-hand side cannot be made.
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<S> + 'e>, SimError>;

    /// Receives the instant, s, at which a step of the run ends. The last step of a part of the run is
    /// not reported.
    fn record_step_end(&self, _t: f64) {}

    /// Largest minimum of an open gap that is reported, relative to the size of the gap's terms. `None`
    /// if no minima are reported.
    fn reported_gap_limit(&self) -> Option<f64> {
        None
    }

    /// Receives a minimum of an open gap that is below the limit [`Self::reported_gap_limit`]. Beyond
    /// such a minimum, the derivatives of the run may not exist.
    fn record_gap_minimum(&self, _approach: &GapMinimum) {}

    /// Returns the state just after a crossing. `before` is the state just before it. The result has
    /// slopes if the numbers of `before` have them.
    fn state_after_crossing(&self, crossing: &ContactCrossing<'_>, before: &[S]) -> Vec<S>;
}

/// Carrier of plain doubles, which have no derivatives.
pub struct DoubleCarrier<'a> {
    /// Contacts of the scene, prepared for the integrated variables.
    pub contacts: &'a SceneContacts<'a>,
    /// Function that makes the right-hand side of the equations of motion without contact forces.
    pub equations: &'a Equations<'a>,
}

impl NumberCarrier<f64> for DoubleCarrier<'_> {
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<f64> + 'e>, SimError> {
        Ok(Box::new(HeldContactEquations { rhs: (self.equations)()?, contacts: self.contacts, kept }))
    }

    fn state_after_crossing(&self, crossing: &ContactCrossing<'_>, _: &[f64]) -> Vec<f64> {
        crossing.after.y.clone()
    }
}
