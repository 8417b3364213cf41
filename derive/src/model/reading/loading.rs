//! Reader of one model file: its state, and functions that read entries of any section.

use super::declared_names::NameKind;
use super::declared_names::{AllowedQuantities, Names};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::shortened_for_message;
use crate::model::Parameter;
use crate::model::input::InputBinding;
use crate::model::units::{StatedUnit, Unit, bare_number_advice, unit_of};
use crate::toml_reader::{Entry, Located, TomlReader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Largest number of entries in one section of a model file.
const MAX_ENTRIES: usize = 5000;

/// State of reading one model file: the TOML reader, the arena, names and units.
pub struct Loading<'a> {
    /// TOML reader, which collects the errors.
    pub reader: TomlReader<'a>,
    /// Arena of the model's terms.
    pub arena: Arena,
    /// Names declared so far.
    pub names: Names,
    /// Unit of each symbol. A symbol whose declaration is wrong has no unit.
    pub units: FxHashMap<Expr, Unit>,
    /// Formulas that a scene gives to inputs of the model.
    pub bindings: Vec<InputBinding>,
    /// Names of inputs to whose formula a parameter with the input's name is added.
    pub varied: Vec<String>,
    /// Numbers with units in formulas, as (byte range, symbol of the parameter that stands for the
    /// number).
    pub literals: Vec<(Range<usize>, Expr)>,
    /// Parameters that stand for numbers with units in formulas.
    pub stated_numbers: Vec<Parameter>,
}

impl<'a> Loading<'a> {
    /// Prose under an optional key, on one line. `None` if the key is absent, or after an error is reported.
    pub fn text(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<String> {
        self.reader.prose(table, key)
    }

    /// Named entries of a section, in the order of the file; empty if the section is absent. If the
    /// section cannot be read, later references to names of `kinds` are not reported.
    pub fn section(&mut self, table: &'a DeTable<'a>, key: &str, kinds: &[NameKind]) -> Vec<Entry<'a>> {
        let Some(value) = self.reader.get(table, key) else { return Vec::new() };
        let Some(section) = self.reader.table(value, &format!("`{key}`"), &format!("[{key}]")) else {
            self.names.mark_unread_kinds(kinds);
            return Vec::new();
        };
        let mut entries = self.reader.entries(section);
        if entries.len() > MAX_ENTRIES {
            let message = format!("`{key}` has {} entries: more than {MAX_ENTRIES}", entries.len());
            self.reader.error(entries[MAX_ENTRIES].0.span.clone(), message, "state a smaller mechanism");
            self.names.mark_unread_kinds(kinds);
            entries.truncate(MAX_ENTRIES);
        }
        entries
    }

    /// Declares a named entry and opens its table. Returns the table, and the entry's name for error messages. `None`
    /// after an error is reported.
    pub fn entry(
        &mut self,
        name: &Located,
        value: &'a Spanned<DeValue<'a>>,
        kind: NameKind,
        symbol: Option<Expr>,
        example: &str,
    ) -> Option<(&'a DeTable<'a>, String)> {
        let what = format!("{} `{}`", kind.noun(), shortened_for_message(&name.text));
        self.names.declare(&mut self.reader, name, kind, symbol);
        let Some(entry) = self.reader.table(value, &what, example) else {
            self.names.mark_wrong_name(&name.text);
            return None;
        };
        self.about(entry);
        Some((entry, what))
    }

    /// Reads the unit under the required key `unit` of an entry. `None` after an error is reported.
    pub fn read_unit_key(&mut self, table: &'a DeTable<'a>, owner: &Located) -> Option<Unit> {
        let value =
            self.reader.required(table, "unit", &format!("`{}`", shortened_for_message(&owner.text)), &owner.span)?;
        let text = self.reader.string(value, "`unit`")?;
        match Unit::parse(&text.text) {
            Ok(unit) => Some(unit),
            Err(message) => {
                self.reader.error(text.span, message, Unit::help(&text.text));
                None
            }
        }
    }

