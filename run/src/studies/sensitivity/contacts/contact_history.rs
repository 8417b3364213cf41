//! Record of the changes of contacts in a run with derivatives, and of early ends of the derivatives.

use crate::preparation::impacts::{HeldContacts, NONE};
use std::cell::RefCell;
use std::fmt;
use tripos_derive::plain_text::with_reliable_digits;

/// Instant from which a run has no derivatives by one varied number, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivativeEnd {
    /// Instant, s, from which there are no derivatives.
    pub t: f64,
    /// Reason why the derivatives end, as text for the user.
    pub why: String,
}

/// Instant at which contacts close, open, stick or slip, with its derivatives by the varied numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactChangeInstant {
    /// Instant of the change of contacts, s.
    pub t: f64,
    /// Derivative of the instant by each varied number, s per unit of the number. NaN if it does not
    /// exist.
    pub moves: Vec<f64>,
    /// Contacts that are held closed from this instant on.
    pub kept: HeldContacts,
}

/// Record of the changes of contacts during a run, and of early ends of derivatives.
#[derive(Clone, Debug, Default)]
pub struct ContactHistory {
    /// Changes of contacts, in the order of time.
    pub instants: Vec<ContactChangeInstant>,
    /// Early end of the derivatives by each varied number; `None` if they reach the end of the run.
    pub endings: Vec<Option<DerivativeEnd>>,
}

impl ContactHistory {
    /// Creates a record without changes of contacts, for `numbers` varied numbers.
    pub fn new(numbers: usize) -> Self {
        Self { instants: Vec::new(), endings: vec![None; numbers] }
    }

    /// Contacts that are held closed just after the instant `t`, s. It is the last change of contacts up
    /// to `t` that decides.
    pub fn held_contacts_after(&self, t: f64) -> &HeldContacts {
        self.instants.iter().rfind(|instant| instant.t <= t).map_or(&NONE, |instant| &instant.kept)
    }

    /// Derivatives of the instant `t`, at which contacts change, by each varied number. `None` if no
    /// contact changes at `t`.
    pub fn instant_derivatives(&self, t: f64) -> Option<&[f64]> {
        self.instants.iter().find(|instant| instant.t.total_cmp(&t).is_eq()).map(|instant| instant.moves.as_slice())
    }

    /// Ends the derivatives by the varied number with the index `number` at the instant `t`, s. Later
    /// instants of contact changes get the derivative NaN. Does nothing if the derivatives have ended
    /// before.
    pub fn end(&mut self, number: usize, t: f64, why: String) {
        if self.endings[number].as_ref().is_some_and(|ending| ending.t <= t) {
            return;
        }
        self.endings[number] = Some(DerivativeEnd { t, why });
        self.instants.iter_mut().filter(|instant| instant.t > t).for_each(|instant| instant.moves[number] = f64::NAN);
    }

    /// Adds the derivatives of the same run by further varied numbers, which `other` recorded.
    pub fn extend_history(&mut self, other: Self) {
        for (own, more) in self.instants.iter_mut().zip(other.instants) {
            own.moves.extend(more.moves);
        }
        self.endings.extend(other.endings);
    }
}

/// Ends the derivatives by the varied number with the index `number` at the instant `t`, s, unless they
/// have ended already.
pub fn end_derivatives(history: &RefCell<ContactHistory>, number: usize, t: f64, why: String) {
    let mut history = history.borrow_mut();
    history.endings[number].get_or_insert(DerivativeEnd { t, why });
}

/// Writes the end of derivatives as text, such as "from t = 0.5 s on: the contact …".
impl fmt::Display for DerivativeEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "from t = {} s on: {}", with_reliable_digits(self.t, None), self.why)
    }
}
