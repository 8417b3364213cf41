//! Inputs of a scene: numbers, formulas, or tables of a signal, which a scene gives to the inputs of its model.

use crate::algebra::Arena;
use crate::algebra::text::parse::parse;
use crate::diagnostic::{Diagnostics, Source, nearest_name_advice};
use crate::model::{Input, InputBinding, Model, StatedUnit, TIME};
use crate::scene::numbers::number_reader::{InputNumber, ValueReader};
use crate::scene::numbers::signal_table::{Interpolation, signal_table_formula};
use crate::toml_reader::{Located, TomlReader};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Key of the section of a scene file that gives values to inputs.
const INPUTS: &str = "inputs";

/// Formulas that a scene gives to inputs of its model, with their place in the scene file.
#[derive(Default)]
pub struct InputBindings {
    /// Formulas for inputs, in the order of the scene file.
    pub bindings: Vec<InputBinding>,
    /// Byte range of the section `[inputs]` in the scene file; empty if there is no such section.
    pub place: Range<usize>,
}

/// Replaces inputs of a model by the formulas that a scene or state file gives to them. Returns `Diagnostics` if one
/// of these formulas is wrong.
pub(in crate::scene) fn bind_inputs(source: &Source, model: &mut Model) -> Result<(), Diagnostics> {
    let (reader, table) = TomlReader::parse(source)?;
    let mut values = ValueReader::new(reader, model);
    let given = values.inputs(table.get_ref());
    values.reader.finish()?;
    if given.bindings != model.bindings {
        *model = model.reread_with_inputs(given.bindings, source, given.place)?;
    }
    Ok(())
}

