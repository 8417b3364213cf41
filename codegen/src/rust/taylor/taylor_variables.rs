//! Writer of the text of a function `taylor`, and the names of the variables in its statements.

use crate::plan::TaylorPlan;
use crate::rust::expression::expression;
use crate::rust::names::rust_identifier;
use proc_macro2::TokenStream;
use rustc_hash::FxHashMap;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::display_tree::display_tree;

/// Writer of the text of a function `taylor`. Its plan states the names of the variables.
pub(super) struct TaylorWriter<'a> {
    /// Plan of the function, with the names of its variables.
    pub(super) plan: &'a TaylorPlan<'a>,
}

impl TaylorWriter<'_> {
    /// Returns the variable of the coefficient of order 0 of a series.
    pub(super) fn order_zero_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&format!("{}_0", self.plan.names[at]))
    }

    /// Returns the variable of the coefficient of order 1 of a series.
    pub(super) fn order_one_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&format!("{}_1", self.plan.names[at]))
    }

    /// Returns the variable of the coefficient of order k − 1 of a series.
    pub(super) fn previous_order_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&format!("{}_last", self.plan.names[at]))
    }

    /// Returns the variable of the coefficient of order k of a series.
    pub(super) fn current_order_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&self.plan.names[at])
    }

    /// Returns the variable of the reciprocal of a series' coefficient of order 0.
    pub(super) fn reciprocal_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&self.plan.over[&at])
    }

    /// Returns the variable of 1/(2 z), where z is the coefficient of order 0 of a square root.
    pub(super) fn over_twice_variable(&self, at: usize) -> TokenStream {
        rust_identifier(&self.plan.over_twice[&at])
    }

    /// Returns the expression for a constant factor: its variable if it has one, otherwise its number.
    pub(super) fn weight_variable_or_number(&self, e: Expr) -> TokenStream {
        match self.plan.weights.get(&e).or_else(|| self.plan.variables.of.get(&e)) {
            Some(name) => rust_identifier(name),
            None => expression(&display_tree(self.plan.arena, e, &FxHashMap::default(), usize::MAX)),
        }
    }
}
