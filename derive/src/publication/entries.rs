//! Reading of the entries of a publication: keys that all entries have, and entries with a single formula.

use super::printed::LabelChoice;
use super::printed::equalities::sides;
use super::printed::printed_matrix::{MatrixCells, printed_matrix_cells};
use super::publication_reader::{KEYS, PublicationReader};
use super::{Entry, EntryKind, Initial};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::algebra::value::tape::Tape;
use crate::diagnostic::{Diagnostic, nearest_name_advice, shortened_for_message};
use crate::mechanics::Quantity;
use crate::toml_reader::Located;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Largest number of entries in a publication file.
const MAX_ENTRIES: usize = 2000;
/// Largest number of characters in an entry's id.
const MAX_ID: usize = 80;

/// Kind of an entry of a publication file, which is given by the name of its table.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Equation,
    Matrix,
    Definition,
    System,
    Listing,
    Initial,
}

/// Kinds of entries, each with its key and its name in messages.
const KINDS: [(Kind, &str, &str); 6] = [
    (Kind::Equation, "equation", "an equation"),
    (Kind::Matrix, "matrix", "a matrix"),
    (Kind::Definition, "definition", "a definition"),
    (Kind::System, "system", "a system"),
    (Kind::Listing, "listing", "a listing"),
    (Kind::Initial, "initial", "an initial value"),
];

/// Keys that a table may have for an entry of this kind.
fn entry_keys(kind: Kind) -> Vec<&'static str> {
    let own: &[&str] = match kind {
        Kind::Equation => &["quantity", "printed", "label", "line", "formulation", "frame"],
        Kind::Matrix => &["quantity", "printed", "label", "line", "claims"],
        Kind::Definition => &["printed"],
        Kind::System => &[
            "formulation",
            "frame",
            "equations",
            "label",
            "labels",
            "unknowns",
            "matrix",
            "right",
            "matrix_ids",
            "right_ids",
        ],
        Kind::Listing => &["formulation", "state", "derivative", "matrix"],
        Kind::Initial => &["set", "quantity", "printed"],
    };
    let formulas: &[&str] = match kind {
        Kind::Definition => &[],
        Kind::Initial => &["notation"],
        Kind::Equation | Kind::Matrix | Kind::System | Kind::Listing => {
            &["notation", "file", "part", "about", "small", "order"]
        }
    };
    [&["id", "section", "repaired", "note"], formulas, own].concat()
}

/// Byte range of a part of a text, without the spaces at both ends of the part.
fn trimmed_range(text: &str, range: Range<usize>) -> Range<usize> {
    let part = &text[range.clone()];
    let start = range.start + part.len() - part.trim_start().len();
    start..start + part.trim().len()
}

/// Part of a printed formula, without spaces at its ends, with its place in the file.
pub(super) fn entry_formula_part(printed: &Located, range: Range<usize>) -> Located {
    Located {
        text: printed.text[range.clone()].trim().to_owned(),
        span: printed.part(trimmed_range(&printed.text, range)),
        exact: printed.exact,
    }
}

/// Table of an entry in a publication file, with its place.
pub struct EntryTable<'a> {
    /// TOML table with the keys of the entry.
    pub table: &'a DeTable<'a>,
    /// Name of the entry's kind for messages, such as "an equation".
    pub what: &'static str,
    /// Byte range of the entry in the publication file.
    pub span: Range<usize>,
    /// Notation in which the entry's formulas are written.
    pub notation: Notation,
}

