//! Inputs of a model: signals that drive loads, and formulas that scenes give to inputs.

use super::Unit;
use crate::algebra::Expr;

/// Input of a model: a signal that occurs by name in loads.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name of the input in the model file.
    pub name: String,
    /// Unit of the input, in SI.
    pub unit: Unit,
    /// Description of the input in words; empty if the model file gives none.
    pub about: String,
    /// Symbol of the parameter with the input's name, or the term of the input's formula in SI units.
    pub value: Expr,
    /// True if the input is a parameter, whose value may change between steps. False if a formula replaces the input.
    pub is_parameter: bool,
}

/// Formula that a scene gives to an input of the model; it replaces the input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputBinding {
    /// Name of the input that the formula replaces.
    pub input: String,
    /// Text of the formula, which may contain t, coordinates q, rates q', speeds and parameters.
    pub formula: String,
}
