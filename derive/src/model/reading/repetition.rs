//! Repetition: an entry whose key contains a range is read once for each number of the range.
//!
//! ```toml
//! [counts]
//! n = 10
//!
//! [joints."pin{i in 2..n}"]
//! body = "rod{i}"
//! to = "rod{i-1}"
//! ```
//!
//! Repetition is expanded before anything else is read. The expanded tables contain no ranges.

use crate::algebra::text::parse::parse;
use crate::algebra::{Arena, Rational};
use crate::diagnostic::shortened_for_message;
use crate::toml_reader::TomlReader;
use std::borrow::Cow;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Largest number of entries into which the ranges of one model file may be expanded.
const MAX_REPEATED: usize = 20_000;

/// Keys whose texts are prose, in which braces need not be ranges.
const PROSE: [&str; 3] = ["name", "source", "about"];

/// Whole numbers by name. A later entry hides an earlier entry of the same name.
type Numbers = Vec<(String, i64)>;

/// Copy of a model file's table with every repetition expanded; `None` if the file repeats nothing. Errors are
/// recorded in the reader.
pub fn expand_repetition<'a>(reader: &mut TomlReader<'_>, table: &DeTable<'a>) -> Option<DeTable<'a>> {
    if !table.contains_key("counts") && !has_repetition(table) {
        return None;
    }
    let mut repeating = RepetitionExpander { reader, arena: Arena::new(), entries: 0 };
    let mut counts = Numbers::new();
    if let Some(stated) = table.get("counts") {
        repeating.counts(stated, &mut counts);
    }
    let mut whole = DeTable::new();
    for (key, value) in table {
        if key.get_ref() != "counts" {
            let value = repeating.expand_value(value, &counts, RepeatedText::of(key.get_ref()));
            whole.insert(key.clone(), value);
        }
    }
    Some(whole)
}

/// True if any key of the table, at any depth, contains an opening brace.
fn has_repetition(table: &DeTable<'_>) -> bool {
    table
        .iter()
        .any(|(key, value)| key.get_ref().contains('{') || value.get_ref().as_table().is_some_and(has_repetition))
}

/// State of the expansion of repeated entries.
struct RepetitionExpander<'r, 'a> {
    /// Reader of the file, which collects the errors.
    reader: &'r mut TomlReader<'a>,
    /// Arena for the formulas of indices.
    arena: Arena,
    /// Number of entries expanded so far.
    entries: usize,
}

/// Kind of the texts under a key: formulas and names, or prose.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RepeatedText {
    /// Formulas and names, in which all braces are replaced.
    Formula,
    /// Prose, in which braces without a number stay.
    Prose,
}

impl RepeatedText {
    /// Kind of the texts under the given key.
    fn of(key: &str) -> Self {
        if PROSE.contains(&key) { Self::Prose } else { Self::Formula }
    }
}

impl RepetitionExpander<'_, '_> {
    /// Reads the section `[counts]`, whole numbers by name, into `counts`. Wrong values are reported.
    fn counts(&mut self, stated: &Spanned<DeValue<'_>>, counts: &mut Numbers) {
        let DeValue::Table(table) = stated.get_ref() else {
            return self.reader.error(stated.span(), "`counts` must be a table", "write it as [counts], with n = 10");
        };
        for (name, value) in table {
            let number = match value.get_ref() {
                DeValue::Integer(n) if n.radix() == 10 => n.as_str().replace('_', "").parse::<i64>().ok(),
                _ => None,
            };
            match number.filter(|n| n.abs() <= 1_000_000) {
                Some(number) => counts.push((name.get_ref().to_string(), number)),
                None => {
                    let message = format!(
                        "the count `{}` is not a whole number up to 1000000",
                        shortened_for_message(name.get_ref())
                    );
                    self.reader.error(value.span(), message, "write n = 10");
                }
            }
        }
    }

