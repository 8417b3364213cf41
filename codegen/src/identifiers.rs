//! Names in generated code: of variables, fields, modules and types.

use quote::format_ident;
use tripos_derive::Formulation;

/// The variable that holds a symbol: `q1'` is `q1_dot`. Keywords and the function's own argument
/// names get an underscore.
#[must_use]
pub fn input_name(symbol: &str) -> String {
    let stem = symbol.trim_end_matches('\'');
    let dots = ["", "_dot", "_ddot"][(symbol.len() - stem.len()).min(2)];
    let name = format!("{stem}{dots}");
    let taken = [
        "p",
        "q",
        "u",
        "q_dot",
        "v_dot",
        "out",
        "zero",
        "S",
        "Parameters",
        "Scalar",
        "System",
        "self",
        "Self",
        "super",
        "crate",
    ];
    if taken.contains(&name.as_str()) || syn::parse_str::<syn::Ident>(&name).is_err() {
        format!("{name}_")
    } else {
        name
    }
}

/// The unit struct of a formulation.
#[must_use]
pub fn type_name(formulation: Formulation) -> &'static str {
    match formulation {
        Formulation::Kane => "Kane",
        Formulation::Lagrange => "Lagrange",
        Formulation::NewtonEuler => "NewtonEuler",
    }
}

/// The module of a formulation.
#[must_use]
pub fn module_name(formulation: Formulation) -> &'static str {
    match formulation {
        Formulation::Kane => "kane",
        Formulation::Lagrange => "lagrange",
        Formulation::NewtonEuler => "newton_euler",
    }
}

/// A parameter as a struct field: its own name, with an underscore where it is a keyword.
#[must_use]
pub fn field_name(name: &str) -> proc_macro2::Ident {
    if syn::parse_str::<syn::Ident>(name).is_ok() { format_ident!("{name}") } else { format_ident!("{name}_") }
}
