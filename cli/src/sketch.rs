//! Sketch of a mechanism as a picture: SVG, and LaTeX for a document.
//!
//! Invariant: both pictures have equal paths and labels, with the looks of one table; text from a file is escaped when
//! it is written. Absent on purpose: geometry, which is in [`tripos::pictures::sketch`].

mod latex;
mod look;
mod svg;

pub use latex::picture;
pub use svg::{document, figure};

/// Coordinate of the sheet as text, rounded to tenths of a px.
fn rounded(x: f64) -> String {
    // The sum with 0 removes the sign of -0.
    ((x * 10.0).round() / 10.0 + 0.0).to_string()
}
