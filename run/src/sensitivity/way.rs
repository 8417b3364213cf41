//! What a run with slopes met on its way: instants at which slopes jump, what is held from there on, and where derivatives end.

use crate::impacts::{Kept, NONE};
use std::cell::RefCell;
use std::fmt;

/// Where derivatives by a number end, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Ending {
    /// From when on there are none, s.
    pub t: f64,
    /// Why.
    pub why: String,
}

/// An instant at which contacts close, open, stick or slip.
#[derive(Clone, Debug, PartialEq)]
pub struct Instant {
    /// When, s.
    pub t: f64,
    /// How it moves with each number.
    pub moves: Vec<f64>,
    /// The contacts that are held from there on.
    pub kept: Kept,
}

/// What was met on the way.
#[derive(Clone, Debug, Default)]
pub struct Way {
    /// In the order of the run.
    pub instants: Vec<Instant>,
    /// By each number; nothing where derivatives go on to the end.
    pub endings: Vec<Option<Ending>>,
}

impl Way {
    /// A way without contacts, with derivatives by so many numbers.
    pub fn new(numbers: usize) -> Self {
        Self { instants: Vec::new(), endings: vec![None; numbers] }
    }

    /// The contacts that are held from an instant on.
    pub fn kept(&self, t: f64) -> &Kept {
        self.instants.iter().rfind(|instant| instant.t <= t).map_or(&NONE, |instant| &instant.kept)
    }

    /// How an instant at which contacts change moves.
    pub fn moves(&self, t: f64) -> Option<&[f64]> {
        self.instants.iter().find(|instant| instant.t.total_cmp(&t).is_eq()).map(|instant| instant.moves.as_slice())
    }

    /// Says why derivatives by a number end, if they had not before: what was told of it later no longer holds.
    pub fn end(&mut self, number: usize, t: f64, why: String) {
        if self.endings[number].as_ref().is_some_and(|ending| ending.t <= t) {
            return;
        }
        self.endings[number] = Some(Ending { t, why });
        self.instants.iter_mut().filter(|instant| instant.t > t).for_each(|instant| instant.moves[number] = f64::NAN);
    }

    /// Adds the same way as other numbers move it.
    pub fn extend(&mut self, other: Self) {
        for (own, more) in self.instants.iter_mut().zip(other.instants) {
            own.moves.extend(more.moves);
        }
        self.endings.extend(other.endings);
    }
}

/// Says why derivatives by a number end, if they had not before.
pub fn end(way: &RefCell<Way>, number: usize, t: f64, why: String) {
    let mut way = way.borrow_mut();
    way.endings[number].get_or_insert(Ending { t, why });
}

/// "from t = 0.5 s on: the contact …".
impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "from t = {} s on: {}", self.t, self.why)
    }
}
