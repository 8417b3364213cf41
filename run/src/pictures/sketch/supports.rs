//! Marks of the ground at joints: supports of pins, rails of sliding points, and walls that hold springs.

use super::drawing_elements::{DrawingPoint, Mark, MarkRole, Path, drawing_unit_vector};
use super::sheet::Sheet;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::space::{cross, length, subtract_vectors};
use crate::pictures::view::{SolidForm, Triple};
use tripos_derive::model::ReactionKind;

/// Height of a pin above the ground, px, and half the width of its support, px.
const STAND: (f64, f64) = (13.0, 15.0);
/// Distance between the lines of a hatching, px, and length of each line, px.
const HATCH: (f64, f64) = (5.5, 6.5);
/// Length of a rail to each side of the sliding point, px.
const RAIL: f64 = 62.0;

/// Adds the marks of supports and rails to the sheet.
pub fn draw_supports(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    let mut done: Vec<usize> = Vec::new();
    for point in points_held_by_ground(subject) {
        if done.iter().any(|other| subject.points_coincide(*other, point)) {
            continue;
        }
        if subject.is_fixed(point) {
            sheet.add(support_marks(subject, point));
            done.push(point);
        } else if let Some(way) = rail_direction(subject, point) {
            sheet.add(rail_marks(subject, point, way));
            done.push(point);
        }
    }
}

/// Indices of the points where the ground holds the mechanism: joints, reactions, fixed ends of rods and
/// springs, and fixed mass centres of rigid bodies.
fn points_held_by_ground(subject: &SketchSubject<'_>) -> Vec<usize> {
    let mechanism = subject.mechanism;
    let hung = mechanism.carried.iter().filter(|joint| joint.on.is_none()).map(|joint| joint.point);
    let pushed = mechanism.reactions.iter().filter_map(|reaction| match reaction.kind {
        ReactionKind::Force { on, against: None } => Some(on.point),
        _ => None,
    });
    let ends = rod_and_spring_ends(subject).into_iter().flatten().filter(|point| subject.is_fixed(*point));
    let centres = mechanism.bodies.iter().filter(|body| body.rigid.is_some()).map(|body| body.centre);
    let resting = centres.filter(|point| subject.is_fixed(*point));
    hung.chain(pushed).chain(ends).chain(resting).collect()
}

/// Indices of the two end points of each rod and each spring.
fn rod_and_spring_ends(subject: &SketchSubject<'_>) -> Vec<[usize; 2]> {
    let solids = subject.view.solids.iter();
    solids
        .filter_map(|solid| match solid.form {
            SolidForm::Rod { ends, .. } | SolidForm::Spring { ends } => Some(ends),
            _ => None,
        })
        .collect()
}

/// Sum of the unit vectors on the sheet along the rods and springs that end at a point. Each vector begins at
/// the point.
fn direction_of_rods(subject: &SketchSubject<'_>, point: usize) -> DrawingPoint {
    let mut sum = [0.0; 2];
    for [a, b] in rod_and_spring_ends(subject) {
        for (from, to) in [(a, b), (b, a)] {
            if subject.points_coincide(from, point) {
                let way = drawing_unit_vector(
                    subject.camera.project_vector(subject.pose.points[from], subject.pose.points[to]),
                );
                sum = [0, 1].map(|i| sum[i] + way[i]);
            }
        }
    }
    sum
}

