//! Pen that draws figures: a backend of the library plotters that writes SVG in few bytes. Strokes become paths of
//! relative steps, with one path for all successive strokes of the same look.
//!
//! Invariant: text that was written is never read again.

use super::curve_thinning::{keep_column_extremes, thin_line};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind, FontStyle};
use std::convert::Infallible;
use std::fmt::Write;

/// Pen that appends the SVG elements of a figure to a text.
pub struct Pen<'a> {
    /// Text with the elements written so far.
    out: &'a mut String,
    /// Width and height of the canvas, in canvas units.
    size: (u32, u32),
    /// Function that returns the dashes of strokes from their colour and width.
    dashes: Dashes,
    /// Path that collects the latest strokes; `None` after another kind of element.
    path: Option<Path>,
}

/// Function from red, green, blue and width in canvas units to the dashes of a stroke; `None` for a
/// solid line.
type Dashes = fn([u8; 3], u32) -> Option<&'static str>;

/// SVG path of successive strokes with the same look.
struct Path {
    /// SVG attributes of the path element, which determine its look.
    look: String,
    /// SVG commands of the path so far.
    data: String,
    /// End point of the latest stroke, in canvas units.
    at: BackendCoord,
}

impl<'a> Pen<'a> {
    /// Creates a pen for a canvas of the size (width, height) in canvas units. It appends to `out`.
    pub fn new(out: &'a mut String, size: (u32, u32), dashes: Dashes) -> Self {
        Self { out, size, dashes, path: None }
    }

    /// Writes the collected path as an element.
    fn end_path(&mut self) {
        if let Some(Path { look, data, .. }) = self.path.take() {
            let _ = writeln!(self.out, "<path {look} d=\"{data}\"/>");
        }
    }

    /// Returns the path for strokes of a look: the current path if it has the same look, else a new path.
    fn path(&mut self, look: String) -> &mut Path {
        if self.path.as_ref().is_some_and(|path| path.look != look) {
            self.end_path();
        }
        self.path.get_or_insert(Path { look, data: String::new(), at: (0, 0) })
    }
}

/// Returns a colour as `#` and six hexadecimal digits.
fn colour(colour: BackendColor) -> String {
    let (r, g, b) = colour.rgb;
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// Returns the SVG attribute of the opacity, with a space after it. Empty for an opaque colour.
fn opacity(colour: BackendColor) -> String {
    if colour.alpha < 1.0 { format!("opacity=\"{}\" ", colour.alpha) } else { String::new() }
}

/// Returns the SVG attributes of a stroke: colour, width, opacity and dashes.
fn stroke<S: BackendStyle>(style: &S, dashes: Dashes) -> String {
    let (colour_of, width) = (style.color(), style.stroke_width());
    let (r, g, b) = colour_of.rgb;
    let dashes = dashes([r, g, b], width).map_or_else(String::new, |list| format!(" stroke-dasharray=\"{list}\""));
    format!("fill=\"none\" {}stroke=\"{}\" stroke-width=\"{width}\"{dashes}", opacity(colour_of), colour(colour_of))
}

/// Escapes the characters of a text that have a meaning in SVG.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            other => out.push(other),
        }
    }
    out
}

