//! Arrays of printed programs, entry by entry, and the operations that programs do with them.
//!
//! Invariant: an operation that is not read leaves no entry of its array with an older value.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::{Arena, Expr};
use crate::publication::names::program_variables::{ArrayKind, ArrayShape, LinearSolution, ProgramValue};

/// Largest number of unknowns of a linear system in a program.
const MOST_UNKNOWNS: usize = 8;

/// Array of a program.
#[derive(Clone)]
pub struct ProgramArray {
    /// Entries, row by row. All rows have the same length.
    pub rows: Vec<Vec<ProgramValue>>,
    pub kind: ArrayKind,
}

/// Value of a part of a formula: an array or a number.
#[derive(Clone)]
pub enum Operand {
    Array(ProgramArray),
    Number(ProgramValue),
}

/// Way in which two operands are combined.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    Add,
    Subtract,
    /// Product or quotient of entries at the same place.
    Times,
    Over,
    /// Product of matrices.
    Product,
}

impl ProgramArray {
    /// Array with one index.
    pub fn flat(entries: Vec<ProgramValue>) -> Self {
        Self { rows: entries.into_iter().map(|entry| vec![entry]).collect(), kind: ArrayKind::Flat }
    }

    /// Unit matrix with `size` rows.
    pub fn unit(size: usize, kind: ArrayKind) -> Self {
        let entry = |i, k| ProgramValue::Value(if i == k { Expr::ONE } else { Expr::ZERO });
        Self { rows: (0..size).map(|i| (0..size).map(|k| entry(i, k)).collect()).collect(), kind }
    }

    /// Number of rows and of columns, and the kind.
    pub fn shape(&self) -> ArrayShape {
        ArrayShape { rows: self.rows.len(), columns: self.rows.first().map_or(0, Vec::len), kind: self.kind }
    }

    /// Array with rows and columns exchanged. An array with one index stays as it is.
    #[must_use]
    pub fn transposed(self) -> Self {
        if self.kind == ArrayKind::Flat {
            return self;
        }
        let columns = self.shape().columns;
        let rows = (0..columns).map(|k| self.rows.iter().map(|row| row[k].clone()).collect()).collect();
        Self { rows, kind: self.kind }
    }

    /// Entries of a vector in their order; `None` for a matrix of several rows and columns.
    pub fn entries(&self) -> Option<Vec<ProgramValue>> {
        let shape = self.shape();
        (shape.rows == 1 || shape.columns == 1).then(|| self.rows.iter().flatten().cloned().collect())
    }

    /// Array whose entries are those of `self` after `change`.
    fn map(self, mut change: impl FnMut(ProgramValue) -> ProgramValue) -> Self {
        let rows = self.rows.into_iter().map(|row| row.into_iter().map(&mut change).collect()).collect();
        Self { rows, kind: self.kind }
    }
}

/// Combines two values; an unread value stays unread. `None` for a division by zero.
fn combined(arena: &mut Arena, a: &ProgramValue, b: &ProgramValue, operation: Operation) -> Option<ProgramValue> {
    let (a, b) = match (a, b) {
        (ProgramValue::Value(a), ProgramValue::Value(b)) => (*a, *b),
        (ProgramValue::Unread(_), _) => return Some(a.clone()),
        (_, ProgramValue::Unread(_)) => return Some(b.clone()),
    };
    Some(ProgramValue::Value(match operation {
        Operation::Add => arena.add(a, b),
        Operation::Subtract => arena.sub(a, b),
        Operation::Times | Operation::Product => arena.mul(a, b),
        Operation::Over => arena.div(a, b)?,
    }))
}

/// Result of an operation on two operands. The error is the reason why it is not read.
pub fn combined_operands(
    arena: &mut Arena,
    left: Operand,
    right: Operand,
    operation: Operation,
) -> Result<Operand, &'static str> {
    let zero = "it divides by zero";
    match (left, right) {
        (Operand::Number(a), Operand::Number(b)) => combined(arena, &a, &b, operation).map(Operand::Number).ok_or(zero),
        (Operand::Array(_), Operand::Array(_)) if operation == Operation::Over => {
            Err("a quotient of two vectors or matrices is not read")
        }
        (Operand::Array(a), Operand::Array(b)) if operation == Operation::Product => matrix_product(arena, &a, &b),
        (Operand::Array(a), Operand::Array(b)) => {
            if a.shape() != b.shape() {
                return Err("the sizes of its vectors or matrices do not fit");
            }
            let mut rows = Vec::new();
            for (left, right) in a.rows.iter().zip(&b.rows) {
                let row: Option<Vec<ProgramValue>> =
                    left.iter().zip(right).map(|(x, y)| combined(arena, x, y, operation)).collect();
                rows.push(row.ok_or(zero)?);
            }
            Ok(Operand::Array(ProgramArray { rows, kind: a.kind }))
        }
        (Operand::Array(array), Operand::Number(number)) => {
            if matches!(&number, ProgramValue::Value(Expr::ZERO)) && operation == Operation::Over {
                return Err(zero);
            }
            let of = |entry: ProgramValue| combined(arena, &entry, &number, operation).unwrap_or(entry);
            Ok(Operand::Array(array.map(of)))
        }
        (Operand::Number(_), Operand::Array(_)) if operation == Operation::Over => {
            Err("a division by a vector or matrix is not read")
        }
        (Operand::Number(number), Operand::Array(array)) => {
            let of = |entry: ProgramValue| combined(arena, &number, &entry, operation).unwrap_or(entry);
            Ok(Operand::Array(array.map(of)))
        }
    }
}

