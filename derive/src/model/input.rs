//! Inputs: signals that drive loads, and the formulas that scenes give to them.

use super::Unit;
use crate::algebra::Expr;

/// A signal that loads name.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name of the input in the model file.
    pub name: String,
    /// Unit of the input, in SI.
    pub unit: Unit,
    /// Description of the input in words; empty if the model file gives none.
    pub about: String,
    /// Symbol of the parameter that has the input's name, or the input's formula, in SI, if it has one.
    pub value: Expr,
    /// True if the input is a parameter, false if it has a formula.
    pub is_parameter: bool,
}

/// A formula that replaces an input in one scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Name of the input that the formula replaces.
    pub input: String,
    /// Formula for the input, in t, coordinates, q', speeds and parameters.
    pub formula: String,
}
