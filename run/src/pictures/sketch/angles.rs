//! Arcs for coordinates that turn frames. An arc leads from an axis at angle zero to the same axis in the
//! drawn pose.

use super::axes::{along_axis, are_axes_drawn};
use super::drawing_elements::{DrawingPoint, LabelWord, Mark, MarkRole, Path, drawing_unit_vector};
use super::pose_formulas::{FrameTurn, SignedCoordinate};
use super::sheet::Sheet;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::Triple;
use crate::pictures::view::space::{
    add_scaled_vector, cross, dot, length, rotate_vector, rotate_vector_back, subtract_vectors, transpose,
};
use std::f64::consts::{PI, TAU};

/// Radius of the first arc about a place, px, and increase of the radius for each further arc about the
/// same place, px.
const RADIUS: (f64, f64) = (36.0, 14.0);
/// Absolute angle below which an arc shows only the positive sense of the angle, rad.
const TINY: f64 = 0.12;
/// Angle of an arc that shows only the positive sense, rad.
const SENSE: f64 = 0.9;
/// Length of the arrow tip of an arc, px.
const TIP: f64 = 8.0;
/// Least part of a vector perpendicular to the axis of an angle with which the vector can show the
/// angle, as a fraction of the vector's length.
const ACROSS: f64 = 0.7;
/// Part of a vector along a basis vector from which on the vector counts as parallel to the basis
/// vector, as a fraction of the vector's length.
const ALONG: f64 = 0.95;

/// Coordinate that is the angle of a frame about an axis of its parent frame.
pub struct Angle {
    /// Coordinate, with its sign and its zero in the formula of the angle.
    pub signed: SignedCoordinate,
    /// Index of the frame that the coordinate turns.
    pub frame: usize,
    /// Index of the parent frame, from which the frame is turned.
    pub parent: usize,
    /// Index of the axis of rotation, 0 to 2, the same in both frames.
    pub axis: usize,
}

/// Line whose rotation an arc shows, with its origin and its direction.
struct AngleLine {
    /// Origin of the line and centre of the arc, in the inertial frame, m.
    apex: Triple,
    /// Unit vector along the line, in the turned frame.
    direction: Triple,
}

/// Component of a vector perpendicular to the axis of an angle, along a basis vector.
struct AcrossAxis {
    /// Basis vector of the turned frame, with a sign, that is perpendicular to the axis and closest to the
    /// vector.
    direction: Triple,
    /// Length of the component perpendicular to the axis, m.
    length: f64,
    /// Length of the component along this basis vector, divided by the length of the vector.
    share: f64,
}

impl Angle {
    /// Makes the angle that a coordinate is. `None` if the coordinate is not the angle of a frame about one
    /// axis.
    pub fn of(subject: &SketchSubject<'_>, coordinate: usize) -> Option<Self> {
        let frames = 0..subject.pose.rotations.len();
        frames.into_iter().find_map(|frame| {
            let FrameTurn { parent, axis, term } = subject.terms.turn(frame)?;
            let signed = subject.terms.signed_coordinate(subject.mechanism, subject.p, subject.q, term, coordinate)?;
            Some(Self { signed, frame, parent, axis })
        })
    }

    /// Unit vector along the axis of the angle, in the inertial frame.
    pub fn rotation_axis(&self, subject: &SketchSubject<'_>) -> Triple {
        transpose(&subject.pose.rotations[self.parent])[self.axis]
    }

    /// Value of the angle without whole turns, rad, from −π to below π.
    pub fn angle_without_turns(&self) -> f64 {
        let whole = self.signed.now - self.signed.zero;
        whole - TAU * ((whole + PI) / TAU).floor()
    }

