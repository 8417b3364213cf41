//! Thinning of curves: selection of the points that are drawn, and of the places of markers. Points
//! are in pixels.

use super::axis::truncate_to_integer;

/// Largest number of points of a curve that is not thinned.
const PLENTY: usize = 2000;

/// Selects the points of a curve that can be seen. A long curve keeps the ends and extremes of each
/// pixel column. If x turns back, it keeps points that are half a pixel apart.
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
