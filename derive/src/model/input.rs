//! Inputs: signals that drive loads, and the formulas that scenes give to them.

use super::Unit;
use crate::algebra::Expr;

/// A signal that loads name.
#[derive(Clone, Debug)]
pub struct Input {
    /// Its name in the file.
    pub name: String,
    /// Its unit, in SI.
    pub unit: Unit,
    /// Description in words.
    pub about: String,
    /// The symbol of a parameter of its name; the formula where it has one, whose numbers are in SI.
    pub value: Expr,
    /// True if the input is a parameter, false if it has a formula.
    pub is_parameter: bool,
}

/// A formula that stands for an input in one scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The name of the input.
    pub input: String,
    /// The formula, in t, coordinates, q', speeds and parameters.
    pub formula: String,
}
