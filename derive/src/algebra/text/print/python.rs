//! Formulas as Python reads them: with `NumPy` under the name `np`, or with `SymPy` under the name `sp`.

use super::Spelling;

pub(super) const NUMPY: Spelling = Spelling { pi: "np.pi", power: "**", function: of_numpy, quotient: None };
pub(super) const SYMPY: Spelling =
    Spelling { pi: "sp.pi", power: "**", function: of_sympy, quotient: Some("sp.Rational") };

/// Name of a function in `NumPy`, with the prefix `np.`.
fn of_numpy(name: &'static str) -> String {
    let name = match name {
        "asin" => "arcsin",
        "acos" => "arccos",
        "atan" => "arctan",
        other => other,
    };
    format!("np.{name}")
}

/// Name of a function in `SymPy`, with the prefix `sp.`.
fn of_sympy(name: &'static str) -> String {
    format!("sp.{}", if name == "abs" { "Abs" } else { name })
}
