//! Reader of a TOML file: a model, scene or publication. All errors are collected, each with its
//! place in the file.

use crate::algebra::text::print::print_text;
use crate::algebra::value::interval::{constant_with_wide_interval, number_beyond_doubles};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice, shortened_for_message};
use crate::plain_text::{code_point_text, compare_with_numbers, is_blank, is_forbidden, one_line};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Version of the file formats and of the JSON that commands print. It is increased when an
/// existing key changes its meaning.
pub const SCHEMA: u32 = 1;

/// Text of a key or value, with its place in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Located {
    /// Content of the TOML string without quotes and with escapes resolved, or the digits of the TOML
    /// number.
    pub text: String,
    /// Byte range of the text in the file. It excludes the quotes if the text has no escapes.
    pub span: Range<usize>,
    /// True if byte k of `text` is byte `span.start + k` of the file. Then a part of the text has a
    /// place of its own.
    pub exact: bool,
}

impl Located {
    /// Place in the file, as a byte range, of the bytes `range` of the text. It is the whole `span`
    /// if the text is not `exact`.
    #[must_use]
    pub fn part(&self, range: Range<usize>) -> Range<usize> {
        if self.exact { self.span.start + range.start..self.span.start + range.end } else { self.span.clone() }
    }

    /// Bytes `range` of the text without white space at their ends, with their place.
    #[must_use]
    pub fn trimmed(&self, range: Range<usize>) -> Self {
        let part = &self.text[range.clone()];
        let start = range.start + (part.len() - part.trim_start().len());
        let text = part.trim().to_owned();
        Self { span: self.part(start..start + text.len()), text, exact: self.exact }
    }
}

/// Entry of a TOML table: the key with its place, and the value with its place.
pub type Entry<'a> = (Located, &'a Spanned<DeValue<'a>>);

/// Reader of one TOML file, which collects the errors it finds.
pub struct TomlReader<'a> {
    /// File that the reader reads.
    pub source: &'a Source,
    /// Errors found in the file so far.
    pub errors: Vec<Diagnostic>,
    /// Messages recorded by `error_once`. The values are the index of the message in `errors`, and
    /// the number of places reported so far.
    repeated: FxHashMap<String, (usize, usize)>,
    /// Texts that were assembled from parts of this file, or from parts of further files that it
    /// names.
    made: Vec<AssembledText>,
}

/// Map from the bytes of an assembled text to their places in the file from which its parts come.
/// The bytes of an assembled text are numbered after the last byte of the file being read. So the
/// number of a byte shows to which text it belongs.
struct AssembledText {
    /// Number of the first byte of the assembled text. Numbers continue after the last byte of the
    /// file being read and of earlier assembled texts.
    start: usize,
    /// File from which the parts come; `None` for the file being read.
    file: Option<Arc<Source>>,
    /// Place in the file of each byte of the assembled text, as (start, end) in bytes.
    places: Vec<(u32, u32)>,
}

impl<'a> TomlReader<'a> {
    /// Creates a reader of the file `source`, with no errors recorded.
    #[must_use]
    pub fn new(source: &'a Source) -> Self {
        Self { source, errors: Vec::new(), repeated: FxHashMap::default(), made: Vec::new() }
    }

    /// Parses a TOML file to a table and its reader. Reports duplicate keys, the first syntax error,
    /// and forbidden characters.
    ///
    /// # Errors
    /// [`Diagnostics`] if the file is not TOML or has a forbidden character.
    pub fn parse(source: &'a Source) -> Result<(Self, Spanned<DeTable<'a>>), Diagnostics> {
        let (table, errors) = DeTable::parse_recoverable(&source.text);
        if errors.is_empty() {
            let mut reader = Self::new(source);
            reader.refuse_forbidden_characters(table.get_ref());
            reader.finish()?;
            return Ok((reader, table));
        }
        let duplicate = |e: &toml::de::Error| e.message() == "duplicate key";
        let mut list: Vec<Diagnostic> = Vec::new();
        let mut doubled_section: Option<usize> = None;
        for error in errors.iter().filter(|e| duplicate(e)) {
            let span = error.span().unwrap_or(0..0);
            // If a section is stated twice, its keys are not reported as duplicates as well.
            if doubled_section.is_some_and(|start| !source.text[start..span.start].contains("\n[")) {
                continue;
            }
            doubled_section = source.text[..span.start].ends_with('[').then_some(span.end);
            list.push(duplicate_key_error(source, table.get_ref(), span));
        }
        // Only the first syntax error is shown, since later ones may be caused by it.
        let first = errors.iter().filter(|e| !duplicate(e)).min_by_key(|e| e.span().map_or(0, |s| s.start));
        if let Some(error) = first {
            let span = error.span().unwrap_or(0..0);
            let message = error.message().lines().next().unwrap_or("not TOML");
            let help = "the file must be valid TOML: `key = value`, with text and formulas in quotes";
            list.push(Diagnostic::new(span, message, help));
        }
        Err(Diagnostics::new(source.clone(), list))
    }

