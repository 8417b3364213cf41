//! Figures as files: the SVG text itself, or PNG and PDF made from it.
//!
//! Invariant: a figure is the same on every machine. The letters in PNG and PDF come from the fonts in `cli/fonts`,
//! never from fonts of the system. PNG and PDF need the feature `pictures`, because their libraries increase the
//! compile time by a third.

#[cfg(feature = "pictures")]
mod png_and_pdf;

use super::files::output_files::write_text_file;
use super::terminal::failure::Failure;
use std::path::Path;
use tripos_derive::plain_text::path_as_plain_text;

/// Default resolution of a PNG, in dots per inch.
pub const DPI: u32 = 200;
/// Number of CSS pixels per inch. Figures are measured in CSS pixels.
#[cfg(feature = "pictures")]
const CSS: f32 = 96.0;
/// Smallest accepted resolution of a PNG, in dots per inch.
const LEAST_DPI: u32 = 20;
/// Largest accepted resolution of a PNG, in dots per inch.
const MOST_DPI: u32 = 1200;
/// Largest number of pixels of a PNG, chosen so that the picture fits into memory.
#[cfg(feature = "pictures")]
const MOST_PIXELS: f32 = 2e8;

/// File format of a figure: SVG, PNG or PDF.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// SVG text, as the figure is drawn.
    Svg,
    /// PNG image, made from the SVG at a given resolution.
    Png,
    /// PDF with one page of the figure's size, and its fonts.
    Pdf,
}

/// Returns the file format of a figure, by the extension of its file name. `more` is appended to the help of the error.
///
/// # Errors
/// [`Failure::Refused`] for an unknown extension, and for a format that is not built into this program.
pub fn picture_format(path: &Path, more: &str) -> Result<PictureFormat, Failure> {
    let kind = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => PictureFormat::Svg,
        Some("png") => PictureFormat::Png,
        Some("pdf") => PictureFormat::Pdf,
        _ => {
            let what = format!("`{}` names no kind of figure", path_as_plain_text(path));
            return Err(Failure::request(what, format!("give a file that ends in .svg, .png or .pdf{more}")));
        }
    };
    if kind != PictureFormat::Svg && !cfg!(feature = "pictures") {
        return Err(missing_format_failure(path));
    }
    Ok(kind)
}

/// Checks the resolution of a picture in dots per inch, and returns it.
///
/// # Errors
/// [`Failure::Refused`] for a resolution below `LEAST_DPI` or above `MOST_DPI`.
pub fn check_dpi(dpi: u32) -> Result<u32, Failure> {
    if (LEAST_DPI..=MOST_DPI).contains(&dpi) {
        return Ok(dpi);
    }
    Err(Failure::request(format!("--dpi is {dpi}"), format!("give a number from {LEAST_DPI} to {MOST_DPI}")))
}

/// Writes a figure to a file, and replaces an existing file. `dpi` is used only for PNG.
///
/// # Errors
/// [`Failure`] if the figure has too many pixels, or if the file cannot be written.
pub fn write_picture(path: &Path, kind: PictureFormat, svg: &str, dpi: u32) -> Result<(), Failure> {
    match kind {
        PictureFormat::Svg => write_text_file(path, svg),
        PictureFormat::Png | PictureFormat::Pdf => write_converted_picture(path, kind, svg, dpi),
    }
}

#[cfg(feature = "pictures")]
fn write_converted_picture(path: &Path, kind: PictureFormat, svg: &str, dpi: u32) -> Result<(), Failure> {
    let bytes = if kind == PictureFormat::Png { png_and_pdf::png(svg, dpi) } else { png_and_pdf::pdf(svg) };
    crate::files::output_files::write_binary_file(path, &bytes?)
}

#[cfg(not(feature = "pictures"))]
fn write_converted_picture(path: &Path, _: PictureFormat, _: &str, _: u32) -> Result<(), Failure> {
    Err(missing_format_failure(path))
}

/// Returns the failure for a file format that is not built into this program.
fn missing_format_failure(path: &Path) -> Failure {
    let what = format!("`{}` is a kind of figure that this program was built without", path_as_plain_text(path));
    let help = "give a file that ends in .svg, or build with `--features pictures`";
    Failure::request(what, help.to_owned())
}
