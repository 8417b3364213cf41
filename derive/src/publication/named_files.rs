//! Reading of files to which a publication refers: equations of a LaTeX file by labels, and
//! variables of a program.

use super::author_files::notation_of_author_file;
use super::entries::{EntryTable, entry_formula_part};
use super::equalities::{equations, sides};
use super::printed::{
    LabelChoice, LatexFile, Statement, TracedError, TracedText, is_program_number, latex_without_comments,
    statement_copies_value, statements,
};
use super::printed_matrix::{MatrixCells, printed_matrix_cells};
use super::program_variables::{ProgramValue, ProgramVariables, UnreadAssignment};
use super::publication_reader::PublicationReader;
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostic, Source, shortened_for_message};
use crate::toml_reader::Located;
use std::ops::Range;
use std::sync::Arc;
use toml::de::DeTable;

/// Largest number of characters in a file name.
const MAX_NAME: usize = 100;
impl<'a> PublicationReader<'a, '_> {
    /// Reads the file and the macros that the publication file states at its top, for all entries.
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

    /// Name of the file of an entry: the entry's own, else the file at the top of the publication
    /// file; `None` if neither.
    fn file_of(&mut self, item: &EntryTable<'a>) -> Option<Located> {
        match self.reader.get(item.table, "file") {
            Some(value) => self.reader.string(value, "`file`"),
            None => self.files.usual.clone(),
        }
    }

    /// Reads a file in the folder of the publication file, once.
    /// Reports an unsuitable name or an unreadable file, and returns `None`.
    fn read_source_file(&mut self, name: &Located) -> Option<Arc<Source>> {
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

    /// Reads a LaTeX file and its macros, once; `None` if an error is reported.
    fn read_paper(&mut self, name: &Located) -> Option<Arc<LatexFile>> {
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
    fn report_problem_in_named_file(&mut self, file: Option<Arc<Source>>, problem: TracedError) {
        self.reader.errors.push(Diagnostic { file, ..Diagnostic::new(problem.place, problem.message, problem.help) });
    }

    /// Equations that have a label in the LaTeX file of an entry, as formulas without macros, except
    /// definitions that `[abbreviations]` takes from the file. Reports an unknown label or a file
    /// that is not LaTeX, and returns `None`.
    pub fn equations_by_label(
        &mut self,
        item: &EntryTable<'a>,
        label: &Located,
        choice: LabelChoice,
    ) -> Option<Vec<Located>> {
        let mut list = self.all_labelled_equations(item, label, choice)?;
        let is_defined = |equation: &Located| {
            let left = self.name_of_labelled_equation(equation);
            left.is_some_and(|name| self.files.defined.contains(&name))
        };
        if !list.iter().all(is_defined) {
            list.retain(|equation| !is_defined(equation));
        }
        Some(list)
    }

    /// Formula of an abbreviation that the file at the top defines in an equation `name = formula`. The table of the
    /// abbreviation, at `span` of the publication file, names the label of the equation. `None` if an error is
    /// reported.
    pub fn labelled_definition(
        &mut self,
        name: &Located,
        table: &'a DeTable<'a>,
        span: Range<usize>,
    ) -> Option<Located> {
        let item = &EntryTable { table, what: "an abbreviation", span, notation: Notation::Latex };
        self.reader.report_unknown_keys(item.table, item.what, &["label"]);
        let label = self.reader.required(item.table, "label", item.what, &item.span)?;
        let label = self.reader.string(label, "`label`")?;
        let list = self.all_labelled_equations(item, &label, LabelChoice::Display)?;
        let named: Vec<&Located> = list
            .iter()
            .filter(|equation| self.name_of_labelled_equation(equation).is_some_and(|left| left == name.text))
            .collect();
        let [equation] = named[..] else {
            let what = if named.is_empty() { "no equation" } else { "more than one equation" };
            let message = format!(
                "{what} of `{}` has `{}` alone on its left side",
                shortened_for_message(&label.text),
                name.text
            );
            let help = "say in [symbols] which symbol stands for the abbreviation, or copy its formula";
            self.reader.error(label.span, message, help);
            return None;
        };
        let sides = sides(&equation.text, 0..equation.text.len(), item.notation);
        let [_, right] = &sides[..] else {
            let message = format!("`{}` is equal to more than one formula", name.text);
            self.reader.error(equation.span.clone(), message, "copy the formula that is meant");
            return None;
        };
        self.files.defined.push(name.text.clone());
        Some(entry_formula_part(equation, right.clone()))
    }

    /// Name that an equation has alone on its left side, or with arguments, as in `h(q) = …`; `None` if a formula or an
    /// unknown symbol stands there.
    fn name_of_labelled_equation(&self, equation: &Located) -> Option<String> {
        let left = sides(&equation.text, 0..equation.text.len(), Notation::Latex).swap_remove(0);
        let left = equation.text[left].trim();
        let name = left.split_once('(').map_or(left, |(name, _)| name);
        self.words.name_of(name, Notation::Latex)
    }

    /// Equations of a label, also those side by side in one line.
    fn all_labelled_equations(
        &mut self,
        item: &EntryTable<'a>,
        label: &Located,
        choice: LabelChoice,
    ) -> Option<Vec<Located>> {
        let Some(name) = self.file_of(item) else {
            self.reader.error(label.span.clone(), "a label of no file", "name the file: file = \"paper.tex\"");
            return None;
        };
        if notation_of_author_file(&name.text) != Some(Notation::Latex) {
            let help = "labels are of LaTeX files; name the variable of a program under `printed`";
            self.reader.error(
                label.span.clone(),
                format!("`{}` is no LaTeX file", shortened_for_message(&name.text)),
                help,
            );
            return None;
        }
        let (source, paper) = (self.read_source_file(&name)?, self.read_paper(&name)?);
        match paper.equations(label.text.trim(), choice) {
            Err(help) => {
                let message =
                    format!("no equation of `{}` has the label `{}`", name.text, shortened_for_message(&label.text));
                self.reader.error(label.span.clone(), message, help);
                None
            }
            Ok(Err(problem)) => {
                self.report_problem_in_named_file(Some(source), problem);
                None
            }
            Ok(Ok(list)) => {
                let list = list.into_iter().map(|formula| self.register_assembled_formula(&source, formula));
                let apart = |line: Located| {
                    let parts = equations(&line.text, Notation::Latex).into_iter();
                    parts.map(|range| entry_formula_part(&line, range)).collect::<Vec<_>>()
                };
                Some(list.flat_map(apart).collect())
            }
        }
    }

    /// Registers an assembled formula with the reader, so that errors point into its file.
    fn register_assembled_formula(&mut self, source: &Arc<Source>, formula: TracedText) -> Located {
        self.reader.register_assembled_text(Some(Arc::clone(source)), formula.text, formula.places)
    }

    /// Formula of the publication file in which macros are replaced.
    /// Reports macros that cannot be replaced, and returns `None`.
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

    /// Variables that the program of an entry assigns; `None` if the entry names no program, or if
    /// an error is reported.
    pub fn read_program_assignments(&mut self, item: &EntryTable<'a>) -> Option<Arc<ProgramVariables>> {
        let own = self.reader.get(item.table, "file");
        let part = self.reader.get(item.table, "part");
        if own.is_none() && part.is_none() {
            return None;
        }
        let part = match part {
            Some(value) => Some(self.reader.string(value, "`part`")?),
            None => None,
        };
        let Some(name) = self.file_of(item) else {
            let span = part.map_or_else(|| item.span.clone(), |part| part.span);
            self.reader.error(span, "a part of no file", "name the file: file = \"model.py\"");
            return None;
        };
        let notation = notation_of_author_file(&name.text);
        if notation == Some(Notation::Latex) {
            if let Some(part) = part {
                self.reader.error(part.span, "`part` is of a program", "a LaTeX file has labels: label = \"eq:1\"");
            }
            return None;
        }
        let source = self.read_source_file(&name)?;
        let notation = notation?;
        let key = (name.text.clone(), part.as_ref().map_or(String::new(), |p| p.text.clone()), notation.name());
        if let Some(found) = self.files.programs.get(&key) {
            return found.clone();
        }
        let locals = match statements(&source.text, notation, part.as_ref().map(|p| p.text.as_str())) {
            Some(list) => {
                for statement in list {
                    self.read_assignment(&source, notation, statement);
                }
                Some(std::mem::take(&mut self.words.locals))
            }
            None => {
                let (span, what) = part.map_or_else(|| (name.span.clone(), String::new()), |p| (p.span, p.text));
                let message =
                    format!("`{}` has no part `{}` that can be read", name.text, shortened_for_message(&what));
                let help = "name a function, lines as in 12-40, or NAME of the comments `begin NAME` and `end NAME`";
                self.reader.error(span, message, help);
                None
            }
        };
        self.files.programs.insert(key, locals.clone());
        locals
    }

    /// Adds an assignment of a program to the variables read so far.
    fn read_assignment(&mut self, source: &Arc<Source>, notation: Notation, statement: Statement) {
        let Statement { targets, operator, right, is_nested, place } = statement;
        let line = self.reader.register_assembled_text(
            Some(Arc::clone(source)),
            " ".to_owned(),
            TracedText::from_place(" ", &place).places,
        );
        let unread = |name: &str, why: &str| {
            let help = "name the part of the program that decides".to_owned();
            let place = line.span.clone();
            ProgramValue::Unread(
                UnreadAssignment { place, message: why.to_owned(), help, names_assignment: false }
                    .naming_variable(name),
            )
        };
        if is_nested {
            for name in &targets {
                self.assign_program_value(name, unread(name, "a condition or a loop decides about it"));
            }
            return;
        }
        if targets.len() > 1 {
            let is_whole = right.text.trim().chars().all(|c| c.is_alphanumeric() || c == '_');
            if let Some(locals) = Arc::get_mut(&mut self.words.locals).filter(|_| is_whole) {
                locals.record_unpacking(&targets);
            }
            for name in &targets {
                self.assign_declared_meaning(name, &right.text, || unread(name, "it is assigned together with others"));
            }
            return;
        }
        let name = targets[0].clone();
        if is_program_number(&right.text) && operator.is_none() && self.words.meaning(&name).is_some_and(|(_, is)| is) {
            // A program's number for a parameter of the model is a value, and changes no formula.
            // The key `name = ` marks that the number is assigned; it cannot be the name of a
            // variable.
            if self.words.locals.has_variable(&name) || self.words.locals.has_variable(&format!("{name} = ")) {
                self.assign_program_value(&name, unread(&name, "it gets two values"));
            } else {
                self.assign_program_value(&format!("{name} = "), ProgramValue::Value(Expr::ZERO));
            }
            return;
        }
        let formula = self.register_assembled_formula(source, right);
        let value = self.words.read_program_formula(&mut self.model.arena, &formula, notation);
        match (value, operator) {
            (ProgramValue::Value(value), None) => {
                self.words.record_program_variable(&self.model.arena, &name, &formula, notation, value);
                self.assign_program_value(&name, ProgramValue::Value(value));
            }
            (ProgramValue::Value(value), Some(operator)) => {
                self.apply_compound_assignment(&name, operator, value, &unread);
            }
            (ProgramValue::Unread(unread), _) => {
                let is_whole = operator.is_none() && self.assign_vector_entries(&name, &formula, notation);
                if is_whole {
                    return;
                }
                let wrong = || ProgramValue::Unread(unread.naming_variable(&name));
                if operator.is_none() {
                    self.assign_declared_meaning(&name, &formula.text, wrong);
                } else {
                    self.assign_program_value(&name, wrong());
                }
            }
        }
    }

    /// Assigns a value to a variable, and an unread value also to each entry of a range of indices.
    fn assign_program_value(&mut self, name: &str, value: ProgramValue) {
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            // An assignment to several entries at once is not read, and this reason holds for each
            // entry.
            for entry in entries_of_assigned_range(name)
                .filter(|_| matches!(value, ProgramValue::Unread(_)))
                .into_iter()
                .flatten()
            {
                locals.assign_variable(&entry, value.clone());
            }
            locals.assign_variable(name, value);
        }
    }

    /// Restores the meaning from the publication file or the model, if the program only copies a
    /// variable from elsewhere.
    /// Else assigns the unread value `wrong`. An acceleration is always computed, never copied.
    fn assign_declared_meaning(&mut self, name: &str, right: &str, wrong: impl FnOnce() -> ProgramValue) {
        let model = &self.model;
        let is_acceleration =
            |e: Expr| model.coordinates.iter().any(|c| c.second_rate == e) || model.speeds.iter().any(|s| s.rate == e);
        let is_declared = self.words.meaning(name).is_some_and(|(e, _)| !is_acceleration(e));
        if is_declared && statement_copies_value(right) {
            if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
                locals.forget(name);
            }
        } else {
            self.assign_program_value(name, wrong());
        }
    }

    /// Applies an assignment such as `x += value`. Division, and a change of an unknown value, give
    /// an unread value.
    fn apply_compound_assignment(
        &mut self,
        name: &str,
        operator: char,
        value: Expr,
        unread: &dyn Fn(&str, &str) -> ProgramValue,
    ) {
        let locals = &self.words.locals;
        let before = match locals.variable_number(name).and_then(|number| locals.value(number)) {
            Some(ProgramValue::Value(e)) => Some(*e),
            Some(ProgramValue::Unread(..)) => return,
            None => self.words.meaning(name).map(|(e, _)| e),
        };
        let arena = &mut self.model.arena;
        let changed = before.and_then(|before| match operator {
            '+' => Some(arena.add(before, value)),
            '-' => Some(arena.sub(before, value)),
            '*' => Some(arena.mul(before, value)),
            _ => None,
        });
        let value = changed.map_or_else(
            || unread(name, "the change is made to a value that is unknown, or divides by one"),
            ProgramValue::Value,
        );
        self.assign_program_value(name, value);
    }

    /// Assigns the entries of a vector or matrix, or of a copy of one; returns false if the formula
    /// is neither.
    fn assign_vector_entries(&mut self, name: &str, formula: &Located, notation: Notation) -> bool {
        let copied = self.words.locals.entries(formula.text.trim());
        if !copied.is_empty() {
            for (from, index) in copied {
                let value = self.words.locals.variable_number(&from).and_then(|n| self.words.locals.value(n)).cloned();
                if let Some(value) = value {
                    self.assign_program_value(&format!("{name}{index}"), value);
                }
            }
            return true;
        }
        // A tuple is a list without brackets: a bracket instead of the parenthesis keeps all byte
        // positions.
        let whole = formula.text.trim();
        let is_tuple = whole.starts_with('(') && whole.ends_with(')') && whole.contains(',') && !whole.contains('[');
        let is_bare = !is_tuple && whole.contains(',') && !whole.contains(['(', '[']);
        let (text, shift) = match (is_tuple, is_bare) {
            (true, _) => (format!("[{}]", &whole[1..whole.len() - 1]), 0),
            (_, true) => (format!("[{whole}]"), 1),
            _ => (formula.text.clone(), 0),
        };
        let Ok(MatrixCells { rows, factor: None }) = printed_matrix_cells(&text, notation) else { return false };
        let is_row = rows.len() == 1;
        let is_column = rows.iter().all(|row| row.len() == 1);
        let first = usize::from(notation == Notation::Matlab);
        for (i, row) in rows.iter().enumerate() {
            for (j, cell) in row.iter().enumerate() {
                let range = cell.start.saturating_sub(shift)..cell.end.saturating_sub(shift);
                let entry = Located { text: text[cell.clone()].to_owned(), span: formula.part(range), exact: true };
                let value = self.words.read_program_formula(&mut self.model.arena, &entry, notation);
                let value = match value {
                    ProgramValue::Unread(unread) => ProgramValue::Unread(unread.naming_variable(name)),
                    value @ ProgramValue::Value(_) => value,
                };
                let (i, j) = (i + first, j + first);
                let mut names = if notation == Notation::Matlab {
                    vec![format!("{name}({i},{j})")]
                } else {
                    vec![format!("{name}[{i},{j}]"), format!("{name}[{i}][{j}]")]
                };
                if is_row || is_column {
                    let at = if is_row { j } else { i };
                    let brackets = if notation == Notation::Matlab { ('(', ')') } else { ('[', ']') };
                    names.push(format!("{name}{}{at}{}", brackets.0, brackets.1));
                }
                for name in names {
                    self.assign_program_value(&name, value.clone());
                }
            }
        }
        true
    }
}

/// Largest number of entries of a vector that a range of indices may name.
const MOST_ENTRIES: usize = 100;

/// Names of the vector entries in a range of indices, such as z(1:4) in MATLAB or `z[0:4]` in
/// Python.
/// Returns `None` for a name without a range.
fn entries_of_assigned_range(name: &str) -> Option<Vec<String>> {
    let open = name.find(['(', '['])?;
    let is_python = name[open..].starts_with('[');
    let (first, last) = name[open + 1..].strip_suffix([')', ']'])?.split_once(':')?;
    let first = if is_python && first.is_empty() { 0 } else { first.parse::<usize>().ok()? };
    let last = last.parse::<usize>().ok()?;
    let range = if is_python { first..last } else { first..last.saturating_add(1) };
    let (bracket, close) = if is_python { ('[', ']') } else { ('(', ')') };
    let whole = &name[..open];
    (range.len() <= MOST_ENTRIES).then(|| range.map(|at| format!("{whole}{bracket}{at}{close}")).collect())
}