    /// Reports every key and every text of a TOML table that contains a forbidden character. Line
    /// breaks and tabs are allowed in texts: they separate words.
    fn refuse_forbidden_characters(&mut self, table: &DeTable<'_>) {
        let mut tables = vec![table];
        let mut values: Vec<&Spanned<DeValue<'_>>> = Vec::new();
        while let Some(table) = tables.pop() {
            for (key, value) in table {
                self.refuse_forbidden_character_in(key.span(), key.get_ref(), |c| !is_forbidden(c));
                values.push(value);
            }
            while let Some(value) = values.pop() {
                match value.get_ref() {
                    DeValue::String(text) => {
                        self.refuse_forbidden_character_in(value.span(), text, |c| is_blank(c) || !is_forbidden(c));
                    }
                    DeValue::Array(list) => values.extend(list.iter()),
                    DeValue::Table(table) => tables.push(table),
                    _ => {}
                }
            }
        }
    }

    /// Reports the first character of a text for which the function `fits` returns false. `span` is
    /// the place of the text in the file.
    fn refuse_forbidden_character_in(&mut self, span: Range<usize>, text: &str, fits: impl Fn(char) -> bool) {
        if let Some(c) = text.chars().find(|c| !fits(*c)) {
            let kind = if c.is_control() { "the control character" } else { "the invisible character" };
            self.error(
                span,
                format!("this text has {kind} {}", code_point_text(c)),
                "remove it: text is what one can read",
            );
        }
    }

    /// Reads the text of an optional key as one line of prose: line breaks and tabs become spaces.
    /// `None` if the key is absent. If the value is not a string, an error is recorded and `None`
    /// is returned.
    pub fn prose(&mut self, table: &'a DeTable<'a>, key: &str) -> Option<String> {
        let value = self.get(table, key)?;
        Some(one_line(&self.string(value, &format!("`{key}`"))?.text))
    }

