//! Line charts and heat maps as inline SVG.
//!
//! Lengths are pixels of a figure that is 1000 px wide. The canvas has several units per pixel, because plotters places
//! everything at whole numbers. Invariant: equal panels give equal bytes. Logarithmic axes show absolute values. A
//! drift with a sign is shown on a linear axis.

mod axis;
mod canvas;
mod curve_look;
mod curve_thinning;
mod error;
mod heat_map;
pub mod styles;
mod svg_pen;

pub use error::PlotError;
pub use heat_map::draw_heat;
pub use tripos::studies::figure::{Bounds, Cell, Figure, HeatMap, Panel, Scale, Series, figure_text_in_symbols};

use axis::Axis;
use canvas::{Canvas, EDGE, GRID, draw_line, draw_text, size_to_canvas_units};
use curve_look::{dashes, draw_band, draw_curve, draw_marker, look};
use curve_thinning::{thin_curve, thinned_marker_places};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;
use svg_pen::Pen;

/// Width of every figure, px.
const WIDTH: f64 = 1000.0;
/// Horizontal distance between two panels of a figure, px.
const GAP: f64 = 22.0;
/// Height of a line of text in a figure, px.
const LINE: f64 = 17.0;
/// Width, px, up to which an error band is not visible beside its curve. A band that is nowhere wider is not drawn.
const BAND: f64 = 1.0;
/// Largest number of names in a legend that all panels share. If there are more names, each panel has its own legend.
const MOST_NAMES: usize = 8;

/// Draws panels in a grid of `columns` columns, row by row, as one `<svg>` element. The panels
/// share a legend if it is short and unambiguous.
///
/// # Errors
/// [`PlotError`] if plotters fails, which does not happen in memory.
pub fn draw(panels: &[Panel], columns: usize) -> Result<String, PlotError> {
    let columns = columns.clamp(1, panels.len().max(1));
    let is_shared = shares_names(panels);
    let shared = if is_shared { legend_entries(panels, WIDTH) } else { Vec::new() };
    let own = |panel| {
        if is_shared { Vec::new() } else { legend_entries(std::slice::from_ref(panel), WIDTH / columns as f64 - 90.0) }
    };
    let plots: Vec<PanelLayout> = panels.iter().map(|panel| PanelLayout::new(panel, columns, own(panel))).collect();
    let top = if shared.is_empty() { 0.0 } else { legend_line_count(&shared) * LINE + 10.0 };
    // All panels have the same left margin, so that the time axes of a column are aligned.
    let left = 14.0 + plots.iter().map(|plot| plot.tick_width).fold(0.0, f64::max);
    let column = (WIDTH - GAP * (columns - 1) as f64) / columns as f64;
    let (mut corners, mut y) = (Vec::new(), top);
    for row in plots.chunks(columns) {
        let head = row.iter().map(PanelLayout::lines_above).fold(0.0, f64::max) * LINE + 6.0;
        corners.extend((0..row.len()).map(|at| ((column + GAP) * at as f64 + left, y + head)));
        let foot = row.iter().map(|plot| plot.foot.len()).max().unwrap_or(0) as f64 * LINE + 26.0;
        y += head + row[0].height + foot + 8.0;
    }
    let mut svg = String::new();
    {
        let canvas =
            Pen::new(&mut svg, (size_to_canvas_units(WIDTH), size_to_canvas_units(y)), dashes).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw_legend(&canvas, &shared, (4.0, 2.0))?;
        for ((panel, plot), corner) in panels.iter().zip(&plots).zip(&corners) {
            let below = panels
                .iter()
                .zip(&corners)
                .any(|(p, c)| c.0.total_cmp(&corner.0).is_eq() && c.1 > corner.1 && p.x_label == panel.x_label);
            let label = (!below).then_some(plot.x.label.as_str());
            plot.draw(&canvas, *corner, column - left - 10.0, label)?;
        }
        canvas.present()?;
    }
    Ok(svg_element(&svg, &figure_description(panels), y))
}

