//! Looks of curves and markers, and functions that draw curves, error bands and markers.

use super::canvas::{Canvas, draw_line, pixels_to_canvas_units, size_to_canvas_units};
use super::error::PlotError;
use plotters::prelude::*;

/// Opacity of an error band, from 0 (invisible) to 1.
const SHADE: f64 = 0.25;
/// Width of a marker's outline, px. No curve has this width, because strokes with the width and colour of a curve may
/// be dashed.
const OUTLINE: f64 = 1.5;

/// Look of a curve: line colour, width (px) and dashes, then marker colour and marker outline. The outline is in units
/// of the marker's radius; an empty outline means a circle.
pub struct Look(RGBColor, f64, &'static str, RGBColor, &'static [&'static [(f64, f64)]]);

/// Looks of curves; the index is the style number.
/// The order is: three standard formulations, reduced equations, five printed systems, five wrong systems, Pareto
/// front, seven methods, numeric solve, quadrature, formulations on request. Only wrong systems are red. Each look has
/// a different marker. The first is a thick light line that stays visible under thin dashed lines. No two looks have
/// both the same colour and the same width.
pub const LOOKS: [Look; 25] = [
    Look(RGBColor(0x56, 0xb4, 0xe9), 4.5, "", RGBColor(0x00, 0x72, 0xb2), &[]),
    Look(
        RGBColor(0x00, 0x9e, 0x73),
        2.0,
        "28 16",
        RGBColor(0x00, 0x9e, 0x73),
        &[&[(-1.0, 0.8), (1.0, 0.8), (0.0, -1.0), (-1.0, 0.8), (1.0, 0.8)]],
    ),
    Look(
        RGBColor(0x00, 0x00, 0x00),
        1.25,
        "5 13",
        RGBColor(0x00, 0x00, 0x00),
        &[&[(-0.9, -0.9), (0.9, 0.9)], &[(-0.9, 0.9), (0.9, -0.9)]],
    ),
    Look(
        RGBColor(0xe6, 0x9f, 0x00),
        2.0,
        "40 12 8 12",
        RGBColor(0xe6, 0x9f, 0x00),
        &[&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9), (-0.9, -0.9), (0.9, -0.9)]],
    ),
    Look(
        RGBColor(0xcc, 0x79, 0xa7),
        2.0,
        "12 12",
        RGBColor(0xcc, 0x79, 0xa7),
        &[&[(0.0, -1.2), (1.2, 0.0), (0.0, 1.2), (-1.2, 0.0), (0.0, -1.2), (1.2, 0.0)]],
    ),
    Look(
        RGBColor(0x00, 0x72, 0xb2),
        2.0,
        "52 12",
        RGBColor(0x00, 0x72, 0xb2),
        &[&[(-1.1, 0.0), (1.1, 0.0)], &[(0.0, -1.1), (0.0, 1.1)]],
    ),
    Look(
        RGBColor(0x33, 0x22, 0x88),
        2.0,
        "20 8",
        RGBColor(0x33, 0x22, 0x88),
        &[&[(-1.0, -0.8), (1.0, -0.8), (0.0, 1.0), (-1.0, -0.8), (1.0, -0.8)]],
    ),
    Look(RGBColor(0x8b, 0x5a, 0x2b), 2.0, "4 8 24 8", RGBColor(0x8b, 0x5a, 0x2b), &[&[(0.0, -1.2), (0.0, 1.2)]]),
    Look(RGBColor(0x99, 0x99, 0x33), 2.0, "8 6", RGBColor(0x99, 0x99, 0x33), &[&[(-1.2, 0.0), (1.2, 0.0)]]),
    Look(
        RGBColor(0xcc, 0x33, 0x11),
        2.0,
        "24 10",
        RGBColor(0xcc, 0x33, 0x11),
        &[&[(-1.1, 0.0), (1.1, 0.0)], &[(-0.6, -1.0), (0.6, 1.0)], &[(-0.6, 1.0), (0.6, -1.0)]],
    ),
    Look(
        RGBColor(0xcc, 0x33, 0x11),
        1.75,
        "8 8",
        RGBColor(0xcc, 0x33, 0x11),
        &[&[(0.0, 0.0), (0.0, 1.2)], &[(0.0, 0.0), (-1.0, -0.8)], &[(0.0, 0.0), (1.0, -0.8)]],
    ),
    Look(
        RGBColor(0xcc, 0x33, 0x11),
        2.25,
        "44 10",
        RGBColor(0xcc, 0x33, 0x11),
        &[&[(-1.0, -0.9), (1.0, 0.9), (1.0, -0.9), (-1.0, 0.9), (-1.0, -0.9), (1.0, 0.9)]],
    ),
    Look(
        RGBColor(0xcc, 0x33, 0x11),
        2.5,
        "30 8 6 8",
        RGBColor(0xcc, 0x33, 0x11),
        &[&[(-0.9, -1.0), (0.9, -1.0), (-0.9, 1.0), (0.9, 1.0), (-0.9, -1.0), (0.9, -1.0)]],
    ),
    Look(
        RGBColor(0xcc, 0x33, 0x11),
        2.75,
        "14 6",
        RGBColor(0xcc, 0x33, 0x11),
        &[&[(0.0, -1.1), (1.05, -0.35), (0.65, 0.9), (-0.65, 0.9), (-1.05, -0.35), (0.0, -1.1), (1.05, -0.35)]],
    ),
    Look(
        RGBColor(0xbb, 0xbb, 0xbb),
        4.5,
        "",
        RGBColor(0xbb, 0xbb, 0xbb),
        &[&[
            (-0.55, -1.0),
            (0.55, -1.0),
            (1.1, 0.0),
            (0.55, 1.0),
            (-0.55, 1.0),
            (-1.1, 0.0),
            (-0.55, -1.0),
            (0.55, -1.0),
        ]],
    ),
    Look(RGBColor(0x44, 0x77, 0xaa), 2.0, "", RGBColor(0x44, 0x77, 0xaa), &[&[(-1.0, 0.6), (0.0, -0.8), (1.0, 0.6)]]),
    Look(
        RGBColor(0x66, 0xcc, 0xee),
        2.0,
        "30 8",
        RGBColor(0x66, 0xcc, 0xee),
        &[&[(-1.0, -0.6), (0.0, 0.8), (1.0, -0.6)]],
    ),
    Look(
        RGBColor(0x22, 0x88, 0x33),
        2.0,
        "16 8",
        RGBColor(0x22, 0x88, 0x33),
        &[&[(0.7, -1.0), (-0.7, 0.0), (0.7, 1.0)]],
    ),
    Look(
        RGBColor(0xcc, 0xbb, 0x44),
        2.0,
        "40 8",
        RGBColor(0xcc, 0xbb, 0x44),
        &[&[(-0.7, -1.0), (0.7, 0.0), (-0.7, 1.0)]],
    ),
    Look(
        RGBColor(0xaa, 0x33, 0x77),
        2.0,
        "10 6",
        RGBColor(0xaa, 0x33, 0x77),
        &[&[(0.0, 0.0), (0.0, -1.2)], &[(0.0, 0.0), (-1.0, 0.8)], &[(0.0, 0.0), (1.0, 0.8)]],
    ),
    Look(
        RGBColor(0x00, 0x99, 0x88),
        2.0,
        "6 4 16 4",
        RGBColor(0x00, 0x99, 0x88),
        &[&[(-0.8, -1.0), (-0.8, 0.9), (0.9, 0.9)]],
    ),
    Look(
        RGBColor(0x55, 0x55, 0x55),
        2.0,
        "24 6 6 6",
        RGBColor(0x55, 0x55, 0x55),
        &[&[(0.0, 1.2), (0.0, -1.1)], &[(-0.8, -0.3), (0.0, -1.1), (0.8, -0.3)]],
    ),
    Look(
        RGBColor(0x77, 0x77, 0x77),
        1.25,
        "5 9",
        RGBColor(0x77, 0x77, 0x77),
        &[&[(-0.8, -1.0), (-0.8, 1.0)], &[(0.8, -1.0), (0.8, 1.0)], &[(-0.8, 0.0), (0.8, 0.0)]],
    ),
    Look(
        RGBColor(0xdd, 0xaa, 0x33),
        2.0,
        "16 6",
        RGBColor(0xdd, 0xaa, 0x33),
        &[&[(-0.9, -0.9), (0.9, -0.9), (-0.9, 0.9), (0.9, 0.9)]],
    ),
    Look(
        RGBColor(0x11, 0x77, 0x66),
        2.0,
        "36 6 4 6",
        RGBColor(0x11, 0x77, 0x66),
        &[&[(-1.0, -0.5), (1.0, -0.5)], &[(-1.0, 0.5), (1.0, 0.5)]],
    ),
];

