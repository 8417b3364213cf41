//! Canvas of a figure, with functions that draw lines, rectangles and texts. The functions convert points and sizes in
//! pixels to the finer units of the canvas.

use super::axis::truncate_to_integer;
use super::error::PlotError;
use super::svg_pen::Pen;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Canvas on which a figure is drawn by the library plotters.
pub type Canvas<'a> = DrawingArea<Pen<'a>, Shift>;

/// Number of canvas units per pixel of a figure.
const FINE: f64 = 4.0;
/// Colour of all texts in a figure.
const TEXT: RGBColor = RGBColor(0x22, 0x22, 0x22);
/// Colour of the grid lines in a panel.
pub const GRID: RGBColor = RGBColor(0xe3, 0xe3, 0xe3);
/// Colour of the axes of a panel and of error bars.
pub const EDGE: RGBColor = RGBColor(0x88, 0x88, 0x88);

/// Draws a line through points; points and width in px.
/// `Err` if plotters fails.
pub fn draw_line(canvas: &Canvas, points: &[(f64, f64)], width: f64, color: RGBColor) -> Result<(), PlotError> {
    let mut points: Vec<_> =
        points.iter().map(|(x, y)| (pixels_to_canvas_units(*x), pixels_to_canvas_units(*y))).collect();
    points.dedup();
    let style = ShapeStyle { color: color.into(), filled: false, stroke_width: size_to_canvas_units(width) };
    Ok(canvas.draw(&PathElement::new(points, style))?)
}

/// Draws a filled rectangle with the opposite corners `a` and `b`, px.
/// `Err` if plotters fails.
pub fn draw_rectangle(canvas: &Canvas, a: (f64, f64), b: (f64, f64), color: RGBColor) -> Result<(), PlotError> {
    let corners = [
        (pixels_to_canvas_units(a.0), pixels_to_canvas_units(a.1)),
        (pixels_to_canvas_units(b.0), pixels_to_canvas_units(b.1)),
    ];
    Ok(canvas.draw(&Rectangle::new(corners, ShapeStyle { color: color.into(), filled: true, stroke_width: 0 }))?)
}

/// Writes a text at the point `at`, px. `side` is the part of the text that is placed at this point. `Err` if plotters
/// fails.
pub fn draw_text(canvas: &Canvas, text: &str, at: (f64, f64), side: HPos, style: FontStyle) -> Result<(), PlotError> {
    // Plotters divides a font size by 1.24.
    let font = FontDesc::new(FontFamily::SansSerif, 12.5 * 1.24 * FINE, style);
    let style = TextStyle::from(font).color(&TEXT).pos(Pos::new(side, VPos::Center));
    Ok(canvas.draw(&Text::new(text, (pixels_to_canvas_units(at.0), pixels_to_canvas_units(at.1)), style))?)
}

/// Converts a length in pixels to canvas units, rounded.
pub fn pixels_to_canvas_units(pixels: f64) -> i32 {
    truncate_to_integer((pixels * FINE).round())
}

/// Converts a size in pixels to canvas units, rounded and not negative.
pub fn size_to_canvas_units(pixels: f64) -> u32 {
    pixels_to_canvas_units(pixels).unsigned_abs()
}
