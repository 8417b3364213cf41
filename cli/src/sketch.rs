//! Sketch of a mechanism as a picture, in SVG or in LaTeX.
//!
//! Invariant: both pictures have the same paths and labels, with looks from one table. Text from a file is escaped when
//! it is written. The geometry comes from [`tripos::pictures::sketch`].

mod latex;
mod look;
mod svg;

pub use latex::tikz_picture;
pub use svg::{sketch_svg_element, sketch_svg_file};

/// Returns a coordinate of the drawing as text, rounded to tenths of a pixel.
fn sketch_coordinate_text(x: f64) -> String {
    // The sum with 0 removes the sign of -0.
    ((x * 10.0).round() / 10.0 + 0.0).to_string()
}
