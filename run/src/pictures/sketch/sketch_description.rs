//! Description of a sketch in sentences, for its caption and for readers who cannot see the sketch.

use super::angles::Angle;
use super::axes::along_axis;
use super::dimension_lines::Length;
use super::drawn_pose::ChangedCoordinate;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::Triple;
use crate::pictures::view::space::dot;
use crate::pictures::view::{Solid, SolidForm};
use tripos_derive::model::{TIME, Unit};
use tripos_derive::plain_text::with_significant_digits;

/// Coordinate, with the mark that shows it on the sheet.
pub struct MarkedCoordinate {
    /// Index of the generalized coordinate that is shown.
    pub coordinate: usize,
    /// Mark that shows the coordinate.
    pub mark: CoordinateMark,
}

/// Kind of mark that shows a coordinate on the sheet.
pub enum CoordinateMark {
    /// Arc of an angle. The flag is false if the arc shows only the positive sense of the angle.
    Arc(Angle, bool),
    /// Dimension line of a length. The flag is false if only an arrow shows the positive sense of the length.
    Line(Length, bool),
    /// Common arc of several coordinates that turn a frame together. The value is the index of this frame.
    Together(usize),
    /// Arrow at the point that the coordinate moves the most.
    Arrow,
    /// Name without a mark: the coordinate moves nothing that is drawn.
    Name,
}

/// Sentences that describe the view, the drawn bodies and the coordinates of a sketch.
pub fn describe_sketch(subject: &SketchSubject<'_>, shown: &[MarkedCoordinate]) -> String {
    let mut sentences = vec![describe_view_direction(subject)];
    sentences.extend(describe_bodies(subject));
    sentences.extend(describe_coordinates(subject, shown));
    let is_closed =
        shown.iter().any(|shown| matches!(shown.mark, CoordinateMark::Arc(_, false) | CoordinateMark::Line(_, false)));
    if is_closed {
        sentences.push("For an angle near 0, the arrow shows the positive sense.".to_owned());
    }
    sentences.join(" ")
}

/// Sentence about the direction of view and the direction of gravity.
fn describe_view_direction(subject: &SketchSubject<'_>) -> String {
    let towards = subject.camera.towards;
    let gravity = if !subject.has_gravity() {
        ""
    } else if dot(subject.view.up, towards).abs() > 0.99 {
        ", gravity away from who looks"
    } else {
        ", gravity downwards"
    };
    match axis_of(subject, towards).filter(|_| subject.is_planar) {
        Some(axis) => format!("Seen against {axis}, across the plane of the motion{gravity}."),
        None => format!("Seen obliquely from above{gravity}."),
    }
}

/// Name of the inertial axis along a direction, with its sign, such as `-n3`. `None` if no axis is parallel
/// to the direction.
fn axis_of(subject: &SketchSubject<'_>, direction: Triple) -> Option<String> {
    let (axis, is_along) = along_axis(subject, 0, direction)?;
    let name = subject.mechanism.frames[0].name.to_lowercase();
    Some(format!("{}{name}{}", if is_along { "" } else { "-" }, axis + 1))
}

/// Sentence that lists the drawn bodies and springs; `None` if there are none.
fn describe_bodies(subject: &SketchSubject<'_>) -> Option<String> {
    let list: Vec<String> = subject
        .mechanism
        .bodies
        .iter()
        .enumerate()
        .filter_map(|(at, body)| {
            let is_of = |solid: &&Solid| solid.body == Some(at);
            let noun = |solid: &Solid| match &solid.form {
                SolidForm::Sphere { .. } if body.rigid.is_none() => "particle",
                form => form.noun(),
            };
            let mut nouns: Vec<&str> = subject.view.solids.iter().filter(is_of).map(noun).collect();
            nouns.sort_unstable();
            nouns.dedup();
            (!nouns.is_empty()).then(|| format!("{} ({})", body.name, nouns.join(", ")))
        })
        .collect();
    let springs = subject.view.solids.iter().filter(|solid| matches!(solid.form, SolidForm::Spring { .. }));
    let springs = springs.map(|solid| format!("{} (spring or damper)", solid.label));
    let all: Vec<String> = list.into_iter().chain(springs).collect();
    (!all.is_empty()).then(|| format!("Drawn are {}.", all.join(", ")))
}

/// Sentence that tells for each coordinate what its mark shows; `None` if there are no coordinates.
fn describe_coordinates(subject: &SketchSubject<'_>, shown: &[MarkedCoordinate]) -> Option<String> {
    let one = |shown: &MarkedCoordinate| {
        let coordinate = &subject.mechanism.coordinates[shown.coordinate];
        let about = if coordinate.about.is_empty() { String::new() } else { format!(" ({})", coordinate.about) };
        let frame = |at: usize| subject.mechanism.frames[at].name.clone();
        let what = match &shown.mark {
            CoordinateMark::Arc(angle, _) => {
                let axis = format!("{}{}", frame(angle.parent).to_lowercase(), angle.axis + 1);
                format!("turns {} about {axis}", frame(angle.frame))
            }
            CoordinateMark::Line(length, _) => {
                format!("is a length towards {}", subject.mechanism.points[length.point].name)
            }
            CoordinateMark::Together(at) => format!("turns {} with others", frame(*at)),
            CoordinateMark::Arrow => "moves what its arrow is at".to_owned(),
            CoordinateMark::Name => "moves nothing that is drawn".to_owned(),
        };
        format!("{}{about} {what}", coordinate.name)
    };
    let list: Vec<String> = shown.iter().map(one).collect();
    (!list.is_empty()).then(|| format!("{}.", list.join("; ")))
}

/// Sentence with the values of the coordinates in the drawn pose. If values were changed, it also gives the
/// original values. `of` is the name of the original pose, such as the start of a scene.
pub fn describe_pose_of_sketch(subject: &SketchSubject<'_>, changed: &[ChangedCoordinate], of: &str) -> String {
    let all = subject.mechanism.coordinates.iter().zip(subject.q).enumerate().filter(|(_, (c, _))| c.name != TIME);
    let value = |at: usize, x: f64| {
        let coordinate = &subject.mechanism.coordinates[at];
        // Euler parameters have no unit, but are no angles. All other coordinates without unit are angles.
        let is_angle = coordinate.unit.is_plain() && Angle::of(subject, at).is_some();
        if is_angle {
            format!("{}°", digits(x.to_degrees()))
        } else {
            format!("{}{}", digits(x), unit(&coordinate.unit))
        }
    };
    let values: Vec<String> = all.map(|(at, (c, x))| format!("{} = {}", c.name, value(at, *x))).collect();
    let at = if values.is_empty() { String::new() } else { format!(" at {}", values.join(", ")) };
    if changed.is_empty() {
        return format!("Drawn{at}: {of}.");
    }
    let list: Vec<String> = changed
        .iter()
        .map(|c| format!("{} = {}", subject.mechanism.coordinates[c.coordinate].name, value(c.coordinate, c.was)))
        .collect();
    format!("Drawn{at}, to be seen; {of} has {}.", list.join(", "))
}

/// Text of a unit that follows a number, with a space in front; empty for numbers without unit.
fn unit(unit: &Unit) -> String {
    if unit.is_plain() { String::new() } else { format!(" {unit}") }
}

/// Text of a number with three significant digits. Numbers with absolute values below 1e-9 become 0.
fn digits(x: f64) -> String {
    let x = if x.abs() < 1e-9 { 0.0 } else { x };
    // Adding 0 turns -0 into 0.
    with_significant_digits(x + 0.0, 3)
}