    /// Reads a name for people, such as a title, without white space at its ends. `None`, with an
    /// error recorded, if the value is not a string, or contains a line break or another forbidden
    /// character.
    pub fn name(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<Located> {
        let text = self.string(value, what)?;
        if let Some(c) = text.text.chars().find(|c| is_forbidden(*c)) {
            let message = format!("{what} has the control character {}", code_point_text(c));
            self.error(text.span, message, "write it on one line");
            return None;
        }
        Some(Located { text: text.text.trim().to_owned(), ..text })
    }

    /// Ends the reading of the file: returns all recorded errors and clears the list.
    ///
    /// # Errors
    /// [`Diagnostics`] if any error was recorded.
    pub fn finish(&mut self) -> Result<(), Diagnostics> {
        if self.errors.is_empty() {
            return Ok(());
        }
        let errors = std::mem::take(&mut self.errors).into_iter().map(|error| self.error_in_its_file(error)).collect();
        Err(Diagnostics::new(self.source.clone(), errors))
    }

    /// Registers a text that was assembled from parts of a file, so that an error in the text
    /// points at the right part. `places` has, for each byte of the text, its (start, end) in
    /// `file`. `None` for `file` is the file being read.
    pub fn register_assembled_text(
        &mut self,
        file: Option<Arc<Source>>,
        text: String,
        places: Vec<(u32, u32)>,
    ) -> Located {
        let start = self.made.last().map_or(self.source.text.len() + 1, |made| made.start + made.places.len() + 1);
        let span = start..start + text.len();
        self.made.push(AssembledText { start, file, places });
        Located { text, span, exact: true }
    }

    /// True if `text` was registered as an assembled text. False if it is a part of the file being
    /// read.
    #[must_use]
    pub fn is_assembled_text(&self, text: &Located) -> bool {
        text.span.start > self.source.text.len()
    }

    /// Translates the places of an error in an assembled text into places in the file from which
    /// the text came. Errors at other places stay unchanged.
    fn error_in_its_file(&self, mut error: Diagnostic) -> Diagnostic {
        if error.file.is_some() {
            return error;
        }
        if let Some((span, file)) = error.span.as_ref().and_then(|span| self.place_of(span)) {
            (error.span, error.file) = (Some(span), file);
        }
        if let Some((span, _)) = error.other.as_mut()
            && span.start > self.source.text.len()
        {
            match self.place_of(span) {
                Some((place, file)) if file == error.file => *span = place,
                // The second place is left out if it is in another file than the first.
                _ => error.other = None,
            }
        } else if error.file.is_some() {
            error.other = None;
        }
        error
    }

    /// Place in a file of a byte range of an assembled text, as (byte range, file). `None` for the
    /// file is the file being read. The result is `None` if `span` is not in an assembled text.
    fn place_of(&self, span: &Range<usize>) -> Option<(Range<usize>, Option<Arc<Source>>)> {
        let at = self.made.partition_point(|made| made.start <= span.start).checked_sub(1)?;
        let made = &self.made[at];
        let last = made.places.len();
        let from = (span.start - made.start).min(last);
        let inside = &made.places[from..(span.end.max(span.start) - made.start).clamp(from, last)];
        let bounds = inside.iter().copied().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        let bounds = bounds.or_else(|| made.places.get(from).map(|place| (place.0, place.0)));
        let bounds = bounds.or_else(|| made.places.last().map(|place| (place.1, place.1))).unwrap_or_default();
        Some((bounds.0 as usize..bounds.1 as usize, made.file.clone()))
    }

    /// Records an error at the byte range `span` of the file, with advice in `help`.
    pub fn error(&mut self, span: Range<usize>, message: impl Into<String>, help: impl Into<String>) {
        self.errors.push(Diagnostic::new(span, message, help));
    }

    /// Records an error for a constant in a formula whose digits are lost in double precision by
    /// cancellation.
    pub fn report_lost_constant(&mut self, arena: &Arena, formula: &Located, constant: Expr) {
        let message = format!(
            "double precision does not know the constant `{}`",
            shortened_for_message(&print_text(arena, constant))
        );
        let help = "write the value of the constant: its computation loses all digits";
        self.error(formula.span.clone(), message, help);
    }

    /// True if double precision can compute the formula `e`; otherwise an error is recorded at
    /// `formula`. A formula is refused if it has a number beyond the range of doubles, or a
    /// constant whose digits are lost in doubles.
    pub fn is_computable(&mut self, arena: &Arena, formula: &Located, e: Expr) -> bool {
        if let Some(power) = number_beyond_doubles(arena, e) {
            let message = format!("a number of about 10^{power} is beyond double precision");
            let help = "scale the quantity: numbers reach from 1e-307 to 1e308 in size";
            self.error(formula.span.clone(), message, help);
            return false;
        }
        match constant_with_wide_interval(arena, e) {
            Some(lost) => self.report_lost_constant(arena, formula, lost),
            None => return true,
        }
        false
    }

    /// Records an error that one cause may produce at many places. The message is shown once, with
    /// its first two places and the number of further places.
    pub fn error_once(&mut self, span: Range<usize>, message: String, help: impl Into<String>) {
        let Some((at, places)) = self.repeated.get_mut(&message) else {
            self.repeated.insert(message.clone(), (self.errors.len(), 1));
            return self.error(span, message, help);
        };
        *places += 1;
        let others =
            if *places > 2 { format!("also here, and {} times more", *places - 2) } else { "also here".into() };
        let first = &mut self.errors[*at];
        let mut spans: Vec<_> = [first.span.take(), first.other.take().map(|(s, _)| s), Some(span)].into();
        spans.sort_by_key(|s| s.as_ref().map_or(usize::MAX, |s| s.start));
        first.span = spans[0].take();
        first.other = spans[1].take().map(|s| (s, others));
    }

    /// Entries of a TOML table in the order of the file. Entries with the same place are ordered by
    /// name.
    #[must_use]
    #[allow(clippy::unused_self, reason = "a question to the reader")]
    pub fn entries(&self, table: &'a DeTable<'a>) -> Vec<Entry<'a>> {
        let mut entries: Vec<Entry<'a>> = table.iter().map(|(key, value)| (located_key(key), value)).collect();
        // Entries that were created by a repetition have the same place, so their names order them.
        entries.sort_by(|(a, _), (b, _)| {
            a.span.start.cmp(&b.span.start).then_with(|| compare_with_numbers(&a.text, &b.text))
        });
        entries
    }

