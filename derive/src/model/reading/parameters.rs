//! Parameters of a model file, and the plain numbers that are their default values.

use super::declared_names::{CONSTANT, NameKind};
use super::loading::Loading;
use crate::algebra::Rational;
use crate::diagnostic::shortened_for_message;
use crate::model::Parameter;
use crate::model::units::StatedUnit;
use crate::toml_reader::Located;
use toml::de::{DeTable, DeValue};

impl<'a> Loading<'a> {
    /// Reads the section `[parameters]` of a model file. Errors are recorded in the reader.
    pub fn parameters(&mut self, table: &'a DeTable<'a>) -> Vec<Parameter> {
        let mut parameters = Vec::new();
        for (name, value) in self.section(table, "parameters", &[NameKind::Parameter]) {
            let symbol = self.arena.symbol(&name.text);
            let example = "{ unit = \"kg\", value = 1, positive = true }";
            if let DeValue::String(text) = value.get_ref()
                && let Some(stated) = StatedUnit::of(text)
            {
                // The short form `l = "0.5 m"` declares a parameter with its unit and value.
                self.names.declare(&mut self.reader, &name, NameKind::Parameter, Some(symbol));
                self.units.insert(symbol, stated.unit.clone());
                let number = self
                    .reader
                    .formula(value, "a parameter")
                    .and_then(|formula| self.constant_parameter_value(&formula));
                let (unit, about) = (stated.unit, String::new());
                parameters.push(Parameter {
                    name: name.text,
                    symbol,
                    unit,
                    value: number,
                    positive: false,
                    is_input: false,
                    about,
                });
                continue;
            }
            let Some((entry, _)) = self.entry(&name, value, NameKind::Parameter, Some(symbol), example) else {
                continue;
            };
            self.reader.report_unknown_keys(entry, "a parameter", &["unit", "value", "positive", "about"]);
            let of_value = self.reader.get(entry, "value").and_then(|v| StatedUnit::of(v.get_ref().as_str()?));
            let unit = match &of_value {
                Some(stated) if !entry.contains_key("unit") => Some(stated.unit.clone()),
                _ => self.read_unit_key(entry, &name),
            };
            if let (Some(stated), Some(unit)) = (&of_value, &unit)
                && stated.unit != *unit
                && let Some(value) = self.reader.get(entry, "value")
            {
                let message = format!(
                    "the value of `{}` is in {}, not in {}",
                    name.text,
                    stated.unit.unit_words(),
                    unit.unit_words()
                );
                self.reader.error(value.span(), message, "state both in units of one kind");
            }
            self.units.extend(unit.clone().map(|unit| (symbol, unit)));
            let positive = self.reader.get(entry, "positive");
            let positive = positive.and_then(|v| self.reader.boolean(v, "`positive`")).unwrap_or(false);
            if positive {
                self.arena.assume_positive(symbol);
            }
            let value = self.reader.get(entry, "value").and_then(|v| {
                let formula = self.reader.formula(v, "`value`")?;
                let number = self.constant_parameter_value(&formula)?;
                if positive && (number.is_negative() || number.is_zero()) {
                    let stated = shortened_for_message(&formula.text);
                    let message =
                        format!("the parameter `{}` is declared positive, but its value is {stated}", name.text);
                    self.reader.error(formula.span, message, "change the value or remove `positive = true`");
                    return None;
                }
                Some(number)
            });
            let about = self.about(entry);
            let unit = unit.unwrap_or_default();
            parameters.push(Parameter { name: name.text, symbol, unit, value, positive, is_input: false, about });
        }
        parameters
    }

    /// Value in SI units of a formula that must be a plain number, with an optional unit. `None` after reporting any
    /// other formula.
    pub(super) fn constant_parameter_value(&mut self, formula: &Located) -> Option<Rational> {
        let what = "a parameter's value";
        let stated = StatedUnit::of(&formula.text);
        let number = stated.as_ref().map_or_else(|| formula.clone(), |stated| stated.number_before_unit(formula));
        let mut e = self.names.formula(&mut self.reader, &mut self.arena, &number, CONSTANT, what)?;
        if let Some(stated) = stated {
            e = stated.apply(&mut self.arena, e);
        }
        let value = match self.arena.as_number(e) {
            Some(value) => Some(value.clone()),
            None => crate::model::impossible_bodies::values_of_terms_at(&self.arena, &[], &[e])
                .and_then(|v| Rational::from_f64_exact(v[0])),
        };
        // Values that overflow a double, or underflow to 0, are refused.
        let value = value.filter(|v| v.to_f64().is_finite() && (v.is_zero() || v.to_f64().is_normal()));
        if value.is_none() {
            let message = format!("`{}` is not a number of double precision", shortened_for_message(&formula.text));
            self.reader.error(formula.span.clone(), message, "give 0 or a number between 1e-307 and 1e308 in size");
        }
        value
    }
}
