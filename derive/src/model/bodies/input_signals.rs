//! Inputs that drive loads: parameters that a program may change during a run, or formulas that scenes give instead.
//!
//! A formula replaces its input before equations are derived, so derivatives and series of the equations include the
//! formula. Only the code that reads files knows the loads that an input affects.

use super::elements::Elements;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr, Rational};
use crate::model::input::{Input, InputBinding};
use crate::model::reading::declared_names::{AllowedQuantities, NameKind};
use crate::model::reading::loading::Loading;
use crate::model::{DomainCondition, Parameter, StatedUnit, Unit};
use crate::toml_reader::Located;
use toml::de::{DeTable, DeValue};

/// Kinds of quantities that the formula of an input may contain.
const PARTS: AllowedQuantities =
    AllowedQuantities(&[NameKind::Parameter, NameKind::Coordinate, NameKind::Rate, NameKind::Speed]);

/// Inputs of a model, and the formulas that replace inputs.
pub struct InputSignals {
    /// Inputs, in the order of the model file.
    pub list: Vec<Input>,
    /// Symbols of the inputs that have a formula, each with its term.
    replacements: Vec<(Expr, Expr)>,
}

impl InputSignals {
    /// Replaces inputs by their formulas in the elements of the mechanism and in the conditions of the domain.
    pub fn put_in(&self, arena: &mut Arena, elements: &mut Elements, domain: &mut [DomainCondition]) {
        if self.replacements.is_empty() {
            return;
        }
        let mut put = Substitution::new(&self.replacements);
        elements.rewrite(&mut |e| put.apply(arena, e));
        for condition in domain {
            condition.positive = put.apply(arena, condition.positive);
        }
    }
}

impl<'a> Loading<'a> {
    /// Reads `[inputs]`. An input whose value is a number becomes a parameter, which is added to
    /// `parameters`. Errors are recorded in the reader.
    pub fn inputs(&mut self, table: &'a DeTable<'a>, parameters: &mut Vec<Parameter>) -> InputSignals {
        let (mut list, mut replacements) = (Vec::new(), Vec::new());
        for (name, value) in self.section(table, "inputs", &[NameKind::Input]) {
            let symbol = self.arena.symbol(&name.text);
            let example = "{ unit = \"N\", value = 0 }";
            let Some((entry, what)) = self.entry(&name, value, NameKind::Input, Some(symbol), example) else {
                continue;
            };
            self.reader.report_unknown_keys(entry, "an input", &["unit", "value", "about"]);
            let Some(unit) = self.read_unit_key(entry, &name) else { continue };
            self.units.insert(symbol, unit.clone());
            let about = self.about(entry);
            let bound = self.bindings.iter().find(|binding| binding.input == name.text);
            let formula = match (bound, self.reader.get(entry, "value")) {
                // Errors in the formula that a scene gives were already reported with the scene's file.
                (Some(binding), _) => {
                    Some(Located { text: binding.formula.clone(), span: name.span.clone(), exact: false })
                }
                (None, Some(value)) => self.reader.formula(value, &format!("the value of {what}")),
                (None, None) => Some(Located { text: "0".to_owned(), span: name.span.clone(), exact: false }),
            };
            let e = formula.and_then(|formula| {
                let (formula, stated) = self.number_of_input(&formula, &unit, &what)?;
                let what = format!("the value of {what}");
                let e = self.names.formula(&mut self.reader, &mut self.arena, &formula, PARTS, &what)?;
                Some(stated.map_or(e, |stated| stated.apply(&mut self.arena, e)))
            });
            let Some(e) = e else {
                self.names.mark_wrong_name(&name.text);
                continue;
            };
            let number = match self.arena.as_number(e) {
                Some(number) => Some(number.clone()),
                None if self.arena.reachable(&[e]).iter().all(|part| self.arena.symbol_name(*part).is_none()) => {
                    crate::model::impossible_bodies::values_of_terms_at(&self.arena, &[], &[e])
                        .and_then(|values| Rational::from_f64_exact(values[0]))
                }
                None => None,
            };
            let is_varied = number.is_none() && self.varied.contains(&name.text);
            let is_parameter = number.is_some();
            if is_parameter || is_varied {
                let (name, unit, about) = (name.text.clone(), unit.clone(), about.clone());
                parameters.push(Parameter {
                    name,
                    symbol,
                    unit,
                    value: number.or(Some(Rational::ZERO)),
                    positive: false,
                    is_input: true,
                    about,
                });
            }
            let value = match (is_parameter, is_varied) {
                (true, _) => symbol,
                (false, true) => self.arena.add(e, symbol),
                (false, false) => e,
            };
            if !is_parameter {
                replacements.push((symbol, value));
            }
            list.push(Input { name: name.text, unit, about, value, is_parameter });
        }
        InputSignals { list, replacements }
    }

    /// Splits the value of an input into its number and the unit that may follow it. `None` after reporting a unit
    /// whose dimension is not that of the input.
    fn number_of_input(&mut self, formula: &Located, unit: &Unit, what: &str) -> Option<(Located, Option<StatedUnit>)> {
        let Some(stated) = StatedUnit::of(&formula.text) else { return Some((formula.clone(), None)) };
        if stated.unit != *unit {
            let (needed, found) = (unit.unit_words(), stated.unit.unit_words());
            let message = format!("the value of {what} must be in {needed}, but `{}` is in {found}", formula.text);
            self.reader.error(formula.span.clone(), message, format!("state it in {needed}"));
            return None;
        }
        Some((stated.number_before_unit(formula), Some(stated)))
    }
}

/// Texts of the input formulas that apply. A formula that the scene gives takes the place of the model file's
/// formula.
pub fn input_signal_formulas<'t>(table: &'t DeTable<'_>, bindings: &'t [InputBinding]) -> Vec<&'t str> {
    let inputs = table.get("inputs").and_then(|value| value.get_ref().as_table());
    let stated = inputs.into_iter().flat_map(|inputs| inputs.iter()).filter_map(|(name, value)| {
        let is_bound = bindings.iter().any(|binding| binding.input == *name.get_ref());
        let value = value.get_ref().as_table()?.get("value")?;
        if let (false, DeValue::String(text)) = (is_bound, value.get_ref()) { Some(text.as_ref()) } else { None }
    });
    stated.chain(bindings.iter().map(|binding| binding.formula.as_str())).collect()
}