    /// Reports every key of `table` that is not in `allowed`. `what` is the name of the table in
    /// messages.
    pub fn report_unknown_keys(&mut self, table: &'a DeTable<'a>, what: &str, allowed: &[&str]) {
        for (key, _) in self.entries(table) {
            if !allowed.contains(&key.text.as_str()) {
                let help = nearest_name_advice(&key.text, allowed.iter().copied());
                self.error(key.span, format!("unknown key `{}` in {what}", key.text), help);
            }
        }
    }

    /// Value of an optional key of a table; `None` if the key is absent.
    #[must_use]
    #[allow(clippy::unused_self, reason = "a question to the reader")]
    pub fn get(&self, table: &'a DeTable<'a>, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        table.iter().find(|(k, _)| k.get_ref() == key).map(|(_, value)| value)
    }

    /// Checks the format version that a file states under the key `schema`. An error is recorded if
    /// the version is newer than `SCHEMA` or not a number. An absent key is accepted.
    pub fn schema(&mut self, table: &'a DeTable<'a>) {
        let Some(value) = self.get(table, "schema") else { return };
        let version = match value.get_ref() {
            DeValue::Integer(n) if n.radix() == 10 => n.as_str().parse::<u32>().ok(),
            _ => None,
        };
        match version {
            Some(1..=SCHEMA) => {}
            Some(newer) if newer > SCHEMA => {
                let message =
                    format!("the file is of version {newer} of the format, and this program knows 1 to {SCHEMA}");
                self.error(value.span(), message, "a newer tripos reads it");
            }
            _ => self.error(
                value.span(),
                "`schema` must be a version of the format",
                format!("write schema = {SCHEMA}, or leave it out"),
            ),
        }
    }

    /// Value of a required key of a table. If the key is absent, an error is recorded at the place
    /// `owner`, with `what` as the name of the table, and `None` is returned.
    pub fn required(
        &mut self,
        table: &'a DeTable<'a>,
        key: &str,
        what: &str,
        owner: &Range<usize>,
    ) -> Option<&'a Spanned<DeValue<'a>>> {
        let value = self.get(table, key);
        if value.is_none() {
            self.error(owner.clone(), format!("{what} has no `{key}`"), format!("add `{key} = …`"));
        }
        value
    }

    /// Reads a value as a table. For another kind of value, records an error with `example` as
    /// advice and returns `None`.
    pub fn table(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str, example: &str) -> Option<&'a DeTable<'a>> {
        match value.get_ref() {
            DeValue::Table(table) => Some(table),
            _ => {
                self.error(value.span(), format!("{what} must be a table"), format!("write it as {example}"));
                None
            }
        }
    }

