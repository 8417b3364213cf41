//! Thinning of curves: selects the points that are drawn, and the places of markers. Points are in pixels; the pen
//! thins them again as places in canvas units.
//!
//! Invariant: a place that is not drawn lies within [`SEEN`] of the drawn line, or between the extremes of a column of
//! width [`COLUMN`]. No place is moved.

use super::axis::truncate_to_integer;
use plotters_backend::BackendCoord;

/// Number of points up to which a curve is not thinned.
const PLENTY: usize = 2000;
/// Largest distance of a removed point from the drawn line, in canvas units. It is too small to be visible.
const SEEN: f64 = 1.2;
/// Width of a column of a long curve, in canvas units. Of the points in a column, only the lowest and the highest are
/// kept.
const COLUMN: i32 = 6;
/// Number of points up to which a curve keeps all points of its columns.
const SHORT: usize = 60;

/// Selects the visible points of a curve. A long curve keeps its ends and the extremes of each pixel column. If x turns
/// back, points that are half a pixel apart are kept.
pub fn thin_curve(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= PLENTY {
        return points.to_vec();
    }
    if !points.is_sorted_by(|a, b| a.0 <= b.0) {
        let mut kept = vec![points[0]];
        for p in points {
            let last = kept[kept.len() - 1];
            if (p.0 - last.0).hypot(p.1 - last.1) >= 0.5 {
                kept.push(*p);
            }
        }
        kept.extend(points.last());
        return kept;
    }
    let mut kept = Vec::new();
    for column in points.chunk_by(|a, b| truncate_to_integer(a.0) == truncate_to_integer(b.0)) {
        let order = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
        let low = (0..column.len()).min_by(order).unwrap_or(0);
        let high = (0..column.len()).max_by(order).unwrap_or(0);
        let mut chosen = [0, low.min(high), low.max(high), column.len() - 1].to_vec();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|at| column[at]));
    }
    kept
}

/// Returns the places of about 25 markers on a curve in a panel of this width, px. `share`, from 0
/// to 1, shifts them, so that equal curves have markers at different places.
pub fn thinned_marker_places(points: &[(f64, f64)], width: f64, share: f64) -> Vec<(f64, f64)> {
    let spacing = (width / 25.0).max(34.0);
    let mut chosen = Vec::new();
    let mut next = match points {
        [] => return chosen,
        [only] => return vec![*only],
        [first, ..] => first.0.min(points[points.len() - 1].0) + share * spacing,
    };
    if points.is_sorted_by(|a, b| a.0 <= b.0) {
        for pair in points.windows(2) {
            // Markers between samples lie on the drawn line.
            while next <= pair[1].0 && pair[1].0 > pair[0].0 {
                let part = ((next - pair[0].0) / (pair[1].0 - pair[0].0)).max(0.0);
                chosen.push((next, pair[0].1 + part * (pair[1].1 - pair[0].1)));
                next += spacing;
            }
        }
        return chosen;
    }
    let every = points.len().div_ceil(12);
    let start = truncate_to_integer(share * every as f64).unsigned_abs() as usize;
    points.iter().skip(start).step_by(every).copied().collect()
}

/// Keeps the lowest and the highest place of each column, in their order, and the two ends. If a curve is short or
/// turns back, all places are kept.
pub fn keep_column_extremes(places: Vec<BackendCoord>) -> Vec<BackendCoord> {
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

/// Removes places that are so near the line through the remaining places that the removal is not visible (Ramer 1972;
/// Douglas & Peucker 1973).
pub fn thin_line(places: Vec<BackendCoord>) -> Vec<BackendCoord> {
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

/// Returns the distance of a place from the line segment between `from` and `to`, in canvas units.
fn distance(place: BackendCoord, from: BackendCoord, to: BackendCoord) -> f64 {
    let minus = |a: BackendCoord, b: BackendCoord| (f64::from(a.0) - f64::from(b.0), f64::from(a.1) - f64::from(b.1));
    let (along, off) = (minus(to, from), minus(place, from));
    let square = along.0 * along.0 + along.1 * along.1;
    let share = if square > 0.0 { ((off.0 * along.0 + off.1 * along.1) / square).clamp(0.0, 1.0) } else { 0.0 };
    (off.0 - share * along.0).hypot(off.1 - share * along.1)
}

#[cfg(test)]
mod tests {
    use super::{SEEN, distance, thin_line};

    /// Goal: the removal of points is not visible. Method: of a sine of 800 points, few points are left, and all others
    /// lie near the line between these.
    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "numbers within 400")]
    fn a_smooth_curve_needs_few_points() {
        let places: Vec<_> =
            (0..800_i32).map(|x| (2 * x, (400.0 * (f64::from(x) / 60.0).sin()).round() as i32)).collect();
        let kept = thin_line(places.clone());
        assert!(kept.len() < 160, "{}", kept.len());
        for place in places {
            let nearest = kept.windows(2).map(|pair| distance(place, pair[0], pair[1])).fold(f64::MAX, f64::min);
            assert!(nearest <= SEEN, "{place:?}: {nearest}");
        }
    }
}
