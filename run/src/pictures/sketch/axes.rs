//! Marks for the axes of frames and for gravity, with their names.

use super::drawing_elements::{DrawingPoint, LabelWord, Mark, MarkRole, Path, drawing_extent, drawing_unit_vector};
use super::sheet::Sheet;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::space::{IDENTITY, dot, length, rotate_vector, subtract_vectors, transpose};
use crate::pictures::view::{Rotation, Triple};

/// Lengths of a drawn axis, px, for three cases: the inertial frame, a body frame, and a body frame if
/// there are many.
const LONG: [f64; 3] = [62.0, 46.0, 30.0];
/// Length of an axis's arrow tip, px.
const TIP: f64 = 8.0;
/// Number of body frames from which on their axes are short and only some are named.
const MANY: usize = 4;
/// Length of the projection of a unit vector below which its axis counts as perpendicular to the sheet.
const HEAD_ON: f64 = 0.12;
/// Length of the arrow for gravity, px, and its least distance from other marks, px.
const FALL: (f64, f64) = (38.0, 16.0);

/// Frame whose axes are drawn, with the place and the length of the axes.
struct Triad {
    /// Index of the frame whose axes are drawn.
    frame: usize,
    /// Origin of the drawn axes in the inertial frame, m.
    at: Triple,
    /// Length of each drawn axis, px.
    long: f64,
}

/// Adds the axes of the inertial frame and of the bodies to the sheet.
pub fn draw_axes(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    let bodies = body_axes(subject);
    let is_many = bodies.len() >= MANY;
    let origin = Triad { frame: 0, at: subject.pose.points[0], long: LONG[0] };
    draw_frame_axes(subject, sheet, &origin, [true; 3]);
    for triad in &bodies {
        // If there is no room for all names, the first axis names the frame. A frame that a joint generates has the
        // name
        // of its body.
        let is_needed = match (subject.is_generated(triad.frame), is_many) {
            (true, true) => [false; 3],
            (_, true) => [true, false, false],
            _ => [true, true, !subject.is_planar],
        };
        self::draw_frame_axes(subject, sheet, triad, is_needed);
    }
}

/// True if the axes of the frame with this index are drawn.
pub fn are_axes_drawn(subject: &SketchSubject<'_>, frame: usize) -> bool {
    body_axes(subject).iter().any(|triad| triad.frame == frame)
}

/// Axes that are drawn for rigid bodies: the axes of the body's frame, at the mass centre. If the inertia
/// is given in a frame that does not spin with the body, the axes of that frame are drawn.
fn body_axes(subject: &SketchSubject<'_>) -> Vec<Triad> {
    let mut list: Vec<Triad> = Vec::new();
    let rigid = subject.mechanism.bodies.iter().filter_map(|body| Some((body.centre, body.rigid.as_ref()?)));
    for (centre, (frame, inertia)) in rigid {
        let is_above = inertia.frame != 0 && subject.frame_and_parents(*frame).any(|above| above == inertia.frame);
        let frame = if is_above { inertia.frame } else { *frame };
        let at = subject.pose.points[centre];
        let is_there = list.iter().any(|triad| triad.frame == frame && length(subtract_vectors(triad.at, at)) < 1e-9);
        if !are_axes_inertial(&subject.pose.rotations[frame]) && !is_there {
            list.push(Triad { frame, at, long: LONG[1] });
        }
    }
    if list.len() >= MANY {
        for triad in &mut list {
            triad.long = LONG[2];
        }
    }
    list
}

/// True if the axes of a frame are parallel to the axes of the inertial frame.
fn are_axes_inertial(rotation: &Rotation) -> bool {
    rotation.iter().flatten().zip(IDENTITY.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12)
}