/// Product of two matrices; an array with one index is a row on the left and a column on the right.
fn matrix_product(arena: &mut Arena, a: &ProgramArray, b: &ProgramArray) -> Result<Operand, &'static str> {
    let left = if a.kind == ArrayKind::Flat {
        vec![a.rows.iter().map(|row| row[0].clone()).collect::<Vec<_>>()]
    } else {
        a.rows.clone()
    };
    let (inner, columns) = (b.rows.len(), b.shape().columns);
    if left.iter().any(|row| row.len() != inner) {
        return Err("the sizes of its matrices do not fit for a product");
    }
    let mut rows = Vec::new();
    for row in &left {
        let mut list = Vec::new();
        for k in 0..columns {
            let mut sum = ProgramValue::Value(Expr::ZERO);
            for (x, other) in row.iter().zip(&b.rows) {
                let product = combined(arena, x, &other[k], Operation::Times).unwrap_or_else(|| x.clone());
                sum = combined(arena, &sum, &product, Operation::Add).unwrap_or(product);
            }
            list.push(sum);
        }
        rows.push(list);
    }
    let is_flat = a.kind == ArrayKind::Flat || b.kind == ArrayKind::Flat;
    match rows.as_mut_slice() {
        [row] if row.len() == 1 && (is_flat || a.kind == ArrayKind::Matrix) => Ok(Operand::Number(row.remove(0))),
        _ if is_flat => Ok(Operand::Array(ProgramArray::flat(rows.into_iter().flatten().collect()))),
        _ => Ok(Operand::Array(ProgramArray { rows, kind: a.kind })),
    }
}

/// Solution x of A x = b, with the record of the system if all its entries are known. The error is
/// the reason why it is not read.
pub fn solved_array(
    arena: &mut Arena,
    a: &ProgramArray,
    b: &ProgramArray,
) -> Result<(ProgramArray, LinearSolution), &'static str> {
    let n = a.rows.len();
    if a.shape().columns != n || b.rows.len() != n {
        return Err("the sizes of the linear system do not fit");
    }
    if n > MOST_UNKNOWNS {
        return Err("the linear system has more than 8 unknowns");
    }
    let known = |rows: &[Vec<ProgramValue>]| -> Option<Vec<Vec<Expr>>> {
        let value = |entry: &ProgramValue| match entry {
            ProgramValue::Value(e) => Some(*e),
            ProgramValue::Unread(_) => None,
        };
        rows.iter().map(|row| row.iter().map(value).collect()).collect()
    };
    let unknown = "an entry of the linear system was not read";
    let (matrix, columns) = (known(&a.rows).ok_or(unknown)?, known(&b.rows).ok_or(unknown)?);
    let (solution, _) = solve_linear(arena, &mut Simplifier::default(), &matrix, &columns)
        .map_err(|_| "the matrix of the linear system is singular")?;
    let rows = solution.iter().map(|row| row.iter().map(|e| ProgramValue::Value(*e)).collect()).collect();
    let first = |rows: Vec<Vec<Expr>>| rows.into_iter().map(|row| row[0]).collect();
    let record = LinearSolution { values: first(solution), matrix, right: first(columns) };
    Ok((ProgramArray { rows, kind: b.kind }, record))
}

/// Arrays side by side in rows of blocks, as one array. The error is the reason why they do not fit.
pub fn joined_blocks(blocks: Vec<Vec<Operand>>, kind: ArrayKind) -> Result<ProgramArray, &'static str> {
    let unfit = "the sizes of its parts do not fit";
    let mut rows: Vec<Vec<ProgramValue>> = Vec::new();
    for line in blocks {
        let mut joined: Vec<Vec<ProgramValue>> = Vec::new();
        for (at, block) in line.into_iter().enumerate() {
            let own = match block {
                Operand::Number(value) => vec![vec![value]],
                Operand::Array(array) => array.rows,
            };
            if at == 0 {
                joined = own;
            } else if own.len() == joined.len() {
                joined.iter_mut().zip(own).for_each(|(row, more)| row.extend(more));
            } else {
                return Err(unfit);
            }
        }
        rows.extend(joined);
    }
    let width = rows.first().map_or(0, Vec::len);
    if width == 0 || rows.iter().any(|row| row.len() != width) {
        return Err(unfit);
    }
    Ok(ProgramArray { rows, kind })
}
