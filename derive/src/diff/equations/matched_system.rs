//! Printed system with the derived rows that match its rows.

use super::row_judgement::{Row, RowMatchResult};
use crate::algebra::Expr;
use crate::mechanics::{Formulation, RowName};

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
    /// Derived row of which the printed row `row` is a multiple: its index, and the factor printed ÷ derived. Returns
    /// `None` for a printed row that is a combination of several derived rows.
    pub fn matched_derived_row(&self, row: usize) -> Option<(usize, Expr)> {
        match &self.matches[row] {
            RowMatchResult::Row { at, factor } => Some((*at, *factor)),
            RowMatchResult::Combination { .. } => None,
        }
    }
}