impl<'a> PublicationReader<'a, '_> {
    /// Reads all entries, in the order of the publication file.
    pub fn entries(&mut self, table: &'a DeTable<'a>) -> Vec<Entry> {
        let before = self.reader.errors.len();
        let mut items: Vec<(Kind, EntryTable<'a>)> = Vec::new();
        for (kind, key, what) in KINDS {
            let Some(value) = self.reader.get(table, key) else { continue };
            let DeValue::Array(array) = value.get_ref() else {
                let help = format!("write each as [[{key}]]");
                self.reader.error(value.span(), format!("`{key}` must be a list of tables"), help);
                continue;
            };
            for value in array {
                if let Some(table) = self.reader.table(value, what, &format!("[[{key}]]")) {
                    let notation = if kind == Kind::Definition { self.notation } else { self.notation(table) };
                    items.push((kind, EntryTable { table, what, span: value.span(), notation }));
                }
            }
        }
        // An unknown key is reported, since it may be a misspelt kind of entry.
        let all_known = table.iter().all(|(key, _)| KEYS.contains(&key.get_ref().as_ref()));
        if items.is_empty() && all_known && self.reader.errors.len() == before {
            let help = "add [[equation]] entries; docs/publication.md describes the format";
            self.reader.errors.push(Diagnostic::of_file("the publication has no entries", help));
        }
        items.sort_by_key(|(_, item)| item.span.start);
        if let Some((_, item)) = items.get(MAX_ENTRIES) {
            let message = format!("more than {MAX_ENTRIES} entries");
            self.reader.error(item.span.clone(), message, "split the publication into several files");
            items.truncate(MAX_ENTRIES);
        }
        let mut entries = Vec::new();
        for (kind, item) in &items {
            entries.extend(self.entry(*kind, item).unwrap_or_default());
        }
        if entries.len() > MAX_ENTRIES {
            let message = format!("more than {MAX_ENTRIES} entries with those of matrices and chains");
            self.reader.errors.push(Diagnostic::of_file(message, "split the publication into several files"));
        }
        entries
    }

    /// Reads a table of the publication file as its entries. A matrix, or a chain of formulas, gives several entries.
    /// The formulas may use the variables of the program that the table names. `None` if an error is reported.
    fn entry(&mut self, kind: Kind, item: &EntryTable<'a>) -> Option<Vec<Entry>> {
        let program = self.read_program_assignments(item);
        self.words.locals = program.unwrap_or_default();
        let read = self.read_entry(kind, item);
        self.words.locals = std::sync::Arc::default();
        read
    }

    /// Reads a table of the publication file as its entries, once the variables of its program are known. `None` if an
    /// error is reported.
    fn read_entry(&mut self, kind: Kind, item: &EntryTable<'a>) -> Option<Vec<Entry>> {
        self.reader.report_unknown_keys(item.table, item.what, &entry_keys(kind));
        let id = self.read_entry_id(item);
        let section = self.required_entry_text(item, "section");
        let repaired = self.read_text(item.table, "repaired");
        let note = self.read_text(item.table, "note");
        let near = match kind {
            Kind::Equation | Kind::Matrix | Kind::System | Kind::Listing => self.read_approximation(item.table),
            Kind::Definition | Kind::Initial => None,
        };
        let whole = |kind: EntryKind| vec![(String::new(), kind)];
        let kinds = match kind {
            Kind::Matrix => self.matrix_entries(item),
            Kind::Equation => self.read_equation(item),
            Kind::Definition => {
                self.required_entry_text(item, "printed").map(|text| whole(EntryKind::Definition { text: text.text }))
            }
            Kind::System => self.read_system(item).map(|system| whole(EntryKind::System(system))),
            Kind::Listing => self.read_listing(item).map(|listing| whole(EntryKind::Listing(listing))),
            Kind::Initial => self.read_initial(item).map(whole),
        };
        let (id, section, kinds) = (id?, section?.text, kinds?);
        let mut entries = Vec::new();
        for (at, (suffix, kind)) in kinds.into_iter().enumerate() {
            let is_whole = suffix.is_empty();
            let entry = Entry {
                id: if is_whole { id.text.clone() } else { format!("{}-{suffix}", id.text) },
                section: section.clone(),
                repaired: repaired.clone().filter(|_| at == 0),
                note: note.clone().filter(|_| at == 0),
                notation: item.notation,
                near: near.clone(),
                span: id.span.clone(),
                kind,
            };
            for part in entry.ids() {
                if part != id.text {
                    self.reserve_entry_id(&part, &id.span, ", of a part of this entry,");
                }
            }
            entries.push(entry);
        }
        Some(entries)
    }

    /// Reads a printed matrix or vector of a quantity as one equation for each element, each with the suffix of its id.
    /// The Coriolis matrix C is judged as a whole instead. Returns `None` if an error is reported.
    fn matrix_entries(&mut self, item: &EntryTable<'a>) -> Option<Vec<(String, EntryKind)>> {
        let quantity = self.required_entry_text(item, "quantity");
        let printed = self.read_entry_formula(item)?;
        let MatrixCells { rows, factor } = match printed_matrix_cells(&printed.text, item.notation) {
            Ok(cells) => cells,
            Err(why) => {
                let help = "write the whole matrix under `printed`, or give each component an [[equation]] of its own";
                self.reader.error(printed.span, why, help);
                return None;
            }
        };
        let factor = match factor {
            Some(factor) => Some(self.entry_matrix_factor(&entry_formula_part(&printed, factor), item.notation)?),
            None => None,
        };
        let factor = factor.as_ref();
        let quantity = quantity?;
        if quantity.text.trim() == "C" {
            let cells = self.entry_matrix_cells(rows, factor, &printed, item)?;
            return self.coriolis_entries(item, &cells, &printed);
        }
        if let Some(value) = self.reader.get(item.table, "claims") {
            let help = "claims are about the matrix C of C(q, q') q'";
            self.reader.error(value.span(), format!("`claims` on `{}`", shortened_for_message(&quantity.text)), help);
            return None;
        }
        let comma = if rows.len().max(rows[0].len()) > 9 { "," } else { "" };
        let is_vector = rows.len() == 1 || rows[0].len() == 1;
        let named = |index: &str| Located { text: format!("{} {index}", quantity.text), ..quantity.clone() };
        let by_one = is_vector && Quantity::parse(&named("[1]").text, self.model).is_ok();
        let mut list = Vec::new();
        for (i, row) in rows.into_iter().enumerate() {
            let mut entries = Vec::new();
            for (j, cell) in row.into_iter().enumerate() {
                let index = if by_one { format!("[{}]", i.max(j) + 1) } else { format!("[{},{}]", i + 1, j + 1) };
                let name = Located { exact: false, ..named(&index) };
                let formula = entry_formula_part(&printed, cell);
                let (quantity, value) =
                    (self.read_quantity(&name), self.cell_with_factor(factor, &formula, item.notation));
                // A single error message for an unknown quantity is enough.
                let of = value.as_ref().map_or(Expr::ZERO, |(value, _)| *value);
                let own = self.in_own_coordinates(item, &quantity?, of);
                let suffix = format!("{}{comma}{}", i + 1, j + 1);
                entries.push(
                    own.zip(value).map(|((quantity, printed), (_, text))| {
                        (suffix, EntryKind::Equation { quantity, printed, text })
                    }),
                );
            }
            list.push(entries.into_iter().collect::<Option<Vec<_>>>());
        }
        Some(list.into_iter().collect::<Option<Vec<_>>>()?.concat())
    }

    /// Terms and texts of the elements of a printed matrix, row by row; `None` if an error is
    /// reported.
    fn entry_matrix_cells(
        &mut self,
        rows: Vec<Vec<Range<usize>>>,
        factor: Option<&(Expr, String)>,
        printed: &Located,
        item: &EntryTable<'a>,
    ) -> Option<Vec<Vec<(Expr, String)>>> {
        let mut list = Vec::new();
        for row in rows {
            let mut cells = Vec::new();
            for cell in row {
                let formula = entry_formula_part(printed, cell);
                cells.push(self.cell_with_factor(factor, &formula, item.notation));
            }
            list.push(cells);
        }
        list.into_iter().map(|row| row.into_iter().collect()).collect()
    }

    /// Value and text of the factor before a matrix, which may be only a sign. `None` if an error is reported.
    fn entry_matrix_factor(&mut self, printed: &Located, notation: Notation) -> Option<(Expr, String)> {
        let value = if printed.text == "-" { Expr::MINUS_ONE } else { self.formula(printed, notation)? };
        let times = if printed.text == "-" || notation == Notation::Latex { "" } else { "*" };
        Some((value, format!("{}{times}", printed.text)))
    }

    /// Value and text of an element of a matrix, multiplied by the factor before the matrix. `None` if an error is
    /// reported.
    fn cell_with_factor(
        &mut self,
        factor: Option<&(Expr, String)>,
        formula: &Located,
        notation: Notation,
    ) -> Option<(Expr, String)> {
        let value = self.formula(formula, notation)?;
        Some(match factor {
            Some((factor, text)) => (self.model.arena.mul(*factor, value), format!("{text}({})", formula.text)),
            None => (value, formula.text.clone()),
        })
    }

    /// Text under a required key of an entry; reports an absent key and returns `None`.
    pub fn required_entry_text(&mut self, item: &EntryTable<'a>, key: &str) -> Option<Located> {
        let value = self.reader.required(item.table, key, item.what, &item.span)?;
        self.reader.string(value, &format!("`{key}`"))
    }

    /// Array under a required key of an entry, with its place. Reports a key that is absent or has another value, and
    /// returns `None`.
    pub(super) fn required_entry_array(
        &mut self,
        item: &EntryTable<'a>,
        key: &str,
        example: &str,
    ) -> Option<(&'a [Spanned<DeValue<'a>>], Range<usize>)> {
        let value = self.reader.required(item.table, key, item.what, &item.span)?;
        Some((self.require_array(value, &format!("`{key}`"), example)?, value.span()))
    }

    /// Printed formula of an entry: the text under the key `printed`, or the labelled equation in a file. Returns
    /// `None` if an error is reported.
    fn read_entry_formula(&mut self, item: &EntryTable<'a>) -> Option<Located> {
        let Some(label) = self.reader.get(item.table, "label") else {
            if let Some(line) = self.reader.get(item.table, "line") {
                self.reader.error(line.span(), "`line` without `label`", "`line` counts the equations of a label");
            }
            return self.required_entry_formula(item, "printed");
        };
        if let Some(printed) = self.reader.get(item.table, "printed") {
            let help = "give a formula here as `printed`, or give a label of a file, not both";
            self.reader.error(printed.span(), "`printed` beside `label`", help);
        }
        let label = self.reader.string(label, "`label`")?;
        let mut list = self.equations_by_label(item, &label, LabelChoice::Labelled)?;
        let count = list.len();
        let at = match self.reader.get(item.table, "line") {
            None if count == 1 => 0,
            None => {
                let message = format!("the label `{}` has {count} equations", shortened_for_message(&label.text));
                self.reader.error(label.span, message, format!("choose one: line = 1 to line = {count}"));
                return None;
            }
            Some(line) => match line.get_ref() {
                DeValue::Integer(n) => n.as_str().parse().unwrap_or(0_usize).wrapping_sub(1),
                _ => usize::MAX,
            },
        };
        if at >= count {
            let span = self.reader.get(item.table, "line").map_or(label.span, Spanned::span);
            self.reader.error(span, "there is no such line", format!("write a number from 1 to {count}"));
            return None;
        }
        Some(list.swap_remove(at))
    }

    /// Formula under a required key of an entry; reports an absent key and returns `None`.
    fn required_entry_formula(&mut self, item: &EntryTable<'a>, key: &str) -> Option<Located> {
        let value = self.reader.required(item.table, key, item.what, &item.span)?;
        self.reader.formula(value, &format!("`{key}`"))
    }

    /// Reads the id of an entry. Reports an unsuitable or repeated id and returns `None`.
    fn read_entry_id(&mut self, item: &EntryTable<'a>) -> Option<Located> {
        let id = self.required_entry_text(item, "id")?;
        let odd = |c: char| c.is_whitespace() || c.is_control();
        if id.text.is_empty() || id.text.chars().count() > MAX_ID || id.text.contains(odd) {
            let message = format!("`{}` cannot be an id", shortened_for_message(&id.text));
            let help = format!("an id has 1 to {MAX_ID} characters and no spaces, such as 2.11-a1");
            self.reader.error(id.span, message, help);
            return None;
        }
        let (text, span) = (id.text.clone(), id.span.clone());
        self.reserve_entry_id(&text, &span, "");
        Some(id)
    }

    /// Reserves an id for an entry, or reports that the id is already in use.
    fn reserve_entry_id(&mut self, id: &str, span: &Range<usize>, of_what: &str) {
        if let Some(first) = self.ids.get(id) {
            let message = format!("the id `{}`{of_what} is used twice", shortened_for_message(id));
            let twice = if first == span {
                Diagnostic::new(span.clone(), message, "keep row and column apart, as in E{i},{j}")
            } else {
                let help = "ids are unique in a file: add a suffix such as -line2";
                Diagnostic::new(span.clone(), message, help).with_other(first.clone(), "first used here")
            };
            self.reader.errors.push(twice);
            return;
        }
        self.ids.insert(id.to_owned(), span.clone());
    }

    /// Reads an entry `[[equation]]` with the printed values of a quantity. A chain `a = b = c` has several values. If
    /// the quantity is absent or 0, the entry is an equation of motion. Each value has the suffix of its id, which is
    /// empty for a single value.
    fn read_equation(&mut self, item: &EntryTable<'a>) -> Option<Vec<(String, EntryKind)>> {
        let printed = self.read_entry_formula(item);
        if printed.is_none() && self.reader.get(item.table, "label").is_some() {
            return None;
        }
        let is_zero = |value: &Spanned<DeValue<'a>>| match value.get_ref() {
            DeValue::String(name) => name.trim() == "0",
            DeValue::Integer(n) => n.as_str() == "0",
            _ => false,
        };
        let quantity = self.reader.get(item.table, "quantity");
        let is_equation = printed.as_ref().is_some_and(|formula| formula.text.contains('='));
        if quantity.map_or(is_equation, is_zero) {
            let system = self.system_of_motion_equation(item, &printed?)?;
            return Some(vec![(String::new(), EntryKind::System(system))]);
        }
        let name = self.required_entry_text(item, "quantity");
        let values = printed.map(|formula| printed_entry_values(&formula, item.notation));
        let unknown = name.as_ref().and_then(|name| self.system_unknown_by_name(&name.text));
        let kinds: Vec<Option<EntryKind>> = if let Some(unknown) = unknown {
            let values = values?.into_iter();
            values.map(|value| self.value_of_unknown(item, unknown, &value).map(EntryKind::System)).collect()
        } else {
            let quantity = name.and_then(|name| self.read_quantity(&name));
            let values = values.unwrap_or_default().into_iter();
            let values: Vec<_> = values.map(|value| (self.formula(&value, item.notation), value.text)).collect();
            let quantity = quantity?;
            let mut kinds = Vec::new();
            for (formula, text) in values {
                let own = formula.and_then(|formula| self.in_own_coordinates(item, &quantity, formula));
                kinds.push(own.map(|(quantity, printed)| EntryKind::Equation { quantity, printed, text }));
            }
            kinds
        };
        let is_chain = kinds.len() > 1;
        let suffix = |at: usize| if is_chain { (at + 1).to_string() } else { String::new() };
        kinds.into_iter().enumerate().map(|(at, kind)| Some((suffix(at), kind?))).collect()
    }

    /// Reads an entry `[[initial]]`: a printed number of a parameter, or an initial value. Reports a second number for
    /// the same quantity in the set. `None` if an error is reported.
    fn read_initial(&mut self, item: &EntryTable<'a>) -> Option<EntryKind> {
        let set = self.required_entry_text(item, "set");
        let quantity = self.required_entry_text(item, "quantity").and_then(|name| self.initial_quantity(name));
        let printed = self.required_entry_formula(item, "printed");
        let value = printed.as_ref().and_then(|f| self.read_constant(f, item.notation));
        let (set, (name, symbol), text) = (set?.text, quantity?, printed?.text);
        if let Some(first) = self.values.get(&(set.clone(), symbol)) {
            let message = format!("`{}` has two values in the set `{}`", name.text, shortened_for_message(&set));
            let twice = Diagnostic::new(name.span, message, "put what another place prints into a set of its own");
            self.reader.errors.push(twice.with_other(first.clone(), "first stated here"));
            return None;
        }
        self.values.insert((set.clone(), symbol), name.span);
        let decimals = count_decimals(&text);
        if self.words.is_renamed(&name.text) {
            // The number belongs to a variable that only the publication has.
            return Some(EntryKind::Definition { text });
        }
        Some(EntryKind::Initial(Initial { set, quantity: symbol, name: name.text, value: value?, text, decimals }))
    }

    /// Name and symbol of a parameter, a coordinate, the derivative of a coordinate, or a speed. Reports any other name
    /// and returns `None`.
    fn initial_quantity(&mut self, name: Located) -> Option<(Located, Expr)> {
        let model = &self.model;
        let mut known: Vec<(String, Expr)> = model.parameters.iter().map(|p| (p.name.clone(), p.symbol)).collect();
        for c in &model.coordinates {
            known.extend([(c.name.clone(), c.symbol), (format!("{}'", c.name), c.rate)]);
        }
        known.extend(model.speeds.iter().map(|s| (s.name.clone(), s.symbol)));
        if let Some((_, symbol)) = known.iter().find(|(n, _)| *n == name.text) {
            return Some((name, *symbol));
        }
        let message =
            format!("`{}` is no parameter, coordinate, time derivative or speed", shortened_for_message(&name.text));
        self.reader.error(name.span, message, nearest_name_advice(&name.text, known.iter().map(|(n, _)| n.as_str())));
        None
    }

    /// Reads a formula without symbols as a number.
    /// Reports a formula with symbols or without a finite value, and returns `None`.
    fn read_constant(&mut self, formula: &Located, notation: Notation) -> Option<Expr> {
        let e = self.formula(formula, notation)?;
        let arena = &self.model.arena;
        if let Some(symbol) = arena.reachable(&[e]).iter().find_map(|part| arena.symbol_name(*part)) {
            let message = format!("`{}` is not a number: it contains `{symbol}`", shortened_for_message(&formula.text));
            self.reader.error(formula.span.clone(), message, "write a number, or one in terms of numbers and `pi`");
            return None;
        }
        let value = Tape::new(arena, &[], &[e]).map_or(f64::NAN, |tape| tape.evaluate(&[])[0]);
        if !value.is_finite() {
            let message = format!("`{}` is not a number of double precision", shortened_for_message(&formula.text));
            self.reader.error(formula.span.clone(), message, "give a finite number below 1e308 in size");
            return None;
        }
        Some(e)
    }
}

