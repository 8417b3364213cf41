//! Kinds of numbers in which a run with contacts is computed: plain doubles, or numbers with slopes.
//!
//! Values alone decide which contacts close, push and open. Slopes accompany the values and decide nothing.

use super::contact_change::ContactChange;
use super::contacts::Contacts;
use super::held_contacts::HeldContacts;
use super::held_motion::Held;
use super::meeting::After;
use tripos_sim::{RightHandSide, SimError};

/// Function that makes the equations of a run, anew for each use.
pub type Equations<'a> = dyn Fn() -> Result<Box<dyn RightHandSide<f64> + 'a>, SimError> + 'a;

/// A state at which velocities jump, or from which contacts are held or released.
pub struct Crossing<'c> {
    /// Instant of the crossing, s.
    pub t: f64,
    /// Change of a contact that caused the crossing; `None` at the start of the run.
    pub contact_change: Option<ContactChange>,
    /// Values of the state just before the crossing.
    pub before: &'c [f64],
    /// Contacts that were held before the crossing, each with its mode.
    pub kept: &'c HeldContacts,
    /// State after the event, with the impact and the contacts that are closed after it.
    pub after: &'c After,
}

/// A minimum of a gap that stays open but comes close to zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// Index of the contact whose gap has the minimum.
    pub contact: usize,
    /// Instant of the minimum, s.
    pub t: f64,
    /// State at the minimum.
    pub y: Vec<f64>,
}

/// Operations that a run with contacts needs of the numbers in which it is computed.
pub trait Carrier<S> {
    /// Makes the equations of motion with the forces of the held contacts `kept`.
    ///
    /// # Errors
    /// [`SimError`] if the equations of motion cannot be made.
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<S> + 'e>, SimError>;

    /// Receives the instant, s, at which each step inside a part of the run ends, except the last step.
    fn stepped(&self, _t: f64) {}

    /// Gap below which a minimum of the gap is reported, relative to the size of the gap's terms. `None` if no minima
    /// are reported.
    fn near(&self) -> Option<f64> {
        None
    }

    /// Receives a minimum of an open gap that is below [`Self::near`]. Derivatives of the run may end at that instant.
    fn nears(&self, _approach: &Approach) {}

    /// State after a crossing: its values, and the slopes that accompany the values, if any.
    fn across(&self, crossing: &Crossing<'_>, before: &[S]) -> Vec<S>;
}

/// Carrier of plain doubles, which have no slopes.
pub struct Doubles<'a> {
    pub contacts: &'a Contacts<'a>,
    pub equations: &'a Equations<'a>,
}

impl Carrier<f64> for Doubles<'_> {
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<f64> + 'e>, SimError> {
        Ok(Box::new(Held { rhs: (self.equations)()?, contacts: self.contacts, kept }))
    }

    fn across(&self, crossing: &Crossing<'_>, _: &[f64]) -> Vec<f64> {
        crossing.after.y.clone()
    }
}
