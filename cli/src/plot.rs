//! Line plots as inline SVG.
//!
//! Lengths are pixels of a figure 1000 wide. The canvas has [`FINE`] units to a pixel, because plotters
//! places everything at whole numbers. Invariant: the same panels give the same bytes. Absent on
//! purpose: logarithmic axes, which hide the sign of a drift.

mod axis;
mod thin;

pub use axis::pretty;

use axis::{Axis, whole};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::fmt;
use thin::{marked, thin};

/// One curve.
pub struct Series {
    /// Its name in the legend.
    pub label: String,
    /// Picks colour, dashes and marker: 0 Kane, 1 Lagrange, 2 Newton–Euler, then others.
    pub style: usize,
    /// (x, y); the curve breaks where a value is not finite.
    pub points: Vec<(f64, f64)>,
}

/// One coordinate system.
pub struct Panel {
    /// The title; left out where `y_label` begins with it.
    pub title: String,
    /// Horizontal quantity, as `t [s]`.
    pub x_label: String,
    /// Vertical quantity, as `T + V [J]`.
    pub y_label: String,
    /// The curves, the first one drawn lowest.
    pub series: Vec<Series>,
    /// What to know about the curves, such as where one ends early.
    pub note: Option<String>,
}

/// Plotters could not draw.
#[derive(Debug)]
pub struct PlotError(String);

impl fmt::Display for PlotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for PlotError {}

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for PlotError {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        Self(error.to_string())
    }
}

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const FINE: f64 = 4.0;
const WIDTH: f64 = 1000.0;
const GAP: f64 = 22.0;
const LINE: f64 = 17.0;
const TEXT: RGBColor = RGBColor(0x22, 0x22, 0x22);
const GRID: RGBColor = RGBColor(0xe3, 0xe3, 0xe3);
const EDGE: RGBColor = RGBColor(0x88, 0x88, 0x88);
/// Width of a marker's outline, unlike that of any curve.
const OUTLINE: f64 = 1.5;

/// Line colour, width and dashes, marker colour and outline in units of its radius; no outline: a circle.
struct Look(RGBColor, f64, &'static str, RGBColor, &'static [&'static [(f64, f64)]]);

/// Colours of Okabe and Ito. A thick light line lies under thin dashed ones, so equal curves all show.
const LOOKS: [Look; 6] = [
    Look(RGBColor(0x56, 0xb4, 0xe9), 4.5, "", RGBColor(0x00, 0x72, 0xb2), &[]),
    Look(
        RGBColor(0xd5, 0x5e, 0x00),
        2.0,
        "28 16",
        RGBColor(0xd5, 0x5e, 0x00),
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
        RGBColor(0x00, 0x9e, 0x73),
        2.0,
        "40 12 8 12",
        RGBColor(0x00, 0x9e, 0x73),
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
        RGBColor(0xe6, 0x9f, 0x00),
        2.0,
        "52 12",
        RGBColor(0xe6, 0x9f, 0x00),
        &[&[(-1.1, 0.0), (1.1, 0.0)], &[(0.0, -1.1), (0.0, 1.1)]],
    ),
];

/// Panels in a grid, row by row, with one legend, as one `<svg>` element.
///
/// # Errors
/// [`PlotError`] if plotters fails, which it does not when it writes to memory.
pub fn draw(panels: &[Panel], columns: usize) -> Result<String, PlotError> {
    let columns = columns.clamp(1, panels.len().max(1));
    let plots: Vec<Plot> = panels.iter().map(|panel| Plot::new(panel, columns)).collect();
    let legend = legend(panels);
    let top = legend.last().map_or(0.0, |(_, _, y)| y + LINE + 8.0);
    // One left edge for all, so that the time axes of a column stand under each other.
    let left = 14.0 + plots.iter().map(|plot| plot.tick_width).fold(0.0, f64::max);
    let column = (WIDTH - GAP * (columns - 1) as f64) / columns as f64;
    let (mut corners, mut y) = (Vec::new(), top);
    for row in plots.chunks(columns) {
        let head = row.iter().map(|plot| plot.head.len()).max().unwrap_or(0) as f64 * LINE + 6.0;
        corners.extend((0..row.len()).map(|at| ((column + GAP) * at as f64 + left, y + head)));
        let foot = row.iter().map(|plot| plot.foot.len()).max().unwrap_or(0) as f64 * LINE + 26.0;
        y += head + row[0].height + foot + 8.0;
    }
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (extent(WIDTH), extent(y))).into_drawing_area();
        canvas.fill(&WHITE)?;
        for (series, x, y) in &legend {
            let look = &LOOKS[series.style % LOOKS.len()];
            curve(&canvas, &[(*x, *y + 9.0), (*x + 44.0, *y + 9.0)], look)?;
            marker(&canvas, (*x + 22.0, *y + 9.0), look)?;
            write(&canvas, &series.label, (*x + 52.0, *y + 9.0), HPos::Left, FontStyle::Normal)?;
        }
        for ((panel, plot), corner) in panels.iter().zip(&plots).zip(&corners) {
            let below = panels
                .iter()
                .zip(&corners)
                .any(|(p, c)| c.0.total_cmp(&corner.0).is_eq() && c.1 > corner.1 && p.x_label == panel.x_label);
            plot.draw(&canvas, *corner, column - left - 10.0, below)?;
        }
        canvas.present()?;
    }
    Ok(finish(&svg, &describe(panels), y))
}

