//! Section `[assembly]` of a model file: values of coordinates near which the mechanism is assembled.

use crate::algebra::{Arena, Expr};
use crate::geometry::{Frame, Turn};
use crate::model::Coordinate;
use crate::model::impossible_bodies::values_of_terms_at;
use crate::model::reading::declared_names::{NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::toml_reader::Entry;
use std::ops::Range;
use toml::de::DeTable;

/// Values of coordinates near which a mechanism is assembled, as the model file states them.
pub struct Assembly {
    /// Coordinates with their values, terms of parameters in SI units.
    values: Vec<(Expr, Expr)>,
    /// Place of the section in the model file, as a byte range.
    pub place: Range<usize>,
}

impl<'a> Loading<'a> {
    /// Reads the section `[assembly]` of a model file. `None` if the file has no such section.
    pub fn assembly(&mut self, table: &'a DeTable<'a>) -> Option<Assembly> {
        let place = self.reader.get(table, "assembly")?.span();
        let entries = self.section(table, "assembly", &[]);
        let values = self.coordinate_values(entries);
        Some(Assembly { values, place })
    }

    /// Reads values of coordinates as pairs (coordinate, value). Errors are recorded in the reader.
    pub fn coordinate_values(&mut self, entries: Vec<Entry<'a>>) -> Vec<(Expr, Expr)> {
        const WHAT: &str = "a coordinate's value";
        let mut pairs = Vec::new();
        for (name, value) in entries {
            if !self.names.expect(&mut self.reader, &name, NameKind::Coordinate) {
                continue;
            }
            let Some(formula) = self.reader.formula(value, WHAT) else { continue };
            let symbol = self.arena.symbol(&name.text);
            let Some(unit) = self.units.get(&symbol).cloned() else { continue };
            // A plain number counts as being in the coordinate's own unit, so its unit needs no check.
            let plain = self.names.formula(&mut self.reader, &mut self.arena, &formula, PARAMETERS, WHAT);
            let Some(e) = plain else { continue };
            if self.arena.as_number(e).is_none() {
                self.quantity(&formula, PARAMETERS, &unit, WHAT);
            }
            pairs.push((symbol, e));
        }
        pairs
    }
}

impl Assembly {
    /// Value of each coordinate in SI units at given values of the parameters. Without a value, the first Euler
    /// parameter of a frame is 1, and other coordinates are 0. `None` if a value is not known.
    pub fn pose(
        &self,
        arena: &Arena,
        coordinates: &[Coordinate],
        frames: &[Frame],
        known: &[(Expr, f64)],
    ) -> Option<Vec<f64>> {
        let first: Vec<Expr> = frames.iter().filter_map(first_euler_parameter).collect();
        let terms: Vec<Expr> = self.values.iter().map(|(_, value)| *value).collect();
        let values = values_of_terms_at(arena, known, &terms)?;
        let stated = |symbol: Expr| self.values.iter().position(|(own, _)| *own == symbol).map(|at| values[at]);
        let without = |symbol: &Expr| if first.contains(symbol) { 1.0 } else { 0.0 };
        Some(coordinates.iter().map(|c| stated(c.symbol).unwrap_or_else(|| without(&c.symbol))).collect())
    }
}

/// Symbol of the first Euler parameter of a frame; `None` for frames that other quantities turn.
fn first_euler_parameter(frame: &Frame) -> Option<Expr> {
    let (_, turn @ Turn::Oriented(oriented)) = frame.rotation.as_ref()? else { return None };
    if oriented.spins.is_empty() { None } else { turn.quantities().first().copied() }
}
