//! Outputs of a scene, and error messages for quantities that rigid-body equations do not contain.

use crate::diagnostic::{Diagnostics, Source, nearest_name_advice};
use crate::model::Model;
use crate::plain_text::one_line;
use crate::scene::SceneOutput;
use crate::scene::numbers::number_reader::ValueReader;
use crate::toml_reader::{Located, TomlReader};
use toml::de::{DeTable, DeValue};

/// Names of energies in outputs. A quantity of the model with one of these names takes precedence.
pub const ENERGIES: [&str; 3] = ["kinetic_energy", "potential_energy", "total_energy"];

/// Words for quantities that rigid-body equations do not contain. Each list of words comes with the message for a
/// user who states one of them as an output.
const QUANTITIES_WITHOUT_EQUATION: [(&[&str], &str); 4] = [
    (
        &["impact", "bounce", "rebound", "collision", "restitution"],
        "an impact cannot be an output: state the contact under [impacts], and the run lists all impacts with impulses and losses",
    ),
    (
        &["lift_off", "liftoff", "flight", "contact_loss", "loss_of_contact", "separation"],
        "what follows a loss of contact is not in equations with a constraint that keeps it. Show the reaction, and let the run end where it is zero; \
         or leave the constraint out of the model, and state the contact under [impacts]",
    ),
    (
        &["slip", "stick", "friction", "rolling"],
        "a change between sticking and slipping is not in the equations: they hold for one kind of contact. Model the friction as an \
         applied force",
    ),
    (
        &["deformation", "stress", "strain", "heat", "sound"],
        "bodies are rigid in the equations: nothing in them deforms, warms or sounds",
    ),
];

impl<'a> ValueReader<'a, '_> {
    /// Reads `outputs = ["q2", "u1"]` of a scene file. An entry is a name, a formula, or a table such as `{ name =
    /// "lean", value = "q2" }`. If the key is absent, every coordinate and speed is an output. The second result is
    /// true if the scene file states outputs.
    pub fn outputs(&mut self, table: &'a DeTable<'a>) -> (Vec<SceneOutput>, bool) {
        let Some(value) = self.reader.get(table, "outputs") else { return (default_outputs(self.model), false) };
        let DeValue::Array(array) = value.get_ref() else {
            let help = "write outputs = [\"q2\", \"u1\"], or a formula in quotes";
            self.reader.error(value.span(), "`outputs` must be a list", help);
            return (Vec::new(), true);
        };
        if array.is_empty() {
            let help = "name what the scene shall show, or leave `outputs` out to see every coordinate and speed";
            self.reader.error(value.span(), "`outputs` is empty", help);
        }
        let mut list: Vec<SceneOutput> = Vec::new();
        for entry in array {
            let (name, formula) = match entry.get_ref() {
                DeValue::Table(_) => {
                    let how = "{ name = \"lean\", value = \"q2\" }";
                    let Some(table) = self.reader.table(entry, "an output", how) else { continue };
                    self.reader.report_unknown_keys(table, "an output", &["name", "value"]);
                    let name = self.reader.required(table, "name", "an output", &entry.span());
                    let name = name.and_then(|v| self.reader.name(v, "an output's name"));
                    let value = self.reader.required(table, "value", "an output", &entry.span());
                    let value = value.and_then(|v| self.reader.formula(v, "an output"));
                    let (Some(name), Some(value)) = (name, value) else { continue };
                    (name, value)
                }
                _ => {
                    let Some(formula) = self.reader.formula(entry, "an output") else { continue };
                    (formula.clone(), formula)
                }
            };
            let name = Located { text: one_line(&name.text), ..name };
            if name.text.is_empty() || name.text == "t" {
                let message = format!("an output cannot be called `{}`", name.text);
                self.reader.error(name.span, message, "give it a name of its own; `t` is the time");
                continue;
            }
            // A name of the model must not denote another formula.
            let is_taken = self.model.arena.find_symbol(&name.text).is_some() || ENERGIES.contains(&name.text.as_str());
            if is_taken && name.text != formula.text.trim() {
                let message = format!("an output cannot be called `{}`: the model uses this name", name.text);
                self.reader.error(name.span, message, "choose a name that the model does not use");
                continue;
            }
            if list.iter().any(|o| o.name == name.text) {
                let message = format!("the output `{}` is listed twice", name.text);
                self.reader.error(name.span, message, "leave one of them out");
                continue;
            }
            if let Some(value) = self.output_formula(&formula) {
                list.push(SceneOutput { name: name.text, value });
            }
        }
        (list, true)
    }

    /// Reads the formula of an output as a term. `None` after an error is reported, also for a quantity that the
    /// equations do not contain.
    fn output_formula(&mut self, formula: &Located) -> Option<crate::algebra::Expr> {
        let word = formula.text.trim().to_lowercase().replace([' ', '-'], "_");
        let known = self.model.arena.find_symbol(formula.text.trim()).is_some();
        if let (false, Some((_, why))) =
            (known, QUANTITIES_WITHOUT_EQUATION.iter().find(|(words, _)| words.contains(&word.as_str())))
        {
            self.reader.error(formula.span.clone(), format!("no output `{}` can be had", formula.text), *why);
            return None;
        }
        self.value_formula_with(formula, &ENERGIES)
    }

    /// Reads `free = ["M"]`: indices of the parameters that stay symbols in the scene's reduced
    /// equations. Unknown names are reported.
    pub fn free_parameters(&mut self, table: &'a DeTable<'a>) -> Vec<usize> {
        let Some(value) = self.reader.get(table, "free") else { return Vec::new() };
        let DeValue::Array(array) = value.get_ref() else {
            self.reader.error(value.span(), "`free` must be a list of parameters", "write free = [\"M\"]");
            return Vec::new();
        };
        let mut list = Vec::new();
        for entry in array {
            let Some(name) = self.reader.string(entry, "a parameter's name") else { continue };
            match self.model.parameters.iter().position(|p| p.name == name.text) {
                Some(at) if !list.contains(&at) => list.push(at),
                Some(_) => {}
                None => {
                    let help = nearest_name_advice(&name.text, self.model.parameters.iter().map(|p| p.name.as_str()));
                    self.reader.error(name.span, format!("the model has no parameter `{}`", name.text), help);
                }
            }
        }
        list
    }
}

/// Reads an output from a text outside a file, such as the command line. The syntax is that of a scene's outputs.
///
/// # Errors
/// Returns [`Diagnostics`] if the text is no formula in names of the model.
pub fn load_output(text: &str, model: &mut Model) -> Result<SceneOutput, Diagnostics> {
    let source = Source::from_text("--output", text);
    let mut values = ValueReader::new(TomlReader::new(&source), model);
    let formula = Located { text: source.text.clone(), span: 0..source.text.len(), exact: true };
    let value = values.output_formula(&formula);
    values.reader.finish()?;
    Ok(SceneOutput { name: text.trim().to_owned(), value: value.expect("reported if missing") })
}

/// Default outputs of a scene: every coordinate, then every generalized speed.
#[must_use]
pub fn default_outputs(model: &Model) -> Vec<SceneOutput> {
    let coordinates = model.coordinates.iter().map(|c| SceneOutput { name: c.name.clone(), value: c.symbol });
    coordinates.chain(model.speeds.iter().map(|s| SceneOutput { name: s.name.clone(), value: s.symbol })).collect()
}
