//! Claims of printed entries, as data, with which wrong entries are traced to one another.

use super::rows::{Match, Row};
use crate::algebra::Expr;
use crate::mechanics::{Formulation, QuantityKind, RowName};

/// Claim of a printed entry. Indices of tables, rows and columns count from 0; the right-hand side is the last column.
#[derive(Clone, Debug)]
pub enum Claim {
    /// Value of a named quantity, as printed and as derived.
    Value {
        /// Kind of the quantity, with its indices.
        kind: QuantityKind,
        /// Printed value, with the symbols of the text replaced by their values.
        printed: Expr,
        /// Derived value, in the same variables as the printed value.
        derived: Expr,
        /// Formulation by which the publication says that it found the value; `None` if it does not say.
        by: Option<Formulation>,
    },
    /// Row of a printed system as a whole.
    Row {
        /// Index of the system or listing.
        table: usize,
        /// Index of the row.
        row: usize,
    },
    /// Single entry of a row of a printed system.
    Entry {
        /// Index of the system or listing.
        table: usize,
        /// Index of the row.
        row: usize,
        /// Index of the column.
        column: usize,
    },
    /// Number stated in the publication.
    Number {
        /// Ids of the entries that the number contradicts.
        against: Vec<String>,
    },
    /// Row of a printed system near a point that is the expansion of an earlier printed row.
    Expansion {
        /// Index of the earlier system or listing.
        table: usize,
        /// Index of the row in it.
        row: usize,
    },
    /// Row of equations in which a slope ∂/∂t with q and q̇ held is printed instead of the rate d/dt.
    HeldTime,
    /// A claim that is not traced to others, such as a definition or another formula near a point.
    Other,
}

/// Printed system beside the derived rows with which it was matched. Columns are in the order of the derived unknowns.
#[derive(Clone, Debug)]
pub struct Table {
    /// Formulation that the system was compared with.
    pub formulation: Formulation,
    /// Name of each derived row.
    pub names: Vec<RowName>,
    /// Symbols of the derived unknowns.
    pub unknowns: Vec<Expr>,
    /// Rows of the derived system, in the order of `names`.
    pub derived: Vec<Row>,
    /// Rows of the printed system.
    pub printed: Vec<Row>,
    /// Match of each printed row with the derived rows.
    pub matches: Vec<Match>,
}

impl Table {
    /// Index of the derived row of which a printed row is a multiple, and the factor. `None` for a combination of rows.
    pub fn matched(&self, row: usize) -> Option<(usize, Expr)> {
        match &self.matches[row] {
            Match::Row { at, factor } => Some((*at, *factor)),
            Match::Combination { .. } => None,
        }
    }
}
