//! Contents of figures as data: panels with curves, and tables of coloured numbers. This module does not
//! draw them.

/// Figure: a grid of panels with curves, or a table of coloured numbers.
pub enum Figure {
    /// Panels in a grid. The second value is the number of columns of the grid.
    Panels(Vec<Panel>, usize),
    /// Table of numbers, coloured on a logarithmic scale.
    HeatMap(HeatMap),
}

/// Scale of an axis: linear or logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Scale with evenly spaced values.
    Linear,
    /// Scale with evenly spaced logarithms, for positive values.
    Logarithmic,
}

impl Scale {
    /// True if a point can be drawn on an axis with this scale. The point is given as the coordinate on the
    /// other axis, followed by the coordinate on this axis. Numbers beyond 1e300 are refused, because
    /// computations with them could overflow.
    #[must_use]
    pub fn shows(self, point: (f64, f64)) -> bool {
        let (x, y) = point;
        x.abs() < 1e300 && y.abs() < 1e300 && (self == Self::Linear || y >= 1e-300)
    }
}

/// Curve of a panel, with its name, style, points and uncertainties.
pub struct Series {
    /// Name of the curve for the legend.
    pub label: String,
    /// Index that selects colour, dashes and marker. For formulations it is 0 for Kane, 1 for Lagrange, 2
    /// for Newton–Euler, and 3 and above for printed equations.
    pub style: usize,
    /// Points (x, y) of the curve, which breaks where a value is not finite.
    pub points: Vec<(f64, f64)>,
    /// Range (lowest x, highest x) of each measured point, drawn as a bar. Empty for curves that are not
    /// measured. Measured curves have a marker at each point; other curves have few markers.
    pub spread: Vec<(f64, f64)>,
    /// Bounds of the true value at positions along the curve; empty if no bounds are known.
    pub band: Vec<Bounds>,
}

/// Lower and upper bound of the true value at one position along a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Position on the horizontal axis.
    pub x: f64,
    /// Lower bound of the true value.
    pub low: f64,
    /// Upper bound of the true value.
    pub high: f64,
}

impl Series {
    /// Makes a curve without ranges of measured points and without bounds.
    #[must_use]
    pub fn curve(label: String, style: usize, points: Vec<(f64, f64)>) -> Self {
        Self { label, style, points, spread: Vec::new(), band: Vec::new() }
    }
}

/// Panel of a figure: two axes with their curves.
pub struct Panel {
    /// Title of the panel. It is not drawn if `y_label` begins with it.
    pub title: String,
    /// Label of the horizontal axis, such as `t [s]`.
    pub x_label: String,
    /// Label of the vertical axis, such as `T + V [J]`.
    pub y_label: String,
    /// Scale of the vertical axis. On a logarithmic axis, a curve breaks where its values are not
    /// positive.
    pub scale: Scale,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
    /// Curves of the panel, drawn in this order, so that the last is on top.
    pub series: Vec<Series>,
    /// Note on the curves, such as the instant at which a curve ends early; `None` without a note.
    pub note: Option<String>,
}

impl Panel {
    /// True if a point (x, y) can be drawn on the scales of the panel.
    #[must_use]
    pub fn shows(&self, point: (f64, f64)) -> bool {
        self.scale.shows(point) && self.x_scale.shows((point.1, point.0))
    }
}

/// Cell of a table of numbers: a number, or a text that says why the number is missing.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Positive number that is coloured on a logarithmic scale, such as an error.
    Value(f64),
    /// Short text in place of a number. It says when and why the run stopped.
    Stopped(String),
}

/// Table of numbers whose cells are coloured on a logarithmic scale.
pub struct HeatMap {
    /// Title of the table, which says what its numbers are.
    pub title: String,
    /// Heading of each column.
    pub columns: Vec<String>,
    /// Rows of the table, each with its heading and its cells.
    pub rows: Vec<(String, Vec<Cell>)>,
    /// Range of the colour scale: the number with the lightest and the number with the darkest colour.
    pub range: (f64, f64),
    /// Note that is written below the table.
    pub note: String,
}

/// Converts the formulas in a text to mathematical symbols: `q1'` to q̇₁, `cos(q2)` to cos(q₂),
/// `m/s^2` to m/s², `kg*m` to kg·m.
#[must_use]
pub fn figure_text_in_symbols(text: &str) -> String {
    let belongs = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let mut out = String::new();
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| belongs(c) != belongs(first)).unwrap_or(rest.len());
        let (part, others) = rest.split_at(end);
        out += &if belongs(first) { figure_name_in_symbols(part) } else { part.to_owned() };
        rest = others;
    }
    let out = out.replace("^2", "²").replace("^3", "³").replace('*', "·");
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Converts a name such as `q1'` to q̇₁: digits become a subscript, primes become dots. Other words
/// are unchanged.
fn figure_name_in_symbols(word: &str) -> String {
    let stem = word.trim_end_matches('\'');
    let dots = ["", "\u{307}", "\u{308}"][(word.len() - stem.len()).min(2)];
    match (stem.chars().next(), stem.get(1..)) {
        (Some(letter), Some(digits)) if letter.is_ascii_alphabetic() && digits.bytes().all(|b| b.is_ascii_digit()) => {
            let lowered = digits.bytes().filter_map(|b| char::from_u32(u32::from(b - b'0') + '₀' as u32));
            format!("{letter}{dots}{}", lowered.collect::<String>())
        }
        _ => word.to_owned(),
    }
}