/// Values that an equation, or a chain `name = a = b`, prints for the quantity on its left side. A formula without `=`
/// is a single value.
fn printed_entry_values(formula: &Located, notation: Notation) -> Vec<Located> {
    let sides = sides(&formula.text, 0..formula.text.len(), notation);
    match &sides[..] {
        [left, right @ ..] if !right.is_empty() && !formula.text[left.clone()].contains(['+', '/']) => {
            right.iter().map(|side| entry_formula_part(formula, side.clone())).collect()
        }
        _ => vec![formula.clone()],
    }
}

/// Number of decimals of a plain number, such as five for `1.50e-3`; `None` for any other formula.
fn count_decimals(text: &str) -> Option<u32> {
    let text = text.trim().trim_start_matches(['-', '+']).trim_start();
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    if mantissa.is_empty() || !mantissa.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
        return None;
    }
    let after_point = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    u32::try_from((i64::try_from(after_point).ok()? - exponent).max(0)).ok()
}

#[cfg(test)]
mod tests {
    use super::count_decimals;

    #[test]
    fn decimals_are_those_printed() {
        let cases = [("0.1745", Some(4)), ("5", Some(0)), ("-0.10", Some(2)), ("1.50e-3", Some(5)), ("2e3", Some(0))];
        for (text, expected) in cases.into_iter().chain([("10*pi/180", None), ("pi", None), ("1/4", None), ("", None)])
        {
            assert_eq!(count_decimals(text), expected, "{text}");
        }
    }
}
