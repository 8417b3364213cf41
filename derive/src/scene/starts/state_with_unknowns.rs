//! States with unknowns: numbers under `[guess]` are solved for, from these values. All other numbers are held.

use crate::algebra::{Expr, Rational};
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::model::{Model, TIME, not_a_name};
use crate::scene::SceneOutput;
use crate::scene::numbers::number_reader::{NamedNumber, ValueReader, VariedNumber};
use crate::scene::numbers::scene_number::{Number, double_values, extended_values};
use crate::scene::settings::inputs::bind_inputs;
use crate::scene::settings::outputs::ENERGIES;
use crate::toml_reader::{Located, TomlReader};
use toml::de::DeTable;
use tripos_traits::DoubleDouble;

/// State in which guessed numbers are unknowns. They are to be solved for so that conditions are satisfied.
#[derive(Clone, Debug, Default)]
pub struct StateWithUnknowns {
    /// Values of the parameters in SI units, in the order of the model, to 32 digits.
    pub parameters: Vec<DoubleDouble>,
    /// Values of the parameters as rational numbers, in the order of the model. `None` for a value that is not known
    /// exactly.
    pub rational: Vec<Option<Rational>>,
    /// Values of the coordinates, then of the generalized speeds, in SI units. They are stated or guessed values.
    pub x: Vec<DoubleDouble>,
    /// Formula of each coordinate and speed, as a term in parameters and names that the state file
    /// defines.
    pub formulas: Vec<Expr>,
    /// Indices in [`Self::x`] of the unknowns: the numbers under `[guess]`.
    pub sought: Vec<usize>,
    /// Numbers with names that the state file defines for its own formulas.
    pub names: Vec<NamedNumber<DoubleDouble>>,
    /// Outputs to show; empty if the state file states none.
    pub outputs: Vec<SceneOutput>,
}

/// Keys that a state file may have. Keys of scene files are permitted, but ignored.
const KEYS: [&str; 20] = [
    "schema",
    "model",
    "title",
    "about",
    "names",
    "parameters",
    "inputs",
    "state",
    "start",
    "guess",
    "outputs",
    "free",
    "ladder",
    "span",
    "integration",
    "impacts",
    "claims",
    "events",
    "figures",
    "source",
];

