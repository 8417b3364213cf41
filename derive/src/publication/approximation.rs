//! Reading of the keys `about`, `small` and `order`, which say that formulas hold near a point.
//!
//! At the point, variables have given values, or parameters are zero. The formulas hold up to an order in the
//! deviations from the point.

use super::publication_reader::PublicationReader;
use super::{Approximation, PointValue};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::toml_reader::Located;
use toml::de::{DeTable, DeValue};

/// Highest order of an approximation that a publication file may give.
const MOST: u32 = 4;

impl<'a> PublicationReader<'a, '_> {
    /// Reads the point, the small parameters and the order from a table. Values that the table lacks are taken from the
    /// top of the publication file. `None` if there is no point and no small parameter, or if an error is reported.
    pub fn read_approximation(&mut self, table: &'a DeTable<'a>) -> Option<Approximation> {
        let order = self.read_order(table);
        let small = self.read_small_parameters(table);
        let is_stated = self.reader.get(table, "about").is_some();
        let mut values = match &self.near {
            _ if is_stated => self.read_point(table)?,
            Some(near) => near.values.clone(),
            None => Vec::new(),
        };
        for parameter in small {
            if values.iter().all(|known| known.symbol != parameter.symbol) {
                values.push(parameter);
            }
        }
        if values.is_empty() {
            if let Some(order) = self.reader.get(table, "order").filter(|_| !is_stated) {
                let help = "add the point, as in about = { q1 = 0 }, or what is small, as in small = [\"epsilon\"]";
                self.reader.error(order.span(), "`order` without a point that it is about", help);
            }
            return None;
        }
        let order = order.or(self.near.as_ref().map(|near| near.order)).unwrap_or(1);
        Some(Approximation { order, values })
    }

    /// Reads the values of variables at the point from the key `about` of a table; `None` if the key is absent or
    /// wrong.
    fn read_point(&mut self, table: &'a DeTable<'a>) -> Option<Vec<PointValue>> {
        let value = self.reader.get(table, "about")?;
        let point = self.reader.table(value, "`about`", "about = { q1 = 0, u3 = \"w\" }")?;
        let mut values = Vec::new();
        for (name, value) in self.reader.entries(point) {
            if self.words.is_renamed(&name.text) {
                let message = format!("`{}` is the publication's own in this file", shortened_for_message(&name.text));
                self.reader.error(name.span, message, "give its coordinate a name that the model does not have");
                continue;
            }
            let formula = self.reader.formula(value, &format!("`{}`", shortened_for_message(&name.text)));
            let symbol = self.point_variable(&name);
            let value = formula.and_then(|f| self.read_approximation_value(&f));
            if let (Some(symbol), Some(value)) = (symbol, value) {
                values.push(PointValue { name: name.text, symbol, value });
            }
        }
        Some(values)
    }

    /// Reads the parameters under the key `small` of a table, each with the value 0 at the point.
    fn read_small_parameters(&mut self, table: &'a DeTable<'a>) -> Vec<PointValue> {
        let Some(value) = self.reader.get(table, "small") else { return Vec::new() };
        let DeValue::Array(array) = value.get_ref() else {
            self.reader.error(value.span(), "`small` must be a list of names", "write small = [\"epsilon\"]");
            return Vec::new();
        };
        let mut list = Vec::new();
        for name in array {
            let Some(name) = self.reader.string(name, "a small parameter") else { continue };
            if let Some(p) = self.model.parameters.iter().find(|p| p.name == name.text) {
                list.push(PointValue { name: name.text, symbol: p.symbol, value: Expr::ZERO });
                continue;
            }
            let message = format!("`{}` is no parameter", shortened_for_message(&name.text));
            let help = nearest_name_advice(&name.text, self.model.parameters.iter().map(|p| p.name.as_str()));
            self.reader.error(name.span, message, help);
        }
        list
    }

    /// Reads the order under the key `order` of a table, from 1 to 4; `None` if the key is absent or wrong.
    fn read_order(&mut self, table: &'a DeTable<'a>) -> Option<u32> {
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

    /// Symbol of the coordinate, time derivative, speed or reaction with this name. Reports any other name and returns
    /// `None`.
    fn point_variable(&mut self, name: &Located) -> Option<Expr> {
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
        let message =
            format!("`{}` is no coordinate, time derivative, speed or reaction", shortened_for_message(&name.text));
        self.reader.error(
            name.span.clone(),
            message,
            nearest_name_advice(&name.text, known.iter().map(|(n, _)| n.as_str())),
        );
        None
    }

    /// Reads a formula that contains only parameters, in the language of model files. Reports other symbols and returns
    /// `None`.
    fn read_approximation_value(&mut self, formula: &Located) -> Option<Expr> {
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
