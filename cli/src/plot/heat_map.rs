//! Heat map of a table: rows and columns of coloured cells, each with its value as text.

use super::canvas::{Canvas, EDGE, draw_line, draw_rectangle, draw_text, size_to_canvas_units};
use super::curve_look::dashes;
use super::svg_pen::Pen;
use super::{Cell, HeatMap, LINE, PlotError, WIDTH, plot_text_width, svg_element, wrap_plot_note};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

/// Height of a row of a heat map, px.
const HEIGHT: f64 = 22.0;
/// Colours (red, green, blue) from the smallest to the largest value. Their lightness falls in equal steps, so that the
/// map is readable without colours.
const COLOURS: [(f64, f64, f64); 4] =
    [(247.0, 252.0, 245.0), (186.0, 228.0, 179.0), (253.0, 174.0, 97.0), (178.0, 60.0, 60.0)];
/// Colour of cells without a value.
const GREY: RGBColor = RGBColor(0xdd, 0xdd, 0xdd);

/// Draws a heat map as one `<svg>` element.
///
/// # Errors
/// [`PlotError`] if plotters fails, which does not happen in memory.
pub fn draw_heat(map: &HeatMap) -> Result<String, PlotError> {
    let left = map.rows.iter().map(|(name, _)| plot_text_width(name)).fold(40.0, f64::max) + 14.0;
    let width = (WIDTH - left - 4.0) / map.columns.len().max(1) as f64;
    let note = wrap_plot_note(&map.note, WIDTH - 20.0);
    let top = 2.0 * LINE + 12.0;
    let bottom = top + HEIGHT * map.rows.len() as f64;
    let height = bottom + 14.0 + LINE * note.len() as f64;
    let mut svg = String::new();
    {
        let canvas =
            Pen::new(&mut svg, (size_to_canvas_units(WIDTH), size_to_canvas_units(height)), dashes).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw_text(&canvas, &map.title, (4.0, LINE / 2.0 + 2.0), HPos::Left, FontStyle::Bold)?;
        for (at, name) in map.columns.iter().enumerate() {
            let x = left + (at as f64 + 0.5) * width;
            draw_text(&canvas, name, (x, top - LINE / 2.0 - 2.0), HPos::Center, FontStyle::Normal)?;
        }
        for (at, (name, cells)) in map.rows.iter().enumerate() {
            let y = top + at as f64 * HEIGHT;
            draw_text(&canvas, name, (left - 8.0, y + HEIGHT / 2.0), HPos::Right, FontStyle::Normal)?;
            for (column, cell) in cells.iter().enumerate() {
                draw_cell(&canvas, map, cell, (left + column as f64 * width, y), width)?;
            }
        }
        draw_line(&canvas, &[(left, top), (left, bottom)], 1.0, EDGE)?;
        for (at, text) in note.iter().enumerate() {
            draw_text(&canvas, text, (4.0, bottom + 14.0 + at as f64 * LINE), HPos::Left, FontStyle::Italic)?;
        }
        canvas.present()?;
    }
    Ok(svg_element(&svg, &map.title, height))
}

/// Draws a cell with its upper left corner at `at`, px: its colour and its text.
/// `Err` if plotters fails.
fn draw_cell(canvas: &Canvas, map: &HeatMap, cell: &Cell, at: (f64, f64), width: f64) -> Result<(), PlotError> {
    let (colour, text) = match cell {
        Cell::Value(value) if value.is_finite() => {
            (colour(*value, map.range), format!("{value:.0e}").replace('-', "−"))
        }
        Cell::Value(_) => (GREY, "—".to_owned()),
        Cell::Stopped(why) => (GREY, why.clone()),
    };
    draw_rectangle(canvas, at, (at.0 + width - 2.0, at.1 + HEIGHT - 2.0), colour)?;
    let middle = (at.0 + width / 2.0 - 1.0, at.1 + HEIGHT / 2.0 - 1.0);
    draw_text(canvas, &text, middle, HPos::Center, FontStyle::Normal)
}

/// Returns the colour of a value, on a logarithmic scale between the ends of `range`.
fn colour(value: f64, range: (f64, f64)) -> RGBColor {
    let (light, dark) = range;
    let part = (value.max(1e-300).log10() - light.log10()) / (dark.log10() - light.log10());
    let place = part.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let first = place.floor().min((COLOURS.len() - 2) as f64);
    let at = super::axis::truncate_to_integer(first).unsigned_abs() as usize;
    let (a, b, share) = (COLOURS[at], COLOURS[at + 1], place - first);
    let mix = |a: f64, b: f64| u8::try_from(super::axis::truncate_to_integer(a + (b - a) * share)).unwrap_or(u8::MAX);
    RGBColor(mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_run_from_light_to_dark() {
        let range = (1e-16, 1.0);
        assert_eq!(colour(1e-20, range), RGBColor(247, 252, 245));
        assert_eq!(colour(10.0, range), RGBColor(178, 60, 60));
        assert_eq!(colour(0.0, range), colour(1e-16, range));
    }

    #[test]
    fn a_map_draws_whatever_its_cells_hold() {
        let cells = vec![Cell::Value(1e-9), Cell::Value(f64::NAN), Cell::Stopped("singular 1.2 s".to_owned())];
        let columns = ["a", "b", "c"].map(str::to_owned).to_vec();
        let row = ("kane".to_owned(), cells);
        let map =
            HeatMap { title: "Error".to_owned(), columns, rows: vec![row], range: (1e-16, 1.0), note: String::new() };
        let svg = draw_heat(&map).unwrap();
        assert!(svg.contains("1e−9") && svg.contains("singular 1.2 s") && !svg.contains("NaN"), "{svg}");
    }
}
