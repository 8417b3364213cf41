//! Published derivations as data: every printed equation of a publication, to be judged one by one.
//!
//! A publication file belongs to a model. Its formulas are read into the arena of the model. So read it before
//! [`crate::mechanics::derive_all`], whose arena starts as a clone: every handle stays valid there.
//!
//! Invariant: nothing is repaired or judged here. A wrong *form* of a file is an error; a wrong printed *equation* is
//! left for a comparison to find.
//!
//! Abbreviations are replaced by their formulas while reading; [`PrintedAbbreviations`] keeps the
//! formulas as printed. The names
//! of derived quantities stay symbols, which no model can declare, until
//! [`QuantityNames::resolve_quantity_names`] replaces them by values. So
//! an entry may be read, and its errors found, before anything is derived.
//!
//! ```
//! use tripos_derive::algebra::meaning::compare::Comparer;
//! use tripos_derive::diagnostic::Source;
//! use tripos_derive::mechanics::{Quantities, derive_all};
//! use tripos_derive::publication::{EntryKind, load_publication};
//! # let source = Source::from_text("model.toml", r#"
//! #     name = "Slider"
//! #     parameters.m = { unit = "kg" }
//! #     coordinates.x = { unit = "m" }
//! #     speeds.u = "2*x'"
//! #     inertial = { frame = "N", origin = "O" }
//! #     points.P = { from = "O", frame = "N", position = ["x", 0, 0] }
//! #     particles.slider = { point = "P", mass = "m" }
//! # "#);
//!
//! let mut model = tripos_derive::model::load(&source)?; // a mass on a line, with speed u = 2 x'
//! let publication = load_publication(&Source::from_text("publication.toml", r#"
//!     [[equation]]
//!     id = "1"
//!     section = "1"
//!     quantity = "T"
//!     printed = "m*x'^2/2"
//! "#), &mut model)?;
//! let EntryKind::Equation { quantity, printed, .. } = &publication.entries[0].kind else { unreachable!() };
//!
//! let mut derivations = derive_all(&model)?;
//! let mut quantities = Quantities::new(&model, &mut derivations);
//! let derived = quantities.value(quantity)?; // m u^2/8
//! let derived = quantities.in_rates(derived);
//! let verdict = Comparer::default().compare(&mut derivations.kinematics.arena, *printed, derived);
//! assert!(verdict.is_equal());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod approximation;
mod author_files;
mod coriolis_matrix;
mod entries;
mod equalities;
mod listing;
mod name_meanings;
mod name_spelling;
mod named_files;
mod own_coordinates;
mod printed;
mod printed_abbreviations;
mod printed_matrix;
mod printed_system;
mod program_variables;
mod publication_of_model;
mod publication_reader;
mod quantity_names;
mod row_text;
mod time_derivatives;

pub use printed_abbreviations::{Abbreviation, PrintedAbbreviations};
pub use publication_of_model::{
    hash_publication_of_model, is_publication_path, load_publication_of_model, publication_path_of_model,
};
pub use publication_reader::{load_publication, load_publication_in_coordinates, load_publication_with_files};
pub use quantity_names::QuantityNames;
pub(crate) use row_text::system_row_text;

use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::Source;
use crate::mechanics::{Formulation, Quantity};
use std::ops::Range;

/// Published derivation: the entries, names and abbreviations of a publication file.
#[derive(Clone, Debug)]
pub struct Publication {
    /// Text of the publication file, with the file's name.
    pub source: Source,
    /// Title of the publication; empty if the file states none.
    pub title: String,
    /// Description, in words, of the printed source that was transcribed; empty if the file states
    /// none.
    pub reference: String,
    /// Abbreviations of the printed text, in the order of the publication file: (name, formula).
    pub abbreviations: Vec<(String, Expr)>,
    /// Coordinates and speeds that only the printed text has: (name, formula in the model's
    /// variables).
    pub coordinates: Vec<(String, Expr)>,
    /// Coordinates and speeds of the model to which the printed text gives another meaning: (name,
    /// formula in the model's variables).
    pub redefined: Vec<(String, Expr)>,
    /// Formulas as printed, in which abbreviations are symbols.
    pub shorthand: PrintedAbbreviations,
    /// Names that the printed text gives to derived quantities: (name, quantity, symbol in the
    /// formulas).
    pub names: Vec<(String, Quantity, Expr)>,
    /// Entries of the publication, in the order of the publication file.
    pub entries: Vec<Entry>,
}