#[cfg(test)]
impl Look {
    /// True if two looks can be mistaken for each other.
    pub fn is_like(&self, other: &Self) -> bool {
        self.4 == other.4 || (self.0 == other.0 && size_to_canvas_units(self.1) == size_to_canvas_units(other.1))
    }
}

/// Returns the look of a style number. Numbers beyond the last look begin again with the first.
pub fn look(style: usize) -> &'static Look {
    &LOOKS[style % LOOKS.len()]
}

/// Returns the dashes of curves with this colour and this width in canvas units; `None` for solid lines. Only curves
/// have strokes with these colours and widths.
pub fn dashes([r, g, b]: [u8; 3], width: u32) -> Option<&'static str> {
    let drawn = LOOKS.iter().find(|look| look.0 == RGBColor(r, g, b) && size_to_canvas_units(look.1) == width);
    drawn.map(|look| look.2).filter(|dashes| !dashes.is_empty())
}

/// Draws a curve through points, px.
/// `Err` if plotters fails.
pub fn draw_curve(canvas: &Canvas, points: &[(f64, f64)], look: &Look) -> Result<(), PlotError> {
    draw_line(canvas, points, look.1, look.0)
}

/// Draws the area between the edges `low` and `high`, px, in a pale shade of the curve's colour.
/// `Err` if plotters fails.
pub fn draw_band(canvas: &Canvas, low: &[(f64, f64)], high: &[(f64, f64)], look: &Look) -> Result<(), PlotError> {
    let corners = low
        .iter()
        .chain(high.iter().rev())
        .map(|(x, y)| (pixels_to_canvas_units(*x), pixels_to_canvas_units(*y)))
        .collect::<Vec<_>>();
    Ok(canvas.draw(&Polygon::new(corners, look.0.mix(SHADE)))?)
}

/// Draws the marker of a look around the point `middle`, px.
/// `Err` if plotters fails.
pub fn draw_marker(canvas: &Canvas, middle: (f64, f64), look: &Look) -> Result<(), PlotError> {
    let (x, y) = middle;
    let radius = 3.6;
    if look.4.is_empty() {
        let style = ShapeStyle { color: look.3.into(), filled: false, stroke_width: size_to_canvas_units(OUTLINE) };
        canvas.draw(&Circle::new(
            (pixels_to_canvas_units(x), pixels_to_canvas_units(y)),
            pixels_to_canvas_units(radius),
            style,
        ))?;
    }
    for outline in look.4 {
        let points: Vec<_> = outline.iter().map(|(dx, dy)| (x + radius * dx, y + radius * dy)).collect();
        draw_line(canvas, &points, OUTLINE, look.3)?;
    }
    Ok(())
}
