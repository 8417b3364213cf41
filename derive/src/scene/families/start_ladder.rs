//! Ladder of a scene: several start values of a single coordinate or speed. It shows the value at which runs fail.

use crate::diagnostic::nearest_name_advice;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::Number;
use crate::scene::starts::start::{ExactStart, InitialMotion};
use toml::de::{DeTable, DeValue};
use tripos_traits::DoubleDouble;

/// Ladder of a scene: several start values of a single coordinate or generalized speed, with a run for each.
#[derive(Clone, Debug, PartialEq)]
pub struct Ladder {
    /// Name of the coordinate or speed that varies.
    pub name: String,
    /// Index of the varied number in the list of all coordinates, then all speeds.
    pub at: usize,
    /// Start values in SI units, to 32 digits, one for each run.
    pub values: Vec<DoubleDouble>,
}

impl<'a> ValueReader<'a, '_> {
    /// Reads `[ladder]` of a scene: a single coordinate or speed with a list of values. `None` if the section is
    /// absent, or after an error is reported.
    pub fn ladder(&mut self, table: &'a DeTable<'a>, p: &[Number], start: &ExactStart) -> Option<Ladder> {
        const HOW: &str = "write one coordinate or speed with its values, as u2 = [1.6, 0.8]";
        let section = self.section(table, "ladder")?;
        let place = self.reader.get(table, "ladder").map_or(0..0, toml::Spanned::span);
        let entries = self.reader.entries(section);
        let [(name, value)] = entries.as_slice() else {
            let message = format!("`ladder` varies {} numbers, not one", entries.len());
            self.reader.error(place, message, HOW);
            return None;
        };
        let coordinates = self.model.coordinates.iter().map(|c| c.name.clone());
        let speeds = self.model.speeds.iter().map(|s| s.name.clone());
        let stated = if matches!(start.motion, InitialMotion::Speeds(_)) { speeds.collect() } else { Vec::new() };
        let names: Vec<String> = coordinates.chain(stated).collect();
        let Some(at) = names.iter().position(|known| *known == name.text) else {
            let help = nearest_name_advice(&name.text, names.iter().map(String::as_str));
            self.reader.error(name.span.clone(), format!("the start states no `{}`", name.text), help);
            return None;
        };
        if at < self.model.coordinates.len() && !self.model.loops.is_empty() {
            let message = format!("a ladder of `{}` would open the loops of the model", name.text);
            self.reader.error(name.span.clone(), message, "vary a speed, or sweep over the coordinate");
            return None;
        }
        let DeValue::Array(array) = value.get_ref() else {
            self.reader.error(value.span(), "the values of a ladder must be a list", HOW);
            return None;
        };
        let mut values = Vec::new();
        for value in array {
            let formula = self.reader.formula(value, "a value of the ladder")?;
            values.push(self.number(&formula, p, "a value of the ladder")?.extended());
        }
        if values.is_empty() {
            self.reader.error(value.span(), "the ladder has no values", HOW);
            return None;
        }
        Some(Ladder { name: name.text.clone(), at, values })
    }
}