/// Entry of a publication: an equation, a definition, a system, a program (listing) or a number.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Id of the entry, unique in the publication file; the printed equation number comes first.
    pub id: String,
    /// Section of the printed text that contains the entry.
    pub section: String,
    /// Illegible part of the print, and the reading chosen for it; `None` if the print was clear.
    pub repaired: Option<String>,
    /// Remark of the transcriber; `None` if there is none.
    pub note: Option<String>,
    /// Notation in which the entry's formulas are written, such as LaTeX.
    pub notation: Notation,
    /// Point near which the entry's formulas hold; `None` if they hold everywhere.
    pub near: Option<Approximation>,
    /// Byte range of the entry's id in the publication file.
    pub span: Range<usize>,
    /// Content of the entry: an equation, a definition, a system, a program (listing) or a number.
    pub kind: EntryKind,
}

/// Statement that formulas hold only near a point, up to an order in the deviations from the point.
#[derive(Clone, Debug)]
pub struct Approximation {
    /// Highest order in the deviations that is kept, from 1 to 4.
    pub order: u32,
    /// Variables that stay near a value, each with its value at the point; at least one.
    pub values: Vec<PointValue>,
}

/// Value near which a variable stays in an approximation.
#[derive(Clone, Debug)]
pub struct PointValue {
    /// Name of the variable: a coordinate, time derivative, speed, reaction or small parameter.
    pub name: String,
    /// Symbol of the variable, in the model's arena.
    pub symbol: Expr,
    /// Value near which the variable stays; it contains only parameters.
    pub value: Expr,
}

/// Kinds of content of an entry, with their data.
#[derive(Clone, Debug)]
pub enum EntryKind {
    /// Printed value of a derived quantity.
    Equation {
        /// Derived quantity whose value is printed, such as a kinetic energy.
        quantity: Quantity,
        /// Printed value of the quantity, as a term.
        printed: Expr,
        /// Printed text of the value, as transcribed.
        text: String,
    },
    /// Printed definition, which no derivation can contradict.
    Definition {
        /// Printed text of the definition, as transcribed.
        text: String,
    },
    /// Printed linear system, such as M u̇ = F.
    System(System),
    /// Printed program that computes the time derivative of a state.
    Listing(Listing),
    /// Printed number: a parameter's value or an initial value.
    Initial(Initial),
}

/// Printed linear system, matrix · unknowns = right, with any number of rows and one column for
/// each unknown.
#[derive(Clone, Debug)]
pub struct System {
    /// Formulation whose derived system the printed system is compared with.
    pub formulation: Formulation,
    /// Index of the frame of the components of a Newton–Euler system; `None` for other systems.
    pub frame: Option<usize>,
    /// Unknowns of the system, each once: u̇ for Kane, q̈ for Lagrange, u̇ and reactions for Newton–Euler.
    pub unknowns: Vec<Expr>,
    /// Names of the unknowns, in the order of `unknowns`.
    pub unknown_names: Vec<String>,
    /// Matrix of the printed system: one row for each equation, one column for each unknown.
    pub matrix: Vec<Vec<Expr>>,
    /// Printed texts of the matrix entries, row by row.
    pub matrix_texts: Vec<Vec<String>>,
    /// Right-hand sides of the printed system, one for each row.
    pub right: Vec<Expr>,
    /// Printed texts of the right-hand sides, one for each row.
    pub right_texts: Vec<String>,
    /// Printed texts of whole rows; `None` if the system is printed as a matrix.
    pub row_texts: Option<Vec<String>>,
    /// True if the system is a single printed equation, whose row has the id of the entry.
    pub is_single: bool,
    /// Template for the ids of matrix entries, with `{i}` for the row and `{j}` for the column;
    /// `None` if entries have no ids.
    pub matrix_ids: Option<String>,
    /// Template for the ids of right-hand sides, with `{i}` for the row; `None` if right-hand sides
    /// have no ids.
    pub right_ids: Option<String>,
}

/// Printed program that computes the time derivative of a state.
/// The state has coordinates q and motion variables in any order. The motion variables are u, or q̇
/// for Lagrange.
#[derive(Clone, Debug)]
pub struct Listing {
    /// Formulation whose derived equations the printed program is compared with.
    pub formulation: Formulation,
    /// Variables of the state, z(1), z(2), …, each once: coordinates and generalized speeds. For
    /// Lagrange, rates replace speeds.
    pub state: Vec<Expr>,
    /// Names of the state's variables, in the order of `state`.
    pub state_names: Vec<String>,
    /// Assigned derivatives dz(1), dz(2), …; if the program has a matrix, before they are divided
    /// by it.
    pub derivative: Vec<Expr>,
    /// Printed texts of the assigned derivatives.
    pub derivative_texts: Vec<String>,
    /// Indices, in the state, of the motion variables u or q̇.
    pub moving: Vec<usize>,
    /// Square matrix E of dz = E \ dz, with a row and a column for each motion variable; `None` if
    /// the program has none.
    pub matrix: Option<Vec<Vec<Expr>>>,
    /// Printed texts of the matrix entries, row by row; `None` if the program has no matrix.
    pub matrix_texts: Option<Vec<Vec<String>>>,
}

