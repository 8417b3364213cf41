//! Outlines of the solids of a mechanism on the sheet, drawn from back to front.

use super::drawing_elements::{DrawingPoint, Mark, MarkRole, Path};
use super::sheet::Sheet;
use super::sketch_subject::SketchSubject;
use crate::pictures::view::space::{
    add_scaled_vector, cross, dot, length, product, rotate_vector, rotation_from_quaternion, rotation_to_axis,
    subtract_vectors, transpose, unit_vector,
};
use crate::pictures::view::{Rotation, Solid, SolidForm, SolidPlace, Triple};

/// Least half-width of a drawn rod, px.
const THIN: f64 = 2.2;
/// Least radius of a drawn particle, px.
const SMALL: f64 = 6.0;
/// Radius of a drawn pin, px. A pin is the mark of a joint.
const PIN: f64 = 3.6;
/// Length of one coil of a drawn spring, px, and half the width of the spring, px.
const SPRING: (f64, f64) = (11.0, 7.0);
/// Margin of a drawn ground plane around the solids above it, px.
const MARGIN: f64 = 26.0;

/// Marks of a solid, with its place in the drawing order.
struct SolidOutline {
    /// Coordinate of the solid's centre along the direction to the viewer, m. It is not used in a planar
    /// mechanism.
    depth: f64,
    /// Rank among solids of equal depth. A solid of lower rank is drawn first. The ground has rank 0.
    rank: u8,
    /// Marks of the solid: its outlines and areas.
    marks: Vec<Mark>,
}

/// Adds all solids to the sheet, from back to front.
pub fn draw_solids(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    let mut list: Vec<SolidOutline> =
        subject.view.solids.iter().filter_map(|solid| solid_outline(subject, solid)).collect();
    // Depths are rounded, since their last digits may differ between machines.
    let step = 1e-6 * subject.view.size;
    let key = |drawn: &SolidOutline| if subject.is_planar { 0.0 } else { (drawn.depth / step).round() };
    let is_ground = |drawn: &SolidOutline| drawn.rank != 0;
    list.sort_by(|a, b| is_ground(a).cmp(&is_ground(b)).then(key(a).total_cmp(&key(b))).then(a.rank.cmp(&b.rank)));
    for drawn in list {
        sheet.add(drawn.marks);
    }
}

/// Makes the marks of a solid, with its depth and rank. `None` for a ground plane that is not drawn.
fn solid_outline(subject: &SketchSubject<'_>, solid: &Solid) -> Option<SolidOutline> {
    let camera = &subject.camera;
    let is_particle = solid.body.is_some_and(|body| subject.mechanism.bodies[body].rigid.is_none());
    let (middle, rank, marks) = match &solid.form {
        SolidForm::Sphere { at, radius } => {
            let middle = solid_centre(subject, at);
            let spot = camera.project_point(middle);
            let (rank, mark) = if solid.is_pin() {
                (4, Mark::solid(MarkRole::Joint, Path::circle(spot, PIN)))
            } else if is_particle {
                (3, Mark::solid(MarkRole::Mass, Path::circle(spot, (camera.scale * radius).max(SMALL))))
            } else {
                (1, Mark::solid(MarkRole::Body, Path::circle(spot, (camera.scale * radius).max(PIN))))
            };
            // A pin is drawn in front of the solids that it joins.
            (
                if solid.is_pin() {
                    add_scaled_vector(middle, 0.05 * subject.view.size, camera.towards)
                } else {
                    middle
                },
                rank,
                vec![mark],
            )
        }
        SolidForm::Cylinder { at, radius, length } => {
            let axis = rotate_vector(&solid_axes(subject, at), [0.0, 0.0, 1.0]);
            (solid_centre(subject, at), 1, cylinder(subject, solid_centre(subject, at), axis, *radius, *length))
        }
        SolidForm::Box { at, size } => (solid_centre(subject, at), 1, box_faces(subject, at, *size)),
        SolidForm::Rod { ends, radius } => {
            let [a, b] = ends.map(|point| subject.pose.points[point]);
            let wide = (camera.scale * radius).clamp(THIN, 9.0);
            let path = Path::capsule(camera.project_point(a), camera.project_point(b), wide);
            (add_scaled_vector(a, 0.5, subtract_vectors(b, a)), 2, vec![Mark::solid(MarkRole::Body, path)])
        }
        SolidForm::Spring { ends } => {
            let [a, b] = ends.map(|point| subject.pose.points[point]);
            let coil = Mark::line(MarkRole::Spring, spring_outline(camera.project_point(a), camera.project_point(b)));
            (add_scaled_vector(a, 0.5, subtract_vectors(b, a)), 2, vec![coil])
        }
        SolidForm::Ground { at } => (solid_centre(subject, at), 0, ground_outline(subject, at)?),
    };
    Some(SolidOutline { depth: camera.depth(middle), rank, marks })
}

