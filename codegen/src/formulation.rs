//! One formulation of one model as a Rust file.

use crate::function::{Arguments, Function, Returns, Value, Writer};
use crate::identifiers::{Variables, spelled, type_name};
use crate::system;
use crate::tokens::format;
use quote::quote;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::{Equations, Formulation, Model};

/// Emits the file of one formulation, such as `kane.rs`, from a source such as `models/disk/model.toml`.
#[must_use]
pub fn file(model: &Model, source: &str, arena: &Arena, equations: &Equations) -> String {
    let writer = Writer { model, arena, equations, variables: Variables::new(arena, &type_name(&equations.name)) };
    let mut functions = linear_system(&writer);
    functions.extend(kinematics_and_energies(&writer));
    if equations.formulation == Formulation::Lagrange {
        functions.extend(conversions(&writer));
    }
    let header = header(&writer, source, &functions);
    let functions = functions.into_iter().map(|f| f.tokens);
    let system = system::system(model, equations);
    format(
        &header,
        quote! {
            use super::Parameters;
            use tripos_traits::{Scalar, System};
            #(#functions)*
            #system
        },
    )
}

/// `mass_matrix` and `forcing`.
fn linear_system(writer: &Writer<'_>) -> Vec<Function> {
    let e = writer.equations;
    let n = e.unknowns.len();
    let place = |i: usize, j: usize| format!("{}{}", index(i, n), index(j, n));
    let entries: Vec<Value> = (0..n * n)
        .map(|at| (at / n, at % n))
        .map(|(i, j)| (format!("m{}", place(i, j)), format!("M{}", place(i, j)), e.matrix[i][j]))
        .collect();
    let forcing: Vec<Value> = e
        .forcing
        .iter()
        .enumerate()
        .map(|(i, value)| (format!("f{}", index(i, n)), format!("f{}", index(i, n)), *value))
        .collect();
    let symmetry = if e.symmetric { "symmetric, rows" } else { "rows" };
    let product = equation_text(e.formulation);
    let matrix_about = format!("Matrix of the linear system {product}; {symmetry} {}.", e.rows.join(", "));
    let forcing_about =
        format!("Right-hand side of the linear system; unknowns {}.", vector_text(writer.arena, &e.unknowns));
    let returns = Returns::Matrix { symmetric: e.symmetric };
    vec![
        writer.function("mass_matrix", &matrix_about, Arguments::State, returns, &entries),
        writer.function("forcing", &forcing_about, Arguments::State, Returns::Vector, &forcing),
    ]
}

fn kinematics_and_energies(writer: &Writer<'_>) -> Vec<Function> {
    let e = writer.equations;
    let rates = named(writer.model.coordinates.iter().map(|c| format!("{}'", c.name)), &e.coordinate_rates);
    let about = "Kinematic equations: the time derivatives of the coordinates.";
    let kinetic = [("energy".to_owned(), "T".to_owned(), e.kinetic_energy)];
    let potential = [("energy".to_owned(), "V".to_owned(), e.potential_energy)];
    vec![
        writer.function("coordinate_rates", about, Arguments::State, Returns::Vector, &rates),
        writer.function("kinetic_energy", "Kinetic energy T.", Arguments::State, Returns::Number, &kinetic),
        writer.function(
            "potential_energy",
            "Potential energy V of gravity.",
            Arguments::Configuration,
            Returns::Number,
            &potential,
        ),
    ]
}

/// Between q' and the generalized speeds, where q' is what is integrated.
fn conversions(writer: &Writer<'_>) -> Vec<Function> {
    let (e, model) = (writer.equations, writer.model);
    let speeds = named(model.speeds.iter().map(|s| s.name.clone()), &e.generalized_speeds);
    let rates = named(model.speeds.iter().map(|s| format!("{}'", s.name)), &e.generalized_speed_rates);
    let variables = named(model.coordinates.iter().map(|c| format!("{}'", c.name)), &e.motion_variables);
    let function =
        |name, about, arguments, values: &[Value]| writer.function(name, about, arguments, Returns::Vector, values);
    vec![
        function("generalized_speeds", "The generalized speeds u, from q and q'.", Arguments::State, &speeds),
        function(
            "generalized_speed_rates",
            "Their time derivatives u', from q, q' and q''.",
            Arguments::StateAndRates,
            &rates,
        ),
        function("motion_variables", "q' from q and the generalized speeds u.", Arguments::Speeds, &variables),
    ]
}

/// Outputs named after symbols: `q1'` is computed in `q1_dot_value`, distinct from an input `q1_dot`.
fn named(symbols: impl Iterator<Item = String>, values: &[Expr]) -> Vec<Value> {
    symbols.zip(values).map(|(symbol, value)| (format!("{}_value", spelled(&symbol)), symbol, *value)).collect()
}

/// 1-based, set apart where one digit does not do.
fn index(i: usize, n: usize) -> String {
    if n < 10 { format!("{}", i + 1) } else { format!("_{}", i + 1) }
}

fn vector_text(arena: &Arena, symbols: &[Expr]) -> String {
    let names: Vec<&str> = symbols.iter().filter_map(|s| arena.symbol_name(*s)).collect();
    format!("({})", names.join(", "))
}

fn equation_text(formulation: Formulation) -> &'static str {
    match formulation {
        Formulation::Kane => "M(q) u' = f(q, u)",
        Formulation::Lagrange => "E(q) q'' = A(q, q')",
        Formulation::NewtonEuler => "A(q, u) (u', reactions) = b(q, u)",
    }
}

fn header(writer: &Writer<'_>, source: &str, functions: &[Function]) -> Vec<String> {
    let (e, model) = (writer.equations, writer.model);
    let plural = |n: usize, what: &str| if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") };
    let mut counts = vec![
        plural(model.coordinates.len(), "coordinate"),
        plural(model.speeds.len(), "speed"),
        plural(model.parameters.len(), "parameter"),
    ];
    let reactions = e.unknowns.len() - e.variables.len();
    if reactions > 0 {
        counts.push(plural(reactions, "reaction"));
    }
    let costs: Vec<String> = functions.iter().take(2).map(|f| format!("{} {}", f.name, f.cost)).collect();
    vec![
        format!("{}: {}, {}.", model.title, e.title, equation_text(e.formulation)),
        String::new(),
        format!("Generated from `{source}`. Do not edit; run `tripos regenerate`."),
        format!("{}. Unknowns: {}.", counts.join(", "), vector_text(writer.arena, &e.unknowns)),
        format!("Cost: {}.", costs.join("; ")),
        singular_text(writer.arena, e),
    ]
}

fn singular_text(arena: &Arena, e: &Equations) -> String {
    if e.divisors.is_empty() {
        return "The kinematic equations are singular nowhere.".to_owned();
    }
    let places: Vec<String> = e.divisors.iter().map(|d| format!("{} = 0", text(arena, *d))).collect();
    format!("The kinematic equations are singular where {}.", places.join(" and where "))
}