/// Printed number: the value of a parameter, or an initial value.
#[derive(Clone, Debug)]
pub struct Initial {
    /// Name of the set of numbers to which the number belongs. A set has one value of each
    /// quantity.
    pub set: String,
    /// Symbol of the parameter, coordinate, coordinate's derivative or speed.
    pub quantity: Expr,
    /// Name of the parameter, coordinate, coordinate's derivative or speed.
    pub name: String,
    /// Printed number as a term without symbols.
    pub value: Expr,
    /// Text of the printed number, as transcribed.
    pub text: String,
    /// Number of printed decimals; `None` for a formula, which is exact.
    pub decimals: Option<u32>,
}

/// True if the text of a printed formula contains a decimal number, such as 2.5 or .5.
#[must_use]
pub fn has_decimals(text: &str) -> bool {
    let is_digit = |at: Option<usize>| at.and_then(|at| text.as_bytes().get(at)).is_some_and(u8::is_ascii_digit);
    text.match_indices('.').any(|(at, _)| is_digit(Some(at + 1)))
}

/// True if a printed equation has terms other than 0 on its right side.
pub(crate) fn has_right_side(text: &str) -> bool {
    text.find('=').is_some_and(|at| !text[at + 1..].trim().trim_start_matches('0').is_empty())
}

impl Publication {
    /// Title of the publication for headings, or "A publication without a title" if it is blank.
    #[must_use]
    pub fn heading(&self) -> &str {
        match self.title.trim() {
            "" => "A publication without a title",
            title => title,
        }
    }
}

impl System {
    /// Id of the row with the index `row`, from 0; `id` is the id of the system's entry.
    #[must_use]
    pub fn row_id(&self, id: &str, row: usize) -> String {
        if self.is_single { id.to_owned() } else { format!("{id}-row{}", row + 1) }
    }

    /// Id of the matrix entry in `row` and `column`, from 0; `None` if matrix entries have no ids.
    #[must_use]
    pub fn matrix_id(&self, row: usize, column: usize) -> Option<String> {
        let template = self.matrix_ids.as_ref()?;
        Some(template.replace("{i}", &(row + 1).to_string()).replace("{j}", &(column + 1).to_string()))
    }

    /// Id of the right-hand side of `row`, from 0; `None` if right-hand sides have no ids.
    #[must_use]
    pub fn right_id(&self, row: usize) -> Option<String> {
        Some(self.right_ids.as_ref()?.replace("{i}", &(row + 1).to_string()))
    }

    /// Ids of all rows, matrix entries and right-hand sides; `id` is the id of the system's entry.
    fn ids(&self, id: &str) -> Vec<String> {
        let mut ids: Vec<String> = (0..self.right.len()).map(|row| self.row_id(id, row)).collect();
        for row in 0..self.right.len() {
            ids.extend((0..self.unknowns.len()).filter_map(|column| self.matrix_id(row, column)));
        }
        ids.extend((0..self.right.len()).filter_map(|row| self.right_id(row)));
        ids
    }
}

impl Listing {
    /// Id of the program's assigned derivative with the index `at`, from 0; `id` is the id of the
    /// program's entry.
    #[must_use]
    pub fn derivative_id(&self, id: &str, at: usize) -> String {
        format!("{id}-dz{}", at + 1)
    }

    /// Id of the program's matrix entry in `row` and `column`, from 0; `id` is the id of the
    /// program's entry.
    #[must_use]
    pub fn matrix_id(&self, id: &str, row: usize, column: usize) -> String {
        // With more than nine rows, the pairs (1, 11) and (11, 1) would read the same without a
        // comma.
        let comma = if self.state.len() > 18 { "," } else { "" };
        format!("{id}-E{}{comma}{}", row + 1, column + 1)
    }

    /// Ids of all derivatives and matrix entries that the program assigns; `id` is the id of its
    /// entry.
    fn ids(&self, id: &str) -> Vec<String> {
        let mut ids: Vec<String> = (0..self.derivative.len()).map(|at| self.derivative_id(id, at)).collect();
        for (i, row) in self.matrix.iter().flatten().enumerate() {
            ids.extend((0..row.len()).map(|j| self.matrix_id(id, i, j)));
        }
        ids
    }
}

impl Entry {
    /// Ids of all parts of the entry that get a verdict: the entry's own id, or the ids of a
    /// system's or program's parts.
    #[must_use]
    pub fn ids(&self) -> Vec<String> {
        match &self.kind {
            EntryKind::System(system) => system.ids(&self.id),
            EntryKind::Listing(listing) => listing.ids(&self.id),
            EntryKind::Equation { .. } | EntryKind::Definition { .. } | EntryKind::Initial(_) => vec![self.id.clone()],
        }
    }
}