    /// Copy of a value in which numbers replace the formulas in braces. In prose, braces whose content is no whole
    /// number stay.
    fn expand_value<'a>(
        &mut self,
        value: &Spanned<DeValue<'a>>,
        numbers: &Numbers,
        kind: RepeatedText,
    ) -> Spanned<DeValue<'a>> {
        let span = value.span();
        let new = match value.get_ref() {
            DeValue::String(text) if text.contains('{') && kind == RepeatedText::Formula => {
                DeValue::String(Cow::Owned(self.expand_text(text, numbers, &span)))
            }
            DeValue::String(text) if text.contains('{') => {
                DeValue::String(Cow::Owned(self.expand_prose(text, numbers)))
            }
            DeValue::Array(list) => {
                let mut array = toml::de::DeArray::new();
                for item in list {
                    array.push(self.expand_value(item, numbers, kind));
                }
                DeValue::Array(array)
            }
            DeValue::Table(table) => DeValue::Table(self.expand_table(table, numbers)),
            other => other.clone(),
        };
        Spanned::new(span, new)
    }

    /// Copy of a table in which repeated entries are expanded, and numbers replace the formulas in braces.
    fn expand_table<'a>(&mut self, table: &DeTable<'a>, numbers: &Numbers) -> DeTable<'a> {
        let mut result = DeTable::new();
        for (key, value) in table {
            if !key.get_ref().contains('{') {
                result.insert(key.clone(), self.expand_value(value, numbers, RepeatedText::of(key.get_ref())));
                continue;
            }
            let span = key.span();
            for (name, numbers) in self.expand_key(key.get_ref(), numbers, &span) {
                self.entries += 1;
                if self.entries == MAX_REPEATED + 1 {
                    let message = format!("more than {MAX_REPEATED} entries are repeated");
                    self.reader.error(span.clone(), message, "state a smaller mechanism");
                }
                if self.entries > MAX_REPEATED {
                    return result;
                }
                let value = self.expand_value(value, &numbers, RepeatedText::Formula);
                if result.insert(Spanned::new(span.clone(), Cow::Owned(name.clone())), value).is_some() {
                    let message = format!("`{}` is stated twice by repeated entries", shortened_for_message(&name));
                    self.reader.error(span.clone(), message, "name the index of the range in the key");
                }
            }
        }
        result
    }

    /// Expands a key with ranges into names. Each name comes with the numbers, to which the values of its indices are
    /// added. Empty after an error is reported.
    fn expand_key(&mut self, key: &str, numbers: &Numbers, span: &Range<usize>) -> Vec<(String, Numbers)> {
        let mut open = vec![(String::new(), numbers.clone())];
        let mut rest = key;
        while let Some((before, after)) = rest.split_once('{') {
            let Some((inside, after)) = after.split_once('}') else {
                self.reader.error(span.clone(), "this `{` is never closed", "write a range as {i in 1..4}");
                return Vec::new();
            };
            let mut next = Vec::new();
            for (text, numbers) in open {
                let text = text + before;
                let Some((index, from, to)) = range(inside) else {
                    match self.number(inside, &numbers, span) {
                        Some(number) => next.push((format!("{text}{number}"), numbers)),
                        None => return Vec::new(),
                    }
                    continue;
                };
                let is_name =
                    index.starts_with(|c: char| c.is_ascii_alphabetic()) && index.chars().all(char::is_alphanumeric);
                if !is_name || numbers.iter().any(|(name, _)| name == index) {
                    let message = format!("`{}` cannot be the index of a range", shortened_for_message(index));
                    self.reader.error(span.clone(), message, "choose another name for it, such as i");
                    return Vec::new();
                }
                let (Some(from), Some(to)) = (self.number(from, &numbers, span), self.number(to, &numbers, span))
                else {
                    return Vec::new();
                };
                if to.saturating_sub(from) >= i64::try_from(MAX_REPEATED).unwrap_or(i64::MAX) {
                    let message = format!("the range {from}..{to} has more than {MAX_REPEATED} numbers");
                    self.reader.error(span.clone(), message, "state a smaller mechanism");
                    return Vec::new();
                }
                for n in from..=to {
                    let mut numbers = numbers.clone();
                    numbers.push((index.to_owned(), n));
                    next.push((format!("{text}{n}"), numbers));
                }
            }
            (open, rest) = (next, after);
        }
        open.into_iter().map(|(text, numbers)| (text + rest, numbers)).collect()
    }

    /// Replaces the formulas in braces in a text by numbers. Reports formulas that give no whole
    /// number.
    fn expand_text(&mut self, text: &str, numbers: &Numbers, span: &Range<usize>) -> String {
        let mut result = String::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            result += before;
            let Some((inside, after)) = after.split_once('}') else {
                self.reader.error(span.clone(), "this `{` is never closed", "write an index as {i} or {i-1}");
                return result;
            };
            match self.number(inside, numbers, span) {
                Some(number) => result += &number.to_string(),
                None => return result,
            }
            rest = after;
        }
        result + rest
    }

    /// Replaces the formulas in braces in prose by numbers. Braces without a whole number stay
    /// unchanged.
    fn expand_prose(&mut self, text: &str, numbers: &Numbers) -> String {
        let mut result = String::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            result += before;
            let known = after
                .split_once('}')
                .and_then(|(inside, after)| Some((self.index_value(inside, numbers).ok()?, after)));
            match known {
                Some((number, after)) => {
                    result += &number.to_string();
                    rest = after;
                }
                None => {
                    result.push('{');
                    rest = after;
                }
            }
        }
        result + rest
    }

    /// Whole number that a formula of counts and indices gives. `None` after reporting a formula whose value is not
    /// whole.
    fn number(&mut self, formula: &str, numbers: &Numbers, span: &Range<usize>) -> Option<i64> {
        match self.index_value(formula, numbers) {
            Ok(number) => Some(number),
            Err(message) => {
                let help = "write an index as {i} or {i-1}, a range as {i in 1..4}; counts stand under [counts]";
                self.reader.error(span.clone(), format!("`{{{}}}`: {message}", shortened_for_message(formula)), help);
                None
            }
        }
    }

    /// Whole number that a formula of counts and indices gives. Returns a message if its value is not whole.
    fn index_value(&mut self, formula: &str, numbers: &Numbers) -> Result<i64, String> {
        let value = parse(&mut self.arena, formula, &mut |arena, name| {
            let known = numbers.iter().rev().find(|(known, _)| known == name);
            let known = known.map(|(_, number)| arena.number(Rational::integer(*number)));
            known.ok_or_else(|| (format!("`{}` is no index and no count", shortened_for_message(name)), None))
        });
        let value = value.map_err(|error| error.message)?;
        let whole = self.arena.as_number(value).filter(|n| n.is_integer()).and_then(Rational::to_i64);
        whole.ok_or_else(|| "this is not a whole number".to_owned())
    }
}

/// Splits a range such as `i in 1..n` into (index, first number, last number), here `i`, `1` and `n`. `None` if the
/// text is no range.
fn range(inside: &str) -> Option<(&str, &str, &str)> {
    let (index, ends) = inside.split_once(" in ")?;
    let (from, to) = ends.split_once("..")?;
    Some((index.trim(), from, to))
}