/// Returns the elements of a figure as an `<svg>` element with the title `about` and the height in
/// px.
fn svg_element(elements: &str, about: &str, height: f64) -> String {
    let about = about.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    format!(
        "<svg role=\"img\" aria-label=\"{about}\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" \
         height=\"{height}\" viewBox=\"0 0 {} {}\" stroke-linejoin=\"round\" \
         font-family=\"sans-serif\">\n<title>{about}</title>\n{elements}</svg>\n",
        size_to_canvas_units(WIDTH),
        size_to_canvas_units(height),
    )
}

/// Returns a description of a figure for its title: axes and curves.
fn figure_description(panels: &[Panel]) -> String {
    if panels.is_empty() {
        return "Empty figure".to_owned();
    }
    let panel =
        |p: &Panel| format!("{} against {}", figure_text_in_symbols(&p.y_label), figure_text_in_symbols(&p.x_label));
    let of = |panels: &[Panel]| {
        let entries = legend_entries(panels, WIDTH);
        let curves: Vec<&str> = entries.iter().map(|entry| entry.series.label.as_str()).collect();
        let curves = if curves.is_empty() { "none".to_owned() } else { curves.join(", ") };
        format!("{}. Curves: {curves}", panels.iter().map(panel).collect::<Vec<_>>().join("; "))
    };
    if shares_names(panels) { of(panels) } else { panels.chunks(1).map(of).collect::<Vec<_>>().join(". ") }
}

/// True if one legend can serve all panels: it is short, and no look belongs to two names in it.
fn shares_names(panels: &[Panel]) -> bool {
    let entries = legend_entries(panels, WIDTH);
    let is_clear = |LegendEntry { series, .. }: &LegendEntry| {
        let mut others = entries.iter().map(|entry| entry.series);
        others.all(|other| other.label == series.label || !std::ptr::eq(look(other.style), look(series.style)))
    };
    panels.len() == 1 || (entries.len() <= MOST_NAMES && entries.iter().all(is_clear))
}

/// Returns the number of text lines in a legend.
fn legend_line_count(entries: &[LegendEntry<'_>]) -> f64 {
    entries.last().map_or(0.0, |entry| entry.y / LINE + 1.0)
}

/// Entry of a legend: a curve with the place of its name.
struct LegendEntry<'a> {
    /// Curve whose name the legend entry shows.
    series: &'a Series,
    /// Distance of the entry to the right of the legend's upper left corner, px.
    x: f64,
    /// Distance of the entry below the legend's upper left corner, px.
    y: f64,
}

/// Draws a legend with its upper left corner at `corner`, px.
/// `Err` if plotters fails.
fn draw_legend(canvas: &Canvas, entries: &[LegendEntry<'_>], corner: (f64, f64)) -> Result<(), PlotError> {
    let (left, top) = corner;
    for LegendEntry { series, x, y } in entries {
        let (look, x, y) = (look(series.style), left + x, top + y + 9.0);
        draw_curve(canvas, &[(x, y), (x + 44.0, y)], look)?;
        draw_marker(canvas, (x + 22.0, y), look)?;
        draw_text(canvas, &series.label, (x + 52.0, y), HPos::Left, FontStyle::Normal)?;
    }
    Ok(())
}

/// Returns the entries of a legend that is `room` px wide: every label once, with its place. New labels of each panel
/// begin on a new line. A single curve with the name of its panel needs no entry.
fn legend_entries(panels: &[Panel], room: f64) -> Vec<LegendEntry<'_>> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    let (mut x, mut y) = (0.0, 0.0);
    for panel in panels {
        if x > 0.0 {
            (x, y) = (0.0, y + LINE);
        }
        for series in &panel.series {
            let is_alone = panel.series.len() == 1 && series.label == panel.title;
            if is_alone
                || entries.iter().any(|entry| entry.series.label == series.label && entry.series.style == series.style)
            {
                continue;
            }
            let width = 80.0 + plot_text_width(&series.label);
            if x > 0.0 && x + width > room {
                (x, y) = (0.0, y + LINE);
            }
            entries.push(LegendEntry { series, x, y });
            x += width;
        }
    }
    entries
}