/// Position of a solid's centre in the inertial frame, m.
pub fn solid_centre(subject: &SketchSubject<'_>, at: &SolidPlace) -> Triple {
    add_scaled_vector(subject.pose.points[at.point], 1.0, rotate_vector(&subject.pose.rotations[at.frame], at.position))
}

/// Axes of a solid in the inertial frame, as the columns of a rotation matrix.
fn solid_axes(subject: &SketchSubject<'_>, at: &SolidPlace) -> Rotation {
    product(&subject.pose.rotations[at.frame], &rotation_from_quaternion(at.turned))
}

/// Marks of a cylinder whose axis is the unit vector `axis`: its far end, side and near end. `radius` and
/// the length `long` are in m.
fn cylinder(subject: &SketchSubject<'_>, middle: Triple, axis: Triple, radius: f64, long: f64) -> Vec<Mark> {
    let camera = &subject.camera;
    let towards = dot(axis, camera.towards);
    let axis = if towards < 0.0 { axis.map(|x| -x) } else { axis };
    let [near, far] = [0.5, -0.5].map(|side| add_scaled_vector(middle, side * long, axis));
    let across = transpose(&rotation_to_axis(axis));
    let [a, b] = [across[0], across[1]].map(|e| camera.project_point(e.map(|x| radius * x)));
    let end = |at: Triple| Mark::solid(MarkRole::Body, Path::ellipse(camera.project_point(at), a, b));
    let is_flat = camera.scale * long * (1.0 - towards * towards).max(0.0).sqrt() < 1.5;
    // The visible side ends at the lines where the surface is tangent to the direction of sight.
    let edge = unit_vector(cross(axis, camera.towards)).filter(|_| !is_flat);
    let Some(edge) = edge.map(|edge| edge.map(|x| radius * x)) else { return vec![end(near)] };
    let corners = [(far, 1.0), (near, 1.0), (near, -1.0), (far, -1.0)]
        .map(|(at, side)| camera.project_point(add_scaled_vector(at, side, edge)));
    vec![end(far), Mark::solid(MarkRole::Body, Path::polygon(&corners)), end(near)]
        .into_iter()
        // In a view from the side, the ends of a cylinder are lines. They are left out.
        .filter(|mark| towards.abs() > 0.02 || mark.path.parts.len() == 3)
        .collect()
}

/// Marks of the visible faces of a box with edge lengths `size`, m.
fn box_faces(subject: &SketchSubject<'_>, at: &SolidPlace, size: Triple) -> Vec<Mark> {
    let camera = &subject.camera;
    let (middle, columns) = (solid_centre(subject, at), transpose(&solid_axes(subject, at)));
    let mut list = Vec::new();
    for axis in 0..3 {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [-0.5, 0.5] {
            if side * dot(columns[axis], camera.towards) <= 1e-6 {
                continue;
            }
            let face = add_scaled_vector(middle, side * size[axis], columns[axis]);
            let corner = |(y, z): (f64, f64)| {
                camera.project_point(add_scaled_vector(
                    add_scaled_vector(face, y * size[j], columns[j]),
                    z * size[k],
                    columns[k],
                ))
            };
            let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(corner);
            list.push(Mark::solid(MarkRole::Body, Path::polygon(&corners)));
        }
    }
    list
}

/// Zigzag path of a coil spring from `a` to `b` on the sheet.
fn spring_outline(a: DrawingPoint, b: DrawingPoint) -> Path {
    let way = [b[0] - a[0], b[1] - a[1]];
    let across = super::drawing_elements::drawing_unit_vector([-way[1], way[0]]);
    let at = |t: f64, side: f64| [0, 1].map(|i| a[i] + t * way[i] + side * SPRING.1 * across[i]);
    let (from, to) = (0.14, 0.86);
    let mut spots = vec![a, at(from, 0.0)];
    let count = 2.0 * ((to - from) * way[0].hypot(way[1]) / SPRING.0).round().clamp(4.0, 40.0);
    let (mut turn, mut side) = (0.5, 1.0);
    while turn < count {
        spots.push(at(from + turn / count * (to - from), side));
        (turn, side) = (turn + 1.0, -side);
    }
    spots.extend([at(to, 0.0), b]);
    Path::line(&spots)
}

