//! Published derivations as data: every printed equation of a publication, to be judged one by one.
//!
//! A publication file belongs to a model. Its formulas are read into the arena of the model, so read it before
//! [`crate::mechanics::derive_all`], whose arena starts as a clone: every handle stays valid there.
//!
//! Invariant: nothing is repaired or judged here. A wrong *form* of a file is an error; a wrong printed *equation* is
//! left for a comparison to find.
//!
//! Abbreviations are replaced by their formulas while reading. The names of derived quantities stay symbols, which no
//! model can declare, until [`Names::resolve`] says what they are worth: so an entry may be read, and its errors
//! found, before anything is derived.
//!
//! ```
//! use tripos_derive::algebra::meaning::compare::Comparer;
//! use tripos_derive::diagnostic::Source;
//! use tripos_derive::mechanics::{Quantities, derive_all};
//! use tripos_derive::publication::{EntryKind, load};
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
//! let publication = load(&Source::from_text("publication.toml", r#"
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

mod beside;
mod entries;
mod linear;
mod names;
mod near;
mod read;
mod spelling;
mod words;

pub use beside::{beside, hash_beside, is_beside, load_beside};
pub use names::Names;
pub use read::load;

use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::Source;
use crate::mechanics::{Formulation, Quantity};
use std::ops::Range;

/// A published derivation.
#[derive(Clone, Debug)]
pub struct Publication {
    /// The file.
    pub source: Source,
    /// The title.
    pub title: String,
    /// Description of the source that was transcribed, in words.
    pub reference: String,
    /// Shorthand of the text, in the order of the file: (name, formula).
    pub abbreviations: Vec<(String, Expr)>,
    /// Symbols of the text for derived quantities: (name, quantity, its symbol in the formulas).
    pub names: Vec<(String, Quantity, Expr)>,
    /// The entries in the order of the file.
    pub entries: Vec<Entry>,
}

/// Something printed.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Unique in the file; the equation number comes first.
    pub id: String,
    /// The section of the text.
    pub section: String,
    /// Garbled part of the print, and the way it was read; `None` if the print was clear.
    pub repaired: Option<String>,
    /// Remark of the transcriber.
    pub note: Option<String>,
    /// Notation of its formulas.
    pub notation: Notation,
    /// Point near which its formulas hold; `None` if they hold everywhere.
    pub near: Option<Approximation>,
    /// The place of the id in the file.
    pub span: Range<usize>,
    /// Content of the entry: an equation, a definition, a system, a listing or a number.
    pub kind: EntryKind,
}

/// Statement that formulas hold near a point, up to an order in the deviations from it.
#[derive(Clone, Debug)]
pub struct Approximation {
    /// Highest order in the deviations that is kept, at least 1.
    pub order: u32,
    /// The point, at least one value.
    pub values: Vec<PointValue>,
}

/// Value near which one variable stays.
#[derive(Clone, Debug)]
pub struct PointValue {
    /// Name of a coordinate, a time derivative, a speed or a reaction.
    pub name: String,
    /// Its symbol.
    pub symbol: Expr,
    /// The value, in parameters.
    pub value: Expr,
}

/// Kinds of content of an entry, with their data.
#[derive(Clone, Debug)]
pub enum EntryKind {
    /// A value of a derived quantity.
    Equation {
        /// The quantity.
        quantity: Quantity,
        /// The value, as printed.
        printed: Expr,
        /// Its text.
        text: String,
    },
    /// Definition of the text, which no derivation can contradict.
    Definition {
        /// The text.
        text: String,
    },
    /// A linear system.
    System(System),
    /// A program that computes the derivative of a state.
    Listing(Listing),
    /// A number.
    Initial(Initial),
}