/// Marks of the support of a fixed point, on the side away from its rods. It is a wall if only springs end at
/// the point.
fn support_marks(subject: &SketchSubject<'_>, point: usize) -> Vec<Mark> {
    let (spot, leads) = (subject.spot(point), direction_of_rods(subject, point));
    let is_of_spring = |solid: &crate::pictures::view::Solid| match solid.form {
        SolidForm::Spring { ends } => ends.iter().any(|end| subject.points_coincide(*end, point)),
        _ => false,
    };
    let is_of_rod = |solid: &crate::pictures::view::Solid| match solid.form {
        SolidForm::Rod { ends, .. } => ends.iter().any(|end| subject.points_coincide(*end, point)),
        _ => false,
    };
    let is_sideways = leads[0].abs() > 1.3 * leads[1].abs();
    let solids = &subject.view.solids;
    if solids.iter().any(is_of_spring) && !solids.iter().any(is_of_rod) {
        let behind =
            if is_sideways { [-leads[0].signum(), 0.0] } else { [0.0, if leads[1] < 0.0 { 1.0 } else { -1.0 }] };
        let ends = [-1.0, 1.0].map(|side| [spot[0] + side * 16.0 * behind[1], spot[1] - side * 16.0 * behind[0]]);
        return wall_marks(ends, behind);
    }
    // The support is above a mechanism that hangs down, and otherwise below.
    let down = if leads[1] > 0.35 { -1.0 } else { 1.0 };
    let foot = |side: f64| [spot[0] + side * 0.62 * STAND.1, spot[1] + down * STAND.0];
    let mut marks = vec![Mark::solid(MarkRole::Support, Path::polygon(&[spot, foot(1.0), foot(-1.0)]))];
    let ends = [-1.0, 1.0].map(|side| [spot[0] + side * STAND.1, spot[1] + down * STAND.0]);
    marks.extend(wall_marks(ends, [0.0, down]));
    marks.push(Mark::solid(MarkRole::Joint, Path::circle(spot, 3.6)));
    marks
}

/// Unit vector along the line on which a point moves. `None` if the point does not move along one straight
/// line.
fn rail_direction(subject: &SketchSubject<'_>, point: usize) -> Option<Triple> {
    let here = subject.pose.points[point];
    let ways: Vec<Triple> = subject.far.iter().map(|pose| subtract_vectors(pose.points[point], here)).collect();
    let longest = ways.iter().copied().max_by(|a, b| length(*a).total_cmp(&length(*b)))?;
    let way = crate::pictures::view::space::unit_vector(longest)?;
    let is_along = |other: &Triple| length(cross(*other, way)) <= 1e-9 * (subject.view.size + length(*other));
    ways.iter().all(is_along).then_some(way)
}

/// Marks of a rail beside the point that slides on it. Empty if the rail is nearly perpendicular to the
/// sheet.
fn rail_marks(subject: &SketchSubject<'_>, point: usize, way: Triple) -> Vec<Mark> {
    let camera = &subject.camera;
    let (spot, seen) = (subject.spot(point), camera.project_direction(way));
    if seen[0].hypot(seen[1]) < 0.2 {
        return Vec::new();
    }
    let along = drawing_unit_vector(seen);
    // The rail is below the point, or to the left of it.
    let below = if along[0].abs() > 0.5 { [-along[1], along[0]] } else { [along[1], -along[0]] };
    let below = if below[1] < -1e-9 || (below[1].abs() < 1e-9 && below[0] > 0.0) { below.map(|x| -x) } else { below };
    let reach = subject.view.solids.iter().filter(|solid| solid.form.points().contains(&point) && solid.body.is_some());
    let reach = reach.map(|solid| camera.scale * solid.form.reach()).fold(6.0, f64::max).min(40.0);
    let at = |t: f64| [0, 1].map(|i| spot[i] + t * along[i] + (reach + 1.0) * below[i]);
    wall_marks([at(-RAIL), at(RAIL)], below)
}

/// Marks of a wall: a line between two points of the sheet, with hatching in the direction `behind`.
pub fn wall_marks(ends: [DrawingPoint; 2], behind: DrawingPoint) -> Vec<Mark> {
    let [a, b] = ends;
    let way = [b[0] - a[0], b[1] - a[1]];
    let long = way[0].hypot(way[1]);
    let along = drawing_unit_vector(way);
    let behind = drawing_unit_vector(behind);
    let mut marks = vec![Mark::line(MarkRole::Support, Path::line(&ends))];
    let count = (long / HATCH.0).floor().clamp(1.0, 400.0);
    let places = std::iter::successors(Some(0.5), |k| Some(k + 1.0)).take_while(|k| *k < count);
    for k in places {
        let from = [0, 1].map(|i| a[i] + k / count * long * along[i]);
        let to = [0, 1].map(|i| from[i] + 0.7 * HATCH.1 * (behind[i] - 0.8 * along[i]));
        marks.push(Mark::line(MarkRole::Support, Path::line(&[from, to])));
    }
    marks
}