/// Result of drawing an element, which cannot fail.
type DrawResult = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Pen<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> DrawResult {
        Ok(())
    }

    fn present(&mut self) -> DrawResult {
        self.end_path();
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> DrawResult {
        self.end_path();
        let ((x, y), opacity, fill) = (point, opacity(color), colour(color));
        let _ = writeln!(self.out, "<rect x=\"{x}\" y=\"{y}\" width=\"1\" height=\"1\" {opacity}fill=\"{fill}\"/>");
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> DrawResult {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> DrawResult {
        let places = thin_line(keep_column_extremes(path.into_iter().collect()));
        let look = stroke(style, self.dashes);
        self.path(look).line(&places);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, radius: u32, style: &S, fill: bool) -> DrawResult {
        let look = if fill {
            format!("{}fill=\"{}\"", opacity(style.color()), colour(style.color()))
        } else {
            stroke(style, self.dashes)
        };
        self.path(look).add_circle(center, radius);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> DrawResult {
        // Overlapping areas in one path would be drawn with a single shade, so that each area needs its own path.
        self.end_path();
        let look = format!("{}fill=\"{}\"", opacity(style.color()), colour(style.color()));
        let area = self.path(look);
        area.line(&thin_line(path.into_iter().collect()));
        area.data.push('z');
        self.end_path();
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> DrawResult {
        self.end_path();
        let ((x, y), (right, bottom)) = (upper_left, bottom_right);
        let (width, height, hue) = (right - x, bottom - y, colour(style.color()));
        let (fill, stroke) = if fill { (hue.as_str(), "none") } else { ("none", hue.as_str()) };
        let _ = writeln!(
            self.out,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" {}fill=\"{fill}\" stroke=\"{stroke}\"/>",
            opacity(style.color()),
        );
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, pos: BackendCoord) -> DrawResult {
        self.end_path();
        let side = match style.anchor().h_pos {
            HPos::Left => "start",
            HPos::Right => "end",
            HPos::Center => "middle",
        };
        let down = match style.anchor().v_pos {
            VPos::Top => "0.76em",
            VPos::Center => "0.5ex",
            VPos::Bottom => "-0.5ex",
        };
        let shape = match style.style() {
            FontStyle::Normal => String::new(),
            FontStyle::Bold => " font-weight=\"bold\"".to_owned(),
            other => format!(" font-style=\"{}\"", other.as_str()),
        };
        let ((x, y), opacity, fill) = (pos, opacity(style.color()), colour(style.color()));
        // The font size of plotters is 1.24 times as large.
        let size = style.size() / 1.24;
        let _ = writeln!(
            self.out,
            "<text x=\"{x}\" y=\"{y}\" dy=\"{down}\" text-anchor=\"{side}\" font-size=\"{size}\" {opacity}fill=\"{fill}\"\
             {shape}>\n{}\n</text>",
            escaped(text),
        );
        Ok(())
    }
}

impl Path {
    /// Adds a circle around (x, y) to the path, as two arcs. Lengths are in canvas units.
    fn add_circle(&mut self, (x, y): BackendCoord, radius: u32) {
        let radius = i32::try_from(radius).unwrap_or(i32::MAX / 2);
        self.line(&[(x - radius, y)]);
        let wide = 2 * radius;
        let _ = write!(self.data, "a{radius} {radius} 0 1 0 {wide} 0 {radius} {radius} 0 1 0-{wide} 0");
    }

    /// Adds a line to the path: a move to the first of `places`, then a step to each further place. Places are in
    /// canvas units.
    fn line(&mut self, places: &[BackendCoord]) {
        self.data.push('m');
        for (count, place) in places.iter().enumerate() {
            let (dx, dy) = (place.0 - self.at.0, place.1 - self.at.1);
            let space = if count == 0 || dx < 0 { "" } else { " " };
            let between = if dy < 0 { "" } else { " " };
            let _ = write!(self.data, "{space}{dx}{between}{dy}");
            self.at = *place;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Pen;
    use plotters::prelude::*;

    /// Goal: strokes are drawn at their places. Method: two strokes and a ring of the same look, an area and a name are
    /// compared with paths written by hand.
    #[test]
    fn strokes_of_one_look_are_one_path() {
        let mut out = String::new();
        {
            let canvas = Pen::new(&mut out, (100, 100), |_, _| None).into_drawing_area();
            let style = ShapeStyle { color: RGBColor(0xe3, 0xe3, 0xe3).into(), filled: false, stroke_width: 4 };
            canvas.draw(&PathElement::new(vec![(10, 20), (30, 15)], style)).unwrap();
            canvas.draw(&PathElement::new(vec![(0, 0), (5, 5), (5, 0)], style)).unwrap();
            canvas.draw(&Circle::new((9, 4), 3, style)).unwrap();
            canvas.draw(&Polygon::new(vec![(0, 0), (9, 0), (0, 9)], RGBColor(1, 2, 3).mix(0.25))).unwrap();
            canvas.draw(&Text::new("a < b", (7, 8), ("sans-serif", 12.4))).unwrap();
            canvas.present().unwrap();
        }
        assert_eq!(
            out,
            "<path fill=\"none\" stroke=\"#E3E3E3\" stroke-width=\"4\" \
             d=\"m10 20 20-5m-30-15 5 5 0-5m1 4a3 3 0 1 0 6 0 3 3 0 1 0-6 0\"/>\n\
             <path opacity=\"0.25\" fill=\"#010203\" d=\"m0 0 9 0-9 9z\"/>\n\
             <text x=\"7\" y=\"8\" dy=\"0.76em\" text-anchor=\"start\" font-size=\"10\" fill=\"#000000\">\na &lt; b\n</text>\n"
        );
    }
}
