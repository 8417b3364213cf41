//! Figure in fewer bytes, for a page that holds many. The strokes become paths of relative steps, one path for all
//! successive strokes of one look.
//!
//! Invariant: a removed point lies within [`SEEN`] of the drawn line, or between the extremes of a column of
//! [`COLUMN`]; no point is moved. The module reads the output of plotters, one element per line; unknown elements stay
//! unchanged.

use std::fmt::Write;

/// Place (x, y) in units of the canvas, four to a pixel.
type Place = (i64, i64);

/// Largest distance of a removed point from the drawn line, in units of the canvas: it is not seen.
const SEEN: f64 = 1.2;
/// Width of a column of a long curve, in units of the canvas.
const COLUMN: i64 = 6;
/// Largest number of points of a curve that keeps all points of its columns.
const SHORT: usize = 60;

/// Shape that an element of the SVG draws.
enum Shape {
    Line(Vec<Place>),
    Area(Vec<Place>),
    Ring(Place, i64),
}

/// Path of successive strokes with one look.
struct Path<'a> {
    look: &'a str,
    data: String,
    at: Place,
}

/// Makes a figure, an `<svg>` element of [`super::draw`], smaller in bytes.
pub fn slim(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len() / 2);
    let mut path: Option<Path> = None;
    for line in svg.lines() {
        let Some((look, shape)) = shape(line) else {
            out += &path.take().map_or_else(String::new, Path::element);
            out += line;
            out.push('\n');
            continue;
        };
        let is_area = matches!(shape, Shape::Area(_));
        if is_area || path.as_ref().is_none_or(|path| path.look != look) {
            out += &path.take().map_or_else(String::new, Path::element);
        }
        path.get_or_insert_with(|| Path { look, data: String::new(), at: (0, 0) }).add(shape);
        if is_area {
            out += &path.take().map_or_else(String::new, Path::element);
        }
    }
    out += &path.map_or_else(String::new, Path::element);
    // Default values are dropped, and the common font is stated once.
    out.replace(" opacity=\"1\"", "").replace(" font-family=\"sans-serif\"", "").replacen(
        "<svg ",
        "<svg font-family=\"sans-serif\" ",
        1,
    )
}

/// Reads the look and the shape of a line of SVG; `None` if it is no stroke.
fn shape(line: &str) -> Option<(&str, Shape)> {
    if let Some(rest) = line.strip_prefix("<circle cx=\"") {
        let (x, rest) = rest.split_once("\" cy=\"")?;
        let (y, rest) = rest.split_once("\" r=\"")?;
        let (radius, look) = rest.split_once("\" ")?;
        return Some((look.strip_suffix("/>")?, Shape::Ring((number(x)?, number(y)?), number(radius)?)));
    }
    let of = |element: &str| line.strip_prefix(element)?.strip_suffix("\"/>")?.split_once(" points=\"");
    let places = |points: &str| points.split_whitespace().map(place).collect::<Option<Vec<_>>>();
    if let Some((look, points)) = of("<polyline ") {
        return Some((look, Shape::Line(places(points)?)));
    }
    let (look, points) = of("<polygon ")?;
    Some((look, Shape::Area(places(points)?)))
}

fn place(text: &str) -> Option<Place> {
    let (x, y) = text.split_once(',')?;
    Some((number(x)?, number(y)?))
}

/// Reads a whole number; `None` for other text, whose element is not changed.
fn number(text: &str) -> Option<i64> {
    text.parse().ok()
}