/// Adds the axes of a frame to the sheet. `is_needed` tells for each axis if its name must be placed.
fn draw_frame_axes(subject: &SketchSubject<'_>, sheet: &mut Sheet, triad: &Triad, is_needed: [bool; 3]) {
    let columns = transpose(&subject.pose.rotations[triad.frame]);
    let from = subject.camera.project_point(triad.at);
    for (axis, (column, is_needed)) in columns.into_iter().zip(is_needed).enumerate() {
        let seen = subject.camera.project_direction(column);
        let share = seen[0].hypot(seen[1]);
        let words = vec![subject.basis(triad.frame, axis)];
        if share < HEAD_ON {
            // An axis out of the sheet is a dot in a circle. In a planar mechanism, only the
            // inertial frame shows this axis.
            if triad.frame == 0 || !subject.is_planar {
                let is_out = dot(column, subject.camera.towards) > 0.0;
                sheet.add(if is_out { towards_viewer(from) } else { away_from_viewer(from) });
                let role = MarkRole::Axis;
                if is_needed {
                    sheet.request_label(role, words, from, None, 8.0);
                } else {
                    sheet.request_optional_label(role, words, from, None, 8.0);
                }
            }
            continue;
        }
        // Foreshortened axes are drawn short, but long enough to be seen.
        let long = triad.long * share.max(0.35) / share;
        let to = [0, 1].map(|i| from[i] + long * seen[i]);
        sheet.add(Mark::arrow(MarkRole::Axis, Path::line(&[from, to]), TIP));
        let towards = Some(drawing_unit_vector(seen));
        if is_needed {
            sheet.request_label(MarkRole::Axis, words, to, towards, 3.0);
        } else {
            sheet.request_optional_label(MarkRole::Axis, words, to, towards, 3.0);
        }
    }
}

/// Marks of an axis that points towards the viewer: a dot in a circle.
fn towards_viewer(at: DrawingPoint) -> Vec<Mark> {
    vec![Mark::solid(MarkRole::Axis, Path::circle(at, 5.0)), Mark::dot(MarkRole::Axis, at, 1.6)]
}

/// Marks of an axis that points away from the viewer: a cross in a circle.
fn away_from_viewer(at: DrawingPoint) -> Vec<Mark> {
    let arm = 3.5;
    let mut marks = vec![Mark::solid(MarkRole::Axis, Path::circle(at, 5.0))];
    marks.extend([1.0, -1.0].map(|side| {
        Mark::line(MarkRole::Axis, Path::line(&[[at[0] - arm, at[1] - side * arm], [at[0] + arm, at[1] + side * arm]]))
    }));
    marks
}

/// Adds an arrow for gravity in a free place of the sheet, if the mechanism has gravity.
pub fn draw_gravity_arrow(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    if !subject.has_gravity() {
        return;
    }
    let down = subject.view.up.map(|x| 0.0 - x);
    let seen = subject.camera.project_direction(down);
    let share = seen[0].hypot(seen[1]);
    let long = if share < HEAD_ON { 0.0 } else { FALL.0 };
    let half =
        [0.5 * long * seen[0].abs() / share.max(HEAD_ON) + 9.0, 0.5 * long * seen[1].abs() / share.max(HEAD_ON) + 9.0];
    let middle = free_place(sheet, half);
    if long == 0.0 {
        sheet.add(away_from_viewer(middle));
    } else {
        let way = drawing_unit_vector(seen);
        let ends = [-0.5, 0.5].map(|side| [0, 1].map(|i| middle[i] + side * long * way[i]));
        sheet.add(Mark::arrow(MarkRole::Gravity, Path::line(&ends), 10.0));
    }
    sheet.request_label(MarkRole::Gravity, vec![LabelWord::Name("g".to_owned())], middle, Some([1.0, 0.0]), 5.0);
}

/// Finds a free box with the half size `half`, px, and returns its middle. The box is in a corner of the
/// drawing, or beside the drawing if no corner is free.
fn free_place(sheet: &Sheet, half: DrawingPoint) -> DrawingPoint {
    let Some((low, high)) = drawing_extent(&sheet.marks, &[]) else { return [0.0; 2] };
    let spots: Vec<DrawingPoint> = sheet.marks.iter().flat_map(|mark| mark.path.points_along_path(3.0)).collect();
    let inside = |side: [f64; 2]| {
        let of = |i: usize| if side[i] > 0.0 { high[i] - half[i] } else { low[i] + half[i] };
        [of(0), of(1)]
    };
    let corners = [[1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(inside);
    let is_free =
        |at: &DrawingPoint| !spots.iter().any(|spot| (0..2).all(|i| (spot[i] - at[i]).abs() < half[i] + FALL.1));
    corners.into_iter().find(is_free).unwrap_or([high[0] + half[0] + FALL.1, low[1] + half[1]])
}

/// Finds the axis of a frame that is parallel to a direction in the inertial frame. Returns its index, and
/// true if it has the same sense. `None` if no axis is parallel.
pub fn along_axis(subject: &SketchSubject<'_>, frame: usize, direction: Triple) -> Option<(usize, bool)> {
    let components = rotate_vector(&transpose(&subject.pose.rotations[frame]), direction);
    let axis = (0..3).find(|axis| components[*axis].abs() > 1.0 - 1e-9)?;
    Some((axis, components[axis] > 0.0))
}