/// matrix · unknowns = right, as printed. Any number of rows; as many columns as unknowns.
#[derive(Clone, Debug)]
pub struct System {
    /// Formulation that the system is compared with.
    pub formulation: Formulation,
    /// The frame of the components: for Newton–Euler only.
    pub frame: Option<usize>,
    /// u̇ for Kane, q̈ for Lagrange, u̇ and reactions for Newton–Euler; each once.
    pub unknowns: Vec<Expr>,
    /// Their names.
    pub unknown_names: Vec<String>,
    /// The matrix, row by row.
    pub matrix: Vec<Vec<Expr>>,
    /// Its text.
    pub matrix_texts: Vec<Vec<String>>,
    /// The right-hand sides.
    pub right: Vec<Expr>,
    /// Their texts.
    pub right_texts: Vec<String>,
    /// Ids of single entries of the matrix, with `{i}` for the row and `{j}` for the column.
    pub matrix_ids: Option<String>,
    /// Ids of single right-hand sides, with `{i}` for the row.
    pub right_ids: Option<String>,
}

/// A program that computes the derivative of a state (q, v): v is u, or q̇ for Lagrange.
#[derive(Clone, Debug)]
pub struct Listing {
    /// Formulation that the listing is compared with.
    pub formulation: Formulation,
    /// z(1), z(2), …: coordinates, then as many speeds, each once.
    pub state: Vec<Expr>,
    /// Their names.
    pub state_names: Vec<String>,
    /// dz(1), dz(2), … as assigned: before the division by the matrix, if there is one.
    pub derivative: Vec<Expr>,
    /// Their texts.
    pub derivative_texts: Vec<String>,
    /// E of dz = E \ dz for the second half of the state; square.
    pub matrix: Option<Vec<Vec<Expr>>>,
    /// Its text.
    pub matrix_texts: Option<Vec<Vec<String>>>,
}

/// A number of a parameter, or a value at the start.
#[derive(Clone, Debug)]
pub struct Initial {
    /// Values of one set belong together; a set has one value of a quantity.
    pub set: String,
    /// The symbol of a parameter, coordinate, coordinate's derivative or speed.
    pub quantity: Expr,
    /// Its name.
    pub name: String,
    /// The number: a term without symbols.
    pub value: Expr,
    /// Its text.
    pub text: String,
    /// Decimals as printed, for a plain number; `None` for a formula, which is exact.
    pub decimals: Option<u32>,
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
    /// The id of a row, which counts from 0, of the system `id`.
    #[must_use]
    pub fn row_id(&self, id: &str, row: usize) -> String {
        format!("{id}-row{}", row + 1)
    }

    /// The id of a single entry of the matrix, row and column from 0, if the file names them.
    #[must_use]
    pub fn matrix_id(&self, row: usize, column: usize) -> Option<String> {
        let template = self.matrix_ids.as_ref()?;
        Some(template.replace("{i}", &(row + 1).to_string()).replace("{j}", &(column + 1).to_string()))
    }

    /// The id of a single right-hand side, row from 0, if the file names them.
    #[must_use]
    pub fn right_id(&self, row: usize) -> Option<String> {
        Some(self.right_ids.as_ref()?.replace("{i}", &(row + 1).to_string()))
    }

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
    /// The id of dz(`at` + 1) of the listing `id`.
    #[must_use]
    pub fn derivative_id(&self, id: &str, at: usize) -> String {
        format!("{id}-dz{}", at + 1)
    }

    /// The id of an entry of the matrix of the listing `id`, row and column from 0.
    #[must_use]
    pub fn matrix_id(&self, id: &str, row: usize, column: usize) -> String {
        // Beyond 9 rows, 1 and 11 would read as 11 and 1.
        let comma = if self.state.len() > 18 { "," } else { "" };
        format!("{id}-E{}{comma}{}", row + 1, column + 1)
    }

    fn ids(&self, id: &str) -> Vec<String> {
        let mut ids: Vec<String> = (0..self.derivative.len()).map(|at| self.derivative_id(id, at)).collect();
        for (i, row) in self.matrix.iter().flatten().enumerate() {
            ids.extend((0..row.len()).map(|j| self.matrix_id(id, i, j)));
        }
        ids
    }
}

impl Entry {
    /// The ids of everything that gets a verdict of its own: the entry's id, or those of the rows and entries of a
    /// system or listing.
    #[must_use]
    pub fn ids(&self) -> Vec<String> {
        match &self.kind {
            EntryKind::System(system) => system.ids(&self.id),
            EntryKind::Listing(listing) => listing.ids(&self.id),
            EntryKind::Equation { .. } | EntryKind::Definition { .. } | EntryKind::Initial(_) => vec![self.id.clone()],
        }
    }
}
