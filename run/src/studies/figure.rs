//! Contents of figures as data: curves in panels, and tables of sizes. Code that draws them is elsewhere on purpose.

/// Figure that is made of panels or of a table.
pub enum Figure {
    /// Panels in a grid, with the number of its columns.
    Panels(Vec<Panel>, usize),
    /// A table of numbers on a logarithmic scale.
    HeatMap(HeatMap),
}

/// Scale of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly spaced values.
    Linear,
    /// Evenly spaced logarithms.
    Logarithmic,
}

impl Scale {
    /// True if a point (coordinate on the other axis, coordinate on this axis) can be drawn. Beyond 1e300 a range could
    /// overflow.
    #[must_use]
    pub fn shows(self, point: (f64, f64)) -> bool {
        let (x, y) = point;
        x.abs() < 1e300 && y.abs() < 1e300 && (self == Self::Linear || y >= 1e-300)
    }
}

/// Curve of a panel, with its name, style and points.
pub struct Series {
    /// Name of the curve in the legend.
    pub label: String,
    /// Index of colour, dashes and marker: 0 Kane, 1 Lagrange, 2 Newton–Euler, 3 and more for printed equations.
    pub style: usize,
    /// Points (x, y); the curve breaks where a value is not finite.
    pub points: Vec<(f64, f64)>,
    /// Range (lowest x, highest x) of each measured point, drawn as a bar. Curves of measurements have a marker at each
    /// point; others have only a few markers.
    pub spread: Vec<(f64, f64)>,
    /// Band in which the true value lies, as far as is known; in the order of the points.
    pub band: Vec<Bounds>,
}

/// Lowest and highest true value at a place of a curve, as far as is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Place on the horizontal axis.
    pub x: f64,
    /// Lowest true value.
    pub low: f64,
    /// Highest true value.
    pub high: f64,
}

impl Series {
    /// Creates a curve without spread and band.
    #[must_use]
    pub fn curve(label: String, style: usize, points: Vec<(f64, f64)>) -> Self {
        Self { label, style, points, spread: Vec::new(), band: Vec::new() }
    }
}

/// Panel of a figure: axes with their curves.
pub struct Panel {
    /// Title of the panel; not drawn if `y_label` begins with it.
    pub title: String,
    /// Label of the horizontal axis, such as `t [s]`.
    pub x_label: String,
    /// Label of the vertical axis, such as `T + V [J]`.
    pub y_label: String,
    /// Scale of the vertical axis. On a logarithmic axis a curve breaks where its values are not positive.
    pub scale: Scale,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
    /// Curves of the panel; later ones are drawn over earlier ones.
    pub series: Vec<Series>,
    /// Note on the curves, such as the instant at which one ends early.
    pub note: Option<String>,
}

impl Panel {
    /// True if a point (x, y) can be drawn in the panel.
    #[must_use]
    pub fn shows(&self, point: (f64, f64)) -> bool {
        self.scale.shows(point) && self.x_scale.shows((point.1, point.0))
    }
}

/// Cell of a table of sizes.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number on a logarithmic scale, such as an error.
    Value(f64),
    /// A short text that says when and why the run stopped, in place of a number.
    Stopped(String),
}

/// A table of numbers on a logarithmic scale.
pub struct HeatMap {
    /// Title of the table, which describes its numbers.
    pub title: String,
    /// Heading of each column.
    pub columns: Vec<String>,
    /// Heading and cells of each row.
    pub rows: Vec<(String, Vec<Cell>)>,
    /// Numbers that get the lightest and the darkest colour.
    pub range: (f64, f64),
    /// Note below the table.
    pub note: String,
}

/// Converts a formula in text to mathematical symbols: `q1'` to q̇₁, `cos(q2)` to cos(q₂), `m/s^2` to m/s², `kg*m` to
/// kg·m.
#[must_use]
pub fn pretty(text: &str) -> String {
    let belongs = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let mut out = String::new();
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| belongs(c) != belongs(first)).unwrap_or(rest.len());
        let (part, others) = rest.split_at(end);
        out += &if belongs(first) { name(part) } else { part.to_owned() };
        rest = others;
    }
    let out = out.replace("^2", "²").replace("^3", "³").replace('*', "·");
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Converts a name such as `q1'` to q̇₁, with its index lowered and dots for its primes; leaves other words unchanged.
fn name(word: &str) -> String {
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