/// The document of plotters as an element with dashes and a name.
fn finish(svg: &str, about: &str, height: f64) -> String {
    let body = svg.split_once('>').map_or("", |(_, body)| body).trim_start();
    let about = about.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let mut out = format!(
        "<svg role=\"img\" aria-label=\"{about}\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" \
         height=\"{height}\" viewBox=\"0 0 {} {}\" stroke-linejoin=\"round\">\n<title>{about}</title>\n{body}",
        extent(WIDTH),
        extent(height),
    );
    // Plotters cuts a dashed line into elements; one attribute does the same. Only curves have this stroke.
    for Look(RGBColor(r, g, b), width, dashes, ..) in LOOKS.iter().filter(|look| !look.2.is_empty()) {
        let stroke = format!("stroke=\"#{r:02X}{g:02X}{b:02X}\" stroke-width=\"{}\"", extent(*width));
        out = out.replace(&stroke, &format!("{stroke} stroke-dasharray=\"{dashes}\""));
    }
    out
}

fn describe(panels: &[Panel]) -> String {
    if panels.is_empty() {
        return "Empty figure".to_owned();
    }
    let panel = |p: &Panel| format!("{} against {}", pretty(&p.y_label), pretty(&p.x_label));
    let curves: Vec<&str> = legend(panels).iter().map(|(series, ..)| series.label.as_str()).collect();
    let curves = if curves.is_empty() { "none".to_owned() } else { curves.join(", ") };
    format!("{}. Curves: {curves}", panels.iter().map(panel).collect::<Vec<_>>().join("; "))
}

/// Every label once, with the place of its entry.
fn legend(panels: &[Panel]) -> Vec<(&Series, f64, f64)> {
    let mut entries: Vec<(&Series, f64, f64)> = Vec::new();
    let (mut x, mut y) = (4.0, 2.0);
    for series in panels.iter().flat_map(|panel| &panel.series) {
        if entries.iter().any(|(known, ..)| known.label == series.label && known.style == series.style) {
            continue;
        }
        let width = 80.0 + text_width(&series.label);
        if x > 4.0 && x + width > WIDTH {
            (x, y) = (4.0, y + LINE);
        }
        entries.push((series, x, y));
        x += width;
    }
    entries
}

/// A panel with its axes, before its place is known.
struct Plot<'a> {
    panel: &'a Panel,
    x: Axis,
    y: Axis,
    head: Vec<(String, FontStyle)>,
    foot: Vec<String>,
    tick_width: f64,
    height: f64,
}