/// Panel with its axes and texts, before its place on the canvas is known.
struct PanelLayout<'a> {
    /// Panel of the figure, with its curves.
    panel: &'a Panel,
    /// Horizontal axis of the panel.
    x: Axis,
    /// Vertical axis of the panel.
    y: Axis,
    /// Lines of text above the panel: title and label of the vertical axis.
    head: Vec<(String, FontStyle)>,
    /// Entries of the panel's own legend; empty if the panels share a legend.
    names: Vec<LegendEntry<'a>>,
    /// Lines of the note below the panel.
    foot: Vec<String>,
    /// Width of the longest tick text of the vertical axis, px.
    tick_width: f64,
    /// Height of the panel without its texts, px.
    height: f64,
}

impl<'a> PanelLayout<'a> {
    /// Chooses the axes and texts of a panel in a figure with this number of columns. `names` are the entries of the
    /// panel's own legend.
    fn new(panel: &'a Panel, columns: usize, names: Vec<LegendEntry<'a>>) -> Self {
        let points = || panel.series.iter().flat_map(|s| &s.points).filter(|p| panel.shows(**p));
        let per_axis = if columns == 1 { 10.0 } else { 5.0 };
        let bars = panel.series.iter().flat_map(|s| &s.spread).flat_map(|(low, high)| [*low, *high]);
        let bars = bars.filter(|x| panel.shows((*x, 1.0)));
        let x = match panel.x_scale {
            Scale::Linear => Axis::new(points().map(|p| p.0), &panel.x_label, 0.0, per_axis),
            Scale::Logarithmic => Axis::logarithmic(points().map(|p| p.0).chain(bars), &panel.x_label, per_axis),
        };
        let (values, count) = (points().map(|p| p.1), if columns == 1 { 6.0 } else { 4.0 });
        let y = match panel.scale {
            Scale::Linear => Axis::new(values, &panel.y_label, 0.06, count),
            Scale::Logarithmic => Axis::logarithmic(values, &panel.y_label, count),
        };
        let mut head = vec![(y.label.clone(), FontStyle::Normal)];
        if !panel.y_label.starts_with(panel.title.as_str()) {
            head.insert(0, (figure_text_in_symbols(&panel.title), FontStyle::Bold));
        }
        let foot = panel.note.as_ref().map_or(Vec::new(), |note| wrap_plot_note(note, WIDTH / columns as f64 - 90.0));
        let tick_width = y.ticks.iter().map(|(_, text)| plot_text_width(text)).fold(0.0, f64::max);
        // On two logarithmic axes the slopes of curves matter, so that such a panel is higher.
        let height = if columns == 1 || panel.x_scale == Scale::Logarithmic { 300.0 } else { 150.0 };
        Self { panel, x, y, head, names, foot, tick_width, height }
    }

    /// Returns the number of lines of text above the panel.
    fn lines_above(&self) -> f64 {
        self.head.len() as f64 + legend_line_count(&self.names)
    }

