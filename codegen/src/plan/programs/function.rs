//! Plan of one function: arguments, program, return value and cost.

use super::arguments::{Argument, Entry};
use super::cost::OperationCount;
use super::program::{Program, Statement};
use super::program_parts::Parts;
use rustc_hash::FxHashSet;
use tripos_derive::algebra::Expr;

/// Planned function of generated code, which is independent of a target language.
#[derive(Clone, Debug)]
pub struct Function {
    /// Name of the generated function.
    pub name: &'static str,
    /// Description of the function's result, as a sentence for its comment.
    pub about: String,
    /// Arguments of the function, in the order of its signature.
    pub arguments: Vec<Argument>,
    /// Shape of the function's return value, such as a number, a vector or a matrix.
    pub returns: Returns,
    /// Program that computes the function's values, line by line.
    pub program: Program,
    /// Entries of the return value, in order: names of computed variables, or zero.
    pub entries: Vec<Entry>,
    /// Division of a long program into several functions; `None` if the program stays whole.
    pub parts: Option<Parts>,
    /// Number of operations in one call of the function.
    pub cost: OperationCount,
    /// Choice of the comments on the lines of the program: formulas or none.
    pub explanation: LineComments,
}

/// Choice of the comments on the lines of a program: formulas or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineComments {
    /// Each line has its formula above it as a comment.
    Formulas,
    /// No line has a comment, because most lines are named terms, whose names say enough.
    Names,
}

impl LineComments {
    /// Returns the formula of a statement as a comment for the line above it; `None` if no comment
    /// is written.
    #[must_use]
    pub fn of(self, statement: &Statement) -> Option<&str> {
        statement.comment.as_deref().filter(|_| self == Self::Formulas)
    }
}

/// Kind of argument list of a planned function: the quantities that it takes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Arguments {
    /// Arguments (p, q, v): parameters, coordinates and motion variables.
    State,
    /// Arguments (p, q, u): parameters, coordinates and generalized speeds.
    Speeds,
    /// Arguments (p, q, v, v̇): parameters, coordinates, motion variables and their time
    /// derivatives.
    StateAndRates,
    /// Arguments (p, q, v, x): parameters, coordinates, motion variables and the unknowns of the
    /// linear system.
    StateAndUnknowns,
    /// Arguments (p, q): parameters and coordinates, without motion variables.
    Configuration,
    /// Arguments (p): only the parameters.
    Parameters,
    /// Arguments (p, q, v, r): parameters, coordinates, motion variables, and reactions in the
    /// order of the model.
    Balanced,
    /// Arguments (p, t, q, v): parameters, time, coordinates and motion variables. They serve the
    /// outputs and events of scenes.
    Shown {
        /// Symbol of the time t in the arena.
        time: Expr,
    },
}

/// Shape of the return value of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Returns {
    /// The function returns a single number.
    Number,
    /// The function returns one array with all its entries.
    Vector,
    /// The function returns two arrays. The first has this length; the second contains the remaining entries.
    Pair(usize),
    /// The function returns two arrays: a square matrix with this many rows, row by row, and a vector with as many
    /// entries as the matrix has rows.
    System(usize),
    /// The function returns a square matrix, row by row. A symmetric matrix is computed from its upper triangle.
    Matrix {
        /// True if the matrix equals its transpose.
        symmetric: bool,
    },
    /// The function returns a rectangular matrix, row by row.
    Table {
        /// Number of columns of the returned matrix.
        columns: usize,
    },
}

impl Returns {
    /// Returns the comment for the lines that compute the entries; it is written above them.
    #[must_use]
    pub fn heading(self) -> &'static str {
        match self {
            Self::Matrix { symmetric: true } => "Entries that are not zero; upper triangle.",
            Self::Matrix { .. } | Self::Table { .. } => "Entries that are not zero.",
            _ => "Values.",
        }
    }

    /// Returns the length of the first of two results, as a number of entries. `None` if the function returns only
    /// one result.
    #[must_use]
    pub fn first(self) -> Option<usize> {
        match self {
            Self::Pair(first) => Some(first),
            Self::System(side) => Some(side * side),
            Self::Number | Self::Vector | Self::Matrix { .. } | Self::Table { .. } => None,
        }
    }

    /// Returns the index of the entry that is computed in place of the entry `at` of `count`. In a symmetric matrix
    /// it lies in the upper triangle; otherwise it is `at`.
    pub(in crate::plan) fn entry_of_upper_triangle(self, at: usize, count: usize) -> usize {
        let side = count.isqrt();
        match self {
            Self::Matrix { symmetric: true } if at % side < at / side => (at % side) * side + at / side,
            _ => at,
        }
    }
}

/// Value to be computed, as (name of its variable, its name in comments, its term).
pub type Value = (String, String, Expr);

impl Function {
    /// Returns the part of the function's cost that depends only on parameters. It could be computed once for all
    /// states.
    #[must_use]
    pub fn cost_of_parameters(&self) -> OperationCount {
        let mut fixed: FxHashSet<&str> = FxHashSet::default();
        for argument in &self.arguments {
            if let Argument::Parameters { read } = argument {
                fixed.extend(read.iter().map(|(_, variable)| variable.as_str()));
            }
        }
        let mut lines = Vec::new();
        for (at, line) in self.program.lines.iter().enumerate() {
            if self.program.names_read(at..at + 1).is_subset(&fixed) {
                fixed.extend(self.program.names_set(at..at + 1));
                lines.push(line.clone());
            }
        }
        OperationCount::of(&Program { lines, ..Program::default() })
    }
}

/// Returns the numbers of rows and columns of the matrix that a function returns, or of the first
/// of two results. `None` for a function that returns a number or vectors.
#[cfg(feature = "languages")]
pub(crate) fn result_matrix_size(function: &Function) -> Option<[usize; 2]> {
    let count = function.entries.len();
    match function.returns {
        Returns::Matrix { .. } => Some([count.isqrt(); 2]),
        Returns::Table { columns } => Some([count.checked_div(columns).unwrap_or(0), columns]),
        Returns::System(side) => Some([side; 2]),
        Returns::Number | Returns::Vector | Returns::Pair(_) => None,
    }
}
