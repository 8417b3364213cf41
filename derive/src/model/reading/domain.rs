//! Domain in which a model holds, as the section `[domain]` of a model file states it.

use super::names::{ANYTHING, Kind};
use super::reader::Loading;
use crate::model::Condition;
use crate::model::reactions::interactions::AskedReaction;
use crate::plain::one_line;
use toml::de::DeTable;

impl<'a> Loading<'a> {
    /// Reads the section `[domain]` of a model file: strict inequalities by name. Errors are recorded in the reader.
    pub fn domain(&mut self, table: &'a DeTable<'a>) -> Vec<Condition> {
        let mut domain = Vec::new();
        for (name, value) in self.section(table, "domain", &[]) {
            self.names.declare(&mut self.reader, &name, Kind::Condition, None);
            let Some(text) = self.reader.string(value, "a condition") else { continue };
            let help = "write a strict inequality, such as \"abs(q2) < pi/2\" or \"N > 0\"";
            let Some((left, (sign, right))) = self.split(&text, &["<", ">"], help) else { continue };
            let what = "a condition of the domain";
            let left = self.formula(&left, ANYTHING, what);
            let right = self.formula(&right, ANYTHING, what);
            let (Some(left), Some(right)) = (left, right) else { continue };
            let asked = self.names.reactions.iter().map(AskedReaction::symbol);
            self.units.extend(asked);
            if !self.comparable(left, right, &text.span) {
                continue;
            }
            let positive = if sign == "<" { self.arena.sub(right, left) } else { self.arena.sub(left, right) };
            if let Some(value) = self.arena.as_number(positive) {
                let always = if value.is_negative() || value.is_zero() { "never" } else { "always" };
                let message = format!("the condition `{}` is {always} fulfilled", name.text);
                self.reader.error(text.span, message, "state where the model holds, or remove the condition");
                continue;
            }
            domain.push(Condition { name: name.text, text: one_line(&text.text), positive });
        }
        domain
    }
}
