//! The numbers that a run with contacts is made in.
//!
//! What is decided, which contacts close, push and open, is decided by values alone; numbers with slopes beside their values go along.

use super::contacts::Contacts;
use super::happening::Happening;
use super::held::Held;
use super::kept::Kept;
use super::meeting::After;
use tripos_sim::{RightHandSide, SimError};

/// How the equations of a run are had, anew for each use.
pub type Equations<'a> = dyn Fn() -> Result<Box<dyn RightHandSide<f64> + 'a>, SimError> + 'a;

/// A state at which velocities jump, or at which contacts are let go or held from there on.
pub struct Crossing<'c> {
    /// When, s.
    pub t: f64,
    /// What happens; nothing where the run begins.
    pub happening: Option<Happening>,
    /// The state before.
    pub before: &'c [f64],
    /// The contacts that were held before.
    pub kept: &'c Kept,
    /// The state after, and how it came about.
    pub after: &'c After,
}

/// Where a gap is at its least, and next to nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// The contact.
    pub contact: usize,
    /// When, s.
    pub t: f64,
    /// The state.
    pub y: Vec<f64>,
}

/// What a run with contacts asks of the numbers it is made in.
pub trait Carrier<S> {
    /// The equations with the forces of these contacts.
    ///
    /// # Errors
    /// [`SimError`] if the question makes no sense.
    fn equations<'e>(&'e self, kept: &'e Kept) -> Result<Box<dyn RightHandSide<S> + 'e>, SimError>;

    /// Is told of each step inside a part, and when it ends, s: of all but the last.
    fn stepped(&self, _t: f64) {}

    /// How small a gap must be at its least to be told of, as a part of what it is made of; nothing if that is of no use.
    fn near(&self) -> Option<f64> {
        None
    }

    /// Is told where the gap of a contact that stays open is at its least, and so small: derivatives may end there.
    fn nears(&self, _approach: &Approach) {}

    /// The state after a crossing: the values that it has, and whatever goes along with them.
    fn across(&self, crossing: &Crossing<'_>, before: &[S]) -> Vec<S>;
}

/// Doubles, with which nothing goes along.
pub struct Doubles<'a> {
    pub contacts: &'a Contacts<'a>,
    pub equations: &'a Equations<'a>,
}

impl Carrier<f64> for Doubles<'_> {
    fn equations<'e>(&'e self, kept: &'e Kept) -> Result<Box<dyn RightHandSide<f64> + 'e>, SimError> {
        Ok(Box::new(Held { rhs: (self.equations)()?, contacts: self.contacts, kept }))
    }

    fn across(&self, crossing: &Crossing<'_>, _: &[f64]) -> Vec<f64> {
        crossing.after.y.clone()
    }
}
