//! What an entry states, as data: by this wrong entries are traced to one another.

use super::rows::{Match, Row};
use crate::algebra::Expr;
use crate::mechanics::{Formulation, QuantityKind, RowName};

/// What an entry states. Tables, rows and columns are positions from 0; the right-hand side is the last column.
#[derive(Clone, Debug)]
pub enum Claim {
    /// A value of a named quantity, as printed and as derived.
    Value {
        /// The quantity.
        kind: QuantityKind,
        /// Printed, with what symbols of the text stand for.
        printed: Expr,
        /// Derived, in the same variables.
        derived: Expr,
    },
    /// A row of a printed system as a whole.
    Row {
        /// Which system or listing.
        table: usize,
        /// The row.
        row: usize,
    },
    /// A single entry of a row.
    Entry {
        /// Which system or listing.
        table: usize,
        /// The row.
        row: usize,
        /// The column.
        column: usize,
    },
    /// A number.
    Number {
        /// The ids of the numbers that it contradicts.
        against: Vec<String>,
    },
    /// What no other entry can be traced to.
    Other,
}

/// A printed system beside the derived rows that it was matched with, columns in the order of the derived unknowns.
#[derive(Clone, Debug)]
pub struct Table {
    /// What it was compared with.
    pub formulation: Formulation,
    /// What each derived row is of.
    pub names: Vec<RowName>,
    /// The derived unknowns.
    pub unknowns: Vec<Expr>,
    /// The derived rows.
    pub derived: Vec<Row>,
    /// The printed rows.
    pub printed: Vec<Row>,
    /// What each printed row was matched with.
    pub matches: Vec<Match>,
}

impl Table {
    /// The derived row that a printed one was matched with, and the printed one's factor.
    pub fn matched(&self, row: usize) -> Option<(usize, Expr)> {
        match &self.matches[row] {
            Match::Row { at, factor } => Some((*at, *factor)),
            Match::Combination { .. } => None,
        }
    }
}
