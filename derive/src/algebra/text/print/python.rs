//! Spelling of formulas in Python: with `NumPy` imported as `np`, or with `SymPy` imported as `sp`.

use super::{Spelling, write_line};
use crate::algebra::text::display_tree::DisplayTree;

/// Prints a display tree as a Python expression, with functions of `NumPy` such as `np.sin`.
#[must_use]
pub fn python_of(view: &DisplayTree) -> String {
    let mut out = String::new();
    write_line(view, &NUMPY, &mut out);
    out
}

/// Prints a display tree as a Python expression, with functions of `SymPy` such as `sp.sin`.
/// Quotients of integers stay exact (`sp.Rational`).
#[must_use]
pub fn sympy_of(view: &DisplayTree) -> String {
    let mut out = String::new();
    write_line(view, &SYMPY, &mut out);
    out
}

/// Spelling of formulas with `NumPy`, imported as `np`.
const NUMPY: Spelling = Spelling { pi: "np.pi", power: "**", function: python_spelling_of_numpy, quotient: None };
/// Spelling of formulas with `SymPy`, imported as `sp`.
const SYMPY: Spelling =
    Spelling { pi: "sp.pi", power: "**", function: python_spelling_of_sympy, quotient: Some("sp.Rational") };

/// Name of a function in `NumPy`, with the prefix `np.`, from its name in model files.
fn python_spelling_of_numpy(name: &'static str) -> String {
    let name = match name {
        "asin" => "arcsin",
        "acos" => "arccos",
        "atan" => "arctan",
        other => other,
    };
    format!("np.{name}")
}

/// Name of a function in `SymPy`, with the prefix `sp.`, from its name in model files.
fn python_spelling_of_sympy(name: &'static str) -> String {
    format!("sp.{}", if name == "abs" { "Abs" } else { name })
}
