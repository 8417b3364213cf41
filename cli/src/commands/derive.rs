//! Command `tripos derive`: prints equations of motion for the user or for other programs.

mod derivation_document;
mod formula_writer;
mod json;
pub mod latex;
mod latex_formulas;
mod layout;
mod markdown;
mod sympy;
mod typst;

use crate::arguments::{self, Format};
use crate::files::workspace::{read_model, short_name};
use crate::phrases::NAMED_TERMS_HEADING;
use crate::terminal::failure::{Failure, json_text, print, print_json, print_to_stderr};
use derivation_document::Document;
use formula_writer::{FormulaWriter, formulas_in_derivation};
use rustc_hash::FxHashSet;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::equations_name::formulation_of_name;
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::print::mathml;
use tripos_derive::mechanics::{
    DerivationInSteps, EquationForm, MovingLoadPlace, accelerations, derive_all, derive_in_steps, moving_load_places,
};
use tripos_derive::prove::{first_integrals, write_integral_names};

/// Derived formulation with its accelerations in closed form. `solved` is `None` if the equations do not determine the
/// accelerations.
struct SolvedFormulation {
    derivation: DerivationInSteps,
    solved: Option<Elimination>,
}

/// Runs `tripos derive`: derives the equations and prints them in a format. `part` may be a
/// fragment only for LaTeX. Returns the exit status.
///
/// # Errors
/// `Failure` if the model cannot be read or derived, or the request is refused.
pub fn derive(
    model: &Path,
    by: Option<&str>,
    form: Option<arguments::Form>,
    format: Format,
    part: latex::LatexExtent,
) -> Result<u8, Failure> {
    if part == latex::LatexExtent::Fragment && format != Format::Latex {
        return Err(Failure::request("only LaTeX has fragments", "add --format latex, or leave out --fragment"));
    }
    let model = read_model(model)?;
    let form = form.map(|form| match form {
        arguments::Form::Closed => EquationForm::Closed,
        arguments::Form::Steps => EquationForm::Steps,
    });
    let derived = derivations(&model, by, form)?;
    let moving = moving_load_places(&model).map_err(|error| model.diagnose(&error))?;
    let document = || derivation_document(&model, &moving, &derived);
    let out = match format {
        Format::Text => derivation_text(&model, &moving, &derived),
        Format::Latex => latex::latex_document(&document()?, part),
        Format::Markdown => markdown::markdown(&document()?),
        Format::Typst => typst::typst(&document()?),
        Format::Sympy => sympy::sympy(&model, &derived)?,
        Format::Mathml => solved_formulations_mathml(&derived),
        Format::Json => {
            print_json(&json_of(&model, &derived))?;
            return Ok(0);
        }
    };
    print(&out)?;
    Ok(0)
}

/// Returns the derived formulations of a model as JSON.
fn json_of(model: &Mechanism, derived: &[SolvedFormulation]) -> Value {
    let list: Vec<Value> = derived.iter().map(|d| json::formulation_json(model, d)).collect();
    json!({
        "model": short_name(model), "title": model.title, "count": model.counts_in_words(), "formulations": list,
    })
}

/// Derivation of a model as JSON text, with the divisors of its formulas.
pub struct DerivationText {
    /// Bytes that `tripos derive MODEL --json` writes.
    pub json: String,
    /// The same JSON as a value.
    pub value: Value,
    /// Divisors in the formulas of each formulation, as pairs (formulation, formulas of the divisors). The formulas
    /// contain the names of the JSON.
    pub divisors: Vec<(String, Vec<String>)>,
}

/// Derives all standard formulations of a model, and returns them as JSON text.
///
/// # Errors
/// `Failure` if the model cannot be derived.
pub fn derivation_text_in_json(model: &Mechanism) -> Result<DerivationText, Failure> {
    let derived = derivations(model, None, None)?;
    let divisors = derived.iter().map(json::formulation_divisors).collect();
    let value = json_of(model, &derived);
    Ok(DerivationText { json: json_text(&value), value, divisors })
}

/// Derives the formulation named `by`, or all standard formulations that the model supports. Names unsupported
/// formulations on standard error.
fn derivations(
    model: &Mechanism,
    by: Option<&str>,
    form: Option<EquationForm>,
) -> Result<Vec<SolvedFormulation>, Failure> {
    if let Some(name) = by {
        let derivation =
            derive_in_steps(model, formulation_of_name(name)?, form).map_err(|error| model.diagnose(&error))?;
        return Ok(vec![SolvedFormulation::new(derivation)]);
    }
    let mut list = Vec::new();
    for f in Formulation::STANDARD {
        match derive_in_steps(model, f, form) {
            Ok(derivation) => list.push(SolvedFormulation::new(derivation)),
            Err(error) if error.is_unsupported() => print_to_stderr(&format!("not shown: {error}")),
            Err(error) => return Err(model.diagnose(&error).into()),
        }
    }
    Ok(list)
}

impl SolvedFormulation {
    /// Solves derived equations for the accelerations. The elimination steps do not name terms again that the equations
    /// already name.
    fn new(mut derivation: DerivationInSteps) -> Self {
        let DerivationInSteps { arena, equations, .. } = &mut derivation;
        let mut solved = accelerations(arena, &mut Simplifier::default(), equations).ok();
        if let Some(solved) = &mut solved {
            let named: FxHashSet<Expr> = equations.definitions.iter().map(|step| step.symbol).collect();
            solved.steps.retain(|step| !named.contains(&step.symbol));
        }
        Self { derivation, solved }
    }
}

