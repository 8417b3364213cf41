//! Figures as files: SVG as it is drawn, and PNG and PDF made of it.
//!
//! Invariant: a figure is the same on any machine. Letters of PNG and PDF come from the fonts in `cli/fonts`, never from those of the system.

use crate::failure::Failure;
use crate::output::{bytes, text};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::path::Path;
use tripos::Error;
use tripos_derive::plain::path_in_line;

/// Regular and bold, cut down to what labels need.
const FONTS: [&[u8]; 2] = [include_bytes!("../fonts/DejaVuSans.ttf"), include_bytes!("../fonts/DejaVuSans-Bold.ttf")];
const FAMILY: &str = "DejaVu Sans";
/// Dots of an inch where nothing is said.
pub const DPI: u32 = 200;
/// Pixels of CSS, in which figures are measured, in an inch.
const CSS: f32 = 96.0;
/// Dots of an inch that make a picture.
const LEAST_DPI: u32 = 20;
const MOST_DPI: u32 = 1200;
/// Pixels of a picture that fit into memory anywhere.
const MOST_PIXELS: f32 = 2e8;

/// A kind of file that figures are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// What is drawn, unchanged.
    Svg,
    /// Pixels.
    Png,
    /// A page of its size, with its fonts.
    Pdf,
}

impl Kind {
    /// By the ending of a file's name.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()? {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            "pdf" => Some(Self::Pdf),
            _ => None,
        }
    }
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
        Kind::Png => bytes(path, &png_of(&tree(svg)?, dpi)?),
        Kind::Pdf => bytes(path, &pdf_of(&tree(svg)?)?),
    }
}

/// What is drawn, with its letters in their places.
fn tree(svg: &str) -> Result<Tree, Failure> {
    let mut options = Options { font_family: FAMILY.to_owned(), ..Options::default() };
    let fonts = options.fontdb_mut();
    for font in FONTS {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family(FAMILY);
    Tree::from_str(svg, &options).map_err(|error| failed(&error))
}

fn png_of(tree: &Tree, dpi: u32) -> Result<Vec<u8>, Failure> {
    let scale = dpi as f32 / CSS;
    let size = tree.size();
    let (width, height) = ((size.width() * scale).round(), (size.height() * scale).round());
    if width * height > MOST_PIXELS {
        let what = format!("the figure would have {width} × {height} pixels");
        return Err(Failure::request(
            what,
            "give a smaller --dpi, fewer panels, or a file that ends in .pdf".to_owned(),
        ));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sizes above 0 and below 2e8")]
    let pixels = Pixmap::new((width as u32).max(1), (height as u32).max(1));
    let mut pixels = pixels.ok_or_else(|| failed(&"no picture of this size"))?;
    pixels.fill(Color::WHITE);
    resvg::render(tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    // Nothing shines through what is painted on white.
    let rgb: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|rgba| [rgba[0], rgba[1], rgba[2]]).collect();
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // Dots of a metre.
    let dots = (f64::from(dpi) / 0.0254).round();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1200 dots of an inch")]
    let dots = dots as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: dots, yppu: dots, unit: png::Unit::Meter }));
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&rgb)?;
        writer.finish()
    });
    written.map_err(|error| failed(&error))?;
    Ok(out)
}

fn pdf_of(tree: &Tree) -> Result<Vec<u8>, Failure> {
    let page = svg2pdf::PageOptions { dpi: CSS };
    svg2pdf::to_pdf(tree, svg2pdf::ConversionOptions::default(), page).map_err(|error| failed(&error))
}

/// A figure of ours that cannot be made into another kind of file, which no input causes.
fn failed(error: &dyn std::fmt::Display) -> Failure {
    Error::Stopped(format!("the figure cannot be written as this kind of file: {error}")).into()
}

/// Refuses a file that is no kind of figure.
pub fn unknown(path: &Path, more: &str) -> Failure {
    let what = format!("`{}` names no kind of figure", path_in_line(path));
    Failure::request(what, format!("give a file that ends in .svg, .png or .pdf{more}"))
}

#[cfg(test)]
mod tests {
    use super::{png_of, tree};

    fn drawn(text: &str, style: &str) -> Vec<u8> {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"30\" font-family=\"sans-serif\">\
             <text x=\"5\" y=\"20\" font-size=\"14\" {style}>{text}</text></svg>"
        );
        png_of(&tree(&svg).unwrap(), 96).unwrap()
    }

    /// Goal: no label has a hole. Method: each sign that labels are made of draws something, and nothing that two of them share, or that a sign without a glyph draws.
    #[test]
    fn the_fonts_have_every_sign_of_labels() {
        for style in ["", "font-weight=\"bold\""] {
            let mut seen = vec![drawn("", style), drawn("\u{4e16}", style)];
            let signs = "q̇ q̈ q u̇ α β γ δ ε ζ η θ κ λ μ ν ξ ρ σ τ φ χ ψ ω Δ Θ Λ Ξ Σ Φ Ψ Ω ₀ ₁ ₂ ₃ ₄ ₅ ₆ ₇ ₈ ₉ ² ³ · × − – — … ° ± √ ∞ ∂ ∫ ≤ ≥ ≠ → é ü ß Ł";
            for sign in signs.split(' ') {
                let picture = drawn(sign, style);
                assert!(!seen.contains(&picture), "{sign} {style}");
                seen.push(picture);
            }
        }
        assert_ne!(drawn("q", ""), drawn("q", "font-weight=\"bold\""));
    }
}
