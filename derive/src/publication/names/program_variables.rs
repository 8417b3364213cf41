//! Variables that a printed program assigns, for the reading of formulas that use them.

use crate::algebra::Expr;
use crate::diagnostic::shortened_for_message;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Prefix of the names that replace program variables while a formula is read.
const LOCAL: &str = "_local_";

/// Name that replaces the program variable with this number while a formula is read.
pub fn variable_substitute(number: usize) -> String {
    format!("{LOCAL}{number}_")
}

/// Number of the program variable that is replaced by `name`; `None` for any other name.
pub fn variable_number_of_substitute(name: &str) -> Option<usize> {
    name.strip_prefix(LOCAL)?.strip_suffix('_')?.parse().ok()
}

/// Variables that a program listed in a publication assigns, with their values.
#[derive(Default)]
pub struct ProgramVariables {
    /// Index of each variable's latest value in the list of values. The key is the name in the program.
    numbers: FxHashMap<String, usize>,
    /// Assigned values, in the order of the assignments.
    values: Vec<ProgramValue>,
    /// Lists of variables that the program assigns together from the same vector, as in `q, w = state`.
    unpacked: Vec<Vec<String>>,
    /// Place of the statement that is being read, as a byte range in the reader's texts.
    pub statement: Range<usize>,
    /// Shapes of the arrays of the program, by their names.
    shapes: FxHashMap<String, ArrayShape>,
    /// Pairs of names that may be the same array, as after `K = M` in Python.
    aliases: Vec<[String; 2]>,
    /// Linear systems that the program solves, in the order of the statements.
    solutions: Vec<LinearSolution>,
}

/// Kind of an array in a program, which decides the meaning of its product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrayKind {
    /// Matrix or vector with two indices and the product of matrices, as in MATLAB.
    Matrix,
    /// Array with two indices and an entry-by-entry product, as in NumPy.
    Table,
    /// Array with one index.
    Flat,
    /// Number that is the result of a formula with arrays.
    Number,
}

/// Size and kind of an array in a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArrayShape {
    /// Number of rows; for an array with one index, the number of its entries.
    pub rows: usize,
    /// Number of columns of the array.
    pub columns: usize,
    pub kind: ArrayKind,
}

/// Linear system A x = b that a program solves, with its solution.
pub struct LinearSolution {
    /// Unknowns x as terms.
    pub values: Vec<Expr>,
    /// Matrix A, row by row.
    pub matrix: Vec<Vec<Expr>>,
    /// Right side b of the system, one entry for each row of A.
    pub right: Vec<Expr>,
}

/// Value that a program listed in a publication assigns to a variable.
#[derive(Clone)]
pub enum ProgramValue {
    /// Value that was read as a symbolic term.
    Value(Expr),
    /// Value of an assignment that was not read, with the reason.
    Unread(UnreadAssignment),
}

/// Reason why an assignment of a program was not read, for an error message.
#[derive(Clone)]
pub struct UnreadAssignment {
    /// Place of the cause, as a byte range in the reader's texts.
    pub place: Range<usize>,
    /// Message that says why the assignment was not read.
    pub message: String,
    /// Advice that goes with the message.
    pub help: String,
    /// True if the message names an assignment that was not read. It may be an earlier assignment.
    pub names_assignment: bool,
}

impl UnreadAssignment {
    /// Adds the name of the assigned variable to the message. If the message already names an assignment, it is
    /// unchanged.
    #[must_use]
    pub fn naming_variable(mut self, name: &str) -> Self {
        if !self.names_assignment {
            self.message =
                format!("the assignment of `{}` was not read: {}", shortened_for_message(name), self.message);
            self.names_assignment = true;
        }
        self
    }
}

impl ProgramVariables {
    /// Assigns a value to a variable. An earlier value of the variable is kept under its own number.
    pub fn assign_variable(&mut self, name: &str, value: ProgramValue) {
        self.numbers.insert(name.to_owned(), self.values.len());
        self.values.push(value);
    }

    /// Records variables that the program assigns together from one vector, in their order.
    pub fn record_unpacking(&mut self, names: &[String]) {
        self.unpacked.push(names.to_vec());
    }

    /// Lists of variables that the program assigns together from the same vector, with one list for each assignment.
    pub fn unpacked_variables(&self) -> &[Vec<String>] {
        &self.unpacked
    }

    /// Shape of the array with this name. `None` for a name that is no array, or an array of unknown shape. If only
    /// entries of the array were assigned and none is missing, the entries determine the shape.
    pub fn array_shape(&self, name: &str) -> Option<ArrayShape> {
        self.shapes.get(name).copied().or_else(|| self.shape_of_entries(name))
    }

