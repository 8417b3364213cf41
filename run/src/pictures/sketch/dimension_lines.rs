//! Marks of coordinates that move points: dimension lines for lengths, and arrows for all other
//! coordinates.

use super::drawing_elements::{DrawingPoint, LabelWord, Mark, MarkRole, Path, arrow_tip, drawing_unit_vector};
use super::pose_formulas::{Components, SignedCoordinate};
use super::sheet::Sheet;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::Triple;
use crate::pictures::view::space::{add_scaled_vector, length, subtract_vectors, transpose};

/// Distance of a dimension line from the measured length, px, and length by which the extension lines
/// continue beyond it, px.
const AWAY: (f64, f64) = (30.0, 4.0);
/// Length of the arrow tips of a dimension line, px.
const TIP: f64 = 8.0;
/// Length below which an arrow replaces a dimension line, px.
const TINY: f64 = 9.0;
/// Length of an arrow that shows only the positive sense of a coordinate, px.
const SENSE: f64 = 34.0;

/// Coordinate that is a component of the position vector of a point, with its sign and zero.
pub struct Length {
    /// Coordinate, with its sign and its zero in the formula of the component.
    pub signed: SignedCoordinate,
    /// Index of the point that the coordinate moves.
    pub point: usize,
    /// Index of the component of the position vector, 0 to 2.
    pub component: usize,
}

impl Length {
    /// Makes the length that a coordinate is. `None` if the coordinate is not a component of a point's
    /// position.
    pub fn of(subject: &SketchSubject<'_>, coordinate: usize) -> Option<Self> {
        (0..subject.pose.points.len()).find_map(|point| {
            let Components { first, .. } = subject.terms.components(point)?;
            (0..3).find_map(|component| {
                let (p, q) = (subject.p, subject.q);
                let signed = subject.terms.signed_coordinate(subject.mechanism, p, q, first + component, coordinate)?;
                Some(Self { signed, point, component })
            })
        })
    }

    /// Ends of the measured length in the inertial frame, m. The earlier components of the position vector
    /// come before it. `None` if the point has no position components.
    fn ends(&self, subject: &SketchSubject<'_>) -> Option<[Triple; 2]> {
        let Components { from, frame, first } = subject.terms.components(self.point)?;
        let values = subject.terms.values(subject.p, subject.q);
        let axes = transpose(&subject.pose.rotations[frame]);
        let corner = (0..self.component)
            .fold(subject.pose.points[from], |at, before| add_scaled_vector(at, values[first + before], axes[before]));
        Some([self.signed.zero, self.signed.now].map(|value| add_scaled_vector(corner, value, axes[self.component])))
    }

    /// Unit vector in the inertial frame along which the dimension line is moved, away from the other
    /// components of the position. `None` if the dimension line is drawn directly between the ends.
    fn side_of_dimension_line(&self, subject: &SketchSubject<'_>) -> Option<Triple> {
        if !subject.is_planar {
            return None;
        }
        let Components { frame, first, .. } = subject.terms.components(self.point)?;
        let values = subject.terms.values(subject.p, subject.q);
        let axes = transpose(&subject.pose.rotations[frame]);
        let other = (0..3).find(|k| *k != self.component && values[first + k].abs() > 0.02 * subject.view.size);
        if let Some(other) = other {
            let sign = values[first + other].signum();
            // Earlier components end at the beginning of this length; later ones begin at its end.
            let side = if other < self.component { sign } else { -sign };
            return Some(axes[other].map(|x| side * x));
        }
        let seen = subject.camera.project_direction(axes[self.component]);
        Some(if seen[0].abs() > seen[1].abs() { subject.camera.up.map(|x| -x) } else { subject.camera.right })
    }
}

