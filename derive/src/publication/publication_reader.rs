//! Reading of a publication file as a [`Publication`]: the file as a whole, and the names that it declares.
//!
//! Every error is reported once, at its cause. In the modules of this folder, `None` as a result means that an error
//! has been reported to the reader.

use super::names::author_files::{AuthorFiles, notation_of_author_file, read_file_beside_publication};
use super::names::name_meanings::NameMeanings;
use super::names::name_spelling::notation_names;
use super::{Approximation, Publication};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice, shortened_for_message};
use crate::mechanics::Quantity;
use crate::model::Model;
use crate::toml_reader::{Entry as Field, Located, TomlReader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys that may occur at the top of a publication file.
pub const KEYS: [&str; 19] = [
    "schema",
    "file",
    "macros",
    "equation",
    "definition",
    "system",
    "listing",
    "initial",
    "title",
    "source",
    "notation",
    "about",
    "small",
    "order",
    "symbols",
    "coordinates",
    "matrix",
    "abbreviations",
    "names",
];
/// Largest number of names in one section of a publication file.
const MAX_NAMES: usize = 1000;
/// Number of errors after which no further formula is read.
const MAX_ERRORS: usize = 1000;

/// Reads a publication file for its model, and adds its formulas to the model's arena.
///
/// # Errors
/// [`Diagnostics`] with every error of the publication file.
pub fn load_publication(source: &Source, model: &mut Model) -> Result<Publication, Diagnostics> {
    let folder = source.path.parent().map(std::path::Path::to_owned).unwrap_or_default();
    load_publication_with_files(source, model, &|name| read_file_beside_publication(&folder.join(name)))
}

/// Reads a publication file for its model, with `coordinates` instead of the file's own table
/// `[coordinates]`.
///
/// # Errors
/// [`Diagnostics`] with every error of the publication file.
pub fn load_publication_in_coordinates(
    source: &Source,
    model: &mut Model,
    coordinates: &[(String, String)],
) -> Result<Publication, Diagnostics> {
    let folder = source.path.parent().map(std::path::Path::to_owned).unwrap_or_default();
    load_publication_from(source, model, &|name| read_file_beside_publication(&folder.join(name)), Some(coordinates))
}

/// Reads a publication file for its model. The function `read` reads a file to which the publication refers, by its
/// name.
///
/// # Errors
/// [`Diagnostics`] with every error of the publication file and of the files to which it refers.
pub fn load_publication_with_files(
    source: &Source,
    model: &mut Model,
    read: &dyn Fn(&str) -> Result<Source, Diagnostics>,
) -> Result<Publication, Diagnostics> {
    load_publication_from(source, model, read, None)
}

/// Reads a publication file, with optional coordinates instead of its own table `[coordinates]`.
fn load_publication_from(
    source: &Source,
    model: &mut Model,
    read: &dyn Fn(&str) -> Result<Source, Diagnostics>,
    stated: Option<&[(String, String)]>,
) -> Result<Publication, Diagnostics> {
    let (mut reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    if table.is_empty() {
        let empty = source.text.trim_start_matches('\u{feff}').trim().is_empty();
        let message =
            if empty { "the publication file is empty" } else { "the publication file holds nothing but comments" };
        reader.errors.push(Diagnostic::of_file(message, "docs/publication.md describes the format"));
    }
    reader.schema(table);
    reader.finish()?;
    reader.report_unknown_keys(table, "a publication file", &KEYS);
    let words = NameMeanings::new(model);
    let mut loading = PublicationReader {
        reader,
        model,
        words,
        notation: Notation::default(),
        near: None,
        ids: FxHashMap::default(),
        values: FxHashMap::default(),
        files: AuthorFiles::new(read),
        stated,
        coordinates: Vec::new(),
        redefined: Vec::new(),
    };
    let title = loading.read_text(table, "title").unwrap_or_default();
    let reference = loading.read_text(table, "source").unwrap_or_default();
    let names = loading.read_names(table);
    loading.read_named_files(table);
    loading.notation = loading.notation(table);
    let abbreviations = loading.read_abbreviations(table);
    loading.report_names_in_own_coordinates(&names);
    loading.near = loading.read_approximation(table);
    let entries = loading.entries(table);
    let mut files: Vec<(String, Arc<Source>)> =
        loading.files.sources.into_iter().filter_map(|(name, source)| Some((name, source?))).collect();
    files.sort_by(|(a, _), (b, _)| a.cmp(b));
    let shorthand = loading.words.shorthand;
    loading.reader.finish()?;
    let (coordinates, redefined) = (loading.coordinates, loading.redefined);
    let source = source.clone();
    Ok(Publication {
        source,
        files,
        title,
        reference,
        abbreviations,
        coordinates,
        redefined,
        shorthand,
        names,
        entries,
    })
}

/// State of the reading of a publication file: the file, the model, and the names and entries read
/// so far.
pub struct PublicationReader<'a, 'm> {
    /// Reader of the TOML text, which collects errors.
    pub reader: TomlReader<'a>,
    /// Model to which the publication belongs.
    pub model: &'m mut Model,
    /// Names that formulas may use, with their meanings.
    pub words: NameMeanings,
    /// Notation of formulas in entries that give no notation of their own.
    pub notation: Notation,
    /// Point and order for entries that give none of their own; `None` if the formulas of such entries hold everywhere.
    pub near: Option<Approximation>,
    /// Byte range in the publication file of each entry's id.
    pub ids: FxHashMap<String, Range<usize>>,
    /// Byte range of each printed number. The key is the number's set and quantity.
    pub values: FxHashMap<(String, Expr), Range<usize>>,
    /// Files to which the publication refers.
    pub files: AuthorFiles<'m>,
    /// Coordinates that replace the table `[coordinates]` of the file; `None` to use the file's
    /// own.
    stated: Option<&'m [(String, String)]>,
    /// Coordinates and speeds that only the publication has, as pairs (name, formula in the model's variables).
    pub(super) coordinates: Vec<(String, Expr)>,
    /// Coordinates and speeds of the model to which the publication gives another meaning, as pairs (name, formula).
    redefined: Vec<(String, Expr)>,
}

impl<'a> PublicationReader<'a, '_> {
    /// Notation of a table: its own, or that of the ending of its file, or else the notation of the publication file.
    pub fn notation(&mut self, table: &'a DeTable<'a>) -> Notation {
        let Some(value) = self.reader.get(table, "notation") else {
            // The ending of a file name shows the language of the file.
            let file = self.reader.get(table, "file").and_then(|file| file.get_ref().as_str());
            return file.and_then(notation_of_author_file).unwrap_or(self.notation);
        };
        let Some(name) = self.reader.string(value, "`notation`") else { return self.notation };
        Notation::from_name(&name.text).unwrap_or_else(|| {
            let message = format!("there is no notation `{}`", shortened_for_message(&name.text));
            self.reader.error(name.span, message, nearest_name_advice(&name.text, notation_names()));
            self.notation
        })
    }

    /// Reads a formula in the names of the model and of the publication file; `None` if an error is
    /// reported.
    pub fn formula(&mut self, formula: &Located, notation: Notation) -> Option<Expr> {
        if self.reader.errors.len() > MAX_ERRORS {
            return None;
        }
        if notation == Notation::Latex && !self.reader.is_assembled_text(formula) {
            let expanded = self.without_macros(formula)?;
            return self.words.formula(&mut self.reader, &mut self.model.arena, &expanded, notation);
        }
        self.words.formula(&mut self.reader, &mut self.model.arena, formula, notation)
    }

    /// Reads the name of a derived quantity; reports a name that is not a quantity and returns
    /// `None`.
    pub fn read_quantity(&mut self, name: &Located) -> Option<Quantity> {
        match Quantity::parse(&name.text, self.model) {
            Ok(quantity) => Some(quantity),
            Err(error) => {
                self.reader.error(name.part(error.range), error.message, error.help);
                None
            }
        }
    }

    /// Text under a key of a table; `None` if the key is absent.
    pub fn read_text(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<String> {
        self.reader.prose(table, key)
    }

    /// Values of a TOML array. Reports a value that is not an array and returns `None`; `what` names the value in the
    /// message.
    pub fn require_array(
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

    /// Fields of a section that declares names, at most 1000; reports an error if there are more.
    fn read_name_section(&mut self, table: &'a DeTable<'a>, key: &str, example: &str) -> Vec<Field<'a>> {
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

    /// Reads the table `[names]`: name, quantity and symbol of each derived quantity that the
    /// publication names.
    fn read_names(&mut self, table: &'a DeTable<'a>) -> Vec<(String, Quantity, Expr)> {
        let mut names = Vec::new();
        for (name, value) in self.read_name_section(table, "names", "a1 = \"a(P) @ B [1]\"") {
            let text = self.reader.string(value, "the name of a quantity");
            let quantity = text.and_then(|text| self.read_quantity(&text));
            // The name contains a space, so that no file can declare such a symbol.
            let symbol = quantity.as_ref().map(|q| self.model.arena.symbol(&format!("derived {q}")));
            let declared = self.words.declare(&mut self.reader, &name, symbol);
            if let (true, Some(quantity), Some(symbol)) = (declared, quantity, symbol) {
                self.words.clock.exclude_symbol(symbol);
                names.push((name.text, quantity, symbol));
            }
        }
        names
    }

    /// Reads the table `[symbols]`: the publication's spellings for names of the model and of the
    /// publication file.
    fn read_symbols(&mut self, table: &'a DeTable<'a>) {
        for (symbol, value) in self.read_name_section(table, "symbols", "'I_{xx}' = \"I1\"") {
            if let Some(name) = self.reader.string(value, "the name of a symbol") {
                self.words.add_spelling(&mut self.reader, &symbol, &name);
            }
        }
    }

    /// Declares the coordinates and speeds of the publication, as formulas in the model's variables, with their
    /// derivatives. A formula is `None` if it is wrong and reported. A name that the model also has gets its new
    /// meaning once all formulas are read.
    fn read_coordinates(&mut self, list: Vec<(Located, Option<Located>)>) {
        let mut renamed = Vec::new();
        for (name, formula) in list {
            let formula = formula.and_then(|f| self.formula(&f, Notation::default()));
            if self.words.is_motion(&name.text) {
                renamed.push((name, formula));
                continue;
            }
            let arena = &mut self.model.arena;
            let declared = self.words.declare_moving(&mut self.reader, arena, &name, formula);
            self.coordinates.extend(formula.filter(|_| declared).map(|e| (name.text, e)));
        }
        for (name, formula) in renamed {
            self.words.redefine(&mut self.reader, &mut self.model.arena, &name, formula);
            self.redefined.extend(formula.map(|e| (name.text, e)));
        }
    }

    /// Names and formulas of the publication's coordinates, given by the caller or else by the table `[coordinates]`. A
    /// formula is `None` if it is wrong and reported.
    fn stated_coordinates(&mut self, table: &'a DeTable<'a>) -> Vec<(Located, Option<Located>)> {
        if let Some(stated) = self.stated {
            let whole = self.reader.get(table, "coordinates").map_or(0..0, Spanned::span);
            let located = |text: &String| Located { text: text.clone(), span: whole.clone(), exact: false };
            return stated.iter().map(|(name, formula)| (located(name), Some(located(formula)))).collect();
        }
        let section = self.read_name_section(table, "coordinates", "alpha = \"q2 - q1\"");
        let formulas = section.into_iter().map(|(name, value)| {
            let formula = self.reader.formula(value, &format!("`{}`", shortened_for_message(&name.text)));
            (name, formula)
        });
        formulas.collect()
    }

    /// Reads the tables `[abbreviations]`, `[coordinates]` and `[symbols]`. Returns the abbreviations as pairs (name,
    /// formula). Formulas may use the model's names and earlier abbreviations. A formula is in the publication file, or
    /// in the author's file under a label.
    fn read_abbreviations(&mut self, table: &'a DeTable<'a>) -> Vec<(String, Expr)> {
        let section = self.read_name_section(table, "abbreviations", "s1 = \"sin(q1)\"");
        for (name, _) in &section {
            self.words.announce_abbreviation(&name.text);
        }
        let own = self.stated_coordinates(table);
        for (name, _) in &own {
            self.words.announce_abbreviation(&name.text);
        }
        self.read_coordinates(own);
        self.read_symbols(table);
        let mut abbreviations = Vec::new();
        for (name, value) in section {
            let (formula, notation) = match value.get_ref() {
                DeValue::Table(table) => (self.labelled_definition(&name, table, value.span()), Notation::Latex),
                _ => (self.reader.formula(value, &format!("`{}`", shortened_for_message(&name.text))), self.notation),
            };
            let formula = formula.and_then(|f| self.formula(&f, notation));
            let declared = self.words.declare(&mut self.reader, &name, formula);
            if let (true, Some(formula)) = (declared, formula) {
                self.words.shorthand.add_abbreviation(&self.model.arena, &name.text, formula);
                abbreviations.push((name.text, formula));
            }
        }
        abbreviations
    }
}
