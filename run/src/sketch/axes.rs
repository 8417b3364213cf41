//! Axes of frames with their names, and gravity.

use super::drawing::{Mark, Path, Role, Spot, Word, extent, unit};
use super::sheet::{Sheet, Subject};
use crate::view::space::{IDENTITY, dot, length, minus, rotated, transposed};
use crate::view::{Rotation, Triple};

/// How long an axis is, px: inertial ones, those of bodies, and of many bodies.
const LONG: [f64; 3] = [62.0, 46.0, 30.0];
/// The tip of an axis, px.
const TIP: f64 = 8.0;
/// Frames from which on their axes are short, and not all of them named.
const MANY: usize = 4;
/// What of an axis is seen of one that points to who looks.
const HEAD_ON: f64 = 0.12;
/// How long the arrow of gravity is, px, and how far from all else it stands.
const FALL: (f64, f64) = (38.0, 16.0);

/// A frame whose axes are drawn, and where.
struct Triad {
    frame: usize,
    at: Triple,
    long: f64,
}

/// Puts the axes of the inertial frame and of bodies on the sheet.
pub fn draw(subject: &Subject<'_>, sheet: &mut Sheet) {
    let bodies = of_bodies(subject);
    let is_many = bodies.len() >= MANY;
    let origin = Triad { frame: 0, at: subject.pose.points[0], long: LONG[0] };
    triad(subject, sheet, &origin, [true; 3]);
    for triad in &bodies {
        // The first names the frame where there is no room for all; that of a body that a joint carries is named by its body.
        let is_needed = match (subject.is_generated(triad.frame), is_many) {
            (true, true) => [false; 3],
            (_, true) => [true, false, false],
            _ => [true, true, !subject.is_planar],
        };
        self::triad(subject, sheet, triad, is_needed);
    }
}

/// Whether the axes of a frame are drawn.
pub fn is_drawn(subject: &Subject<'_>, frame: usize) -> bool {
    of_bodies(subject).iter().any(|triad| triad.frame == frame)
}