    /// Reads a value as a string. For another kind of value, reports an error and returns `None`.
    pub fn string(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<Located> {
        match value.get_ref() {
            DeValue::String(text) => Some(self.located(value.span(), text)),
            _ => {
                self.error(value.span(), format!("{what} must be a string"), "put it in quotes");
                None
            }
        }
    }

    /// Reads a value as the text of a formula: a string or a decimal number. For another kind of value,
    /// reports an error and returns `None`.
    pub fn formula(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<Located> {
        match value.get_ref() {
            DeValue::String(text) => Some(self.located(value.span(), text)),
            DeValue::Integer(n) if n.radix() == 10 => Some(number(n.as_str(), value.span())),
            DeValue::Float(x) if x.as_str().bytes().any(|b| b.is_ascii_digit()) => {
                Some(number(x.as_str(), value.span()))
            }
            DeValue::Float(x) => {
                self.error(value.span(), format!("{what} is `{}`, not a number", x.as_str()), "give a finite number");
                None
            }
            _ => {
                let help = "write a number, or mathematics in quotes such as \"M*R^2/4\"";
                self.error(value.span(), format!("{what} must be a number or a formula in quotes"), help);
                None
            }
        }
    }

    /// Reads a value as an array of exactly three formulas, such as the components of a vector. For
    /// another value, reports an error and returns `None`.
    pub fn triple(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<[Located; 3]> {
        let help = "write three components, such as [\"0\", \"R\", \"0\"]";
        let DeValue::Array(array) = value.get_ref() else {
            self.error(value.span(), format!("{what} must be an array"), help);
            return None;
        };
        if array.len() != 3 {
            self.error(value.span(), format!("{what} has {} components, not 3", array.len()), help);
            return None;
        }
        let parts: Vec<_> = array.iter().map(|v| self.formula(v, what)).collect();
        let parts: Option<Vec<Located>> = parts.into_iter().collect();
        parts?.try_into().ok()
    }

    /// Reads a value as a boolean. For another kind of value, reports an error and returns `None`.
    pub fn boolean(&mut self, value: &'a Spanned<DeValue<'a>>, what: &str) -> Option<bool> {
        match value.get_ref() {
            DeValue::Boolean(b) => Some(*b),
            _ => {
                self.error(
                    value.span(),
                    format!("{what} must be true or false"),
                    "write true or false, without quotes",
                );
                None
            }
        }
    }

    /// Text and place of a TOML string, without its quotes. TOML has one or three quotes, and drops
    /// a line break after three opening quotes. If the string has escapes, the place is that of the
    /// whole value.
    fn located(&self, span: Range<usize>, text: &str) -> Located {
        for (before, after) in [(1, 1), (3, 3), (4, 3), (5, 3)] {
            let inner = span.start + before..span.end.saturating_sub(after);
            if self.source.text.get(inner.clone()) == Some(text) {
                return Located { text: text.to_owned(), span: inner, exact: true };
            }
        }
        Located { text: text.to_owned(), span, exact: false }
    }
}

/// Creates the error for a TOML key that is stated twice. It also shows the first place of the key,
/// if this place is found.
fn duplicate_key_error(source: &Source, table: &DeTable<'_>, span: Range<usize>) -> Diagnostic {
    let key = source.text[span.clone()].trim_matches(['"', '\'']);
    let message = format!("`{}` is stated twice", shortened_for_message(key));
    let diagnostic = Diagnostic::new(span.clone(), message, "remove or rename one of the two");
    // The section that contains the key is that of the last header above it, or else the top level
    // of the file.
    let above = &source.text[..span.start];
    let line = &above[above.rfind('\n').map_or(0, |n| n + 1)..];
    let header = if line.starts_with('[') { line } else { above.rfind("\n[").map_or("", |n| &above[n + 1..]) };
    let header = header.trim_start_matches('[');
    let path = if line.starts_with('[') { header } else { header.split(']').next().unwrap_or_default() };
    let mut section = Some(table);
    for part in path.split('.').map(str::trim).filter(|part| !part.is_empty()) {
        section = section.and_then(|t| t.get(part)).and_then(|v| v.get_ref().as_table());
    }
    let first = if line.starts_with('[') {
        above.find(&format!("\n[{key}]")).map(|at| at + 2..at + 2 + key.len())
    } else {
        section.and_then(|t| t.iter().find(|(k, _)| k.get_ref() == key)).map(|(k, _)| k.span())
    };
    match first.filter(|first| first.end <= span.start) {
        Some(first) => diagnostic.with_other(first, "first stated here"),
        None => diagnostic,
    }
}

/// Text of a TOML key with its place in the file.
fn located_key(key: &Spanned<std::borrow::Cow<'_, str>>) -> Located {
    Located { text: key.get_ref().to_string(), span: key.span(), exact: false }
}

/// Text of a TOML number without underscores, with its place in the file.
fn number(text: &str, span: Range<usize>) -> Located {
    let plain = text.replace('_', "");
    let exact = plain.len() == span.len();
    Located { text: plain, span, exact }
}
