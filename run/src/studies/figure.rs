//! Contents of figures as data: curves in panels, and tables of sizes. Rendering is left out on purpose.

/// Figure that is made of panels or of a table.
pub enum Figure {
    /// Panels in a grid with this number of columns.
    Panels(Vec<Panel>, usize),
    /// A table of sizes.
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
    /// True if a point (other, value) can be drawn on this axis. Beyond 1e300 a range could overflow.
    #[must_use]
    pub fn shows(self, (x, y): (f64, f64)) -> bool {
        x.abs() < 1e300 && y.abs() < 1e300 && (self == Self::Linear || y >= 1e-300)
    }
}

/// One curve.
pub struct Series {
    /// Name in the legend.
    pub label: String,
    /// Index of colour, dashes and marker: 0 Kane, 1 Lagrange, 2 Newton–Euler, then printed equations.
    pub style: usize,
    /// Points (x, y); the curve breaks where a value is not finite.
    pub points: Vec<(f64, f64)>,
    /// Range of the x values of each measured point, drawn as a bar. Each measurement has a marker; a curve has only a
    /// few.
    pub spread: Vec<(f64, f64)>,
    /// Band (x, lowest, highest) in which the true value lies, as far as is known; in the order of the points.
    pub band: Vec<(f64, f64, f64)>,
}

impl Series {
    /// Creates a curve without spread and band.
    #[must_use]
    pub fn curve(label: String, style: usize, points: Vec<(f64, f64)>) -> Self {
        Self { label, style, points, spread: Vec::new(), band: Vec::new() }
    }
}

/// Coordinate system with its curves.
pub struct Panel {
    /// The title; left out where `y_label` begins with it.
    pub title: String,
    /// Label of the horizontal axis, such as `t [s]`.
    pub x_label: String,
    /// Label of the vertical axis, such as `T + V [J]`.
    pub y_label: String,
    /// Scale of the vertical axis. On a logarithmic axis a curve breaks where it is not positive.
    pub scale: Scale,
    /// Scale of the horizontal axis.
    pub x_scale: Scale,
    /// Curves; later ones are drawn over earlier ones.
    pub series: Vec<Series>,
    /// Note on the curves, such as where one ends early.
    pub note: Option<String>,
}

impl Panel {
    /// True if a point can be drawn.
    #[must_use]
    pub fn shows(&self, (x, y): (f64, f64)) -> bool {
        self.scale.shows((x, y)) && self.x_scale.shows((y, x))
    }
}

/// Cell of a table of sizes.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number on a logarithmic scale, such as an error.
    Value(f64),
    /// No number, but a short text on where and why the run stopped.
    Stopped(String),
}

/// A table of numbers on a logarithmic scale.
pub struct HeatMap {
    /// Description of the numbers.
    pub title: String,
    /// Heading of each column.
    pub columns: Vec<String>,
    /// Heading of each row, and its cells.
    pub rows: Vec<(String, Vec<Cell>)>,
    /// Numbers with the lightest and with the darkest colour.
    pub range: (f64, f64),
    /// Note below the table.
    pub note: String,
}

/// Sets text as a person writes it: `q1'` as q̇₁, `cos(q2)` as cos(q₂), `m/s^2` as m/s², `kg*m` as kg·m.
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

/// Sets a name with its index lowered and dots for its primes; leaves other words unchanged.
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
