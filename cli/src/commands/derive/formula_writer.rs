//! Formulas of a derivation as text, with names for the parts that long formulas share.
//!
//! Without these names, a part would be written wherever it occurs, and a mechanism with several closed loops would
//! take a hundred megabytes.

use rustc_hash::FxHashSet;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::display_tree::SharedNames;
use tripos_derive::algebra::text::print::{long_parts, print_whole_view, text_of};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Equations, Step};

/// Lists every formula of the equations and stages, except those of accelerations and definitions.
pub fn formulas_in_derivation(e: &Equations, steps: &[Step]) -> Vec<Expr> {
    let lists = [&e.unknowns, &e.forcing, &e.coordinate_rates, &e.divisors].into_iter().chain(&e.matrix).flatten();
    let lines = steps.iter().flat_map(|step| step.lines.iter().map(|(_, value)| value));
    lists.chain(lines).chain(&[e.kinetic_energy, e.potential_energy, e.power]).copied().collect()
}

/// Writer of formulas as text. It gives names to the parts that long formulas share.
pub struct FormulaWriter<'a> {
    /// Arena that stores the terms (symbolic expressions).
    arena: &'a Arena,
    /// Names of shared parts; the key is the term.
    names: SharedNames,
    /// Shared parts that have names, each after the parts that it contains.
    parts: Vec<Expr>,
    /// Parts whose definitions are already written.
    defined: FxHashSet<Expr>,
}

impl<'a> FormulaWriter<'a> {
    /// Finds the shared parts of the given formulas and names them, such as `part_1_kane`.
    pub fn new(arena: &'a Arena, equations: &Equations, formulas: &[Expr]) -> Self {
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
    pub fn text(&self, e: Expr) -> String {
        text_of(&print_whole_view(self.arena, e, &self.names))
    }

    /// Returns formulas as texts, with shared parts as names.
    pub fn texts(&self, list: &[Expr]) -> Vec<String> {
        list.iter().map(|e| self.text(*e)).collect()
    }

    /// Returns definitions as pairs (name, formula), each after the shared parts that it contains. The shared parts of
    /// `formulas` follow.
    pub fn definitions(&mut self, list: &[Definition], formulas: &[Expr]) -> Vec<(String, String)> {
        let mut out = Vec::new();
        for step in list {
            self.define_parts(&[step.value], &mut out);
            let name = self.arena.symbol_name(step.symbol).unwrap_or_default();
            out.push((name.to_owned(), self.text(step.value)));
        }
        self.define_parts(formulas, &mut out);
        out
    }

    /// Adds the definitions of the shared parts in `formulas` that are not written yet.
    fn define_parts(&mut self, formulas: &[Expr], out: &mut Vec<(String, String)>) {
        if self.defined.len() == self.parts.len() {
            return;
        }
        for part in self.arena.shown_subterms(formulas) {
            if let Some(name) = self.names.get(&part).filter(|_| !self.defined.contains(&part)) {
                out.push((name.clone(), self.text(part)));
                self.defined.insert(part);
            }
        }
    }
}
