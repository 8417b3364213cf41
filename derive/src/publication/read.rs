//! From the text of a publication file to a [`Publication`]: the file as a whole, and the names it declares.
//!
//! Every error is reported once, at its cause; `None` always means that an error stands in the reader.

use super::spelling::notations;
use super::words::Words;
use super::{Approximation, Publication};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest, shown};
use crate::mechanics::Quantity;
use crate::model::Model;
use crate::read::{Entry as Field, Located, Reader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys of the file.
pub const KEYS: [&str; 14] = [
    "schema",
    "equation",
    "definition",
    "system",
    "listing",
    "initial",
    "title",
    "source",
    "notation",
    "about",
    "order",
    "symbols",
    "abbreviations",
    "names",
];
/// The most names of one kind that a file declares.
const MAX_NAMES: usize = 1000;
/// Errors after which no formula is read any more: nobody mends that many at once.
const MAX_ERRORS: usize = 1000;

/// Reads a publication for its model; formulas go to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the file.
pub fn load(source: &Source, model: &mut Model) -> Result<Publication, Diagnostics> {
    let (mut reader, table) = Reader::parse(source)?;
    let table = table.get_ref();
    if table.is_empty() {
        let empty = source.text.trim_start_matches('\u{feff}').trim().is_empty();
        let message =
            if empty { "the publication file is empty" } else { "the publication file holds nothing but comments" };
        reader.errors.push(Diagnostic::of_file(message, "docs/publication.md describes the format"));
    }
    reader.schema(table);
    reader.finish()?;
    reader.allow(table, "a publication file", &KEYS);
    let words = Words::new(model);
    let mut loading = Loading {
        reader,
        model,
        words,
        notation: Notation::default(),
        near: None,
        ids: FxHashMap::default(),
        values: FxHashMap::default(),
    };
    let title = loading.text(table, "title").unwrap_or_default();
    let reference = loading.text(table, "source").unwrap_or_default();
    let names = loading.names(table);
    loading.notation = loading.notation(table);
    let abbreviations = loading.abbreviations(table);
    loading.near = loading.near(table);
    let entries = loading.entries(table);
    loading.reader.finish()?;
    Ok(Publication { source: source.clone(), title, reference, abbreviations, names, entries })
}

/// State of reading a publication: the file, the model, and the names and entries read so far.
pub struct Loading<'a, 'm> {
    pub reader: Reader<'a>,
    pub model: &'m mut Model,
    pub words: Words,
    /// Notation of formulas whose entry states none.
    pub notation: Notation,
    /// Point near which formulas hold whose entry states none.
    pub near: Option<Approximation>,
    /// Place of each id in the file.
    pub ids: FxHashMap<String, Range<usize>>,
    /// Place where each set states a quantity.
    pub values: FxHashMap<(String, Expr), Range<usize>>,
}

impl<'a> Loading<'a, '_> {
    /// The notation that a table states, or that of the file.
    pub fn notation(&mut self, table: &'a DeTable<'a>) -> Notation {
        let Some(value) = self.reader.get(table, "notation") else { return self.notation };
        let Some(name) = self.reader.string(value, "`notation`") else { return self.notation };
        Notation::named(&name.text).unwrap_or_else(|| {
            let message = format!("there is no notation `{}`", shown(&name.text));
            self.reader.error(name.span, message, nearest(&name.text, notations()));
            self.notation
        })
    }

    /// A formula in the names of the model and of the file.
    pub fn formula(&mut self, formula: &Located, notation: Notation) -> Option<Expr> {
        if self.reader.errors.len() > MAX_ERRORS {
            return None;
        }
        self.words.formula(&mut self.reader, &mut self.model.arena, formula, notation)
    }

    /// The name of a derived quantity.
    pub fn quantity(&mut self, name: &Located) -> Option<Quantity> {
        match Quantity::parse(&name.text, self.model) {
            Ok(quantity) => Some(quantity),
            Err(error) => {
                self.reader.error(name.part(error.range), error.message, error.help);
                None
            }
        }
    }

    /// A string that may be absent.
    pub fn text(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<String> {
        self.reader.prose(table, key)
    }

    /// The values of an array.
    pub fn array(
        &mut self,
        value: &'a Spanned<DeValue<'a>>,
        what: &str,
        example: &str,
    ) -> Option<&'a [Spanned<DeValue<'a>>]> {
        match value.get_ref() {
            DeValue::Array(array) => Some(array),
            _ => {
                self.reader.error(value.span(), format!("{what} must be an array"), format!("write {example}"));
                None
            }
        }
    }

    /// The fields of a section that declares names.
    fn section(&mut self, table: &'a DeTable<'a>, key: &str, example: &str) -> Vec<Field<'a>> {
        let Some(value) = self.reader.get(table, key) else { return Vec::new() };
        let example = format!("[{key}] with lines such as {example}");
        let Some(section) = self.reader.table(value, &format!("`{key}`"), &example) else { return Vec::new() };
        let mut fields = self.reader.entries(section);
        if let Some((name, _)) = fields.get(MAX_NAMES) {
            let message = format!("more than {MAX_NAMES} names in `{key}`");
            self.reader.error(name.span.clone(), message, "split the publication into several files");
            fields.truncate(MAX_NAMES);
        }
        fields
    }

    /// `[names]`: symbols for derived quantities.
    fn names(&mut self, table: &'a DeTable<'a>) -> Vec<(String, Quantity, Expr)> {
        let mut names = Vec::new();
        for (name, value) in self.section(table, "names", "a1 = \"a(P) @ B [1]\"") {
            let text = self.reader.string(value, "the name of a quantity");
            let quantity = text.and_then(|text| self.quantity(&text));
            // A space: no file can declare such a symbol.
            let symbol = quantity.as_ref().map(|q| self.model.arena.symbol(&format!("derived {q}")));
            let declared = self.words.declare(&mut self.reader, &name, symbol);
            if let (true, Some(quantity), Some(symbol)) = (declared, quantity, symbol) {
                names.push((name.text, quantity, symbol));
            }
        }
        names
    }

    /// `[symbols]`: how the publication writes names of the model and of the file.
    fn symbols(&mut self, table: &'a DeTable<'a>) {
        for (symbol, value) in self.section(table, "symbols", "'I_{xx}' = \"I1\"") {
            if let Some(name) = self.reader.string(value, "the name of a symbol") {
                self.words.spell(&mut self.reader, &symbol, &name);
            }
        }
    }

    /// `[abbreviations]`: formulas in the names of the model and in earlier abbreviations.
    fn abbreviations(&mut self, table: &'a DeTable<'a>) -> Vec<(String, Expr)> {
        let section = self.section(table, "abbreviations", "s1 = \"sin(q1)\"");
        for (name, _) in &section {
            self.words.announce(&name.text);
        }
        self.symbols(table);
        let mut abbreviations = Vec::new();
        for (name, value) in section {
            let formula = self.reader.formula(value, &format!("`{}`", crate::diagnostic::shown(&name.text)));
            let formula = formula.and_then(|f| self.formula(&f, self.notation));
            let declared = self.words.declare(&mut self.reader, &name, formula);
            if let (true, Some(formula)) = (declared, formula) {
                abbreviations.push((name.text, formula));
            }
        }
        abbreviations
    }
}
