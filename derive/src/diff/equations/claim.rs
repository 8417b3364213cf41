//! Claims of printed entries, as data for tracing wrong entries to one another.

use super::row_judgement::{Row, RowMatchResult};
use crate::algebra::Expr;
use crate::mechanics::{Formulation, QuantityKind, RowName};

/// Claim of a printed entry. Indices of tables, rows and columns count from 0; the right-hand side is the last column.
#[derive(Clone, Debug)]
pub enum Claim {
    /// Value of a named quantity, as printed and as derived.
    Value {
        /// Kind of the named quantity, with its indices.
        kind: QuantityKind,
        /// Printed value, with the symbols of the text replaced by their values.
        printed: Expr,
        /// Derived value, in the same variables as the printed value.
        derived: Expr,
        /// Formulation by which the publication says that it found the value; `None` if it does not say.
        by: Option<Formulation>,
    },
    /// Claim of a whole row of a printed system.
    Row {
        /// Index, among the tables, of the system or program (listing) with the row.
        table: usize,
        /// Index of the row in its system.
        row: usize,
    },
    /// Claim of a single entry in a row of a printed system.
    Entry {
        /// Index, among the tables, of the system or program (listing) with the entry.
        table: usize,
        /// Index of the row that contains the entry.
        row: usize,
        /// Index of the column that contains the entry; the right-hand side is the last column.
        column: usize,
    },
    /// Number that the publication states, such as an initial value.
    Number {
        /// Ids of the entries that the printed number contradicts.
        against: Vec<String>,
    },
    /// Row of a printed system that holds near a point and expands an earlier printed row.
    Expansion {
        /// Index, among the tables, of the system or program (listing) that has the earlier row.
        table: usize,
        /// Index of the earlier row in its system or program (listing).
        row: usize,
    },
    /// Row in which a partial derivative ∂/∂t, with q and q̇ held constant, is printed instead of
    /// the total derivative d/dt.
    HeldTime,
    /// Statement that is not traced to other entries, such as a definition or a formula that holds
    /// only near a point.
    Other,
}

/// Printed system with the derived rows with which it was matched. Columns follow the order of the
/// derived unknowns.
#[derive(Clone, Debug)]
pub struct MatchedSystem {
    /// Formulation whose derived system was compared with the printed system.
    pub formulation: Formulation,
    /// Name of each row of the derived system, such as its speed or coordinate.
    pub names: Vec<RowName>,
    /// Symbols of the unknowns of the derived system, in the order of the columns.
    pub unknowns: Vec<Expr>,
    /// Rows of the derived system, in the order of `names`.
    pub derived: Vec<Row>,
    /// Rows of the printed system, in its own order; columns follow `unknowns`.
    pub printed: Vec<Row>,
    /// Match of each printed row with the derived rows, in the order of `printed`.
    pub matches: Vec<RowMatchResult>,
}

impl MatchedSystem {
    /// Index of the derived row of which the printed row `row` is a multiple, and the factor
    /// printed ÷ derived.
    /// Returns `None` for a printed row that is a combination of several derived rows.
    pub fn matched_derived_row(&self, row: usize) -> Option<(usize, Expr)> {
        match &self.matches[row] {
            RowMatchResult::Row { at, factor } => Some((*at, *factor)),
            RowMatchResult::Combination { .. } => None,
        }
    }
}
