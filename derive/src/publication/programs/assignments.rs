//! Reading of a program's assignments: the value of each variable, or the reason why it was not read.

use super::arrays::{Operand, Operation, ProgramArray, combined_operands};
use super::indices::{bracket_pairs, entry_names, indexed_name, selected_entries};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Source, shortened_for_message};
use crate::publication::entries::EntryTable;
use crate::publication::names::author_files::notation_of_author_file;
use crate::publication::names::program_variables::{
    ArrayKind, ArrayShape, ProgramValue, ProgramVariables, UnreadAssignment,
};
use crate::publication::printed::{
    Statement, TracedText, comma_parts, is_program_number, statement_copies_value, statements,
};
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;
use std::sync::Arc;

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
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            locals.statement = line.span.clone();
        }
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
                self.assign_program_value(name, unread(name, "a condition or a loop decides about it"), notation);
            }
            return;
        }
        if targets.len() > 1 {
            let is_whole = right.text.trim().chars().all(|c| c.is_alphanumeric() || c == '_');
            if let Some(locals) = Arc::get_mut(&mut self.words.locals).filter(|_| is_whole) {
                locals.record_unpacking(&targets);
            }
            for name in &targets {
                self.assign_declared_meaning(name, &right.text, notation, || {
                    unread(name, "it is assigned together with others")
                });
            }
            return;
        }
        let name = targets[0].clone();
        if is_program_number(&right.text) && operator.is_none() && self.words.meaning(&name).is_some_and(|(_, is)| is) {
            // A program's number for a parameter of the model is a value, and changes no formula.
            // The key `name = ` marks that the number is assigned; it cannot be the name of a
            // variable.
            if self.words.locals.has_variable(&name) || self.words.locals.has_variable(&format!("{name} = ")) {
                self.assign_program_value(&name, unread(&name, "it gets two values"), notation);
            } else {
                self.assign_program_value(&format!("{name} = "), ProgramValue::Value(Expr::ZERO), notation);
            }
            return;
        }
        let formula = self.register_assembled_formula(source, right);
        // In Python, an operator such as `+=` changes an array that may have other names.
        if operator.is_some() && notation == Notation::Python {
            self.forget_aliases(&name);
        }
        self.assign_formula(&name, operator, &formula, notation, &unread);
        let viewed = viewed_array(&formula.text);
        if operator.is_none()
            && notation == Notation::Python
            && let Some(locals) = Arc::get_mut(&mut self.words.locals)
            && viewed != name
            && locals.array_shape(viewed).is_some()
        {
            locals.record_alias(&name, viewed);
        }
    }

    /// Assigns a formula to a variable, or changes the variable by an operator such as `+=`. `unread` makes the value
    /// of a variable, for a reason, whose formula is not read.
    fn assign_formula(
        &mut self,
        name: &str,
        operator: Option<char>,
        formula: &Located,
        notation: Notation,
        unread: &dyn Fn(&str, &str) -> ProgramValue,
    ) {
        if self.assign_array_formula(name, operator, formula, notation) {
            return;
        }
        let value = self.words.read_program_formula(&mut self.model.arena, formula, notation);
        match (value, operator) {
            (ProgramValue::Value(value), None) => {
                self.words.record_program_variable(&self.model.arena, name, formula, notation, value);
                self.assign_program_value(name, ProgramValue::Value(value), notation);
            }
            (ProgramValue::Value(value), Some(operator)) => {
                self.apply_compound_assignment(name, operator, value, notation, unread);
            }
            (ProgramValue::Unread(unread), _) => {
                let wrong = || ProgramValue::Unread(unread.naming_variable(name));
                if operator.is_none() {
                    self.assign_declared_meaning(name, &formula.text, notation, wrong);
                } else {
                    self.assign_program_value(name, wrong(), notation);
                }
            }
        }
    }

    /// Assigns a formula with arrays, or changes an array by an operator such as `+=`. Returns false
    /// if neither the formula nor the variable is an array.
    fn assign_array_formula(
        &mut self,
        name: &str,
        operator: Option<char>,
        formula: &Located,
        notation: Notation,
    ) -> bool {
        let own = operator.and_then(|_| self.words.locals.array_shape(name));
        let read = match (self.read_program_array(formula, notation), own) {
            (None, None) => return false,
            (Some(read), _) => read,
            (None, Some(_)) => {
                let value = self.words.read_program_formula(&mut self.model.arena, formula, notation);
                Ok((ProgramArray { rows: vec![vec![value]], kind: ArrayKind::Number }, Vec::new()))
            }
        };
        // A copy of itself, as in `z = z(:)`, changes nothing.
        let copied = formula.text.trim().trim_end_matches(';').trim_end_matches("(:)");
        if operator.is_none() && copied == name {
            return true;
        }
        let outcome = read.and_then(|(array, solutions)| {
            let changed = match (operator, own) {
                (None, _) => Ok(array),
                (Some(operator), Some(shape)) => self.changed_array(name, shape, operator, array, notation),
                (Some(_), None) => Err("a change of a vector or matrix is not read here"),
            };
            changed.and_then(|array| self.assign_array(name, array, notation)).map(|()| solutions).map_err(|message| {
                UnreadAssignment {
                    place: formula.span.clone(),
                    message: message.to_owned(),
                    help: "write it out entry by entry".to_owned(),
                    names_assignment: false,
                }
            })
        });
        match outcome {
            Ok(solutions) => {
                if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
                    for solution in solutions {
                        locals.record_linear_solution(solution);
                    }
                }
            }
            Err(unread) => {
                let wrong = || ProgramValue::Unread(unread.naming_variable(name));
                if operator.is_none() {
                    self.assign_declared_meaning(name, &formula.text, notation, wrong);
                } else {
                    self.assign_program_value(name, wrong(), notation);
                }
            }
        }
        true
    }

    /// Array `name` after a change such as `+=` by another array or a number.
    fn changed_array(
        &mut self,
        name: &str,
        shape: ArrayShape,
        operator: char,
        by: ProgramArray,
        notation: Notation,
    ) -> Result<ProgramArray, &'static str> {
        let before = Operand::Array(self.array_of_variable(name, shape, notation));
        let by = match by.rows.first() {
            Some(row) if by.kind == ArrayKind::Number => Operand::Number(row[0].clone()),
            _ => Operand::Array(by),
        };
        let operation = match operator {
            '+' => Operation::Add,
            '-' => Operation::Subtract,
            '*' => Operation::Times,
            _ => Operation::Over,
        };
        match combined_operands(&mut self.model.arena, before, by, operation)? {
            Operand::Array(array) => Ok(array),
            Operand::Number(_) => Err("a change of a vector to a number is not read"),
        }
    }

    /// Array of a variable, entry by entry. An entry without a value is unread.
    pub(in crate::publication) fn array_of_variable(
        &self,
        name: &str,
        shape: ArrayShape,
        notation: Notation,
    ) -> ProgramArray {
        let entry = |row, column| {
            let names = entry_names(name, (row, column), Some(shape), notation);
            let locals = &self.words.locals;
            let value = names.iter().find_map(|name| locals.value(locals.variable_number(name)?)).cloned();
            value.unwrap_or_else(|| {
                ProgramValue::Unread(UnreadAssignment {
                    place: self.words.locals.statement.clone(),
                    message: format!("`{}` has no value", names[0]),
                    help: "assign it".to_owned(),
                    names_assignment: true,
                })
            })
        };
        let rows = (0..shape.rows).map(|row| (0..shape.columns).map(|column| entry(row, column)).collect()).collect();
        ProgramArray { rows, kind: shape.kind }
    }

    /// Array of the entries that indices select, as in `z(3:4)`. `None` if the text is no indexed name.
    pub(in crate::publication) fn array_of_indices(
        &mut self,
        text: &str,
        notation: Notation,
    ) -> Option<Result<ProgramArray, String>> {
        let (name, indices) = indexed_name(text)?;
        let shape = self.words.locals.array_shape(name);
        let Some((rows, columns)) = selected_entries(&indices, shape, notation) else {
            return Some(Err(format!("what `{}` selects is not known", shortened_for_message(text))));
        };
        let value = |reader: &mut Self, row: usize, column: usize| match shape {
            Some(shape) => reader.array_of_variable(name, shape, notation).rows[row][column].clone(),
            None => {
                let text = entry_names(name, (row, column), None, notation).pop().unwrap_or_default();
                let span = reader.words.locals.statement.clone();
                let entry = Located { text, span, exact: false };
                reader.words.read_program_formula(&mut reader.model.arena, &entry, notation)
            }
        };
        let is_inside = shape.is_none_or(|shape| {
            rows.iter().all(|row| *row < shape.rows) && columns.iter().all(|column| *column < shape.columns)
        });
        if !is_inside {
            return Some(Err(format!("`{}` selects entries that do not exist", shortened_for_message(text))));
        }
        let lines: Vec<Vec<ProgramValue>> =
            rows.iter().map(|row| columns.iter().map(|column| value(self, *row, *column)).collect()).collect();
        Some(Ok(if notation == Notation::Matlab {
            ProgramArray { rows: lines, kind: ArrayKind::Matrix }
        } else if lines.len() == 1 || columns.len() == 1 {
            ProgramArray::flat(lines.into_iter().flatten().collect())
        } else {
            ProgramArray { rows: lines, kind: ArrayKind::Table }
        }))
    }

    /// Assigns an array to a variable, or to the entries that its indices select. The error is the
    /// reason why the assignment is not read.
    fn assign_array(&mut self, name: &str, array: ProgramArray, notation: Notation) -> Result<(), &'static str> {
        let shape = array.shape();
        let Some((whole, indices)) = indexed_name(name) else {
            if shape.kind == ArrayKind::Number {
                self.assign_program_value(name, array.rows[0][0].clone(), notation);
                return Ok(());
            }
            self.forget_entries(name, &format!("`{name}` is another vector or matrix now"));
            if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
                locals.set_array_shape(name, Some(shape));
                for (row, line) in array.rows.into_iter().enumerate() {
                    for (column, value) in line.into_iter().enumerate() {
                        for entry in entry_names(name, (row, column), Some(shape), notation) {
                            locals.assign_variable(&entry, value.clone());
                        }
                    }
                }
            }
            return Ok(());
        };
        let known = self.words.locals.array_shape(whole);
        let Some((rows, columns)) = selected_entries(&indices, known, notation) else {
            return Err("the entries that it is assigned to are not known");
        };
        let places: Vec<(usize, usize)> =
            rows.iter().flat_map(|row| columns.iter().map(|column| (*row, *column))).collect();
        let values: Vec<ProgramValue> = array.rows.into_iter().flatten().collect();
        let fits = if shape.rows == 1 || shape.columns == 1 {
            rows.len() == 1 || columns.len() == 1
        } else {
            (rows.len(), columns.len()) == (shape.rows, shape.columns)
        };
        let values = match values.as_slice() {
            [value] => vec![value.clone(); places.len()],
            _ if fits && values.len() == places.len() => values,
            _ => return Err("the sizes of its two sides do not fit"),
        };
        let whole = whole.to_owned();
        for (place, value) in places.into_iter().zip(values) {
            self.assign_entry(&whole, place, &value, notation);
        }
        Ok(())
    }

    /// Assigns a value to one entry of an array, by all its names.
    fn assign_entry(&mut self, whole: &str, place: (usize, usize), value: &ProgramValue, notation: Notation) {
        self.forget_aliases(whole);
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            let shape = locals.array_shape(whole);
            for name in entry_names(whole, place, shape, notation) {
                locals.assign_variable(&name, value.clone());
            }
        }
    }

    /// Makes all entries of the other names of an array unread, since the array changes.
    fn forget_aliases(&mut self, name: &str) {
        for other in self.words.locals.array_aliases(name) {
            self.forget_entries(&other, &format!("`{other}` and `{name}` may be one array, which changes"));
        }
    }

    /// Makes all entries of an array unread, for the reason `why`.
    fn forget_entries(&mut self, name: &str, why: &str) {
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            for (entry, _) in locals.entries(name) {
                let unread = UnreadAssignment {
                    place: locals.statement.clone(),
                    message: why.to_owned(),
                    help: "name the part of the program that decides".to_owned(),
                    names_assignment: true,
                };
                locals.assign_variable(&entry, ProgramValue::Unread(unread));
            }
        }
    }

    /// Assigns a value to a variable or to the entries that its indices select. If it is not known
    /// which entries change, none has a value any more.
    fn assign_program_value(&mut self, name: &str, value: ProgramValue, notation: Notation) {
        if let Some((whole, indices)) = indexed_name(name) {
            let shape = self.words.locals.array_shape(whole);
            match selected_entries(&indices, shape, notation) {
                Some((rows, columns)) => {
                    let whole = whole.to_owned();
                    for place in rows.iter().flat_map(|row| columns.iter().map(|column| (*row, *column))) {
                        self.assign_entry(&whole, place, &value, notation);
                    }
                }
                None => {
                    self.forget_entries(whole, &format!("`{name}` may be this entry, and it was assigned"));
                    self.forget_aliases(whole);
                }
            }
            if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
                locals.assign_variable(name, value);
            }
            return;
        }
        let entries = self.words.locals.entries(name);
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            locals.set_array_shape(name, None);
            for (entry, _) in entries {
                // The reason why the whole was not read holds for each entry.
                let unread = match &value {
                    ProgramValue::Unread(_) => value.clone(),
                    ProgramValue::Value(_) => ProgramValue::Unread(UnreadAssignment {
                        place: locals.statement.clone(),
                        message: format!("`{name}` is a number from here on"),
                        help: "name the part of the program that decides".to_owned(),
                        names_assignment: true,
                    }),
                };
                locals.assign_variable(&entry, unread);
            }
            locals.assign_variable(name, value);
        }
    }

    /// Restores the meaning from the publication file or the model, if the program only copies a
    /// variable from elsewhere.
    /// Else assigns the unread value `wrong`. An acceleration is always computed, never copied.
    fn assign_declared_meaning(
        &mut self,
        name: &str,
        right: &str,
        notation: Notation,
        wrong: impl FnOnce() -> ProgramValue,
    ) {
        let model = &self.model;
        let is_acceleration =
            |e: Expr| model.coordinates.iter().any(|c| c.second_rate == e) || model.speeds.iter().any(|s| s.rate == e);
        let is_declared = self.words.meaning(name).is_some_and(|(e, _)| !is_acceleration(e));
        if is_declared && statement_copies_value(right) {
            if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
                locals.forget(name);
            }
        } else {
            self.assign_program_value(name, wrong(), notation);
        }
    }

    /// Applies an assignment such as `x += value`. Division, and a change of an unknown value, give
    /// an unread value.
    fn apply_compound_assignment(
        &mut self,
        name: &str,
        operator: char,
        value: Expr,
        notation: Notation,
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
        self.assign_program_value(name, value, notation);
    }
}