impl Path<'_> {
    fn element(self) -> String {
        format!("<path {} d=\"{}\"/>\n", self.look, self.data)
    }

    fn add(&mut self, shape: Shape) {
        match shape {
            Shape::Line(places) => self.line(&simple(columns(places))),
            Shape::Area(places) => {
                self.line(&simple(places));
                self.data.push('z');
            }
            Shape::Ring((x, y), radius) => {
                self.line(&[(x - radius, y)]);
                let wide = 2 * radius;
                let _ = write!(self.data, "a{radius} {radius} 0 1 0 {wide} 0 {radius} {radius} 0 1 0-{wide} 0");
            }
        }
    }

    /// Adds a move to the first of `places` to the path, then a step to each further place.
    fn line(&mut self, places: &[Place]) {
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

/// Keeps the lowest and the highest place of each column, in their order, and the ends. A short curve, or one that
/// turns back, keeps all places.
fn columns(places: Vec<Place>) -> Vec<Place> {
    if places.len() <= SHORT || !places.is_sorted_by(|a, b| a.0 <= b.0) {
        return places;
    }
    let mut kept = vec![places[0]];
    for column in places.chunk_by(|a, b| a.0.div_euclid(COLUMN) == b.0.div_euclid(COLUMN)) {
        let height = |at: &usize| column[*at].1;
        let (low, high) = ((0..column.len()).min_by_key(height), (0..column.len()).max_by_key(height));
        let (low, high) = (low.unwrap_or_default(), high.unwrap_or_default());
        kept.extend([column[low.min(high)], column[low.max(high)]]);
    }
    kept.extend(places.last());
    kept.dedup();
    kept
}

/// Keeps the places that are seen in the line (Ramer 1972; Douglas & Peucker 1973).
fn simple(places: Vec<Place>) -> Vec<Place> {
    if places.len() < 3 {
        return places;
    }
    let mut is_kept = vec![false; places.len()];
    let last = places.len() - 1;
    (is_kept[0], is_kept[last]) = (true, true);
    let mut spans = vec![(0, last)];
    while let Some((from, to)) = spans.pop() {
        let off = |at: usize| distance(places[at], places[from], places[to]);
        let Some(worst) = (from + 1..to).max_by(|a, b| off(*a).total_cmp(&off(*b))) else { continue };
        if off(worst) > SEEN {
            is_kept[worst] = true;
            spans.extend([(from, worst), (worst, to)]);
        }
    }
    places.into_iter().zip(is_kept).filter_map(|(place, kept)| kept.then_some(place)).collect()
}

/// Distance of a place from the line segment between two others.
fn distance(place: Place, from: Place, to: Place) -> f64 {
    let minus = |a: Place, b: Place| ((a.0 - b.0) as f64, (a.1 - b.1) as f64);
    let (along, off) = (minus(to, from), minus(place, from));
    let square = along.0 * along.0 + along.1 * along.1;
    let share = if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (off.0 - share * along.0).hypot(off.1 - share * along.1)
}

#[cfg(test)]
mod tests {
    use super::{SEEN, distance, simple, slim};

    /// Goal: strokes stay where they are. Method: two markers and a ring of one look, by hand.
    #[test]
    fn strokes_of_one_look_are_one_path() {
        let svg = "<svg role=\"img\">\n<polyline fill=\"none\" opacity=\"1\" stroke=\"#E3E3E3\" points=\"10,20 30,15 \"/>\n\
                   <polyline fill=\"none\" opacity=\"1\" stroke=\"#E3E3E3\" points=\"0,0 5,5 5,0 \"/>\n\
                   <circle cx=\"9\" cy=\"4\" r=\"3\" opacity=\"1\" fill=\"none\" stroke=\"#000000\"/>\n<text>\n</svg>\n";
        assert_eq!(
            slim(svg),
            "<svg font-family=\"sans-serif\" role=\"img\">\n<path fill=\"none\" stroke=\"#E3E3E3\" d=\"m10 20 20-5m-30-15 5 5 0-5\"/>\n\
             <path fill=\"none\" stroke=\"#000000\" d=\"m6 4a3 3 0 1 0 6 0 3 3 0 1 0-6 0\"/>\n<text>\n</svg>\n"
        );
    }

    /// Goal: the removed points are not missed. Method: a sine of 800 points: few are left, and all others lie by the
    /// line between them.
    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "numbers within 400")]
    fn a_smooth_curve_needs_few_points() {
        let places: Vec<_> = (0..800_i64).map(|x| (2 * x, (400.0 * (x as f64 / 60.0).sin()).round() as i64)).collect();
        let kept = simple(places.clone());
        assert!(kept.len() < 160, "{}", kept.len());
        for place in places {
            let nearest = kept.windows(2).map(|pair| distance(place, pair[0], pair[1])).fold(f64::MAX, f64::min);
            assert!(nearest <= SEEN, "{place:?}: {nearest}");
        }
    }
}
