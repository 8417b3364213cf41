//! Variables that a program assigns, while formulas of the program are read.

use crate::algebra::Expr;
use crate::diagnostic::shown;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Prefix of the names that stand for variables of a program while a formula is read.
const LOCAL: &str = "_local_";

/// Name that stands, while a formula is read, for the variable of a program with this number.
pub fn local_name(number: usize) -> String {
    format!("{LOCAL}{number}_")
}

/// Number of the variable of a program that a name stands for while a formula is read; `None` for another name.
pub fn local_number(name: &str) -> Option<usize> {
    name.strip_prefix(LOCAL)?.strip_suffix('_')?.parse().ok()
}

/// Variables that a program assigns, with their values.
#[derive(Default)]
pub struct Locals {
    /// Number of each variable in `values`, by its name in the program.
    numbers: FxHashMap<String, usize>,
    values: Vec<Local>,
    /// Variables to which the program assigns the entries of one whole together, as in `q, w = state`.
    unpacked: Vec<Vec<String>>,
}

/// Value of a variable of a program.
#[derive(Clone)]
pub enum Local {
    Value(Expr),
    Unread(Unread),
}

/// Reason why an assignment of a program was not read.
#[derive(Clone)]
pub struct Unread {
    /// Place of the reason in the reader.
    pub place: Range<usize>,
    pub message: String,
    pub help: String,
    /// True if the message names the assignment that was not read, which may be an earlier one.
    pub names_assignment: bool,
}

impl Unread {
    /// Reason with the name of the assigned variable in its message, unless an earlier assignment is named there.
    #[must_use]
    pub fn naming(mut self, name: &str) -> Self {
        if !self.names_assignment {
            self.message = format!("the assignment of `{}` was not read: {}", shown(name), self.message);
            self.names_assignment = true;
        }
        self
    }
}

impl Locals {
    /// Assigns a variable.
    pub fn set(&mut self, name: &str, value: Local) {
        self.numbers.insert(name.to_owned(), self.values.len());
        self.values.push(value);
    }

    /// Notes variables to which the program assigns the entries of one whole together.
    pub fn unpack(&mut self, names: &[String]) {
        self.unpacked.push(names.to_vec());
    }

    /// Variables to which the program assigns the entries of one whole together, one list for each assignment.
    pub fn unpacked(&self) -> &[Vec<String>] {
        &self.unpacked
    }

    /// Forgets a variable, so that its name has the meaning that the publication file gives it.
    pub fn forget(&mut self, name: &str) {
        self.numbers.remove(name);
    }

    pub fn has(&self, name: &str) -> bool {
        self.numbers.contains_key(name)
    }

    /// Number of a variable that was assigned; `None` for another name.
    pub fn number(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).copied()
    }

    /// Reason why the assignment with this number was not read; `None` if it was read.
    pub fn unread(&self, number: usize) -> Option<&Unread> {
        match self.values.get(number)? {
            Local::Unread(unread) => Some(unread),
            Local::Value(_) => None,
        }
    }

    /// Names of the entries of a vector or matrix, each with the text behind the name of the whole.
    pub fn entries(&self, whole: &str) -> Vec<(String, String)> {
        let index = |name: &String| {
            let index = name.strip_prefix(whole)?;
            index.starts_with(['[', '(']).then(|| (name.clone(), index.to_owned()))
        };
        let mut list: Vec<_> = self.numbers.keys().filter_map(index).collect();
        list.sort();
        list
    }

    /// Value of a variable by its number.
    pub fn value(&self, number: usize) -> Option<&Local> {
        self.values.get(number)
    }
}
