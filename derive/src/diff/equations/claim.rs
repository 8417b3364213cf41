//! Claims of printed entries: their statements as data, with which the source of a wrong entry is traced.

use crate::algebra::Expr;
use crate::mechanics::{Formulation, QuantityKind};

/// Claim (statement) of a printed entry. Indices of tables, rows and columns count from 0; the right-hand side is the
/// last column.
#[derive(Clone, Debug)]
pub enum Claim {
    /// Claim about the value of a named quantity, as printed and as derived.
    Value {
        /// Kind of the named quantity, with its indices.
        kind: QuantityKind,
        /// Printed value, with the symbols of the publication replaced by their values.
        printed: Expr,
        /// Derived value, in the same variables as the printed value.
        derived: Expr,
        /// Formulation from which the publication derives the value; `None` if it does not say.
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
    /// Claim of a printed row that holds near a point and expands an earlier printed row.
    Expansion {
        /// Index, among the tables, of the system or program (listing) that has the earlier row.
        table: usize,
        /// Index of the earlier row in its system or program (listing).
        row: usize,
    },
    /// Claim of a row with the partial derivative ∂/∂t, q and q̇ held constant, instead of the total derivative d/dt.
    HeldTime,
    /// Claim that is not traced to other entries, such as a definition or a formula that holds only near a point.
    Other,
}