/// The frames of bodies: where inertia is told in one that does not spin with the body, that.
fn of_bodies(subject: &Subject<'_>) -> Vec<Triad> {
    let mut list: Vec<Triad> = Vec::new();
    let rigid = subject.mechanism.bodies.iter().filter_map(|body| Some((body.centre, body.rigid.as_ref()?)));
    for (centre, (frame, inertia)) in rigid {
        let is_above = inertia.frame != 0 && subject.chain(*frame).any(|above| above == inertia.frame);
        let frame = if is_above { inertia.frame } else { *frame };
        let at = subject.pose.points[centre];
        let is_there = list.iter().any(|triad| triad.frame == frame && length(minus(triad.at, at)) < 1e-9);
        if !is_unturned(&subject.pose.rotations[frame]) && !is_there {
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

/// Whether a frame stands as the inertial one does.
fn is_unturned(rotation: &Rotation) -> bool {
    rotation.iter().flatten().zip(IDENTITY.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12)
}

fn triad(subject: &Subject<'_>, sheet: &mut Sheet, triad: &Triad, is_needed: [bool; 3]) {
    let columns = transposed(&subject.pose.rotations[triad.frame]);
    let from = subject.camera.spot(triad.at);
    for (axis, (column, is_needed)) in columns.into_iter().zip(is_needed).enumerate() {
        let seen = subject.camera.seen(column);
        let share = seen[0].hypot(seen[1]);
        let words = vec![subject.basis(triad.frame, axis)];
        if share < HEAD_ON {
            // Out of the sheet: a dot in a circle. Bodies in a plane share it.
            if triad.frame == 0 || !subject.is_planar {
                let is_out = dot(column, subject.camera.towards) > 0.0;
                sheet.add(head_on(from, is_out));
                let role = Role::Axis;
                if is_needed {
                    sheet.name(role, words, from, None, 8.0);
                } else {
                    sheet.may_name(role, words, from, None, 8.0);
                }
            }
            continue;
        }
        // Those that point to who looks are short; but not shorter than can be seen.
        let long = triad.long * share.max(0.35) / share;
        let to = [0, 1].map(|i| from[i] + long * seen[i]);
        sheet.add(Mark::arrow(Role::Axis, Path::line(&[from, to]), TIP));
        let towards = Some(unit(seen));
        if is_needed {
            sheet.name(Role::Axis, words, to, towards, 3.0);
        } else {
            sheet.may_name(Role::Axis, words, to, towards, 3.0);
        }
    }
}

/// An axis that points at who looks, or away.
fn head_on(at: Spot, is_out: bool) -> Vec<Mark> {
    let mut marks = vec![Mark::solid(Role::Axis, Path::circle(at, 5.0))];
    if is_out {
        marks.push(Mark::dot(Role::Axis, at, 1.6));
    } else {
        let arm = 3.5;
        marks.extend([1.0, -1.0].map(|side| {
            Mark::line(Role::Axis, Path::line(&[[at[0] - arm, at[1] - side * arm], [at[0] + arm, at[1] + side * arm]]))
        }));
    }
    marks
}

/// Puts an arrow of gravity where nothing else is. Returns whether there is gravity.
pub fn gravity(subject: &Subject<'_>, sheet: &mut Sheet) -> bool {
    let Some(gravity) = &subject.mechanism.gravity else { return false };
    let down = subject.view.up.map(|x| 0.0 - x);
    let is_stated = gravity.acceleration.iter().any(|e| *e != tripos_derive::algebra::Expr::ZERO);
    if !is_stated {
        return false;
    }
    let seen = subject.camera.seen(down);
    let share = seen[0].hypot(seen[1]);
    let long = if share < HEAD_ON { 0.0 } else { FALL.0 };
    let half =
        [0.5 * long * seen[0].abs() / share.max(HEAD_ON) + 9.0, 0.5 * long * seen[1].abs() / share.max(HEAD_ON) + 9.0];
    let middle = free_place(sheet, half);
    if long == 0.0 {
        sheet.add(head_on(middle, false));
    } else {
        let way = unit(seen);
        let ends = [-0.5, 0.5].map(|side| [0, 1].map(|i| middle[i] + side * long * way[i]));
        sheet.add(Mark::arrow(Role::Gravity, Path::line(&ends), 10.0));
    }
    sheet.name(Role::Gravity, vec![Word::Name("g".to_owned())], middle, Some([1.0, 0.0]), 5.0);
    true
}

/// The middle of a free box of this half size: in a corner of what is drawn, else beside it.
fn free_place(sheet: &Sheet, half: Spot) -> Spot {
    let Some((low, high)) = extent(&sheet.marks, &[]) else { return [0.0; 2] };
    let spots: Vec<Spot> = sheet.marks.iter().flat_map(|mark| mark.path.spots(3.0)).collect();
    let inside = |side: [f64; 2]| {
        let of = |i: usize| if side[i] > 0.0 { high[i] - half[i] } else { low[i] + half[i] };
        [of(0), of(1)]
    };
    let corners = [[1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(inside);
    let is_free = |at: &Spot| !spots.iter().any(|spot| (0..2).all(|i| (spot[i] - at[i]).abs() < half[i] + FALL.1));
    corners.into_iter().find(is_free).unwrap_or([high[0] + half[0] + FALL.1, low[1] + half[1]])
}

/// The axis of a frame that a direction is along, and whether it is along it or against it.
pub fn along_axis(subject: &Subject<'_>, frame: usize, direction: Triple) -> Option<(usize, bool)> {
    let components = rotated(&transposed(&subject.pose.rotations[frame]), direction);
    let axis = (0..3).find(|axis| components[*axis].abs() > 1.0 - 1e-9)?;
    Some((axis, components[axis] > 0.0))
}
