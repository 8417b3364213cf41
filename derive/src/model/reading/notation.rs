//! Notation of a model file: the symbols by which documents show the model's names.

use super::declared_names::NameKind;
use super::loading::Loading;
use crate::algebra::text::print::name_parts;
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::model::Model;
use crate::toml_reader::Located;
use toml::de::DeTable;

/// Kinds of names for which a model file may state symbols.
const SHOWN: [NameKind; 8] = [
    NameKind::Parameter,
    NameKind::Coordinate,
    NameKind::Speed,
    NameKind::Input,
    NameKind::Reaction,
    NameKind::Frame,
    NameKind::Point,
    NameKind::Body,
];

/// Kinds of names that have no time derivative, so that their symbols get no dots.
const PLACES: [NameKind; 3] = [NameKind::Frame, NameKind::Point, NameKind::Body];

/// Letters that documents use for energies. No other quantity may have them as its symbol.
const ENERGIES: [&str; 2] = ["T", "V"];
/// Letters that documents use, with a number, for entries of equations, such as `M11` and `f1`.
const NUMBERED: [&str; 5] = ["M", "f", "F", "Q", "C"];

/// Largest number of dots that a document puts over a symbol, for time derivatives.
const MOST_DOTS: usize = 2;

impl<'a> Loading<'a> {
    /// Reads the section `[notation]` of a model file: the symbol by which documents show each listed
    /// name. Reports a symbol that two names would share, except a generalized speed and the
    /// coordinate's rate that it equals.
    pub fn notation(&mut self, table: &'a DeTable<'a>, model: &mut Model) {
        let mut list: Vec<(String, Located)> = Vec::new();
        for (name, value) in self.section(table, "notation", &[]) {
            let Some(symbol) =
                self.reader.string(value, &format!("the symbol of `{}`", shortened_for_message(&name.text)))
            else {
                continue;
            };
            let kind = self.names.kind(&name.text).filter(|kind| SHOWN.contains(kind));
            let is_place = kind.is_some_and(|kind| PLACES.contains(&kind));
            if kind.is_none() {
                let help = nearest_name_advice(&name.text, self.names.names_of_kind(&SHOWN));
                self.reader.error(
                    name.span,
                    format!("no symbol is named `{}`", shortened_for_message(&name.text)),
                    help,
                );
            } else if is_symbol(&symbol.text) && !(is_place && symbol.text.ends_with('\'')) {
                list.push((name.text, symbol));
            } else {
                let help = "write a letter or the name of a Greek letter, `_` with a subscript, and `'` for each dot, as in \"omega_1\" or \"psi'\"";
                self.reader.error(
                    symbol.span.clone(),
                    format!("`{}` is no symbol", shortened_for_message(&symbol.text)),
                    help,
                );
            }
        }
        for (name, symbol) in &list {
            model.arena.set_printed_name(name, &symbol.text);
            // Declaring the symbol keeps named terms from getting a name that looks like it.
            model.arena.symbol(&symbol.text);
        }
        for (name, symbol) in &list {
            if let Some(other) = name_with_same_symbol(model, name, &symbol.text, &list) {
                let message = format!("`{name}` and `{other}` would both be shown as `{}`", symbol.text);
                self.reader.error(symbol.span.clone(), message, "give each name a symbol of its own");
            } else if is_reserved_notation(&symbol.text) {
                let message = format!("documents write `{}` for something else", symbol.text);
                let help = "T and V are energies; M, f, F, Q and C with numbers are entries of equations";
                self.reader.error(symbol.span.clone(), message, help);
            }
        }
    }
}

/// True if a text can be a symbol: letters and digits, `_` with a subscript, and at most two primes.
fn is_symbol(text: &str) -> bool {
    let stem = text.trim_end_matches('\'');
    let is_part = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_alphanumeric());
    stem.starts_with(|c: char| c.is_ascii_alphabetic())
        && stem.len() <= 30
        && stem.splitn(2, '_').all(|part| part.split('_').all(is_part))
        && text.len() - stem.len() <= MOST_DOTS
}

/// True if documents already use a symbol for energies or for entries of equations.
fn is_reserved_notation(symbol: &str) -> bool {
    let (letters, subscript, _) = name_parts(symbol);
    let is_number = !subscript.is_empty() && subscript.bytes().all(|b| b.is_ascii_digit());
    ENERGIES.contains(&letters.as_str()) && subscript.is_empty() || NUMBERED.contains(&letters.as_str()) && is_number
}

/// Name of another quantity of the model that would look like the quantity `name` if its symbol were `symbol`.
/// Symbols with dots for time derivatives are compared as well. `None` if all look different.
fn name_with_same_symbol(model: &Model, name: &str, symbol: &str, list: &[(String, Located)]) -> Option<String> {
    let printed = |name: &str| {
        let stated = list.iter().find(|(stated, _)| stated == name);
        stated.map_or_else(|| name.to_owned(), |(_, symbol)| symbol.text.clone())
    };
    let parameters = model.parameters.iter().map(|p| (&p.name, 0));
    let coordinates = model.coordinates.iter().map(|c| (&c.name, 2));
    let speeds = model.speeds.iter().map(|s| (&s.name, 1));
    let reactions = model.reactions.iter().map(|r| (&r.name, 0));
    let quantities: Vec<(&String, usize)> = parameters.chain(coordinates).chain(speeds).chain(reactions).collect();
    let Some(dots) = quantities.iter().find(|(other, _)| *other == name).map(|(_, dots)| *dots) else {
        return place_with_same_symbol(model, name, symbol, &printed);
    };
    // A generalized speed that equals a coordinate's rate may look like it.
    let is_rate = |speed: &str, of: &str| {
        let speed = model.speeds.iter().find(|one| one.name == speed);
        speed.is_some_and(|speed| model.coordinates.iter().any(|c| c.name == of && c.rate == speed.definition))
    };
    let is_equal = |other: &str, order: usize, own: usize| {
        is_rate(name, other) && order == own + 1 || is_rate(other, name) && own == order + 1
    };
    let looks = |own: usize| name_parts(&format!("{symbol}{}", "'".repeat(own)));
    quantities.iter().filter(|(other, _)| *other != name).find_map(|(other, order)| {
        let alike = (0..=*order).any(|order| {
            let other_looks = name_parts(&format!("{}{}", printed(other), "'".repeat(order)));
            (0..=dots).any(|own| looks(own) == other_looks && !is_equal(other, order, own))
        });
        alike.then(|| (*other).clone())
    })
}

/// Name of another frame, point or body that would look like the frame, point or body `name` if its symbol were
/// `symbol`. Case is ignored, since basis vectors have small letters. `None` if all look different.
fn place_with_same_symbol(model: &Model, name: &str, symbol: &str, printed: &dyn Fn(&str) -> String) -> Option<String> {
    let frames: Vec<&String> = model.frames.iter().map(|frame| &frame.name).collect();
    let points: Vec<&String> = model.points.iter().map(|point| &point.name).collect();
    let bodies: Vec<&String> = model.bodies.iter().map(|body| &body.name).collect();
    let own = [frames, points, bodies].into_iter().find(|list| list.iter().any(|other| *other == name))?;
    let looks = |symbol: &str| name_parts(&symbol.to_lowercase());
    own.into_iter().find(|other| *other != name && looks(&printed(other)) == looks(symbol)).cloned()
}
