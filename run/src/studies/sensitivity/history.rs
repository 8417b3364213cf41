//! Changes during a run with slopes: instants at which slopes jump, contacts held from there on, and ends of
//! derivatives.

use crate::preparation::impacts::{HeldContacts, NONE};
use std::cell::RefCell;
use std::fmt;
use tripos_derive::plain::within;

/// End of the derivatives with respect to a number, with its reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Ending {
    /// Instant from which on there are no derivatives, s.
    pub t: f64,
    /// Reason why the derivatives end.
    pub why: String,
}

/// An instant at which contacts close, open, stick or slip, with its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// Instant of the change, s.
    pub t: f64,
    /// Derivative of the instant by each seed; NaN if there is none.
    pub moves: Vec<f64>,
    /// Contacts that are held from this instant on.
    pub kept: HeldContacts,
}

/// Changes of contacts during a run, and ends of derivatives.
#[derive(Clone, Debug, Default)]
pub struct ContactHistory {
    /// Changes of contacts, in the order of the run.
    pub instants: Vec<Instant>,
    /// End of the derivatives by each seed; `None` if they reach the end of the run.
    pub endings: Vec<Option<Ending>>,
}

impl ContactHistory {
    /// Creates a record without changes of contacts, with derivatives by `numbers` seeds.
    pub fn new(numbers: usize) -> Self {
        Self { instants: Vec::new(), endings: vec![None; numbers] }
    }

    /// Contacts that are held just after an instant.
    pub fn kept(&self, t: f64) -> &HeldContacts {
        self.instants.iter().rfind(|instant| instant.t <= t).map_or(&NONE, |instant| &instant.kept)
    }

    /// Derivatives of an instant at which contacts change, by each seed; `None` if no contact changes at `t`.
    pub fn moves(&self, t: f64) -> Option<&[f64]> {
        self.instants.iter().find(|instant| instant.t.total_cmp(&t).is_eq()).map(|instant| instant.moves.as_slice())
    }

    /// Ends the derivatives with respect to the seed `number` at an instant, s, if they had not ended before. Later
    /// instants then have no derivative by this seed.
    pub fn end(&mut self, number: usize, t: f64, why: String) {
        if self.endings[number].as_ref().is_some_and(|ending| ending.t <= t) {
            return;
        }
        self.endings[number] = Some(Ending { t, why });
        self.instants.iter_mut().filter(|instant| instant.t > t).for_each(|instant| instant.moves[number] = f64::NAN);
    }

    /// Adds the derivatives of the same run's instants by further seeds.
    pub fn extend(&mut self, other: Self) {
        for (own, more) in self.instants.iter_mut().zip(other.instants) {
            own.moves.extend(more.moves);
        }
        self.endings.extend(other.endings);
    }
}

/// Ends the derivatives with respect to the seed `number` at an instant, s, if they had not ended before.
pub fn end(history: &RefCell<ContactHistory>, number: usize, t: f64, why: String) {
    let mut history = history.borrow_mut();
    history.endings[number].get_or_insert(Ending { t, why });
}

/// Writes "from t = 0.5 s on: the contact …".
impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "from t = {} s on: {}", within(self.t, None), self.why)
    }
}