impl<'a> Plot<'a> {
    fn new(panel: &'a Panel, columns: usize) -> Self {
        let points = || panel.series.iter().flat_map(|s| &s.points).filter(|p| usable(**p));
        let per_axis = if columns == 1 { 10.0 } else { 5.0 };
        let x = Axis::new(points().map(|p| p.0), &panel.x_label, 0.0, per_axis);
        let y = Axis::new(points().map(|p| p.1), &panel.y_label, 0.06, if columns == 1 { 6.0 } else { 4.0 });
        let mut head = vec![(y.label.clone(), FontStyle::Normal)];
        if !panel.y_label.starts_with(panel.title.as_str()) {
            head.insert(0, (pretty(&panel.title), FontStyle::Bold));
        }
        let foot = panel.note.as_ref().map_or(Vec::new(), |note| wrap(note, WIDTH / columns as f64 - 90.0));
        let tick_width = y.ticks.iter().map(|(_, text)| text_width(text)).fold(0.0, f64::max);
        Self { panel, x, y, head, foot, tick_width, height: if columns == 1 { 300.0 } else { 150.0 } }
    }

    fn draw(&self, canvas: &Canvas, (left, top): (f64, f64), width: f64, below: bool) -> Result<(), PlotError> {
        let (right, bottom) = (left + width, top + self.height);
        let head_top = top - 6.0 - self.head.len() as f64 * LINE + LINE / 2.0;
        for (at, (text, style)) in self.head.iter().enumerate() {
            write(canvas, text, (left, head_top + at as f64 * LINE), HPos::Left, *style)?;
        }
        for (at, text) in &self.x.ticks {
            let x = left + at * width;
            line(canvas, &[(x, top), (x, bottom)], 1.0, GRID)?;
            write(canvas, text, (x, bottom + 11.0), HPos::Center, FontStyle::Normal)?;
        }
        for (at, text) in &self.y.ticks {
            let y = bottom - at * self.height;
            line(canvas, &[(left, y), (right, y)], 1.0, GRID)?;
            write(canvas, text, (left - 6.0, y), HPos::Right, FontStyle::Normal)?;
        }
        line(canvas, &[(left, top), (left, bottom), (right, bottom)], 1.0, EDGE)?;
        if !below {
            write(canvas, &self.x.label, (left + width / 2.0, bottom + 26.0), HPos::Center, FontStyle::Normal)?;
        }
        for (at, text) in self.foot.iter().enumerate() {
            let y = bottom + if below { 27.0 } else { 42.0 } + at as f64 * LINE;
            write(canvas, text, (left, y), HPos::Left, FontStyle::Italic)?;
        }
        let place = |(x, y): (f64, f64)| (left + self.x.place(x) * width, bottom - self.y.place(y) * self.height);
        for (at, series) in self.panel.series.iter().enumerate() {
            let look = &LOOKS[series.style % LOOKS.len()];
            for run in series.points.split(|p| !usable(*p)).filter(|run| !run.is_empty()) {
                let run: Vec<_> = run.iter().map(|p| place(*p)).collect();
                curve(canvas, &thin(&run), look)?;
                let share = (at as f64 + 0.5) / self.panel.series.len() as f64;
                for point in marked(&run, width, share) {
                    marker(canvas, point, look)?;
                }
            }
        }
        if !self.panel.series.iter().any(|s| s.points.iter().any(|p| usable(*p))) {
            let middle = (left + width / 2.0, top + self.height / 2.0);
            write(canvas, "no finite values", middle, HPos::Center, FontStyle::Italic)?;
        }
        Ok(())
    }
}

/// Whether a point can be drawn. Beyond 1e300 a range could overflow.
fn usable((x, y): (f64, f64)) -> bool {
    x.abs() < 1e300 && y.abs() < 1e300
}

