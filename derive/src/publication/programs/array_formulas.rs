//! Reading of formulas of programs that contain arrays: sums, products, solutions of linear systems,
//! ranges of entries, and lists of them.

use super::arrays::{Operand, Operation, ProgramArray, combined_operands, joined_blocks, solved_array};
use super::indices::{bracket_pairs, bracketed_end};
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::publication::names::program_variables::{ArrayKind, LinearSolution, ProgramValue, UnreadAssignment};
use crate::publication::printed::printed_matrix::{MatrixCells, printed_matrix_cells};
use crate::publication::printed::{comma_parts, marks_outside_brackets};
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Deepest nesting of a formula with arrays.
const DEEPEST: usize = 40;
/// Functions that make an array of a list.
const ARRAYS: [&str; 7] = ["array", "asarray", "matrix", "Matrix", "mat", "asmatrix", "ImmutableMatrix"];
/// Functions of arrays that are read beside those that make them.
const FUNCTIONS: [&str; 17] = [
    "vertcat",
    "horzcat",
    "concatenate",
    "hstack",
    "vstack",
    "block",
    "zeros",
    "ones",
    "eye",
    "solve",
    "linsolve",
    "mldivide",
    "inv",
    "dot",
    "matmul",
    "mtimes",
    "transpose",
];

/// Reason why a formula with arrays is not read.
pub(super) type Reason = String;

/// Formula with arrays that is being read, with the linear systems that it solves.
pub(super) struct ArrayFormula<'a> {
    pub formula: &'a Located,
    pub notation: Notation,
    solutions: Vec<LinearSolution>,
}

/// Trimmed byte range of a text, without semicolons behind.
pub(super) fn trimmed(text: &str, range: Range<usize>) -> Range<usize> {
    let part = &text[range.clone()];
    let start = range.start + part.len() - part.trim_start().len();
    let end = range.start + part.trim_end_matches([' ', ';', '\t']).len();
    start..end.max(start)
}

/// True if a text is a name, possibly with members, as `np.array`.
pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.'))
}

/// True if a text is a list of parts between commas.
fn is_list(text: &str) -> bool {
    comma_parts(text).len() > 1
}

/// Text inside the parentheses that enclose a whole text; `None` if there are none.
fn parenthesised(text: &str) -> Option<&str> {
    (text.starts_with('(') && bracketed_end(text, 0) == Some(text.len())).then(|| &text[1..text.len() - 1])
}

/// Name in front of a bracket and the byte range inside, if a text is one call or one indexed name.
fn called(text: &str, open: char) -> Option<(&str, Range<usize>)> {
    let at = text.find(open)?;
    let name = &text[..at];
    (is_name(name) && bracketed_end(text, at)? == text.len()).then_some((name, at + 1..text.len() - 1))
}

impl PublicationReader<'_, '_> {
    /// Reads a formula of a program as an array. `None` if the formula contains no array: then it is a
    /// number. The error is the reason why the array is not read, at its place.
    pub(in crate::publication) fn read_program_array(
        &mut self,
        formula: &Located,
        notation: Notation,
    ) -> Option<Result<(ProgramArray, Vec<LinearSolution>), UnreadAssignment>> {
        let whole = trimmed(&formula.text, 0..formula.text.len());
        let text = &formula.text[whole.clone()];
        let is_list = notation == Notation::Python && (is_list(text) || parenthesised(text).is_some_and(is_list));
        if !is_list && !self.contains_array(text, notation) {
            return None;
        }
        let mut reading = ArrayFormula { formula, notation, solutions: Vec::new() };
        match self.array_operand(&mut reading, whole, 0) {
            Ok(Operand::Array(array)) => Some(Ok((array, reading.solutions))),
            Ok(Operand::Number(value)) => {
                Some(Ok((ProgramArray { rows: vec![vec![value]], kind: ArrayKind::Number }, reading.solutions)))
            }
            Err(message) => Some(Err(UnreadAssignment {
                place: formula.span.clone(),
                message,
                help: "write it out entry by entry".to_owned(),
                names_assignment: false,
            })),
        }
    }