impl<'a> ValueReader<'a, '_> {
    /// Reads the formulas of the section `[inputs]` of a scene file. Numbers for inputs that are parameters are left
    /// out. Wrong entries are reported.
    pub(in crate::scene) fn inputs(&mut self, table: &'a DeTable<'a>) -> InputBindings {
        let mut given = InputBindings::default();
        let Some(section) = self.section(table, INPUTS) else { return given };
        given.place = self.reader.get(table, INPUTS).map_or(0..0, Spanned::span);
        for (name, value) in self.reader.entries(section) {
            let Some(input) = self.model.inputs.iter().find(|input| input.name == name.text) else {
                let help = nearest_name_advice(&name.text, self.model.inputs.iter().map(|input| input.name.as_str()));
                self.reader.error(name.span, format!("the model has no input `{}`", name.text), help);
                continue;
            };
            let takes_numbers = self.takes_numbers(input);
            let formula = match value.get_ref() {
                DeValue::Table(_) => self.input_table_formula(table, &name, value),
                _ => self.reader.formula(value, "an input").filter(|formula| self.is_input_signal(formula)),
            };
            let Some(formula) = formula else { continue };
            if !takes_numbers || !Self::is_input_number(&formula) {
                given.bindings.push(InputBinding { input: name.text, formula: formula.text });
            }
        }
        given
    }

    /// True if a number that a scene gives to this input becomes the value of a parameter. False if a formula
    /// replaces the input.
    fn takes_numbers(&self, input: &Input) -> bool {
        input.is_parameter && self.model.bindings.iter().all(|binding| binding.input != input.name)
    }

    /// Reads the numbers that a scene file gives to inputs of the model. Formulas are left out.
    pub(in crate::scene) fn numbers_of_inputs(&mut self, table: &'a DeTable<'a>) -> Vec<InputNumber> {
        let mut numbers = Vec::new();
        // Errors of the section are reported where its formulas are read.
        let Some(section) = table.get(INPUTS).and_then(|value| value.get_ref().as_table()) else { return numbers };
        for (name, value) in self.reader.entries(section) {
            let input = self.model.inputs.iter().find(|input| input.name == name.text);
            let Some(input) = input.filter(|input| self.takes_numbers(input)).cloned() else { continue };
            if value.get_ref().is_table() {
                continue;
            }
            let formula = self.reader.formula(value, "an input").filter(Self::is_input_number);
            let Some(formula) = formula else { continue };
            self.check_unit(&formula, &input.unit, &name.text);
            let at = self.model.parameters.iter().position(|p| p.name == name.text);
            if let (Some(parameter), Some(number)) = (at, self.constant(&formula)) {
                numbers.push(InputNumber { parameter, number, span: formula.span });
            }
        }
        numbers
    }

    /// True if a formula is a number with an optional unit, without any name.
    fn is_input_number(formula: &Located) -> bool {
        let number =
            StatedUnit::of(&formula.text).map_or_else(|| formula.clone(), |stated| stated.number_before_unit(formula));
        let mut known = |arena: &mut Arena, name: &str| match name {
            "deg" => Ok(arena.pi()),
            _ => Err((String::new(), None)),
        };
        parse(&mut Arena::new(), &number.text, &mut known).is_ok()
    }

    /// True if every name in a formula may occur in an input's formula. Otherwise reports the name and returns false.
    fn is_input_signal(&mut self, formula: &Located) -> bool {
        if Self::is_input_number(formula) {
            return true;
        }
        let model = &*self.model;
        let mut known: Vec<String> = model.parameters.iter().filter(|p| !p.is_input).map(|p| p.name.clone()).collect();
        let coordinates = model.coordinates.iter().filter(|c| c.name != TIME);
        known.extend(coordinates.flat_map(|c| [c.name.clone(), format!("{}'", c.name)]));
        known.extend(model.constraints.iter().map(|c| c.fixes.clone()));
        known.extend(model.speeds.iter().map(|s| s.name.clone()));
        known.push(TIME.to_owned());
        let mut arena = model.arena.clone();
        let result = parse(&mut arena, &formula.text, &mut |arena, name| {
            if known.iter().any(|known| known == name) {
                return Ok(arena.symbol(name));
            }
            Err((
                format!("`{name}` cannot stand in an input"),
                Some(nearest_name_advice(name, known.iter().map(String::as_str))),
            ))
        });
        if let Err(error) = &result {
            self.reader.error(
                formula.part(error.span.clone()),
                error.message.clone(),
                error.help.clone().unwrap_or_default(),
            );
        }
        result.is_ok()
    }

    /// Formula of t for an input whose signal a CSV table gives: `{ table = "drive.csv", column = "F" }`. `None`
    /// after an error is reported.
    fn input_table_formula(
        &mut self,
        file: &'a DeTable<'a>,
        name: &Located,
        value: &'a Spanned<DeValue<'a>>,
    ) -> Option<Located> {
        let what = format!("input `{}`", name.text);
        let entry = self.reader.table(value, &what, "{ table = \"drive.csv\", column = \"F\" }")?;
        self.reader.report_unknown_keys(entry, &what, &["table", "time", "column", "interpolation"]);
        let path = self.reader.required(entry, "table", &what, &name.span)?;
        let path = self.reader.string(path, "`table`")?;
        let mut column = |key: &str, default: &str| match self.reader.get(entry, key) {
            Some(value) => self.reader.string(value, &format!("`{key}`")).map(|text| text.text),
            None => Some(default.to_owned()),
        };
        let (time, column) = (column("time", TIME)?, column("column", &name.text)?);
        let how = self.choice(Some(entry), "interpolation", &["linear", "cubic"]);
        let how = if how == Some("cubic") { Interpolation::Cubic } else { Interpolation::Linear };
        let span = self.span_of_input_table(file)?;
        let folder = self.reader.source.path.parent().map(std::path::Path::to_owned).unwrap_or_default();
        match signal_table_formula(&folder.join(&path.text), [&time, &column], how, span) {
            Ok(text) => Some(Located { text, span: path.span, exact: false }),
            Err((message, help)) => {
                self.reader.error(path.span, message, help);
                None
            }
        }
    }

    /// First and last instant of a scene's span, s, the smaller value first. `None` after an error is reported.
    fn span_of_input_table(&mut self, file: &'a DeTable<'a>) -> Option<(f64, f64)> {
        let parameters = self.parameters(file)?;
        let (from, to) = self.scene_span(file, &parameters)?;
        Some((from.double.min(to.double), from.double.max(to.double)))
    }
}
