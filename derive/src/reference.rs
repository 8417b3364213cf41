//! Reference of a model: an independent derivation by SymPy, as data, and its comparison with the
//! derivation of Tripos.
//!
//! `tests/sympy/reference.py` writes a reference, and `models/*/reference.json` stores it.
//! `tests/sympy/README.md` describes the keys. Formulas are compared by algebra, never by text: see
//! [`compare_reference()`].
//!
//! Invariant: a reference agrees only if it is complete. A missing entry is reported. This module
//! does not run Python.

mod compare_reference;

pub use compare_reference::{ComparedEntry, compare_reference};

use crate::algebra::text::parse::ParseError;
use crate::diagnostic::{Source, shortened_for_message};
use crate::mechanics::{Formulation, QuantityError};
use crate::model::text_hash;
use crate::plain_text::path_as_plain_text;
use serde_json::{Map, Value};
use std::fmt;
use std::path::{Path, PathBuf};

/// Equations and quantities that SymPy derived from a model file, as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// Path of the file from which the reference was read, for messages.
    pub file: PathBuf,
    /// Short name of the model, as stated in the reference.
    pub model: String,
    /// Hash of the model text from which the reference was derived. Shapes and notation are not
    /// part of this text; see [`crate::model::text_hash`].
    pub text_hash: String,
    /// Version of SymPy that derived the reference.
    pub sympy: String,
    /// Quantities as pairs of name and formula, in the order of the reference file.
    pub quantities: Vec<(String, String)>,
    /// Equations of motion, one system for each formulation in the file. Kane's and Lagrange's
    /// equations are always present, unless `not_derived` is set.
    pub systems: Vec<ReferenceSystem>,
    /// Reason why SymPy does not derive this model, so that the reference is empty. `None` if SymPy
    /// derives it.
    pub not_derived: Option<String>,
}

/// Linear system of equations of motion, matrix · unknowns = forcing, with formulas as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReferenceSystem {
    /// Formulation by which SymPy derived the equations.
    pub formulation: Formulation,
    /// Names of the unknowns, in the order of the columns.
    pub unknowns: Vec<String>,
    /// Square matrix of formulas, with a row and a column for each unknown.
    pub matrix: Vec<Vec<String>>,
    /// Right-hand side of the equations, with a formula for each row.
    pub forcing: Vec<String>,
}

/// Reason why a reference cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReferenceError {
    /// Text of the reference file is not JSON.
    NotJson {
        /// Path of the reference file.
        file: PathBuf,
        /// Error of the JSON reader, with line and column.
        why: String,
    },
    /// Key of the reference file is missing or has the wrong content.
    Form {
        /// Path of the reference file.
        file: PathBuf,
        /// Full name of the key in the file, as in `kane.matrix`.
        key: String,
        /// Description of the content that the key must have.
        expected: String,
    },
    /// Reference was derived from a model text that differs from the present one.
    OtherText {
        /// Path of the reference file.
        file: PathBuf,
        /// Hash of the model text, as stated in the reference.
        recorded: String,
        /// Hash of the present model text.
        current: String,
    },
    /// Reference states a quantity that the model does not have.
    Quantity {
        /// Path of the reference file.
        file: PathBuf,
        /// Name of the quantity in the reference.
        name: String,
        /// Error in the quantity's name.
        error: QuantityError,
    },
    /// SymPy does not derive this model, so the reference is empty.
    NotDerived {
        /// Path of the reference file.
        file: PathBuf,
        /// Reason that the reference states for being empty.
        why: String,
    },
    /// Formula in the reference cannot be read.
    Formula {
        /// Path of the reference file.
        file: PathBuf,
        /// Name of the entry to which the formula belongs.
        name: String,
        /// Error in the formula.
        error: ParseError,
    },
}

impl std::error::Error for ReferenceError {}

impl fmt::Display for ReferenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotJson { file, why } => write!(f, "{}: this is not JSON: {why}", path_as_plain_text(file)),
            Self::Form { file, key, expected } => write!(f, "{}: `{key}` must be {expected}", path_as_plain_text(file)),
            Self::OtherText { file, recorded, current } => {
                let recorded = shortened_for_message(recorded);
                write!(
                    f,
                    "{}: derived from the model text {recorded}, which now is {current}",
                    path_as_plain_text(file)
                )
            }
            Self::Quantity { file, name, error } => {
                write!(
                    f,
                    "{}: `{}`: {} ({})",
                    path_as_plain_text(file),
                    shortened_for_message(name),
                    error.message,
                    error.help
                )
            }
            Self::NotDerived { file, why } => write!(f, "{}: {}", path_as_plain_text(file), shortened_for_message(why)),
            Self::Formula { file, name, error } => {
                write!(
                    f,
                    "{}: the value of `{}`: {}",
                    path_as_plain_text(file),
                    shortened_for_message(name),
                    error.message
                )
            }
        }
    }
}