/// Returns the derivation as plain text.
fn derivation_text(model: &Mechanism, moving: &[MovingLoadPlace], derived: &[SolvedFormulation]) -> String {
    let mut out = format!("{}\n{}\n", model.title, model.counts_in_words());
    for place in moving {
        let _ = writeln!(out, "{}", place.text(model));
    }
    for SolvedFormulation { derivation, solved } in derived {
        let DerivationInSteps { arena, equations: e, steps } = derivation;
        let _ = writeln!(out, "\n{}\n{}", e.formulation.title(), "=".repeat(e.formulation.title().chars().count()));
        let solved = solved.as_ref().map_or(&[][..], |solved| &solved.steps);
        let values = |list: &[Definition]| list.iter().map(|step| step.value).collect::<Vec<_>>();
        let shown = [formulas_in_derivation(e, steps), values(&e.definitions)].concat();
        let mut writer = FormulaWriter::new(arena, e, &[shown.as_slice(), &values(solved)].concat());
        let named = writer.definitions(&e.definitions, &shown);
        if !named.is_empty() {
            let _ = writeln!(out, "\n{NAMED_TERMS_HEADING}, each line by those before it");
        }
        for (name, value) in named {
            let _ = writeln!(out, "  {name} = {value}");
        }
        for step in steps {
            let _ = writeln!(out, "\n{}", step.stage.title(model));
            for (name, value) in &step.lines {
                let _ = writeln!(out, "  {} = {}", name.text(model), writer.text(*value));
            }
        }
        let _ = writeln!(out, "\nEquations of motion, one row for each of {}", e.row_names(model).join(", "));
        for (row, right) in e.matrix.iter().zip(&e.forcing) {
            let _ = writeln!(out, "  {} = {}", row_text(&writer, row, &e.unknowns), writer.text(*right));
        }
        if !solved.is_empty() {
            let _ = writeln!(out, "\nSolved for the accelerations, each line by those before it");
        }
        for (name, value) in writer.definitions(solved, &[]) {
            let _ = writeln!(out, "  {name} = {value}");
        }
        let _ = writeln!(out, "\nT = {}\nV = {}", writer.text(e.kinetic_energy), writer.text(e.potential_energy));
        if e.power != Expr::ZERO {
            let _ = writeln!(out, "d(T + V)/dt = {}", writer.text(e.power));
        }
        if !e.divisors.is_empty() {
            let list: Vec<String> = e.divisors.iter().map(|d| format!("{} = 0", writer.text(*d))).collect();
            let _ = writeln!(out, "The kinematic equations are singular where {}.", list.join(", "));
        }
    }
    out
}

/// Returns a row of the linear system as text, `M1*x1 + M2*x2 + …`, without zero entries.
fn row_text(writer: &FormulaWriter<'_>, row: &[Expr], unknowns: &[Expr]) -> String {
    let mut terms = Vec::new();
    for (entry, unknown) in row.iter().zip(unknowns) {
        let name = writer.text(*unknown);
        match writer.text(*entry).as_str() {
            "0" => {}
            "1" => terms.push(name),
            "-1" => terms.push(format!("-{name}")),
            factor if factor.contains(' ') => terms.push(format!("({factor})*{name}")),
            factor => terms.push(format!("{factor}*{name}")),
        }
    }
    terms.join(" + ").replace("+ -", "- ")
}

/// Largest number of coordinates for which `derive` searches for first integrals. `prove` searches
/// for them in any model.
const MOST_PROVED: usize = 8;

/// Returns a document with the derived formulations, and with the first integrals if the model is small. `Err` if the
/// model cannot be derived by all formulations.
fn derivation_document(
    model: &Mechanism,
    moving: &[MovingLoadPlace],
    derived: &[SolvedFormulation],
) -> Result<Document, Failure> {
    let mut document = Document::new(model, moving);
    for SolvedFormulation { derivation, solved } in derived {
        document.formulation(model, derivation, solved.as_ref());
    }
    if model.coordinates.len() <= MOST_PROVED {
        let mut all = derive_all(model).map_err(|error| model.diagnose(&error))?;
        let integrals = first_integrals(model, &mut all);
        all.write_names();
        write_integral_names(&integrals, &mut all);
        document.integrals(model, &all.kinematics.arena, &integrals);
    }
    Ok(document)
}

/// Returns the definitions and the equations of motion as MathML for web pages.
fn solved_formulations_mathml(derived: &[SolvedFormulation]) -> String {
    let mut out = String::new();
    for DerivationInSteps { arena, equations: e, .. } in derived.iter().map(|derived| &derived.derivation) {
        for step in &e.definitions {
            let name = mathml(arena, step.symbol);
            let _ = writeln!(
                out,
                "<math display=\"block\"><mrow>{name}<mo>=</mo>{}</mrow></math>",
                mathml(arena, step.value)
            );
        }
        for (row, right) in e.matrix.iter().zip(&e.forcing) {
            let mut terms = Vec::new();
            for (entry, unknown) in row.iter().zip(&e.unknowns) {
                if *entry != Expr::ZERO {
                    let name = mathml(arena, *unknown);
                    terms.push(format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>{name}", mathml(arena, *entry)));
                }
            }
            let _ = writeln!(
                out,
                "<math display=\"block\"><mrow>{}<mo>=</mo>{}</mrow></math>",
                terms.join("<mo>+</mo>"),
                mathml(arena, *right)
            );
        }
    }
    out
}