    /// Chooses the line whose rotation the arc shows, in this order of preference:
    /// - a vector to a point that is placed in the turned frame, preferably along a basis vector;
    /// - the first vector in a frame that turns with the turned frame, if it is perpendicular to the axis;
    /// - the next basis vector, at the mass centre.
    fn line_of_angle(&self, subject: &SketchSubject<'_>) -> AngleLine {
        let ways = |is_own: bool| {
            let list = subject.terms.links.points.iter().enumerate().filter_map(move |(point, link)| {
                let (from, frame) = (*link)?;
                let is_in = if is_own {
                    frame == self.frame
                } else {
                    subject.frame_and_parents(frame).any(|f| f == self.frame)
                };
                let way = subtract_vectors(subject.pose.points[point], subject.pose.points[from]);
                (is_in && length(way) > 1e-6 * subject.view.size).then_some((from, way))
            });
            list.collect::<Vec<_>>()
        };
        let (own, all) = (ways(true), ways(false));
        let best = own.iter().filter_map(|(from, way)| Some((*from, self.component_across_axis(subject, *way)?)));
        let best = best.min_by(|(_, a), (_, b)| {
            let rank = |x: &AcrossAxis| (x.share < ALONG, -(1e6 * x.length / subject.view.size).round());
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        if let Some((from, AcrossAxis { direction, .. })) = best {
            return AngleLine { apex: subject.pose.points[from], direction };
        }
        let mut next = [0.0; 3];
        next[(self.axis + 1) % 3] = 1.0;
        if let Some((from, way)) = all.first() {
            let of_first = self
                .component_across_axis(subject, *way)
                .filter(|across| across.share > 0.8)
                .map(|across| across.direction);
            return AngleLine { apex: subject.pose.points[*from], direction: of_first.unwrap_or(next) };
        }
        let turned = |frame: usize| subject.frame_and_parents(frame).any(|f| f == self.frame);
        let bodies = &subject.mechanism.bodies;
        let body = bodies.iter().find(|body| body.rigid.as_ref().is_some_and(|(frame, _)| turned(*frame)));
        AngleLine { apex: subject.pose.points[body.map_or(0, |body| body.centre)], direction: next }
    }

    /// Component of the vector `way` perpendicular to the axis. `None` if `way` is too close to the
    /// direction of the axis.
    fn component_across_axis(&self, subject: &SketchSubject<'_>, way: Triple) -> Option<AcrossAxis> {
        let inside = rotate_vector_back(&subject.pose.rotations[self.frame], way);
        let (j, k) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let across = inside[j].hypot(inside[k]);
        if across < ACROSS * length(inside) {
            return None;
        }
        // Of two components that are equal up to rounding, the first is taken.
        let axis = if inside[k].abs() > inside[j].abs() * (1.0 + 1e-9) { k } else { j };
        let mut direction = [0.0; 3];
        direction[axis] = inside[axis].signum();
        Some(AcrossAxis { direction, length: across, share: inside[axis].abs() / length(inside) })
    }
}

/// Unit vectors along the axes of the given angles, in the inertial frame.
pub fn axes_of_angles(subject: &SketchSubject<'_>, angles: &[Angle]) -> Vec<Triple> {
    angles.iter().map(|angle| angle.rotation_axis(subject)).collect()
}

/// Centres of the arcs that are drawn so far, px, in sheet coordinates.
#[derive(Default)]
pub struct Arcs(Vec<DrawingPoint>);

impl Arcs {
    /// Radius of the next arc about a centre, px. Adds the centre to the list.
    fn radius(&mut self, at: DrawingPoint) -> f64 {
        let there = self.0.iter().filter(|spot| (spot[0] - at[0]).hypot(spot[1] - at[1]) < 8.0).count();
        self.0.push(at);
        RADIUS.0 + RADIUS.1 * there as f64
    }
}

/// Adds the arc of an angle to the sheet. Returns true if the arc shows the value of the angle, and false
/// if it shows only the positive sense.
pub fn draw_angle_arc(subject: &SketchSubject<'_>, sheet: &mut Sheet, arcs: &mut Arcs, angle: &Angle) -> bool {
    let (arm, axis, extent) = (angle.line_of_angle(subject), angle.rotation_axis(subject), angle.angle_without_turns());
    let apex = subject.camera.project_point(arm.apex);
    let radius = arcs.radius(apex);
    let zero = subject.direction_after_rotation(angle.parent, angle.axis, angle.signed.zero, arm.direction);
    let now = rotate_vector(&subject.pose.rotations[angle.frame], arm.direction);
    let is_open = extent.abs() >= TINY;
    let (from, sweep) = if is_open { (zero, extent) } else { (now, angle.signed.sign * SENSE) };
    // The arc begins at the direction `from`, and turns towards the direction that is a quarter turn further.
    let [a, b] = [from, cross(axis, from)].map(|e| subject.camera.project_direction(e).map(|x| radius * x));
    let path = Path::arc(apex, a, b, 0.0, sweep);
    for (direction, frame) in [(zero, angle.parent), (now, angle.frame)] {
        let seen = subject.camera.project_direction(direction).map(|x| (radius + 12.0) * x);
        let to = [0, 1].map(|i| apex[i] + seen[i]);
        sheet.add([Mark::line(MarkRole::Reference, Path::line(&[apex, to]))]);
        name_axis(subject, sheet, frame, direction, arm.apex, to);
    }
    sheet.add(Mark::arrow(MarkRole::Coordinate, path, TIP));
    let middle = Path::arc(apex, a, b, 0.0, 0.5 * sweep).end();
    let outwards = drawing_unit_vector([middle[0] - apex[0], middle[1] - apex[1]]);
    let name = subject.mechanism.coordinates[angle.signed.coordinate].name.clone();
    sheet.request_label(MarkRole::Coordinate, vec![LabelWord::Name(name)], middle, Some(outwards), 4.0);
    is_open
}

/// Adds the name of the axis along a reference line, unless the axes of its frame are drawn elsewhere. The
/// line leads from the point `apex`, m, to the place `to`, px, on the sheet. It has the `direction` in the
/// inertial frame.
fn name_axis(
    subject: &SketchSubject<'_>,
    sheet: &mut Sheet,
    frame: usize,
    direction: Triple,
    apex: Triple,
    to: DrawingPoint,
) {
    let is_at_origin = length(subtract_vectors(apex, subject.pose.points[0])) < 1e-9;
    // In a planar mechanism, the inertial axes are easily recognized.
    if frame == 0 && (is_at_origin || subject.is_planar)
        || are_axes_drawn(subject, frame)
        || subject.is_generated(frame)
    {
        return;
    }
    let Some((axis, is_along)) = along_axis(subject, frame, direction) else { return };
    let basis = subject.basis(frame, axis);
    let words = if is_along { vec![basis] } else { vec![LabelWord::Minus, basis] };
    let from = subject.camera.project_point(apex);
    sheet.request_optional_label(
        MarkRole::Axis,
        words,
        to,
        Some(drawing_unit_vector([to[0] - from[0], to[1] - from[1]])),
        3.0,
    );
}

/// Adds one arc with the names of all coordinates that turn a frame together. The arc leads from an axis of
/// the parent frame to the same axis of the frame.
pub fn draw_common_arc(
    subject: &SketchSubject<'_>,
    sheet: &mut Sheet,
    arcs: &mut Arcs,
    frame: usize,
    names: Vec<LabelWord>,
) {
    let Some((parent, _)) = subject.terms.links.frames[frame] else { return };
    let [before, after] = [parent, frame].map(|f| transpose(&subject.pose.rotations[f]));
    let bodies = &subject.mechanism.bodies;
    let turned = |f: usize| subject.frame_and_parents(f).any(|above| above == frame);
    let body = bodies.iter().find(|body| body.rigid.as_ref().is_some_and(|rigid| turned(rigid.0)));
    let place = subject.pose.points[body.map_or(0, |body| body.centre)];
    let apex = subject.camera.project_point(place);
    let radius = arcs.radius(apex) + 14.0;
    // The axis with the largest rotation is taken, except rotations close to 180°.
    let turn = |axis: usize| dot(before[axis], after[axis]).clamp(-1.0, 1.0).acos();
    let axis =
        (0..3).fold(0, |best, axis| if turn(axis) > turn(best) + 1e-6 && turn(axis) < 2.6 { axis } else { best });
    let across = add_scaled_vector(after[axis], -dot(after[axis], before[axis]), before[axis]);
    let other = crate::pictures::view::space::unit_vector(across).unwrap_or(before[(axis + 1) % 3]);
    let [a, b] = [before[axis], other].map(|e| subject.camera.project_direction(e).map(|x| radius * x));
    let sweep = turn(axis).max(SENSE);
    let path = Path::arc(apex, a, b, 0.0, sweep);
    let to = [0, 1].map(|i| apex[i] + 1.25 * a[i]);
    sheet.add([Mark::line(MarkRole::Reference, Path::line(&[apex, to]))]);
    sheet.add(Mark::arrow(MarkRole::Coordinate, path, TIP));
    let middle = Path::arc(apex, a, b, 0.0, 0.5 * sweep).end();
    let outwards = drawing_unit_vector([middle[0] - apex[0], middle[1] - apex[1]]);
    sheet.request_label(MarkRole::Coordinate, names, middle, Some(outwards), 4.0);
}