/// Reads a state file, or the start of a scene file, with its unknowns. `given`, as (name, value), replaces numbers
/// of the file: its own names, parameters, coordinates and speeds.
///
/// # Errors
/// Returns [`Diagnostics`] with every error of the file.
pub fn load_state_with_unknowns(
    source: &Source,
    model: &mut Model,
    given: &[(String, f64)],
) -> Result<StateWithUnknowns, Diagnostics> {
    bind_inputs(source, model)?;
    let (reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    let place = |name: &str| model.parameters.iter().position(|p| p.name == *name);
    let varied =
        given.iter().filter_map(|(name, x)| Some((VariedNumber::Parameter(place(name)?), Number::from_double(*x))));
    let varied: Vec<(VariedNumber, Number)> = varied.collect();
    let mut values = ValueReader { given: &varied, ..ValueReader::new(reader, model) };
    let mut asked = StateWithUnknowns::default();
    if let Some(impacts) = values.reader.get(table, "impacts") {
        let message = "motions near a contact cannot be studied: a contact acts on one side only";
        values.reader.error(
            impacts.span(),
            message,
            "leave the contacts out, and state each closed contact as a constraint of the model",
        );
    }
    values.state_file(table, given);
    let parameters = values.parameters(table).unwrap_or_default();
    let stated = values.stated_and_guessed_values(table, &parameters);
    let (outputs, are_stated) = values.outputs(table);
    let wide = |NamedNumber { name, symbol, value }| NamedNumber { name, symbol, value: Number::extended(&value) };
    asked.names = values.names.iter().cloned().map(wide).collect();
    values.reader.finish()?;
    for (at, StatedValue { number, formula, is_guess }) in stated.expect("reported if missing").into_iter().enumerate()
    {
        let name = state_names(model).nth(at).unwrap_or_default();
        let value = given.iter().find(|(given, _)| *given == name).map(|(_, value)| *value);
        asked.x.push(value.map_or(number.extended(), DoubleDouble::from));
        asked.formulas.push(formula);
        if is_guess && value.is_none() {
            asked.sought.push(at);
        }
    }
    asked.parameters = extended_values(&parameters);
    asked.rational = parameters.into_iter().map(|number| number.exact).collect();
    if are_stated {
        asked.outputs = outputs;
    }
    Ok(asked)
}

/// Names of the coordinates, followed by the names of the generalized speeds.
fn state_names(model: &Model) -> impl Iterator<Item = String> {
    model.coordinates.iter().map(|c| c.name.clone()).chain(model.speeds.iter().map(|s| s.name.clone()))
}

/// Value of a coordinate or speed in a state file, stated or guessed.
#[derive(Clone)]
struct StatedValue {
    /// Stated or guessed value, in SI units.
    number: Number,
    /// Term of the value, in parameters and in names that the file defines.
    formula: Expr,
    /// True if the value is a guess, so that the number is an unknown. False if the number is held.
    is_guess: bool,
}

impl<'a> ValueReader<'a, '_> {
    /// Reads the entries that every state file may have: the format version and the file's own names. Reports unknown
    /// keys.
    pub(in crate::scene) fn state_file(&mut self, table: &'a DeTable<'a>, given: &[(String, f64)]) {
        self.reader.schema(table);
        self.reader.report_unknown_keys(table, "a state file", &KEYS);
        self.read_own_names(table, given);
    }

    /// Reads `[names]`: numbers with names that the state file defines for its own formulas. Wrong names are
    /// reported.
    fn read_own_names(&mut self, table: &'a DeTable<'a>, given: &[(String, f64)]) {
        let Some(section) = self.section(table, "names") else { return };
        for (name, value) in self.reader.entries(section) {
            if let Some(wrong) = not_a_name(&name) {
                self.reader.errors.push(wrong);
                continue;
            }
            if self.is_of_model(&name.text) {
                let message = format!("`{}` is a name of the model", name.text);
                self.reader.error(
                    name.span,
                    message,
                    "choose another name, or state its value where the model's names are",
                );
                continue;
            }
            let Some(formula) = self.reader.formula(value, &format!("`{}`", name.text)) else { continue };
            let Some(number) = self.constant(&formula) else { continue };
            let value = given.iter().find(|(given, _)| *given == name.text);
            let number = value.map_or(number, |(_, value)| Number::from_double(*value));
            let symbol = self.model.arena.symbol(&name.text);
            self.names.push(NamedNumber { name: name.text, symbol, value: number });
        }
    }

    /// True if a name already has a meaning in formulas of this model's scenes.
    fn is_of_model(&self, name: &str) -> bool {
        let model = &self.model;
        let own = |known: &str| known == name;
        model.parameters.iter().any(|p| own(&p.name))
            || model.inputs.iter().any(|input| own(&input.name))
            || model.reactions.iter().any(|r| own(&r.name))
            || model.constraints.iter().any(|c| own(&c.fixes))
            || state_names(model).any(|known| own(&known))
            || ENERGIES.contains(&name)
            || [TIME, "pi", "deg"].contains(&name)
    }

    /// Reads all coordinates and speeds, from `[state]` or `[start]`, and from `[guess]`. `None` after
    /// an error is reported.
    fn stated_and_guessed_values(&mut self, table: &'a DeTable<'a>, parameters: &[Number]) -> Option<Vec<StatedValue>> {
        let names: Vec<String> = state_names(self.model).collect();
        let n = self.model.coordinates.len();
        let mut values: Vec<Option<StatedValue>> = vec![None; names.len()];
        let mut rates: Vec<Option<Number>> = vec![None; n];
        // Time as a coordinate gets the value 0, since a state with unknowns does not state it.
        if let Some(at) = self.model.time() {
            values[at] = Some(StatedValue { number: Number::from_double(0.0), formula: Expr::ZERO, is_guess: false });
        }
        let held = if table.contains_key("state") { "state" } else { "start" };
        for (key, is_guess) in [(held, false), ("guess", true)] {
            let Some(section) = self.section(table, key) else { continue };
            for (name, value) in self.reader.entries(section) {
                let rate = self.model.coordinates.iter().position(|c| format!("{}'", c.name) == name.text);
                if let Some(at) = rate.filter(|_| !is_guess) {
                    let formula = self.reader.formula(value, &format!("`{}`", name.text));
                    rates[at] = formula.and_then(|formula| self.number(&formula, parameters, "a rate"));
                    continue;
                }
                let Some(at) = self.place_of(&names, &name) else { continue };
                let Some(formula) = self.reader.formula(value, &format!("`{}`", name.text)) else { continue };
                let Some(number) = self.number(&formula, parameters, "a value of a state") else { continue };
                if values[at].is_some() {
                    let message = format!("`{}` is stated and guessed", name.text);
                    self.reader.error(
                        name.span,
                        message,
                        "leave it out of [guess] to hold it, or out of the other to seek it",
                    );
                    continue;
                }
                let formula = self.expression(&formula)?;
                values[at] = Some(StatedValue { number, formula, is_guess });
            }
        }
        let rated = rates.iter().position(Option::is_some);
        if let (Some(rate), Some(speed)) = (rated, values[n..].iter().position(Option::is_some)) {
            let message = format!(
                "speeds and time derivatives are mixed: `{}` and `{}'`",
                self.model.speeds[speed].name, self.model.coordinates[rate].name
            );
            self.reader.errors.push(Diagnostic::of_file(message, "state every speed, or every q'"));
        }
        self.speeds_of(&rates, parameters, &mut values);
        let missing: Vec<&str> =
            names.iter().zip(&values).filter(|(_, value)| value.is_none()).map(|(name, _)| name.as_str()).collect();
        if !missing.is_empty() && self.reader.errors.is_empty() {
            let message = format!("no value is given to {}", missing.join(", "));
            let help = "add held values to [state], and guesses of sought values to [guess]";
            self.reader.errors.push(Diagnostic::of_file(message, help));
        }
        values.into_iter().collect()
    }

    /// Computes the speeds of a state that states the rates of all coordinates. Sets the speeds in `values`.
    fn speeds_of(&mut self, rates: &[Option<Number>], parameters: &[Number], values: &mut [Option<StatedValue>]) {
        let (places, speeds) = values.split_at_mut(rates.len());
        let rates: Option<Vec<f64>> = rates.iter().map(|rate| rate.as_ref().map(|rate| rate.double)).collect();
        let q: Option<Vec<f64>> = places.iter().map(|value| value.as_ref().map(|q| q.number.double)).collect();
        let (Some(rates), Some(q)) = (rates, q) else { return };
        for (speed, u) in speeds.iter_mut().zip(self.speeds_of_state(&double_values(parameters), &q, &rates)) {
            if speed.is_none() {
                let term = Rational::from_f64_exact(u).map(|u| self.model.arena.number(u));
                *speed = term.map(|formula| StatedValue { number: Number::from_double(u), formula, is_guess: false });
            }
        }
    }

    /// Index of the coordinate or speed `name` in `names`. `None` after reporting any other name. `None` without a
    /// report for a variable that a constraint determines.
    fn place_of(&mut self, names: &[String], name: &Located) -> Option<usize> {
        if let Some(at) = names.iter().position(|known| *known == name.text && *known != TIME) {
            return Some(at);
        }
        // A variable that a constraint determines follows from the coordinates.
        if self.model.constraints.iter().any(|c| c.fixes == name.text) {
            return None;
        }
        let (message, help) = self.model.unknown_state_name(&name.text, names.iter().map(String::as_str));
        self.reader.error(name.span.clone(), message, help);
        None
    }
}
