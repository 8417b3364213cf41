//! Reading of a program's assignments: the value of each variable, or the reason why it was not read.

use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Source, shortened_for_message};
use crate::publication::entries::EntryTable;
use crate::publication::names::author_files::notation_of_author_file;
use crate::publication::names::program_variables::{ProgramValue, ProgramVariables, UnreadAssignment};
use crate::publication::printed::printed_matrix::{MatrixCells, printed_matrix_cells};
use crate::publication::printed::{Statement, TracedText, is_program_number, statement_copies_value, statements};
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;
use std::sync::Arc;

/// Largest number of entries of a vector that a range of indices may name.
const MOST_ENTRIES: usize = 100;

impl<'a> PublicationReader<'a, '_> {
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
                let is_whole = operator.is_none()
                    && (self.assign_linear_solution(&name, &formula, notation)
                        || self.assign_vector_entries(&name, &formula, notation));
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
    pub(in crate::publication) fn assign_program_value(&mut self, name: &str, value: ProgramValue) {
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

    /// Assigns entries of a vector to others, as in `dz(1:2) = z(3:4)`. Returns false if the formula is
    /// no range of entries.
    fn assign_range_of_entries(&mut self, name: &str, formula: &Located, notation: Notation) -> bool {
        let whole = formula.text.trim();
        let Some(sources) = entries_of_assigned_range(whole) else { return false };
        let Some(names) = names_of_assigned_entries(name, sources.len(), notation) else { return false };
        // All values are read before the first is assigned.
        let place = formula.span.clone();
        let values: Vec<ProgramValue> = sources
            .into_iter()
            .map(|text| {
                let entry = Located { text, span: place.clone(), exact: false };
                self.words.read_program_formula(&mut self.model.arena, &entry, notation)
            })
            .collect();
        for (name, value) in names.iter().zip(values) {
            let value = match value {
                ProgramValue::Unread(unread) => ProgramValue::Unread(unread.naming_variable(name)),
                value @ ProgramValue::Value(_) => value,
            };
            self.assign_program_value(name, value);
        }
        true
    }

    /// Assigns the entries of a vector or matrix, or of a copy of one; returns false if the formula
    /// is neither.
    pub(in crate::publication) fn assign_vector_entries(
        &mut self,
        name: &str,
        formula: &Located,
        notation: Notation,
    ) -> bool {
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
        if self.assign_range_of_entries(name, formula, notation) {
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

/// Names of the entries of an assigned vector: those of a range such as z(1:4), or the first
/// `count` entries of a whole vector. Returns `None` for a range of another length.
pub fn names_of_assigned_entries(name: &str, count: usize, notation: Notation) -> Option<Vec<String>> {
    let first = usize::from(notation == Notation::Matlab);
    let (open, close) = if notation == Notation::Matlab { ('(', ')') } else { ('[', ']') };
    let whole = || (first..first + count).map(|at| format!("{name}{open}{at}{close}")).collect();
    Some(entries_of_assigned_range(name).unwrap_or_else(whole)).filter(|names| names.len() == count)
}

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
