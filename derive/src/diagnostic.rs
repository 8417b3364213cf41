//! Diagnostics: errors of an input file, each with its place, a message and advice.

use crate::plain_text::{message_text, one_line, path_as_plain_text, with_visible_characters};
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use std::fmt;
#[cfg(feature = "files")]
use std::io::Read;
use std::ops::Range;
#[cfg(feature = "files")]
use std::path::Path;
use std::path::PathBuf;
use std::sync::Arc;

/// A text file with its path. Errors name the file by this path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Path of the file, as the user gave it.
    pub path: PathBuf,
    /// Text of the file, without a byte order mark.
    pub text: String,
}

impl Source {
    /// Largest size of a file that is read, in bytes (4 MiB). Files written by people are far smaller.
    pub const MAX_BYTES: u64 = 4 << 20;

    /// Reads a regular file of UTF-8 text.
    ///
    /// # Errors
    /// [`Diagnostics`] that name the file and the reason. The file is absent, a directory, a device
    /// or pipe, too large, not UTF-8 (with the line of the first wrong byte), or contains a NUL
    /// byte.
    #[cfg(feature = "files")]
    pub fn read(path: &Path) -> Result<Self, Diagnostics> {
        let fail = |message: String, help: &str| Err(Diagnostics::without_place(path, &message, help));
        let metadata = match std::fs::metadata(path) {
            Ok(metadata) => metadata,
            Err(error) => return fail(format!("cannot read the file: {error}"), "check the path"),
        };
        if !metadata.is_file() {
            let what = if metadata.is_dir() { "a folder" } else { "not a regular file" };
            return fail(format!("this is {what}"), "give the path of a text file, such as models/disk/model.toml");
        }
        let mut bytes = Vec::new();
        let read = std::fs::File::open(path).and_then(|file| file.take(Self::MAX_BYTES + 1).read_to_end(&mut bytes));
        if let Err(error) = read {
            return fail(format!("cannot read the file: {error}"), "check its permissions");
        }
        if bytes.len() as u64 > Self::MAX_BYTES {
            return fail(
                format!("the file is larger than {} bytes", Self::MAX_BYTES),
                "give a text file of this format",
            );
        }
        // For an error at a byte of a file that is not plain text, the source contains only the
        // text before that byte.
        let fail_at = |at: usize, length: usize, message: &str, help: &str| {
            let mut text = String::from_utf8_lossy(&bytes[..at]).into_owned();
            let start = text.len();
            text.push_str(&"\u{fffd}".repeat(length));
            let span = start..text.len();
            let source = Self { path: path.to_owned(), text };
            Err(Diagnostics::new(source, vec![Diagnostic::new(span, message, help)]))
        };
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return fail_at(0, 1, "the file is UTF-16, not UTF-8", "save the file as UTF-8");
        }
        if let Some(at) = bytes.iter().position(|b| *b == 0) {
            return fail_at(at, 1, "the file has a NUL byte here", "the file must be plain text");
        }
        match std::str::from_utf8(&bytes) {
            // A byte order mark is not a part of the text; it would shift the columns of errors.
            Ok(text) => Ok(Self { path: path.to_owned(), text: text.trim_start_matches('\u{feff}').to_owned() }),
            Err(error) => {
                fail_at(error.valid_up_to(), 1, "the file is not UTF-8 from here on", "save the file as UTF-8")
            }
        }
    }

    /// Creates a source from text that was not read from a file. Errors name the text by `path`.
    #[must_use]
    pub fn from_text(path: &str, text: &str) -> Self {
        Self { path: PathBuf::from(path), text: text.trim_start_matches('\u{feff}').to_owned() }
    }
}

/// An error of an input file: message, place and advice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Message of the error, in one line and without forbidden characters.
    pub message: String,
    /// Place of the error in the file, as a byte range; `None` if the error concerns the file as a
    /// whole.
    pub span: Option<Range<usize>>,
    /// Second place in the file that belongs to the error, as a byte range with a label; `None` if
    /// there is none.
    pub other: Option<(Range<usize>, String)>,
    /// Advice for correcting the error; `None` if there is none.
    pub help: Option<String>,
    /// File that contains the error, if it is a further file that the file being read names. `None`
    /// for the file being read.
    pub file: Option<Arc<Source>>,
}

