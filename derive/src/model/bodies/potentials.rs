//! Potential energies that a model file states. They depend only on coordinates, positions and time.

use crate::algebra::Expr;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::model::Potential;
use crate::model::reading::declared_names::{NameKind, PLACES};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::toml_reader::Located;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Potential energy as an entry of the model file states it, with the byte range of its formula.
pub struct StatedPotential {
    /// Name of the potential in the model file.
    name: Located,
    /// Energy, J, as a term in parameters, coordinates and positions.
    energy: Expr,
    /// Byte range of the formula in the model file.
    span: Range<usize>,
}

impl<'a> Loading<'a> {
    /// Reads the section `[potentials]` of a model file. Errors are recorded in the reader.
    pub fn potentials(&mut self, table: &'a DeTable<'a>) -> Vec<StatedPotential> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "potentials", &[]) {
            self.names.declare(&mut self.reader, &name, NameKind::Potential, None);
            let what = format!("potential `{}`", name.text);
            let value = match value.get_ref() {
                DeValue::Table(entry) => {
                    self.reader.report_unknown_keys(entry, "a potential", &["value", "about"]);
                    self.about(entry);
                    self.reader.required(entry, "value", &what, &name.span)
                }
                _ => Some(value),
            };
            let Some(formula) = value.and_then(|value| self.reader.formula(value, &what)) else { continue };
            let Some(energy) = self.quantity(&formula, PLACES, &Unit::new(2, 1, -2), &what) else { continue };
            list.push(StatedPotential { name, energy, span: formula.span });
        }
        list
    }

    /// Replaces named positions in the stated potentials by terms in coordinates. A potential that exerts no force is
    /// reported and left out.
    pub fn potentials_with_positions(
        &mut self,
        put: &mut Substitution,
        stated: Vec<StatedPotential>,
    ) -> Vec<Potential> {
        let time = self.arena.find_symbol(crate::model::TIME);
        let mut along_time = Gradient::new(&time.into_iter().collect::<Vec<_>>());
        let mut coordinates = self.names.symbols_of(&[NameKind::Coordinate]);
        coordinates.retain(|symbol| Some(*symbol) != time);
        let mut along = Gradient::new(&coordinates);
        let mut list = Vec::new();
        for StatedPotential { name, energy, span } in stated {
            let explicit = along_time.apply(&mut self.arena, energy).iter().map(|(_, slope)| *slope).next();
            let explicit_rate = put.apply(&mut self.arena, explicit.unwrap_or(Expr::ZERO));
            let energy = put.apply(&mut self.arena, energy);
            if let Some(term) = put.undefined {
                let term = crate::algebra::text::print::print_text(&self.arena, term);
                let message = format!("the potential `{}` divides by a term that is always zero, in {term}", name.text);
                self.reader.error(span, message, "name places that move apart");
            } else if along.apply(&mut self.arena, energy).is_empty() {
                let message = format!("potential `{}` depends on no coordinate: it exerts nothing", name.text);
                self.reader.error(span, message, "name a coordinate, a position or a distance that changes");
            } else {
                list.push(Potential { name: name.text, energy, explicit_rate });
            }
        }
        list
    }
}