/// Adds the dimension line of a length to the sheet. Returns true if the line shows the length, and false
/// if only an arrow shows its positive sense.
pub fn draw_dimension_line(subject: &SketchSubject<'_>, sheet: &mut Sheet, lengths: &Length) -> bool {
    let Some([from, to]) = lengths.ends(subject) else { return false };
    let name = vec![LabelWord::Name(subject.mechanism.coordinates[lengths.signed.coordinate].name.clone())];
    let [a, b] = [from, to].map(|place| subject.camera.project_point(place));
    let long = (b[0] - a[0]).hypot(b[1] - a[1]);
    if long < TINY {
        let Components { frame, .. } = subject.terms.components(lengths.point).unwrap_or_default();
        let axis = transpose(&subject.pose.rotations[frame])[lengths.component];
        draw_growth_arrow(
            subject,
            sheet,
            b,
            subject.camera.project_direction(axis.map(|x| lengths.signed.sign * x)),
            name,
        );
        return false;
    }
    let moved = lengths.side_of_dimension_line(subject).map(|aside| subject.camera.project_direction(aside));
    let away = |spot: DrawingPoint, by: f64| moved.map_or(spot, |way| [0, 1].map(|i| spot[i] + by * way[i]));
    if moved.is_some() {
        for end in [a, b] {
            let line = Path::line(&[away(end, 4.0), away(end, AWAY.0 + AWAY.1)]);
            sheet.add([Mark::line(MarkRole::Reference, line)]);
        }
    }
    let ends = [away(a, AWAY.0), away(b, AWAY.0)];
    let heading = drawing_unit_vector([b[0] - a[0], b[1] - a[1]]);
    sheet.add([Mark::line(MarkRole::Coordinate, Path::line(&ends))]);
    sheet.add([
        arrow_tip(MarkRole::Coordinate, ends[1], heading, TIP),
        arrow_tip(MarkRole::Coordinate, ends[0], heading.map(|x| -x), TIP),
    ]);
    let middle = [0, 1].map(|i| 0.5 * (ends[0][i] + ends[1][i]));
    sheet.request_label(MarkRole::Coordinate, name, middle, moved.map(drawing_unit_vector), 3.0);
    true
}

/// Adds an arrow with a name that shows in which direction a coordinate grows. It begins near the point
/// `from` of the sheet, px, and has the projected direction `seen`.
fn draw_growth_arrow(
    subject: &SketchSubject<'_>,
    sheet: &mut Sheet,
    from: DrawingPoint,
    seen: DrawingPoint,
    name: Vec<LabelWord>,
) {
    let share = seen[0].hypot(seen[1]);
    let way =
        if share < 0.05 { subject.camera.project_direction(subject.camera.right) } else { drawing_unit_vector(seen) };
    let at = |t: f64| [0, 1].map(|i| from[i] + t * way[i]);
    sheet.add(Mark::arrow(MarkRole::Coordinate, Path::line(&[at(10.0), at(10.0 + SENSE)]), TIP));
    sheet.request_label(MarkRole::Coordinate, name, at(10.0 + 0.6 * SENSE), Some([-way[1], way[0]]), 4.0);
}

/// Adds an arrow at the point that a coordinate moves the most. Returns false if the coordinate moves no
/// point.
pub fn draw_motion_arrow(subject: &SketchSubject<'_>, sheet: &mut Sheet, coordinate: usize) -> bool {
    let step = 1e-6 * (1.0 + subject.q[coordinate].abs());
    let mut q = subject.q.to_vec();
    q[coordinate] += step;
    let moved = subject.poses.pose_at(subject.p, &q);
    let ways =
        moved.points.iter().zip(&subject.pose.points).map(|(to, from)| subtract_vectors(*to, *from).map(|x| x / step));
    let ways: Vec<Triple> = ways.collect();
    let most = ways.iter().map(|way| length(*way)).fold(0.0, f64::max);
    // If several points move about equally far, the first is taken.
    let point = ways.iter().position(|way| length(*way) > 0.999 * most);
    let Some(point) = point.filter(|_| most.is_finite() && most > 1e-6 * subject.view.size) else { return false };
    let name = vec![LabelWord::Name(subject.mechanism.coordinates[coordinate].name.clone())];
    let direction = ways[point].map(|x| x / most);
    draw_growth_arrow(subject, sheet, subject.spot(point), subject.camera.project_direction(direction), name);
    true
}