    /// Shape of an array whose entries were assigned one by one; `None` if an entry is missing.
    fn shape_of_entries(&self, name: &str) -> Option<ArrayShape> {
        let list = self.entries(name);
        let is_matlab = list.first()?.1.starts_with('(');
        let first = usize::from(is_matlab);
        let places = list.iter().map(|(_, index)| {
            let numbers: Option<Vec<usize>> = index
                .split(['(', ')', '[', ']', ','])
                .filter(|part| !part.is_empty())
                .map(|part| part.trim().parse::<usize>().ok()?.checked_sub(first))
                .collect();
            numbers.filter(|numbers| matches!(numbers.len(), 1 | 2))
        });
        let places: Vec<Vec<usize>> = places.collect::<Option<_>>()?;
        let pairs: Vec<&Vec<usize>> = places.iter().filter(|place| place.len() == 2).collect();
        if pairs.is_empty() {
            let rows = places.iter().map(|place| place[0]).max()?.checked_add(1)?;
            let kind = if is_matlab { ArrayKind::Matrix } else { ArrayKind::Flat };
            return (places.len() == rows).then_some(ArrayShape { rows, columns: 1, kind });
        }
        let rows = pairs.iter().map(|place| place[0]).max()?.checked_add(1)?;
        let columns = pairs.iter().map(|place| place[1]).max()?.checked_add(1)?;
        let is_complete = (0..rows).all(|i| (0..columns).all(|k| pairs.iter().any(|place| **place == [i, k])));
        let kind = if is_matlab { ArrayKind::Matrix } else { ArrayKind::Table };
        is_complete.then_some(ArrayShape { rows, columns, kind })
    }

    /// Sets the shape of an array. `None` records that the name is no array any more.
    pub fn set_array_shape(&mut self, name: &str, shape: Option<ArrayShape>) {
        self.aliases.retain(|pair| pair.iter().all(|own| own != name));
        match shape {
            Some(shape) => {
                self.numbers.remove(name);
                self.shapes.insert(name.to_owned(), shape);
            }
            None => {
                self.shapes.remove(name);
            }
        }
    }

    /// Records that two names may be the same array, and so may the other names of the second.
    pub fn record_alias(&mut self, name: &str, other: &str) {
        for own in self.array_aliases(other).into_iter().chain([other.to_owned()]) {
            self.aliases.push([name.to_owned(), own]);
        }
    }

    /// Other names that may be the same array as `name`.
    pub fn array_aliases(&self, name: &str) -> Vec<String> {
        let other = |[a, b]: &[String; 2]| match (a == name, b == name) {
            (true, _) => Some(b.clone()),
            (_, true) => Some(a.clone()),
            _ => None,
        };
        self.aliases.iter().filter_map(other).collect()
    }

    /// Records a linear system that the program solves.
    pub fn record_linear_solution(&mut self, solution: LinearSolution) {
        self.solutions.push(solution);
    }

    /// Latest linear system of the program that has the solution `values`; `None` if there is none.
    pub fn linear_solution(&self, values: &[Expr]) -> Option<&LinearSolution> {
        self.solutions.iter().rev().find(|solution| solution.values == values)
    }

    /// Removes a variable. Its name then has its meaning from the publication file or the model again.
    pub fn forget(&mut self, name: &str) {
        self.numbers.remove(name);
    }

    /// True if the program has assigned a variable of this name.
    pub fn has_variable(&self, name: &str) -> bool {
        self.numbers.contains_key(name)
    }

    /// Number of the latest value of a variable; `None` for a name that was not assigned.
    pub fn variable_number(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).copied()
    }

    /// Reason why the assignment with this number was not read; `None` if it was read.
    pub fn unread(&self, number: usize) -> Option<&UnreadAssignment> {
        match self.values.get(number)? {
            ProgramValue::Unread(unread) => Some(unread),
            ProgramValue::Value(_) => None,
        }
    }

    /// Names of the assigned entries of the vector or matrix `whole`, each with its index as text, such as `[0]`.
    pub fn entries(&self, whole: &str) -> Vec<(String, String)> {
        let index = |name: &String| {
            let index = name.strip_prefix(whole)?;
            index.starts_with(['[', '(']).then(|| (name.clone(), index.to_owned()))
        };
        let mut list: Vec<_> = self.numbers.keys().filter_map(index).collect();
        list.sort();
        list
    }

    /// Value with this number; `None` for an unknown number.
    pub fn value(&self, number: usize) -> Option<&ProgramValue> {
        self.values.get(number)
    }
}