    /// True if a text contains an array: a list in brackets, a range, a function of arrays, or the
    /// name of an array of the program.
    fn contains_array(&self, text: &str, notation: Notation) -> bool {
        if notation == Notation::C {
            return false;
        }
        let bytes = text.as_bytes();
        let closes: FxHashMap<usize, usize> = bracket_pairs(text).into_iter().collect();
        let has_range = text.contains(':');
        let mut at = 0;
        while at < text.len() {
            let c = text[at..].chars().next().unwrap_or(' ');
            let before = text[..at].trim_end().chars().next_back();
            if c == '\\' || c == '[' && !before.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | ')' | ']')) {
                return true;
            }
            if !(c.is_alphabetic() || c == '_')
                || at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'.')
            {
                at += c.len_utf8();
                continue;
            }
            let length =
                text[at..].find(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.'))).unwrap_or(text.len() - at);
            let (name, end) = (&text[at..at + length], at + length);
            let last = name.rsplit('.').next().unwrap_or(name);
            let shape = self.words.locals.array_shape(name);
            match bytes.get(end) {
                Some(b'(') if FUNCTIONS.contains(&last) || ARRAYS.contains(&last) => return true,
                Some(b'(' | b'[') => {
                    let inside = closes.get(&end).map(|close| &text[end + 1..*close]);
                    let is_row = |inside: &str| {
                        bytes[end] == b'['
                            && shape.is_some_and(|shape| shape.kind != ArrayKind::Flat && shape.columns > 1)
                            && !inside.contains(',')
                            && bytes.get(end + inside.len() + 2) != Some(&b'[')
                    };
                    if inside.is_some_and(|inside| has_range && inside.contains(':') || is_row(inside)) {
                        return true;
                    }
                }
                _ if shape.is_some() => return true,
                // The name before a method, as in `M.T`.
                _ if name.contains('.') => {
                    let stem = &name[..name.len() - last.len() - 1];
                    if self.words.locals.array_shape(stem).is_some() {
                        return true;
                    }
                }
                _ => {}
            }
            at = end;
        }
        false
    }

    /// Value of the part `range` of a formula.
    pub(super) fn array_operand(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        range: Range<usize>,
        depth: usize,
    ) -> Result<Operand, Reason> {
        let (whole, notation) = (reading.formula, reading.notation);
        let range = trimmed(&whole.text, range);
        let text = &whole.text[range.clone()];
        let within = |inner: Range<usize>| range.start + inner.start..range.start + inner.end;
        if text.is_empty() || depth > DEEPEST {
            return Err("a part of it is not read".to_owned());
        }
        let list = comma_parts(text);
        if list.len() > 1 && notation == Notation::Python {
            let mut entries = Vec::new();
            for part in list.into_iter().filter(|part| !text[part.clone()].trim().is_empty()) {
                match self.array_operand(reading, within(part), depth + 1)? {
                    Operand::Number(value) => entries.push(value),
                    Operand::Array(_) => return Err("a list of vectors is not read".to_owned()),
                }
            }
            return Ok(Operand::Array(ProgramArray::flat(entries)));
        }
        if parenthesised(text).is_some_and(is_list) && notation == Notation::Python {
            return self.array_operand(reading, within(1..text.len() - 1), depth + 1);
        }
        if !self.contains_array(text, notation) {
            let part = Located { text: text.to_owned(), span: whole.part(range), exact: whole.exact };
            return Ok(Operand::Number(self.words.read_program_formula(&mut self.model.arena, &part, notation)));
        }
        if parenthesised(text).is_some() {
            return self.array_operand(reading, within(1..text.len() - 1), depth + 1);
        }
        if let Some((at, sign)) = last_sum_sign(text) {
            let operation = if sign == '-' { Operation::Subtract } else { Operation::Add };
            let left = if text[..at].trim().is_empty() {
                Operand::Number(ProgramValue::Value(Expr::ZERO))
            } else {
                self.array_operand(reading, within(0..at), depth + 1)?
            };
            let right = self.array_operand(reading, within(at + 1..text.len()), depth + 1)?;
            return combined_operands(&mut self.model.arena, left, right, operation).map_err(str::to_owned);
        }
        if let Some((at, sign)) = last_product_sign(text) {
            let is_elementwise = text[..at].ends_with('.');
            let left_end = at - usize::from(is_elementwise);
            let right = self.array_operand(reading, within(at + 1..text.len()), depth + 1)?;
            let is_product = sign == '@' || sign == '*' && !is_elementwise && notation == Notation::Matlab;
            if is_product && let Some(inner) = inverted_part(&text[..left_end]) {
                return self.product_with_inverse(reading, within(inner), right, depth);
            }
            let left = self.array_operand(reading, within(0..left_end), depth + 1)?;
            return self.array_product(reading, left, right, sign, is_elementwise);
        }
        self.array_atom(reading, range, depth)
    }

    /// Product, quotient or solution of two operands with the sign `*`, `/`, `@` or `\`.
    fn array_product(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        left: Operand,
        right: Operand,
        sign: char,
        is_elementwise: bool,
    ) -> Result<Operand, Reason> {
        let is_matrix = |operand: &Operand| matches!(operand, Operand::Array(array) if array.kind == ArrayKind::Matrix);
        let operation = match sign {
            '\\' if !is_elementwise => match (left, right) {
                (Operand::Array(a), Operand::Array(b)) => return self.array_solution(reading, &a, &b),
                (left, right) => {
                    return combined_operands(&mut self.model.arena, right, left, Operation::Over)
                        .map_err(str::to_owned);
                }
            },
            '\\' => return Err("`.\\` is not read".to_owned()),
            '/' => Operation::Over,
            '@' => Operation::Product,
            _ if !is_elementwise && (is_matrix(&left) || is_matrix(&right)) => Operation::Product,
            _ => Operation::Times,
        };
        combined_operands(&mut self.model.arena, left, right, operation).map_err(str::to_owned)
    }

    /// Solution of the linear system A x = b.
    pub(super) fn array_solution(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        a: &ProgramArray,
        b: &ProgramArray,
    ) -> Result<Operand, Reason> {
        let (solution, record) = solved_array(&mut self.model.arena, a, b)?;
        if b.shape().columns == 1 {
            reading.solutions.push(record);
        }
        Ok(Operand::Array(solution))
    }

    /// Product A⁻¹ b: the solution of A x = b. `inner` is the byte range of A.
    fn product_with_inverse(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        inner: Range<usize>,
        right: Operand,
        depth: usize,
    ) -> Result<Operand, Reason> {
        match (self.array_operand(reading, inner, depth + 1)?, right) {
            (Operand::Array(a), Operand::Array(b)) => self.array_solution(reading, &a, &b),
            _ => Err("it is no linear system".to_owned()),
        }
    }

    /// Inverse of a matrix.
    pub(super) fn array_inverse(&mut self, a: &ProgramArray) -> Result<Operand, Reason> {
        let unit = ProgramArray::unit(a.rows.len(), a.kind);
        Ok(Operand::Array(solved_array(&mut self.model.arena, a, &unit)?.0))
    }

    /// Value of a part without signs outside of brackets: a name, a list, a call, or one of these with
    /// a method or a mark of a transpose behind.
    fn array_atom(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        range: Range<usize>,
        depth: usize,
    ) -> Result<Operand, Reason> {
        let (whole, notation) = (reading.formula, reading.notation);
        let text = &whole.text[range.clone()];
        let within = |inner: Range<usize>| range.start + inner.start..range.start + inner.end;
        let transpose = [".transpose()", ".T", ".'", "'"].into_iter().find_map(|mark| text.strip_suffix(mark));
        if let Some(rest) = transpose {
            return match self.array_operand(reading, within(0..rest.len()), depth + 1)? {
                Operand::Array(array) => Ok(Operand::Array(array.transposed())),
                number @ Operand::Number(_) => Ok(number),
            };
        }
        for mark in [".flatten()", ".ravel()", "(:)"] {
            if let Some(rest) = text.strip_suffix(mark) {
                let Operand::Array(array) = self.array_operand(reading, within(0..rest.len()), depth + 1)? else {
                    return Err("it is no vector".to_owned());
                };
                let entries = array.entries().ok_or("a matrix is not read as one vector")?;
                let kind = if mark == "(:)" { ArrayKind::Matrix } else { ArrayKind::Flat };
                return Ok(Operand::Array(ProgramArray { kind, ..ProgramArray::flat(entries) }));
            }
        }
        if let Some(rest) = text.strip_suffix(".inv()") {
            let Operand::Array(array) = self.array_operand(reading, within(0..rest.len()), depth + 1)? else {
                return Err("it is no matrix".to_owned());
            };
            return self.array_inverse(&array);
        }
        for (method, is_product) in [(".dot(", true), (".LUsolve(", false), (".solve(", false)] {
            let Some(at) = text.rfind(method).filter(|at| is_array_text(self, &text[..*at], notation)) else {
                continue;
            };
            let open = at + method.len() - 1;
            if bracketed_end(text, open) != Some(text.len()) {
                continue;
            }
            let right = self.array_operand(reading, within(open + 1..text.len() - 1), depth + 1)?;
            if is_product && let Some(inner) = inverted_part(&text[..at]) {
                return self.product_with_inverse(reading, within(inner), right, depth);
            }
            let left = self.array_operand(reading, within(0..at), depth + 1)?;
            return match (left, right) {
                (left, right) if is_product => {
                    combined_operands(&mut self.model.arena, left, right, Operation::Product).map_err(str::to_owned)
                }
                (Operand::Array(a), Operand::Array(b)) => self.array_solution(reading, &a, &b),
                _ => Err("it is no linear system".to_owned()),
            };
        }
        if text.starts_with('[') && bracketed_end(text, 0) == Some(text.len()) {
            let kind = if notation == Notation::Matlab { ArrayKind::Matrix } else { ArrayKind::Flat };
            return self.array_list(reading, range, kind, depth);
        }
        if let Some((name, inside)) = called(text, '(')
            && (FUNCTIONS.contains(&last_of(name)) || ARRAYS.contains(&last_of(name)))
        {
            return self.array_call(reading, last_of(name), within(inside), depth);
        }
        if let Some(shape) = self.words.locals.array_shape(text) {
            return Ok(Operand::Array(self.array_of_variable(text, shape, notation)));
        }
        if let Some(part) = self.array_of_indices(text, notation) {
            return part.map(Operand::Array);
        }
        Err(match called(text, '(') {
            Some((name, _)) => format!("`{name}` of a vector or matrix is not read"),
            None => "a part of it is not read as a vector or matrix".to_owned(),
        })
    }

    /// Array of a list in brackets.
    fn array_list(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        range: Range<usize>,
        kind: ArrayKind,
        depth: usize,
    ) -> Result<Operand, Reason> {
        let whole = reading.formula;
        let text = &whole.text[range.clone()];
        let is_python = reading.notation == Notation::Python;
        let is_nested = is_python && text[1..].trim_start().starts_with('[');
        let MatrixCells { rows, .. } = printed_matrix_cells(text, reading.notation)?;
        let mut blocks = Vec::new();
        for row in rows {
            let mut line = Vec::new();
            for cell in row {
                line.push(self.array_operand(reading, range.start + cell.start..range.start + cell.end, depth + 1)?);
            }
            blocks.push(line);
        }
        if is_python && !is_nested {
            let line = blocks.remove(0);
            if line.iter().all(|operand| matches!(operand, Operand::Number(_))) {
                let numbers = line.into_iter().filter_map(|operand| match operand {
                    Operand::Number(value) => Some(value),
                    Operand::Array(_) => None,
                });
                return Ok(Operand::Array(ProgramArray::flat(numbers.collect())));
            }
            // A list of vectors is a matrix with these rows.
            let rows: Option<Vec<Vec<ProgramValue>>> = line
                .into_iter()
                .map(|operand| match operand {
                    Operand::Array(array) => array.entries(),
                    Operand::Number(_) => None,
                })
                .collect();
            let rows = rows.ok_or("a list of numbers and vectors is not read")?;
            let lines = rows.into_iter().map(|row| row.into_iter().map(Operand::Number).collect()).collect();
            return Ok(Operand::Array(joined_blocks(lines, ArrayKind::Table)?));
        }
        if is_nested && blocks.iter().flatten().any(|operand| matches!(operand, Operand::Array(_))) {
            return Err("a list of lists of vectors is not read".to_owned());
        }
        let kind = if is_nested { ArrayKind::Table } else { kind };
        Ok(Operand::Array(joined_blocks(blocks, kind)?))
    }
}