impl Diagnostic {
    /// Creates an error at a byte range of the file.
    #[must_use]
    pub fn new(span: Range<usize>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { span: Some(span), ..Self::of_file(message, help) }
    }

    /// Creates an error that concerns the file as a whole, without a place.
    #[must_use]
    pub fn of_file(message: impl Into<String>, help: impl Into<String>) -> Self {
        let (message, help) = (message_text(&message.into()).replace('\n', "\\n"), message_text(&help.into()));
        Self { message, span: None, other: None, help: Some(help), file: None }
    }

    /// Adds a second place in the file, with its label.
    #[must_use]
    pub fn with_other(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.other = Some((span, message_text(&label.into())));
        self
    }
}

/// All errors of one input file, with its text. `Display` writes each error with its place, as
/// compilers do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// File in which the errors were found.
    pub source: Source,
    /// Errors of the file, in the order of their places.
    pub list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Collects the errors of one file, sorts them by file and place, and drops repeated errors.
    #[must_use]
    pub fn new(source: Source, mut list: Vec<Diagnostic>) -> Self {
        list.sort_by_key(|d| (d.file.as_ref().map(|file| file.path.clone()), d.span.as_ref().map_or(0, |s| s.start)));
        list.dedup();
        Self { source, list }
    }

    /// Line and column of an error in its file, in characters from 1; `None` if the error concerns the
    /// file as a whole.
    #[must_use]
    pub fn place(&self, diagnostic: &Diagnostic) -> Option<(usize, usize)> {
        let excerpt = Excerpt::new(&self.file(diagnostic).text, diagnostic.span.as_ref()?);
        Some((excerpt.line, excerpt.column))
    }

    /// File that contains an error: the file that the error names, otherwise the file that was
    /// read.
    #[must_use]
    pub fn file<'a>(&'a self, diagnostic: &'a Diagnostic) -> &'a Source {
        diagnostic.file.as_deref().unwrap_or(&self.source)
    }

    /// Creates the single error of a file that could not be read.
    #[cfg(feature = "files")]
    fn without_place(path: &Path, message: &str, help: &str) -> Self {
        let source = Source { path: path.to_owned(), text: String::new() };
        Self::new(source, vec![Diagnostic::of_file(message, help)])
    }
}

impl std::error::Error for Diagnostics {}

/// Largest number of errors of one file that are shown.
const MAX_SHOWN: usize = 50;
/// Number of bytes of a very long line that are shown, beginning at the error. A line of at most
/// twice this length is shown whole.
const MARGIN: usize = 160;

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, diagnostic) in self.list.iter().take(MAX_SHOWN).enumerate() {
            if at > 0 {
                writeln!(f, "\n")?;
            }
            let file = self.file(diagnostic);
            f.write_str(&with_visible_characters(&render_diagnostic(
                &path_as_plain_text(&file.path),
                &file.text,
                diagnostic,
            )))?;
        }
        if self.list.len() > MAX_SHOWN {
            write!(f, "\n\nand {} more errors", self.list.len() - MAX_SHOWN)?;
        }
        Ok(())
    }
}

