//! Figures as files: SVG as it is drawn, and PNG and PDF made of it.
//!
//! Invariant: a figure is the same on any machine. Letters of PNG and PDF come from the fonts in `cli/fonts`, never
//! from those of the system. PNG and PDF need the feature `pictures`: the libraries that make them take a third as long
//! to compile as all other code.

#[cfg(feature = "pictures")]
mod made;

use crate::failure::Failure;
use crate::output::text;
use std::path::Path;
use tripos_derive::plain::path_in_line;

/// Dots of an inch where nothing is said.
pub const DPI: u32 = 200;
/// Pixels of CSS, in which figures are measured, in an inch.
#[cfg(feature = "pictures")]
const CSS: f32 = 96.0;
/// Dots of an inch that make a picture.
const LEAST_DPI: u32 = 20;
const MOST_DPI: u32 = 1200;
/// Pixels of a picture that fit into memory anywhere.
#[cfg(feature = "pictures")]
const MOST_PIXELS: f32 = 2e8;

/// A kind of file that figures are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// SVG text as drawn, unchanged.
    Svg,
    /// An image of pixels.
    Png,
    /// A page of its size, with its fonts.
    Pdf,
}

/// The kind of figure that a file's name asks for by its ending; `more` is said of what else may be written.
///
/// # Errors
/// [`Failure::Refused`] of a name that asks for none, and of a kind that this program cannot write.
pub fn kind(path: &Path, more: &str) -> Result<Kind, Failure> {
    let kind = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => Kind::Svg,
        Some("png") => Kind::Png,
        Some("pdf") => Kind::Pdf,
        _ => {
            let what = format!("`{}` names no kind of figure", path_in_line(path));
            return Err(Failure::request(what, format!("give a file that ends in .svg, .png or .pdf{more}")));
        }
    };
    if kind != Kind::Svg && !cfg!(feature = "pictures") {
        return Err(left_out(path));
    }
    Ok(kind)
}

/// Dots of an inch that were asked for.
///
/// # Errors
/// [`Failure::Refused`] of a number that makes no picture.
pub fn checked_dpi(dpi: u32) -> Result<u32, Failure> {
    if (LEAST_DPI..=MOST_DPI).contains(&dpi) {
        return Ok(dpi);
    }
    Err(Failure::request(format!("--dpi is {dpi}"), format!("give a number from {LEAST_DPI} to {MOST_DPI}")))
}

/// Writes a figure, in the place of a file that is there; `dpi` counts for PNG alone.
///
/// # Errors
/// [`Failure`] if it has too many pixels, or cannot be written.
pub fn write(path: &Path, kind: Kind, svg: &str, dpi: u32) -> Result<(), Failure> {
    match kind {
        Kind::Svg => text(path, svg),
        Kind::Png | Kind::Pdf => made(path, kind, svg, dpi),
    }
}

#[cfg(feature = "pictures")]
fn made(path: &Path, kind: Kind, svg: &str, dpi: u32) -> Result<(), Failure> {
    let bytes = if kind == Kind::Png { made::png(svg, dpi) } else { made::pdf(svg) };
    crate::output::bytes(path, &bytes?)
}

#[cfg(not(feature = "pictures"))]
fn made(path: &Path, _: Kind, _: &str, _: u32) -> Result<(), Failure> {
    Err(left_out(path))
}

fn left_out(path: &Path) -> Failure {
    let what = format!("`{}` is a kind of figure that this program was built without", path_in_line(path));
    let help = "give a file that ends in .svg, or build with `--features pictures`";
    Failure::request(what, help.to_owned())
}
