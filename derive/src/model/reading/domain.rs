//! Domain in which a model holds, as the section `[domain]` of a model file states it.

use super::declared_names::{ANYTHING, NameKind};
use super::loading::Loading;
use crate::model::DomainCondition;
use crate::model::reactions::interactions::NamedReaction;
use crate::plain_text::one_line;
use toml::de::DeTable;

impl<'a> Loading<'a> {
    /// Reads the section `[domain]` of a model file: named strict inequalities. Errors are recorded in the reader.
    pub fn domain(&mut self, table: &'a DeTable<'a>) -> Vec<DomainCondition> {
        let mut domain = Vec::new();
        for (name, value) in self.section(table, "domain", &[]) {
            self.names.declare(&mut self.reader, &name, NameKind::Condition, None);
            let Some(text) = self.reader.string(value, "a condition") else { continue };
            let help = "write a strict inequality, such as \"abs(q2) < pi/2\" or \"N > 0\"";
            let Some((left, (sign, right))) = self.split_relation(&text, &["<", ">"], help) else { continue };
            let what = "a condition of the domain";
            let left = self.formula(&left, ANYTHING, what);
            let right = self.formula(&right, ANYTHING, what);
            let (Some(left), Some(right)) = (left, right) else { continue };
            let asked = self.names.reactions.iter().map(NamedReaction::symbol);
            self.units.extend(asked);
            if !self.have_same_unit(left, right, &text.span) {
                continue;
            }
            let positive = if sign == "<" { self.arena.sub(right, left) } else { self.arena.sub(left, right) };
            if let Some(value) = self.arena.as_number(positive) {
                let always = if value.is_negative() || value.is_zero() { "never" } else { "always" };
                let message = format!("the condition `{}` is {always} fulfilled", name.text);
                self.reader.error(text.span, message, "state where the model holds, or remove the condition");
                continue;
            }
            domain.push(DomainCondition { name: name.text, text: one_line(&text.text), positive });
        }
        domain
    }
}