/// Marks of a ground plane: a line with hatching if the plane is seen edge-on, otherwise a rectangle under
/// the solids. `None` if no solid touches the plane, or if the plane is seen from directly above.
fn ground_outline(subject: &SketchSubject<'_>, at: &SolidPlace) -> Option<Vec<Mark>> {
    let camera = &subject.camera;
    let is_touched = subject.view.is_stated || subject.view.solids.iter().any(|solid| solid.touches.is_some());
    if !is_touched {
        return None;
    }
    let columns = transpose(&solid_axes(subject, at));
    let (place, normal) = (solid_centre(subject, at), columns[2]);
    // The extent of the solids over the plane, along its first two axes.
    let seen = subject.view.solids.iter().filter(|solid| !matches!(solid.form, SolidForm::Ground { .. }));
    let over = seen.flat_map(|solid| {
        let reach = solid.form.reach();
        solid.form.points().into_iter().flat_map(move |point| [-reach, reach].map(|r| (point, r)))
    });
    let along = |axis: usize| {
        let of = |(point, r): (usize, f64)| dot(columns[axis], subtract_vectors(subject.pose.points[point], place)) + r;
        let all = over.clone().map(of).chain([dot(columns[axis], subtract_vectors(subject.pose.points[0], place))]);
        let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
        (low - camera.metres(MARGIN), high + camera.metres(MARGIN))
    };
    let (x, y) = (along(0), along(1));
    let at = |a: f64, b: f64| add_scaled_vector(add_scaled_vector(place, a, columns[0]), b, columns[1]);
    let facing = dot(normal, camera.towards);
    if facing.abs() > 0.995 {
        return None;
    }
    if facing.abs() < 0.05 {
        let ends = [at(x.0, y.0), at(x.1, y.1)].map(|end| camera.project_point(end));
        let below = camera.project_direction(normal).map(|c| -c);
        return Some(super::supports::wall_marks(ends, below));
    }
    let corners = [at(x.0, y.0), at(x.1, y.0), at(x.1, y.1), at(x.0, y.1)].map(|corner| camera.project_point(corner));
    Some(vec![Mark::solid(MarkRole::Ground, Path::polygon(&corners))])
}

/// Extent of the solids and points on the sheet at the camera's scale: the least and the greatest corner.
pub fn bodies_extent(subject: &SketchSubject<'_>) -> (DrawingPoint, DrawingPoint) {
    let camera = &subject.camera;
    let mut all: Vec<(DrawingPoint, f64)> = Vec::new();
    for solid in &subject.view.solids {
        match &solid.form {
            SolidForm::Ground { .. } => {}
            SolidForm::Sphere { at, .. } | SolidForm::Cylinder { at, .. } | SolidForm::Box { at, .. } => {
                all.push((
                    camera.project_point(solid_centre(subject, at)),
                    if solid.is_pin() { 0.0 } else { solid.form.reach() },
                ));
            }
            SolidForm::Rod { ends, .. } | SolidForm::Spring { ends } => {
                all.extend(ends.map(|point| (subject.spot(point), 0.0)));
            }
        }
    }
    // Coordinates are measured from the origin, so the points close to it must be visible.
    let is_told = |point: &Triple| length(*point) < 6.0 * subject.view.size;
    all.extend(
        subject.pose.points.iter().filter(|point| is_told(point)).map(|point| (camera.project_point(*point), 0.0)),
    );
    all.iter().fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), (spot, reach)| {
        ([0, 1].map(|i| low[i].min(spot[i] - reach)), [0, 1].map(|i| high[i].max(spot[i] + reach)))
    })
}

/// Vectors along rods and springs in the inertial frame, m. A good direction of view shows them as long as
/// possible.
pub fn vectors_along_rods(subject: &SketchSubject<'_>) -> Vec<Triple> {
    let ends = subject.view.solids.iter().filter_map(|solid| match solid.form {
        SolidForm::Rod { ends, .. } | SolidForm::Spring { ends } => Some(ends),
        _ => None,
    });
    ends.map(|[a, b]| subtract_vectors(subject.pose.points[b], subject.pose.points[a])).collect()
}