/// Byte range of A in a text such as `inv(A)`; `None` for any other text.
fn inverted_part(text: &str) -> Option<Range<usize>> {
    let start = text.len() - text.trim_start().len();
    let own = text.trim();
    let (name, inside) = called(own, '(')?;
    (last_of(name) == "inv").then_some(start + inside.start..start + inside.end)
}

/// Last part of a name with members, as `array` of `np.array`.
fn last_of(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}

/// True if a text in front of a method is an array.
fn is_array_text(reader: &PublicationReader<'_, '_>, text: &str, notation: Notation) -> bool {
    !text.trim().is_empty() && reader.contains_array(text, notation)
}

/// Byte position and sign of the last `+` or `-` outside of brackets that adds terms or stands in
/// front of the first; `None` if there is none.
fn last_sum_sign(text: &str) -> Option<(usize, char)> {
    let at = marks_outside_brackets(text, &['+', '-']).into_iter().rev().find(|at| {
        let before = text[..*at].trim_end();
        let last = before.chars().next_back();
        let is_exponent = matches!(last, Some('e' | 'E'))
            && before[..before.len() - 1].ends_with(|c: char| c.is_ascii_digit() || c == '.');
        !is_exponent && !matches!(last, Some('+' | '-' | '*' | '/' | '@' | '\\' | '^' | ',' | ':'))
    })?;
    Some((at, text[at..].chars().next()?))
}

/// Byte position and sign of the last `*`, `/`, `@` or `\` outside of brackets; `None` if there is
/// none. `**` is a power.
fn last_product_sign(text: &str) -> Option<(usize, char)> {
    let bytes = text.as_bytes();
    let at = marks_outside_brackets(text, &['*', '/', '@', '\\']).into_iter().rev().find(|at| {
        let is_star = |at: Option<usize>| at.and_then(|at| bytes.get(at)) == Some(&b'*');
        bytes[*at] != b'*' || !is_star(Some(at + 1)) && !is_star(at.checked_sub(1))
    })?;
    Some((at, text[at..].chars().next()?))
}
