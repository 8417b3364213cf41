//! Derivation as JSON, for other programs.
//!
//! Invariants:
//! - Every name in a formula is a symbol of the model, or is defined in `named`. A name in an acceleration may also be
//!   defined by an earlier elimination step.
//! - No formula grows beyond its parts: parts that long formulas share have names of their own.

use super::SolvedFormulation;
use rustc_hash::FxHashSet;
use serde_json::{Value, json};
use tripos_derive::Model;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::display_tree::SharedNames;
use tripos_derive::algebra::text::print::{long_parts, print_whole_view, text_of};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DerivationInSteps, Equations, LineName, Step};

/// Returns the JSON object of one formulation: its equations, definitions, accelerations and
/// stages.
pub fn formulation_json(model: &Model, SolvedFormulation { derivation, solved }: &SolvedFormulation) -> Value {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let (solved, divisors) = solved.as_ref().map_or((&[][..], &[][..]), |solved| (&solved.steps, &solved.divisors));
    let values = |list: &[Definition]| list.iter().map(|step| step.value).collect::<Vec<_>>();
    let shown = [formulas_in_derivation_json(e, steps), values(&e.definitions)].concat();
    let mut writer =
        JsonFormulaWriter::new(arena, e, &[shown.as_slice(), values(solved).as_slice(), divisors].concat());
    let named = writer.definitions(&e.definitions, &shown);
    let accelerations = writer.definitions(solved, divisors);
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

/// Lists every formula of the equations and stages, except those of accelerations and definitions.
fn formulas_in_derivation_json(e: &Equations, steps: &[Step]) -> Vec<Expr> {
    let lists = [&e.unknowns, &e.forcing, &e.coordinate_rates, &e.divisors].into_iter().chain(&e.matrix).flatten();
    let lines = steps.iter().flat_map(|step| step.lines.iter().map(|(_, value)| value));
    lists.chain(lines).chain(&[e.kinetic_energy, e.potential_energy, e.power]).copied().collect()
}

/// Writer of formulas as text. It gives names to the parts that long formulas share.
struct JsonFormulaWriter<'a> {
    /// Arena that stores the terms (symbolic expressions).
    arena: &'a Arena,
    /// Names of shared parts; the key is the term.
    names: SharedNames,
    /// Shared parts that have names, each after the parts that it contains.
    parts: Vec<Expr>,
    /// Parts whose definitions are already written.
    defined: FxHashSet<Expr>,
}

impl<'a> JsonFormulaWriter<'a> {
    /// Finds the shared parts of the given formulas and names them, such as `part_1_kane`.
    fn new(arena: &'a Arena, equations: &Equations, formulas: &[Expr]) -> Self {
        let parts = long_parts(arena, formulas);
        let suffix = equations.formulation.name().replace('-', "_");
        let mut number = 0;
        let mut name = || loop {
            number += 1;
            let name = format!("part_{number}_{suffix}");
            if arena.find_symbol(&name).is_none() {
                return name;
            }
        };
        let names = parts.iter().map(|part| (*part, name())).collect();
        Self { arena, names, parts, defined: FxHashSet::default() }
    }

    /// Returns a formula as text, with shared parts as names.
    fn text(&self, e: Expr) -> String {
        text_of(&print_whole_view(self.arena, e, &self.names))
    }

    /// Returns formulas as texts, with shared parts as names.
    fn texts(&self, list: &[Expr]) -> Vec<String> {
        list.iter().map(|e| self.text(*e)).collect()
    }

    /// Returns definitions as JSON, each after the shared parts that it contains. The shared parts of `formulas`
    /// follow.
    fn definitions(&mut self, list: &[Definition], formulas: &[Expr]) -> Vec<Value> {
        let mut out = Vec::new();
        for step in list {
            self.define_parts(&[step.value], &mut out);
            let name = self.arena.symbol_name(step.symbol).unwrap_or_default();
            out.push(json!({ "name": name, "value": self.text(step.value) }));
        }
        self.define_parts(formulas, &mut out);
        out
    }

    /// Adds the definitions of the shared parts in `formulas` that are not written yet.
    fn define_parts(&mut self, formulas: &[Expr], out: &mut Vec<Value>) {
        if self.defined.len() == self.parts.len() {
            return;
        }
        for part in self.arena.shown_subterms(formulas) {
            if let Some(name) = self.names.get(&part).filter(|_| !self.defined.contains(&part)) {
                out.push(json!({ "name": name, "value": self.text(part) }));
                self.defined.insert(part);
            }
        }
    }
}
