//! Formulas as Python with `NumPy` under the name `np` reads them.

use super::Spelling;

pub(super) const PYTHON: Spelling = Spelling { pi: "np.pi", power: "**", function };

/// What `NumPy` calls a function.
fn function(name: &'static str) -> String {
    let name = match name {
        "asin" => "arcsin",
        "acos" => "arccos",
        "atan" => "arctan",
        other => other,
    };
    format!("np.{name}")
}
