//! Claims of printed entries, as data; they serve to trace wrong entries to one another.

use super::rows::{Match, Row};
use crate::algebra::Expr;
use crate::mechanics::{Formulation, QuantityKind, RowName};

/// Claim of a printed entry. Tables, rows and columns are positions from 0; the right-hand side is the last column.
#[derive(Clone, Debug)]
pub enum Claim {
    /// A value of a named quantity, as printed and as derived.
    Value {
        /// The quantity.
        kind: QuantityKind,
        /// The printed value, with symbols of the text replaced by their values.
        printed: Expr,
        /// The derived value, in the same variables.
        derived: Expr,
    },
    /// A row of a printed system as a whole.
    Row {
        /// Index of the system or listing.
        table: usize,
        /// Index of the row.
        row: usize,
    },
    /// A single entry of a row.
    Entry {
        /// Index of the system or listing.
        table: usize,
        /// Index of the row.
        row: usize,
        /// Index of the column.
        column: usize,
    },
    /// A stated number.
    Number {
        /// The ids of the numbers that it contradicts.
        against: Vec<String>,
    },
    /// A claim that is not traced to others, such as a definition or a formula near a point.
    Other,
}

/// A printed system beside the derived rows that it was matched with, columns in the order of the derived unknowns.
#[derive(Clone, Debug)]
pub struct Table {
    /// Formulation that the system was compared with.
    pub formulation: Formulation,
    /// Name of each derived row.
    pub names: Vec<RowName>,
    /// The derived unknowns.
    pub unknowns: Vec<Expr>,
    /// The derived rows.
    pub derived: Vec<Row>,
    /// The printed rows.
    pub printed: Vec<Row>,
    /// Match of each printed row with the derived rows.
    pub matches: Vec<Match>,
}

impl Table {
    /// The derived row that a printed row is a multiple of, and the factor; `None` for a combination of rows.
    pub fn matched(&self, row: usize) -> Option<(usize, Expr)> {
        match &self.matches[row] {
            Match::Row { at, factor } => Some((*at, *factor)),
            Match::Combination { .. } => None,
        }
    }
}