impl Reference {
    /// Reads a reference from JSON text. Errors state the path `source.path`.
    ///
    /// # Errors
    /// [`ReferenceError::NotJson`] or [`ReferenceError::Form`] if the text has a wrong form.
    pub fn read(source: &Source) -> Result<Self, ReferenceError> {
        let file = &source.path;
        let not_json =
            |error: serde_json::Error| ReferenceError::NotJson { file: file.clone(), why: error.to_string() };
        let value: Value = serde_json::from_str(&source.text).map_err(not_json)?;
        let file_table = value.as_object().ok_or_else(|| form_error(file, "the file", "an object"))?;
        let table = ReferenceTable { file, path: "", entries: file_table };
        let not_derived = match file_table.get(NOT_DERIVED) {
            Some(_) => Some(table.text(NOT_DERIVED)?),
            None => None,
        };
        let mut systems = Vec::new();
        for (formulation, key) in SYSTEMS {
            let is_wanted = not_derived.is_none() && !formulation.has_reactions();
            if is_wanted || file_table.contains_key(key) {
                systems.push(table.table(key)?.system(formulation)?);
            }
        }
        Ok(Self {
            file: file.clone(),
            model: table.text("model")?,
            text_hash: table.text("text_hash")?,
            sympy: table.text("sympy")?,
            quantities: if not_derived.is_some() { Vec::new() } else { table.table("quantities")?.formulas()? },
            systems,
            not_derived,
        })
    }

    /// Checks that the reference was derived from the model text `text`. Shapes and notation in the
    /// text may differ.
    ///
    /// # Errors
    /// [`ReferenceError::OtherText`] if the reference was derived from a different text.
    pub fn check_text(&self, text: &str) -> Result<(), ReferenceError> {
        let current = text_hash(crate::model::equations_text(text));
        if self.text_hash == current {
            return Ok(());
        }
        Err(ReferenceError::OtherText { file: self.file.clone(), recorded: self.text_hash.clone(), current })
    }
}

/// Name of the folder of the Python environment, which is inside cargo's test folder. It contains a
/// hash of `requirements`: the text of `tests/sympy/requirements.txt`, which lists the packages.
#[must_use]
pub fn reference_environment_name(requirements: &str) -> String {
    format!("sympy-{}", text_hash(requirements))
}

/// Key in a reference file that states why the reference is empty.
const NOT_DERIVED: &str = "not_derived";

/// Formulations that a reference file may have, each with its key in the file.
const SYSTEMS: [(Formulation, &str); 3] =
    [(Formulation::Kane, "kane"), (Formulation::Lagrange, "lagrange"), (Formulation::NewtonEuler, "newton_euler")];

/// Creates the error for a key whose content differs from the expected content.
fn form_error(file: &Path, key: &str, expected: &str) -> ReferenceError {
    ReferenceError::Form { file: file.to_owned(), key: shortened_for_message(key), expected: expected.to_owned() }
}

/// JSON object in a reference file, with the path and key that errors state.
struct ReferenceTable<'a> {
    /// Path of the reference file.
    file: &'a Path,
    /// Key of the object in the file; empty for the whole file.
    path: &'a str,
    /// Entries of the JSON object, by key.
    entries: &'a Map<String, Value>,
}

impl<'a> ReferenceTable<'a> {
    /// Creates the error for an entry of this object whose content differs from the text
    /// `expected`.
    fn wrong_entry_error(&self, key: &str, expected: &str) -> ReferenceError {
        let dot = if self.path.is_empty() { "" } else { "." };
        form_error(self.file, &format!("{}{dot}{key}", self.path), expected)
    }

    /// Reads the entry with this key, which must be a string.
    fn text(&self, key: &str) -> Result<String, ReferenceError> {
        let text = self.entries.get(key).and_then(Value::as_str);
        text.map(str::to_owned).ok_or_else(|| self.wrong_entry_error(key, "a string"))
    }

    /// Reads the entry with this key, which must be an object.
    fn table(&self, key: &'a str) -> Result<ReferenceTable<'a>, ReferenceError> {
        let entries = self.entries.get(key).and_then(Value::as_object);
        Ok(ReferenceTable {
            file: self.file,
            path: key,
            entries: entries.ok_or_else(|| self.wrong_entry_error(key, "an object"))?,
        })
    }

    /// Reads all entries as formulas: pairs of name and text.
    fn formulas(&self) -> Result<Vec<(String, String)>, ReferenceError> {
        let entries = self.entries.iter().map(|(name, value)| {
            let formula = value.as_str().ok_or_else(|| self.wrong_entry_error(name, "a string"))?;
            Ok((name.clone(), formula.to_owned()))
        });
        entries.collect()
    }

    /// Reads an entry that must be a list of strings. If `count` is given, the list must have
    /// `count` strings.
    fn list(&self, key: &str, count: Option<usize>) -> Result<Vec<String>, ReferenceError> {
        let found =
            self.entries.get(key).and_then(reference_string_list).filter(|list| count.is_none_or(|n| n == list.len()));
        found.ok_or_else(|| self.wrong_entry_error(key, "strings, one for each unknown"))
    }

    /// Reads this object as a linear system: unknowns, matrix and forcing.
    fn system(&self, formulation: Formulation) -> Result<ReferenceSystem, ReferenceError> {
        let unknowns = self.list("unknowns", None)?;
        let n = unknowns.len();
        let rows = self.entries.get("matrix").and_then(Value::as_array);
        let rows = rows.and_then(|rows| rows.iter().map(reference_string_list).collect::<Option<Vec<_>>>());
        let matrix = rows.filter(|rows| rows.len() == n && rows.iter().all(|row| row.len() == n));
        let matrix = matrix.ok_or_else(|| {
            self.wrong_entry_error("matrix", "a list of n rows of n strings, with n the number of unknowns")
        })?;
        Ok(ReferenceSystem { formulation, unknowns, matrix, forcing: self.list("forcing", Some(n))? })
    }
}

/// Reads a JSON value as a list of strings; `None` if it is anything else.
fn reference_string_list(value: &Value) -> Option<Vec<String>> {
    value.as_array()?.iter().map(|entry| entry.as_str().map(str::to_owned)).collect()
}
