//! Reading of the files to which a publication refers, and of their macros. Each file is read once.

use super::entries::EntryTable;
use super::names::author_files::notation_of_author_file;
use super::printed::{LatexFile, TracedError, TracedText, latex_without_comments};
use super::publication_reader::PublicationReader;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostic, Source, shortened_for_message};
use crate::toml_reader::Located;
use std::sync::Arc;
use toml::de::DeTable;

/// Largest number of characters in a file name.
const MAX_NAME: usize = 100;

impl<'a> PublicationReader<'a, '_> {
    /// Reads the file and the macros that are given at the top of the publication file and apply to all entries.
    pub fn read_named_files(&mut self, table: &'a DeTable<'a>) {
        if let Some(value) = self.reader.get(table, "file")
            && let Some(name) = self.reader.string(value, "`file`")
        {
            if notation_of_author_file(&name.text) == Some(Notation::Latex) {
                if let Some(paper) = self.read_paper(&name) {
                    self.files.macros = paper.macros.at_the_end();
                }
            } else {
                self.read_source_file(&name);
            }
            self.files.usual = Some(name);
        }
        if let Some(value) = self.reader.get(table, "macros")
            && let Some(text) = self.reader.string(value, "`macros`")
        {
            let mut macros = self.files.macros.at_the_end();
            let rest = macros.take_macro_definitions(&latex_without_comments(&text.text));
            if !rest.text.trim().is_empty() {
                let start = text.part(rest.place_of_part(0..rest.text.len()));
                let help = "write \\newcommand{\\name}[1]{…} or \\def\\name{…}";
                self.reader.error(start, "`macros` holds more than definitions", help);
            }
            self.files.macros = macros;
        }
    }

    /// Name of the file of an entry: its own file, or else the file at the top of the publication file. `None` if there
    /// is neither.
    pub(super) fn file_of(&mut self, item: &EntryTable<'a>) -> Option<Located> {
        match self.reader.get(item.table, "file") {
            Some(value) => self.reader.string(value, "`file`"),
            None => self.files.usual.clone(),
        }
    }

    /// Reads a file in the folder of the publication file, each file once. Reports an unsuitable name or an unreadable
    /// file, and returns `None`.
    pub(super) fn read_source_file(&mut self, name: &Located) -> Option<Arc<Source>> {
        if let Some(found) = self.files.sources.get(&name.text) {
            return found.clone();
        }
        let text = name.text.as_str();
        let is_plain = text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | ' '))
            && !text.starts_with(['.', ' '])
            && text.len() <= MAX_NAME;
        let read = if !is_plain || notation_of_author_file(text).is_none() {
            let help = "name a file in the folder of the publication, such as paper.tex, model.m, model.py or model.c";
            self.reader.error(
                name.span.clone(),
                format!("`{}` is no name of such a file", shortened_for_message(text)),
                help,
            );
            None
        } else {
            match (self.files.read)(text) {
                Ok(source) => Some(Arc::new(source)),
                Err(errors) => {
                    let why = errors.list.first().map(|e| e.message.clone()).unwrap_or_default();
                    let help = errors.list.into_iter().next().and_then(|e| e.help).unwrap_or_default();
                    self.reader.error(name.span.clone(), format!("`{text}`: {why}"), help);
                    None
                }
            }
        };
        self.files.sources.insert(name.text.clone(), read.clone());
        read
    }

    /// Reads a LaTeX file and its macros, each file once; `None` if an error is reported.
    pub(super) fn read_paper(&mut self, name: &Located) -> Option<Arc<LatexFile>> {
        if let Some(found) = self.files.papers.get(&name.text) {
            return found.clone();
        }
        let source = self.read_source_file(name)?;
        let paper = match LatexFile::read(&source.text) {
            Ok(paper) => Some(Arc::new(paper)),
            Err(problem) => {
                self.report_problem_in_named_file(Some(source), problem);
                None
            }
        };
        self.files.papers.insert(name.text.clone(), paper.clone());
        paper
    }

    /// Reports an error at its place in a file; `None` means the publication file itself.
    pub(super) fn report_problem_in_named_file(&mut self, file: Option<Arc<Source>>, problem: TracedError) {
        self.reader.errors.push(Diagnostic { file, ..Diagnostic::new(problem.place, problem.message, problem.help) });
    }

    /// Registers an assembled formula with the reader, so that errors refer to places in its file.
    pub(super) fn register_assembled_formula(&mut self, source: &Arc<Source>, formula: TracedText) -> Located {
        self.reader.register_assembled_text(Some(Arc::clone(source)), formula.text, formula.places)
    }

    /// Replaces the macros in a formula of the publication file. Reports macros that cannot be replaced, and returns
    /// `None`.
    pub fn without_macros(&mut self, formula: &Located) -> Option<Located> {
        if self.files.macros.is_empty() || !formula.text.contains('\\') {
            return Some(formula.clone());
        }
        let traced = if formula.exact {
            TracedText::text_at_place(&formula.text, formula.span.start)
        } else {
            TracedText::from_place(&formula.text, &formula.span)
        };
        match self.files.macros.expand_macros(&traced, &|_| true) {
            Ok(expanded) => Some(self.reader.register_assembled_text(None, expanded.text, expanded.places)),
            Err(problem) => {
                self.report_problem_in_named_file(None, problem);
                None
            }
        }
    }
}
