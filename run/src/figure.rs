//! What figures show, as data: curves in panels, and tables of sizes. Absent on purpose: how they are drawn.

/// A figure.
pub enum Figure {
    /// Panels in a grid of so many columns.
    Panels(Vec<Panel>, usize),
    /// A table of sizes.
    HeatMap(HeatMap),
}

/// How values are placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithms.
    Logarithmic,
}

impl Scale {
    /// Whether a point (other, value) can be drawn on this axis. Beyond 1e300 a range could overflow.
    #[must_use]
    pub fn shows(self, (x, y): (f64, f64)) -> bool {
        x.abs() < 1e300 && y.abs() < 1e300 && (self == Self::Linear || y >= 1e-300)
    }
}

/// One curve.
pub struct Series {
    /// Its name in the legend.
    pub label: String,
    /// Picks colour, dashes and marker: 0 Kane, 1 Lagrange, 2 Newton–Euler, then printed ones.
    pub style: usize,
    /// (x, y); the curve breaks where a value is not finite.
    pub points: Vec<(f64, f64)>,
    /// For each measured point, from where to where x was found: drawn as a bar. Measurements carry a marker each, a
    /// curve only some.
    pub spread: Vec<(f64, f64)>,
    /// (x, lowest, highest): between which values the true one lies, as far as is known; in the order of the points.
    pub band: Vec<(f64, f64, f64)>,
}

impl Series {
    /// A curve.
    #[must_use]
    pub fn curve(label: String, style: usize, points: Vec<(f64, f64)>) -> Self {
        Self { label, style, points, spread: Vec::new(), band: Vec::new() }
    }
}

/// One coordinate system.
pub struct Panel {
    /// The title; left out where `y_label` begins with it.
    pub title: String,
    /// Horizontal quantity, as `t [s]`.
    pub x_label: String,
    /// Vertical quantity, as `T + V [J]`.
    pub y_label: String,
    /// How it is scaled; on a logarithmic axis a curve breaks where it is not positive.
    pub scale: Scale,
    /// How the horizontal quantity is scaled.
    pub x_scale: Scale,
    /// The curves, the first one drawn lowest.
    pub series: Vec<Series>,
    /// What to know about the curves, such as where one ends early.
    pub note: Option<String>,
}

impl Panel {
    /// Whether a point can be drawn.
    #[must_use]
    pub fn shows(&self, (x, y): (f64, f64)) -> bool {
        self.scale.shows((x, y)) && self.x_scale.shows((y, x))
    }
}

/// One cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number on a logarithmic scale, such as an error.
    Value(f64),
    /// No number: where and why it stopped, in few words.
    Stopped(String),
}

/// A table of numbers on a logarithmic scale.
pub struct HeatMap {
    /// What the numbers are.
    pub title: String,
    /// A heading for each column.
    pub columns: Vec<String>,
    /// A heading for each row, and its cells.
    pub rows: Vec<(String, Vec<Cell>)>,
    /// The numbers that have the lightest and the darkest colour.
    pub range: (f64, f64),
    /// What to know.
    pub note: String,
}

/// Words as a person writes them: `q1'` as q̇₁, `cos(q2)` as cos(q₂), `m/s^2` as m/s², `kg*m` as kg·m.
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

/// A name with its index lowered and dots for its primes; other words as they are.
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
