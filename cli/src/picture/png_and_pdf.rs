//! PNG and PDF files of figures, made from their SVG.

use super::{CSS, MOST_PIXELS};
use crate::terminal::failure::Failure;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use tripos::Error;

/// Fonts DejaVu Sans, regular and bold, reduced to the characters that occur in labels.
const FONTS: [&[u8]; 2] =
    [include_bytes!("../../fonts/DejaVuSans.ttf"), include_bytes!("../../fonts/DejaVuSans-Bold.ttf")];
/// Name of the font family for all labels.
const FAMILY: &str = "DejaVu Sans";

/// Returns the bytes of a PNG of a figure, with `dpi` dots per inch.
///
/// # Errors
/// [`Failure`] if the figure has too many pixels.
pub fn png(svg: &str, dpi: u32) -> Result<Vec<u8>, Failure> {
    png_of(&parse_svg(svg)?, dpi)
}

/// Returns the bytes of a PDF of a figure: one page, with its fonts.
///
/// # Errors
/// [`Failure`] if the SVG cannot be read again, which no figure of this program causes.
pub fn pdf(svg: &str) -> Result<Vec<u8>, Failure> {
    pdf_of(&parse_svg(svg)?)
}

/// Parses the SVG of a figure, and lays out its text in the fonts of this program. `Err` if the SVG is invalid, which
/// no figure of this program causes.
fn parse_svg(svg: &str) -> Result<Tree, Failure> {
    let mut options = Options { font_family: FAMILY.to_owned(), ..Options::default() };
    let fonts = options.fontdb_mut();
    for font in FONTS {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family(FAMILY);
    Tree::from_str(svg, &options).map_err(|error| conversion_failure(&error))
}

/// Renders a parsed figure on a white background as a PNG. `Err` if the picture has too many pixels.
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
    let mut pixels = pixels.ok_or_else(|| conversion_failure(&"no picture of this size"))?;
    pixels.fill(Color::WHITE);
    resvg::render(tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    // The picture is painted on white and is opaque, so that its transparency can be dropped.
    let rgb: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|rgba| [rgba[0], rgba[1], rgba[2]]).collect();
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // A PNG file gives its resolution in dots per metre.
    let dots = (f64::from(dpi) / 0.0254).round();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1200 dots of an inch")]
    let dots = dots as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: dots, yppu: dots, unit: png::Unit::Meter }));
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&rgb)?;
        writer.finish()
    });
    written.map_err(|error| conversion_failure(&error))?;
    Ok(out)
}

/// Converts a parsed figure to a PDF.
/// `Err` if the conversion fails, which no input causes.
fn pdf_of(tree: &Tree) -> Result<Vec<u8>, Failure> {
    let page = svg2pdf::PageOptions { dpi: CSS };
    svg2pdf::to_pdf(tree, svg2pdf::ConversionOptions::default(), page).map_err(|error| conversion_failure(&error))
}

/// Returns the failure for a figure that could not be converted, which no input causes.
fn conversion_failure(error: &dyn std::fmt::Display) -> Failure {
    Error::Stopped(format!("the figure cannot be written as this kind of file: {error}")).into()
}

#[cfg(test)]
mod tests {
    use super::{parse_svg, png_of};

    fn drawn(text: &str, style: &str) -> Vec<u8> {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"30\" font-family=\"sans-serif\">\
             <text x=\"5\" y=\"20\" font-size=\"14\" {style}>{text}</text></svg>"
        );
        png_of(&parse_svg(&svg).unwrap(), 96).unwrap()
    }

    /// Goal: every character of a label is drawn. Method: each character that occurs in labels draws something, no two
    /// draw the same, and none draws the mark of a missing glyph.
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