    /// Draws the panel with the upper left corner of its axes at `corner` and this `width`, px.
    /// `label` is the label of the horizontal axis; `None` if a panel below shows it.
    /// `Err` if plotters fails.
    fn draw(&self, canvas: &Canvas, corner: (f64, f64), width: f64, label: Option<&str>) -> Result<(), PlotError> {
        let (left, top) = corner;
        let (right, bottom) = (left + width, top + self.height);
        let head_top = top - 6.0 - self.lines_above() * LINE + LINE / 2.0;
        draw_legend(canvas, &self.names, (left, top - 6.0 - legend_line_count(&self.names) * LINE))?;
        for (at, (text, style)) in self.head.iter().enumerate() {
            draw_text(canvas, text, (left, head_top + at as f64 * LINE), HPos::Left, *style)?;
        }
        for (at, text) in &self.x.ticks {
            let x = left + at * width;
            draw_line(canvas, &[(x, top), (x, bottom)], 1.0, GRID)?;
            draw_text(canvas, text, (x, bottom + 11.0), HPos::Center, FontStyle::Normal)?;
        }
        for (at, text) in &self.y.ticks {
            let y = bottom - at * self.height;
            draw_line(canvas, &[(left, y), (right, y)], 1.0, GRID)?;
            draw_text(canvas, text, (left - 6.0, y), HPos::Right, FontStyle::Normal)?;
        }
        draw_line(canvas, &[(left, top), (left, bottom), (right, bottom)], 1.0, EDGE)?;
        if let Some(label) = label {
            draw_text(canvas, label, (left + width / 2.0, bottom + 26.0), HPos::Center, FontStyle::Normal)?;
        }
        for (at, text) in self.foot.iter().enumerate() {
            let y = bottom + if label.is_none() { 27.0 } else { 42.0 } + at as f64 * LINE;
            draw_text(canvas, text, (left, y), HPos::Left, FontStyle::Italic)?;
        }
        let shows = |p: (f64, f64)| self.panel.shows(p);
        let place = |(x, y): (f64, f64)| {
            (left + self.x.position_on_axis(x) * width, bottom - self.y.position_on_axis(y) * self.height)
        };
        for series in &self.panel.series {
            let edge = |y: &dyn Fn(&Bounds) -> f64| -> Vec<(f64, f64)> {
                let inside = |(x, y): (f64, f64)| (x, y.clamp(top, bottom));
                series
                    .band
                    .iter()
                    .filter(|bounds| (bounds.high - bounds.low).is_finite())
                    .map(|bounds| inside(place((bounds.x, y(bounds)))))
                    .collect()
            };
            let (low, high) = (edge(&|bounds| bounds.low), edge(&|bounds| bounds.high));
            if low.iter().zip(&high).any(|(low, high)| low.1 - high.1 > BAND) {
                draw_band(canvas, &low, &high, look(series.style))?;
            }
        }
        for (at, series) in self.panel.series.iter().enumerate() {
            let look = look(series.style);
            for run in series.points.split(|p| !shows(*p)).filter(|run| !run.is_empty()) {
                let run: Vec<_> = run.iter().map(|p| place(*p)).collect();
                draw_curve(canvas, &thin_curve(&run), look)?;
                let share = (at as f64 + 0.5) / self.panel.series.len() as f64;
                let markers = if series.spread.is_empty() { thinned_marker_places(&run, width, share) } else { run };
                for point in markers {
                    draw_marker(canvas, point, look)?;
                }
            }
            for ((low, high), (_, y)) in series.spread.iter().zip(&series.points) {
                if shows((*low, *y)) && shows((*high, *y)) {
                    draw_line(canvas, &[place((*low, *y)), place((*high, *y))], 1.0, EDGE)?;
                }
            }
        }
        if !self.panel.series.iter().any(|s| s.points.iter().any(|p| shows(*p))) {
            let middle = (left + width / 2.0, top + self.height / 2.0);
            draw_text(canvas, "no finite values", middle, HPos::Center, FontStyle::Italic)?;
        }
        Ok(())
    }
}

/// Breaks a text into lines of about `width` px.
fn wrap_plot_note(text: &str, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if plot_text_width(line) + plot_text_width(word) < width => line.extend([" ", word]),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Returns the estimated width of a text in px. The estimate is slightly too large, because the font is not known.
fn plot_text_width(text: &str) -> f64 {
    7.0 * text.chars().count() as f64
}

#[cfg(test)]
mod tests;
