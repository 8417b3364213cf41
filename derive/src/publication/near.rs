//! Keys `about` and `order` of a publication file: formulas that hold near a point only, up to an order in the
//! deviations from the point.

use super::read::Loading;
use super::{Approximation, PointValue};
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{nearest, shown};
use crate::read::Located;
use toml::de::{DeTable, DeValue};

/// Highest order of an approximation that a publication file may state.
const MOST: u32 = 4;

impl<'a> Loading<'a, '_> {
    /// Reads the point and the order that a table states. If the table states none, those of the publication file are
    /// returned. `None` if the table states an empty point.
    pub fn near(&mut self, table: &'a DeTable<'a>) -> Option<Approximation> {
        let order = self.order(table);
        let Some(value) = self.reader.get(table, "about") else {
            return match (&self.near, order) {
                (Some(near), Some(order)) => Some(Approximation { order, ..near.clone() }),
                (near, None) => near.clone(),
                (None, Some(_)) => {
                    let span = self.reader.get(table, "order").map_or(0..0, toml::Spanned::span);
                    let help = "add the point, as in about = { q1 = 0 }";
                    self.reader.error(span, "`order` without a point that it is about", help);
                    None
                }
            };
        };
        let point = self.reader.table(value, "`about`", "about = { q1 = 0, u3 = \"w\" }")?;
        let mut values = Vec::new();
        for (name, value) in self.reader.entries(point) {
            if self.words.is_renamed(&name.text) {
                let message = format!("`{}` is the publication's own in this file", shown(&name.text));
                self.reader.error(name.span, message, "give its coordinate a name that the model does not have");
                continue;
            }
            let formula = self.reader.formula(value, &format!("`{}`", shown(&name.text)));
            let symbol = self.stays(&name);
            let value = formula.and_then(|f| self.of_parameters(&f));
            if let (Some(symbol), Some(value)) = (symbol, value) {
                values.push(PointValue { name: name.text, symbol, value });
            }
        }
        let order = order.or(self.near.as_ref().map(|near| near.order)).unwrap_or(1);
        (!values.is_empty()).then_some(Approximation { order, values })
    }

    fn order(&mut self, table: &'a DeTable<'a>) -> Option<u32> {
        let value = self.reader.get(table, "order")?;
        let order = match value.get_ref() {
            DeValue::Integer(n) => n.as_str().parse::<u32>().ok(),
            _ => None,
        };
        let order = order.filter(|order| (1..=MOST).contains(order));
        if order.is_none() {
            let help = "1 for linear formulas, 2 for energies of linear equations";
            self.reader.error(value.span(), format!("`order` must be a whole number from 1 to {MOST}"), help);
        }
        order
    }

    /// Symbol of a coordinate, a time derivative, a speed or a reaction by its name; reports another name.
    fn stays(&mut self, name: &Located) -> Option<crate::algebra::Expr> {
        let model = &self.model;
        let mut known = Vec::new();
        for c in &model.coordinates {
            known.extend([(c.name.clone(), c.symbol), (format!("{}'", c.name), c.rate)]);
        }
        known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        known.extend(model.reactions.iter().map(|r| (r.name.clone(), r.symbol)));
        if let Some((_, symbol)) = known.iter().find(|(n, _)| *n == name.text) {
            return Some(*symbol);
        }
        let message = format!("`{}` is no coordinate, time derivative, speed or reaction", shown(&name.text));
        self.reader.error(name.span.clone(), message, nearest(&name.text, known.iter().map(|(n, _)| n.as_str())));
        None
    }

    /// Reads a formula in parameters, in the language of model files; reports other symbols.
    fn of_parameters(&mut self, formula: &Located) -> Option<crate::algebra::Expr> {
        let e = self.formula(formula, Notation::default())?;
        let (arena, parameters) = (&self.model.arena, self.model.p());
        let other = arena
            .reachable(&[e])
            .into_iter()
            .find(|part| arena.symbol_name(*part).is_some() && !parameters.contains(part));
        if let Some(symbol) = other.and_then(|part| arena.symbol_name(part)) {
            let message = format!("`{symbol}` is no parameter: a point stays where it is");
            self.reader.error(formula.span.clone(), message, "write numbers and parameters of the model");
            return None;
        }
        Some(e)
    }
}