fn wrap(text: &str, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line) + text_width(word) < width => line.extend([" ", word]),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// An estimate, a little wide: no font is at hand.
fn text_width(text: &str) -> f64 {
    7.0 * text.chars().count() as f64
}

fn curve(canvas: &Canvas, points: &[(f64, f64)], look: &Look) -> Result<(), PlotError> {
    line(canvas, points, look.1, look.0)
}

fn marker(canvas: &Canvas, (x, y): (f64, f64), look: &Look) -> Result<(), PlotError> {
    let radius = 3.6;
    if look.4.is_empty() {
        let style = ShapeStyle { color: look.3.into(), filled: false, stroke_width: extent(OUTLINE) };
        canvas.draw(&Circle::new((fine(x), fine(y)), fine(radius), style))?;
    }
    for outline in look.4 {
        let points: Vec<_> = outline.iter().map(|(dx, dy)| (x + radius * dx, y + radius * dy)).collect();
        line(canvas, &points, OUTLINE, look.3)?;
    }
    Ok(())
}

fn line(canvas: &Canvas, points: &[(f64, f64)], width: f64, color: RGBColor) -> Result<(), PlotError> {
    let mut points: Vec<_> = points.iter().map(|(x, y)| (fine(*x), fine(*y))).collect();
    points.dedup();
    let style = ShapeStyle { color: color.into(), filled: false, stroke_width: extent(width) };
    Ok(canvas.draw(&PathElement::new(points, style))?)
}

fn write(canvas: &Canvas, text: &str, at: (f64, f64), side: HPos, style: FontStyle) -> Result<(), PlotError> {
    // Plotters divides a size by 1.24.
    let font = FontDesc::new(FontFamily::SansSerif, 12.5 * 1.24 * FINE, style);
    let style = TextStyle::from(font).color(&TEXT).pos(Pos::new(side, VPos::Center));
    Ok(canvas.draw(&Text::new(text, (fine(at.0), fine(at.1)), style))?)
}

/// Pixels in units of the canvas.
fn fine(pixels: f64) -> i32 {
    whole((pixels * FINE).round())
}

fn extent(pixels: f64) -> u32 {
    fine(pixels).unsigned_abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(curves: &[Vec<(f64, f64)>]) -> Panel {
        let series =
            |(at, points): (usize, &Vec<_>)| Series { label: format!("curve {at}"), style: at, points: points.clone() };
        Panel {
            title: "Energy".to_owned(),
            x_label: "t [s]".to_owned(),
            y_label: "T + V [J]".to_owned(),
            series: curves.iter().enumerate().map(series).collect(),
            note: None,
        }
    }

    #[test]
    fn degenerate_panels_draw() {
        let nan = f64::NAN;
        for curves in [
            vec![],
            vec![vec![]],
            vec![vec![(0.0, 1.0)]],
            vec![vec![(nan, 1.0), (0.0, nan), (f64::INFINITY, 2.0)]],
            vec![vec![(0.0, 7.0), (1.0, 7.0)]],
            vec![vec![(0.0, 0.0), (0.0, 0.0)]],
            vec![vec![(0.0, 1e-16), (1.0, 1e5)], vec![(0.0, -1e299), (1.0, 1e299)]],
            vec![vec![(0.0, 5e-324), (1.0, 1e-310)]],
        ] {
            let svg = draw(&[panel(&curves)], 1).unwrap();
            assert!(svg.starts_with("<svg role=\"img\"") && svg.trim_end().ends_with("</svg>"));
            assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("2147483647"), "{svg}");
        }
        assert!(draw(&[], 0).is_ok());
    }

    #[test]
    fn a_figure_is_the_same_each_time() {
        let points: Vec<_> = (0..9000).map(|i| (f64::from(i), f64::from(i).sin())).collect();
        let figure =
            || draw(&[panel(&[points.clone(), points.clone()]), panel(std::slice::from_ref(&points))], 2).unwrap();
        assert_eq!(figure(), figure());
        assert!(figure().len() < 300_000, "a long curve is thinned: {}", figure().len());
    }
}