/// Methods and functions of NumPy that return a view of an array: entries in the same memory.
const VIEWS: [&str; 8] = ["asarray", "ravel", "reshape", "squeeze", "swapaxes", "transpose", "view", "atleast_2d"];

/// Name of the array of which a formula of Python is the array itself or a view, as `A`, `A.T`, `A[0]`,
/// `A.reshape(2, 2)` and `np.asarray(A)`. For other formulas, a text that is no name.
fn viewed_array(formula: &str) -> &str {
    let mut text = formula.trim();
    loop {
        if let Some(rest) = text.strip_suffix(".T") {
            text = rest;
            continue;
        }
        // Opening bracket of the call that ends the formula.
        let last = bracket_pairs(text).pop().filter(|(_, close)| close + 1 == text.len());
        let Some((open, _)) = last.filter(|(open, _)| text[*open..].starts_with('(')) else { break };
        let (object, function) = text[..open].rsplit_once('.').unwrap_or(("", &text[..open]));
        if !VIEWS.contains(&function) {
            break;
        }
        let inside = &text[open + 1..text.len() - 1];
        let is_module = matches!(object, "" | "np" | "numpy");
        text =
            if is_module { comma_parts(inside).first().map_or("", |part| inside[part.clone()].trim()) } else { object };
    }
    indexed_name(text).map_or(text, |(name, _)| name)
}
