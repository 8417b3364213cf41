//! Functions of programs that make arrays: of lists, of sizes, of parts, and of other arrays.

use super::array_formulas::{ArrayFormula, Reason, is_name, trimmed};
use super::arrays::{Operand, Operation, ProgramArray, combined_operands, joined_blocks};
use super::indices::bracketed_end;
use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::publication::names::program_variables::{ArrayKind, ProgramValue};
use crate::publication::printed::comma_parts;
use crate::publication::publication_reader::PublicationReader;
use std::ops::Range;

/// Largest number of rows or columns that `zeros`, `ones` or `eye` makes.
const MOST_ROWS: usize = 50;
impl PublicationReader<'_, '_> {
    /// Value of a function of arrays; `inside` is the byte range of its arguments.
    pub(super) fn array_call(
        &mut self,
        reading: &mut ArrayFormula<'_>,
        function: &str,
        inside: Range<usize>,
        depth: usize,
    ) -> Result<Operand, Reason> {
        let text = reading.formula.text[inside.clone()].to_owned();
        let arguments: Vec<Range<usize>> = comma_parts(&text)
            .into_iter()
            .filter(|part| {
                // An argument with a name, as `dtype=float`, changes no entry.
                let part = text[part.clone()].trim();
                !part.is_empty() && !part.split_once('=').is_some_and(|(name, _)| is_name(name.trim()))
            })
            .collect();
        if matches!(function, "zeros" | "ones" | "eye") {
            return array_of_sizes(function, &text, reading.notation);
        }
        let lists = matches!(function, "concatenate" | "hstack" | "vstack" | "block");
        let mut operands = Vec::new();
        for argument in &arguments {
            let place = trimmed(&text, argument.clone());
            let list = &text[place.clone()];
            // The list of parts of `concatenate([a, b])`.
            if lists && list.starts_with(['[', '(']) && bracketed_end(list, 0) == Some(list.len()) {
                for part in comma_parts(&list[1..list.len() - 1]) {
                    let part = place.start + 1 + part.start..place.start + 1 + part.end;
                    if !text[part.clone()].trim().is_empty() {
                        let at = inside.start + part.start..inside.start + part.end;
                        operands.push(self.array_operand(reading, at, depth + 1)?);
                    }
                }
                continue;
            }
            let at = inside.start + place.start..inside.start + place.end;
            operands.push(self.array_operand(reading, at, depth + 1)?);
        }
        let unread = || format!("`{function}` is not read here");
        let two = |operands: Vec<Operand>| -> Result<(Operand, Operand), Reason> {
            let [left, right]: [Operand; 2] = operands.try_into().map_err(|_| unread())?;
            Ok((left, right))
        };
        match function {
            "vertcat" => {
                let blocks = operands.into_iter().map(|operand| vec![operand]).collect();
                Ok(Operand::Array(joined_blocks(blocks, ArrayKind::Matrix)?))
            }
            "horzcat" => Ok(Operand::Array(joined_blocks(vec![operands], ArrayKind::Matrix)?)),
            "concatenate" | "hstack" => {
                let parts: Option<Vec<Vec<ProgramValue>>> = operands
                    .into_iter()
                    .map(|operand| match operand {
                        Operand::Number(value) => Some(vec![value]),
                        Operand::Array(array) if array.kind == ArrayKind::Flat => array.entries(),
                        Operand::Array(_) => None,
                    })
                    .collect();
                Ok(Operand::Array(ProgramArray::flat(parts.ok_or_else(unread)?.concat())))
            }
            "solve" | "linsolve" | "mldivide" => match two(operands)? {
                (Operand::Array(a), Operand::Array(b)) => self.array_solution(reading, &a, &b),
                _ => Err(unread()),
            },
            "dot" | "matmul" | "mtimes" => {
                let (left, right) = two(operands)?;
                combined_operands(&mut self.model.arena, left, right, Operation::Product).map_err(str::to_owned)
            }
            _ => {
                let [operand]: [Operand; 1] = operands.try_into().map_err(|_| unread())?;
                let Operand::Array(array) = operand else { return Err(unread()) };
                match function {
                    "inv" => self.array_inverse(&array),
                    "transpose" => Ok(Operand::Array(array.transposed())),
                    "array" | "asarray" => Ok(Operand::Array(array)),
                    // A list is a column of `Matrix`, and a row of `matrix`.
                    "Matrix" | "ImmutableMatrix" => {
                        Ok(Operand::Array(ProgramArray { kind: ArrayKind::Matrix, ..array }))
                    }
                    "matrix" | "mat" | "asmatrix" => {
                        let is_list = array.kind == ArrayKind::Flat;
                        let array = ProgramArray { kind: ArrayKind::Matrix, ..array };
                        Ok(Operand::Array(if is_list { array.transposed() } else { array }))
                    }
                    _ => Err(unread()),
                }
            }
        }
    }
}

/// Array that `zeros`, `ones` or `eye` makes; `text` has the sizes.
fn array_of_sizes(function: &str, text: &str, notation: Notation) -> Result<Operand, Reason> {
    let is_list = text.trim_start().starts_with(['(', '[']);
    let sizes: Option<Vec<usize>> = text
        .split([',', '(', ')', '[', ']'])
        .map(str::trim)
        .filter(|size| !size.is_empty() && !size.contains('='))
        .map(|size| size.parse().ok().filter(|n| (1..=MOST_ROWS).contains(n)))
        .collect();
    let (rows, columns, is_flat) = match (sizes.unwrap_or_default().as_slice(), notation, is_list) {
        (&[n], Notation::Python, _) if function != "eye" => (n, 1, true),
        (&[n], ..) => (n, n, false),
        // The second argument of `np.zeros(4, float)` is no size.
        (&[n, m], Notation::Matlab, _) | (&[n, m], _, true) => (n, m, false),
        _ => return Err(format!("the sizes of `{function}` are not read")),
    };
    let kind = match (notation, is_flat) {
        (Notation::Matlab, _) => ArrayKind::Matrix,
        (_, true) => ArrayKind::Flat,
        _ => ArrayKind::Table,
    };
    if function == "eye" {
        return Ok(Operand::Array(ProgramArray::unit(rows, kind)));
    }
    let value = ProgramValue::Value(if function == "ones" { Expr::ONE } else { Expr::ZERO });
    Ok(Operand::Array(ProgramArray { rows: vec![vec![value; columns]; rows], kind }))
}