    /// Reads the description under the optional key `about` of an entry; empty if it is absent.
    pub fn about(&mut self, table: &'a DeTable<'a>) -> String {
        self.text(table, "about").unwrap_or_default()
    }

    /// True if both sides of a relation have the same unit, or if a unit is indefinite. Otherwise reports an error.
    pub fn have_same_unit(&mut self, left: Expr, right: Expr, span: &Range<usize>) -> bool {
        let before = self.reader.errors.len();
        if let (Some(a), Some(b)) = (self.unit_of(left, span), self.unit_of(right, span))
            && a != b
        {
            let message = format!("the left side is in {}, the right side in {}", a.unit_words(), b.unit_words());
            self.reader.error(span.clone(), message, "check the units of the parameters and coordinates");
        }
        self.reader.errors.len() == before
    }

    /// Splits a relation, such as an equation, at its only sign into (left side, (sign, right side)). `None` after
    /// reporting no sign, several signs, or a sign that is not allowed.
    pub fn split_relation<'s>(
        &mut self,
        text: &Located,
        signs: &[&'s str],
        help: &str,
    ) -> Option<(Located, (&'s str, Located))> {
        let found: Vec<(usize, &'s str)> =
            signs.iter().flat_map(|sign| text.text.match_indices(sign).map(|(at, _)| (at, *sign))).collect();
        let weak = found.iter().map(|(at, _)| *at).find(|at| signs.len() > 1 && text.text[at + 1..].starts_with('='));
        if let Some(at) = weak {
            let sign = &text.text[at..at + 2];
            self.reader.error(text.part(at..at + 2), format!("`{sign}` is not a strict inequality"), help);
            return None;
        }
        let [(at, sign)] = found.as_slice() else {
            let expected = signs.join("` or `");
            self.reader.error(text.span.clone(), format!("expected exactly one `{expected}` here"), help);
            return None;
        };
        Some((text.trimmed(0..*at), (*sign, text.trimmed(at + 1..text.text.len()))))
    }

    /// Unit of a term. `None` if it is indefinite, or after reporting a sum of terms with different units.
    pub fn unit_of(&mut self, e: Expr, span: &Range<usize>) -> Option<Unit> {
        match unit_of(&self.arena, e, &self.units) {
            Ok(unit) => unit,
            Err((message, help)) => {
                self.reader.error(span.clone(), message, help);
                None
            }
        }
    }

    /// Reads a formula, or a number with a unit, as a term that must have the unit `unit`. A wrong unit
    /// is reported. `None` if nothing could be read.
    pub fn quantity(&mut self, formula: &Located, allowed: AllowedQuantities, unit: &Unit, what: &str) -> Option<Expr> {
        if let Some(stated) = StatedUnit::of(&formula.text).filter(|stated| stated.unit != *unit) {
            let (needed, found) = (unit.unit_words(), stated.unit.unit_words());
            let message =
                format!("{what} must be in {needed}, but `{}` is in {found}", shortened_for_message(&formula.text));
            let help =
                if unit.is_plain() { "state it in rad or deg".to_owned() } else { format!("state it in {needed}") };
            self.reader.error(formula.span.clone(), message, help);
            return None;
        }
        let e = self.formula(formula, allowed, what)?;
        self.record_units_of_velocities();
        if let Some(found) = self.unit_of(e, &formula.span)
            && found != *unit
        {
            let (needed, found) = (unit.unit_words(), found.unit_words());
            let message =
                format!("{what} must be in {needed}, but `{}` is in {found}", shortened_for_message(&formula.text));
            let help = if self.arena.reachable(&[e]).iter().any(|part| self.arena.symbol_name(*part).is_some()) {
                "check the units of the parameters and coordinates".to_owned()
            } else {
                bare_number_advice(&needed)
            };
            self.reader.error(formula.span.clone(), message, help);
        }
        Some(e)
    }

    /// Records the units of the velocities that have occurred in formulas so far.
    pub fn record_units_of_velocities(&mut self) {
        let stated = self.names.velocities.iter().chain(self.names.undeclared_velocities());
        self.units.extend(stated.map(|velocity| (velocity.symbol, velocity.unit())));
    }
}
