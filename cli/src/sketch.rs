//! A sketch as a picture: SVG, and LaTeX for a thesis.
//!
//! Invariant: both are the same paths and labels, with the looks of one table; text that came from a file is escaped
//! where it is written. Absent on purpose: geometry, which is [`tripos::pictures::sketch`]'s.

mod latex;
mod look;
mod svg;

pub use latex::picture;
pub use svg::{document, figure};

/// A coordinate of the sheet, in tenths of a px.
fn rounded(x: f64) -> String {
    // Not -0.
    ((x * 10.0).round() / 10.0 + 0.0).to_string()
}
