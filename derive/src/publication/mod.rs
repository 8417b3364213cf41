//! Published derivations as data: every printed equation of a publication, to be judged one by one.
//!
//! A publication file belongs to a model. Its formulas are read into the arena of the model, before
//! [`crate::mechanics::derive_all`] is called. The arena of the derivations starts as a clone of the model's arena, so
//! that every handle stays valid there.
//!
//! Invariant: nothing is repaired or judged here. A wrong *form* of a file is an error; a wrong printed *equation* is
//! left for a comparison to find.
//!
//! Abbreviations are replaced with their formulas while the file is read; [`PrintedAbbreviations`] keeps the formulas
//! as printed. The names of derived quantities stay symbols, which no model can declare, until
//! [`QuantityNames::resolve_quantity_names`] replaces them with values. An entry can therefore be read, and its errors
//! found, before anything is derived.
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
mod entries;
mod labelled_equations;
mod named_files;
mod names;
mod own_coordinates;
mod printed;
mod programs;
mod publication_of_model;
mod publication_reader;
mod systems;

pub use names::printed_abbreviations::{Abbreviation, PrintedAbbreviations};
pub use names::quantity_names::QuantityNames;
pub(crate) use printed::equalities::has_right_side;
pub use programs::listing::Listing;
pub use publication_of_model::{
    hash_publication_of_model, is_publication_path, load_publication_of_model, publication_path_of_model,
};
pub use publication_reader::{load_publication, load_publication_in_coordinates, load_publication_with_files};
pub use systems::printed_system::System;
pub(crate) use systems::row_text::system_row_text;

use crate::algebra::Expr;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::Source;
use crate::mechanics::Quantity;
use std::ops::Range;
use std::sync::Arc;

/// Published derivation: the entries, names and abbreviations of a publication file.
#[derive(Clone, Debug)]
pub struct Publication {
    /// Text of the publication file, with the file's name.
    pub source: Source,
    /// Files of the author to which the publication file refers, as pairs (name, text), in alphabetical order.
    pub files: Vec<(String, Arc<Source>)>,
    /// Title of the publication; empty if the file has none.
    pub title: String,
    /// Description, in words, of the printed source that was transcribed; empty if the file has none.
    pub reference: String,
    /// Abbreviations of the publication, in the order of the file, as pairs (name, formula).
    pub abbreviations: Vec<(String, Expr)>,
    /// Coordinates and speeds that only the publication has, as pairs (name, formula in the model's variables).
    pub coordinates: Vec<(String, Expr)>,
    /// Coordinates and speeds of the model to which the publication gives another meaning, as pairs (name, formula in
    /// the model's variables).
    pub redefined: Vec<(String, Expr)>,
    /// Formulas as printed, in which abbreviations are symbols.
    pub shorthand: PrintedAbbreviations,
    /// Names that the publication gives to derived quantities: (name, quantity, symbol in the formulas).
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

/// Condition that formulas hold only near a point, up to an order in the deviations from the point.
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
    /// Printed definition, which no derived value can contradict.
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

/// Printed number: the value of a parameter, or an initial value.
#[derive(Clone, Debug)]
pub struct Initial {
    /// Name of the set to which the number belongs. A set has at most one number for each quantity.
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

impl Entry {
    /// Ids of all parts of the entry that are judged: the entry's own id, or the ids of the parts of a system or
    /// program.
    #[must_use]
    pub fn ids(&self) -> Vec<String> {
        match &self.kind {
            EntryKind::System(system) => system.ids(&self.id),
            EntryKind::Listing(listing) => listing.ids(&self.id),
            EntryKind::Equation { .. } | EntryKind::Definition { .. } | EntryKind::Initial(_) => vec![self.id.clone()],
        }
    }
}
