//! Spelling of formulas in Python: with `NumPy` imported as `np`, or with `SymPy` imported as `sp`.

use super::Spelling;

/// Spelling of formulas with `NumPy`, imported as `np`.
pub(super) const NUMPY: Spelling =
    Spelling { pi: "np.pi", power: "**", function: python_spelling_of_numpy, quotient: None };
/// Spelling of formulas with `SymPy`, imported as `sp`.
pub(super) const SYMPY: Spelling =
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