/// Writes one error in the way of compilers: message, place with the lines of the file, and advice.
fn render_diagnostic(path: &str, text: &str, diagnostic: &Diagnostic) -> String {
    let title = Level::ERROR.primary_title(diagnostic.message.as_str());
    let excerpt = diagnostic.span.as_ref().map(|span| Excerpt::new(text, span));
    let mut group = match &excerpt {
        None => title.element(Origin::path(path)),
        Some(excerpt) if excerpt.whole => {
            let primary = AnnotationKind::Primary.span(excerpt.span.clone());
            let snippet = Snippet::source(&*excerpt.text).path(path).line_start(excerpt.line).annotation(primary);
            let other = diagnostic.other.as_ref().filter(|(span, _)| excerpt.holds(span));
            match (&diagnostic.other, other) {
                (_, Some((span, label))) => {
                    let span = span.start - excerpt.start..span.end - excerpt.start;
                    title.element(snippet.annotation(AnnotationKind::Context.span(span).label(label.as_str())))
                }
                (Some((span, label)), None) => {
                    let second = Excerpt::new(text, span);
                    let context = AnnotationKind::Context.span(second.span.clone()).label(label.clone());
                    let second_snippet = Snippet::source(second.text.into_owned()).path(path).line_start(second.line);
                    title.element(snippet).element(second_snippet.annotation(context))
                }
                (None, None) => title.element(snippet),
            }
        }
        // The place of an error in a very long line is stated in words, since columns of a part of
        // the line would mislead.
        Some(excerpt) => {
            let origin = Origin::path(path).line(excerpt.line).char_column(excerpt.column);
            let note = match &*excerpt.text {
                "" => "at the end of a very long line".to_owned(),
                part => format!("in a very long line, at `{}`", shortened_for_message(part)),
            };
            title.element(origin).element(Level::NOTE.message(note))
        }
    };
    if let Some(help) = diagnostic.help.as_ref().filter(|help| !help.is_empty()) {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    Renderer::plain().render(&[group])
}

/// Part of a file around an error, as shown in a message.
struct Excerpt<'a> {
    /// Text of the excerpt.
    text: std::borrow::Cow<'a, str>,
    /// Byte in the file at which the excerpt starts.
    start: usize,
    /// Number of the excerpt's first line in the file, from 1.
    line: usize,
    /// Column of the error in the file, in characters, from 1.
    column: usize,
    /// Byte range of the error, counted from the start of the excerpt.
    span: Range<usize>,
    /// True if the excerpt consists of whole lines; false if it is a part of a very long line.
    whole: bool,
}

impl<'a> Excerpt<'a> {
    /// Cuts the excerpt for an error at the byte range `span` out of the file `text`.
    fn new(text: &'a str, span: &Range<usize>) -> Self {
        let from = floor_char_boundary(text, span.start);
        let to = floor_char_boundary(text, span.end).max(from);
        let first = text[..from].rfind('\n').map_or(0, |n| n + 1);
        // If an error extends over several lines, only the first line is shown.
        let end = text[from..].find('\n').map_or(text.len(), |n| from + n);
        let end = if text[..end].ends_with('\r') { end - 1 } else { end }.max(from);
        let to = to.min(end).max(from);
        let line = text[..first].bytes().filter(|b| *b == b'\n').count() + 1;
        let column = text[first..from].chars().count() + 1;
        let whole = end - first <= 2 * MARGIN;
        let start = if whole { first } else { from };
        let end = if whole { end } else { floor_char_boundary(text, from + MARGIN).min(end) };
        Self { text: text[start..end].into(), start, line, column, span: from - start..to.min(end) - start, whole }
    }

    /// True if the byte range `span` of the file lies within the excerpt.
    fn holds(&self, span: &Range<usize>) -> bool {
        span.start >= self.start && span.end <= self.start + self.text.len()
    }
}

/// Largest byte index that is at most `at` and at which a character of `text` starts.
fn floor_char_boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Error for a name that is not declared, or that is declared as something of another kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName {
    /// Message of the error, in one line.
    pub message: String,
    /// Advice: the nearest known name, or a list of the known names.
    pub help: String,
}

impl UnknownName {
    /// Creates an error for `name`, with the nearest of the names `known` as advice.
    pub(crate) fn new<'a>(message: String, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        Self { message, help: nearest_name_advice(name, known) }
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.message, self.help)
    }
}

impl std::error::Error for UnknownName {}

/// Advice for an unknown name: "did you mean …?" with the nearest known name. If no known name is
/// near, the advice lists at most 40 known names.
#[must_use]
pub fn nearest_name_advice<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    let close = known
        .iter()
        .filter(|k| k.len().abs_diff(name.len()) <= k.len().max(name.len()).div_ceil(3))
        .map(|k| (strsim::damerau_levenshtein(&name.to_lowercase(), &k.to_lowercase()), *k))
        .filter(|(distance, k)| *distance <= (k.len().max(name.len()) + 1) / 3)
        .min();
    match close {
        Some((_, k)) => format!("did you mean `{k}`?"),
        None if known.is_empty() => "nothing of this kind is declared".to_owned(),
        None => {
            let list: Vec<String> = known.iter().take(40).map(|k| format!("`{k}`")).collect();
            format!("known here: {}", list.join(", "))
        }
    }
}

/// Shortens a text for a message: one line of at most 60 characters, with forbidden characters written out.
#[must_use]
pub fn shortened_for_message(text: &str) -> String {
    const LONGEST: usize = 60;
    let line = one_line(text);
    let text = with_visible_characters(&line);
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}
