//! Figures as files: SVG as it is drawn, and PNG and PDF made from it.
//!
//! Invariant: a figure is the same on any machine. Letters of PNG and PDF come from the fonts in `cli/fonts`, never
//! from those of the system. PNG and PDF need the feature `pictures`: compiling their libraries adds a third to the
//! compile time.

#[cfg(feature = "pictures")]
mod formats;

use crate::failure::Failure;
use crate::output::text;
use std::path::Path;
use tripos_derive::plain::path_in_line;

/// Resolution of a PNG if no option states it, in dots per inch.
pub const DPI: u32 = 200;
/// CSS pixels per inch, the unit in which figures are measured.
#[cfg(feature = "pictures")]
const CSS: f32 = 96.0;
/// Smallest resolution of a PNG that is accepted, in dots per inch; `MOST_DPI` is the largest.
const LEAST_DPI: u32 = 20;
const MOST_DPI: u32 = 1200;
/// Largest number of pixels of a PNG: such a picture fits into memory everywhere.
#[cfg(feature = "pictures")]
const MOST_PIXELS: f32 = 2e8;

/// Kind of a figure's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// SVG text as it is drawn, unchanged.
    Svg,
    /// PNG, an image of pixels.
    Png,
    /// PDF with a page of the figure's size, and its fonts.
    Pdf,
}

/// Kind of a figure's file, by the ending of its name; `more` completes the help of the error.
///
/// # Errors
/// [`Failure::Refused`] for an unknown ending, and for a kind that this program cannot write.
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

/// Checks the resolution of a picture, in dots per inch.
///
/// # Errors
/// [`Failure::Refused`] for a resolution below `LEAST_DPI` or above `MOST_DPI`.
pub fn checked_dpi(dpi: u32) -> Result<u32, Failure> {
    if (LEAST_DPI..=MOST_DPI).contains(&dpi) {
        return Ok(dpi);
    }
    Err(Failure::request(format!("--dpi is {dpi}"), format!("give a number from {LEAST_DPI} to {MOST_DPI}")))
}

/// Writes a figure to a file, and replaces an existing one; `dpi` is used only for PNG.
///
/// # Errors
/// [`Failure`] if the figure has too many pixels, or cannot be written.
pub fn write(path: &Path, kind: Kind, svg: &str, dpi: u32) -> Result<(), Failure> {
    match kind {
        Kind::Svg => text(path, svg),
        Kind::Png | Kind::Pdf => made(path, kind, svg, dpi),
    }
}

#[cfg(feature = "pictures")]
fn made(path: &Path, kind: Kind, svg: &str, dpi: u32) -> Result<(), Failure> {
    let bytes = if kind == Kind::Png { formats::png(svg, dpi) } else { formats::pdf(svg) };
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
