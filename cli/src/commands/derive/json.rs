//! Derivation as JSON, for other programs.
//!
//! Invariants:
//! - Every name in a formula is a symbol of the model, or is defined in `named`. A name in an acceleration may also be
//!   defined by an earlier elimination step.
//! - No formula grows beyond its parts: parts that long formulas share have names of their own.

use super::SolvedFormulation;
use super::formula_writer::{FormulaWriter, formulas_in_derivation};
use serde_json::{Value, json};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::solve::elimination::divisors;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::mechanics::{DerivationInSteps, LineName, Step};

/// Returns the name of a formulation, and the divisors in its equations, energies and accelerations as text. The text
/// contains the names of its JSON object. The lines of its stages are left out.
pub fn formulation_divisors(SolvedFormulation { derivation, solved }: &SolvedFormulation) -> (String, Vec<String>) {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let (solved, divided) = solved.as_ref().map_or((&[][..], &[][..]), |solved| (&solved.steps, &solved.divisors));
    let values = |list: &[Definition]| list.iter().map(|step| step.value).collect::<Vec<_>>();
    let shown = [formulas_in_derivation(e, steps), values(&e.definitions), values(solved)].concat();
    let writer = FormulaWriter::new(arena, e, &[shown.as_slice(), divided].concat());
    let stated = e.matrix.iter().flatten().chain(&e.forcing).chain(&e.coordinate_rates);
    let stated: Vec<Expr> = stated.chain(&[e.kinetic_energy, e.potential_energy, e.power]).copied().collect();
    let claimed = [stated, values(solved)].concat();
    let computed = [values(&needed_steps(arena, &e.definitions, &claimed)), claimed].concat();
    (e.formulation.name().to_owned(), writer.texts(&divisors(arena, &computed)))
}

/// Returns the JSON object of one formulation: its equations, definitions, accelerations and
/// stages.
pub fn formulation_json(model: &Model, SolvedFormulation { derivation, solved }: &SolvedFormulation) -> Value {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let (solved, divisors) = solved.as_ref().map_or((&[][..], &[][..]), |solved| (&solved.steps, &solved.divisors));
    let values = |list: &[Definition]| list.iter().map(|step| step.value).collect::<Vec<_>>();
    let shown = [formulas_in_derivation(e, steps), values(&e.definitions)].concat();
    let mut writer = FormulaWriter::new(arena, e, &[shown.as_slice(), values(solved).as_slice(), divisors].concat());
    let object = |list: Vec<(String, String)>| {
        list.into_iter().map(|(name, value)| json!({ "name": name, "value": value })).collect::<Vec<_>>()
    };
    let named = object(writer.definitions(&e.definitions, &shown));
    let accelerations = object(writer.definitions(solved, divisors));
    let step = |step: &Step| {
        let line = |(name, value): &(LineName, Expr)| json!({ "name": name.text(model), "value": writer.text(*value) });
        json!({ "title": step.stage.title(model), "lines": step.lines.iter().map(line).collect::<Vec<_>>() })
    };
    json!({
        "formulation": e.formulation.name(),
        "named": named,
        "unknowns": writer.texts(&e.unknowns),
        "rows": e.row_names(model),
        "mass_matrix": e.matrix.iter().map(|row| writer.texts(row)).collect::<Vec<_>>(),
        "forcing": writer.texts(&e.forcing),
        "coordinate_rates": writer.texts(&e.coordinate_rates),
        "kinetic_energy": writer.text(e.kinetic_energy),
        "potential_energy": writer.text(e.potential_energy),
        "power": writer.text(e.power),
        "singular_where": writer.texts(&e.divisors),
        "accelerations": accelerations,
        "accelerations_divide_by": writer.texts(divisors),
        "steps": steps.iter().map(step).collect::<Vec<_>>(),
    })
}
